//! Camera mathematics over a pipe, for oracles in other languages: one JSON request per line on standard input, one JSON
//! answer per line on standard output, `{"error": …}` if the request failed. Pixels are in OpenCV's convention.

use std::io::{self, BufRead, Write};

use oaktwin_camera::math::{DMat3, DVec2, DVec3};
use oaktwin_camera::{
    ApertureOffsets, Camera, FTheta, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole,
    PixelPoint, RectifiedIntrinsics, RigidTransform, UsdOptics, stereo_rectify_to, undistort_rectify_map,
};
use serde::Deserialize;
use serde_json::{Value, json};

type Matrix = [[f64; 3]; 3];

#[derive(Deserialize)]
#[serde(tag = "op", rename_all = "snake_case", deny_unknown_fields)]
enum Request {
    /// Project points in the camera's frame to pixels.
    Project {
        camera: CameraJson,
        points: Vec<[f64; 3]>,
    },
    /// Unproject pixels to unit rays.
    Unproject {
        camera: CameraJson,
        pixels: Vec<[f64; 2]>,
    },
    /// Undistort pixels to the plane z = 1.
    Undistort {
        camera: CameraJson,
        pixels: Vec<[f64; 2]>,
    },
    /// The maximum effect of τx and τy.
    TiltError { camera: CameraJson },
    /// Stereo rectification.
    Rectify {
        left: CameraJson,
        right: CameraJson,
        right_from_left: [[f64; 4]; 4],
        intrinsics: Option<Rectified>,
    },
    /// The rectification lookup table.
    Map {
        camera: CameraJson,
        rectified_from_camera: Matrix,
        rectified: IntrinsicsJson,
    },
    /// Intrinsics at another size.
    Resize {
        intrinsics: IntrinsicsJson,
        size: [u32; 2],
        keep_aspect_ratio: bool,
        top_left: Option<[f64; 2]>,
    },
    /// The fields of view.
    Fov { intrinsics: IntrinsicsJson },
    /// The ideal camera with this horizontal field of view.
    FromHfov { size: [u32; 2], hfov: f64 },
    /// USD camera attributes, and the intrinsics that OpenUSD and Isaac Sim derive from them.
    UsdOptics {
        intrinsics: IntrinsicsJson,
        pixel_size_um: f64,
        offsets: Offsets,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct IntrinsicsJson {
    size: [u32; 2],
    k: Matrix,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraJson {
    intrinsics: IntrinsicsJson,
    lens: LensJson,
}

#[derive(Deserialize)]
#[serde(tag = "model", rename_all = "snake_case", deny_unknown_fields)]
enum LensJson {
    Pinhole,
    OpencvPinhole {
        coefficients: Vec<f64>,
    },
    OpencvFisheye {
        coefficients: Vec<f64>,
    },
    /// The centre is in the USD convention; the camera's intrinsics are replaced by the lens's own.
    Ftheta {
        coefficients: Vec<f64>,
        nominal_size: [u32; 2],
        optical_centre: [f64; 2],
        max_fov: f64,
    },
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Rectified {
    ZeroDisparity,
    FreeDisparity,
    LeftCamera,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Offsets {
    Openusd,
    Document,
    Zero,
}

type Answer = Result<Value, Box<dyn std::error::Error>>;

fn main() -> io::Result<()> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    for line in io::stdin().lock().lines() {
        let answer = answer(&line?).unwrap_or_else(|error| json!({ "error": error.to_string() }));
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}

fn answer(line: &str) -> Answer {
    Ok(match serde_json::from_str(line)? {
        Request::Project { camera, points } => {
            let camera = camera.parse()?;
            let pixel = |&p: &[f64; 3]| camera.project(DVec3::from(p)).map(|p| [p.x, p.y]);
            json!(points.iter().map(pixel).collect::<Vec<_>>())
        }
        Request::Unproject { camera, pixels } => {
            let camera = camera.parse()?;
            let ray = |&p: &[f64; 2]| camera.unproject(opencv(p)).map(|ray| ray.to_array());
            json!(pixels.iter().map(ray).collect::<Vec<_>>())
        }
        Request::Undistort { camera, pixels } => {
            let camera = camera.parse()?;
            let undistort = |&p: &[f64; 2]| {
                let distorted = camera.intrinsics.normalized_from_pixel(opencv(p));
                camera.lens.undistort(distorted).map(|p| p.to_array())
            };
            json!(pixels.iter().map(undistort).collect::<Vec<_>>())
        }
        Request::TiltError { camera } => json!(camera.parse()?.largest_tilt_error_px()),
        Request::Rectify {
            left,
            right,
            right_from_left,
            intrinsics,
        } => rectify([&left, &right], right_from_left, intrinsics.as_ref())?,
        Request::Map {
            camera,
            rectified_from_camera,
            rectified,
        } => {
            let rotation = DMat3::from_cols_array_2d(&rectified_from_camera).transpose();
            json!(undistort_rectify_map(&camera.parse()?, rotation, &rectified.parse()).collect::<Vec<_>>())
        }
        Request::Resize {
            intrinsics,
            size,
            keep_aspect_ratio,
            top_left,
        } => {
            let size = ImageSize::new(size[0], size[1]);
            let resized = intrinsics.parse().resized(size, keep_aspect_ratio);
            let top_left = opencv(top_left.unwrap_or_default());
            json!(resized.cropped(top_left, size).opencv_matrix())
        }
        Request::Fov { intrinsics } => {
            let intrinsics = intrinsics.parse();
            json!({ "hfov": intrinsics.hfov(), "vfov": intrinsics.vfov(), "dfov": intrinsics.dfov() })
        }
        Request::FromHfov { size, hfov } => {
            json!(Intrinsics::from_hfov(ImageSize::new(size[0], size[1]), hfov).opencv_matrix())
        }
        Request::UsdOptics {
            intrinsics,
            pixel_size_um,
            offsets,
        } => usd_optics(&intrinsics.parse(), pixel_size_um, &offsets),
    })
}

fn rectify(
    [left, right]: [&CameraJson; 2],
    right_from_left: [[f64; 4]; 4],
    intrinsics: Option<&Rectified>,
) -> Answer {
    let intrinsics = match intrinsics {
        None | Some(Rectified::ZeroDisparity) => RectifiedIntrinsics::ZeroDisparity,
        Some(Rectified::FreeDisparity) => RectifiedIntrinsics::FreeDisparity,
        Some(Rectified::LeftCamera) => RectifiedIntrinsics::LeftCamera,
    };
    let transform = RigidTransform::from_rows(right_from_left);
    let pair = stereo_rectify_to(&left.parse()?, &right.parse()?, &transform, intrinsics)?;
    Ok(json!({
        "r1": rows(pair.rectified_from_left),
        "r2": rows(pair.rectified_from_right),
        "p1": pair.projection_left(),
        "p2": pair.projection_right(),
        "q": pair.disparity_to_depth().transpose().to_cols_array_2d(),
        "baseline": pair.baseline,
    }))
}

fn usd_optics(intrinsics: &Intrinsics, pixel_size_um: f64, offsets: &Offsets) -> Value {
    let offsets = match offsets {
        Offsets::Openusd => ApertureOffsets::OpenUsd,
        Offsets::Document => ApertureOffsets::Document,
        Offsets::Zero => ApertureOffsets::Zero,
    };
    let optics = UsdOptics::from_intrinsics(intrinsics, pixel_size_um, offsets);
    json!({
        "focal_length": optics.focal_length_mm,
        "horizontal_aperture": optics.horizontal_aperture_mm,
        "vertical_aperture": optics.vertical_aperture_mm,
        "horizontal_aperture_offset": optics.horizontal_aperture_offset_mm,
        "vertical_aperture_offset": optics.vertical_aperture_offset_mm,
        "hfov": optics.hfov(),
        "openusd": optics.openusd_intrinsics(intrinsics.size).opencv_matrix(),
        "isaac": optics.isaac_intrinsics(intrinsics.size).opencv_matrix(),
    })
}

impl IntrinsicsJson {
    fn parse(&self) -> Intrinsics {
        Intrinsics::from_opencv_matrix(ImageSize::new(self.size[0], self.size[1]), self.k)
    }
}

impl CameraJson {
    fn parse(&self) -> Result<Camera, oaktwin_camera::LensError> {
        let intrinsics = self.intrinsics.parse();
        let lens = match &self.lens {
            LensJson::Pinhole => LensModel::Pinhole,
            LensJson::OpencvPinhole { coefficients } => {
                LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(coefficients)?)
            }
            LensJson::OpencvFisheye { coefficients } => {
                LensModel::OpenCvFisheye(OpenCvFisheye::from_slice(coefficients)?)
            }
            LensJson::Ftheta {
                coefficients,
                nominal_size,
                optical_centre,
                max_fov,
            } => {
                let nominal = ImageSize::new(nominal_size[0], nominal_size[1]);
                let centre = PixelPoint::from(DVec2::from(*optical_centre));
                let lens = FTheta::new(coefficients, nominal, centre, *max_fov)?;
                return Ok(Camera::from_ftheta(lens, intrinsics.size));
            }
        };
        Ok(Camera::new(intrinsics, lens))
    }
}

fn opencv(p: [f64; 2]) -> PixelPoint<OpenCv> {
    PixelPoint::from(DVec2::from(p))
}

fn rows(m: DMat3) -> [[f64; 3]; 3] {
    m.transpose().to_cols_array_2d()
}
