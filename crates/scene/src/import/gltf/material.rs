use std::collections::BTreeMap;
use std::sync::Arc;

use ::gltf::json;
use json::texture::WrappingMode;
use json::validation::Checked;

use super::document::Document;
use super::uri::{self, Target};
use crate::import::builder::Builder;
use crate::{ColorSpace, Material, Texture, TextureSource, TextureUse, Wrap};

/// What primitives need to know of the materials, in the order of the file's.
pub(super) struct Materials {
    list: Vec<Known>,
}

#[derive(Clone, Copy)]
pub(super) struct Known {
    /// In the scene.
    pub(super) number: u32,
    /// Which set of texture coordinates its base colour has.
    pub(super) uv_set: Option<u32>,
    /// What multiplies the colours of vertices.
    pub(super) factor: [f32; 3],
    pub(super) double_sided: bool,
}

impl Materials {
    pub(super) fn read(document: &Document, builder: &mut Builder) -> Self {
        let mut images = BTreeMap::new();
        let known = |(i, said): (usize, &json::Material)| {
            let pbr = &said.pbr_metallic_roughness;
            let [r, g, b, _] = pbr.base_color_factor.0;
            let factor = [r, g, b].map(finite);
            let name = said.name.clone().unwrap_or_else(|| format!("material_{i}"));
            let texture = pbr.base_color_texture.as_ref();
            let (base_color_texture, uv_set) =
                match texture.map(|info| read_texture(document, info, &name, &mut images, builder)) {
                    Some(Some((texture, set))) => (Some(texture), Some(set)),
                    _ => (None, None),
                };
            let number = builder.add_material(Material {
                name,
                base_color: Some(factor),
                base_color_texture,
                emissive: said.emissive_factor.0.map(finite),
                metallic: finite(pbr.metallic_factor.0).clamp(0.0, 1.0),
                roughness: finite(pbr.roughness_factor.0).clamp(0.0, 1.0),
            });
            Known {
                number,
                uv_set,
                factor,
                double_sided: said.double_sided,
            }
        };
        Self {
            list: document.root.materials.iter().enumerate().map(known).collect(),
        }
    }

    pub(super) fn get(&self, index: usize) -> Option<Known> {
        self.list.get(index).copied()
    }
}

fn finite(x: f32) -> f32 {
    if x.is_finite() { x } else { 0.0 }
}

/// The texture and its set of coordinates; `None`, with a finding, where there is no image.
fn read_texture(
    document: &Document,
    info: &json::texture::Info,
    material: &str,
    images: &mut BTreeMap<usize, Option<u32>>,
    builder: &mut Builder,
) -> Option<(TextureUse, u32)> {
    let Some(texture) = document.root.textures.get(info.index.value()) else {
        builder.warn("texture-missing", material, "its texture is not in the file");
        return None;
    };
    let image = texture.source.value();
    let number = *images
        .entry(image)
        .or_insert_with(|| match source(document, image) {
            Ok(source) => Some(builder.add_texture(Texture {
                source,
                color_space: ColorSpace::Srgb,
            })),
            Err(message) => {
                builder.warn("texture-missing", format!("images[{image}]"), message);
                None
            }
        });
    let mut used = TextureUse::new(number?);
    let sampler = texture
        .sampler
        .and_then(|sampler| document.root.samplers.get(sampler.value()));
    if let Some(sampler) = sampler {
        used.wrap_s = wrap(sampler.wrap_s);
        used.wrap_t = wrap(sampler.wrap_t);
    }
    let mut set = info.tex_coord;
    let transform = info
        .extensions
        .as_ref()
        .and_then(|extensions| extensions.texture_transform.as_ref());
    if let Some(transform) = transform {
        set = transform.tex_coord.unwrap_or(set);
        used.image_from_uv = image_from_uv(transform.offset.0, transform.rotation.0, transform.scale.0);
    }
    Some((used, set))
}

fn source(document: &Document, image: usize) -> Result<TextureSource, String> {
    let Some(said) = document.root.images.get(image) else {
        return Err("the image is not in the file".into());
    };
    let name = said.name.clone().unwrap_or_else(|| format!("images[{image}]"));
    let encoded = |bytes: &[u8]| TextureSource::Encoded {
        name,
        bytes: Arc::from(bytes),
    };
    match (&said.uri, said.buffer_view) {
        (_, Some(view)) => document.view(view.value()).map(|(bytes, _)| encoded(bytes)),
        (Some(uri), None) => match uri::resolve(uri, &document.folder) {
            Target::Data(bytes) => Ok(encoded(&bytes)),
            Target::File(file) if file.is_file() => Ok(TextureSource::File(file)),
            Target::File(file) => Err(format!("{}: the image is not there", file.display())),
            Target::Unsupported(why) => Err(format!("the image is {why}")),
        },
        (None, None) => Err("the image has no data".into()),
    }
}

fn wrap(mode: Checked<WrappingMode>) -> Wrap {
    match mode {
        Checked::Valid(WrappingMode::ClampToEdge) => Wrap::Clamp,
        Checked::Valid(WrappingMode::MirroredRepeat) => Wrap::Mirror,
        Checked::Valid(WrappingMode::Repeat) | Checked::Invalid => Wrap::Repeat,
    }
}

/// `KHR_texture_transform` between coordinates from the lower left instead of from the upper left.
///
/// It scales, turns counter-clockwise as one sees it, then moves: so does Khronos's own viewer. (The formula in the
/// extension's text turns the other way.)
fn image_from_uv(offset: [f32; 2], rotation: f32, scale: [f32; 2]) -> [[f32; 3]; 2] {
    let (sine, cosine) = rotation.sin_cos();
    let ([su, sv], [ou, ov]) = (scale, offset);
    // From above: u′ = c·su·u + s·sv·v + ou, v′ = −s·su·u + c·sv·v + ov. Then 1 − v for v on both sides.
    let matrix = [
        [cosine * su, -sine * sv, ou + sine * sv],
        [sine * su, cosine * sv, 1.0 - ov - cosine * sv],
    ];
    if matrix.iter().flatten().all(|x| x.is_finite()) {
        matrix
    } else {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn apply(m: [[f32; 3]; 2], [u, v]: [f32; 2]) -> [f32; 2] {
        m.map(|row| row[0] * u + row[1] * v + row[2])
    }

    #[test]
    fn transforms_turn_as_one_sees_them() {
        assert_eq!(
            image_from_uv([0.0; 2], 0.0, [1.0; 2]),
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        );
        // The upper half of the image: in glTF's coordinates from v = 0 to v = 0.5.
        let upper = image_from_uv([0.0, 0.0], 0.0, [1.0, 0.5]);
        assert_eq!(apply(upper, [0.0, 1.0]), [0.0, 1.0]);
        assert_eq!(apply(upper, [0.0, 0.0]), [0.0, 0.5]);
        // A quarter turn about the upper left corner, counter-clockwise: what was right of it is above it.
        let turned = image_from_uv([0.0; 2], std::f32::consts::FRAC_PI_2, [1.0; 2]);
        let [u, v] = apply(turned, [0.25, 1.0]);
        assert!(u.abs() < 1e-6 && (v - 1.25).abs() < 1e-6, "{u} {v}");
    }
}
