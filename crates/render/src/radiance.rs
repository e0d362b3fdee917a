use oaktwin_base::diagnostic::Finding;
use oaktwin_image::Image;

use crate::shade;
use crate::{Backend, Renderer, View};

impl Renderer {
    /// Renders linear light, from which frames that take time are added up: red, green and blue in the exposure of the scene, and coverage,
    /// which is 0 for a miss and otherwise 1. Outlines are antialiased. The findings are textures that cannot be shown.
    #[must_use]
    pub fn radiance(&self, view: &View, backend: Backend) -> (Image<[f32; 4]>, Vec<Finding>) {
        let seen = self.visibility(view, backend);
        let corners = self.corners(view, backend);
        let rays = self.rays(view);
        let input = self.shading(view, &rays, &seen);
        let (colors, mut findings) = self.shader().radiance(input, &corners);
        findings.extend(self.unread_masks());
        let mut light = colors.map(|[r, g, b]| [*r, *g, *b, 1.0]);
        for (pixel, hit) in light.pixels_mut().iter_mut().zip(seen.hits.pixels()) {
            if hit.is_miss() {
                pixel[3] = 0.0;
            }
        }
        self.spare_visibility(view, backend).keep(Some(seen.z), seen.hits);
        (light, findings)
    }

    /// Returns the colours, sRGB with coverage, of light that [`Renderer::radiance`] returned, or of means of it.
    #[must_use]
    pub fn developed(light: &Image<[f32; 4]>) -> Image<[u8; 4]> {
        shade::print(light)
    }
}
