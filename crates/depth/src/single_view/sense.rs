use oaktwin_image::{Image, ZDepth};
use rayon::prelude::*;

use super::OutputMode;
use super::SingleView;
use super::output::{SingleViewOutput, Wanted};
use super::plan::SingleViewPlan;
use super::rows::Rows;
use super::tile::{self, Planes, Scratch};
use crate::batch::{Batch, check_length};
use crate::random::Stream;
use crate::reason::ReasonCodes;
use crate::{BatchError, DepthShot};

/// The rows of a tile: many, since the rows around it are computed again.
const TILE_ROWS: std::ops::RangeInclusive<usize> = 32..=128;
/// The images of a batch that a thread takes at once; if there are fewer, the threads share each image.
const IMAGES_A_THREAD: usize = 8;

pub(super) fn sense(
    sensor: &SingleView,
    shot: &DepthShot<'_>,
    random: &Stream,
    wanted: Wanted,
) -> SingleViewOutput {
    let (width, height) = (shot.depth().width(), shot.depth().height());
    let (has_rgb, mode) = (shot.rgb().is_some(), sensor.parameters().rgb_depth_output_mode);
    let has_view = wanted.view && (has_rgb || mode != OutputMode::Color);
    let mut output = SingleViewOutput {
        distance: ZDepth(Image::filled(width, height, 0.0)),
        positions: image(
            wanted.positions && shot.positions().is_some(),
            width,
            height,
            [0.0; 4],
        ),
        colors: image(wanted.colors && has_rgb, width, height, [0; 4]),
        imager: image(wanted.imager && has_rgb, width, height, 0.0),
        view: image(has_view, width, height, [0; 4]),
        reasons: image(wanted.reasons, width, height, 0).map(ReasonCodes),
        confidence: image(wanted.confidence && has_rgb, width, height, 0),
    };
    let plan = SingleViewPlan::new(sensor.parameters(), sensor.assumptions(), width, height);
    if plan.width == 0 || plan.height == 0 {
        return output;
    }
    let random = Planes::new(random, shot);
    let mut parts = Rows::of(&mut output, &plan, tile_rows(plan.height));
    let work = |scratch: &mut Scratch, rows: &mut Rows<'_>| {
        tile::sense(&plan, shot, &random, mode, rows, scratch);
    };
    if parts.len() == 1 {
        work(&mut Scratch::default(), &mut parts[0]);
    } else {
        parts.par_iter_mut().for_each_init(Scratch::default, work);
    }
    output
}

fn image<T: Clone>(is_wanted: bool, width: u32, height: u32, value: T) -> Option<Image<T>> {
    is_wanted.then(|| Image::filled(width, height, value))
}

pub(super) fn batch(
    sensor: &SingleView,
    batch: &Batch<'_>,
    random: &Stream,
    out: &mut [f32],
) -> Result<(), BatchError> {
    let [count, height, width] = batch.shape();
    check_length("result", batch.shape(), out.len())?;
    let Some([columns, lines]) = batch.size() else {
        return Ok(());
    };
    let plan = SingleViewPlan::new(sensor.parameters(), sensor.assumptions(), columns, lines);
    let sense = |scratch: &mut Scratch, i: usize, (first, distance): (usize, &mut [f32])| {
        let Some(shot) = batch.shot(i) else { return };
        let mut rows = Rows {
            first,
            distance,
            positions: None,
            colors: None,
            imager: None,
            view: None,
            reasons: None,
            confidence: None,
        };
        let random = Planes::new(random, &shot);
        tile::sense(&plan, &shot, &random, OutputMode::Color, &mut rows, scratch);
    };
    if count < IMAGES_A_THREAD * rayon::current_num_threads() {
        let rows = tile_rows(height);
        for (i, image) in out.chunks_exact_mut(batch.pixels()).enumerate() {
            let tiles = image.par_chunks_mut(rows * width).enumerate();
            tiles.for_each_init(Scratch::default, |scratch, (k, tile)| {
                sense(scratch, i, (k * rows, tile));
            });
        }
    } else {
        let rows = *TILE_ROWS.end();
        let images = out
            .par_chunks_exact_mut(batch.pixels())
            .enumerate()
            .with_min_len(IMAGES_A_THREAD);
        images.for_each_init(Scratch::default, |scratch, (i, image)| {
            for (k, tile) in image.chunks_mut(rows * width).enumerate() {
                sense(scratch, i, (k * rows, tile));
            }
        });
    }
    Ok(())
}

/// Returns the rows of a tile: some tiles per thread.
fn tile_rows(height: usize) -> usize {
    let rows = height.div_ceil(4 * rayon::current_num_threads());
    rows.clamp(*TILE_ROWS.start(), *TILE_ROWS.end())
}
