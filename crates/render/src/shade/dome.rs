//! Textures of dome lights.

use glam::Vec3;
use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_image::Image;
use oaktwin_scene::Texture;

use super::harmonics::Harmonics;
use crate::texture_file::linear;

/// The columns and rows of the reduced image from which spherical harmonics are computed.
const COARSE: [u32; 2] = [64, 32];

/// A latitude-longitude image around the world.
///
/// In the light's frame its upper edge is +y, its centre is +z and +x is left of the centre, as `OpenEXR` defines such images and
/// OpenUSD draws them.
#[derive(Debug)]
pub(super) struct DomeImage {
    image: Image<[f32; 3]>,
    radiance: Vec3,
    light_from_world: DMat3,
}

impl DomeImage {
    /// Decodes the texture. Returns a finding if it cannot be shown.
    pub(super) fn new(
        texture: &Texture,
        radiance: Vec3,
        world_from_light: DAffine3,
    ) -> Result<Self, Finding> {
        let inverse = world_from_light.matrix3.inverse();
        let is_whole = inverse.is_finite();
        let image = linear(&texture.source)?;
        Ok(Self {
            image,
            radiance,
            light_from_world: if is_whole { inverse } else { DMat3::IDENTITY },
        })
    }

    /// Returns the radiance from a direction in the world.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "casts of floats saturate"
    )]
    pub(super) fn radiance(&self, direction: DVec3) -> Vec3 {
        use std::f64::consts::{FRAC_PI_2, PI, TAU};
        let d = (self.light_from_world * direction).normalize_or(DVec3::Y);
        let across = (d.z.atan2(d.x) + FRAC_PI_2).rem_euclid(TAU) / TAU;
        let down = d.y.clamp(-1.0, 1.0).acos() / PI;
        let (width, height) = (self.image.width(), self.image.height());
        let x = across * f64::from(width) - 0.5;
        let y = (down * f64::from(height) - 0.5).clamp(0.0, f64::from(height) - 1.0);
        let (left, top) = (x.floor(), y.floor());
        let (right_part, lower_part) = ((x - left) as f32, (y - top) as f32);
        let columns = [left, left + 1.0].map(|x| x.rem_euclid(f64::from(width)) as u32);
        let rows = [top as u32, (top as u32 + 1).min(height.saturating_sub(1))];
        let [[a, b], [c, d]] = rows.map(|y| columns.map(|x| self.pixel(x, y)));
        let (upper, lower) = (a.lerp(b, right_part), c.lerp(d, right_part));
        upper.lerp(lower, lower_part) * self.radiance
    }

    fn pixel(&self, x: u32, y: u32) -> Vec3 {
        let pixel = Vec3::from(self.image.get(x, y).copied().unwrap_or_default());
        if pixel.is_finite() {
            pixel.max(Vec3::ZERO)
        } else {
            Vec3::ZERO
        }
    }

    /// Returns the spherical harmonics of the image.
    #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
    pub(super) fn harmonics(&self) -> Harmonics {
        use std::f64::consts::{FRAC_PI_2, PI, TAU};
        let mut sum = Harmonics::default();
        let [columns, rows] = COARSE;
        let world_from_light = self.light_from_world.inverse();
        for row in 0..rows {
            let polar = PI * (f64::from(row) + 0.5) / f64::from(rows);
            let solid_angle = (TAU / f64::from(columns)) * (PI / f64::from(rows)) * polar.sin();
            for column in 0..columns {
                let azimuth = TAU * (f64::from(column) + 0.5) / f64::from(columns) - FRAC_PI_2;
                let (sin, cos) = azimuth.sin_cos();
                let direction = DVec3::new(polar.sin() * cos, polar.cos(), polar.sin() * sin);
                let in_world = (world_from_light * direction).normalize_or(DVec3::Z);
                sum.add(
                    in_world.as_vec3(),
                    self.mean(column, row) * self.radiance,
                    solid_angle as f32,
                );
            }
        }
        sum
    }

    /// Returns the mean of the pixels that a pixel of the reduced image covers.
    #[expect(clippy::cast_precision_loss, reason = "a count")]
    fn mean(&self, column: u32, row: u32) -> Vec3 {
        let span = |at: u32, coarse: u32, fine: u32| {
            let at_fine = |at: u32| u64::from(at) * u64::from(fine) / u64::from(coarse);
            let first = at_fine(at);
            let end = at_fine(at + 1).max(first + 1).min(u64::from(fine));
            let step = usize::try_from((end - first) / 16).unwrap_or(0).max(1);
            (first..end).step_by(step).filter_map(|at| u32::try_from(at).ok())
        };
        let mut sum = Vec3::ZERO;
        let mut count = 0u32;
        for y in span(row, COARSE[1], self.image.height()) {
            for x in span(column, COARSE[0], self.image.width()) {
                sum += self.pixel(x, y);
                count += 1;
            }
        }
        sum / count.max(1) as f32
    }
}
