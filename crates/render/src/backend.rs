use oaktwin_camera::LensModel;

use crate::View;

/// How to find out what a pixel sees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backend {
    /// Whichever suits the view.
    #[default]
    Auto,
    /// Triangles onto tiles of pixels; ideal pinholes only.
    Raster,
    /// Rays through a bounding volume hierarchy; every lens.
    Ray,
}

impl Backend {
    /// Itself, or what `Auto` stands for. A lens that bends rays is always cast.
    #[must_use]
    pub fn for_view(self, view: &View) -> Self {
        match (self, view.camera.lens) {
            (Self::Auto | Self::Raster, LensModel::Pinhole) => Self::Raster,
            _ => Self::Ray,
        }
    }
}
