use oaktwin_base::parameter::{ParameterError, parameters};
use oaktwin_image::Image;

use super::Pixel;

parameters! {
    /// `ThresholdFilter`: drops depths outside a range.
    pub struct Threshold("threshold filter", platform) {
        /// The minimum depth.
        min_range: u16 = 0 => ("min".alias("minRange").unit("mm").range(0.0..=65535.0)),
        /// The maximum depth.
        max_range: u16 = u16::MAX => ("max".alias("maxRange").unit("mm").range(0.0..=65535.0)),
    }
    check ordered
}

impl Threshold {
    fn ordered(&self) -> Result<(), ParameterError> {
        if self.min_range <= self.max_range {
            return Ok(());
        }
        let what = format!("{} is above max", self.min_range);
        Err(ParameterError::new(
            "min",
            what,
            format!("expected up to {}", self.max_range),
        ))
    }

    pub(super) fn run<P: Pixel>(&self, image: &mut Image<P>) {
        for pixel in image.pixels_mut() {
            if !(self.min_range..=self.max_range).contains(&(*pixel).into()) {
                *pixel = P::default();
            }
        }
    }
}
