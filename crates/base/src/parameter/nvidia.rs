//! The attributes of NVIDIA's depth sensor schema, `OmniSensorDepthSensorSingleViewAPI`: one table for the catalog, the USD
//! writer and linter, reports and the sensor.

use std::ops::RangeInclusive;

use crate::parameter::{DefaultSource, FieldText, Kind, ParameterError, Platform, Value, choice, parameters};

// The ranges of numbers that are multiplied: wide, and such that every product is finite.
const BASELINE_MM: RangeInclusive<f64> = -1e6..=1e6;
const MIN_BASELINE_MM: f64 = 1e-6;
const LENGTH_PX: RangeInclusive<f64> = 1e-3..=1e6;
const NOISE_PX: RangeInclusive<f64> = 0.0..=1e6;

/// The largest range of outlier removal, px.
pub const MAX_OUTLIER_RANGE_PX: u32 = 63;

choice! {
    /// The image that replaces the colour image.
    ///
    /// Where the documentation gives a title and no formula, the image is this program's reading of the title. Grey over the
    /// range is 0 at `minDistance` and 255 at `maxDistance`; invalid pixels are black.
    OutputMode {
        /// 0: the unchanged colour image.
        Color = "color",
        /// 1: reported depth, grey, rising from 0 at every whole metre.
        Sawtooth = "sawtooth",
        /// 2: reported depth, grey over the range.
        Grayscale = "grayscale",
        /// 3: reported depth over the range, from red (near) over yellow, green and cyan to blue (far).
        Rainbow = "rainbow",
        /// 4: the input depth, grey over the range.
        InputDepth = "input-depth",
        /// 5: depth where it was moved to, without pixels of low confidence, before outlier removal; grey over the range.
        Reprojected = "reprojected",
        /// 6: of the moved samples, red is confidence, green disparity as in 7.
        Confidence = "confidence",
        /// 7: disparity of the moved samples, before any is dropped for confidence, grey from 0 to `maxDisparityPixel`.
        Disparity = "disparity",
    }
}

parameters! {
    /// The attributes of `OmniSensorDepthSensorSingleViewAPI`, in their units. The defaults match Isaac Sim 5.0 and
    /// 5.1.
    pub struct Attributes("single-view", platform) {
        /// The distance between the imagers; its sign is the side of the second one.
        baseline_mm: f64 = 55.0 => ("baselineMM".unit("mm").range(BASELINE_MM).typical(1.0..=300.0).source(DefaultSource::Nvidia)),
        /// The focal length. It is for a sensor that is `sensorSizePixel` wide.
        focal_length_px: f64 = 897.0 => ("focalLengthPixel".unit("px").range(LENGTH_PX).typical(200.0..=2000.0).source(DefaultSource::Nvidia)),
        /// The width of the sensor.
        sensor_size_px: f64 = 1280.0 => ("sensorSizePixel".unit("px").range(LENGTH_PX).typical(320.0..=3840.0).source(DefaultSource::Nvidia)),
        /// The largest disparity. It is in pixels of the rendered image.
        max_disparity_px: f64 = 110.0 => ("maxDisparityPixel".unit("px").range(LENGTH_PX).typical(1.0..=256.0).source(DefaultSource::Nvidia)),
        /// The minimum depth.
        min_distance_m: f64 = 0.5
            => ("minDistance".unit("m").range(0.0..=f64::MAX).typical(0.0..=5.0).source(DefaultSource::Nvidia)),
        /// The maximum depth.
        max_distance_m: f64 = 1e7 => ("maxDistance".unit("m").typical(1.0..=30.0).source(DefaultSource::Nvidia)),
        /// The quantization step of disparity. It is in pixels of the rendered image; 0 disables both the step and the jitter.
        noise_mean_px: f64 = 0.25
            => ("noiseMean".common(2).unit("px").range(NOISE_PX).typical(0.0..=2.0).source(DefaultSource::Nvidia)),
        /// The standard deviation of disparity. It is in pixels of the rendered image.
        noise_sigma_px: f64 = 0.25
            => ("noiseSigma".common(1).unit("px").range(NOISE_PX).typical(0.0..=2.0).source(DefaultSource::Nvidia)),
        /// The side of the squares of pixels that share their noise.
        noise_downscale_factor_px: f64 = 1.0
            => ("noiseDownscaleFactorPixel".unit("px").range(1.0..=1e6).typical(1.0..=16.0).source(DefaultSource::Nvidia)),
        /// The threshold of confidence: lower values drop more smooth surface, 1 keeps all. The default of Isaac Sim 6 is 0.7.
        confidence_threshold: f64 = 0.95
            => ("confidenceThreshold".common(3).range(0.0..=1.0).source(DefaultSource::Nvidia)),
        /// The range of outlier removal. 0 disables it, and the switch of Isaac Sim 6 is 1, its default.
        outlier_removal_range_px: u32 = 3
            => ("outlierRemovalEnabled" as OutlierRange.common(4).alias("outlierRemovalRange").unit("px").range(0.0..=63.0).source(DefaultSource::Nvidia)),
        /// Whether the stage enables the sensor. It has no effect here: the sensor runs when its output is requested.
        enabled: bool = false => ("enabled".source(DefaultSource::Nvidia)),
        /// The image that replaces the colour image.
        rgb_depth_output_mode: OutputMode = OutputMode::Color
            => ("rgbDepthOutputMode" as ModeNumber.source(DefaultSource::Nvidia)),
        /// Whether the distance at the centre pixel is reported.
        show_distance: bool = false => ("showDistance".source(DefaultSource::Nvidia)),
    }
    check relations
}

impl Attributes {
    /// Returns the schema's defaults in Isaac Sim 5.0 and 5.1.
    #[must_use]
    pub fn isaac_5_1() -> Self {
        Self::defaults(Platform::default())
    }

    /// Returns the schema's defaults in Isaac Sim 6.
    #[must_use]
    pub fn isaac_6() -> Self {
        Self {
            confidence_threshold: 0.70,
            outlier_removal_range_px: 1,
            ..Self::isaac_5_1()
        }
    }

    /// Disparity times depth in an image `width` pixels wide, px·m; negative with a negative baseline.
    #[must_use]
    pub fn disparity_times_depth(&self, width: u32) -> f64 {
        self.baseline_mm / 1000.0 * self.focal_length_px * f64::from(width) / self.sensor_size_px
    }

    fn relations(&self) -> Result<(), ParameterError> {
        if self.baseline_mm.abs() < MIN_BASELINE_MM {
            return Err(ParameterError::new(
                "baselineMM",
                format!("{} gives no disparity", self.baseline_mm),
                "set the distance between the imagers in mm, 75 for an OAK-D",
            ));
        }
        let (min, max) = (self.min_distance_m, self.max_distance_m);
        if max < min {
            let what = format!("{max} m is below the minDistance of {min} m");
            return Err(ParameterError::new(
                "maxDistance",
                what,
                "set a larger maxDistance",
            ));
        }
        Ok(())
    }
}

/// A range in pixels, or the switch of Isaac Sim 6.
struct OutlierRange;

impl FieldText<u32> for OutlierRange {
    const KIND: Kind = Kind::Integer;

    fn set(field: &mut u32, text: &str) -> Option<()> {
        *field = match text {
            "true" => 1,
            "false" => 0,
            range => range.parse().ok()?,
        };
        Some(())
    }

    fn get(field: &u32) -> String {
        field.text()
    }

    fn numbers(field: &u32) -> Vec<f64> {
        field.numbers()
    }
}

/// The number of a mode, or its name.
struct ModeNumber;

impl FieldText<OutputMode> for ModeNumber {
    const KIND: Kind = Kind::Choice(<OutputMode as super::Choice>::NAMES);

    fn set(field: &mut OutputMode, text: &str) -> Option<()> {
        <super::Numbered as FieldText<OutputMode>>::set(field, text)
    }

    fn get(field: &OutputMode) -> String {
        (*field as u8).to_string()
    }
}
