use oaktwin_camera::LensModel;

use crate::View;

/// The visibility backend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backend {
    /// The rasterizer for ideal pinholes, the ray caster for other lenses.
    #[default]
    Auto,
    /// The rasterizer; ideal pinholes only.
    Raster,
    /// The ray caster; every lens.
    Ray,
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
