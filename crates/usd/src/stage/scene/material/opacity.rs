//! Reads where a surface is invisible.

use oaktwin_scene::{Material, Opacity, TextureMask, TextureUse};

use super::super::super::value::{color, single};
use super::identifier;
use super::network::{Input, Node, input};
use super::surface::{MAX_DEPTH, SurfaceReading};

impl SurfaceReading<'_> {
    /// Reads the opacity of a surface shader.
    pub(super) fn opacity(&mut self, shader: &Node, name: &str, threshold: f32, material: &mut Material) {
        match input(self.reader, &shader.shader, name) {
            None => {}
            Some(Input::Value(value, _)) => {
                // Colours have an opacity for each channel.
                let mean = |[r, g, b]: [f32; 3]| (r + g + b) / 3.0;
                if let Some(value) = single(&value).or_else(|| color(&value).map(mean)) {
                    self.cut(value, None, threshold, material);
                }
            }
            Some(Input::Node(node)) => {
                if let Some(mask) = self.mask(&node, "opacity", "its surface is solid") {
                    self.cut(1.0, Some(mask), threshold, material);
                }
            }
        }
    }

    /// Returns the image to which an input is connected. Reports another node, with what is the case `otherwise`.
    pub(super) fn mask(&mut self, node: &Node, name: &str, otherwise: &str) -> Option<TextureMask> {
        let mask = self.mask_of(node, 0);
        if mask.is_none() {
            let id = identifier(self.reader, node);
            self.findings.warn(
                "unsupported-material",
                self.place,
                format!("its {name} node `{id}` is not supported; {otherwise}"),
                "connect an image or author a number",
            );
        }
        mask
    }

    /// Reads the opacity of `gltf_pbr`, whose mode is 0 for solid, 1 for masked and 2 for translucent surfaces.
    pub(super) fn gltf_opacity(&mut self, shader: &Node, material: &mut Material) {
        let threshold = match self.number(shader, "inputs:alpha_mode") {
            Some(1.0) => self.number(shader, "inputs:alpha_cutoff").unwrap_or(0.5),
            Some(2.0) => 0.0,
            _ => return,
        };
        self.opacity(shader, "inputs:alpha", threshold, material);
    }

    /// Reads the opacity of `OmniPBR`.
    pub(super) fn mdl_opacity(&mut self, shader: &Node, material: &mut Material) {
        if !self.is_set(shader, "inputs:enable_opacity") {
            return;
        }
        let threshold = self.number(shader, "inputs:opacity_threshold").unwrap_or(0.0);
        if self.is_set(shader, "inputs:enable_opacity_texture") {
            // Mode 0 is the image's opacity; the others are brightnesses.
            let is_alpha = self.number(shader, "inputs:opacity_mode") == Some(0.0);
            if let Some(texture) = self.image(shader, "inputs:opacity_texture", None) {
                let mask = TextureMask {
                    texture: TextureUse::new(texture),
                    channel: if is_alpha { 3 } else { 0 },
                };
                self.cut(1.0, Some(mask), threshold, material);
            }
        } else {
            let value = self.number(shader, "inputs:opacity_constant").unwrap_or(1.0);
            self.cut(value, None, threshold, material);
        }
    }

    fn mask_of(&mut self, node: &Node, depth: usize) -> Option<TextureMask> {
        let id = identifier(self.reader, node);
        let is_preview = id == "UsdUVTexture";
        if is_preview || id.starts_with("ND_image_") || id.starts_with("ND_tiledimage_") {
            let (texture, uv) = match is_preview {
                true => self.preview_image(node)?,
                false => self.materialx_texture(node)?,
            };
            if self.uv.is_none() {
                self.uv = uv;
            }
            let channel = if is_preview { channel(&node.output) } else { 0 };
            return Some(TextureMask { texture, channel });
        }
        let Input::Node(next) = self.passes_on(node).filter(|_| depth < MAX_DEPTH)? else {
            return None;
        };
        let mut mask = self.mask_of(&next, depth + 1)?;
        if id.starts_with("ND_separate") {
            mask.channel = channel(node.output.trim_start_matches("out"));
        } else if id.starts_with("ND_extract_") {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "an index from 0 to 3"
            )]
            let index = self.number(node, "inputs:index").unwrap_or(0.0).clamp(0.0, 3.0) as u8;
            mask.channel = index;
        } else if id.starts_with("ND_swizzle_") {
            mask.channel = channel(&self.token(node, "inputs:channels").unwrap_or_default());
        }
        Some(mask)
    }

    /// Makes a surface invisible, or lets light pass, where its opacity is low.
    fn cut(&mut self, value: f32, mask: Option<TextureMask>, threshold: f32, material: &mut Material) {
        self.report(Material::not_a_share("opacity", value));
        material.opacity = Opacity::new(value, mask, threshold);
    }
}

/// Returns the index of the channel that an output is named after; red for others.
fn channel(name: &str) -> u8 {
    match name {
        "g" | "y" => 1,
        "b" | "z" => 2,
        "a" | "w" => 3,
        _ => 0,
    }
}
