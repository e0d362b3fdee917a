use oaktwin_camera::ImageSize;
use oaktwin_depth::imager::Parameters;
use oaktwin_depth::rectify::RectifyOptions;
use oaktwin_usd::asset::LensChoice;

/// How a pair is recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairOptions {
    /// The image sensors, their blur in px of the cameras' own resolution. Both are exposed alike.
    pub imager: Parameters,
    /// How the pair is rectified; by default as the device's processor does it.
    pub rectify: Option<RectifyOptions>,
    /// The power of the dot projector, 0 to 1: `DepthAI`'s `setIrLaserDotProjectorIntensity`. 0, off, is the device's
    /// default.
    pub projector: f64,
    /// The factor of the scene's own light. 1 by default: the cameras of Pro models let visible light through beside the
    /// projector's 940 nm. 0 is a dark room, or a filter that blocks all else.
    pub ambient: f64,
    /// The lens of the wide models' nominal cameras. A calibration's own lens wins.
    pub lens: LensChoice,
    /// The size of the raw and rectified images, by `DepthAI`'s rule; by default the sensor's own.
    pub size: Option<ImageSize>,
    /// By how much the device's calibration makes disparities too large, px of the cameras' own resolution: what the right
    /// camera sees lies so much farther left than its calibration says.
    pub bias_px: f64,
    /// Of the noise.
    pub seed: u64,
}

impl Default for PairOptions {
    fn default() -> Self {
        Self {
            imager: Parameters::default(),
            rectify: None,
            projector: 0.0,
            ambient: 1.0,
            lens: LensChoice::default(),
            size: None,
            bias_px: 0.0,
            seed: 0,
        }
    }
}
