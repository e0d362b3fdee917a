//! The visible body of a camera: closed meshes and preview materials, built from the catalog's outer dimensions and the
//! twin's optical centres. Pure geometry, without the USD library.
//!
//! Outer dimensions, front face and lens positions follow the data. All other proportions are chosen to make the model
//! recognizable; they are not measured.
//!
//! A twin's virtual cameras are inside the body, like the real ones. Renderers draw every triangle beyond a camera's
//! near plane, so the front glass has openings: no part of the body is inside a pinhole camera's view frustum.

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
use oaktwin_catalog::{BodyShape, Twin};

pub use material::BodyMaterial;

/// A closed mesh with outward-facing normals in the body frame (x forward, y left, z up), in metres.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// The name, valid and unique as a prim name.
    pub name: String,
    /// The vertices in metres, on a grid of 1 µm.
    pub points: Vec<[f32; 3]>,
    /// The number of vertices of each face: 3 or 4.
    pub face_vertex_counts: Vec<i32>,
    /// Indices into `points`, counter-clockwise seen from outside.
    pub face_vertex_indices: Vec<i32>,
    /// The unit normals, one per entry of `face_vertex_indices` (`faceVarying`), rounded to 4 decimals.
    pub normals: Vec<[f32; 3]>,
    /// The name of a [`BodyMaterial`].
    pub material: &'static str,
}

/// The body of a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyModel {
    /// The visible parts. They may touch and overlap; each is closed.
    pub parts: Vec<BodyPart>,
    /// The materials that the parts use, sorted by name.
    pub materials: Vec<BodyMaterial>,
    /// A convex mesh with the outer dimensions.
    pub collider: BodyPart,
}

/// The outer dimensions that all parts fit into, mm.
#[derive(Clone, Copy, Debug)]
struct Envelope {
    /// The centre of the front face.
    front: DVec3,
    /// Half the width and half the height.
    half: DVec2,
    /// The depth along x.
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

    /// Returns the centre of the front face in the y-z plane.
    fn centre(&self) -> DVec2 {
        DVec2::new(self.front.y, self.front.z)
    }

    fn back_x(&self) -> f64 {
        self.front.x - self.depth
    }

    /// Returns the radius of the edges that run from front to back.
    fn corner_radius(&self, family: BodyShape) -> f64 {
        let share = match family {
            BodyShape::Bar => 0.46,
            BodyShape::Comb => 0.14,
            BodyShape::Compact => 0.3,
            BodyShape::Plain => 0.2,
        };
        share * self.half.min_element()
    }
}

/// Builds the body of a twin. The result is deterministic.
///
/// Dimensions must be positive and finite, as in a checked catalog. A camera that does not fit the front gets no
/// opening.
#[must_use]
pub fn body(twin: &Twin) -> BodyModel {
    let envelope = Envelope::of(twin);
    let family = twin.device.body.shape;
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
