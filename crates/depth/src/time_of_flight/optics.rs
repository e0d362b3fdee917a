//! The rays of pixels.

use super::parameters::Parameters;

/// A pinhole camera in the pixels of one image: the ray of a pixel is (u, v, 1).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Optics {
    /// The focal length, image px.
    pub(super) focal_length_px: f32,
    /// The u of each column.
    pub(super) columns: Vec<f32>,
    middle_y_px: f64,
    per_px: f64,
}

impl Optics {
    #[expect(clippy::cast_possible_truncation, reason = "rows are single precision")]
    pub(super) fn new(p: &Parameters, width: u32, height: u32) -> Self {
        let scale = f64::from(width) / f64::from(p.width_px);
        let middle = [f64::from(width) / 2.0, f64::from(height) / 2.0];
        let [cx, cy] = p
            .principal_point_px
            .map_or(middle, |point| point.map(|c| c * scale));
        let focal_length_px = p.focal_length_px * scale;
        let per_px = 1.0 / focal_length_px;
        Self {
            focal_length_px: focal_length_px as f32,
            columns: (0..width)
                .map(|x| ((f64::from(x) + 0.5 - cx) * per_px) as f32)
                .collect(),
            middle_y_px: cy,
            per_px,
        }
    }

    /// Returns the v of a row.
    #[expect(clippy::cast_possible_truncation, reason = "rows are single precision")]
    pub(super) fn row(&self, y: isize) -> f32 {
        ((y as f64 + 0.5 - self.middle_y_px) * self.per_px) as f32
    }
}
