//! Smooth outlines.

use glam::Vec3;
use oaktwin_image::Image;
use rayon::prelude::*;

use super::Studio;
use super::tone::Encoder;
use crate::annotate::SurfaceFinder;
use crate::ray::{Ray, Stack};
use crate::rays::Rays;
use crate::{Hit, Visibility};

/// Where a pixel at an outline is looked at, from its centre: each in a row and a column of its own.
const PLACES: [[f64; 2]; 4] = [[-0.125, -0.375], [0.375, -0.125], [-0.375, 0.125], [0.125, 0.375]];

/// The least difference from a neighbour, of 255, that is worth smoothing.
const LEAST_CONTRAST: u8 = 12;

/// The least bend of 1/z over three pixels that is an edge, as a share of 1/z.
const LEAST_BEND: f32 = 1e-3;

/// Looks again, four times, at pixels where one thing ends and another begins: their colour is the mean of what is there.
pub(super) fn smooth(studio: &Studio<'_>, rays: &Rays<'_>, seen: &Visibility, rgb: &mut Image<[u8; 4]>) {
    let places: Vec<[u32; 2]> = outlines(seen, rgb);
    let encoder = Encoder::new();
    let looked: Vec<[u8; 4]> = places
        .par_iter()
        .with_min_len(64)
        .map_init(
            || (SurfaceFinder::new(studio.scene, studio.view), Stack::new()),
            |(finder, stack), [x, y]| {
                let mut sum = Vec3::ZERO;
                let mut coverage = 0u16;
                for [dx, dy] in PLACES {
                    let at = [f64::from(*x) + 0.5 + dx, f64::from(*y) + 0.5 + dy];
                    let (color, covered) = look(studio, rays, [*x, *y], at, finder, stack);
                    sum += color;
                    coverage += u16::from(covered);
                }
                let [r, g, b] = (sum / 4.0).to_array().map(|value| encoder.srgb(value));
                [r, g, b, if coverage > 0 { 255 } else { 0 }]
            },
        )
        .collect();
    let width = rgb.width() as usize;
    for ([x, y], color) in places.into_iter().zip(looked) {
        if let Some(pixel) = rgb.pixels_mut().get_mut(y as usize * width + x as usize) {
            // Coverage says what the pixel's centre sees, as all other annotations do.
            *pixel = [color[0], color[1], color[2], pixel[3]];
        }
    }
}

fn look<'a>(
    studio: &'a Studio<'_>,
    rays: &Rays<'_>,
    pixel: [u32; 2],
    at: [f64; 2],
    finder: &mut SurfaceFinder<'a>,
    stack: &mut Stack,
) -> (Vec3, u8) {
    let Some(ray) = rays.through(at) else {
        return (Vec3::ZERO, 0);
    };
    let pose = &studio.view.world_from_camera;
    let found = studio.occlusion.caster.cast(
        studio.scene,
        Ray {
            origin: pose.translation,
            direction: pose.rotation * ray,
            near: studio.view.clip.near_m,
            far: studio.view.clip.far_m,
        },
        stack,
    );
    let next = [
        rays.through([at[0] + 1.0, at[1]]),
        rays.through([at[0], at[1] + 1.0]),
    ];
    let (t, hit) = found.unwrap_or((f64::INFINITY, Hit::MISS));
    #[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
    studio.color(pixel, hit, ray, next, (t * ray.z) as f32, finder, stack)
}

/// The pixels at outlines and sharp edges that can be seen as such.
fn outlines(seen: &Visibility, rgb: &Image<[u8; 4]>) -> Vec<[u32; 2]> {
    let (width, height) = (rgb.width(), rgb.height());
    let rows: Vec<Vec<[u32; 2]>> = (0..height)
        .into_par_iter()
        .map(|y| {
            let is_outline = |x: u32| {
                let neighbours = [
                    [(x.checked_sub(1), Some(y)), (x.checked_add(1), Some(y))],
                    [(Some(x), y.checked_sub(1)), (Some(x), y.checked_add(1))],
                ];
                let pixel = |x: Option<u32>, y: Option<u32>| {
                    let (x, y) = (x?, y?);
                    Some((*rgb.get(x, y)?, *seen.hits.get(x, y)?, *seen.z.0.get(x, y)?))
                };
                let Some((color, hit, z)) = pixel(Some(x), Some(y)) else {
                    return false;
                };
                neighbours.iter().any(|pair| {
                    let [before, after] = pair.map(|(x, y)| pixel(x, y));
                    let contrasts = [before, after]
                        .iter()
                        .flatten()
                        .any(|(other, _, _)| contrast(color, *other) >= LEAST_CONTRAST);
                    if !contrasts {
                        return false;
                    }
                    let changes = [before, after]
                        .iter()
                        .flatten()
                        .any(|(_, other, _)| other.instance != hit.instance);
                    let bends = before.zip(after).is_some_and(|((_, _, left), (_, _, right))| {
                        (z / left + z / right - 2.0).abs() > LEAST_BEND
                    });
                    changes || bends
                })
            };
            (0..width).filter(|x| is_outline(*x)).map(|x| [x, y]).collect()
        })
        .collect();
    rows.concat()
}

fn contrast(a: [u8; 4], b: [u8; 4]) -> u8 {
    (a.iter().zip(b)).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}
