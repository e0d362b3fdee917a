//! The stand that cameras are measured on: a board at a distance, and cameras that look at its middle.

use std::ops::Range;

use crate::measure::{Optics, Quality, Region, Vendor, quality, vendor};
use oaktwin_depth::filter::Chain;
use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, Depth, SingleView, Wanted};
use oaktwin_depth::stereo_matching::{Pair, StereoMatching};
use oaktwin_depth::stereo_noise::StereoNoise;
use oaktwin_depth::time_of_flight::{self, TimeOfFlight};
use rayon::prelude::*;

use super::AccuracyError;
use super::board::{self, Board, Sight};
use super::eyes::Eyes;
use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint, Usd};
use oaktwin_image::{Image, ImageView, ZDepth};
use oaktwin_pipeline::sensor::{Engine, ParameterError, Sensor, Shot};

/// What lies around the region has its say beyond windows and neighbourhoods too: in the edges of textures, px.
const AROUND_PX: u32 = 4;
/// Filters look farther; some carry values along whole rows, halving them at each pixel.
const AROUND_FILTERS_PX: u32 = 72;

/// Paths of a matcher go over the whole image; what lies farther than this moves a disparity by about a tenth of a
/// pixel, px.
const PATHS_PX: u32 = 128;

/// Cameras of one model, to be measured one after the other.
#[derive(Debug)]
pub(super) struct Stand {
    /// Of the whole depth image.
    pub(super) intrinsics: Intrinsics,
    /// What is measured of it.
    pub(super) region: Region,
    /// The cameras.
    pub(super) units: Vec<Unit>,
    /// Their noise; each has its own.
    pub(super) random: Stream,
    /// What takes their pictures, where they match pairs.
    pub(super) eyes: Option<Eyes>,
}

/// A camera.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unit {
    pub(super) engine: Engine,
    pub(super) filters: Chain,
    /// Of the calibration of a pair that is matched, px of the whole image; other engines have it in their parameters.
    pub(super) bias_px: f64,
}

/// What was measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured {
    pub(super) vendor: Vendor,
    /// Nothing where it was not asked for.
    pub(super) quality: Quality,
}

/// How thoroughly to measure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    pub(super) captures: u32,
    /// Whether [`Measured::quality`] is wanted too.
    pub(super) quality: bool,
}

/// One unit's, and for Isaac Sim's sensor what it would be if depth was computed from disparity, or was not.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeasuredUnit {
    pub(super) own: Measured,
    pub(super) other: Option<Measured>,
}

impl Stand {
    /// Measures every unit at a distance, m.
    pub(super) fn measure(
        &self,
        distance_m: f64,
        effort: Effort,
        wants_more: &(dyn Fn() -> bool + Sync),
    ) -> Result<Vec<MeasuredUnit>, AccuracyError> {
        let part = self.part(distance_m);
        let scenery = Scenery::new(self, &part, distance_m);
        let measure = |(unit, item): (&Unit, u32)| {
            if !wants_more() {
                return Err(AccuracyError::Interrupted);
            }
            let of = |engine: &Engine| self.measure_unit(engine, unit, item, &scenery, &part, effort);
            Ok(MeasuredUnit {
                own: of(&unit.engine)?,
                other: other_reading(&unit.engine)?
                    .map(|engine| of(&engine))
                    .transpose()?,
            })
        };
        let numbered: Vec<(&Unit, u32)> = self.units.iter().zip(0..).collect();
        numbered.into_par_iter().map(measure).collect()
    }

    /// Disparity times depth in the pixels that the engine counts disparity in, px·m.
    pub(super) fn disparity_times_depth(&self) -> f64 {
        let width = self.intrinsics.size.width;
        self.units
            .first()
            .map_or(0.0, |unit| disparity_times_depth(&unit.engine, width))
    }

    /// Nearer than this nothing is measured, m.
    pub(super) fn nearest_m(&self) -> f64 {
        match self.units.first().map(|unit| &unit.engine) {
            Some(Engine::SingleView(engine)) => {
                let p = engine.parameters();
                let by_disparity = self.disparity_times_depth() / p.max_disparity_px;
                p.min_distance_m.max(by_disparity)
            }
            Some(Engine::StereoNoise(engine)) => {
                let p = engine.parameters();
                p.stereo.depth(f64::from(p.max_disparity_px()))
            }
            Some(Engine::TimeOfFlight(engine)) => engine.nearest_m(),
            Some(Engine::StereoMatching(engine)) => {
                let p = engine.parameters();
                p.stereo.depth(f64::from(p.max_disparity_px()))
            }
            None => 0.0,
        }
    }

    /// For Isaac Sim's sensor, whether it carries the rendered depth along.
    pub(super) fn carries_depth(&self) -> Option<bool> {
        match &self.units.first()?.engine {
            Engine::SingleView(engine) => Some(engine.assumptions().depth == Depth::Carried),
            Engine::StereoNoise(_) | Engine::StereoMatching(_) | Engine::TimeOfFlight(_) => None,
        }
    }

    /// For Isaac Sim's sensor, one sigma of its jitter as a share of the disparity of what is 1 m away.
    pub(super) fn jitter_times_depth(&self) -> Option<f64> {
        match &self.units.first()?.engine {
            Engine::SingleView(engine) => {
                let p = engine.parameters();
                let is_on = p.noise_mean_px > 0.0;
                Some(if is_on {
                    p.noise_sigma_px / self.disparity_times_depth()
                } else {
                    0.0
                })
            }
            Engine::StereoNoise(_) | Engine::StereoMatching(_) | Engine::TimeOfFlight(_) => None,
        }
    }

    fn measure_unit(
        &self,
        engine: &Engine,
        unit: &Unit,
        item: u32,
        scenery: &Scenery<'_>,
        part: &Part,
        effort: Effort,
    ) -> Result<Measured, ParameterError> {
        let width = self.intrinsics.size.width;
        let engine = of_part(engine, width, &part.intrinsics)?;
        let mut sensor = Sensor::new(engine, unit.filters.clone(), self.random);
        let images = scenery.captures(&mut sensor, unit, item, part, effort.captures);
        let (region, intrinsics) = part.in_image(images.first());
        let views: Vec<ImageView<'_, f32>> = images.iter().map(|image| (&image.0).into()).collect();
        let optics = Optics {
            intrinsics,
            disparity_times_depth: disparity_times_depth(sensor.engine(), part.intrinsics.size.width),
        };
        Ok(Measured {
            vendor: vendor(&views, &region),
            quality: if effort.quality {
                quality(&views, &region, &optics, scenery.distance_m)
            } else {
                Quality::default()
            },
        })
    }

    /// What of the image has a say in the region: that is rendered, and no more.
    fn part(&self, distance_m: f64) -> Part {
        let size = self.intrinsics.size;
        let is_filtered = self.units.iter().any(|unit| !unit.filters.is_empty());
        let around = self
            .units
            .iter()
            .map(|unit| around_px(&unit.engine))
            .max()
            .unwrap_or(0);
        let around = around + if is_filtered { AROUND_FILTERS_PX } else { AROUND_PX };
        let reach = |unit: &Unit| reach_px(&unit.engine, size.width, distance_m).abs();
        let reach = self
            .units
            .iter()
            .map(reach)
            .fold(0.0, f64::max)
            .min(f64::from(size.width));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the image"
        )]
        let sideways = around + reach.ceil() as u32;
        let is_whole = self
            .units
            .iter()
            .any(|unit| is_of_another_width(&unit.engine, size.width));
        let columns = if is_whole {
            0..size.width
        } else {
            grown(&self.region.columns, sideways, size.width)
        };
        let rows = grown(&self.region.rows, around, size.height);
        let top_left = PixelPoint::<OpenCv>::new(f64::from(columns.start), f64::from(rows.start));
        let within = |range: &Range<u32>, start: u32| range.start - start..range.end - start;
        Part {
            region: Region {
                columns: within(&self.region.columns, columns.start),
                rows: within(&self.region.rows, rows.start),
            },
            intrinsics: self.intrinsics.cropped(
                top_left,
                ImageSize::new(columns.end - columns.start, rows.end - rows.start),
            ),
        }
    }
}

/// What there is to see.
struct Scenery<'a> {
    distance_m: f64,
    /// What is rendered as depth with a picture.
    sight: Option<Sight>,
    /// The board, what is before it, and the light on their left camera.
    pair: Option<(Board, &'a Eyes, Image<f32>)>,
}

impl<'a> Scenery<'a> {
    fn new(stand: &'a Stand, part: &Part, distance_m: f64) -> Self {
        let pair = stand.eyes.as_ref().map(|eyes| {
            let board = Board::new(part.intrinsics, distance_m);
            let left = eyes.left(&board, part.intrinsics);
            (board, eyes, left)
        });
        let sight = match pair {
            Some(_) => None,
            None => board::look(part.intrinsics, distance_m),
        };
        Self {
            distance_m,
            sight,
            pair,
        }
    }

    /// So many captures of a unit.
    fn captures(&self, sensor: &mut Sensor, unit: &Unit, item: u32, part: &Part, count: u32) -> Vec<ZDepth> {
        let mut capture = |shot: &Shot<'_>, frame: u32| {
            let mut shot = *shot;
            (shot.frame, shot.item) = (frame.into(), item);
            sensor.capture(&shot, Wanted::default()).distance
        };
        if let Some((board, eyes, left)) = &self.pair {
            let right = eyes.right(board, part.intrinsics, unit.bias_px);
            // The measured depth has the size of the pair.
            let depth = Image::filled(1, 1, 0.0);
            let captures = (0..count).filter_map(|frame| {
                let [left, right] = eyes.record([left, &right], &part.intrinsics, (frame.into(), item));
                let pair = Pair::new(&left, &right).ok()?;
                Some(capture(&Shot::new((&depth).into()).with_pair(pair), frame))
            });
            return captures.collect();
        }
        let Some(sight) = &self.sight else {
            return Vec::new();
        };
        let shot = Shot::new((&sight.depth.0).into());
        let shot = shot.with_rgb((&sight.rgb).into()).unwrap_or(shot);
        (0..count).map(|frame| capture(&shot, frame)).collect()
    }
}

fn grown(range: &Range<u32>, by: u32, end: u32) -> Range<u32> {
    range.start.saturating_sub(by)..range.end.saturating_add(by).min(end)
}

/// A part of the depth image.
struct Part {
    intrinsics: Intrinsics,
    /// What is measured of it.
    region: Region,
}

impl Part {
    /// The region in what the sensor made of the part, which may be smaller: decimated.
    fn in_image(&self, image: Option<&ZDepth>) -> (Region, Intrinsics) {
        let own = self.intrinsics.size;
        let size = image.map_or(own, |image| ImageSize::new(image.0.width(), image.0.height()));
        if size == own {
            return (self.region.clone(), self.intrinsics);
        }
        let scaled = |range: &Range<u32>, to: u32, from: u32| {
            let at = |place: u32| u64::from(place) * u64::from(to) / u64::from(from.max(1));
            let narrow = |place: u64| u32::try_from(place).unwrap_or(u32::MAX);
            narrow(at(range.start))..narrow(at(range.end))
        };
        let region = Region {
            columns: scaled(&self.region.columns, size.width, own.width),
            rows: scaled(&self.region.rows, size.height, own.height),
        };
        (region, self.intrinsics.resized(size, false))
    }
}

/// How far a sample moves in an image, px.
fn reach_px(engine: &Engine, width: u32, distance_m: f64) -> f64 {
    match engine {
        Engine::SingleView(engine) => engine.parameters().disparity_times_depth(width) / distance_m,
        Engine::StereoNoise(engine) => {
            let p = engine.parameters();
            p.stereo.disparity(distance_m) * f64::from(width) / f64::from(p.width_px.max(1))
        }
        Engine::TimeOfFlight(_) => 0.0,
        Engine::StereoMatching(engine) => {
            let p = engine.parameters();
            p.stereo.disparity(distance_m) * f64::from(width) / f64::from(p.width_px.max(1))
        }
    }
}

/// How far around a pixel the engine looks, px.
fn around_px(engine: &Engine) -> u32 {
    match engine {
        Engine::SingleView(engine) => engine.parameters().outlier_removal_range_px,
        Engine::StereoNoise(engine) => {
            let p = engine.parameters();
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "saturates"
            )]
            let dilation = p.edge_dilation_px.ceil() as u32;
            dilation.saturating_add(p.window_px).min(1024)
        }
        // Those whose light a pixel sees, and those beside them for their normals.
        Engine::TimeOfFlight(_) => 2,
        Engine::StereoMatching(_) => PATHS_PX,
    }
}

/// Disparity times depth in the pixels that the engine counts disparity in, px·m.
fn disparity_times_depth(engine: &Engine, width: u32) -> f64 {
    match engine {
        Engine::SingleView(engine) => engine.parameters().disparity_times_depth(width).abs(),
        Engine::StereoNoise(engine) => engine.parameters().stereo.disparity(1.0),
        Engine::TimeOfFlight(_) => 0.0,
        Engine::StereoMatching(engine) => engine.parameters().stereo.disparity(1.0),
    }
}

/// Whether the matcher's images are not as wide as the depth image, so that a part of one is not whole pixels of the other.
fn is_of_another_width(engine: &Engine, width: u32) -> bool {
    match engine {
        Engine::SingleView(_) | Engine::TimeOfFlight(_) => false,
        Engine::StereoNoise(engine) => engine.parameters().width_px != width,
        Engine::StereoMatching(engine) => engine.parameters().width_px != width,
    }
}

/// The engine for a part of an image that leaves columns out: it counts the pixels of that part, of the same size each.
fn of_part(engine: &Engine, width: u32, part: &Intrinsics) -> Result<Engine, ParameterError> {
    let part_width = part.size.width;
    if let Engine::TimeOfFlight(engine) = engine {
        // Where it looks is where the part was rendered from.
        let centre = part.principal_point::<Usd>();
        let parameters = time_of_flight::Parameters {
            focal_length_px: part.fx,
            width_px: part_width,
            principal_point_px: Some([centre.x, centre.y]),
            ..*engine.parameters()
        };
        return Ok(Engine::TimeOfFlight(TimeOfFlight::new(parameters)?));
    }
    if width == part_width {
        return Ok(engine.clone());
    }
    Ok(match engine {
        Engine::SingleView(engine) => {
            let mut parameters = *engine.parameters();
            parameters.sensor_size_px *= f64::from(part_width) / f64::from(width);
            Engine::SingleView(SingleView::new(parameters, *engine.assumptions())?)
        }
        Engine::StereoNoise(engine) => {
            let mut parameters = *engine.parameters();
            parameters.width_px = part_width;
            Engine::StereoNoise(StereoNoise::new(parameters)?)
        }
        Engine::StereoMatching(engine) => {
            let mut parameters = *engine.parameters();
            parameters.kernel_mask = parameters.mask_at(width as usize);
            parameters.width_px = part_width;
            Engine::StereoMatching(StereoMatching::new(parameters)?)
        }
        Engine::TimeOfFlight(_) => engine.clone(),
    })
}

/// The same sensor with the other reading of what public sources leave open.
fn other_reading(engine: &Engine) -> Result<Option<Engine>, ParameterError> {
    let Engine::SingleView(engine) = engine else {
        return Ok(None);
    };
    let depth = match engine.assumptions().depth {
        Depth::Carried => Depth::Recomputed,
        Depth::Recomputed => Depth::Carried,
    };
    let assumptions = Assumptions {
        depth,
        ..*engine.assumptions()
    };
    let other = SingleView::new(*engine.parameters(), assumptions)?;
    Ok(Some(Engine::SingleView(other)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::Catalog;
    use oaktwin_pipeline::sensor::{EngineKind, SensorOptions, sensor};

    fn stand(model: &str, engine: EngineKind, parameters: &[(&str, &str)]) -> Stand {
        let catalog = Catalog::builtin();
        let twin = catalog.nominal(catalog.device(model).unwrap());
        let depth = twin.depth_sensors.last().unwrap();
        let options = SensorOptions {
            engine: Some(engine),
            parameters: parameters
                .iter()
                .map(|(a, b)| ((*a).to_owned(), (*b).to_owned()))
                .collect(),
            ..SensorOptions::default()
        };
        let (sensor, _) = sensor(&twin, depth, &options).unwrap();
        let intrinsics = twin.camera(depth.spec.camera).unwrap().intrinsics;
        Stand {
            intrinsics,
            region: Region::centred(intrinsics.size.width, intrinsics.size.height, 0.05),
            units: vec![Unit {
                engine: sensor.engine().clone(),
                filters: Chain::default(),
                bias_px: 0.0,
            }],
            random: Stream::new(0, ""),
            eyes: None,
        }
    }

    /// What a part of the image says is what the whole image says.
    #[test]
    fn a_part_is_enough() {
        let effort = Effort {
            captures: 3,
            quality: false,
        };
        for (model, engine, quiet) in [
            ("oak4-d", EngineKind::StereoNoise, ("jitter", "0")),
            ("oak-d-tof", EngineKind::SingleView, ("noiseSigma", "0")),
        ] {
            let stand = stand(model, engine, &[quiet]);
            for distance in [0.8, 1.31, 3.3] {
                let part = stand.part(distance);
                assert!(part.intrinsics.size.width < stand.intrinsics.size.width / 2);
                let whole = Part {
                    intrinsics: stand.intrinsics,
                    region: stand.region.clone(),
                };
                let [part, whole] = [part, whole].map(|part| {
                    let scenery = Scenery::new(&stand, &part, distance);
                    let unit = &stand.units[0];
                    let engines = [Some(unit.engine.clone()), other_reading(&unit.engine).unwrap()];
                    engines.map(|engine| {
                        engine.map(|engine| {
                            stand
                                .measure_unit(&engine, unit, 0, &scenery, &part, effort)
                                .unwrap()
                                .vendor
                        })
                    })
                });
                assert_eq!(part, whole, "{model} {distance}");
                assert!(part[0].unwrap().depth_m.is_some(), "{model} {distance}");
            }
        }
    }

    /// Noise, exposure and the far ends of paths are those of the whole image or of its part: the same but for them.
    #[test]
    fn a_strip_is_enough_to_match() {
        let mut stand = stand("oak4-d", EngineKind::StereoMatching, &[]);
        stand.eyes = Some(Eyes::new(0.075, 1.0, 0).unwrap());
        let effort = Effort {
            captures: 2,
            quality: false,
        };
        for disparity in [75.0, 46.15, 18.9, 18.35] {
            let distance = stand.disparity_times_depth() / disparity;
            let part = stand.part(distance);
            assert!(part.intrinsics.size.height < stand.intrinsics.size.height / 2);
            let whole = Part {
                intrinsics: stand.intrinsics,
                region: stand.region.clone(),
            };
            let [part, whole] = [part, whole].map(|part| {
                let scenery = Scenery::new(&stand, &part, distance);
                let unit = &stand.units[0];
                let measured = stand.measure_unit(&unit.engine, unit, 0, &scenery, &part, effort);
                stand.disparity_times_depth() / measured.unwrap().vendor.depth_m.unwrap()
            });
            assert!((part - whole).abs() < 0.15, "{distance} m: {part} {whole} px");
        }
    }
}
