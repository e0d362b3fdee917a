use oaktwin_base::diagnostic::fold_name;
use oaktwin_base::parameter::Scalar;
use oaktwin_camera::StereoGeometry;

use crate::filter::Filter;
use crate::preset::{Platform, StereoConfig, TimeOfFlightConfig};
use crate::{Technology, single_view};

/// Everything that engines are made of; each engine reads the parts that it needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// The device's processor.
    pub platform: Platform,
    /// The focal length at `width_px`, px.
    pub focal_length_px: f64,
    /// The image width; for a stereo pair, the width of the matcher's mode.
    pub width_px: u32,
    /// The baseline in metres, 0 without a stereo pair.
    pub baseline_m: f64,
    /// The principal point (USD's convention); by default the image centre.
    pub principal_point_px: Option<[f64; 2]>,
    /// NVIDIA's attributes of the depth sensor.
    pub attributes: single_view::Parameters,
    /// A preset of `DepthAI`.
    pub preset: Option<PresetConfig>,
    /// Whether the extended disparity range is enabled, by the preset or otherwise.
    pub extended_disparity: bool,
    /// The seed of an individual unit's calibration bias; `None` for a unit without bias.
    pub device_seed: Option<u64>,
    /// Parameters by name, which override everything else.
    pub parameters: Vec<(String, Scalar)>,
}

impl Setup {
    /// Creates a setup of a camera with the defaults of RVC2 and Isaac Sim 5.1.
    #[must_use]
    pub fn new(focal_length_px: f64, width_px: u32, baseline_m: f64) -> Self {
        Self {
            platform: Platform::Rvc2,
            focal_length_px,
            width_px,
            baseline_m,
            principal_point_px: None,
            attributes: single_view::Parameters::isaac_5_1(),
            preset: None,
            extended_disparity: false,
            device_seed: None,
            parameters: Vec::new(),
        }
    }

    /// Whether a parameter is set by name.
    #[must_use]
    pub fn sets(&self, name: &str) -> bool {
        let name = fold_name(name);
        self.parameters.iter().any(|(given, _)| fold_name(given) == name)
    }

    /// Returns the geometry of the stereo pair.
    #[must_use]
    pub fn stereo(&self) -> StereoGeometry {
        StereoGeometry {
            focal_length_px: self.focal_length_px,
            baseline_m: self.baseline_m,
        }
    }
}

/// A preset of `DepthAI`.
#[derive(Clone, Debug, PartialEq)]
pub enum PresetConfig {
    /// The settings of a stereo pair.
    Stereo(Box<StereoConfig>),
    /// The settings of a time-of-flight camera.
    TimeOfFlight(TimeOfFlightConfig),
}

impl PresetConfig {
    /// The technology of the cameras that the preset is for.
    #[must_use]
    pub fn technology(&self) -> Technology {
        match self {
            Self::Stereo(_) => Technology::Stereo,
            Self::TimeOfFlight(_) => Technology::TimeOfFlight,
        }
    }

    /// The filters of the preset, in order.
    #[must_use]
    pub fn filters(&self) -> Vec<Filter> {
        match self {
            Self::Stereo(config) => config.filters(),
            Self::TimeOfFlight(config) => config.filters.clone(),
        }
    }

    /// Whether the preset enables the extended disparity range.
    #[must_use]
    pub fn extended_disparity(&self) -> bool {
        matches!(self, Self::Stereo(config) if config.extended_disparity)
    }
}
