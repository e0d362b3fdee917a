use std::num::NonZeroU32;

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
    /// The distance of the pixels that become points, in both directions.
    step: u32,
}

impl Points {
    /// Creates the rays of the camera of a sensor's outputs; points are in the optical frame of its input. Every `step`th pixel of
    /// every `step`th row becomes a point.
    #[must_use]
    pub fn new(camera: &OutputCamera, step: NonZeroU32) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "points are in single precision")]
        let x_m = -camera.shift_m as f32;
        Self {
            rays: rays(&camera.camera),
            x_m,
            step: step.get(),
        }
    }

    /// Returns the points, row by row, NaN where nothing was measured; colours are packed into a number, like PCL's.
    /// The images belong to the camera.
    #[must_use]
    pub fn message(
        &self,
        header: Header,
        metres: &Image<f32>,
        colors: Option<&Image<[u8; 4]>>,
    ) -> PointCloud2 {
        let (width, height) = (
            self.rays.width().div_ceil(self.step),
            self.rays.height().div_ceil(self.step),
        );
        let names = ["x", "y", "z", "rgb"];
        let names = &names[..if colors.is_some() { 4 } else { 3 }];
        let step = if colors.is_some() { 16 } else { 12 };
        let mut data = Vec::with_capacity(step as usize * width as usize * height as usize);
        let mut is_dense = true;
        let row = self.rays.width() as usize;
        let is_wanted = |index: usize| {
            let every = self.step as usize;
            (index / row).is_multiple_of(every) && (index % row).is_multiple_of(every)
        };
        let all = points(&self.rays, DepthView::Metres(metres.into()));
        for (index, [x, y, z]) in all.enumerate() {
            if self.step > 1 && !is_wanted(index) {
                continue;
            }
            is_dense &= !z.is_nan();
            for number in [x + self.x_m, y, z] {
                data.extend_from_slice(&number.to_le_bytes());
            }
            if let Some(colors) = colors {
                let [r, g, b, _] = colors.pixels().get(index).copied().unwrap_or_default();
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
