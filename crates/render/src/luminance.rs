use oaktwin_diagnostic::Finding;
use oaktwin_image::{Image, ZDepth};

use crate::rays::Rays;
use crate::shade::{Beam, Corners, Sight, corners_of};
use crate::{Backend, Renderer, View};

/// Light on a sensor, linear: 1 is what a white diffuse surface in the scene's typical light sends.
#[derive(Clone, Debug, PartialEq)]
pub struct Luminance {
    /// Of the scene's own lights: Rec. 709 luminance, without a tone curve. 0 where the lens sees nothing.
    pub scene: Image<f32>,
    /// What a beam adds, where there is one.
    pub beam: Option<Image<f32>>,
    /// Metres along the optical axis, `+inf` for a miss.
    pub z: ZDepth,
}

impl Renderer {
    /// The light that a view's pixels collect; the findings are what the picture had to do without.
    ///
    /// Outlines are smooth in the scene's light. A beam is seen as far as diffuse surfaces reflect it, once; it casts
    /// shadows.
    #[must_use]
    pub fn luminance(
        &self,
        view: &View,
        backend: Backend,
        beam: Option<&Beam<'_>>,
    ) -> (Luminance, Vec<Finding>) {
        let seen = self.visibility(view, backend);
        let corner_view = corners_of(view);
        let corners = Corners {
            rays: Rays::new(&corner_view),
            seen: self.visibility(&corner_view, backend),
        };
        let sight = Sight {
            scene: self.scene(),
            caster: self.ray_caster(),
            view,
            rays: &Rays::new(view),
            seen: &seen,
        };
        let (greys, findings) = self.shader().luminance(sight, Some(&corners), beam);
        let found = Luminance {
            scene: greys.scene,
            beam: greys.beam,
            z: seen.z,
        };
        (found, findings)
    }
}
