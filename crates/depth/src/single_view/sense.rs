use oaktwin_image::{Image, ImageView, ZDepth};

use super::SingleView;
use super::assumptions::Depth;
use crate::random::{Stage, Stream, standard_normal};
use crate::{BatchError, Shot};

/// Which outputs to make.
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
    /// `DepthSensorPointCloudPosition`: the point that was moved there, 0 where nothing was measured.
    pub positions: Option<Image<[f32; 4]>>,
    /// `DepthSensorPointCloudColor`: the colour that was moved there, 0 where nothing was measured.
    pub colors: Option<Image<[u8; 4]>>,
    /// `DepthSensorImager`: luma of the picture, 0 to 1.
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

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "columns of an image"
)]
pub(super) fn sense(sensor: &SingleView, shot: &Shot<'_>, random: &Stream, wanted: Wanted) -> Output {
    let (p, depth) = (sensor.parameters(), shot.depth());
    let (width, height) = (depth.width(), depth.height());
    let bf = p.disparity_times_depth(width);
    let jitter = random.plane(Stage::Jitter, shot.frame, shot.item);
    let mut distance = Image::filled(width, height, 0.0f32);
    let positions = shot.positions().filter(|_| wanted.positions);
    let mut moved = positions.map(|_| Image::filled(width, height, [0.0f32; 4]));
    for (y, row) in depth.rows().enumerate() {
        let start = y * width as usize;
        for (x, &z) in row.iter().enumerate() {
            let z64 = f64::from(z);
            if !(z64 >= p.min_distance_m && z64 <= p.max_distance_m && z64 > 0.0) {
                continue;
            }
            let mut d = bf / z64;
            if d.abs() > p.max_disparity_px {
                continue;
            }
            if p.noise_mean_px > 0.0 {
                let patch = |at: usize| (at as f64 / p.noise_downscale_factor_px) as u32;
                let [a, b, ..] = jitter.words(patch(x), patch(y));
                let q = p.noise_mean_px;
                d = q * (d / q).round() + p.noise_sigma_px * standard_normal(a, b)[0];
            }
            let target = (x as f64 + d).round();
            if target < 0.0 || target >= f64::from(width) {
                continue;
            }
            let reported = match sensor.assumptions().depth {
                Depth::Carried => z,
                Depth::Recomputed if d * bf > 0.0 => (bf / d) as f32,
                Depth::Recomputed => continue,
            };
            let target = start + target as usize;
            let place = &mut distance.pixels_mut()[target];
            if *place == 0.0 || reported < *place {
                *place = reported;
                if let (Some(moved), Some(positions)) = (&mut moved, positions) {
                    moved.pixels_mut()[target] = positions.pixels()[start + x];
                }
            }
        }
    }
    Output {
        distance: ZDepth(distance),
        positions: moved,
        colors: None,
        imager: None,
        view: None,
    }
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
    if pixels == 0 {
        return Ok(());
    }
    for (i, (depth, out)) in depth
        .chunks_exact(pixels)
        .zip(out.chunks_exact_mut(pixels))
        .enumerate()
    {
        let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
        let Some(view) = size.and_then(|(width, height)| ImageView::new(width, height, depth)) else {
            continue;
        };
        let mut shot = Shot::new(view);
        shot.frame = frame;
        shot.item = (first_item as u32).wrapping_add(i as u32);
        out.copy_from_slice(
            sense(sensor, &shot, random, Wanted::default())
                .distance
                .0
                .pixels(),
        );
    }
    Ok(())
}
