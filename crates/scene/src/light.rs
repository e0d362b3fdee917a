use oaktwin_camera::math::DAffine3;

/// A light. Its own frame is USD's: it shines along −z; a dome's pole is +y.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// The prim.
    pub path: String,
    /// Its shape.
    pub kind: LightKind,
    /// Linear colour times intensity and exposure: the radiance of its surface, or with `normalize` its power.
    pub radiance: [f32; 3],
    /// Whether `radiance` is divided by the area of the surface (by the solid angle of a distant light).
    pub normalize: bool,
    /// From the light's frame into the world, metres.
    pub world_from_light: DAffine3,
}

/// A light's shape; lengths in the unit of its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// The sun: parallel rays along −z from a disk that is this wide.
    Distant {
        /// The disk's diameter, radians.
        angle: f32,
    },
    /// The sky.
    Dome {
        /// An image in latitude and longitude, into the scene's textures.
        texture: Option<u32>,
    },
    /// A ball.
    Sphere {
        /// Its radius.
        radius: f32,
    },
    /// A rectangle in the x-y plane.
    Rect {
        /// Along x.
        width: f32,
        /// Along y.
        height: f32,
    },
    /// A disk in the x-y plane.
    Disk {
        /// Its radius.
        radius: f32,
    },
}
