use oaktwin_image::{Image, ZDepth};

use crate::reason::ReasonCodes;

/// The requested outputs besides the distance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// `DepthSensorPointCloudPosition`; requires positions.
    pub positions: bool,
    /// `DepthSensorPointCloudColor`; requires a colour image.
    pub colors: bool,
    /// `DepthSensorImager`; requires a colour image.
    pub imager: bool,
    /// The visualization of the parameters' [`OutputMode`](super::OutputMode); mode 0 requires a colour image.
    pub view: bool,
    /// Why pixels have no value.
    pub reasons: bool,
    /// The confidence; requires a colour image.
    pub confidence: bool,
}

/// The outputs of the sensor; all images have the shot's size.
#[derive(Clone, Debug, PartialEq)]
pub struct SingleViewOutput {
    /// `DepthSensorDistance`: metres, 0 where nothing was measured.
    pub distance: ZDepth,
    /// `DepthSensorPointCloudPosition`: the point of the sample that moved to the pixel; [`Invalid`](super::Invalid)
    /// determines its value where nothing was measured, by default 0.
    pub positions: Option<Image<[f32; 4]>>,
    /// `DepthSensorPointCloudColor`: the colour of the sample that moved to the pixel; invalid as in `positions`.
    pub colors: Option<Image<[u8; 4]>>,
    /// `DepthSensorImager`: the luma of the colour image, 0 to 1; its pixels do not move.
    pub imager: Option<Image<f32>>,
    /// The visualization of the parameters' [`OutputMode`](super::OutputMode), sRGB.
    pub view: Option<Image<[u8; 4]>>,
    /// Why pixels have no value.
    pub reasons: Option<ReasonCodes>,
    /// The confidence of the sample in each pixel, 0 to 255; 0 without a sample.
    pub confidence: Option<Image<u16>>,
}

impl SingleViewOutput {
    /// Returns the distance that `showDistance` shows, at the middle pixel in metres, 0 if nothing was measured;
    /// `None` for an image without pixels.
    #[must_use]
    pub fn center_m(&self) -> Option<f32> {
        let image = &self.distance.0;
        image.get(image.width() / 2, image.height() / 2).copied()
    }
}
