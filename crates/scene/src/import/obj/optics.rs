//! The statements of MTL files about transparency and mirrors.

use super::words::{color, number};
use crate::import::builder::Builder;
use crate::import::text;
use crate::{Material, Opacity, Transmission};

/// What the statements of a material say.
#[derive(Default)]
pub(super) struct Optics {
    dissolve: Option<f32>,
    transparency: Option<f32>,
    index: Option<f32>,
    model: Option<f32>,
    specular: Option<[f32; 3]>,
    filter: Option<[f32; 3]>,
    has_roughness: bool,
}

impl Optics {
    /// Reads a statement, and ignores all others.
    pub(super) fn read(&mut self, line: &[u8]) {
        let mut words = text::words(line);
        match words.next().unwrap_or_default() {
            b"d" => self.dissolve = number(words.next()),
            b"Tr" => self.transparency = number(words.next()),
            b"Ni" => self.index = number(words.next()),
            b"illum" => self.model = number(words.next()),
            b"Ks" => self.specular = color(&mut words),
            b"Tf" => self.filter = color(&mut words),
            b"Pr" => self.has_roughness = true,
            _ => {}
        }
    }

    /// Applies the statements to a material, and reports what cannot be meant.
    ///
    /// Exporters write `d 0` and `Tr 1` for solid materials too, so that a surface never disappears because of them. `d` takes precedence
    /// over `Tr`, which some exporters write the wrong way round. Models 3 to 9 of `illum` trace rays: their `Ks` is the colour of a mirror,
    /// and the transparent ones among them, 6 and 7, bend light. Others use `Ks` for highlights only.
    pub(super) fn apply(&self, material: &mut Material, builder: &mut Builder) {
        let (opacity, problem) = match (self.dissolve, self.transparency) {
            (Some(dissolve), _) => (Some(dissolve), Material::not_a_share("`d`", dissolve)),
            (None, Some(transparency)) => {
                let problem = Material::not_a_share("`Tr`", transparency);
                (Some(1.0 - transparency), problem)
            }
            (None, None) => (None, None),
        };
        let index = self.index.and_then(|index| material.set_index(index));
        for problem in [problem, index].into_iter().flatten() {
            builder.warn("material-value", &material.name, problem);
        }
        let traces = self.model.is_some_and(|model| (3.0..=9.0).contains(&model));
        if traces && let Some(specular) = self.specular.filter(|color| color.iter().any(|x| *x > 0.0)) {
            material.specular = Some(specular);
            if !self.has_roughness {
                material.roughness = 0.0;
            }
        }
        let Some(opacity) = opacity.filter(|opacity| *opacity < 1.0 && material.opacity.is_none()) else {
            return;
        };
        if opacity <= 0.0 {
            let message =
                "its `d` is 0, or its `Tr` is 1, which is also written for solid materials: it is solid";
            builder.note("opaque", &material.name, message);
            return;
        }
        let refracts = self.model.is_some_and(|model| model == 6.0 || model == 7.0);
        if refracts {
            material.transmission = Some(Transmission {
                share: 1.0 - opacity,
                mask: None,
                tint: Some(self.filter.unwrap_or([1.0; 3])),
                refracts,
            });
            // The reflectance of glass follows from its index.
            material.specular = None;
            if !self.has_roughness {
                material.roughness = 0.0;
            }
        } else {
            material.opacity = Opacity::new(opacity, None, 0.0);
        }
    }
}
