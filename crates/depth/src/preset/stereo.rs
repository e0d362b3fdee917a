use oaktwin_base::parameter::Platform;

use super::{PresetError, TIME_OF_FLIGHT_PRESETS, is_named};
use crate::filter::{
    Brightness, Decimation, DecimationMode, Filter, Median, Spatial, Speckle, Temporal, Threshold,
};
use crate::stereo_matching::{self, AdaptiveMedian, ConfidenceMetrics, HoleFilling};
use crate::stereo_noise::{self, Subpixel};

/// `StereoDepth`'s `PresetMode`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    /// `DEFAULT`
    Default,
    /// `FACE`
    Face,
    /// `HIGH_DETAIL`
    HighDetail,
    /// `ROBOTICS`
    Robotics,
    /// `ACCURACY`
    Accuracy,
    /// `DENSITY`
    Density,
    /// `FAST_ACCURACY`
    FastAccuracy,
    /// `FAST_DENSITY`
    FastDensity,
    /// `HIGH_ACCURACY` of `DepthAI` 2, `FAST_ACCURACY` since.
    HighAccuracy,
    /// `HIGH_DENSITY` of `DepthAI` 2, `FAST_DENSITY` since.
    HighDensity,
}

impl Preset {
    /// All.
    pub const ALL: [Self; 10] = [
        Self::Default,
        Self::Face,
        Self::HighDetail,
        Self::Robotics,
        Self::Accuracy,
        Self::Density,
        Self::FastAccuracy,
        Self::FastDensity,
        Self::HighAccuracy,
        Self::HighDensity,
    ];

    /// `DepthAI`'s name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Default => "DEFAULT",
            Self::Face => "FACE",
            Self::HighDetail => "HIGH_DETAIL",
            Self::Robotics => "ROBOTICS",
            Self::Accuracy => "ACCURACY",
            Self::Density => "DENSITY",
            Self::FastAccuracy => "FAST_ACCURACY",
            Self::FastDensity => "FAST_DENSITY",
            Self::HighAccuracy => "HIGH_ACCURACY",
            Self::HighDensity => "HIGH_DENSITY",
        }
    }

    /// Whether a platform has the preset; `DepthAI` 2 supports RVC2 only.
    #[must_use]
    pub fn on(self, platform: Platform) -> bool {
        platform == Platform::Rvc2 || !matches!(self, Self::HighAccuracy | Self::HighDensity)
    }

    /// The names of a platform's presets.
    #[must_use]
    pub fn names_on(platform: Platform) -> Vec<&'static str> {
        let on_platform = Self::ALL.iter().filter(|preset| preset.on(platform));
        on_platform.map(|preset| preset.name()).collect()
    }

    /// Finds a preset by name; case, hyphens and underscores do not matter.
    ///
    /// # Errors
    /// Returns an error if the platform has no preset of this name.
    pub fn find(platform: Platform, name: &str) -> Result<Self, PresetError> {
        let place = platform.title();
        match Self::ALL.into_iter().find(|preset| is_named(name, preset.name())) {
            Some(preset) if preset.on(platform) => Ok(preset),
            Some(preset) => Err(PresetError {
                what: format!("{} is a preset of RVC2, not of {place}", preset.name()),
                remedy: format!("use one of {}", Self::names_on(platform).join(", ")),
            }),
            None if TIME_OF_FLIGHT_PRESETS.iter().any(|known| is_named(name, known)) => Err(PresetError {
                what: format!("{name} is a preset of time-of-flight sensors, not of {place}'s stereo"),
                remedy: format!("use one of {}", Self::names_on(platform).join(", ")),
            }),
            None => Err(PresetError::unknown(name, place, &Self::names_on(platform))),
        }
    }
}

/// The filters whose order is configurable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilterStage {
    /// `DECIMATION`
    Decimation,
    /// `SPECKLE`
    Speckle,
    /// `MEDIAN`
    Median,
    /// `SPATIAL`
    Spatial,
    /// `TEMPORAL`
    Temporal,
}

/// The part of `DepthAI`'s `StereoDepthConfig` that has an effect here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoConfig {
    /// `enableSubpixel` and `subpixelFractionalBits`
    pub subpixel: Subpixel,
    /// `enableExtended`
    pub extended_disparity: bool,
    /// `disparityShift`, px.
    pub disparity_shift_px: u32,
    /// `leftRightCheckThreshold`; `None` if the check is disabled.
    pub left_right_check_threshold: Option<u32>,
    /// The platform whose penalties are used.
    pub platform: Platform,
    /// `noiseThresholdOffset` and `noiseThresholdScale` of RVC4's census transform.
    pub noise_threshold: [i32; 2],
    /// `defaultValue` of RVC4's `p1Config` and `p2Config` where they are not adaptive.
    pub fixed_penalties: Option<[u32; 2]>,
    /// `confidenceMetrics` of RVC4
    pub confidence_metrics: ConfidenceMetrics,
    /// `holeFilling` of RVC4
    pub hole_filling: HoleFilling,
    /// `adaptiveMedianFilter` of RVC4
    pub adaptive_median: AdaptiveMedian,
    /// `confidenceThreshold` of `DepthAI` 3, 0 to 255: higher confidences are kept. In `DepthAI` 2, it is 255 minus this.
    pub confidence_threshold: u8,
    /// `filteringOrder`
    pub filtering_order: [FilterStage; 5],
    /// `median`
    pub median: Option<Median>,
    /// `spatialFilter`
    pub spatial: Option<Spatial>,
    /// `temporalFilter`
    pub temporal: Option<Temporal>,
    /// `speckleFilter`
    pub speckle: Option<Speckle>,
    /// `decimationFilter`; a factor of 1 disables it.
    pub decimation: Decimation,
    /// `thresholdFilter`
    pub threshold: Threshold,
    /// `brightnessFilter`
    pub brightness: Brightness,
}

/// The defaults of `DepthAI` 3.
impl Default for StereoConfig {
    fn default() -> Self {
        Self {
            subpixel: Subpixel::Bits5,
            extended_disparity: false,
            disparity_shift_px: 0,
            left_right_check_threshold: Some(10),
            platform: Platform::Rvc2,
            noise_threshold: [0, 0],
            fixed_penalties: None,
            confidence_metrics: ConfidenceMetrics::default(),
            hole_filling: HoleFilling::default(),
            adaptive_median: AdaptiveMedian::default(),
            confidence_threshold: 55,
            filtering_order: [
                FilterStage::Median,
                FilterStage::Decimation,
                FilterStage::Speckle,
                FilterStage::Spatial,
                FilterStage::Temporal,
            ],
            median: None,
            spatial: None,
            temporal: None,
            speckle: None,
            decimation: Decimation::default(),
            threshold: Threshold::default(),
            brightness: Brightness::default(),
        }
    }
}

impl StereoConfig {
    /// Returns the configuration of a preset.
    ///
    /// # Errors
    /// Returns an error if the platform has no preset of this name.
    pub fn preset(platform: Platform, name: &str) -> Result<Self, PresetError> {
        let preset = Preset::find(platform, name)?;
        Ok(match platform {
            Platform::Rvc2 => Self::rvc2(preset),
            Platform::Rvc4 => Self::rvc4(preset),
        })
    }

    fn rvc2(preset: Preset) -> Self {
        let accuracy = Self {
            left_right_check_threshold: Some(5),
            ..Self::default()
        };
        let density = Self {
            confidence_threshold: 15,
            ..Self::default()
        };
        match preset {
            Preset::Accuracy | Preset::FastAccuracy | Preset::HighAccuracy => accuracy,
            Preset::Density | Preset::FastDensity | Preset::HighDensity => density,
            Preset::Default => Self {
                subpixel: Subpixel::Bits3,
                median: Some(Median::Kernel7x7),
                ..density.filtered()
            },
            Preset::Face => Self {
                extended_disparity: true,
                threshold: Threshold {
                    min_range: 30,
                    max_range: 3000,
                },
                ..density.filtered()
            },
            Preset::HighDetail => Self {
                extended_disparity: true,
                ..accuracy.filtered()
            },
            Preset::Robotics => Self {
                subpixel: Subpixel::Bits3,
                median: Some(Median::Kernel7x7),
                spatial: Some(Spatial {
                    delta: 20,
                    ..Spatial::default()
                }),
                temporal: None,
                threshold: Threshold {
                    min_range: 0,
                    max_range: 10_000,
                },
                ..density.filtered()
            },
        }
    }

    /// Returns it with the filters that RVC2's purpose-specific presets share.
    fn filtered(self) -> Self {
        Self {
            filtering_order: [
                FilterStage::Decimation,
                FilterStage::Median,
                FilterStage::Speckle,
                FilterStage::Spatial,
                FilterStage::Temporal,
            ],
            decimation: Decimation {
                factor: 2,
                mode: DecimationMode::PixelSkipping,
            },
            spatial: Some(Spatial {
                hole_filling_radius: 1,
                ..Spatial::default()
            }),
            temporal: Some(Temporal {
                alpha: 0.5,
                ..Temporal::default()
            }),
            speckle: Some(Speckle {
                speckle_range: 200,
                ..Speckle::default()
            }),
            threshold: Threshold {
                min_range: 0,
                max_range: 15_000,
            },
            ..self
        }
    }

    fn rvc4(preset: Preset) -> Self {
        let extended = Self {
            platform: Platform::Rvc4,
            extended_disparity: true,
            ..Self::default()
        };
        match preset {
            Preset::Default | Preset::Density | Preset::FastDensity | Preset::HighDensity => Self {
                left_right_check_threshold: Some(4),
                confidence_threshold: 20,
                noise_threshold: [0, -40],
                fixed_penalties: Some([20, 85]),
                confidence_metrics: ConfidenceMetrics {
                    occlusion_weight: 28,
                    motion_vector_weight: 0,
                    flatness_weight: 4,
                    flatness_threshold: 4,
                    ..ConfidenceMetrics::default()
                },
                hole_filling: HoleFilling {
                    enable: false,
                    ..HoleFilling::default()
                },
                median: Some(Median::Kernel5x5),
                speckle: Some(Speckle {
                    speckle_range: 200,
                    ..Speckle::default()
                }),
                brightness: Brightness {
                    min_brightness: -1,
                    max_brightness: 256,
                },
                ..extended
            },
            _ => Self {
                confidence_threshold: 97,
                noise_threshold: [0, 84],
                fixed_penalties: Some([16, 65]),
                confidence_metrics: ConfidenceMetrics {
                    occlusion_weight: 14,
                    motion_vector_weight: 16,
                    flatness_weight: 2,
                    flatness_threshold: 4,
                    ..ConfidenceMetrics::default()
                },
                hole_filling: HoleFilling {
                    high_confidence_threshold: 240,
                    fill_confidence_threshold: 251,
                    ..HoleFilling::default()
                },
                ..extended
            },
        }
    }

    /// The enabled filters in their order: brightness first, on the matcher's output, and threshold last, on depth.
    #[must_use]
    pub fn filters(&self) -> Vec<Filter> {
        let brightness = (self.brightness.min_brightness >= 0 || self.brightness.max_brightness <= 255)
            .then_some(Filter::Brightness(self.brightness));
        let threshold = (self.threshold != Threshold::default()).then_some(Filter::Threshold(self.threshold));
        let ordered = self.filtering_order.iter().filter_map(|stage| match stage {
            FilterStage::Decimation => {
                (self.decimation.factor > 1).then_some(Filter::Decimation(self.decimation))
            }
            FilterStage::Speckle => self.speckle.map(Filter::Speckle),
            FilterStage::Median => self.median.map(Filter::Median),
            FilterStage::Spatial => self.spatial.map(Filter::Spatial),
            FilterStage::Temporal => self.temporal.map(Filter::Temporal),
        });
        brightness.into_iter().chain(ordered).chain(threshold).collect()
    }

    /// Configures the step and range of disparity, the left-right check and the confidence threshold.
    pub fn apply_to(&self, parameters: &mut stereo_noise::Parameters) {
        parameters.subpixel = self.subpixel;
        parameters.extended_disparity = self.extended_disparity;
        parameters.disparity_shift_px = self.disparity_shift_px;
        parameters.left_right_check = self.left_right_check_threshold.is_some();
        if let Some(threshold) = self.left_right_check_threshold {
            parameters.left_right_check_threshold_px = threshold;
        }
        parameters.confidence_threshold = self.confidence_threshold;
    }

    /// Configures the matcher: as [`StereoConfig::apply_to`], and the noise thresholds, the penalties and RVC4's steps.
    pub fn apply_to_matching(&self, parameters: &mut stereo_matching::Parameters) {
        parameters.subpixel = self.subpixel;
        parameters.extended_disparity = self.extended_disparity;
        parameters.disparity_shift_px = self.disparity_shift_px;
        parameters.left_right_check = self.left_right_check_threshold.is_some();
        if let Some(threshold) = self.left_right_check_threshold {
            parameters.left_right_check_threshold_px = threshold;
        }
        parameters.confidence_threshold = self.confidence_threshold;
        parameters.platform = self.platform;
        [
            parameters.noise_threshold_offset,
            parameters.noise_threshold_scale,
        ] = self.noise_threshold;
        if let Some([p1, p2]) = self.fixed_penalties {
            (parameters.p1.adaptive, parameters.p1.default) = (false, p1);
            (parameters.p2.adaptive, parameters.p2.default) = (false, p2);
        }
        parameters.confidence_metrics = self.confidence_metrics;
        parameters.hole_filling = self.hole_filling;
        parameters.adaptive_median = self.adaptive_median;
    }
}
