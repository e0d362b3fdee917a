//! The fine texture of surfaces without a texture of their own.

use glam::Vec3;
use oaktwin_scene::MicroTexture;

/// The size of the finest cells of noise, metres.
const FINEST: f32 = 0.0005;
/// The number of octaves, each twice as coarse as the one before.
const OCTAVES: u32 = 9;

/// Returns the factor on the albedo at a point in the frame of a surface, metres. What is finer than `footprint`, the size of a pixel
/// on the surface, is left out.
pub(super) fn factor(texture: &MicroTexture, surface: u32, point: Vec3, footprint: f32) -> f32 {
    let mut sum = 0.0;
    let mut cell = FINEST;
    for octave in 0..OCTAVES {
        // An octave fades out as its cells shrink from two pixels to one.
        let weight = (cell / footprint - 1.0).clamp(0.0, 1.0);
        if weight > 0.0 {
            let seed = mixed(texture.seed ^ mixed(surface.wrapping_mul(OCTAVES).wrapping_add(octave)));
            sum += weight * noise(point / cell, seed);
        }
        cell *= 2.0;
    }
    1.0 + texture.contrast * sum
}

/// Value noise from -1 to 1 on a lattice of unit cells.
#[expect(
    clippy::cast_possible_truncation,
    reason = "beyond the range of integers noise repeats"
)]
fn noise(point: Vec3, seed: u32) -> f32 {
    let corner = point.floor();
    let at = point - corner;
    let [x, y, z] = corner.to_array().map(|value| value as i32);
    let value = |dx: i32, dy: i32, dz: i32| {
        let [x, y, z] =
            [(x, dx), (y, dy), (z, dz)].map(|(from, step)| from.wrapping_add(step).cast_unsigned());
        let lattice = x.wrapping_mul(0x8da6_b343) ^ y.wrapping_mul(0xd816_3841) ^ z.wrapping_mul(0xcb1a_b31f);
        unit(mixed(lattice ^ seed))
    };
    // A smooth step has no slope at the lattice's points.
    let t = at * at * (Vec3::splat(3.0) - 2.0 * at);
    let along = |y: i32, z: i32| lerp(value(0, y, z), value(1, y, z), t.x);
    let across = |z: i32| lerp(along(0, z), along(1, z), t.y);
    lerp(across(0), across(1), t.z)
}

fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// Mixes the bits of a number, by the finalizer of `MurmurHash3`.
fn mixed(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x85eb_ca6b);
    bits ^= bits >> 13;
    bits = bits.wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}

/// Returns a number from -1 to 1.
#[expect(clippy::cast_precision_loss, reason = "24 bits fit")]
fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 / 8_388_608.0 - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXTURE: MicroTexture = MicroTexture::ordinary(1);

    fn samples(footprint: f32) -> Vec<f32> {
        (0..4000_u16)
            .map(|at| {
                let at = f32::from(at);
                factor(&TEXTURE, 3, Vec3::new(at * 0.0011, at * 0.0007, 0.0), footprint)
            })
            .collect()
    }

    fn spread(values: &[f32]) -> f32 {
        let count = values.len() as f32;
        let mean = values.iter().sum::<f32>() / count;
        (values.iter().map(|value| (value - mean).powi(2)).sum::<f32>() / count).sqrt()
    }

    #[test]
    fn the_albedo_varies_by_one_to_two_percent_around_its_value() {
        let values = samples(0.001);
        let mean = values.iter().sum::<f32>() / values.len() as f32;
        assert!((mean - 1.0).abs() < 0.005, "{mean}");
        assert!((0.01..0.03).contains(&spread(&values)), "{}", spread(&values));
    }

    #[test]
    fn what_is_finer_than_a_pixel_is_left_out() {
        assert!(spread(&samples(0.02)) < spread(&samples(0.001)));
        assert_eq!(spread(&samples(1.0)).to_bits(), 0.0_f32.to_bits());
    }

    #[test]
    fn surfaces_and_seeds_differ() {
        let point = Vec3::new(0.1234, 0.2345, 0.3456);
        let here = factor(&TEXTURE, 3, point, 0.001);
        assert!((here - factor(&TEXTURE, 4, point, 0.001)).abs() > 1e-6);
        assert!((here - factor(&MicroTexture::ordinary(2), 3, point, 0.001)).abs() > 1e-6);
        assert_eq!(here.to_bits(), factor(&TEXTURE, 3, point, 0.001).to_bits());
    }
}
