use oaktwin_image::{Image, ZDepth, millimetres};

use crate::Shot;
use crate::filter::Chain;
use crate::random::Stream;
use crate::single_view::{self, SingleView};
use crate::stereo_noise::StereoNoise;

/// How a depth image becomes a measured one.
#[derive(Clone, Debug, PartialEq)]
pub enum Engine {
    /// As Isaac Sim's `DepthSensorDistance` does.
    SingleView(SingleView),
    /// With the errors of an OAK's stereo.
    StereoNoise(StereoNoise),
}

/// An engine with its filters: looks at one image after the other, and may remember earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    engine: Engine,
    filters: Chain,
    random: Stream,
}

/// What a sensor reports of one shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    /// Metres, 0 where nothing was measured.
    pub distance: ZDepth,
    /// What Isaac Sim's sensor has beside it.
    pub single_view: Option<single_view::Output>,
}

impl Sensor {
    /// An engine and its filters, with the random numbers of a camera.
    #[must_use]
    pub fn new(engine: Engine, filters: Chain, random: Stream) -> Self {
        Self {
            engine,
            filters,
            random,
        }
    }

    /// The engine.
    #[must_use]
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// The filters, and what they remember.
    #[must_use]
    pub fn filters(&self) -> &Chain {
        &self.filters
    }

    /// What it reports of the next shot. [`SingleView`]'s sister outputs are made where they are `wanted`.
    #[must_use]
    pub fn capture(&mut self, shot: &Shot<'_>, wanted: single_view::Wanted) -> Capture {
        match &self.engine {
            Engine::SingleView(engine) => {
                let output = engine.sense(shot, &self.random, wanted);
                let distance = if self.filters.is_empty() {
                    output.distance.clone()
                } else {
                    let filtered: Image<u16> = self.filters.run(millimetres::from_metres(&output.distance.0));
                    ZDepth(millimetres::to_metres(&filtered))
                };
                Capture {
                    distance,
                    single_view: Some(output),
                }
            }
            Engine::StereoNoise(engine) => {
                let disparity = self.filters.run(engine.disparity(shot, &self.random));
                Capture {
                    distance: engine.depth(&disparity, 1.0),
                    single_view: None,
                }
            }
        }
    }
}
