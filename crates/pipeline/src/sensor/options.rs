use oaktwin_base::parameter::Scalar;
use oaktwin_camera::{Intrinsics, StereoDrift};
use oaktwin_catalog::DepthKind;
use oaktwin_depth::engines::{STEREO_NOISE, calibration_error_px};
use oaktwin_depth::{EngineKind, EngineRef, ParameterError, Setup, Technology};
use oaktwin_usd::asset::IsaacVersion;

/// Returns the default engine for a kind of depth sensor.
#[must_use]
pub fn default_engine(kind: DepthKind) -> &'static EngineKind {
    EngineKind::default_for(technology(kind))
}

pub(super) fn technology(kind: DepthKind) -> Technology {
    match kind {
        DepthKind::Stereo => Technology::Stereo,
        DepthKind::Tof => Technology::TimeOfFlight,
    }
}

/// Whether an engine models a kind of depth sensor.
pub(crate) fn models(engine: &EngineKind, kind: DepthKind) -> bool {
    engine.models.is_none_or(|models| models == technology(kind))
}

/// The options of a depth sensor.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SensorOptions {
    /// The engine; by default [`default_engine`] of the sensor's kind.
    pub engine: Option<EngineRef>,
    /// The name of a `DepthAI` preset for the device's platform: the mode of the matcher, and its filters.
    pub preset: Option<String>,
    /// Filters as text, first to last; they replace the preset's.
    pub filters: Vec<String>,
    /// Parameters of the engine by name, in this order; they override everything else.
    pub parameters: Vec<(String, Scalar)>,
    /// Whether the extended disparity range is enabled: 190 px, or the catalog's values for the extended mode.
    pub extended_disparity: bool,
    /// The Isaac Sim version whose defaults `single_view` has for attributes without a value; by default the version of the scene's
    /// asset, else the oldest supported.
    pub isaac: Option<IsaacVersion>,
    /// The intrinsics of the depth images, if not the twin's: the focal length at their width is used.
    pub image: Option<Intrinsics>,
    /// The name of the camera, which keys its noise; by default the sensor's prim.
    pub name: Option<String>,
    /// The noise seed.
    pub seed: u64,
    /// The seed of an individual unit's calibration bias; by default the unit has none.
    pub device_seed: Option<u64>,
    /// The change of the stereo pair since its calibration; by default none.
    pub drift: Option<StereoDrift>,
}

/// The light that the cameras of a stereo pair see, relative to the light of a bright room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Illumination {
    /// The light at the centre of a dot of the projector on a surface 1 m away; 0 without a projector.
    pub dot_contrast: f64,
    /// The light of the scene; 0 is a dark room.
    pub ambient: f64,
}

impl Default for Illumination {
    fn default() -> Self {
        Self {
            dot_contrast: 0.0,
            ambient: 1.0,
        }
    }
}

impl SensorOptions {
    /// Returns the engine, or the default one for a kind of depth sensor.
    #[must_use]
    pub fn engine_for(&self, kind: DepthKind) -> EngineRef {
        let default = || default_engine(kind).into();
        self.engine.clone().unwrap_or_else(default)
    }

    /// Returns the options with the parameters of `stereo-noise` for this light, which parameters that are given override. Other
    /// engines see the light in their images or do not depend on it.
    #[must_use]
    pub fn lit_by(mut self, light: Illumination) -> Self {
        if self.engine.as_ref().is_some_and(|engine| *engine == STEREO_NOISE) {
            let usual = Illumination::default();
            let parameters = [
                ("dotContrast", light.dot_contrast, usual.dot_contrast),
                ("ambient", light.ambient, usual.ambient),
            ];
            #[expect(clippy::float_cmp, reason = "a default that nobody changed")]
            let changed = parameters.into_iter().filter(|(_, value, usual)| value != usual);
            let changed = changed.map(|(name, value, _)| (name.to_owned(), value.into()));
            self.parameters.splice(0..0, changed);
        }
        self
    }

    /// Returns the error of the disparities of the unit's stereo pair, in pixels of the mode's full width: the parameter
    /// `bias`, else the bias drawn from the device seed, else 0.
    ///
    /// # Errors
    /// Returns an error if the bias is out of range.
    pub fn calibration_error_px(&self) -> Result<f64, ParameterError> {
        calibration_error_px(&Setup {
            device_seed: self.device_seed,
            parameters: self.parameters.clone(),
            ..Setup::new(800.0, 1280, 0.075)
        })
    }
}
