use oaktwin_catalog::Device;

use super::{float, geometry};
use crate::body::BodyPart;
use crate::text::{Prim, Value};

/// Makes the device a rigid body with its mass and an invisible convex collider.
pub(super) fn add_rigid_body(device_prim: &mut Prim, device: &Device, collider: BodyPart) {
    device_prim
        .api_schemas
        .extend(["PhysicsRigidBodyAPI".into(), "PhysicsMassAPI".into()]);
    device_prim.set("physics:mass", float(device.body.mass_g * 1e-3));

    let mut mesh = geometry::mesh(collider);
    mesh.api_schemas
        .extend(["PhysicsCollisionAPI".into(), "PhysicsMeshCollisionAPI".into()]);
    mesh.set_uniform("physics:approximation", Value::token("convexHull"));
    mesh.set_uniform("purpose", Value::token("guide"));
    device_prim
        .children
        .push(Prim::def("Scope", "collisions").with_child(mesh));
}
