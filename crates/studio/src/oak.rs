//! From the state of an OAK on the page to the types of the library.

use oaktwin::camera::ImageSize;
use oaktwin::catalog::{Device, LensChoice, Twin};
use oaktwin::depth::parameters::choose;
use oaktwin::diagnostic::Finding;
use oaktwin::image::annotation::Annotator;
use oaktwin::pair::{PairCameras, PairOptions};
use oaktwin::render::{self, PairUse, PlacedCamera, Rig, RigError, RigSpec, check_size};
use oaktwin::sensor::{EngineKind, Sensor, SensorOptions};

use crate::protocol::{Failure, OakState};
use crate::studio::Studio;
use crate::unit::Drawn;

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
            (Some(id), None) => studio.calibrations.twin(catalog, device, id),
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

    /// Returns the options of the sensor.
    pub(crate) fn options(&self) -> Result<SensorOptions, Failure> {
        let parameters = self.parameters.iter();
        Ok(SensorOptions {
            engine: Some(self.engine()?.into()),
            preset: self.preset.clone(),
            filters: self.filters.clone().unwrap_or_default(),
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

    /// Returns the specification of the rig, with images of a size.
    pub(crate) fn spec(&self, size: Option<ImageSize>) -> Result<RigSpec, Failure> {
        Ok(RigSpec {
            cameras: vec![self.sensor.clone()],
            size,
            annotators: vec![Annotator::DepthSensorDistance],
            sensor: self.options()?,
            pair: PairOptions {
                projector: self.projector,
                ambient: self.ambient,
                lens: self.lens()?,
                ..PairOptions::default()
            },
            ..RigSpec::default()
        })
    }
}

/// Returns the size of images, if one is chosen.
pub(crate) fn image_size(size: Option<[u32; 2]>) -> Result<Option<ImageSize>, Failure> {
    let Some([width, height]) = size else {
        return Ok(None);
    };
    let size = ImageSize::new(width, height);
    check_size(size).map_err(|error| Failure::of("size", &error))?;
    Ok(Some(size))
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
        let spec = RigSpec {
            pair_use: match needs_pair {
                true => PairUse::Beside,
                false => PairUse::Matched,
            },
            ..state.spec(size)?
        };
        let made = Rig::new(&twin, &spec).map_err(|error| match &error {
            RigError::Camera(_) | RigError::Option(_) => Failure::of("sensor", &error),
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
            pair,
            findings,
        })
    }
}
