use oaktwin_files as files;
use oaktwin_image::{CodecError, png, texture};
use oaktwin_scene::{ColorSpace, Material, Scene, TextureSource, TextureUse, Wrap};

use crate::text::{Attribute, Prim, Value};

const SCOPE: &str = "Looks";
/// Replaced by the path of the root once it is known.
const ROOT: &str = "/";

/// The materials and images of a scene.
pub(super) struct Materials<'a> {
    scene: &'a Scene,
    /// The path of each texture's image, as the layer names it.
    paths: Vec<String>,
    images: Vec<(String, Vec<u8>)>,
}

impl<'a> Materials<'a> {
    pub(super) fn new(scene: &'a Scene, folder: &str) -> Result<Self, CodecError> {
        let (mut paths, mut images) = (Vec::new(), Vec::new());
        for (i, image) in scene.textures.iter().enumerate() {
            let (extension, bytes) = match &image.source {
                TextureSource::File(path) => {
                    paths.push(files::with_slashes(path));
                    continue;
                }
                TextureSource::Encoded { bytes, .. } => match extension(bytes) {
                    Some(extension) => (extension, bytes.to_vec()),
                    None => ("png", png::encode(&texture::decode_srgb(bytes, None)?)?),
                },
                TextureSource::Pixels(image) => ("png", png::encode(image.as_ref())?),
            };
            let path = format!("./{folder}/texture_{i}.{extension}");
            images.push((path.clone(), bytes));
            paths.push(path);
        }
        Ok(Self { scene, paths, images })
    }

    pub(super) fn into_images(self) -> Vec<(String, Vec<u8>)> {
        self.images
    }

    /// The path of a texture's image.
    pub(super) fn image(&self, texture: u32) -> Option<&str> {
        self.paths.get(texture as usize).map(String::as_str)
    }

    /// Binds a material to a prim.
    pub(super) fn relate(&self, prim: &mut Prim, material: Option<u32>) {
        let Some(index) = material.filter(|index| self.scene.materials.len() > *index as usize) else {
            return;
        };
        prim.api_schemas.push("MaterialBindingAPI".into());
        prim.relate("material:binding", vec![format!("{ROOT}{SCOPE}/{}", name(index))]);
    }

    /// Adds the materials below the root, and completes the bindings of its descendants.
    pub(super) fn bind(&self, root: &mut Prim) {
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
        let mut looks = Prim::def("Scope", scope);
        for (index, material) in (0..).zip(&self.scene.materials) {
            looks
                .children
                .push(self.prim(material, name(index), &format!("{path}/{}", name(index))));
        }
        root.children.push(looks);
    }

    fn prim(&self, material: &Material, name: String, path: &str) -> Prim {
        let mut surface = shader("Surface", "UsdPreviewSurface");
        let mut prim = Prim::def("Material", name);
        prim.documentation = (!material.name.is_empty()).then(|| material.name.clone());
        let mut output = Attribute::without_value("outputs:surface", "token");
        output.connections = vec![format!("{path}/Surface.outputs:surface")];
        prim.add(output);
        surface.add(Attribute::without_value("outputs:surface", "token"));
        surface.set("inputs:emissiveColor", Value::Color3f(material.emissive));
        surface.set("inputs:metallic", Value::Float(material.metallic));
        surface.set("inputs:roughness", Value::Float(material.roughness));
        let mut nodes = Vec::new();
        if let Some((texture, file)) =
            (material.base_color_texture).and_then(|texture| Some((texture, self.image(texture.texture)?)))
        {
            let mut input = Attribute::without_value("inputs:diffuseColor", "color3f");
            input.connections = vec![format!("{path}/Texture.outputs:rgb")];
            surface.add(input);
            let space = self.scene.textures[texture.texture as usize].color_space;
            nodes = texture_nodes(&texture, file, space, material.base_color, path);
        } else if let Some(color) = material.base_color {
            surface.set("inputs:diffuseColor", Value::Color3f(color));
        } else {
            let mut input = Attribute::without_value("inputs:diffuseColor", "color3f");
            input.connections = vec![format!("{path}/Color.outputs:result")];
            surface.add(input);
            let mut reader = shader("Color", "UsdPrimvarReader_float3");
            reader.set("inputs:varname", Value::string("displayColor"));
            reader.add(Attribute::without_value("outputs:result", "float3"));
            nodes.push(reader);
        }
        prim.children.push(surface);
        prim.children.extend(nodes);
        prim
    }
}

/// The texture of the base colour, with the nodes that give its coordinates.
fn texture_nodes(
    used: &TextureUse,
    file: &str,
    space: ColorSpace,
    color: Option<[f32; 3]>,
    path: &str,
) -> Vec<Prim> {
    let mut image = shader("Texture", "UsdUVTexture");
    image.set("inputs:file", Value::Asset(file.to_owned()));
    let space = match space {
        ColorSpace::Auto => "auto",
        ColorSpace::Srgb => "sRGB",
        ColorSpace::Raw => "raw",
    };
    image.set("inputs:sourceColorSpace", Value::token(space));
    for (name, wrap) in [("wrapS", used.wrap_s), ("wrapT", used.wrap_t)] {
        let wrap = match wrap {
            Wrap::Repeat => "repeat",
            Wrap::Mirror => "mirror",
            Wrap::Clamp => "clamp",
            Wrap::Black => "black",
        };
        image.set(format!("inputs:{name}"), Value::token(wrap));
    }
    let factor = color.unwrap_or([1.0; 3]);
    for (name, values, alpha) in [("scale", used.scale, 1.0), ("bias", used.bias, 0.0)] {
        let [r, g, b]: [f32; 3] = std::array::from_fn(|i| values[i] * factor[i]);
        image.set(format!("inputs:{name}"), Value::Float4([r, g, b, alpha]));
    }
    image.add(Attribute::without_value("outputs:rgb", "float3"));
    let mut reader = shader("Coordinates", "UsdPrimvarReader_float2");
    reader.set("inputs:varname", Value::string("st"));
    reader.add(Attribute::without_value("outputs:result", "float2"));
    let is_plain = used.image_from_uv == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let node = if is_plain { "Coordinates" } else { "Transform" };
    let mut coordinates = Attribute::without_value("inputs:st", "float2");
    coordinates.connections = vec![format!("{path}/{node}.outputs:result")];
    image.add(coordinates);
    if is_plain {
        return vec![image, reader];
    }
    let [[a, b, x], [c, d, y]] = used.image_from_uv;
    let scale = a.hypot(c);
    let mut turn = shader("Transform", "UsdTransform2d");
    turn.set(
        "inputs:scale",
        Value::Float2([scale, (a * d - b * c) / scale.max(f32::MIN_POSITIVE)]),
    );
    turn.set("inputs:rotation", Value::Float(c.atan2(a).to_degrees()));
    turn.set("inputs:translation", Value::Float2([x, y]));
    let mut input = Attribute::without_value("inputs:in", "float2");
    input.connections = vec![format!("{path}/Coordinates.outputs:result")];
    turn.add(input);
    turn.add(Attribute::without_value("outputs:result", "float2"));
    vec![image, turn, reader]
}

fn shader(name: &str, id: &str) -> Prim {
    let mut shader = Prim::def("Shader", name);
    shader.set_uniform("info:id", Value::token(id));
    shader
}

fn name(material: u32) -> String {
    format!("material_{material}")
}

/// Completes the targets of bindings in a prim and its descendants.
fn rebind(prim: &mut Prim, scope: &str) {
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
