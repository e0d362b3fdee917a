//! From the state of an OAK on the page to the types of the library.

use oaktwin::camera::ImageSize;
use oaktwin::catalog::{Device, LensChoice, Twin};
use oaktwin::depth::parameters::choose;
use oaktwin::diagnostic::Finding;
use oaktwin::pair::{PairCameras, PairOptions};
use oaktwin::render::{
    self, DepthSensorOptions, OakOptions, PlacedCamera, depth_sensors, oak_cameras, put_pair,
};
use oaktwin::sensor::{EngineInput, EngineKind, Sensor, SensorOptions};

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
            engine: Some(self.engine()?),
            preset: self.preset.clone(),
            filters: self.filters()?,
            parameters: parameters
                .map(|(name, value)| (name.clone(), value.clone()))
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

    /// Returns the options of the stereo pair.
    pub(crate) fn pair_options(&self, size: Option<ImageSize>) -> Result<PairOptions, Failure> {
        let options = PairOptions {
            projector: self.projector,
            ambient: self.ambient,
            lens: self.lens()?,
            size,
            ..PairOptions::default()
        };
        let options = options.of_sensor(&self.options()?);
        options.map_err(|error| Failure::of(&error.name, &error))
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
        let names = [state.sensor.clone()];
        let options = OakOptions {
            cameras: &names,
            lens,
            size,
        };
        let placed = oak_cameras(&twin, &state.pose.transform()?, &options);
        let (mut cameras, mut findings) = placed.map_err(|error| Failure::of("sensor", &error))?;
        findings.extend(state.drawn(studio)?.map(|drawn| drawn.finding()));
        let is_matching = state.engine()?.input == EngineInput::Pair;
        let has_pair = is_matching || needs_pair;
        for camera in &cameras {
            check_memory(camera.camera.intrinsics.size, has_pair)?;
        }
        let pair = match has_pair {
            // Only a matcher reports the depth of the rectified camera.
            true => {
                let mut unused = Vec::new();
                let moved = if is_matching { &mut cameras } else { &mut unused };
                match put_pair(&twin, moved, &state.pair_options(size)?) {
                    Ok((pair, more)) => {
                        findings.extend(more);
                        Some(pair)
                    }
                    Err(error) if is_matching => return Err(Failure::of("engine", &error)),
                    Err(_) => None,
                }
            }
            false => None,
        };
        let sensor_options = state.options()?;
        let made = depth_sensors(
            &cameras,
            &DepthSensorOptions {
                twin: Some(&twin),
                sensor: &sensor_options,
            },
        );
        let (sensors, more) = made.map_err(|error| Failure::of(&error.error.name, &error.error))?;
        findings.extend(more);
        let both = cameras.into_iter().zip(sensors);
        let Some((camera, sensor)) = both
            .into_iter()
            .find_map(|(camera, sensor)| Some((camera, sensor?)))
        else {
            let error = format!(
                "{} has no depth sensor '{}'; choose a model with one: {}",
                state.model,
                state.sensor,
                twin.device.models_with_depth(None)
            );
            return Err(Failure::of("sensor", &error));
        };
        Ok(Self {
            twin,
            camera,
            sensor,
            pair,
            findings,
        })
    }
}
