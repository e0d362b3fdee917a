mod batch;

use oaktwin_image::{Image, ImageView, ZDepth, millimetres};

use crate::Shot;
use crate::disparity::Subpixel;
use crate::filter::{Chain, Filter};
use crate::random::Stream;
use crate::single_view::{self, SingleView};
use crate::stereo_matching::StereoMatching;
use crate::stereo_noise::StereoNoise;
use crate::time_of_flight::TimeOfFlight;

/// How a depth image becomes a measured one.
#[derive(Clone, Debug, PartialEq)]
pub enum Engine {
    /// As Isaac Sim's `DepthSensorDistance` does.
    SingleView(SingleView),
    /// With the errors of an OAK's stereo.
    StereoNoise(StereoNoise),
    /// As a time-of-flight camera errs.
    TimeOfFlight(TimeOfFlight),
    /// From the [pair](Shot::with_pair) that its cameras took, as an OAK does. Without one, nothing is measured.
    StereoMatching(StereoMatching),
}

impl Engine {
    /// Its parameters by name with their values, as their `set` takes them.
    #[must_use]
    pub fn parameters(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::SingleView(engine) => {
                let mut parameters: Vec<_> = engine.parameters().by_name().collect();
                parameters.sort_unstable();
                parameters
            }
            Self::StereoNoise(engine) => engine.parameters().by_name().collect(),
            Self::TimeOfFlight(engine) => engine.parameters().by_name().collect(),
            Self::StereoMatching(engine) => engine.parameters().by_name().collect(),
        }
    }
}

/// An engine with its filters: looks at one image after the other, and may remember earlier ones.
///
/// # Where filters run
/// * On stereo, as on the device, on fixed-point disparity. The disparities that can be found are spread over 0 to 8192
///   first, as `DepthAI`'s `getMaxDisparity` says, unless no filter changes them or the last that does is a median:
///   `delta` is in these units, `differenceThreshold` in pixels of disparity. Filters of depth ([`Filter::is_of_depth`]) run after all others,
///   on millimetres.
/// * On all else in their order on depth, whole millimetres.
///
/// Decimation is where it stands in the chain, and what follows works on the smaller image. Its values are as they were:
/// disparities of the matcher's full width, hence the same depths. A picture, for the brightness filter, is looked at where
/// the pixel was.
///
/// A [temporal filter](crate::filter::Temporal) remembers each pixel's last value and in which of the last 8 frames it had
/// one, so frames are given in order and each camera has a `Sensor` of its own; without one, what is reported depends on
/// the shot alone. An image of another size begins anew.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    engine: Engine,
    filters: Chain,
    random: Stream,
}

/// What a sensor reports of one shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    /// Metres, 0 where nothing was measured. Smaller than the shot where a filter decimates: [`Chain::size`].
    pub distance: ZDepth,
    /// What Isaac Sim's sensor has beside it.
    pub single_view: Option<single_view::Output>,
    /// How sure the matcher is of each pixel of a pair, 0 to 255; higher is surer. Not filtered.
    pub confidence: Option<Image<u8>>,
    /// What the matcher found in a pair, after the filters that work on disparity.
    pub disparity: Option<FixedDisparity>,
}

/// A disparity image in fixed point.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedDisparity {
    /// 0 where nothing was measured.
    pub fixed: Image<u16>,
    /// A unit, px.
    pub step_px: f64,
    /// The disparity that 0 would stand for, px.
    pub shift_px: u32,
}

impl FixedDisparity {
    /// Pixels of the pair, 0 where nothing was measured.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "pixels are single precision")]
    pub fn to_px(&self) -> Image<f32> {
        let shift = f64::from(self.shift_px);
        self.fixed.map(|&fixed| match fixed {
            0 => 0.0,
            fixed => (f64::from(fixed) * self.step_px + shift) as f32,
        })
    }
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

    /// Whether what it reports depends on earlier frames.
    #[must_use]
    pub fn remembers(&self) -> bool {
        let is_temporal = |filter: &Filter| matches!(filter, Filter::Temporal(_));
        self.filters.filters().iter().any(is_temporal)
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        self.filters.reset();
    }

    /// What it reports of the next shot. [`SingleView`]'s sister outputs are made where they are `wanted`; they are not
    /// filtered.
    #[must_use]
    pub fn capture(&mut self, shot: &Shot<'_>, wanted: single_view::Wanted) -> Capture {
        match &self.engine {
            Engine::SingleView(engine) => {
                let output = engine.sense(shot, &self.random, wanted);
                let distance = self.filters.run_on_metres(&output.distance, shot.rgb(), |_| true);
                Capture {
                    distance: distance.unwrap_or_else(|| output.distance.clone()),
                    single_view: Some(output),
                    confidence: None,
                    disparity: None,
                }
            }
            Engine::StereoNoise(engine) => {
                let depth = if self.filters.filters().iter().all(Filter::is_of_depth) {
                    engine.sense(shot, &self.random)
                } else {
                    let mut disparity = engine.disparity(shot, &self.random);
                    let p = engine.parameters();
                    let most = p.max_disparity_px();
                    let scale = rescale(self.filters.filters(), most, p.subpixel, &mut disparity);
                    let is_of_disparity = |filter: &Filter| !filter.is_of_depth();
                    let integer_level = scale * f64::from(1 << p.subpixel.bits());
                    let filtered =
                        self.filters
                            .run_some(disparity, shot.rgb(), integer_level, is_of_disparity);
                    engine.depth(&filtered, scale)
                };
                let distance = self
                    .filters
                    .run_on_metres(&depth, shot.rgb(), Filter::is_of_depth);
                Capture {
                    distance: distance.unwrap_or(depth),
                    single_view: None,
                    confidence: None,
                    disparity: None,
                }
            }
            Engine::TimeOfFlight(engine) => {
                let depth = engine.sense(shot, &self.random);
                let distance = self.filters.run_on_metres(&depth, shot.rgb(), |_| true);
                Capture {
                    distance: distance.unwrap_or(depth),
                    single_view: None,
                    confidence: None,
                    disparity: None,
                }
            }
            Engine::StereoMatching(engine) => self.match_pair(&engine.clone(), shot),
        }
    }
}

impl Sensor {
    /// What is matched, filtered. The picture for filters is the left image.
    fn match_pair(&mut self, engine: &StereoMatching, shot: &Shot<'_>) -> Capture {
        let (mut disparity, confidence, pair_width) = match shot.pair() {
            Some(pair) => {
                let matched = engine.disparity(&pair);
                (matched.disparity, Some(matched.confidence), pair.width())
            }
            None => {
                let (width, height) = (shot.depth().width(), shot.depth().height());
                (Image::filled(width, height, 0), None, width)
            }
        };
        let filters = self.filters.filters();
        let picture = shot
            .pair()
            .filter(|_| filters.iter().any(Filter::needs_rgb))
            .map(|pair| pair.left().picture());
        let rgb = picture.as_ref().map(ImageView::from);
        let scale = if filters.iter().all(Filter::is_of_depth) {
            1.0
        } else {
            let p = engine.parameters();
            let scale = rescale(filters, p.max_disparity_px(), p.subpixel, &mut disparity);
            let is_of_disparity = |filter: &Filter| !filter.is_of_depth();
            let integer_level = scale * f64::from(1 << p.subpixel.bits());
            disparity = self
                .filters
                .run_some(disparity, rgb, integer_level, is_of_disparity);
            scale
        };
        let depth = engine.depth(&disparity, scale, pair_width);
        let distance = self.filters.run_on_metres(&depth, rgb, Filter::is_of_depth);
        let p = engine.parameters();
        Capture {
            distance: distance.unwrap_or(depth),
            single_view: None,
            disparity: confidence.is_some().then(|| FixedDisparity {
                fixed: disparity,
                step_px: p.subpixel.step_px() / scale,
                shift_px: p.disparity_shift_px,
            }),
            confidence,
        }
    }
}

/// What the disparities that can be found are spread over where filters change them: 13 bits, by `DepthAI`'s
/// `StereoDepthConfig::getMaxDisparity`.
const FILTERED_RANGE: f64 = 8192.0;

/// Spreads disparities for the filters, and says by what. How the device rounds is not published: to the nearest.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "disparities of 16 bits; saturates"
)]
fn rescale(filters: &[Filter], most_px: u32, subpixel: Subpixel, disparity: &mut Image<u16>) -> f64 {
    let changes = |filter: &&Filter| !filter.is_of_depth() && !filter.needs_rgb();
    match filters.iter().rfind(changes) {
        None | Some(Filter::Median(_)) => 1.0,
        Some(_) => {
            let most = most_px << subpixel.bits();
            let scale = FILTERED_RANGE / f64::from(most);
            for fixed in disparity.pixels_mut() {
                let spread = (f64::from(*fixed) * scale + 0.5) as u16;
                *fixed = spread.max(u16::from(*fixed > 0));
            }
            scale
        }
    }
}

impl Chain {
    /// Runs those that are wanted on millimetres; none where there are none.
    fn run_on_metres(
        &mut self,
        depth: &ZDepth,
        rgb: Option<ImageView<'_, [u8; 4]>>,
        wanted: impl Fn(&Filter) -> bool,
    ) -> Option<ZDepth> {
        if !self.filters().iter().any(&wanted) {
            return None;
        }
        let filtered = self.run_some(millimetres::from_metres(&depth.0), rgb, 1.0, wanted);
        Some(ZDepth(millimetres::to_metres(&filtered)))
    }
}

#[cfg(test)]
mod tests;
