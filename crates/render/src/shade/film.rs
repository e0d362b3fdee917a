//! The response of the film to light.

use glam::Vec3;
use oaktwin_image::Image;
use rayon::prelude::*;

use super::tone::{Encoder, tone, untoned};
use crate::Visibility;

/// The response curve of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Film {
    /// The tone curve, for people.
    Tones,
    /// Linear, for sensors.
    Linear,
}

impl Film {
    /// Applies the response curve to exposed radiance.
    #[inline]
    pub(super) fn exposed(self, radiance: Vec3) -> Vec3 {
        match self {
            Self::Tones => toned(radiance),
            // NaN becomes 0.
            Self::Linear => radiance.max(Vec3::ZERO),
        }
    }

    /// Returns the tone-mapped sRGB of a value on film.
    #[inline]
    pub(super) fn srgb(self, color: Vec3, encoder: Encoder) -> [u8; 3] {
        let color = match self {
            Self::Tones => color,
            Self::Linear => toned(color),
        };
        [
            encoder.srgb(color.x),
            encoder.srgb(color.y),
            encoder.srgb(color.z),
        ]
    }
}

fn toned(radiance: Vec3) -> Vec3 {
    Vec3::new(tone(radiance.x), tone(radiance.y), tone(radiance.z))
}

/// Returns the sRGB of exposed light, with the coverage of each pixel, 0 to 1.
pub(crate) fn print(light: &Image<[f32; 4]>) -> Image<[u8; 4]> {
    let encoder = Encoder::new();
    light.map(|[r, g, b, coverage]| {
        let [r, g, b] = Film::Linear.srgb(Vec3::new(*r, *g, *b), encoder);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the cast saturates"
        )]
        [r, g, b, (coverage * 255.0).round() as u8]
    })
}

/// Returns the light of colours that [`Film::Tones`] has, with coverage: 1, or 0 for a miss.
pub(super) fn light(colors: &Image<[f32; 3]>, seen: &Visibility) -> Image<[f32; 4]> {
    let mut light = colors.map(|color| {
        let [r, g, b] = color.map(untoned);
        [r, g, b, 1.0]
    });
    for (pixel, hit) in light.pixels_mut().iter_mut().zip(seen.hits.pixels()) {
        if hit.is_miss() {
            pixel[3] = 0.0;
        }
    }
    light
}

/// Writes sRGB with coverage: 255, or 0 for a miss.
pub(super) fn develop(film: Film, colors: &Image<[f32; 3]>, seen: &Visibility, rgb: &mut Image<[u8; 4]>) {
    let encoder = Encoder::new();
    rgb.pixels_mut()
        .par_iter_mut()
        .with_min_len(4096)
        .zip(colors.pixels())
        .zip(seen.hits.pixels())
        .for_each(|((pixel, color), hit)| {
            let [r, g, b] = film.srgb(Vec3::from(*color), encoder);
            *pixel = [r, g, b, if hit.is_miss() { 0 } else { 255 }];
        });
}
