use std::path::PathBuf;

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Light, LightKind};
use serde::Serialize;

use super::Placed;
use crate::context::Context;
use crate::random::{Numbers, rotation_around, rotation_between};
use crate::recipe::{Lamps, Sky, Sun};

/// The kind of a drawn light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum DrawnLightKind {
    Sun,
    Sky,
    Lamp,
}

impl DrawnLightKind {
    /// The name in the path of the light.
    const fn name(self) -> &'static str {
        match self {
            Self::Sun => "Sun",
            Self::Sky => "Sky",
            Self::Lamp => "Lamp",
        }
    }
}

/// A drawn light.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct DrawnLight {
    kind: DrawnLightKind,
    /// Linear radiance, or irradiance of the sun.
    radiance: [f32; 3],
    /// The centre of a lamp, or the direction towards the sun.
    place: [f64; 3],
    /// The length of a lamp's edges, metres.
    #[serde(skip_serializing_if = "is_zero")]
    size_m: f64,
    /// The image of the sky.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) image: Option<PathBuf>,
    /// The rotation of the sky, degrees.
    #[serde(skip_serializing_if = "is_zero")]
    azimuth_deg: f64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde requires")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

impl DrawnLight {
    /// Returns the light in a world with this up axis; `texture` is the index of the sky's image.
    #[expect(clippy::cast_possible_truncation, reason = "lights are float32")]
    pub(crate) fn light(&self, index: usize, up: DVec3, texture: Option<u32>) -> Light {
        let place = DVec3::from(self.place);
        let (kind, world_from_light) = match self.kind {
            DrawnLightKind::Sun => {
                let kind = LightKind::Distant { angle: 0.0093 };
                (kind, DAffine3::from_mat3(facing(place)))
            }
            DrawnLightKind::Lamp => {
                let size = self.size_m as f32;
                let kind = LightKind::Rect {
                    width: size,
                    height: size,
                };
                (kind, DAffine3::from_mat3_translation(facing(up), place))
            }
            DrawnLightKind::Sky => {
                let turn = rotation_around(up, self.azimuth_deg.to_radians());
                // The pole of a dome is +y.
                let upright = rotation_between(DVec3::Y, up);
                (LightKind::Dome { texture }, DAffine3::from_mat3(turn * upright))
            }
        };
        Light {
            path: format!("/Generated/Lights/{}_{index}", self.kind.name()),
            kind,
            radiance: self.radiance,
            normalize: false,
            world_from_light,
        }
    }
}

/// Returns axes whose z points in a direction, so that a light shines against it.
fn facing(direction: DVec3) -> DMat3 {
    rotation_between(DVec3::Z, direction.normalize())
}

pub(super) fn draw(context: &Context, base: usize, objects: &[Placed], number: u64) -> Vec<DrawnLight> {
    let rule = &context.file.recipe.light;
    let numbers = |name: &str| context.random.numbers(&format!("light.{name}"), number);
    let base = &context.bases[base];
    let mut lights = Vec::new();
    if let Some(sun) = &rule.sun {
        lights.push(draw_sun(sun, base.up(), &mut numbers("sun")));
    }
    if let Some(sky) = &rule.sky {
        lights.push(draw_sky(sky, &context.sky_images, &mut numbers("sky")));
    }
    if let Some(lamps) = &rule.lamps {
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let center = match objects {
            [] => base.bounds.center(),
            objects => objects.iter().map(|one| one.center).sum::<DVec3>() / objects.len() as f64,
        };
        let mut numbers = numbers("lamps");
        let count = lamps.count.draw(&mut numbers).round();
        let mut index = 0.0;
        while index < count {
            lights.push(draw_lamp(lamps, center, base.up(), &mut numbers));
            index += 1.0;
        }
    }
    lights
}

fn draw_sun(sun: &Sun, up: DVec3, numbers: &mut Numbers) -> DrawnLight {
    let intensity = sun.intensity.draw(numbers);
    let elevation = sun.elevation_deg.draw(numbers).to_radians();
    let azimuth = sun.azimuth_deg.draw(numbers).to_radians();
    let temperature = sun.temperature_k.draw(numbers);
    DrawnLight {
        kind: DrawnLightKind::Sun,
        radiance: emitted(intensity, temperature),
        place: direction(up, azimuth, elevation).to_array(),
        size_m: 0.0,
        image: None,
        azimuth_deg: 0.0,
    }
}

fn draw_sky(sky: &Sky, images: &[PathBuf], numbers: &mut Numbers) -> DrawnLight {
    let intensity = sky.intensity.draw(numbers);
    let azimuth_deg = sky.azimuth_deg.draw(numbers);
    let image = numbers.pick(images).cloned();
    DrawnLight {
        kind: DrawnLightKind::Sky,
        radiance: emitted(intensity, WHITE_K),
        place: [0.0; 3],
        size_m: 0.0,
        azimuth_deg: if image.is_some() { azimuth_deg } else { 0.0 },
        image,
    }
}

fn draw_lamp(lamps: &Lamps, center: DVec3, up: DVec3, numbers: &mut Numbers) -> DrawnLight {
    let intensity = lamps.intensity.draw(numbers);
    let size_m = lamps.size_m.draw(numbers);
    let height = lamps.height_m.draw(numbers);
    let distance = lamps.distance_m.draw(numbers);
    let azimuth = std::f64::consts::TAU * numbers.uniform();
    let temperature = lamps.temperature_k.draw(numbers);
    let within = [numbers.uniform(), numbers.uniform(), numbers.uniform()];
    let place = match lamps.region {
        Some(region) => {
            let (min, max) = (DVec3::from(region.min), DVec3::from(region.max));
            min + (max - min) * DVec3::from(within)
        }
        None => center + up * height + direction(up, azimuth, 0.0) * distance,
    };
    DrawnLight {
        kind: DrawnLightKind::Lamp,
        radiance: emitted(intensity, temperature),
        place: place.to_array(),
        size_m,
        image: None,
        azimuth_deg: 0.0,
    }
}

/// Returns a direction by its azimuth from the x axis, counter-clockwise seen from above, and its elevation, radians.
pub(crate) fn direction(up: DVec3, azimuth: f64, elevation: f64) -> DVec3 {
    let ahead = DVec3::X;
    let left = up.cross(ahead);
    let level = ahead * libm::cos(azimuth) + left * libm::sin(azimuth);
    level * libm::cos(elevation) + up * libm::sin(elevation)
}

/// The colour temperature of white light, kelvin.
const WHITE_K: f64 = 6500.0;

/// Returns the linear radiance of a black body of this luminance, 1 for each component at 6500 K.
///
/// The chromaticity follows Krystek's approximation of the Planckian locus (*An algorithm to calculate correlated colour temperature*,
/// 1985), with an error below 8e-5 between 1000 K and 15 000 K.
#[expect(clippy::cast_possible_truncation, reason = "light is float32")]
fn emitted(intensity: f64, temperature: f64) -> [f32; 3] {
    let (color, white) = (planckian(temperature), planckian(WHITE_K));
    let relative: [f64; 3] = std::array::from_fn(|i| (color[i] / white[i]).max(0.0));
    let luminance = 0.2126 * relative[0] + 0.7152 * relative[1] + 0.0722 * relative[2];
    relative.map(|value| (intensity * value / luminance) as f32)
}

/// Returns linear sRGB of a black body with a luminance of 1.
fn planckian(kelvin: f64) -> [f64; 3] {
    let t = kelvin.clamp(1000.0, 15_000.0);
    let u = (0.860_117_757 + 1.541_182_54e-4 * t + 1.286_412_12e-7 * t * t)
        / (1.0 + 8.424_202_35e-4 * t + 7.081_451_63e-7 * t * t);
    let v = (0.317_398_726 + 4.228_062_45e-5 * t + 4.204_816_91e-8 * t * t)
        / (1.0 - 2.897_418_16e-5 * t + 1.614_560_53e-7 * t * t);
    let denominator = 2.0 * u - 8.0 * v + 4.0;
    let (x, y) = (3.0 * u / denominator, 2.0 * v / denominator);
    let [big_x, big_z] = [x / y, (1.0 - x - y) / y];
    [
        3.240_454_2 * big_x - 1.537_138_5 - 0.498_531_4 * big_z,
        -0.969_266 * big_x + 1.876_010_8 + 0.041_556 * big_z,
        0.055_643_4 * big_x - 0.204_025_9 + 1.057_225_2 * big_z,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warm_light_is_red_and_as_bright() {
        let white = emitted(2.0, 6500.0);
        assert!(white.iter().all(|x| (x - 2.0).abs() < 1e-6), "{white:?}");
        let [r, g, b] = emitted(1.0, 2700.0);
        assert!(r > 1.5 && b < 0.3, "{r} {g} {b}");
        assert!((0.2126 * r + 0.7152 * g + 0.0722 * b - 1.0).abs() < 1e-5);
    }

    #[test]
    fn directions_turn_counter_clockwise_seen_from_above() {
        let quarter = std::f64::consts::FRAC_PI_2;
        assert!((direction(DVec3::Z, quarter, 0.0) - DVec3::Y).length() < 1e-12);
        assert!((direction(DVec3::Y, quarter, 0.0) - DVec3::NEG_Z).length() < 1e-12);
        assert!((direction(DVec3::Y, 0.3, quarter) - DVec3::Y).length() < 1e-12);
    }

    #[test]
    fn lights_face_the_scene() {
        let sun = draw_sun(
            &Sun::default(),
            DVec3::Z,
            &mut crate::random::Random::new(0).numbers("sun", 3),
        );
        let light = sun.light(0, DVec3::Z, None);
        let shines = light.world_from_light.transform_vector3(DVec3::NEG_Z);
        assert!((shines + DVec3::from(sun.place)).length() < 1e-12 && shines.z < 0.0);
    }
}
