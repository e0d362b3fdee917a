use oaktwin_base::parameter::{Platform, parameters};
use oaktwin_camera::StereoGeometry;

use crate::disparity::{DepthRounding, Fixed, FractionalBits, Subpixel, SubpixelSwitch};
use crate::random::{NoiseStage, Stream, standard_normal};

parameters! {
    /// The geometry and the errors of a stereo camera. Lengths in pixels are in matcher pixels, pixels of an image
    /// [`width_px`](Self::width_px) wide, whatever the width of the input images.
    pub struct Parameters("stereo-noise", platform) {
        /// The geometry of the rectified pair.
        stereo: StereoGeometry = StereoGeometry { focal_length_px: 800.0, baseline_m: 0.075 } => {
            /// The focal length of the rectified images, in matcher pixels.
            .focal_length_px: f64 => ("focalLength".unit("px").range(1.0..=1e5).typical(200.0..=2000.0).from_camera()),
            /// The distance between the optical centres.
            .baseline_m: f64 => ("baseline".unit("m").range(1e-4..=2.0).typical(0.02..=0.3).from_camera()),
        },
        /// The width of the images that the matcher works on, which is the device's mode: 1280 at 800P, 640 at 480P and 400P. Focal length
        /// and pixel locking follow it unless they are given.
        width_px: u32 = 1280 => ("width".unit("px").range(1.0..=16384.0).typical(320.0..=1920.0).from_camera()),
        /// The step of disparity.
        subpixel: Subpixel = Subpixel::default() => {
            /// Whether disparity has fractional bits.
            : Subpixel => ("subpixel" as SubpixelSwitch.common(2)),
            /// The fractional bits of disparity: 3, 4 or 5, or 0 for whole pixels.
            : Subpixel => ("subpixelFractionalBits" as FractionalBits),
        },
        /// Whether the disparity range is doubled, for near surfaces.
        extended_disparity: bool = false => ("extendedDisparity"),
        /// The first disparity of the search range.
        disparity_shift_px: u32 = 0 => ("disparityShift".unit("px").range(0.0..=1024.0).typical(0.0..=128.0)),
        /// Whether pixels that the right camera cannot see are lost: shadows to the left of near surfaces, and a band at
        /// the left border.
        occlusion: bool = true => ("occlusion".chosen("the geometry of a stereo pair")),
        /// Whether the left-right check is enabled. It rejects a band beside the shadow of near surfaces that the matching
        /// window widens (`edgeDilation`).
        left_right_check: bool = true => ("leftRightCheck"),
        /// The largest difference between both directions of matching that the left-right check accepts.
        left_right_check_threshold_px: u32 = 10 => ("leftRightCheckThreshold".common(3).unit("px").range(0.0..=128.0).typical(0.0..=20.0)),
        /// The minimum confidence; pixels with less texture are lost. Needs a colour image; 0 keeps all.
        confidence_threshold: u8 = 55 => ("confidenceThreshold".common(1).range(0.0..=255.0)),
        /// The light at the centre of a projected dot on a surface 1 m away, relative to the light of a bright room there: about 3
        /// for a Pro model with its projector at full power. Adds to the texture of a colour image.
        dot_contrast: f64 = 0.0 => ("dotContrast".range(0.0..=1e6).typical(0.0..=30.0).estimate()),
        /// The light of the scene relative to a bright room: 0.1 in the evening, 0.001 in a dark room, 0 at night. Below 0.5, noise hides
        /// texture, and dots have more contrast.
        ambient: f64 = 1.0 => ("ambient".range(0.0..=1e6).typical(0.0..=2.0).estimate()),
        /// The number of columns at the left border that are lost.
        invalid_edge_px: u32 = 0 => ("numInvalidateEdgePixels".unit("px").range(0.0..=16384.0).typical(0.0..=64.0)),
        /// The width that the matching window adds to near surfaces on every side.
        edge_dilation_px: f64 = 0.0 => ("edgeDilation".unit("px").range(0.0..=32.0).typical(0.0..=8.0).estimate()),
        /// The fraction of pixels that are lost at random.
        dropout: f64 = 0.0 => ("dropout".range(0.0..=1.0).typical(0.0..=0.2).estimate()),
        /// The disparity error of the unit's calibration (β). A negative bias makes depth too large.
        bias_px: f64 = 0.0 => ("bias".common(5).unit("px").range(-10.0..=10.0).typical(-1.0..=1.0).estimate()),
        /// The amplitude of the error that repeats with every pixel of disparity (a); 0.2 px by default for widths of up
        /// to 640 px.
        pixel_locking_px: f64 = 0.13
            => ("pixelLocking".unit("px").range(0.0..=1.0).typical(0.0..=0.5).chosen("fit to the vendor's error curves")),
        /// The standard deviation of a pixel's disparity over time (σ).
        jitter_px: f64 = 0.05 => ("jitter".common(4).unit("px").range(0.0..=10.0).typical(0.0..=0.5).estimate()),
        /// The factor of bias, pixel locking and jitter of surfaces nearer than 6 m; it grows to 1 at 7 m. On RVC4 it is 0.75: the
        /// parameter sheet states errors below 1.5 % instead of 2 % to 3.5 m, 3 % instead of 4 % to 6.5 m, and equal ones beyond. By default
        /// 1 if one of the three errors is given, which then holds at every distance.
        close_range_factor: f64 = if platform == Platform::Rvc4 { 0.75 } else { 1.0 }
            => ("closeRangeFactor".range(0.0..=10.0).typical(0.0..=2.0).estimate()),
        /// The side of the matching window, over which jitter is correlated and texture is measured.
        window_px: u32 = 7 => ("window".unit("px").range(1.0..=63.0).typical(1.0..=15.0).step(2.0).estimate()),
        /// The rounding of depth to whole millimetres.
        depth_rounding: DepthRounding = DepthRounding::default() => ("depthRounding".estimate()),
    }
}

/// The distances at which [`Parameters::close_range_factor`] begins to change and is 1, m: around the end of the sheet's second range.
pub(super) const CLOSE_RANGE_M: [f64; 2] = [6.0, 7.0];

/// The standard deviation of the calibration bias over units, px: an estimate, with which the median of 200 units stays
/// within the vendor's published accuracy.
pub const DEVICE_BIAS_SIGMA_PX: f64 = 0.15;

impl Parameters {
    /// Returns the defaults of a platform for a stereo pair: `DepthAI`'s where it has the parameter, pixel locking as fitted to the
    /// vendor's measured curves (0.13 px at a width of 1280 px, 0.2 px at 640 px), and estimates otherwise.
    #[must_use]
    pub fn new(platform: Platform, stereo: StereoGeometry, width_px: u32) -> Self {
        let defaults = Self::defaults(platform);
        Self {
            stereo,
            width_px,
            pixel_locking_px: if width_px > 640 {
                defaults.pixel_locking_px
            } else {
                0.2
            },
            ..defaults
        }
    }

    /// Returns the same parameters with the random bias of one unit.
    #[must_use]
    pub fn of_device(mut self, device_seed: u64) -> Self {
        let plane = Stream::new(device_seed, "").plane(NoiseStage::DeviceBias, 0, 0);
        let [a, b, ..] = plane.words(0, 0);
        self.bias_px = DEVICE_BIAS_SIGMA_PX * standard_normal(a, b)[0];
        self
    }

    /// The largest disparity in the search range, px: 95 plus the shift, or twice that in extended mode.
    #[must_use]
    pub fn max_disparity_px(&self) -> u32 {
        let standard = 95 + self.disparity_shift_px;
        if self.extended_disparity {
            2 * standard
        } else {
            standard
        }
    }

    /// The largest value of [`StereoNoise::disparity`](super::StereoNoise::disparity): the search range in steps.
    #[must_use]
    pub fn max_fixed_disparity(&self) -> u32 {
        (self.max_disparity_px() - self.disparity_shift_px) << self.subpixel.bits()
    }

    pub(crate) fn fixed(&self) -> Fixed {
        Fixed {
            stereo: self.stereo,
            subpixel: self.subpixel,
            shift_px: self.disparity_shift_px,
            rounding: self.depth_rounding,
        }
    }
}
