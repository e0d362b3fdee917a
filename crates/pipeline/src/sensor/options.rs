use oaktwin_camera::Intrinsics;
use oaktwin_depth::ParameterError;

use oaktwin_catalog::DepthKind;
use oaktwin_depth::Engine;
use oaktwin_diagnostic::{fold_name, nearest};
use oaktwin_usd::asset::IsaacVersion;

/// Which model of the errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineKind {
    /// Isaac Sim's `DepthSensorDistance`.
    SingleView,
    /// The errors of an OAK's stereo.
    StereoNoise,
    /// An OAK's stereo itself, on the pair that its cameras take.
    StereoMatching,
    /// The errors of a time-of-flight camera.
    TimeOfFlight,
}

impl EngineKind {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::SingleView,
        Self::StereoNoise,
        Self::StereoMatching,
        Self::TimeOfFlight,
    ];

    /// That of an engine.
    #[must_use]
    pub fn of(engine: &Engine) -> Self {
        match engine {
            Engine::SingleView(_) => Self::SingleView,
            Engine::StereoNoise(_) => Self::StereoNoise,
            Engine::StereoMatching(_) => Self::StereoMatching,
            Engine::TimeOfFlight(_) => Self::TimeOfFlight,
        }
    }

    /// The one of this name; case, hyphens and underscores do not matter.
    ///
    /// # Errors
    /// There is none.
    pub fn parse(name: &str) -> Result<Self, ParameterError> {
        let mut all = Self::ALL.into_iter();
        all.find(|kind| fold_name(kind.as_str()) == fold_name(name))
            .ok_or_else(|| {
                let names = || Self::ALL.into_iter().map(Self::as_str);
                let near = nearest(name, names());
                ParameterError {
                    name: "engine".to_owned(),
                    what: format!("there is no engine `{name}`"),
                    remedy: if near.is_empty() {
                        format!("use {}", names().collect::<Vec<_>>().join(" or "))
                    } else {
                        format!("did you mean {}?", near.join(" or "))
                    },
                }
            })
    }

    /// The one that is nearest to the device: the errors of an OAK's stereo, or of its time of flight.
    #[must_use]
    pub fn default_for(kind: DepthKind) -> Self {
        match kind {
            DepthKind::Stereo => Self::StereoNoise,
            DepthKind::Tof => Self::TimeOfFlight,
        }
    }

    /// As people name it: `stereo-noise`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::SingleView => "single-view",
            Self::StereoNoise => "stereo-noise",
            Self::StereoMatching => "stereo-matching",
            Self::TimeOfFlight => "time-of-flight",
        }
    }
}

/// How the sensor of a twin is to be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SensorOptions {
    /// By default [`EngineKind::default_for`] the sensor's kind.
    pub engine: Option<EngineKind>,
    /// A preset of `DepthAI`'s for the device's platform, by name: the mode of the matcher, and its filters.
    pub preset: Option<String>,
    /// Filters as text, first to last; where there are any, they take the place of the preset's.
    pub filters: Vec<String>,
    /// Values for the engine's parameters by name, in this order, after everything else.
    pub parameters: Vec<(String, String)>,
    /// The extended range of disparities: 190 px, or what the catalog says of the extended mode.
    pub extended_disparity: bool,
    /// The Isaac Sim whose defaults `single_view` has for what the twin does not say.
    pub isaac: IsaacVersion,
    /// The intrinsics of the depth images where they are not the twin's: the focal length at their width is used.
    pub image: Option<Intrinsics>,
    /// The camera's name, which tells its noise from other cameras'; by default the sensor's prim.
    pub name: Option<String>,
    /// Of the noise.
    pub seed: u64,
    /// Of the device's calibration bias; none has none.
    pub device_seed: Option<u64>,
}
