use oaktwin_base::parameter::choice;
use oaktwin_camera::LensModel;

use crate::View;

choice! {
    /// The visibility backend.
    Backend {
        /// The rasterizer for ideal pinholes, the ray caster for other lenses.
        Auto = "auto",
        /// The rasterizer; ideal pinholes only.
        Raster = "raster",
        /// The ray caster; every lens.
        Ray = "ray",
    }
}

impl Backend {
    /// Returns the backend that renders a view. Lenses with distortion are always ray cast.
    #[must_use]
    pub fn for_view(self, view: &View) -> Self {
        match (self, view.camera.lens) {
            (Self::Auto | Self::Raster, LensModel::Pinhole) => Self::Raster,
            _ => Self::Ray,
        }
    }
}
