use oaktwin_catalog::Device;

use super::geometry::{self, BodyMaterial, BodyPart};
use super::{f32_of, float};
use crate::text::{Prim, Value};

/// Makes the device a rigid body: its mass, and a box of its outer dimensions that collides but is not seen.
pub(super) fn add_rigid_body(device_prim: &mut Prim, device: &Device) {
    device_prim
        .api_schemas
        .extend(["PhysicsRigidBodyAPI".into(), "PhysicsMassAPI".into()]);
    device_prim.set("physics:mass", float(device.body.mass_g * 1e-3));

    let mut collider = geometry::mesh(&collider(device), "faceVarying");
    collider
        .api_schemas
        .extend(["PhysicsCollisionAPI".into(), "PhysicsMeshCollisionAPI".into()]);
    collider.set_uniform("physics:approximation", Value::token("convexHull"));
    collider.set_uniform("purpose", Value::token("guide"));
    device_prim
        .children
        .push(Prim::def("Scope", "collisions").with_child(collider));
}

/// The box around the body, with outward faces.
fn collider(device: &Device) -> BodyPart {
    let [width, height, depth] = device.body.dimensions_mm;
    let [front, y, z] = device.body.front_mm;
    let low = [front - depth, y - width / 2.0, z - height / 2.0];
    let high = [front, y + width / 2.0, z + height / 2.0];
    let metres = |mm: f64| f32_of(mm * 1e-3);
    // Corner i takes the high end of x, y, z where bit 0, 1, 2 of i is set.
    let points = (0..8)
        .map(|corner| {
            std::array::from_fn(|axis| {
                metres(if corner >> axis & 1 == 1 {
                    high[axis]
                } else {
                    low[axis]
                })
            })
        })
        .collect();
    let faces: [([i32; 4], [f32; 3]); 6] = [
        ([1, 3, 7, 5], [1.0, 0.0, 0.0]),
        ([0, 4, 6, 2], [-1.0, 0.0, 0.0]),
        ([2, 6, 7, 3], [0.0, 1.0, 0.0]),
        ([0, 1, 5, 4], [0.0, -1.0, 0.0]),
        ([4, 5, 7, 6], [0.0, 0.0, 1.0]),
        ([0, 2, 3, 1], [0.0, 0.0, -1.0]),
    ];
    BodyPart {
        name: "collider".into(),
        points,
        face_vertex_counts: vec![4; 6],
        face_vertex_indices: faces.iter().flat_map(|(corners, _)| *corners).collect(),
        normals: faces.iter().flat_map(|(_, normal)| [*normal; 4]).collect(),
        material: BodyMaterial::default(),
    }
}
