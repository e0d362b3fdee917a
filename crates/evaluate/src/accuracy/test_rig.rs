//! The test rig: a flat board at a distance, and cameras that face its centre.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint};
use oaktwin_depth::DriftedPair;
use oaktwin_depth::filter::Chain;
use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, Depth, SingleView};
use oaktwin_depth::stereo_matching::{RectifiedPair, RectifiedPairError};
use oaktwin_image::{Image, ImageView, ZDepth};
use oaktwin_pipeline::sensor::{DepthShot, Engine, Input, ParameterError, Sensor};
use rayon::prelude::*;

use super::AccuracyError;
use super::board::{self, Board};
use super::stereo_camera::StereoCamera;
use crate::measure::{ImageRegion, Optics, Quality, Vendor, quality, vendor};

/// The margin around the measured region in which textures affect it, besides windows and neighbourhoods, px.
const AROUND_PX: u32 = 4;
/// The margin with filters. Some of them propagate values along whole rows, halving their weight at each pixel.
const AROUND_FILTERS_PX: u32 = 72;

/// Units of one camera model that are measured one after the other.
#[derive(Debug)]
pub(super) struct TestRig {
    /// The intrinsics of the whole depth image.
    pub(super) intrinsics: Intrinsics,
    /// The measured region of the depth image.
    pub(super) region: ImageRegion,
    pub(super) units: Vec<Unit>,
    /// The number of the first unit, which distinguishes their noise.
    pub(super) first: u32,
    /// The noise, which differs between units.
    pub(super) random: Stream,
    /// The stereo cameras, for engines that match pairs.
    pub(super) stereo_camera: Option<StereoCamera>,
    /// The picture of the board in the rows around the region, which is the same at every distance; see [`TestRig::prepare`].
    pub(super) picture: OnceLock<Option<Image<[u8; 4]>>>,
}

/// One unit of the camera.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub(super) engine: Arc<dyn Engine>,
    pub(super) filters: Chain,
    /// The drift of the pair, for engines that measure depth images.
    pub(super) drifted: Option<DriftedPair>,
    /// The calibration error of a pair that is matched, px of the whole image; other engines have it as a parameter.
    pub(super) bias_px: f64,
}

impl PartialEq for Unit {
    fn eq(&self, other: &Self) -> bool {
        *self.engine == *other.engine
            && self.filters == other.filters
            && self.drifted == other.drifted
            && self.bias_px.to_bits() == other.bias_px.to_bits()
    }
}

/// The measurements of one engine at one distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured {
    pub(super) vendor: Vendor,
    /// Empty unless requested.
    pub(super) quality: Quality,
}

/// The extent of a measurement.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    pub(super) captures: u32,
    /// Whether [`Measured::quality`] is requested.
    pub(super) quality: bool,
}

/// A measurement that may be interrupted.
#[derive(Clone, Copy)]
pub(super) struct RunControl<'a> {
    pub(super) effort: Effort,
    pub(super) wants_more: &'a (dyn Fn() -> bool + Sync),
}

impl RunControl<'_> {
    fn check(&self) -> Result<(), AccuracyError> {
        match (self.wants_more)() {
            true => Ok(()),
            false => Err(AccuracyError::Interrupted),
        }
    }
}

/// The measurements of one unit, and for Isaac Sim's sensor those under its other documented reading: depth computed from
/// disparity, or carried along.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeasuredUnit {
    pub(super) own: Measured,
    pub(super) other: Option<Measured>,
}

impl TestRig {
    /// Measures every unit at the given distance, after [`TestRig::prepare`].
    pub(super) fn measure(
        &self,
        distance_m: f64,
        work: RunControl<'_>,
    ) -> Result<Vec<MeasuredUnit>, AccuracyError> {
        let part = self.part(distance_m);
        let scenery = Scenery::new(self, &part, distance_m);
        let measure = |(unit, item): (&Unit, u32)| {
            work.check()?;
            let measure =
                |engine: &Arc<dyn Engine>| self.measure_unit(engine, unit, item, &scenery, &part, work);
            Ok(MeasuredUnit {
                own: measure(&unit.engine)?,
                other: other_reading(&unit.engine)?.as_ref().map(measure).transpose()?,
            })
        };
        let numbered: Vec<(&Unit, u32)> = self.units.iter().zip(self.first..).collect();
        numbered.into_par_iter().map(measure).collect()
    }

    fn engine(&self) -> Option<&dyn Engine> {
        self.units.first().map(|unit| &*unit.engine)
    }

    /// Returns disparity times depth in the pixels in which the engine counts disparity, px·m.
    pub(super) fn disparity_times_depth(&self) -> f64 {
        let width = self.intrinsics.size.width;
        self.engine()
            .map_or(0.0, |engine| engine.disparity_times_depth(width))
    }

    /// Returns the minimum measurable distance in metres.
    pub(super) fn nearest_m(&self) -> f64 {
        let width = self.intrinsics.size.width;
        self.engine().map_or(0.0, |engine| engine.nearest_m(width))
    }

    /// Whether Isaac Sim's sensor carries the rendered depth along; `None` for other engines.
    pub(super) fn carries_depth(&self) -> Option<bool> {
        let engine = self.engine()?.downcast_ref::<SingleView>()?;
        Some(engine.assumptions().depth == Depth::Carried)
    }

    /// Returns one sigma of the jitter of Isaac Sim's sensor as a share of the disparity at 1 m; `None` for other engines.
    pub(super) fn jitter_times_depth(&self) -> Option<f64> {
        let p = self.engine()?.downcast_ref::<SingleView>()?.parameters();
        let is_on = p.noise_mean_px > 0.0;
        Some(if is_on {
            p.noise_sigma_px / self.disparity_times_depth()
        } else {
            0.0
        })
    }

    fn measure_unit(
        &self,
        engine: &Arc<dyn Engine>,
        unit: &Unit,
        item: u32,
        scenery: &Scenery<'_>,
        part: &Part,
        work: RunControl<'_>,
    ) -> Result<Measured, AccuracyError> {
        let cropped = engine.crop(self.intrinsics.size.width, &part.intrinsics)?;
        let engine = cropped.unwrap_or_else(|| Arc::clone(engine));
        let drifted = unit.drifted.map(|pair| DriftedPair {
            intrinsics: part.intrinsics,
            ..pair
        });
        let sensor = Sensor::new(engine, unit.filters.clone(), self.random);
        let mut sensor = sensor.with_drift(drifted);
        let images = scenery.captures(&mut sensor, unit, item, part, work)?;
        let (region, intrinsics) = part.in_image(images.first());
        let views: Vec<ImageView<'_, f32>> = images.iter().map(|image| (&image.0).into()).collect();
        let optics = Optics {
            intrinsics,
            disparity_times_depth: sensor.engine().disparity_times_depth(part.intrinsics.size.width),
        };
        Ok(Measured {
            vendor: vendor(&views, &region),
            quality: if work.effort.quality {
                quality(&views, &region, &optics, scenery.distance_m)
            } else {
                Quality::default()
            },
        })
    }

    /// Returns the part of the image that affects the region. Only this part is rendered.
    fn part(&self, distance_m: f64) -> Part {
        let size = self.intrinsics.size;
        let is_filtered = self.units.iter().any(|unit| !unit.filters.is_empty());
        let engines = || self.units.iter().map(|unit| &unit.engine);
        let around = engines().map(|engine| engine.support_px()).max().unwrap_or(0);
        let margin = if is_filtered { AROUND_FILTERS_PX } else { AROUND_PX };
        let around = around.saturating_add(margin);
        let rows = grown(&self.region.rows, around, size.height);
        let reach = engines()
            .map(|engine| engine.reach_px(size.width, distance_m).abs())
            .fold(0.0, f64::max)
            .min(f64::from(size.width));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the image"
        )]
        let sideways = around.saturating_add(reach.ceil() as u32);
        let columns = if engines().any(|engine| engine.needs_full_width(size.width)) {
            0..size.width
        } else {
            grown(&self.region.columns, sideways, size.width)
        };
        let within = |range: &Range<u32>, start: u32| range.start - start..range.end - start;
        Part {
            region: ImageRegion {
                columns: within(&self.region.columns, columns.start),
                rows: within(&self.region.rows, rows.start),
            },
            intrinsics: cropped(&self.intrinsics, &columns, &rows),
            columns,
            rows,
        }
    }

    /// Renders the picture of the board, if the engine needs it. Workers would wait for each other: a worker that renders it may take up
    /// another distance meanwhile, which needs it too.
    pub(super) fn prepare(&self, distance_m: f64) {
        self.prepare_rows(&self.part(distance_m).rows);
    }

    fn prepare_rows(&self, rows: &Range<u32>) {
        if self.stereo_camera.is_none() && self.picture.get().is_none() {
            let whole = 0..self.intrinsics.size.width;
            let picture = board::picture(cropped(&self.intrinsics, &whole, rows));
            let _ = self.picture.set(picture);
        }
    }

    /// Returns the picture of the board in a part of the image.
    fn picture(&self, part: &Part) -> Option<Image<[u8; 4]>> {
        let picture = self.picture.get()?.as_ref()?;
        let columns = part.columns.start as usize..part.columns.end as usize;
        let rows = picture.rows().filter_map(|row| row.get(columns.clone()));
        let size = part.intrinsics.size;
        Image::new(size.width, size.height, rows.flatten().copied().collect())
    }
}

fn cropped(intrinsics: &Intrinsics, columns: &Range<u32>, rows: &Range<u32>) -> Intrinsics {
    let top_left = PixelPoint::<OpenCv>::new(f64::from(columns.start), f64::from(rows.start));
    let size = ImageSize::new(columns.end - columns.start, rows.end - rows.start);
    intrinsics.cropped(top_left, size)
}

/// The scene in front of the cameras.
struct Scenery<'a> {
    distance_m: f64,
    /// The depth and the picture of the board, for engines that require depth.
    sight: Option<(Image<f32>, Image<[u8; 4]>)>,
    /// The board, the cameras, and the light on the left one, for engines that require pairs.
    pair: Option<(Board, &'a StereoCamera, Image<f32>)>,
}

impl<'a> Scenery<'a> {
    fn new(rig: &'a TestRig, part: &Part, distance_m: f64) -> Self {
        let pair = rig.stereo_camera.as_ref().map(|stereo_camera| {
            let board = Board::new(part.intrinsics, distance_m);
            let left = stereo_camera.left(&board, part.intrinsics);
            (board, stereo_camera, left)
        });
        let size = part.intrinsics.size;
        #[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
        let depth = || Image::filled(size.width, size.height, distance_m as f32);
        let sight = match pair {
            Some(_) => None,
            None => rig.picture(part).map(|picture| (depth(), picture)),
        };
        Self {
            distance_m,
            sight,
            pair,
        }
    }

    /// Captures a unit several times.
    fn captures(
        &self,
        sensor: &mut Sensor,
        unit: &Unit,
        item: u32,
        part: &Part,
        work: RunControl<'_>,
    ) -> Result<Vec<ZDepth>, AccuracyError> {
        let count = work.effort.captures;
        if let Some((board, stereo_camera, left)) = &self.pair {
            let right = stereo_camera.right(board, part.intrinsics, unit.bias_px);
            let captures = (0..count).map(|frame| {
                work.check()?;
                let [left, right] =
                    stereo_camera.record([left, &right], &part.intrinsics, (frame.into(), item));
                let pair = RectifiedPair::new(&left, &right).map_err(region_error)?;
                Ok(sensor.capture(Input::Pair(pair), &[])?.distance)
            });
            return captures.collect();
        }
        let Some((depth, picture)) = &self.sight else {
            return Ok(Vec::new());
        };
        let shot = DepthShot::new(depth.into());
        let mut shot = shot.with_rgb(picture.into()).unwrap_or(shot);
        let captures = (0..count).map(|frame| {
            work.check()?;
            (shot.frame, shot.item) = (frame.into(), item);
            Ok(sensor.capture(shot, &[])?.distance)
        });
        captures.collect()
    }
}

/// Converts the error of a rendered pair that cannot be matched.
fn region_error(error: RectifiedPairError) -> ParameterError {
    ParameterError {
        name: "region".to_owned(),
        what: error.what,
        remedy: error.remedy.to_owned(),
    }
}

fn grown(range: &Range<u32>, by: u32, end: u32) -> Range<u32> {
    range.start.saturating_sub(by)..range.end.saturating_add(by).min(end)
}

/// A part of the depth image.
struct Part {
    intrinsics: Intrinsics,
    /// The columns and rows of the whole image.
    columns: Range<u32>,
    rows: Range<u32>,
    /// The measured region of the part.
    region: ImageRegion,
}

impl Part {
    /// Returns the region and the intrinsics in the sensor's output image, which filters may have decimated.
    fn in_image(&self, image: Option<&ZDepth>) -> (ImageRegion, Intrinsics) {
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
        let region = ImageRegion {
            columns: scaled(&self.region.columns, size.width, own.width),
            rows: scaled(&self.region.rows, size.height, own.height),
        };
        (region, self.intrinsics.resized(size, false))
    }
}

/// Returns Isaac Sim's sensor with the other reading of how its reported depth is computed, which public sources leave
/// open; `None` for other engines.
fn other_reading(engine: &Arc<dyn Engine>) -> Result<Option<Arc<dyn Engine>>, ParameterError> {
    let Some(engine) = engine.downcast_ref::<SingleView>() else {
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
    Ok(Some(Arc::new(SingleView::new(
        *engine.parameters(),
        assumptions,
    )?)))
}

#[cfg(test)]
mod tests;
