//! From the state of an OAK on the page to the types of the library.

use oaktwin::camera::{ImageSize, RigidTransform};
use oaktwin::catalog::{Device, LensChoice, Twin};
use oaktwin::depth::imager::ColorParameters;
use oaktwin::depth::parameters::choose;
use oaktwin::diagnostic::Finding;
use oaktwin::image::annotation::Annotator;
use oaktwin::pair::{PairCameras, PairOptions, illumination};
use oaktwin::render::{
    self, OakOptions, PairUse, PlacedCamera, Rig, RigError, RigSpec, Transparent, oak_cameras,
};
use oaktwin::sensor::{EngineInput, EngineKind, Scalar, Sensor, SensorOptions};

use crate::protocol::{Failure, OakState};
use crate::size::{check_memory, check_pixels};
use crate::studio::Studio;
use crate::unit::Drawn;

/// The maximum number of filters of a sensor.
const MAX_FILTERS: usize = 32;

/// An OAK in a scene, ready to be rendered.
#[derive(Debug)]
pub(crate) struct Oak {
    pub(crate) twin: Twin,
    pub(crate) camera: PlacedCamera,
    pub(crate) sensor: Sensor,
    /// The rig of this camera alone.
    pub(crate) rig: Rig,
    /// The stereo pair, if the device has one.
    pub(crate) pair: Option<PairCameras>,
    pub(crate) findings: Vec<Finding>,
}

impl OakState {
    /// Returns the twin: nominal, of a dropped calibration, or a unit of the population.
    pub(crate) fn twin(&self, studio: &Studio) -> Result<Twin, Failure> {
        let (catalog, device) = (&*studio.catalog, self.device(studio)?);
        match (&self.calibration, self.drawn(studio)?) {
            (None, None) => Ok(catalog.nominal(device)),
            (None, Some(drawn)) => drawn.twin(catalog, device),
            (Some(id), None) => {
                let twin = studio.calibrations.twin(catalog, device, id)?;
                let mut sizes = twin.cameras.iter().map(|camera| camera.intrinsics.size);
                sizes.try_for_each(check_pixels)?;
                Ok(twin)
            }
            (Some(_), Some(_)) => {
                let error =
                    "a calibration describes one unit; choose the calibration or a unit of the population";
                Err(Failure::of("populationSeed", error))
            }
        }
    }

    fn device<'a>(&self, studio: &'a Studio) -> Result<&'a Device, Failure> {
        (studio.catalog.device(&self.model)).map_err(|error| Failure::of("model", &error))
    }

    /// Returns the unit of the population, if one is chosen.
    pub(crate) fn drawn(&self, studio: &Studio) -> Result<Option<Drawn>, Failure> {
        let Some(seed) = self.population_seed else {
            return Ok(None);
        };
        Ok(Some(Drawn::new(&studio.catalog, self.device(studio)?, seed)))
    }

    pub(crate) fn lens(&self) -> Result<LensChoice, Failure> {
        choose("lens", &self.lens).map_err(|error| Failure::of("lens", &error))
    }

    pub(crate) fn engine(&self) -> Result<&'static EngineKind, Failure> {
        EngineKind::parse(&self.engine).map_err(|error| Failure::of("engine", &error))
    }

    fn filters(&self) -> Result<Vec<String>, Failure> {
        let filters = self.filters.clone().unwrap_or_default();
        match filters.len() <= MAX_FILTERS {
            true => Ok(filters),
            false => {
                let error = format!(
                    "{} filters are too many; choose at most {MAX_FILTERS}",
                    filters.len()
                );
                Err(Failure::of("filters", &error))
            }
        }
    }

    /// Returns the options of the sensor.
    pub(crate) fn options(&self) -> Result<SensorOptions, Failure> {
        let parameters = self.parameters.iter();
        Ok(SensorOptions {
            engine: Some(self.engine()?.into()),
            preset: self.preset.clone(),
            filters: self.filters()?,
            parameters: parameters
                .map(|(name, value)| (name.clone(), Scalar::of(value)))
                .collect(),
            extended_disparity: self.extended_disparity,
            seed: self.seed,
            device_seed: self.device_seed,
            drift: self.drift()?,
            ..SensorOptions::default()
        })
    }

    /// Returns the kind of the depth sensor, `stereo` or `tof`, or its prim.
    pub(crate) fn sensor_kind(&self) -> &str {
        self.sensor.strip_prefix("depth_").unwrap_or(&self.sensor)
    }

    /// Returns the intensity of the dot projector: 0 where there is none, unless a matcher asks for its dots, which is an error.
    pub(crate) fn projector(&self, studio: &Studio) -> Result<f64, Failure> {
        let is_matcher = self.engine()?.input == EngineInput::Pair;
        Ok(match self.device(studio)?.projector {
            None if !is_matcher => 0.0,
            _ => self.projector,
        })
    }

    /// Returns the options of the sensor with the light among its parameters, where the engine has some for it.
    pub(crate) fn lit_options(&self, studio: &Studio) -> Result<SensorOptions, Failure> {
        let twin = self.twin(studio)?;
        let light = illumination(&twin, self.projector(studio)?, self.ambient);
        let light = light.map_err(|error| Failure::of("projector", &error))?;
        Ok(self.options()?.lit_by(light))
    }

    /// Returns the ground truth of transparent surfaces.
    pub(crate) fn transparent(&self) -> Result<Transparent, Failure> {
        choose("transparent", &self.transparent).map_err(|error| Failure::of("transparent", &error))
    }

    /// Returns the image sensor of colours, if they are recorded.
    pub(crate) fn color_imager(&self) -> Result<Option<ColorParameters>, Failure> {
        let Some(changed) = &self.color_imager else {
            return Ok(None);
        };
        let mut parameters = ColorParameters::default();
        for (name, value) in changed {
            let set = parameters.set(name, value).and_then(|()| parameters.check());
            set.map_err(|error| Failure::of("colorImager", &error))?;
        }
        Ok(Some(parameters))
    }

    /// Returns the specification of the rig, with images of a size.
    pub(crate) fn spec(&self, studio: &Studio, size: Option<ImageSize>) -> Result<RigSpec, Failure> {
        Ok(RigSpec {
            cameras: vec![self.sensor.clone()],
            size,
            annotators: vec![Annotator::DepthSensorDistance],
            sensor: self.options()?,
            pair: PairOptions {
                projector: self.projector(studio)?,
                ambient: self.ambient,
                lens: self.lens()?,
                ..PairOptions::default()
            },
            rgb_imager: self.color_imager()?,
            transparent: self.transparent()?,
            ..RigSpec::default()
        })
    }
}

impl Oak {
    /// Places an OAK and creates its sensor. The stereo pair is created if `needs_pair`, or if the engine matches images.
    pub(crate) fn new(
        studio: &Studio,
        state: &OakState,
        size: Option<ImageSize>,
        needs_pair: bool,
    ) -> Result<Self, Failure> {
        let twin = state.twin(studio)?;
        let lens = state.lens()?;
        render::check_lens(&twin, lens).map_err(|error| Failure::of("lens", &error))?;
        let has_pair = needs_pair || state.engine()?.input == EngineInput::Pair;
        // Before a pair of such cameras takes the memory.
        let cameras = OakOptions {
            cameras: std::slice::from_ref(&state.sensor),
            lens,
            size,
        };
        let placed = oak_cameras(&twin, &RigidTransform::IDENTITY, &cameras);
        for camera in placed.map_err(|error| Failure::of("sensor", &error))?.0 {
            check_memory(camera.camera.intrinsics.size, has_pair)?;
        }
        let spec = RigSpec {
            pair_use: match needs_pair {
                true => PairUse::Beside,
                false => PairUse::Matched,
            },
            ..state.spec(studio, size)?
        };
        let made = Rig::new(&twin, &spec).map_err(|error| match &error {
            RigError::Camera(_) | RigError::NoDepthSensor(_) | RigError::Option(_) | RigError::Moment(_) => {
                Failure::of("sensor", &error)
            }
            RigError::Pair(_) => Failure::of("engine", &error),
            RigError::Sensor(inner) => Failure::of(&inner.error.name, &inner.error),
            RigError::Parameter(inner) => Failure::of(&inner.name, inner),
        });
        let (rig, mut findings) = made?;
        findings.extend(state.drawn(studio)?.map(|drawn| drawn.finding()));
        let rig = rig.at(&state.pose.transform()?);
        let Some((camera, sensor)) = rig.depth_sensor() else {
            let error = format!("{} has no depth sensor '{}'", state.model, state.sensor);
            return Err(Failure::of("sensor", &error));
        };
        let (camera, sensor, pair) = (camera.clone(), sensor.clone(), rig.pair().cloned());
        Ok(Self {
            twin,
            camera,
            sensor,
            rig,
            pair,
            findings,
        })
    }
}
