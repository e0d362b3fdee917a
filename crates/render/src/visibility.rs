use oaktwin_image::{Image, ZDepth};

use crate::spare::Spare;

/// The visible surface of each pixel of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Visibility {
    /// Z-depth in metres, `+inf` for a miss.
    pub z: ZDepth,
    /// The visible triangles.
    pub hits: Image<Hit>,
}

/// The memory of visibilities that were dropped.
#[derive(Debug, Default)]
pub(crate) struct SpareVisibility {
    pub(crate) z: Spare<f32>,
    pub(crate) hits: Spare<Hit>,
}

impl SpareVisibility {
    /// Keeps the memory of a visibility, whose depth may be in use elsewhere.
    pub(crate) fn keep(&self, z: Option<ZDepth>, hits: Image<Hit>) {
        self.hits.keep(hits);
        if let Some(ZDepth(z)) = z {
            self.z.keep(z);
        }
    }
}

/// A triangle of an instance, or a miss. Hits are ordered as in the scene; a miss comes last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Hit {
    /// The index of the instance in the scene; `u32::MAX` for a miss.
    pub instance: u32,
    /// The index of the triangle in the mesh; `u32::MAX` for a miss.
    pub triangle: u32,
}

impl Hit {
    /// A ray that hits nothing.
    pub const MISS: Self = Self {
        instance: u32::MAX,
        triangle: u32::MAX,
    };

    /// Whether the ray hits nothing.
    #[must_use]
    pub const fn is_miss(self) -> bool {
        self.instance == u32::MAX
    }
}
