use oaktwin_camera::{Camera, LensModel, OpenCv, OpenCvLens, RigidTransform, UsdOptics};
use serde::Serialize;

use crate::matrices::{projection, view_transform};

/// The camera of a rendered frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameCamera {
    /// The attributes of the camera prim.
    pub optics: UsdOptics,
    /// The rendering camera: resolution, lens and, for a pinhole, focal lengths and principal point.
    pub camera: Camera,
    /// The camera pose in metres; the camera has OpenCV's axes.
    pub world_from_camera: RigidTransform,
    /// The clipping range, scene units.
    pub clipping_range: [f64; 2],
    /// The metres per scene unit.
    pub meters_per_unit: f64,
    /// The focus distance, scene units.
    pub focus_distance: f64,
    /// The f-number; 0 disables depth of field.
    pub f_stop: f64,
}

/// The output of Replicator's `camera_params` annotator, with its fields and JSON keys in its order.
///
/// Numbers that Replicator stores as `float32` are rounded to it. An infinite clipping distance, which JSON does not support,
/// becomes the maximum of `float32`.
///
/// # Usage
/// With points as rows, `point_in_clip = point_in_world · camera_view_transform · camera_projection`, in scene units;
/// the camera faces −z with y up, and depth is reversed (1 near, 0 far).
/// `u = (x/w + 1)/2 · width`, `v = (1 − y/w)/2 · height`.
///
/// # Lenses
/// The projection of a pinhole matches the rendered image, including offsets. For other lenses, as in Isaac Sim, it depends
/// only on the focal length and the horizontal aperture, and other fields describe the lens:
///
/// | model | `opencv_fx`, `fy`, `optical_centre` | `polynomial` | `lens_p`, `lens_s` |
/// |---|---|---|---|
/// | `pinholeOpenCV` | OpenCV's, px | k1 to k6 | p1 p2, s1 to s4 |
/// | `fisheyeOpenCV` | OpenCV's, px | k1 to k4, 0 | |
/// | `fisheyePolynomial` | centre in px of the nominal image | θ(r) in ascending powers, rad | |
///
/// Replicator's documentation does not define the fields of OpenCV's pinhole coefficients. Its nodes describe `lens_p` as
/// tangential and `lens_s` as thin prism, so the radial ones must be in `polynomial`. The sensor's tilt is not represented.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraParams {
    /// The horizontal and vertical aperture of the prim.
    #[serde(rename = "cameraAperture")]
    pub aperture: [f64; 2],
    /// The horizontal and vertical aperture offset of the prim.
    #[serde(rename = "cameraApertureOffset")]
    pub aperture_offset: [f64; 2],
    /// Tangential distortion.
    #[serde(rename = "cameraFisheyeLensP")]
    pub lens_p: Vec<f64>,
    /// Thin-prism distortion.
    #[serde(rename = "cameraFisheyeLensS")]
    pub lens_s: Vec<f64>,
    /// The full field of view, degrees; 0 for no limit.
    #[serde(rename = "cameraFisheyeMaxFOV")]
    pub max_fov_deg: f64,
    /// The height of the image that the lens parameters refer to, px.
    #[serde(rename = "cameraFisheyeNominalHeight")]
    pub nominal_height: u32,
    /// The width of the image that the lens parameters refer to, px.
    #[serde(rename = "cameraFisheyeNominalWidth")]
    pub nominal_width: u32,
    /// The optical centre, px; 0 for an ideal pinhole.
    #[serde(rename = "cameraFisheyeOpticalCentre")]
    pub optical_centre: [f64; 2],
    /// The lens's polynomial.
    #[serde(rename = "cameraFisheyePolynomial")]
    pub polynomial: Vec<f64>,
    /// The focal length of the prim.
    #[serde(rename = "cameraFocalLength")]
    pub focal_length: f64,
    /// The focus distance, scene units.
    #[serde(rename = "cameraFocusDistance")]
    pub focus_distance: f64,
    /// The f-number; 0 disables depth of field.
    #[serde(rename = "cameraFStop")]
    pub f_stop: f64,
    /// The name of the lens model.
    #[serde(rename = "cameraModel")]
    pub model: &'static str,
    /// The clipping range, scene units.
    #[serde(rename = "cameraNearFar")]
    pub near_far: [f64; 2],
    /// OpenCV's horizontal focal length, px; 0 for other lenses.
    #[serde(rename = "cameraOpenCVFx")]
    pub opencv_fx: f64,
    /// OpenCV's vertical focal length, px; 0 for other lenses.
    #[serde(rename = "cameraOpenCVFy")]
    pub opencv_fy: f64,
    /// The four rows of the matrix from camera to clip space, for points as rows.
    #[serde(rename = "cameraProjection")]
    pub projection: [f64; 16],
    /// The four rows of the matrix from world to camera, for points as rows, in scene units.
    #[serde(rename = "cameraViewTransform")]
    pub view_transform: [f64; 16],
    /// The metres per scene unit.
    #[serde(rename = "metersPerSceneUnit")]
    pub meters_per_scene_unit: f64,
    /// The width and height, px.
    #[serde(rename = "renderProductResolution")]
    pub resolution: [u32; 2],
    /// What the ground truth of transparent surfaces is: `surface` or `through`. Replicator has no such field.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transparent: Option<&'static str>,
}

impl CameraParams {
    /// Creates the parameters of a view.
    #[must_use]
    pub fn new(view: &FrameCamera) -> Self {
        let optics = &view.optics;
        let size = view.camera.intrinsics.size;
        let mut params = Self {
            aperture: [optics.horizontal_aperture_mm, optics.vertical_aperture_mm].map(single),
            aperture_offset: [
                optics.horizontal_aperture_offset_mm,
                optics.vertical_aperture_offset_mm,
            ]
            .map(single),
            lens_p: Vec::new(),
            lens_s: Vec::new(),
            max_fov_deg: 0.0,
            nominal_height: 0,
            nominal_width: 0,
            optical_centre: [0.0; 2],
            polynomial: vec![0.0; 5],
            focal_length: single(optics.focal_length_mm),
            focus_distance: single(view.focus_distance),
            f_stop: single(view.f_stop),
            model: "pinhole",
            near_far: view.clipping_range.map(single),
            opencv_fx: 0.0,
            opencv_fy: 0.0,
            projection: projection(view),
            view_transform: view_transform(view),
            meters_per_scene_unit: single(view.meters_per_unit),
            resolution: [size.width, size.height],
            transparent: None,
        };
        params.describe_lens(&view.camera);
        params
    }

    fn describe_lens(&mut self, camera: &Camera) {
        let intrinsics = &camera.intrinsics;
        self.model = camera.lens.names().replicator;
        if camera.lens == LensModel::Pinhole {
            return;
        }
        if let LensModel::FTheta(lens) = camera.lens {
            self.polynomial = lens.coefficients().map(single).to_vec();
            self.optical_centre = [lens.optical_centre.x, lens.optical_centre.y].map(single);
            self.max_fov_deg = single(lens.max_fov.to_degrees());
            self.nominal_width = lens.nominal_size.width;
            self.nominal_height = lens.nominal_size.height;
            return;
        }
        match camera.lens.as_opencv() {
            Some(OpenCvLens::Pinhole(coefficients)) => {
                let [k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, _, _] = coefficients.map(single);
                self.polynomial = vec![k1, k2, k3, k4, k5, k6];
                self.lens_p = vec![p1, p2];
                self.lens_s = vec![s1, s2, s3, s4];
            }
            Some(OpenCvLens::Fisheye(k)) => {
                let [k1, k2, k3, k4] = k.map(single);
                self.polynomial = vec![k1, k2, k3, k4, 0.0];
            }
            None => self.polynomial = camera.lens.coefficients().iter().copied().map(single).collect(),
        }
        let centre = intrinsics.principal_point::<OpenCv>();
        self.optical_centre = [centre.x, centre.y].map(single);
        self.opencv_fx = single(intrinsics.fx);
        self.opencv_fy = single(intrinsics.fy);
        self.nominal_width = intrinsics.size.width;
        self.nominal_height = intrinsics.size.height;
    }
}

/// Rounds to `float32`.
fn single(value: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "rounded, as documented")]
    let single = value as f32;
    f64::from(single.clamp(f32::MIN, f32::MAX))
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::matrices::tests::view;
    use oaktwin_camera::math::DVec3;
    use oaktwin_camera::{FTheta, ImageSize, Intrinsics, OpenCvFisheye, OpenCvPinhole, PixelPoint, Usd};
    use serde_json::Value;

    fn near(a: &[f64], b: &[f64]) -> bool {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-5)
    }

    #[test]
    #[ignore = "needs OAKTWIN_TEST_DATA"]
    fn agrees_with_isaac_sim() {
        let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
        let folder = PathBuf::from(data).join("conformance/isaac-camera-params");
        let diagonal = DVec3::new(1.0, -1.0, 0.0).normalize();
        let forward = DVec3::new(1.0, 1.0, -2.0).normalize();
        let poses = [
            // Straight down, and from a corner; both face the origin.
            ("rp1", DVec3::new(0.0, 0.0, 10.0), DVec3::Y, DVec3::NEG_X),
            (
                "rp2",
                DVec3::new(-4.0, -4.0, 8.0),
                diagonal,
                diagonal.cross(forward),
            ),
        ];
        for (name, eye, right, up) in poses {
            for (model, clipping_range) in [("pinhole", [1.0, 1e6]), ("pinholeOpenCV", [0.1, 100.0])] {
                let mut view = view(eye, right, up, clipping_range);
                if model == "pinholeOpenCV" {
                    let lens = OpenCvPinhole::from_slice(&[0.1, 0.02]).unwrap();
                    let intrinsics = Intrinsics::new(
                        ImageSize::new(512, 512),
                        700.0,
                        710.0,
                        PixelPoint::<OpenCv>::new(200.0, 300.0),
                    );
                    view.camera = Camera::new(intrinsics, LensModel::OpenCvPinhole(lens));
                }
                let ours = CameraParams::new(&view);
                assert_eq!(ours.model, model);
                let path = folder.join(format!("{model}_{name}.json"));
                let golden: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
                let golden = &golden["camera_data"];
                let numbers = |key: &str| -> Vec<f64> {
                    let flat = |v: &Value| v.as_array().cloned().unwrap_or_else(|| vec![v.clone()]);
                    let rows = golden[key].as_array().unwrap().iter().flat_map(flat);
                    rows.map(|number| number.as_f64().unwrap()).collect()
                };
                assert!(
                    near(&ours.view_transform, &numbers("camera_view_matrix")),
                    "{model} {name}"
                );
                assert!(
                    near(&ours.projection, &numbers("camera_projection_matrix")),
                    "{model} {name}"
                );
                assert_eq!(ours.aperture, *numbers("aperture"));
                assert_eq!(ours.resolution.map(f64::from), *numbers("resolution"));
            }
        }
    }

    #[test]
    fn agrees_with_manual_calculation() {
        // 3 m up, facing +y, in a stage in centimetres whose z is up.
        let mut view = view(DVec3::new(1.0, 2.0, 3.0), DVec3::X, DVec3::Z, [1.0, 3.0]);
        view.meters_per_unit = 0.01;
        view.optics.horizontal_aperture_mm = 24.0;
        view.camera.intrinsics = view.optics.isaac_intrinsics(ImageSize::new(1000, 500));
        let text = String::from_utf8(crate::json::encode(&CameraParams::new(&view))).unwrap();
        let expected = concat!(
            r#"{"cameraAperture": [24.0, 15.290800094604492], "cameraApertureOffset": [0.0, 0.0], "#,
            r#""cameraFisheyeLensP": [], "cameraFisheyeLensS": [], "cameraFisheyeMaxFOV": 0.0, "#,
            r#""cameraFisheyeNominalHeight": 0, "cameraFisheyeNominalWidth": 0, "#,
            r#""cameraFisheyeOpticalCentre": [0.0, 0.0], "#,
            r#""cameraFisheyePolynomial": [0.0, 0.0, 0.0, 0.0, 0.0], "cameraFocalLength": 24.0, "#,
            r#""cameraFocusDistance": 400.0, "cameraFStop": 0.0, "cameraModel": "pinhole", "#,
            r#""cameraNearFar": [1.0, 3.0], "cameraOpenCVFx": 0.0, "cameraOpenCVFy": 0.0, "#,
            r#""cameraProjection": [2.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, "#,
            r#"0.0, 0.0, 0.5, -1.0, 0.0, 0.0, 1.5, 0.0], "#,
            r#""cameraViewTransform": [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, "#,
            r#"0.0, 1.0, 0.0, 0.0, -100.0, -300.0, 200.0, 1.0], "#,
            r#""metersPerSceneUnit": 0.009999999776482582, "renderProductResolution": [1000, 500]}"#,
        );
        assert_eq!(text, expected);
    }

    #[test]
    fn describes_lenses() {
        let mut view = view(DVec3::ZERO, DVec3::X, DVec3::Y, [0.5, f64::INFINITY]);
        let size = ImageSize::new(1280, 800);
        let intrinsics = Intrinsics::new(size, 800.0, 801.0, PixelPoint::<OpenCv>::new(640.5, 400.25));
        let coefficients: Vec<f64> = (1u8..=14).map(f64::from).collect();
        let pinhole = OpenCvPinhole::from_slice(&coefficients).unwrap();
        view.camera = Camera::new(intrinsics, LensModel::OpenCvPinhole(pinhole));
        let params = CameraParams::new(&view);
        assert_eq!(params.model, "pinholeOpenCV");
        assert_eq!(params.polynomial, [1.0, 2.0, 5.0, 6.0, 7.0, 8.0]);
        assert_eq!(
            (params.lens_p, params.lens_s),
            (vec![3.0, 4.0], vec![9.0, 10.0, 11.0, 12.0])
        );
        assert_eq!(params.optical_centre, [640.5, 400.25]);
        assert_eq!((params.opencv_fx, params.opencv_fy), (800.0, 801.0));
        assert_eq!((params.nominal_width, params.nominal_height), (1280, 800));
        assert_eq!(params.near_far, [0.5, f64::from(f32::MAX)]);
        assert_eq!([params.projection[10], params.projection[14]], [0.0, 0.5]);

        view.camera.lens = LensModel::OpenCvFisheye(OpenCvFisheye {
            k: [1.0, 2.0, 3.0, 4.0],
        });
        let params = CameraParams::new(&view);
        assert_eq!(params.model, "fisheyeOpenCV");
        assert_eq!(params.polynomial, [1.0, 2.0, 3.0, 4.0, 0.0]);

        let nominal = ImageSize::new(1936, 1216);
        let centre = PixelPoint::<Usd>::new(970.5, 600.5);
        let ftheta = FTheta::new(&[0.0, 0.25], nominal, centre, std::f64::consts::PI).unwrap();
        view.camera = Camera::from_ftheta(ftheta, size);
        let params = CameraParams::new(&view);
        assert_eq!(params.model, "fisheyePolynomial");
        assert_eq!(params.polynomial, [0.0, 0.25, 0.0, 0.0, 0.0]);
        assert_eq!(
            (params.optical_centre, params.max_fov_deg),
            ([970.5, 600.5], 180.0)
        );
        assert_eq!((params.nominal_width, params.opencv_fx), (1936, 0.0));
    }
}
