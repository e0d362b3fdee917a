use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint,
    RectifiedIntrinsics, RigidTransform,
};
use oaktwin_depth::rectify::{EdgeFill, Grey, Method, Rectify, RectifyOptions, StereoRectify};
use oaktwin_image::{Image, npy};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::files;

/// A camera with OpenCV's parameters.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraJson {
    matrix: [[f64; 3]; 3],
    coefficients: Vec<f64>,
    #[serde(default)]
    fisheye: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    /// The left and the right image, rows × columns of `uint8` or `uint16`, followed by the output files.
    images: [PathBuf; 2],
    rectified: [PathBuf; 2],
    cameras: [CameraJson; 2],
    /// 4×4, translation in metres.
    right_from_left: [[f64; 4]; 4],
    method: String,
    target: String,
    /// −1 repeats the border.
    edge_fill: i32,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let [left, right] = [grey(&self.images[0])?, grey(&self.images[1])?];
        let (width, height) = left.size();
        let size = ImageSize::new(width, height);
        let [a, b] = [self.cameras[0].camera(size)?, self.cameras[1].camera(size)?];
        let named = |name: &str| Method::ALL.iter().copied().find(|method| method.name() == name);
        let target = format!("{}-camera", self.target);
        let target = RectifiedIntrinsics::ALL
            .iter()
            .find(|known| known.name() == target);
        let options = RectifyOptions {
            method: named(&self.method).ok_or("unknown method")?,
            target: *target.ok_or("unknown target")?,
            edge_fill: u8::try_from(self.edge_fill).map_or(EdgeFill::Replicate, EdgeFill::Value),
        };
        let pair = StereoRectify::new(&a, &b, &RigidTransform::from_rows(self.right_from_left), &options)?;
        left.rectify(pair.left(), &self.rectified[0])?;
        right.rectify(pair.right(), &self.rectified[1])?;
        Ok(json!({ "method": pair.method().name() }))
    }
}

impl CameraJson {
    fn camera(&self, size: ImageSize) -> Result<Camera, Box<dyn Error>> {
        let [[fx, _, cx], [_, fy, cy], _] = self.matrix;
        let lens = if self.fisheye {
            let k = <[f64; 4]>::try_from(self.coefficients.as_slice())?;
            LensModel::OpenCvFisheye(OpenCvFisheye { k })
        } else {
            LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&self.coefficients)?)
        };
        Ok(Camera::new(
            Intrinsics::new(size, fx, fy, PixelPoint::<OpenCv>::new(cx, cy)),
            lens,
        ))
    }
}

/// A grey image.
enum AnyGrey {
    Eight(Image<u8>),
    Sixteen(Image<u16>),
}

impl AnyGrey {
    fn size(&self) -> (u32, u32) {
        match self {
            Self::Eight(image) => (image.width(), image.height()),
            Self::Sixteen(image) => (image.width(), image.height()),
        }
    }

    fn rectify(&self, rectify: &Rectify, path: &Path) -> Result<(), Box<dyn Error>> {
        match self {
            Self::Eight(image) => write(rectify, image, path),
            Self::Sixteen(image) => write(rectify, image, path),
        }
    }
}

fn write<P: Grey + npy::NpyElement>(
    rectify: &Rectify,
    image: &Image<P>,
    path: &Path,
) -> Result<(), Box<dyn Error>> {
    let found = rectify
        .rectify(image.into())
        .ok_or("the images have different sizes")?;
    files::write(path, &found)
}

fn grey(path: &Path) -> Result<AnyGrey, Box<dyn Error>> {
    let array = npy::decode(&fs::read(path)?)?;
    let &[height, width] = array.shape.as_slice() else {
        return Err("invalid shape: rows × columns required".into());
    };
    let (width, height) = (u32::try_from(width)?, u32::try_from(height)?);
    let image = match array.values {
        npy::Values::U8(values) => Image::new(width, height, values).map(AnyGrey::Eight),
        npy::Values::U16(values) => Image::new(width, height, values).map(AnyGrey::Sixteen),
        _ => return Err("images must be uint8 or uint16".into()),
    };
    image.ok_or_else(|| "too large".into())
}
