use oaktwin_camera::{ApertureOffsets, ImageSize, Usd, UsdOptics};
use oaktwin_catalog::{LegacyDistortion, Origin, Twin, TwinCamera};

use super::{AssetError, AssetOptions, AssetTarget, IsaacVersion, describe, float, lens, pose};
use crate::nvidia::SENSOR_SCHEMA;
use crate::text::{PrimSpec, SpecValue};

/// Attributes of a camera prim other than optics and pose.
pub(super) struct CameraTraits<'a> {
    pub(super) name: &'a str,
    pub(super) focus_distance: f64,
    pub(super) clipping_range_m: (f64, f64),
    pub(super) stereo_role: &'a str,
}

/// Creates the prim of one of the device's cameras.
pub(super) fn prim(twin: &Twin, camera: &TwinCamera, options: &AssetOptions) -> Result<PrimSpec, AssetError> {
    let spec = &camera.spec;
    let traits = CameraTraits {
        name: &spec.prim,
        focus_distance: spec.focus_distance,
        clipping_range_m: spec.clipping_range_m,
        stereo_role: &spec.stereo_role,
    };
    let mut prim = base(twin, camera, &traits, options);
    prim.documentation = Some(describe::camera(twin, camera, options));
    let lens = lens::of_camera(twin, camera, options);
    if let Some(lens) = &lens {
        lens.author(&mut prim, &twin.device.name)?;
    }
    // The legacy attributes describe a pinhole, which would contradict a lens schema.
    let by_default =
        options.isaac == IsaacVersion::V5_1 && options.target == AssetTarget::Isaac && lens.is_none();
    if by_default || options.legacy_distortion {
        add_legacy_distortion(&mut prim, camera);
    }
    Ok(prim)
}

/// Creates a camera prim with optics and pose, without lens schemas.
pub(super) fn base(
    twin: &Twin,
    camera: &TwinCamera,
    traits: &CameraTraits<'_>,
    options: &AssetOptions,
) -> PrimSpec {
    let optics = optics(twin, camera, options);
    let mut prim = PrimSpec::def("Camera", traits.name);
    if options.isaac == IsaacVersion::V6 && options.target == AssetTarget::Isaac {
        prim.api_schemas.push(SENSOR_SCHEMA.into());
    }
    prim.set(
        "clippingRange",
        SpecValue::Float2([
            super::f32_of(traits.clipping_range_m.0),
            super::f32_of(traits.clipping_range_m.1),
        ]),
    );
    prim.set("focalLength", float(optics.focal_length_mm));
    prim.set("focusDistance", float(traits.focus_distance));
    prim.set("fStop", float(camera.spec.f_stop));
    prim.set("horizontalAperture", float(optics.horizontal_aperture_mm));
    prim.set("verticalAperture", float(optics.vertical_aperture_mm));
    add_offsets(&mut prim, &optics);
    prim.set("projection", SpecValue::token(&camera.spec.projection));
    prim.set_uniform("stereoRole", SpecValue::token(traits.stereo_role));
    pose::set(&mut prim, &pose::of_camera_prim(&camera.body_from_camera));
    prim
}

/// Returns the optical attributes of a twin's camera, in millimetres.
pub(super) fn optics(twin: &Twin, camera: &TwinCamera, options: &AssetOptions) -> UsdOptics {
    let offsets = match twin.origin {
        // Nominal cameras are centred; the sheet's formula applies to the numbers of a calibration file only.
        Origin::Nominal => ApertureOffsets::Zero,
        Origin::Calibration { .. } => options.aperture_offsets,
    };
    UsdOptics::from_intrinsics(&camera.intrinsics, camera.pixel_size_um, offsets)
}

/// Adds `horizontalApertureOffset` and `verticalApertureOffset`.
pub(super) fn add_offsets(prim: &mut PrimSpec, optics: &UsdOptics) {
    prim.set(
        "horizontalApertureOffset",
        float(optics.horizontal_aperture_offset_mm),
    );
    prim.set(
        "verticalApertureOffset",
        float(optics.vertical_aperture_offset_mm),
    );
}

/// Adds the sheet's distortion rows under the names that Isaac Sim read before 5.0, if the catalog has them. "Not Applicable"
/// rows are omitted.
fn add_legacy_distortion(prim: &mut PrimSpec, camera: &TwinCamera) {
    let ImageSize { width, height } = camera.intrinsics.size;
    let centre = camera.intrinsics.principal_point::<Usd>();
    let Some(LegacyDistortion { poly_k, p, s, .. }) = &camera.spec.legacy_distortion else {
        return;
    };
    prim.set(
        "cameraProjectionType",
        SpecValue::token(&camera.spec.projection_type),
    );
    prim.set("fthetaWidth", float(f64::from(width)));
    prim.set("fthetaHeight", float(f64::from(height)));
    prim.set("fthetaCx", float(centre.x));
    prim.set("fthetaCy", float(centre.y));
    if let Some(max_fov_deg) = camera.spec.max_fov_deg {
        prim.set("fthetaMaxFov", float(max_fov_deg));
    }
    for (letter, k) in ('A'..='F').zip(poly_k) {
        prim.set(format!("fthetaPoly{letter}"), float(*k));
    }
    for (i, p) in p.iter().enumerate() {
        prim.set(format!("p{i}"), float(*p));
    }
    for (i, s) in s.iter().enumerate() {
        prim.set(format!("s{i}"), float(*s));
    }
}
