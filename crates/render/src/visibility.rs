use oaktwin_image::{Image, ZDepth};

/// What each pixel of a view sees.
#[derive(Clone, Debug, PartialEq)]
pub struct Visibility {
    /// Metres along the optical axis, `+inf` for a miss.
    pub z: ZDepth,
    /// Which triangle.
    pub hits: Image<Hit>,
}

/// A triangle of an instance, or nothing, in the scene's order; nothing comes last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Hit {
    /// Into the scene's instances; `u32::MAX` for a miss.
    pub instance: u32,
    /// Into its mesh's triangles; `u32::MAX` for a miss.
    pub triangle: u32,
}

impl Hit {
    /// The ray ends nowhere.
    pub const MISS: Self = Self {
        instance: u32::MAX,
        triangle: u32::MAX,
    };

    /// Whether the ray ends nowhere.
    #[must_use]
    pub const fn is_miss(self) -> bool {
        self.instance == u32::MAX
    }
}
