use oaktwin::dataset::recording::{DepthView, points, rays};
use oaktwin::depth::OutputCamera;
use oaktwin::image::Image;

use crate::message::{Header, PointCloud2, PointField};

/// `sensor_msgs/PointField.FLOAT32`.
const FLOAT32: u8 = 7;

/// The rays of a camera, from which point clouds are made.
#[derive(Clone, Debug)]
pub struct Points {
    rays: Image<[f32; 2]>,
    /// The x coordinate of the camera in the frame of the points, metres.
    x_m: f32,
}

impl Points {
    /// Creates the rays of the camera of a sensor's outputs; points are in the optical frame of its input.
    #[must_use]
    pub fn new(camera: &OutputCamera) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "points are in single precision")]
        let x_m = -camera.shift_m as f32;
        Self {
            rays: rays(&camera.camera),
            x_m,
        }
    }

    /// Returns one point per pixel, row by row, NaN where nothing was measured; colours are packed into a number, like PCL's.
    /// The images belong to the camera.
    #[must_use]
    pub fn message(
        &self,
        header: Header,
        metres: &Image<f32>,
        colors: Option<&Image<[u8; 4]>>,
    ) -> PointCloud2 {
        let (width, height) = (self.rays.width(), self.rays.height());
        let names = ["x", "y", "z", "rgb"];
        let names = &names[..if colors.is_some() { 4 } else { 3 }];
        let step = if colors.is_some() { 16 } else { 12 };
        let mut data = Vec::with_capacity(step as usize * self.rays.pixels().len());
        let mut is_dense = true;
        let mut colors = colors.map(|image| image.pixels().iter());
        for [x, y, z] in points(&self.rays, DepthView::Metres(metres.into())) {
            is_dense &= !z.is_nan();
            for number in [x + self.x_m, y, z] {
                data.extend_from_slice(&number.to_le_bytes());
            }
            if let Some(colors) = &mut colors {
                let [r, g, b, _] = colors.next().copied().unwrap_or_default();
                data.extend_from_slice(&[b, g, r, 0]);
            }
        }
        let fields = (0..).step_by(4).zip(names).map(|(offset, name)| PointField {
            name: (*name).to_owned(),
            offset,
            datatype: FLOAT32,
            count: 1,
        });
        PointCloud2 {
            header,
            height,
            width,
            fields: fields.collect(),
            is_bigendian: false,
            point_step: step,
            row_step: step.saturating_mul(width),
            data,
            is_dense,
        }
    }
}
