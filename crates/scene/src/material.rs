use std::path::PathBuf;
use std::sync::Arc;

/// A simple surface material for previews and stereo matching, not for path tracing. Colours are linear.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The path of its prim, or its name in the file.
    pub name: String,
    /// The base colour, which multiplies the texture if there is one; `None` if the mesh's own colours are used.
    pub base_color: Option<[f32; 3]>,
    /// The texture of the base colour.
    pub base_color_texture: Option<TextureUse>,
    /// The reflectance at 940 nm, from 0 to 1, where infrared light and the pairs that see it, and time of flight, meet the surface; `None` if
    /// it follows from the colours.
    pub infrared: Option<f32>,
    /// The emitted light.
    pub emissive: [f32; 3],
    /// The metalness, from 0 to 1.
    pub metallic: f32,
    /// The roughness, from 0 to 1.
    pub roughness: f32,
    /// Where the surface is invisible or lets light pass; `None` if it is solid everywhere.
    pub opacity: Option<Opacity>,
    /// The light that passes through the material, as through glass; `None` if it is not transparent.
    pub transmission: Option<Transmission>,
    /// The index of refraction, at least 1, which determines what the surfaces of glass, plastic and lacquer reflect.
    pub index: f32,
    /// The reflectance at normal incidence; `None` if it follows from the index, the base colour and the metalness.
    pub specular: Option<[f32; 3]>,
}

/// The light that passes through a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmission {
    /// The share, from 0 to 1, of the light that is not reflected at the surface; the rest is scattered by the base colour.
    pub share: f32,
    /// The image that multiplies the share.
    pub mask: Option<TextureMask>,
    /// The factor of the light each time it passes a surface; `None` for the base colour.
    pub tint: Option<[f32; 3]>,
    /// Whether closed meshes of the material bend light by its index, as solid glass does. Otherwise each surface is a thin wall.
    pub refracts: bool,
}

/// The index of refraction of materials that state none: glass and most plastics.
pub const DEFAULT_INDEX: f32 = 1.5;

impl Default for Material {
    fn default() -> Self {
        Self {
            name: String::new(),
            base_color: None,
            base_color_texture: None,
            infrared: None,
            emissive: [0.0; 3],
            metallic: 0.0,
            roughness: 0.5,
            opacity: None,
            transmission: None,
            index: DEFAULT_INDEX,
            specular: None,
        }
    }
}

impl Material {
    /// Returns the material of surfaces without one: grey, or the mesh's own colours.
    #[must_use]
    pub fn bare() -> Self {
        Self {
            roughness: 0.6,
            ..Self::default()
        }
    }

    /// Returns what is wrong with a number of a file, for a finding, if it is not within 0 and 1.
    #[must_use]
    pub fn not_a_share(name: &str, value: f32) -> Option<String> {
        (!(0.0..=1.0).contains(&value)).then(|| format!("its {name} is {value}, which is not within 0 and 1"))
    }

    /// Sets the index of refraction. Returns what is wrong with it, for a finding, if it is below 1; the index is then unchanged.
    pub fn set_index(&mut self, index: f32) -> Option<String> {
        if index.is_finite() && index >= 1.0 {
            self.index = index;
            return None;
        }
        Some(format!(
            "its index of refraction is {index}, which is below 1; {} is used",
            self.index
        ))
    }

    /// Returns the masks of the opacity and of the transmission.
    pub fn masks(&self) -> impl Iterator<Item = TextureMask> {
        let of_opacity = self.opacity.and_then(|opacity| opacity.mask);
        let of_transmission = self.transmission.and_then(|transmission| transmission.mask);
        of_opacity.into_iter().chain(of_transmission)
    }

    /// Returns the material for a scene in which its textures come after `count` others.
    #[must_use]
    pub fn after_textures(self, count: u32) -> Self {
        let moved = |used: TextureUse| TextureUse {
            texture: used.texture + count,
            ..used
        };
        let moved_mask = |mask: TextureMask| TextureMask {
            texture: moved(mask.texture),
            ..mask
        };
        Self {
            base_color_texture: self.base_color_texture.map(moved),
            opacity: self.opacity.map(|opacity| Opacity {
                mask: opacity.mask.map(moved_mask),
                ..opacity
            }),
            transmission: self.transmission.map(|transmission| Transmission {
                mask: transmission.mask.map(moved_mask),
                ..transmission
            }),
            ..self
        }
    }
}

/// Where a surface is invisible, as the leaves of a plant are cut out of a card, or lets part of the light pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opacity {
    /// The opacity, which multiplies the mask if there is one.
    pub value: f32,
    /// The image that cuts the surface.
    pub mask: Option<TextureMask>,
    /// The surface is invisible where its opacity is below this number, and solid elsewhere. If it is 0, the surface is
    /// invisible where its opacity is 0, and lets the rest of the light pass elsewhere.
    pub threshold: f32,
}

impl Opacity {
    /// Returns an opacity; `None` if the surface is solid everywhere.
    #[must_use]
    pub fn new(value: f32, mask: Option<TextureMask>, threshold: f32) -> Option<Self> {
        let opacity = Self {
            value,
            mask,
            threshold: if threshold.is_finite() { threshold } else { 0.0 },
        };
        (mask.is_some() || opacity.at(1.0) < 1.0).then_some(opacity)
    }

    /// Whether the opacity may be between 0 and 1 somewhere: no threshold decides which parts are visible.
    #[must_use]
    pub fn is_partial(&self) -> bool {
        self.threshold <= 0.0 && (self.mask.is_some() || self.value > 0.0 && self.value < 1.0)
    }

    /// Returns the opacity, from 0 to 1, where the mask, if there is one, has a value; 0 is invisible.
    #[must_use]
    #[inline]
    pub fn at(&self, mask: f32) -> f32 {
        let opacity = self.value * mask;
        if !(opacity > 0.0 && opacity >= self.threshold) {
            0.0
        } else if self.threshold > 0.0 {
            1.0
        } else {
            opacity.min(1.0)
        }
    }
}

/// One channel of a texture as a mask.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureMask {
    /// The texture.
    pub texture: TextureUse,
    /// The index of the channel among red, green, blue and opacity.
    pub channel: u8,
}

/// A texture with the way in which a material uses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// An index into the scene's textures.
    pub texture: u32,
    /// The rows of the 2×3 matrix from the mesh's coordinates to the image's, with the origin at the lower left.
    pub image_from_uv: [[f32; 3]; 2],
    /// The factor applied to the texture's red, green, blue and opacity.
    pub scale: [f32; 4],
    /// The offset added after that.
    pub bias: [f32; 4],
    /// The wrap mode in the horizontal direction.
    pub wrap_s: Wrap,
    /// The wrap mode in the vertical direction.
    pub wrap_t: Wrap,
}

impl TextureUse {
    /// Returns an unmodified use of a texture.
    #[must_use]
    pub const fn new(texture: u32) -> Self {
        Self {
            texture,
            image_from_uv: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            scale: [1.0; 4],
            bias: [0.0; 4],
            wrap_s: Wrap::Repeat,
            wrap_t: Wrap::Repeat,
        }
    }
}

/// How coordinates outside an image are handled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The image is repeated.
    #[default]
    Repeat,
    /// The image is mirrored.
    Mirror,
    /// The pixels at its border are extended.
    Clamp,
    /// The outside is black.
    Black,
}

impl Wrap {
    /// Returns the index of a pixel in a row or column of `count` pixels; `None` where the image is black.
    #[must_use]
    #[inline]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "inside the image by then"
    )]
    pub fn index(self, at: i64, count: u32) -> Option<u32> {
        let n = i64::from(count);
        if (0..n).contains(&at) {
            return Some(at as u32);
        }
        let at = match self {
            Self::Repeat => at.rem_euclid(n),
            Self::Clamp => at.clamp(0, n - 1),
            Self::Mirror => {
                let at = at.rem_euclid(2 * n);
                at.min(2 * n - 1 - at)
            }
            Self::Black => return None,
        };
        Some(at as u32)
    }
}

/// An image that is decoded only when colour is requested, or when it is the mask of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The source of its pixels.
    pub source: TextureSource,
    /// The meaning of its values.
    pub color_space: ColorSpace,
}

/// The source of an image's pixels.
#[derive(Clone, Debug, PartialEq)]
pub enum TextureSource {
    /// An image file.
    File(PathBuf),
    /// The bytes of an image file, from inside a package or a buffer.
    Encoded {
        /// The name used in messages.
        name: String,
        /// A complete PNG, JPEG or other image file.
        bytes: Arc<[u8]>,
    },
    /// Decoded sRGB and opacity; the top row is first.
    Pixels(Arc<oaktwin_image::Image<[u8; 4]>>),
}

/// The colour space of a texture's values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum ColorSpace {
    /// sRGB if it has 8 bits and three channels, otherwise linear.
    #[default]
    Auto,
    /// sRGB.
    Srgb,
    /// Linear.
    Raw,
}

#[cfg(test)]
mod tests {
    use super::Wrap;

    #[test]
    fn indices_outside_an_image_are_wrapped() {
        let wrapped = |wrap: Wrap| [-4, -1, 0, 2, 3, 5].map(|at| wrap.index(at, 3));
        assert_eq!(wrapped(Wrap::Repeat), [2, 2, 0, 2, 0, 2].map(Some));
        assert_eq!(wrapped(Wrap::Mirror), [2, 0, 0, 2, 2, 0].map(Some));
        assert_eq!(wrapped(Wrap::Clamp), [0, 0, 0, 2, 2, 2].map(Some));
        assert_eq!(wrapped(Wrap::Black), [None, None, Some(0), Some(2), None, None]);
    }
}
