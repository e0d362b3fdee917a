use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{Camera, Intrinsics, LensModel, OpenCv, OpenCvLens};
use oaktwin_catalog::{LensChoice, Origin, Twin, TwinCamera};

use super::{AssetError, AssetOptions, ROOT, float};
use crate::text::{PrimSpec, SpecValue};

/// The lens-distortion schema of a camera prim.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LensSchema {
    intrinsics: Intrinsics,
    kind: LensKind,
}

#[derive(Clone, Debug, PartialEq)]
enum LensKind {
    /// The coefficients k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4.
    Pinhole([f64; 12]),
    /// The coefficients k1 k2 k3 k4.
    Fisheye([f64; 4]),
}

/// OpenCV's order, also used by Isaac Sim's `set_opencv_pinhole_properties`.
const PINHOLE_NAMES: [&str; 12] = [
    "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4",
];
const FISHEYE_NAMES: [&str; 4] = ["k1", "k2", "k3", "k4"];

/// Returns the lens schema of a camera, if it has one. A calibrated camera always has one, since Isaac Sim's renderer
/// takes the principal point from the schema only.
pub(super) fn of_camera(twin: &Twin, camera: &TwinCamera, options: &AssetOptions) -> Option<LensSchema> {
    let optics = twin.optics(camera, options.lens);
    if optics.lens == LensModel::Pinhole && matches!(twin.origin, Origin::Nominal) {
        return None;
    }
    // All lenses of calibrations and the catalog are among OpenCV's.
    let kind = match optics.lens.as_opencv()? {
        OpenCvLens::Pinhole(all) => {
            let mut coefficients = [0.0; 12];
            coefficients.copy_from_slice(&all[..12]);
            LensKind::Pinhole(coefficients)
        }
        // All coefficients are written, because the schema's fallback value of k1 is not 0.
        OpenCvLens::Fisheye(k) => LensKind::Fisheye(k),
    };
    Some(LensSchema {
        intrinsics: optics.intrinsics,
        kind,
    })
}

/// Returns the lens schema of a depth sensor's virtual camera. An OAK's depth image is rectified, so the schema has no
/// distortion; it carries the calibrated principal point.
pub(super) fn of_depth_camera(twin: &Twin, camera: &TwinCamera) -> Option<LensSchema> {
    matches!(twin.origin, Origin::Calibration { .. }).then_some(LensSchema {
        intrinsics: camera.intrinsics,
        kind: LensKind::Pinhole([0.0; 12]),
    })
}

impl LensSchema {
    /// Applies the schema and writes all of its attributes.
    pub(super) fn author(&self, prim: &mut PrimSpec, model: &str) -> Result<(), AssetError> {
        let (schema, token, names, coefficients): (_, _, &[&str], &[f64]) = match &self.kind {
            LensKind::Pinhole(k) => (
                "OmniLensDistortionOpenCvPinholeAPI",
                "opencvPinhole",
                &PINHOLE_NAMES,
                k,
            ),
            LensKind::Fisheye(k) => (
                "OmniLensDistortionOpenCvFisheyeAPI",
                "opencvFisheye",
                &FISHEYE_NAMES,
                k,
            ),
        };
        prim.api_schemas.push(schema.into());
        prim.set("omni:lensdistortion:model", SpecValue::token(token));
        let name = |attribute: &str| format!("omni:lensdistortion:{token}:{attribute}");
        let c = self.intrinsics.principal_point::<OpenCv>();
        for (attribute, value) in [
            ("fx", self.intrinsics.fx),
            ("fy", self.intrinsics.fy),
            ("cx", c.x),
            ("cy", c.y),
        ] {
            prim.set(name(attribute), float(value));
        }
        prim.set(name("imageSize"), int2(&self.intrinsics, model)?);
        for (attribute, k) in names.iter().zip(coefficients) {
            prim.set(name(attribute), float(*k));
        }
        Ok(())
    }

    /// Returns the lens model's name for the prim's documentation.
    pub(super) fn description(&self) -> &'static str {
        match &self.kind {
            LensKind::Pinhole(_) => "OpenCV's rational and thin-prism model",
            LensKind::Fisheye(_) => "OpenCV's fisheye model",
        }
    }
}

/// Returns the image size as `int2`.
pub(super) fn int2(intrinsics: &Intrinsics, model: &str) -> Result<SpecValue, AssetError> {
    let int = |value: u32| {
        i32::try_from(value).map_err(|_| AssetError::TooLarge {
            model: model.into(),
            place: "resolution".into(),
            value,
        })
    };
    Ok(SpecValue::Int2([
        int(intrinsics.size.width)?,
        int(intrinsics.size.height)?,
    ]))
}

/// Reports tilted sensors, which the schemas cannot express, and lens options that a calibration overrides.
pub(super) fn findings(twin: &Twin, options: &AssetOptions) -> Vec<Finding> {
    let mut findings = Vec::new();
    for camera in &twin.cameras {
        let path = format!("/{ROOT}/{}/{}", twin.device.prim, camera.spec.prim);
        if let LensModel::OpenCvPinhole(lens) = &camera.lens {
            let [.., tau_x, tau_y] = *lens.coefficients();
            let tilt = [tau_x, tau_y];
            if tilt != [0.0, 0.0] {
                let error_px = Camera::new(camera.intrinsics, camera.lens).largest_tilt_error_px();
                findings.push(Finding::new(
                    "lens-tilt-lost",
                    Level::Warning,
                    &path,
                    format!(
                        "the lens schema cannot express sensor tilt (τx {}, τy {} rad): the image is off by up to \
                         {error_px:.3} px",
                        tilt[0], tilt[1]
                    ),
                    "undistort with the calibration itself if that matters",
                ));
            }
        }
    }
    let calibrated = matches!(twin.origin, Origin::Calibration { .. });
    if calibrated && options.lens == LensChoice::Fisheye {
        findings.push(Finding::new(
            "lens-from-calibration",
            Level::Note,
            format!("/{ROOT}/{}", twin.device.prim),
            "the calibration's lens models are used instead of the nominal fisheye",
            "",
        ));
    }
    findings
}
