//! The benchmark's scene: a textured room of planes, spheres and boxes, 77° wide, in closed form.

use oaktwin_image::Image;

/// A ray direction, scaled to z = 1.
type Direction = [f32; 3];

const BALLS: [([f32; 3], f32); 4] = [
    ([-0.6, 0.3, 2.0], 0.45),
    ([0.9, 0.1, 3.2], 0.6),
    ([0.15, -0.35, 1.1], 0.12),
    ([-1.8, -0.4, 4.5], 0.8),
];
/// Panels facing the camera: left, top, right, bottom and distance in metres.
const PANELS: [([f32; 4], f32); 3] = [
    ([-0.35, -0.1, 0.1, 0.6], 1.6),
    ([0.5, -0.9, 1.1, -0.2], 2.4),
    ([1.3, -0.3, 2.4, 0.9], 5.0),
];

/// A depth image in metres, with misses in a doorway, and its colour image.
pub(crate) fn ray_cast(width: u32, height: u32) -> (Image<f32>, Image<[u8; 4]>) {
    let focal = width as f32 / (2.0 * 38.5f32.to_radians().tan());
    let mut depth = Image::filled(width, height, f32::INFINITY);
    let mut rgb = Image::filled(width, height, [0; 4]);
    let pixels = depth.pixels_mut().iter_mut().zip(rgb.pixels_mut());
    for (i, (z, color)) in pixels.enumerate() {
        let (x, y) = (i % width as usize, i / width as usize);
        let direction = [
            (x as f32 + 0.5 - width as f32 / 2.0) / focal,
            (y as f32 + 0.5 - height as f32 / 2.0) / focal,
            1.0,
        ];
        *z = nearest(direction);
        *color = texture(direction, *z);
    }
    (depth, rgb)
}

fn nearest(direction: Direction) -> f32 {
    let [x, y, _] = direction;
    let mut z = f32::INFINITY;
    let mut at = |distance: f32| {
        if distance > 0.0 && distance < z {
            z = distance;
        }
    };
    at(1.2 / y); // floor
    at(-1.6 / y); // ceiling
    at(2.8 / x);
    at(-3.1 / x);
    // The far wall has an open door.
    if !(0.05..0.2).contains(&x) {
        at(6.5);
    }
    for ([left, top, right, bottom], distance) in PANELS {
        if (left..right).contains(&(x * distance)) && (top..bottom).contains(&(y * distance)) {
            at(distance);
        }
    }
    for (centre, radius) in BALLS {
        let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (a, half_b) = (dot(direction, direction), dot(direction, centre));
        let discriminant = half_b * half_b - a * (dot(centre, centre) - radius * radius);
        if discriminant > 0.0 {
            at((half_b - discriminant.sqrt()) / a);
        }
    }
    if x > 0.05 && x < 0.2 && z == 6.5 {
        f32::INFINITY
    } else {
        z
    }
}

/// Noise in cells of 15 mm; smooth above the horizon on the left.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cells and bytes"
)]
fn texture(direction: Direction, z: f32) -> [u8; 4] {
    if !z.is_finite() {
        return [150, 170, 200, 255];
    }
    if direction[0] < -0.3 && direction[1] < 0.0 {
        return [180, 178, 170, 255];
    }
    let cell = direction.map(|axis| (axis * z / 0.015).floor() as i32 as u32);
    let mut hash = cell.iter().fold(0x9E37_79B9_u32, |hash, cell| {
        (hash ^ cell).wrapping_mul(0x85EB_CA6B).rotate_left(13)
    });
    hash ^= hash >> 16;
    let grey = 60 + (hash % 150) as u8;
    [grey, grey, grey - 20, 255]
}
