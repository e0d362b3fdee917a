//! Reads what materials reflect and let pass.

use oaktwin_scene::{Material, Transmission};

use super::super::super::value::{boolean, color, text};
use super::network::{Input, Node, input};
use super::surface::SurfaceReading;

impl SurfaceReading<'_> {
    /// Reads the index of refraction of a `UsdPreviewSurface`, and the reflectance of its specular workflow. Where its opacity is partial, it
    /// is a thin wall.
    pub(super) fn preview_optics(&mut self, shader: &Node, material: &mut Material) {
        self.index(shader, "inputs:ior", material);
        if self.number(shader, "inputs:useSpecularWorkflow") == Some(1.0) {
            material.metallic = 0.0;
            material.specular = Some(
                self.color_value(shader, "inputs:specularColor")
                    .unwrap_or([0.0; 3]),
            );
        }
    }

    /// Reads the transmission of a shader: the names of its weight, its colour (empty for the base colour), its index of refraction, and of
    /// the switch that makes it a thin wall.
    pub(super) fn transmission(
        &mut self,
        shader: &Node,
        [weight, tint, index, is_thin]: [&str; 4],
        material: &mut Material,
    ) {
        self.index(shader, &format!("inputs:{index}"), material);
        let name = format!("inputs:{weight}");
        let mut share = self.number(shader, &name).unwrap_or(0.0);
        self.report(Material::not_a_share(weight, share));
        let mut mask = None;
        if let Some(Input::Node(node)) = input(self.reader, &shader.shader, &name) {
            mask = self.mask(&node, weight, "its surface transmits nothing");
            if mask.is_some() {
                share = 1.0;
            }
        }
        if share > 0.0 {
            let white = || Some([1.0; 3]);
            material.transmission = Some(Transmission {
                share: share.min(1.0),
                mask,
                tint: match tint {
                    "" => None,
                    _ => self.color_value(shader, &format!("inputs:{tint}")).or_else(white),
                },
                refracts: !self.is_set(shader, &format!("inputs:{is_thin}")),
            });
        }
    }

    /// Reads `OmniGlass`, and materials with the same input names. Returns whether the shader is one.
    pub(super) fn mdl_glass(&mut self, shader: &Node, material: &mut Material) -> bool {
        let name = [
            "info:mdl:sourceAsset:subIdentifier",
            "info:sourceAsset:subIdentifier",
        ]
        .into_iter()
        .find_map(|name| self.reader.attribute_value(&shader.shader, name).and_then(text));
        let has = |name| input(self.reader, &shader.shader, name).is_some();
        let is_glass = name.is_some_and(|name| name.starts_with("OmniGlass")) || has("inputs:glass_color");
        if !is_glass {
            return false;
        }
        material.base_color = Some([1.0; 3]);
        material.roughness = self
            .number(shader, "inputs:frosting_roughness")
            .unwrap_or(0.0)
            .clamp(0.0, 1.0);
        material.index = OMNI_GLASS_INDEX;
        self.index(shader, "inputs:glass_ior", material);
        material.transmission = Some(Transmission {
            share: 1.0,
            mask: None,
            tint: Some(self.color_value(shader, "inputs:glass_color").unwrap_or([1.0; 3])),
            refracts: !self.is_set(shader, "inputs:thin_walled"),
        });
        self.mdl_opacity(shader, material);
        true
    }

    fn index(&mut self, shader: &Node, name: &str, material: &mut Material) {
        if let Some(index) = self.number(shader, name) {
            let problem = material.set_index(index);
            self.report(problem);
        }
    }

    fn color_value(&self, shader: &Node, name: &str) -> Option<[f32; 3]> {
        match input(self.reader, &shader.shader, name)? {
            Input::Value(value, _) => color(&value),
            Input::Node(_) => None,
        }
    }

    /// Whether a switch of a shader is on.
    pub(super) fn is_set(&self, shader: &Node, name: &str) -> bool {
        match input(self.reader, &shader.shader, name) {
            Some(Input::Value(value, _)) => boolean(&value) == Some(true),
            _ => false,
        }
    }

    /// Reports a number that cannot be meant.
    pub(super) fn report(&mut self, problem: Option<String>) {
        if let Some(problem) = problem {
            self.findings
                .warn("material-value", self.place, problem, "correct the number");
        }
    }
}

/// The default of `glass_ior` in `OmniGlass`.
const OMNI_GLASS_INDEX: f32 = 1.491;
