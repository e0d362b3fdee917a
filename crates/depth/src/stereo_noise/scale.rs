//! The parameters in single precision and the pixels of one image.

use super::field::Numbers;
use super::parameters::{CLOSE_RANGE_M, Parameters};
use super::texture::{Light, TextureScale};
use super::window::MAX_SIDE;
use crate::DepthShot;

/// The parameters for images of one width, in image pixels where noted, else in matcher pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// Disparity times depth, px·m.
    pub(super) px_m: f32,
    /// Image pixels per matcher pixel.
    pub(super) image_px: f32,
    pub(super) bias: f32,
    pub(super) locking: f32,
    /// What [`Parameters::close_range_factor`] adds to a factor of 1.
    pub(super) close_change: f32,
    /// The disparity from which it changes, and the reciprocal of the range over which it does.
    pub(super) close_from: f32,
    pub(super) close_per_px: f32,
    /// The factor from a window's sum, less [`jitter_mean`](Self::jitter_mean), to its jitter.
    pub(super) jitter: f32,
    pub(super) jitter_mean: f32,
    /// The numbers in the window.
    pub(super) numbers: Numbers,
    pub(super) shift: f32,
    /// Steps per pixel.
    pub(super) steps: f32,
    /// The maximum value in steps.
    pub(super) max_fixed: u32,
    /// The side of the matching window, image px.
    pub(super) window: usize,
    /// The widening of near objects on every side, image px.
    pub(super) dilation: usize,
    /// The invalid columns on the left, image px.
    pub(super) invalid_edge: usize,
    /// Pixels whose 16 random bits are below this are dropped.
    pub(super) dropout: u32,
    /// How confidence is measured.
    pub(super) texture: TextureScale,
    /// The light that changes the texture.
    pub(super) light: Option<Light>,
}

impl Scale {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "checked parameters; rows are single precision"
    )]
    pub(super) fn new(p: &Parameters, shot: &DepthShot<'_>) -> Self {
        let image_width = shot.depth().width();
        let image_px = f64::from(image_width) / f64::from(p.width_px);
        let window = ((f64::from(p.window_px) * image_px).round() as usize).clamp(1, MAX_SIDE);
        let texture = TextureScale::new(p.window_px, window, image_px, shot.color_step);
        let numbers = Numbers::under(window);
        let count = (window * window) as f64;
        let [full, none] = CLOSE_RANGE_M.map(|z| p.stereo.disparity(z));
        Self {
            px_m: (p.stereo.focal_length_px * p.stereo.baseline_m) as f32,
            image_px: image_px as f32,
            bias: p.bias_px as f32,
            locking: p.pixel_locking_px as f32,
            close_change: (p.close_range_factor - 1.0) as f32,
            close_from: none as f32,
            close_per_px: (full - none).recip() as f32,
            jitter: (p.jitter_px / (count * numbers.variance()).sqrt()) as f32,
            jitter_mean: (count * numbers.mean()) as f32,
            numbers,
            shift: p.disparity_shift_px as f32,
            steps: (1u32 << p.subpixel.bits()) as f32,
            max_fixed: p.max_fixed_disparity(),
            window,
            dilation: ((p.edge_dilation_px * image_px).round() as usize).min(MAX_SIDE / 2),
            invalid_edge: (f64::from(p.invalid_edge_px) * image_px).round() as usize,
            dropout: (p.dropout * 65536.0).round() as u32,
            texture,
            light: Light::new(p, &texture),
        }
    }
}
