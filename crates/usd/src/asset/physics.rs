use oaktwin_catalog::Device;

use super::{float, geometry};
use crate::body::BodyPart;
use crate::text::{PrimSpec, SpecValue};

/// Makes the device a rigid body with its mass and an invisible convex collider.
pub(super) fn add_rigid_body(device_prim: &mut PrimSpec, device: &Device, collider: BodyPart) {
    device_prim
        .api_schemas
        .extend(["PhysicsRigidBodyAPI".into(), "PhysicsMassAPI".into()]);
    device_prim.set("physics:mass", float(device.body.mass_g * 1e-3));

    let mut mesh = geometry::mesh(collider);
    mesh.api_schemas
        .extend(["PhysicsCollisionAPI".into(), "PhysicsMeshCollisionAPI".into()]);
    mesh.set_uniform("physics:approximation", SpecValue::token("convexHull"));
    mesh.set_uniform("purpose", SpecValue::token("guide"));
    device_prim
        .children
        .push(PrimSpec::def("Scope", "collisions").with_child(mesh));
}
