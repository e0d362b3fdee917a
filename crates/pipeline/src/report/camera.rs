use serde::Serialize;

use oaktwin_camera::{ApertureOffsets, ImageSize, OpenCv, PixelConvention, PixelPoint, Usd, UsdOptics};
use oaktwin_catalog::{LegacyDistortion, LensChoice, Origin, Role, Source, Sources, Twin, TwinCamera};

/// One camera: intrinsics, their calculation, USD attributes and the check of the field of view.
#[derive(Clone, Debug, Serialize)]
pub struct CameraReport {
    /// The role.
    pub role: Role,
    /// The name of the prim.
    pub prim: String,
    /// The image sensor.
    pub sensor: String,
    /// The image size of the intrinsics.
    pub size: ImageSize,
    /// Pixel pitch, µm.
    pub pixel_size_um: f64,
    /// The catalog's horizontal field of view, degrees.
    pub nominal_hfov_deg: f64,
    /// The horizontal focal length, px.
    pub fx: f64,
    /// The vertical focal length, px.
    pub fy: f64,
    /// The principal point where the first pixel's centre is at 0.5 (OpenUSD; centred is W/2).
    pub principal_point_usd: PixelReport,
    /// The principal point where the first pixel's centre is at 0 (OpenCV, DepthAI, ROS).
    pub principal_point_opencv: PixelReport,
    /// The field of view of the ideal pinhole in degrees: horizontal, vertical, diagonal.
    pub fov_deg: [f64; 3],
    /// The attributes of the USD camera.
    pub usd: UsdReport,
    /// The field of view of the USD attributes in degrees, `2 atan(horizontalAperture / (2 focalLength))`.
    pub hfov_check_deg: f64,
    /// The calculation, line by line.
    pub calculation: Vec<String>,
    /// `pinhole`, `opencv-pinhole`, `opencv-fisheye` or `f-theta`.
    pub lens: &'static str,
    /// The fx, fy, cx, cy of the lens, px (the first pixel's centre at 0); they differ from those above for a nominal fisheye.
    pub lens_intrinsics: [f64; 4],
    /// The distortion coefficients in the order of the lens's library.
    pub distortion: Vec<f64>,
    /// The optical centre in the body frame (x forward, y left, z up), mm.
    pub position_mm: [f64; 3],
    /// The direction of the optical axis in degrees: yaw to the left, pitch up.
    pub yaw_pitch_deg: [f64; 2],
    /// The parameter sheet's column of distortion values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub legacy_distortion: Option<LegacyDistortion>,
    /// The source of the catalog's values.
    pub source: Source,
    /// The keys with another source.
    pub sources: Sources,
}

/// A pixel position, px.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PixelReport {
    /// The column, to the right.
    pub x: f64,
    /// The row, downwards.
    pub y: f64,
}

/// The attributes of a USD camera prim, with lengths in millimetres.
#[derive(Clone, Debug, Serialize)]
pub struct UsdReport {
    /// `focalLength`.
    pub focal_length: f64,
    /// `horizontalAperture`.
    pub horizontal_aperture: f64,
    /// `verticalAperture`.
    pub vertical_aperture: f64,
    /// The offsets that move OpenUSD's window to the principal point; the default of assets.
    pub aperture_offsets_openusd: OffsetsReport,
    /// The offsets by the parameter sheet's formula.
    pub aperture_offsets_document: OffsetsReport,
    /// `focusDistance`.
    pub focus_distance: f64,
    /// `fStop`.
    pub f_stop: f64,
    /// `projection`.
    pub projection: String,
    /// `stereoRole`.
    pub stereo_role: String,
    /// `clippingRange`, m.
    pub clipping_range: (f64, f64),
    /// `cameraProjectionType`.
    pub camera_projection_type: String,
    /// `maxFOV` of the parameter sheet, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_fov_deg: Option<f64>,
}

/// `horizontalApertureOffset` and `verticalApertureOffset`.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OffsetsReport {
    /// `horizontalApertureOffset`.
    pub horizontal: f64,
    /// `verticalApertureOffset`.
    pub vertical: f64,
}

impl CameraReport {
    pub(super) fn new(twin: &Twin, camera: &TwinCamera, lens: LensChoice) -> Self {
        let nominal = twin.origin == Origin::Nominal;
        let (spec, intrinsics) = (&camera.spec, &camera.intrinsics);
        let usd_with = |offsets| UsdOptics::from_intrinsics(intrinsics, camera.pixel_size_um, offsets);
        let usd = usd_with(ApertureOffsets::OpenUsd);
        // The sheet's formula applies to calibrations; centred cameras have no offsets by it.
        let document = usd_with(if nominal {
            ApertureOffsets::Zero
        } else {
            ApertureOffsets::Document
        });
        let optics = twin.optics(camera, lens);
        let forward = camera.body_from_camera.rotation.z_axis;
        Self {
            role: spec.role,
            prim: spec.prim.clone(),
            sensor: spec.sensor.clone(),
            size: intrinsics.size,
            pixel_size_um: camera.pixel_size_um,
            nominal_hfov_deg: spec.hfov_deg,
            fx: intrinsics.fx,
            fy: intrinsics.fy,
            principal_point_usd: intrinsics.principal_point::<Usd>().into(),
            principal_point_opencv: intrinsics.principal_point::<OpenCv>().into(),
            fov_deg: [intrinsics.hfov(), intrinsics.vfov(), intrinsics.dfov()].map(f64::to_degrees),
            hfov_check_deg: usd.hfov().to_degrees(),
            calculation: calculation(nominal, camera, &usd),
            usd: UsdReport {
                focal_length: usd.focal_length_mm,
                horizontal_aperture: usd.horizontal_aperture_mm,
                vertical_aperture: usd.vertical_aperture_mm,
                aperture_offsets_openusd: usd.into(),
                aperture_offsets_document: document.into(),
                focus_distance: spec.focus_distance,
                f_stop: spec.f_stop,
                projection: spec.projection.clone(),
                stereo_role: spec.stereo_role.clone(),
                clipping_range: spec.clipping_range_m,
                camera_projection_type: spec.projection_type.clone(),
                max_fov_deg: spec.max_fov_deg,
            },
            lens: optics.lens.names().report,
            lens_intrinsics: {
                let (k, c) = (optics.intrinsics, optics.intrinsics.principal_point::<OpenCv>());
                [k.fx, k.fy, c.x, c.y]
            },
            distortion: optics.lens.coefficients().to_vec(),
            position_mm: (camera.body_from_camera.translation * 1e3).to_array(),
            yaw_pitch_deg: [
                forward.y.atan2(forward.x),
                forward.z.atan2(forward.x.hypot(forward.y)),
            ]
            .map(f64::to_degrees),
            legacy_distortion: spec.legacy_distortion.clone(),
            source: spec.source,
            sources: spec.sources.clone(),
        }
    }
}

/// The calculation of the parameter sheet with this camera's numbers, in its precision.
fn calculation(nominal: bool, camera: &TwinCamera, usd: &UsdOptics) -> Vec<String> {
    let (k, p) = (&camera.intrinsics, camera.pixel_size_um);
    let ImageSize { width, height } = k.size;
    let fx = if nominal {
        let hfov = camera.spec.hfov_deg;
        format!("fx = fy = {width} / (2 tan({hfov}° / 2)) = {:.2} px", k.fx)
    } else {
        format!("fx = {:.2} px, fy = {:.2} px (calibration)", k.fx, k.fy)
    };
    let f = usd.focal_length_mm;
    let half = usd.horizontal_aperture_mm / (2.0 * f);
    vec![
        fx,
        format!(
            "focalLength = {p} µm × {:.2} px = {f:.4} mm",
            k.mean_focal_length()
        ),
        format!(
            "horizontalAperture = {p} µm × {width} px = {:.3} mm",
            usd.horizontal_aperture_mm
        ),
        format!(
            "verticalAperture = {p} µm × {height} px = {:.3} mm",
            usd.vertical_aperture_mm
        ),
        format!(
            "HFOV = 2 atan({:.3} / (2 × {f:.4})) = 2 atan({half:.4}) = {:.2}°",
            usd.horizontal_aperture_mm,
            usd.hfov().to_degrees()
        ),
    ]
}

impl<C: PixelConvention> From<PixelPoint<C>> for PixelReport {
    fn from(p: PixelPoint<C>) -> Self {
        Self { x: p.x, y: p.y }
    }
}

impl From<UsdOptics> for OffsetsReport {
    fn from(optics: UsdOptics) -> Self {
        // Avoids −0.
        Self {
            horizontal: optics.horizontal_aperture_offset_mm + 0.0,
            vertical: optics.vertical_aperture_offset_mm + 0.0,
        }
    }
}
