use std::collections::BTreeMap;
use std::sync::Arc;

use ::gltf::json;
use json::material::AlphaMode;
use json::texture::WrappingMode;
use json::validation::Checked;
use oaktwin_base::diagnostic::{Message, message};

use super::super::uri::{self, ResolvedUri};
use super::document::Document;
use crate::import::builder::Builder;
use crate::{
    ColorSpace, Material, Opacity, Texture, TextureMask, TextureSource, TextureUse, Transmission, Wrap,
};

/// The materials by their index in the file, with the properties that primitives need.
pub(super) struct Materials {
    list: Vec<MaterialInfo>,
}

#[derive(Clone, Copy)]
pub(super) struct MaterialInfo {
    /// Index into the scene's materials.
    pub(super) number: u32,
    /// The texture coordinate set of the base colour texture.
    pub(super) uv_set: Option<u32>,
    /// The factor that vertex colours are multiplied by.
    pub(super) factor: [f32; 3],
    pub(super) double_sided: bool,
}

impl Materials {
    pub(super) fn read(document: &Document, builder: &mut Builder) -> Self {
        let mut images = BTreeMap::new();
        let known = |(i, material): (usize, &json::Material)| {
            let pbr = &material.pbr_metallic_roughness;
            let [r, g, b, alpha] = pbr.base_color_factor.0;
            let factor = [r, g, b].map(finite);
            let name = material.name.clone().unwrap_or_else(|| format!("material_{i}"));
            let texture = pbr.base_color_texture.as_ref();
            let mut read_texture =
                |info, space| read_texture(document, info, space, &name, &mut images, builder);
            let (base_color_texture, mut uv_set) =
                match texture.and_then(|info| read_texture(info, ColorSpace::Srgb)) {
                    Some((texture, set)) => (Some(texture), Some(set)),
                    None => (None, None),
                };
            let of_transmission = transmission_image(material);
            let of_transmission = of_transmission.and_then(|info| read_texture(info, ColorSpace::Raw));
            let opacity = opacity(material, finite(alpha), base_color_texture);
            let mut read = Material {
                name: name.clone(),
                base_color: Some(factor),
                base_color_texture,
                emissive: material.emissive_factor.0.map(finite),
                metallic: finite(pbr.metallic_factor.0).clamp(0.0, 1.0),
                roughness: finite(pbr.roughness_factor.0).clamp(0.0, 1.0),
                opacity,
                ..Material::default()
            };
            let mut problems = vec![
                Material::not_a_share("metallic factor", pbr.metallic_factor.0),
                Material::not_a_share("roughness factor", pbr.roughness_factor.0),
            ];
            if opacity.is_some() {
                problems.push(Material::not_a_share("opacity", alpha));
            }
            problems.extend(read_optics(material, &mut read));
            for problem in problems.into_iter().flatten() {
                builder.warn("material-value", &name, problem);
            }
            if let (Some((texture, set)), Some(transmission)) = (of_transmission, &mut read.transmission) {
                if *uv_set.get_or_insert(set) == set {
                    transmission.mask = Some(TextureMask { texture, channel: 0 });
                } else {
                    let problem = format!(
                        "the image of its transmission has the texture coordinates {set}, other than its base colour; all of \
                         the surface transmits the share of its factor"
                    );
                    builder.warn("unsupported-material", &name, problem);
                }
            }
            let number = builder.add_material(read);
            MaterialInfo {
                number,
                uv_set,
                factor,
                double_sided: material.double_sided,
            }
        };
        Self {
            list: document.root.materials.iter().enumerate().map(known).collect(),
        }
    }

    pub(super) fn get(&self, index: usize) -> Option<MaterialInfo> {
        self.list.get(index).copied()
    }
}

/// Returns the image of a material that transmits more in some parts than in others.
fn transmission_image(material: &json::Material) -> Option<&json::texture::Info> {
    let transmission = material.extensions.as_ref()?.transmission.as_ref()?;
    transmission.transmission_texture.as_ref()
}

/// Reads the transmission and the index of refraction. Returns what is wrong with them.
fn read_optics(material: &json::Material, read: &mut Material) -> [Option<String>; 2] {
    let Some(extensions) = &material.extensions else {
        return [None, None];
    };
    let index = extensions.ior.as_ref().and_then(|ior| {
        // An index of 0 stands for an unlimited reflectance in old files.
        read.set_index(ior.ior.0)
    });
    let Some(transmission) = &extensions.transmission else {
        return [index, None];
    };
    let share = transmission.transmission_factor.0;
    let is_solid = |volume: &json::extensions::material::Volume| volume.thickness_factor.0 > 0.0;
    if share > 0.0 {
        read.transmission = Some(Transmission {
            share: share.min(1.0),
            mask: None,
            tint: None,
            refracts: extensions.volume.as_ref().is_some_and(is_solid),
        });
    }
    [index, Material::not_a_share("transmission factor", share)]
}

/// Returns where a material is invisible, or lets light pass. Solid ones ignore their opacity.
fn opacity(material: &json::Material, factor: f32, texture: Option<TextureUse>) -> Option<Opacity> {
    let threshold = match material.alpha_mode {
        Checked::Valid(AlphaMode::Mask) => material.alpha_cutoff.map_or(0.5, |cutoff| finite(cutoff.0)),
        Checked::Valid(AlphaMode::Blend) => 0.0,
        Checked::Valid(AlphaMode::Opaque) | Checked::Invalid => return None,
    };
    let mask = texture.map(|texture| TextureMask { texture, channel: 3 });
    Opacity::new(factor, mask, threshold)
}

fn finite(x: f32) -> f32 {
    if x.is_finite() { x } else { 0.0 }
}

/// The texture and its set of coordinates; `None`, with a finding, if the image is missing.
fn read_texture(
    document: &Document,
    info: &json::texture::Info,
    color_space: ColorSpace,
    material: &str,
    images: &mut BTreeMap<(usize, ColorSpace), Option<u32>>,
    builder: &mut Builder,
) -> Option<(TextureUse, u32)> {
    let Some(texture) = document.root.textures.get(info.index.value()) else {
        builder.warn(
            "texture-missing",
            material,
            "its texture does not exist in the file",
        );
        return None;
    };
    let image = texture.source.value();
    let number = *images
        .entry((image, color_space))
        .or_insert_with(|| match source(document, image) {
            Ok(source) => Some(builder.add_texture(Texture { source, color_space })),
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

fn source(document: &Document, image: usize) -> Result<TextureSource, Message> {
    let Some(entry) = document.root.images.get(image) else {
        return Err("the image does not exist in the file".into());
    };
    let name = entry.name.clone().unwrap_or_else(|| format!("images[{image}]"));
    let encoded = |bytes: &[u8]| TextureSource::Encoded {
        name,
        bytes: Arc::from(bytes),
    };
    match (&entry.uri, entry.buffer_view) {
        (_, Some(view)) => Ok(encoded(document.view(view.value())?.0)),
        (Some(uri), None) => match document.folder.resolve(uri) {
            ResolvedUri::Data(bytes) => Ok(encoded(&bytes)),
            ResolvedUri::File(file) if file.is_file() => Ok(TextureSource::File(file)),
            ResolvedUri::File(file) => Err(format!("{}: the image does not exist", file.display()).into()),
            ResolvedUri::Outside(file) => Err(message![
                format!(
                    "{}: the image is outside the folder of the glTF file; ",
                    file.display()
                ),
                uri::inside()
            ]),
            ResolvedUri::Unsupported(why) => Err(format!("the image has {why}").into()),
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

/// Converts `KHR_texture_transform` from coordinates with the origin at the upper left to the lower left.
///
/// It scales, rotates counter-clockwise as displayed, then translates, as does Khronos's own viewer. (The formula in the
/// extension's text rotates the other way.)
fn image_from_uv(offset: [f32; 2], rotation: f32, scale: [f32; 2]) -> [[f32; 3]; 2] {
    let (sine, cosine) = rotation.sin_cos();
    let ([su, sv], [ou, ov]) = (scale, offset);
    // With the origin at the top: u′ = c·su·u + s·sv·v + ou, v′ = −s·su·u + c·sv·v + ov. Then v becomes 1 − v on both sides.
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
    fn rotations_are_counter_clockwise_as_displayed() {
        assert_eq!(
            image_from_uv([0.0; 2], 0.0, [1.0; 2]),
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        );
        // The upper half of the image: v = 0 to v = 0.5 in glTF.
        let upper = image_from_uv([0.0, 0.0], 0.0, [1.0, 0.5]);
        assert_eq!(apply(upper, [0.0, 1.0]), [0.0, 1.0]);
        assert_eq!(apply(upper, [0.0, 0.0]), [0.0, 0.5]);
        // A quarter turn about the upper left corner, counter-clockwise: what was on its right is now above it.
        let turned = image_from_uv([0.0; 2], std::f32::consts::FRAC_PI_2, [1.0; 2]);
        let [u, v] = apply(turned, [0.25, 1.0]);
        assert!(u.abs() < 1e-6 && (v - 1.25).abs() < 1e-6, "{u} {v}");
    }
}
