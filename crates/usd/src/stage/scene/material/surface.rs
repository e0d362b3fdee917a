use oaktwin_scene::{Material, Texture, TextureUse, Wrap};

use super::super::super::reader::Reader;
use super::super::super::value::{color, number, single, text, vec2, vec4};
use super::super::findings::Findings;
use super::network::{Input, Node, input};
use super::texture::Textures;
use super::{identifier, uv};

/// The base colour of unsupported materials.
pub(super) const GREY: [f32; 3] = [0.18; 3];
/// `UsdPreviewSurface`'s fallback for the diffuse colour.
const PREVIEW_DIFFUSE: [f32; 3] = [0.18; 3];
/// The maximum number of pass-through nodes that are followed.
pub(super) const MAX_DEPTH: usize = 16;

/// The state of reading one material.
pub(super) struct SurfaceReading<'a> {
    pub(super) reader: &'a Reader,
    /// The material's path.
    pub(super) place: &'a str,
    pub(super) textures: &'a mut Textures,
    pub(super) scene_textures: &'a mut Vec<Texture>,
    pub(super) findings: &'a mut Findings,
    /// The primvar with the base colour's texture coordinates.
    pub(super) uv: Option<String>,
}

impl SurfaceReading<'_> {
    /// Reads a surface shader. Returns whether it is supported.
    pub(super) fn shader(&mut self, shader: &Node, material: &mut Material) -> bool {
        let id = identifier(self.reader, shader);
        match id.as_str() {
            "UsdPreviewSurface" | "ND_UsdPreviewSurface_surfaceshader" => {
                material.base_color = Some(PREVIEW_DIFFUSE);
                self.base_color(shader, "inputs:diffuseColor", material);
                self.common(
                    shader,
                    material,
                    ["inputs:metallic", "inputs:roughness", "inputs:emissiveColor"],
                );
                let threshold = self.number(shader, "inputs:opacityThreshold").unwrap_or(0.0);
                self.opacity(shader, "inputs:opacity", threshold, material);
                self.preview_optics(shader, material);
                true
            }
            "ND_standard_surface_surfaceshader" => {
                self.standard_surface(shader, material);
                true
            }
            "ND_open_pbr_surface_surfaceshader" => {
                self.open_pbr(shader, material);
                true
            }
            "ND_gltf_pbr_surfaceshader" => {
                self.gltf_pbr(shader, material);
                true
            }
            _ if self.mdl_glass(shader, material) => true,
            _ => {
                let what = if id.is_empty() {
                    "in source code (MDL or other)".to_owned()
                } else {
                    format!("`{id}`")
                };
                let (understood, instead) = if self.mdl_diffuse(shader, material) {
                    (true, "only its diffuse inputs are used")
                } else {
                    (false, "using grey")
                };
                self.findings.warn(
                    "unsupported-material",
                    self.place,
                    format!("its surface shader {what} is not supported; {instead}"),
                    "add a UsdPreviewSurface or a MaterialX standard surface",
                );
                understood
            }
        }
    }

    /// Reads a standard surface of `MaterialX`.
    fn standard_surface(&mut self, shader: &Node, material: &mut Material) {
        material.base_color = Some([0.8; 3]);
        self.base_color(shader, "inputs:base_color", material);
        self.weight(shader, "inputs:base", material);
        material.roughness = 0.2;
        self.common(
            shader,
            material,
            ["inputs:metalness", "inputs:specular_roughness", ""],
        );
        self.emission(shader, "inputs:emission", "inputs:emission_color", material);
        self.opacity(shader, "inputs:opacity", 0.0, material);
        let names = [
            "transmission",
            "transmission_color",
            "specular_IOR",
            "thin_walled",
        ];
        self.transmission(shader, names, material);
    }

    /// Reads an `OpenPBR` surface.
    fn open_pbr(&mut self, shader: &Node, material: &mut Material) {
        material.base_color = Some([0.8; 3]);
        self.base_color(shader, "inputs:base_color", material);
        self.weight(shader, "inputs:base_weight", material);
        material.roughness = 0.3;
        self.common(
            shader,
            material,
            ["inputs:base_metalness", "inputs:specular_roughness", ""],
        );
        self.opacity(shader, "inputs:geometry_opacity", 0.0, material);
        let names = [
            "transmission_weight",
            "transmission_color",
            "specular_ior",
            "geometry_thin_walled",
        ];
        self.transmission(shader, names, material);
    }

    /// Reads the surface of glTF in `MaterialX`.
    fn gltf_pbr(&mut self, shader: &Node, material: &mut Material) {
        material.base_color = Some([1.0; 3]);
        material.metallic = 1.0;
        material.roughness = 1.0;
        self.base_color(shader, "inputs:base_color", material);
        self.common(
            shader,
            material,
            ["inputs:metallic", "inputs:roughness", "inputs:emissive"],
        );
        self.gltf_opacity(shader, material);
        self.transmission(shader, ["transmission", "", "ior", ""], material);
        if self
            .number(shader, "inputs:thickness")
            .is_none_or(|thickness| thickness <= 0.0)
            && let Some(transmission) = &mut material.transmission
        {
            transmission.refracts = false;
        }
    }

    /// Reads the diffuse inputs of `OmniPBR`, the most common MDL material in Isaac Sim's assets, and of materials with
    /// the same input names. Returns whether there are any.
    fn mdl_diffuse(&mut self, shader: &Node, material: &mut Material) -> bool {
        let constant = self.color_input(shader, "inputs:diffuse_color_constant");
        let tint = self
            .color_input(shader, "inputs:diffuse_tint")
            .unwrap_or([1.0; 3]);
        let named = |value: &openusd::sdf::Value| !matches!(value, openusd::sdf::Value::AssetPath(asset) if asset.is_empty());
        let file = match input(self.reader, &shader.shader, "inputs:diffuse_texture") {
            Some(Input::Value(value, _)) => named(&value),
            _ => false,
        };
        let texture = file
            .then(|| self.image(shader, "inputs:diffuse_texture", None))
            .flatten();
        if let Some(texture) = texture {
            material.base_color_texture = Some(TextureUse::new(texture));
            material.base_color = Some(tint);
        } else if let Some([r, g, b]) = constant {
            material.base_color = Some([r * tint[0], g * tint[1], b * tint[2]]);
        } else {
            return false;
        }
        self.common(
            shader,
            material,
            [
                "inputs:metallic_constant",
                "inputs:reflection_roughness_constant",
                "",
            ],
        );
        self.mdl_opacity(shader, material);
        true
    }

    pub(super) fn number(&self, shader: &Node, name: &str) -> Option<f32> {
        match input(self.reader, &shader.shader, name)? {
            Input::Value(value, _) => single(&value),
            Input::Node(_) => None,
        }
    }

    /// Reads metalness, roughness and emission. Textured inputs keep their fallbacks.
    fn common(&mut self, shader: &Node, material: &mut Material, [metallic, roughness, emissive]: [&str; 3]) {
        if let Some(metallic) = self.number(shader, metallic) {
            material.metallic = metallic.clamp(0.0, 1.0);
        }
        if let Some(roughness) = self.number(shader, roughness) {
            material.roughness = roughness.clamp(0.0, 1.0);
        }
        if !emissive.is_empty()
            && let Some(Input::Value(value, _)) = input(self.reader, &shader.shader, emissive)
            && let Some(emissive) = color(&value)
        {
            material.emissive = emissive;
        }
    }

    fn emission(&mut self, shader: &Node, weight: &str, tint: &str, material: &mut Material) {
        let weight = self.number(shader, weight).unwrap_or(0.0);
        let tint = match input(self.reader, &shader.shader, tint) {
            Some(Input::Value(value, _)) => color(&value),
            _ => None,
        };
        material.emissive = tint.unwrap_or([1.0; 3]).map(|channel| channel * weight);
    }

    /// Multiplies the base colour by a weight.
    fn weight(&mut self, shader: &Node, name: &str, material: &mut Material) {
        let weight = self.number(shader, name).unwrap_or(1.0);
        if let Some(color) = &mut material.base_color {
            *color = color.map(|channel| channel * weight);
        }
    }

    /// Reads the base colour: a value, an image or the mesh's own colours.
    fn base_color(&mut self, shader: &Node, name: &str, material: &mut Material) {
        match input(self.reader, &shader.shader, name) {
            None => {}
            Some(Input::Value(value, _)) => {
                if let Some(value) = color(&value) {
                    material.base_color = Some(value);
                }
            }
            Some(Input::Node(node)) => self.color_of(&node, material, 0),
        }
    }

    fn color_of(&mut self, node: &Node, material: &mut Material, depth: usize) {
        let id = identifier(self.reader, node);
        if id == "UsdUVTexture" {
            self.preview_texture(node, material);
        } else if id.starts_with("ND_image_") || id.starts_with("ND_tiledimage_") {
            self.materialx_image(node, material);
        } else if id.starts_with("UsdPrimvarReader_") || id.starts_with("ND_geompropvalue_") {
            self.mesh_color(node, material);
        } else if let Some(next) = self.passes_on(node).filter(|_| depth < MAX_DEPTH) {
            match next {
                Input::Node(next) => self.color_of(&next, material, depth + 1),
                Input::Value(value, _) => material.base_color = color(&value).or(material.base_color),
            }
        } else {
            self.findings.warn(
                "unsupported-material",
                self.place,
                format!("its base colour node `{id}` is not supported"),
                "connect an image or author a colour",
            );
        }
    }

    /// Returns the colour input of an arithmetic node.
    pub(super) fn passes_on(&self, node: &Node) -> Option<Input> {
        const COLORS: [&str; 6] = [
            "inputs:in",
            "inputs:in1",
            "inputs:fg",
            "inputs:value",
            "inputs:in2",
            "inputs:bg",
        ];
        let mut inputs: Vec<Input> = COLORS
            .iter()
            .filter_map(|name| input(self.reader, &node.shader, name))
            .collect();
        let image = inputs.iter().position(|input| matches!(input, Input::Node(_)));
        (!inputs.is_empty()).then(|| inputs.swap_remove(image.unwrap_or(0)))
    }

    /// Reads a base colour that is a primvar of the mesh.
    fn mesh_color(&mut self, node: &Node, material: &mut Material) {
        let name = ["inputs:varname", "inputs:geomprop"]
            .into_iter()
            .find_map(|name| match input(self.reader, &node.shader, name)? {
                Input::Value(value, _) => text(value),
                Input::Node(_) => None,
            });
        let fallback = ["inputs:fallback", "inputs:default"]
            .into_iter()
            .find_map(|name| match input(self.reader, &node.shader, name)? {
                Input::Value(value, _) => color(&value),
                Input::Node(_) => None,
            });
        match name.as_deref() {
            Some("displayColor") => material.base_color = None,
            _ => {
                material.base_color = fallback.or(material.base_color);
                let name = name.unwrap_or_default();
                self.findings.warn(
                    "unsupported-material",
                    self.place,
                    format!("its base colour is the primvar `{name}`, which is not supported"),
                    "use displayColor",
                );
            }
        }
    }

    pub(super) fn token(&self, node: &Node, name: &str) -> Option<String> {
        match input(self.reader, &node.shader, name)? {
            Input::Value(value, _) => text(value),
            Input::Node(_) => None,
        }
    }

    fn preview_texture(&mut self, node: &Node, material: &mut Material) {
        match self.preview_image(node) {
            Some(texture) => self.paint(texture, material),
            None => {
                material.base_color = Some(self.color_input(node, "inputs:fallback").unwrap_or([0.0; 3]));
            }
        }
    }

    fn materialx_image(&mut self, node: &Node, material: &mut Material) {
        match self.materialx_texture(node) {
            Some(texture) => self.paint(texture, material),
            None => {
                material.base_color = Some(self.color_input(node, "inputs:default").unwrap_or([0.0; 3]));
            }
        }
    }

    fn paint(&mut self, (texture, uv): (TextureUse, Option<String>), material: &mut Material) {
        material.base_color_texture = Some(texture);
        material.base_color = Some([1.0; 3]);
        self.uv = uv;
    }

    /// Returns the texture of a `UsdUVTexture`, and the primvar with its coordinates.
    pub(super) fn preview_image(&mut self, node: &Node) -> Option<(TextureUse, Option<String>)> {
        let space = self.token(node, "inputs:sourceColorSpace");
        let texture = self.image(node, "inputs:file", space.as_deref())?;
        let wrap = |name| match self.token(node, name).as_deref() {
            Some("clamp") => Wrap::Clamp,
            Some("mirror") => Wrap::Mirror,
            Some("black") => Wrap::Black,
            _ => Wrap::Repeat,
        };
        let four = |name| match input(self.reader, &node.shader, name)? {
            Input::Value(value, _) => vec4(&value),
            Input::Node(_) => None,
        };
        let placed = uv::placement(self.reader, node, "inputs:st");
        let used = TextureUse {
            image_from_uv: placed.image_from_uv,
            scale: four("inputs:scale").unwrap_or([1.0; 4]),
            bias: four("inputs:bias").unwrap_or([0.0; 4]),
            wrap_s: wrap("inputs:wrapS"),
            wrap_t: wrap("inputs:wrapT"),
            ..TextureUse::new(texture)
        };
        Some((used, placed.primvar))
    }

    /// Returns the texture of a `MaterialX` image, and the primvar with its coordinates.
    pub(super) fn materialx_texture(&mut self, node: &Node) -> Option<(TextureUse, Option<String>)> {
        let space = self.token(node, "inputs:sourceColorSpace");
        let texture = self.image(node, "inputs:file", space.as_deref())?;
        let wrap = |name| match self.token(node, name).as_deref() {
            Some("clamp") => Wrap::Clamp,
            Some("mirror") => Wrap::Mirror,
            Some("constant") => Wrap::Black,
            _ => Wrap::Repeat,
        };
        let mut placed = uv::placement(self.reader, node, "inputs:texcoord");
        if let Some(Input::Value(value, _)) = input(self.reader, &node.shader, "inputs:uvtiling")
            && let Some(tiling) = vec2(&value)
        {
            placed = placed.tiled(tiling);
        }
        let used = TextureUse {
            image_from_uv: placed.image_from_uv,
            wrap_s: wrap("inputs:uaddressmode"),
            wrap_t: wrap("inputs:vaddressmode"),
            ..TextureUse::new(texture)
        };
        Some((used, placed.primvar))
    }

    fn color_input(&self, node: &Node, name: &str) -> Option<[f32; 3]> {
        match input(self.reader, &node.shader, name)? {
            Input::Value(value, _) => color(&value).or_else(|| {
                let grey = number(&value)?;
                #[expect(clippy::cast_possible_truncation, reason = "colours have single precision")]
                Some([grey as f32; 3])
            }),
            Input::Node(_) => None,
        }
    }

    /// Returns the texture of a node's file input.
    pub(super) fn image(&mut self, node: &Node, name: &str, space: Option<&str>) -> Option<u32> {
        let Some(Input::Value(value, attribute)) = input(self.reader, &node.shader, name) else {
            self.findings.warn(
                "missing-texture",
                self.place,
                "its texture has no file",
                "author an image file",
            );
            return None;
        };
        self.textures.add(
            self.reader,
            value,
            &attribute,
            space,
            self.place,
            self.scene_textures,
            self.findings,
        )
    }
}
