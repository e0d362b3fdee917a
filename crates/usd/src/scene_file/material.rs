use oaktwin_files as files;
use oaktwin_image::{CodecError, png, texture};
use oaktwin_scene::{
    ColorSpace, DEFAULT_INDEX, LightKind, Material, Opacity, Scene, TextureMask, TextureSource, TextureUse,
    Wrap,
};

use super::ImageFiles;
use crate::text::{AttributeSpec, PrimSpec, SpecValue};

/// The outputs of an image.
const CHANNELS: [&str; 4] = ["r", "g", "b", "a"];
const SCOPE: &str = "Looks";
/// The opacity of clear materials: a surface of opacity 0 would be cut out.
const MIN_OPACITY: f32 = 0.01;
/// The maximum size of an image file that is copied.
const MAX_BYTES: u64 = 1 << 30;
/// Replaced by the path of the root once it is known.
const ROOT: &str = "/";

/// The materials and images of a scene.
pub(super) struct Materials<'a> {
    scene: &'a Scene,
    /// The path of each used texture's image, as the layer names it.
    paths: Vec<Option<String>>,
    images: Vec<(String, Vec<u8>)>,
}

impl<'a> Materials<'a> {
    pub(super) fn new(scene: &'a Scene, folder: &str, image_files: ImageFiles) -> Result<Self, CodecError> {
        let mut paths = vec![None; scene.textures.len()];
        let mut images: Vec<(String, Vec<u8>)> = Vec::new();
        for index in used_textures(scene) {
            let Some(texture) = scene.textures.get(index) else {
                continue;
            };
            if paths[index].is_some() {
                continue;
            }
            paths[index] = Some(match encoded(&texture.source, image_files)? {
                Image::At(path) => path,
                Image::Beside(extension, bytes) => {
                    let path = format!("./{folder}/texture_{}.{extension}", images.len());
                    images.push((path.clone(), bytes));
                    path
                }
            });
        }
        Ok(Self { scene, paths, images })
    }

    pub(super) fn into_images(self) -> Vec<(String, Vec<u8>)> {
        self.images
    }

    /// The path of a texture's image.
    pub(super) fn image(&self, texture: u32) -> Option<&str> {
        self.paths.get(texture as usize)?.as_deref()
    }

    /// Binds a material to a prim.
    pub(super) fn relate(&self, prim: &mut PrimSpec, material: Option<u32>) {
        let Some(index) = material.filter(|index| self.scene.materials.len() > *index as usize) else {
            return;
        };
        prim.api_schemas.push("MaterialBindingAPI".into());
        prim.relate("material:binding", vec![format!("{ROOT}{SCOPE}/{}", name(index))]);
    }

    /// Adds the materials below the root, and completes the bindings of its descendants.
    pub(super) fn bind(&self, root: &mut PrimSpec) {
        if self.scene.materials.is_empty() {
            return;
        }
        let taken = |name: &str| root.child(name).is_some();
        let mut scope = SCOPE.to_owned();
        while taken(&scope) {
            scope.push('_');
        }
        let path = format!("/{}/{scope}", root.name);
        rebind(root, &path);
        let mut looks = PrimSpec::def("Scope", scope);
        for (index, material) in (0..).zip(&self.scene.materials) {
            looks
                .children
                .push(self.prim(material, name(index), &format!("{path}/{}", name(index))));
        }
        root.children.push(looks);
    }

    /// Adds an opacity to a surface. Returns the nodes of its mask.
    fn opacity(&self, opacity: &Opacity, surface: &mut PrimSpec, path: &str) -> Vec<PrimSpec> {
        surface.set("inputs:opacityThreshold", SpecValue::Float(opacity.threshold));
        let image = opacity
            .mask
            .and_then(|mask| Some((mask, self.image(mask.texture.texture)?)));
        let Some((mask, file)) = image else {
            surface.set("inputs:opacity", SpecValue::Float(opacity.value));
            return Vec::new();
        };
        let mut used = mask.texture;
        let channel = usize::from(mask.channel & 3);
        used.scale[channel] *= opacity.value;
        used.bias[channel] *= opacity.value;
        let mut input = AttributeSpec::without_value("inputs:opacity", "float");
        input.connections = vec![format!("{path}/Mask.outputs:{}", CHANNELS[channel])];
        surface.add(input);
        let space = self.scene.textures[used.texture as usize].color_space;
        let names = ["Mask", "MaskCoordinates", "MaskTransform"];
        texture_nodes(names, &used, file, space, None, path)
    }

    fn prim(&self, material: &Material, name: String, path: &str) -> PrimSpec {
        let mut surface = shader("Surface", "UsdPreviewSurface");
        let mut prim = PrimSpec::def("Material", name);
        prim.documentation = (!material.name.is_empty()).then(|| material.name.clone());
        let mut output = AttributeSpec::without_value("outputs:surface", "token");
        output.connections = vec![format!("{path}/Surface.outputs:surface")];
        prim.add(output);
        surface.add(AttributeSpec::without_value("outputs:surface", "token"));
        surface.set("inputs:emissiveColor", SpecValue::Color3f(material.emissive));
        surface.set("inputs:metallic", SpecValue::Float(material.metallic));
        surface.set("inputs:roughness", SpecValue::Float(material.roughness));
        let mut nodes = Vec::new();
        if let Some((texture, file)) =
            (material.base_color_texture).and_then(|texture| Some((texture, self.image(texture.texture)?)))
        {
            let mut input = AttributeSpec::without_value("inputs:diffuseColor", "color3f");
            input.connections = vec![format!("{path}/Texture.outputs:rgb")];
            surface.add(input);
            let space = self.scene.textures[texture.texture as usize].color_space;
            let names = ["Texture", "Coordinates", "Transform"];
            nodes = texture_nodes(names, &texture, file, space, material.base_color, path);
        } else if let Some(color) = material.base_color {
            surface.set("inputs:diffuseColor", SpecValue::Color3f(color));
        } else {
            let mut input = AttributeSpec::without_value("inputs:diffuseColor", "color3f");
            input.connections = vec![format!("{path}/Color.outputs:result")];
            surface.add(input);
            let mut reader = shader("Color", "UsdPrimvarReader_float3");
            reader.set("inputs:varname", SpecValue::string("displayColor"));
            reader.add(AttributeSpec::without_value("outputs:result", "float3"));
            nodes.push(reader);
        }
        if material.index.to_bits() != DEFAULT_INDEX.to_bits() {
            surface.set("inputs:ior", SpecValue::Float(material.index));
        }
        if let Some(specular) = material.specular {
            surface.set("inputs:useSpecularWorkflow", SpecValue::Int(1));
            surface.set("inputs:specularColor", SpecValue::Color3f(specular));
        }
        // The shader knows thin walls only, and nothing else than opacity.
        if let Some(opacity) = &material.opacity {
            nodes.extend(self.opacity(opacity, &mut surface, path));
        } else if let Some(transmission) = &material.transmission {
            let opacity = (1.0 - transmission.share).max(MIN_OPACITY);
            match transmission.mask {
                None => surface.set("inputs:opacity", SpecValue::Float(opacity)),
                Some(mask) => {
                    let mask = opposite(mask, 1.0 - opacity);
                    nodes.extend(self.opacity(&mask, &mut surface, path));
                }
            }
        }
        prim.children.push(surface);
        prim.children.extend(nodes);
        prim
    }
}

/// Where the image of a texture is to be found.
enum Image {
    /// At a path.
    At(String),
    /// Beside the layer, with this extension and these bytes.
    Beside(&'static str, Vec<u8>),
}

fn encoded(source: &TextureSource, image_files: ImageFiles) -> Result<Image, CodecError> {
    let (extension, bytes) = match source {
        TextureSource::File(path) => {
            if image_files == ImageFiles::Referenced {
                return Ok(Image::At(files::with_slashes(path)));
            }
            let unreadable = |error: std::io::Error| CodecError {
                format: "image",
                place: path.display().to_string().into(),
                problem: format!("cannot be read ({error})"),
                remedy: "restore the file".into(),
            };
            let bytes = files::read_regular(path, MAX_BYTES).map_err(unreadable)?;
            match extension(&bytes) {
                Some(extension) => (extension, bytes),
                None => {
                    let place = std::path::absolute(path).map_err(unreadable)?;
                    return Ok(Image::At(files::with_slashes(&place)));
                }
            }
        }
        TextureSource::Encoded { bytes, .. } => match extension(bytes) {
            Some(extension) => (extension, bytes.to_vec()),
            None => ("png", png::encode(&texture::decode_srgb(bytes, None)?)?),
        },
        TextureSource::Pixels(image) => ("png", png::encode(image.as_ref())?),
    };
    Ok(Image::Beside(extension, bytes))
}

/// Returns the opacity of a surface that transmits a share of light, multiplied by a mask.
fn opposite(mut mask: TextureMask, share: f32) -> Opacity {
    let channel = usize::from(mask.channel & 3);
    let used = &mut mask.texture;
    used.scale[channel] *= -share;
    used.bias[channel] = 1.0 - share * used.bias[channel];
    Opacity {
        value: 1.0,
        mask: Some(mask),
        threshold: 0.0,
    }
}

/// Returns the indices of the textures of materials and lights, in order; some appear several times.
fn used_textures(scene: &Scene) -> impl Iterator<Item = usize> {
    let of_materials = scene.materials.iter().flat_map(|material| {
        let masks = material.masks().map(|mask| mask.texture);
        let used = material.base_color_texture.into_iter().chain(masks);
        used.map(|used| used.texture)
    });
    let of_lights = scene.lights.iter().filter_map(|light| match light.kind {
        LightKind::Dome { texture, .. } => texture,
        _ => None,
    });
    of_materials.chain(of_lights).map(|texture| texture as usize)
}

/// A texture, with the nodes that give its coordinates.
fn texture_nodes(
    [image_name, reader_name, transform_name]: [&str; 3],
    used: &TextureUse,
    file: &str,
    space: ColorSpace,
    color: Option<[f32; 3]>,
    path: &str,
) -> Vec<PrimSpec> {
    let mut image = shader(image_name, "UsdUVTexture");
    image.set("inputs:file", SpecValue::Asset(file.to_owned()));
    let space = match space {
        ColorSpace::Auto => "auto",
        ColorSpace::Srgb => "sRGB",
        ColorSpace::Raw => "raw",
    };
    image.set("inputs:sourceColorSpace", SpecValue::token(space));
    for (name, wrap) in [("wrapS", used.wrap_s), ("wrapT", used.wrap_t)] {
        let wrap = match wrap {
            Wrap::Repeat => "repeat",
            Wrap::Mirror => "mirror",
            Wrap::Clamp => "clamp",
            Wrap::Black => "black",
        };
        image.set(format!("inputs:{name}"), SpecValue::token(wrap));
    }
    let factor = color.unwrap_or([1.0; 3]);
    for (name, values) in [("scale", used.scale), ("bias", used.bias)] {
        let [r, g, b, a] = values;
        let [x, y, z] = factor;
        image.set(
            format!("inputs:{name}"),
            SpecValue::Float4([r * x, g * y, b * z, a]),
        );
    }
    image.add(AttributeSpec::without_value("outputs:rgb", "float3"));
    for channel in CHANNELS {
        image.add(AttributeSpec::without_value(
            format!("outputs:{channel}"),
            "float",
        ));
    }
    let mut reader = shader(reader_name, "UsdPrimvarReader_float2");
    reader.set("inputs:varname", SpecValue::string("st"));
    reader.add(AttributeSpec::without_value("outputs:result", "float2"));
    let is_plain = used.image_from_uv == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let node = if is_plain { reader_name } else { transform_name };
    let mut coordinates = AttributeSpec::without_value("inputs:st", "float2");
    coordinates.connections = vec![format!("{path}/{node}.outputs:result")];
    image.add(coordinates);
    if is_plain {
        return vec![image, reader];
    }
    let [[a, b, x], [c, d, y]] = used.image_from_uv;
    let scale = a.hypot(c);
    let mut turn = shader(transform_name, "UsdTransform2d");
    turn.set(
        "inputs:scale",
        SpecValue::Float2([scale, (a * d - b * c) / scale.max(f32::MIN_POSITIVE)]),
    );
    turn.set("inputs:rotation", SpecValue::Float(c.atan2(a).to_degrees()));
    turn.set("inputs:translation", SpecValue::Float2([x, y]));
    let mut input = AttributeSpec::without_value("inputs:in", "float2");
    input.connections = vec![format!("{path}/{reader_name}.outputs:result")];
    turn.add(input);
    turn.add(AttributeSpec::without_value("outputs:result", "float2"));
    vec![image, turn, reader]
}

fn shader(name: &str, id: &str) -> PrimSpec {
    let mut shader = PrimSpec::def("Shader", name);
    shader.set_uniform("info:id", SpecValue::token(id));
    shader
}

fn name(material: u32) -> String {
    format!("material_{material}")
}

/// Completes the targets of bindings in a prim and its descendants.
fn rebind(prim: &mut PrimSpec, scope: &str) {
    for property in &mut prim.properties {
        if let crate::text::Property::Relationship(relationship) = property {
            for target in &mut relationship.targets {
                if let Some(rest) = target.strip_prefix(&format!("{ROOT}{SCOPE}")) {
                    *target = format!("{scope}{rest}");
                }
            }
        }
    }
    for child in &mut prim.children {
        rebind(child, scope);
    }
}

/// The extension of an encoded image that USD supports.
fn extension(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Some("png"),
        [0xff, 0xd8, 0xff, ..] => Some("jpg"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_transmits_is_not_opaque() {
        let mut texture = TextureUse::new(0);
        (texture.scale[1], texture.bias[1]) = (0.5, 0.25);
        let opacity = opposite(TextureMask { texture, channel: 1 }, 0.75);
        let used = opacity.mask.unwrap().texture;
        for value in [0.0, 0.5, 1.0_f32] {
            let transmitted = 0.75 * (0.5 * value + 0.25);
            let found = opacity.at(used.scale[1] * value + used.bias[1]);
            assert!((found + transmitted - 1.0).abs() < 1e-6, "{value}: {found}");
        }
    }
}
