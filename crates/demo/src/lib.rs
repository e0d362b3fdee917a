//! A furnished room for first experiments: textured, lit and labelled, with objects 0.3 m to 8 m away.

mod noise;
mod pictures;
mod surfaces;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_image::{CodecError, Image, png};
use rayon::prelude::*;

/// The name of the stage among the [`files`]; its textures lie beside it.
pub const STAGE: &str = "demo_room.usda";

/// The pose of an OAK in the room, and of the stage's prim `/Room/Oak`: from its body (x forward, y left, z up)
/// to the world, metres.
#[must_use]
pub fn world_from_body() -> RigidTransform {
    RigidTransform::new(
        DMat3::from_rotation_y(7f64.to_radians()),
        DVec3::new(0.0, 0.0, 1.15),
    )
}

/// Returns the room's files by name: a USD stage and its textures, which are the same on every run.
///
/// # Errors
/// Returns an error if a texture cannot be encoded.
pub fn files() -> Result<Vec<(&'static str, Vec<u8>)>, CodecError> {
    let stage = (STAGE, include_bytes!("../assets/demo_room.usda").to_vec());
    let textures = TEXTURES
        .par_iter()
        .map(|(name, paint)| Ok((*name, png::encode(&paint())?)));
    let textures = textures.collect::<Result<Vec<_>, CodecError>>()?;
    Ok([vec![stage], textures].concat())
}

/// An sRGB picture, rows from the top.
type Picture = Image<[u8; 3]>;

/// Paints a picture.
type Painter = fn() -> Picture;

const TEXTURES: [(&str, Painter); 11] = [
    ("bricks.png", surfaces::bricks),
    ("carpet.png", pictures::carpet),
    ("carton.png", surfaces::carton),
    ("leaf.png", pictures::leaf),
    ("map.png", pictures::map),
    ("planks.png", surfaces::planks),
    ("plaster.png", surfaces::plaster),
    ("poster.png", pictures::poster),
    ("spine.png", pictures::spine),
    ("target.png", pictures::target),
    ("wood.png", surfaces::wood),
];

/// An sRGB colour, 0 to 1.
type Color = [f32; 3];

/// A picture of `width` × `height` pixels; `color` is evaluated at their centres, in pixels.
fn painted(width: u16, height: u16, color: impl Fn(f32, f32) -> Color) -> Picture {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (f32::from(x) + 0.5, f32::from(y) + 0.5)));
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "casts of floats saturate"
    )]
    let pixels = places.map(|(x, y)| color(x, y).map(|value| (value * 255.0 + 0.5) as u8));
    let mut picture = Image::filled(u32::from(width), u32::from(height), [0; 3]);
    for (pixel, painted) in picture.pixels_mut().iter_mut().zip(pixels) {
        *pixel = painted;
    }
    picture
}

fn mixed(a: Color, b: Color, part: f32) -> Color {
    let part = part.clamp(0.0, 1.0);
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * part)
}

fn dimmed(color: Color, factor: f32) -> Color {
    color.map(|value| value * factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stage_uses_every_texture_and_no_other() {
        let stage = include_str!("../assets/demo_room.usda");
        let mut named: Vec<&str> = (stage.split('@'))
            .filter_map(|part| part.strip_prefix("./"))
            .collect();
        named.sort_unstable();
        named.dedup();
        assert_eq!(named, TEXTURES.map(|(name, _)| name));
    }

    #[test]
    fn the_oak_stands_where_the_prim_does() {
        let stage = include_str!("../assets/demo_room.usda");
        let oak = &stage[stage.find("def Xform \"Oak\"").unwrap()..];
        let oak = &oak[..oak.find("\n    }").unwrap()];
        assert!(oak.contains("xformOp:rotateXYZ = (0, 7, 0)"), "{oak}");
        assert!(oak.contains("xformOp:translate = (0, 0, 1.15)"), "{oak}");
        assert_eq!(world_from_body().translation, DVec3::new(0.0, 0.0, 1.15));
        // Looking a little down.
        assert!(world_from_body().apply(DVec3::X).z < 1.15);
    }

    #[test]
    fn textures_are_whole_and_varied() {
        for (name, bytes) in files().unwrap() {
            if name == STAGE {
                continue;
            }
            let picture = oaktwin_image::texture::decode_srgb(&bytes, None).unwrap();
            let mut values: Vec<u8> = picture.pixels().iter().map(|pixel| pixel[1]).collect();
            values.sort_unstable();
            let (low, high) = (values[values.len() / 50], values[values.len() * 49 / 50]);
            assert!(high - low > 12, "{name}: {low} to {high}");
        }
    }
}
