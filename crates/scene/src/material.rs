use std::path::PathBuf;
use std::sync::Arc;

/// What a surface looks like: enough for a recognisable picture, not for a path tracer. Colours are linear.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The prim or the name in the file.
    pub name: String,
    /// Multiplies the texture, if there is one; `None` where the file leaves it to the mesh's own colours.
    pub base_color: Option<[f32; 3]>,
    /// The base colour's image.
    pub base_color_texture: Option<TextureUse>,
    /// Light that it gives off by itself.
    pub emissive: [f32; 3],
    /// 0 to 1.
    pub metallic: f32,
    /// 0 to 1.
    pub roughness: f32,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            name: String::new(),
            base_color: None,
            base_color_texture: None,
            emissive: [0.0; 3],
            metallic: 0.0,
            roughness: 0.5,
        }
    }
}

/// A texture as a material uses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Into the scene's textures.
    pub texture: u32,
    /// Rows of the 2×3 matrix that takes a mesh's coordinates to the image's, origin at the lower left.
    pub image_from_uv: [[f32; 3]; 2],
    /// Multiplies what was read.
    pub scale: [f32; 3],
    /// Is added after that.
    pub bias: [f32; 3],
    /// What happens left and right of the image.
    pub wrap_s: Wrap,
    /// What happens above and below it.
    pub wrap_t: Wrap,
}

impl TextureUse {
    /// A texture as it stands.
    #[must_use]
    pub const fn new(texture: u32) -> Self {
        Self {
            texture,
            image_from_uv: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            scale: [1.0; 3],
            bias: [0.0; 3],
            wrap_s: Wrap::Repeat,
            wrap_t: Wrap::Repeat,
        }
    }
}

/// What lies outside an image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The image again.
    #[default]
    Repeat,
    /// The image mirrored.
    Mirror,
    /// Its outermost pixel.
    Clamp,
    /// Black.
    Black,
}

/// An image that is decoded only when colour is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Where its pixels are.
    pub source: TextureSource,
    /// How its numbers are meant.
    pub color_space: ColorSpace,
}

/// Where an image's pixels are.
#[derive(Clone, Debug, PartialEq)]
pub enum TextureSource {
    /// In a file of their own.
    File(PathBuf),
    /// In a file's bytes: from inside a package or a buffer.
    Encoded {
        /// What to call it in messages.
        name: String,
        /// A whole PNG, JPEG or other image file.
        bytes: Arc<[u8]>,
    },
    /// sRGB and opacity, decoded; rows from the top.
    Pixels(Arc<oaktwin_image::Image<[u8; 4]>>),
}

/// How a texture's numbers are meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorSpace {
    /// sRGB where it has 8 bits and three channels, else linear.
    #[default]
    Auto,
    /// sRGB.
    Srgb,
    /// Linear.
    Raw,
}
