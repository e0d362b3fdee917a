use std::path::PathBuf;

use oaktwin_scene::{Material, TextureUse};
use serde::Serialize;

use crate::random::Numbers;
use crate::recipe::Appearance;

/// A drawn material; `None` where the file's own are kept.
pub(crate) type DrawnLook = Option<DrawnMaterial>;

/// A drawn material.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct DrawnMaterial {
    /// Linear.
    color: [f32; 3],
    roughness: f32,
    metallic: f32,
    #[serde(skip_serializing_if = "Option::is_none")]
    infrared: Option<f32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) texture: Option<PathBuf>,
}

impl DrawnMaterial {
    /// Returns the material; `texture` is the index of its image in the scene.
    pub(crate) fn material(&self, texture: Option<u32>) -> Material {
        Material {
            name: String::new(),
            base_color: Some(self.color),
            base_color_texture: texture.map(TextureUse::new),
            roughness: self.roughness,
            metallic: self.metallic,
            infrared: self.infrared,
            ..Material::default()
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "materials are float32")]
pub(super) fn draw(look: &Appearance, textures: &[PathBuf], numbers: &mut Numbers) -> DrawnLook {
    // Each number is drawn whether or not it is used, so that one key does not change the others.
    let keeps = numbers.uniform() < look.keep;
    let hue = look.hue_deg.draw(numbers);
    let saturation = look.saturation.draw(numbers);
    let albedo = look.albedo.draw(numbers);
    let roughness = look.roughness.draw(numbers) as f32;
    let metallic = look.metallic.draw(numbers) as f32;
    let is_textured = numbers.uniform() < look.textured;
    let texture = numbers.pick(textures).filter(|_| is_textured).cloned();
    let infrared = look
        .infrared
        .as_ref()
        .map(|infrared| infrared.draw(numbers) as f32);
    (!keeps).then(|| DrawnMaterial {
        infrared,
        color: color(hue, saturation, albedo),
        roughness,
        metallic,
        texture,
    })
}

/// Returns a linear colour from hue in degrees, saturation and its largest component.
#[expect(clippy::cast_possible_truncation, reason = "colours are float32")]
fn color(hue: f64, saturation: f64, value: f64) -> [f32; 3] {
    [5.0, 3.0, 1.0].map(|offset| {
        let place = (offset + hue / 60.0).rem_euclid(6.0);
        let share = place.min(4.0 - place).clamp(0.0, 1.0);
        (value * (1.0 - saturation * share)) as f32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hues_have_their_colours() {
        assert_eq!(color(0.0, 1.0, 0.5), [0.5, 0.0, 0.0]);
        assert_eq!(color(120.0, 1.0, 1.0), [0.0, 1.0, 0.0]);
        assert_eq!(color(240.0, 0.5, 1.0), [0.5, 0.5, 1.0]);
        assert_eq!(color(60.0, 1.0, 1.0), [1.0, 1.0, 0.0]);
        assert_eq!(color(17.0, 0.0, 0.3), [0.3; 3]);
    }
}
