use oaktwin_image::{Image, ImageView, ZDepth};
use rayon::prelude::*;

use super::SingleView;
use super::parameters::OutputMode;
use super::plan::Plan;
use super::tile::{self, Planes, Rows, Scratch};
use crate::random::Stream;
use crate::{BatchError, Shot};

/// Which outputs to make beside the distance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// `DepthSensorPointCloudPosition`, where the shot has positions.
    pub positions: bool,
    /// `DepthSensorPointCloudColor`, where the shot has a picture.
    pub colors: bool,
    /// `DepthSensorImager`, where the shot has a picture.
    pub imager: bool,
    /// The picture of the parameters' [`OutputMode`](super::OutputMode); that of mode 0 where the shot has a picture.
    pub view: bool,
}

/// What the sensor reports. All images have the shot's size.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// `DepthSensorDistance`: metres, 0 where nothing was measured.
    pub distance: ZDepth,
    /// `DepthSensorPointCloudPosition`: the point that was moved there; where nothing was measured what
    /// [`Invalid`](super::Invalid) says, by default 0.
    pub positions: Option<Image<[f32; 4]>>,
    /// `DepthSensorPointCloudColor`: the colour that was moved there; where nothing was measured as in `positions`.
    pub colors: Option<Image<[u8; 4]>>,
    /// `DepthSensorImager`: luma of the picture, which nothing moved, 0 to 1.
    pub imager: Option<Image<f32>>,
    /// The picture of the parameters' [`OutputMode`](super::OutputMode), sRGB.
    pub view: Option<Image<[u8; 4]>>,
}

impl Output {
    /// What `showDistance` shows: the distance at the middle pixel, m, 0 where nothing was measured; `None` of an image
    /// without pixels.
    #[must_use]
    pub fn center_m(&self) -> Option<f32> {
        let image = &self.distance.0;
        image.get(image.width() / 2, image.height() / 2).copied()
    }
}

/// Rows of a tile: enough that the rows around it, which are computed again, are few.
const TILE_ROWS: std::ops::RangeInclusive<usize> = 32..=128;

pub(super) fn sense(sensor: &SingleView, shot: &Shot<'_>, random: &Stream, wanted: Wanted) -> Output {
    let (width, height) = (shot.depth().width(), shot.depth().height());
    let (has_rgb, mode) = (shot.rgb().is_some(), sensor.parameters().rgb_depth_output_mode);
    let has_view = wanted.view && (has_rgb || mode != OutputMode::Color);
    let mut output = Output {
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
    };
    let plan = Plan::new(sensor.parameters(), sensor.assumptions(), width, height);
    if plan.width == 0 || plan.height == 0 {
        return output;
    }
    let random = Planes::new(random, shot);
    let tiles = plan.height.div_ceil(4 * rayon::current_num_threads());
    let rows = tiles.clamp(*TILE_ROWS.start(), *TILE_ROWS.end());
    let mut parts = Rows::of(&mut output, &plan, rows);
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

#[expect(clippy::cast_possible_truncation, reason = "items are numbered modulo 2³²")]
pub(super) fn batch(
    sensor: &SingleView,
    depth: &[f32],
    shape: [usize; 3],
    [frame, first_item]: [u64; 2],
    random: &Stream,
    out: &mut [f32],
) -> Result<(), BatchError> {
    let [count, height, width] = shape;
    let pixels = height.saturating_mul(width);
    for (what, length) in [("depth", depth.len()), ("result", out.len())] {
        if pixels.checked_mul(count) != Some(length) {
            return Err(BatchError { what, shape, length });
        }
    }
    // An image with pixels is not longer than its array.
    let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
    let Some((columns, rows)) = size.filter(|_| pixels > 0) else {
        return Ok(());
    };
    let plan = Plan::new(sensor.parameters(), sensor.assumptions(), columns, rows);
    let items = depth
        .par_chunks_exact(pixels)
        .zip(out.par_chunks_exact_mut(pixels));
    items
        .enumerate()
        .with_min_len(8)
        .for_each_init(Scratch::default, |scratch, (i, (depth, out))| {
            let Some(view) = ImageView::new(columns, rows, depth) else {
                return;
            };
            let mut shot = Shot::new(view);
            shot.frame = frame;
            shot.item = (first_item as u32).wrapping_add(i as u32);
            let random = Planes::new(random, &shot);
            let height = *TILE_ROWS.end();
            for (k, distance) in out.chunks_mut(height * width).enumerate() {
                let mut rows = Rows {
                    first: k * height,
                    distance,
                    positions: None,
                    colors: None,
                    imager: None,
                    view: None,
                };
                tile::sense(&plan, &shot, &random, OutputMode::Color, &mut rows, scratch);
            }
        });
    Ok(())
}
