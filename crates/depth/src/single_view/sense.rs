use oaktwin_image::{Image, ZDepth};

use super::SingleView;
use super::assumptions::Depth;
use crate::Shot;
use crate::random::{Stage, Stream, standard_normal};

/// Which outputs to make.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// `DepthSensorPointCloudPosition`, where the shot has positions.
    pub positions: bool,
}

/// What the sensor reports. All images have the shot's size.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// `DepthSensorDistance`: metres, 0 where nothing was measured.
    pub distance: ZDepth,
    /// `DepthSensorPointCloudPosition`: the point that was moved there, 0 where nothing was measured.
    pub positions: Option<Image<[f32; 4]>>,
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
    }
}
