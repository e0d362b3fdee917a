//! The confidence of each pixel as an image.

use oaktwin_image::Image;
use oaktwin_simd::Level;
use rayon::prelude::*;

use super::scale::Scale;
use super::sense::BAND;
use super::texture::{self, Texture};
use super::{DepthShot, Parameters};

/// The memory of one thread.
#[derive(Default)]
struct Scratch {
    texture: Texture,
    sums: Vec<u32>,
}

/// Returns the confidence that [`Parameters::confidence_threshold`] is compared with, 0 to 255, also of pixels that are lost for
/// another reason; `None` without a colour image.
pub(super) fn confidence(parameters: &Parameters, shot: &DepthShot<'_>) -> Option<Image<u16>> {
    let (picture, depth) = (shot.rgb()?, shot.depth());
    let mut levels = Image::filled(picture.width(), picture.height(), 0);
    let scale = Scale::new(parameters, shot);
    let texture_scale = &scale.texture;
    let side = texture_scale.side;
    let width = (picture.width() as usize).max(1);
    let level = Level::detect();
    levels
        .pixels_mut()
        .par_chunks_mut(BAND * width)
        .enumerate()
        .for_each_init(Scratch::default, |s, (index, band)| {
            let first = index * BAND;
            s.texture.reset(width, texture_scale);
            s.sums.resize(width, 0);
            for row in first..first + side - 1 {
                s.texture.slide(level, &picture, row, texture_scale, &mut []);
            }
            for (y, out) in (first..).zip(band.chunks_exact_mut(width)) {
                s.texture
                    .slide(level, &picture, y + side - 1, texture_scale, &mut s.sums);
                texture::light(level, scale.light.as_ref(), &picture, &depth, y, &mut s.sums);
                for (out, sum) in out.iter_mut().zip(&s.sums) {
                    *out = texture_scale.confidence(*sum);
                }
            }
        });
    Some(levels)
}
