use oaktwin_image::Image;
use oaktwin_image::annotation::Returns;

use crate::shade::Band;
use crate::{Backend, Renderer, View};

impl Renderer {
    /// Whether a material of the scene states its reflectance at 940 nm.
    #[must_use]
    pub fn has_infrared(&self) -> bool {
        self.scene()
            .materials
            .iter()
            .any(|material| material.infrared.is_some())
    }

    /// Renders the colours of a view with given reflectances at 940 nm in place of colours; `None` if no material states one.
    #[must_use]
    pub fn infrared(&self, view: &View, backend: Backend) -> Option<Image<[u8; 4]>> {
        if !self.has_infrared() {
            return None;
        }
        let seen = self.visibility(view, backend);
        let corners = self.corners(view, backend);
        let rays = self.rays(view);
        let input = self.shading(view, &rays, &seen);
        let (shaded, _) = self.shader().shade(input, Some(&corners), false, Band::Infrared);
        Some(shaded.rgb)
    }

    /// Renders the returns that a time-of-flight camera receives from a lamp beside it; `None` if depth and colours determine them, because no
    /// material reflects rays, lets them pass or states its reflectance at 940 nm.
    #[must_use]
    pub fn returns(&self, view: &View, backend: Backend) -> Option<Returns> {
        let decides = self.scene().materials.iter().any(crate::shade::decides_returns);
        if !decides {
            return None;
        }
        let seen = self.visibility(view, backend);
        let rays = self.rays(view);
        let input = self.shading(view, &rays, &seen);
        Some(self.shader().returns(input))
    }
}
