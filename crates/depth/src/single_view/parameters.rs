use crate::ParameterError;

/// The attributes of `OmniSensorDepthSensorSingleViewAPI` that shape the result, in their units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// `baselineMM`: between the imagers, mm. Its sign is the side.
    pub baseline_mm: f64,
    /// `confidenceThreshold`, 0 to 1: lower drops more of what has no texture. Without a picture nothing is dropped.
    pub confidence_threshold: f64,
    /// `focalLengthPixel`: px of a sensor that is `sensor_size_px` wide.
    pub focal_length_px: f64,
    /// `maxDisparityPixel`: farther shifts are dropped, px of the rendered image.
    pub max_disparity_px: f64,
    /// `minDistance`, m.
    pub min_distance_m: f64,
    /// `maxDistance`, m.
    pub max_distance_m: f64,
    /// `noiseMean`: the step to which disparity is quantized, px of the rendered image. 0 switches the step and the
    /// jitter off.
    pub noise_mean_px: f64,
    /// `noiseSigma`: the jitter of disparity, px of the rendered image.
    pub noise_sigma_px: f64,
    /// `noiseDownscaleFactorPixel`: the side of a patch that shares its jitter, px.
    pub noise_downscale_factor_px: f64,
    /// `outlierRemovalEnabled`: how far a lone pixel looks for others, px; 0 switches the removal off. The switch of
    /// Isaac Sim 6 is 1.
    pub outlier_removal_range_px: u32,
    /// `rgbDepthOutputMode`.
    pub rgb_depth_output_mode: OutputMode,
    /// `sensorSizePixel`: the width of the sensor that `focal_length_px` belongs to, px.
    pub sensor_size_px: f64,
}

/// `rgbDepthOutputMode`: the picture that takes the colour image's place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum OutputMode {
    /// 0: the colour image.
    #[default]
    Color,
}

impl Parameters {
    /// The schema's defaults in Isaac Sim 5.0 and 5.1.
    pub const ISAAC_5_1: Self = Self {
        baseline_mm: 55.0,
        confidence_threshold: 0.95,
        focal_length_px: 897.0,
        max_disparity_px: 110.0,
        min_distance_m: 0.5,
        max_distance_m: 1e7,
        noise_mean_px: 0.25,
        noise_sigma_px: 0.25,
        noise_downscale_factor_px: 1.0,
        outlier_removal_range_px: 3,
        rgb_depth_output_mode: OutputMode::Color,
        sensor_size_px: 1280.0,
    };

    /// The schema's defaults in Isaac Sim 6.
    pub const ISAAC_6: Self = Self {
        confidence_threshold: 0.70,
        outlier_removal_range_px: 1,
        ..Self::ISAAC_5_1
    };

    /// Disparity times depth in an image `width` pixels wide, px·m.
    #[must_use]
    pub fn disparity_times_depth(&self, width: u32) -> f64 {
        self.baseline_mm / 1000.0 * self.focal_length_px * f64::from(width) / self.sensor_size_px
    }

    pub(super) fn check(&self) -> Result<(), ParameterError> {
        let positive = [
            ("focalLengthPixel", self.focal_length_px),
            ("sensorSizePixel", self.sensor_size_px),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return Err(ParameterError::new(
                    name,
                    format!("{value} is not above 0"),
                    "give a positive number of pixels",
                ));
            }
        }
        Ok(())
    }
}
