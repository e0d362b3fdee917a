//! The look of a camera: closed meshes and preview materials, built from the catalog's outer dimensions and the twin's
//! optical centres. Pure geometry, no USD library.
//!
//! Outer dimensions, front face and lens places follow the data; all other proportions are our own, made to be
//! recognized rather than measured.
//!
//! A twin's virtual cameras sit inside the body, where the real ones do. A renderer takes every triangle beyond a
//! camera's near plane for scenery, so the front glass has real openings: nothing of the body lies inside the
//! pyramid that a pinhole camera sees.

mod fastener;
mod front;
mod housing;
mod loft;
mod material;
mod mesh;
mod outline;
mod plate;
#[cfg(test)]
mod tests;
mod window;

use oaktwin_camera::math::{DVec2, DVec3};
use oaktwin_catalog::{Role, Twin};

pub use material::BodyMaterial;

/// One closed, outward-wound mesh in the body frame (x forward, y left, z up), m.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// A valid, unique prim name.
    pub name: String,
    /// Vertices, m, on a grid of 1 µm.
    pub points: Vec<[f32; 3]>,
    /// Vertices of each face: 3 or 4.
    pub face_vertex_counts: Vec<i32>,
    /// Indices into `points`, counter-clockwise seen from outside.
    pub face_vertex_indices: Vec<i32>,
    /// Unit normals, one per entry of `face_vertex_indices` (`faceVarying`), to 4 decimals.
    pub normals: Vec<[f32; 3]>,
    /// The name of a [`BodyMaterial`].
    pub material: &'static str,
}

/// A camera's body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyModel {
    /// What is seen. Parts may touch and overlap; each is closed by itself.
    pub parts: Vec<BodyPart>,
    /// The materials that the parts name, each once, in order of name.
    pub materials: Vec<BodyMaterial>,
    /// A convex mesh of the outer dimensions.
    pub collider: BodyPart,
}

/// The shapes that a body comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    /// A long bar with fins between the connectors: RVC2.
    Bar,
    /// A bar in front of a comb of fins: RVC4.
    Comb,
    /// A short box: time of flight.
    Box,
}

/// The frame that all parts are fitted into, mm.
#[derive(Clone, Copy, Debug)]
struct Envelope {
    /// The centre of the front face.
    front: DVec3,
    /// Half of the width and of the height.
    half: DVec2,
    /// Along x.
    depth: f64,
}

impl Envelope {
    fn of(twin: &Twin) -> Self {
        let [width, height, depth] = twin.device.body.dimensions_mm;
        Self {
            front: DVec3::from_array(twin.device.body.front_mm),
            half: DVec2::new(width, height) / 2.0,
            depth,
        }
    }

    /// The centre of the front face in the y-z plane.
    fn centre(&self) -> DVec2 {
        DVec2::new(self.front.y, self.front.z)
    }

    fn back_x(&self) -> f64 {
        self.front.x - self.depth
    }

    /// Radius of the edges that run from front to back.
    fn corner_radius(&self, family: Family) -> f64 {
        let share = match family {
            Family::Bar => 0.46,
            Family::Comb => 0.14,
            Family::Box => 0.3,
        };
        share * self.half.min_element()
    }
}

/// Builds the body of a twin, the same for the same input.
///
/// The data must be a checked catalog's: positive, finite dimensions. A camera that the front has no room for gets
/// no opening.
#[must_use]
pub fn body(twin: &Twin) -> BodyModel {
    let envelope = Envelope::of(twin);
    let family = if twin.camera(Role::Tof).is_some() {
        Family::Box
    } else if twin.device.generation == "RVC4" {
        Family::Comb
    } else {
        Family::Bar
    };
    let panel = front::Panel::of(twin, &envelope, family);
    let mut parts = housing::parts(&envelope, family, &panel);
    parts.extend(front::parts(twin, &envelope, &panel));
    let materials = material::used(&parts);
    BodyModel {
        parts,
        materials,
        collider: housing::collider(&envelope, family),
    }
}
