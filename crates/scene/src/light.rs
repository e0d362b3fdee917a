use oaktwin_camera::math::DAffine3;

/// A light. Its frame is USD's: it shines along −z; a dome's pole is +y.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// The path of its prim.
    pub path: String,
    /// The shape.
    pub kind: LightKind,
    /// Linear colour times intensity and exposure: the radiance of its surface, or its power if `normalize` is set.
    pub radiance: [f32; 3],
    /// Whether `radiance` is divided by the area of the surface (by the solid angle of a distant light).
    pub normalize: bool,
    /// The transform from the light's frame to the world, metres.
    pub world_from_light: DAffine3,
}

/// The shape of a light; lengths are in the unit of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// The sun: parallel rays along −z from a distant disk.
    Distant {
        /// The angular diameter of the disk, radians.
        angle: f32,
    },
    /// The sky.
    Dome {
        /// A latitude-longitude image: an index into the scene's textures.
        texture: Option<u32>,
    },
    /// A sphere.
    Sphere {
        /// The radius.
        radius: f32,
    },
    /// A rectangle in the x-y plane.
    Rect {
        /// The size along x.
        width: f32,
        /// The size along y.
        height: f32,
    },
    /// A disk in the x-y plane.
    Disk {
        /// The radius.
        radius: f32,
    },
}
