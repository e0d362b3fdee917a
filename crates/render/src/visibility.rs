use oaktwin_image::{Image, ZDepth};

/// The visible surface of each pixel of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Visibility {
    /// Z-depth in metres, `+inf` for a miss.
    pub z: ZDepth,
    /// The visible triangles.
    pub hits: Image<Hit>,
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
