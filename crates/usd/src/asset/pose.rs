use oaktwin_camera::{Axes, RigidTransform};

use crate::text::{PrimSpec, SpecValue};

/// Sets a prim's pose with `xformOp:translate` and `xformOp:orient`, the pair that Isaac Sim's tools write.
pub(super) fn set(prim: &mut PrimSpec, parent_from_prim: &RigidTransform) {
    let t = parent_from_prim.translation;
    let q = parent_from_prim.quaternion();
    // Rounding to 1 pm and 1e-15 removes arithmetic noise, so that the text reads 0.0375.
    let metres = |x: f64| tidy(x, 1e12);
    let unit = |x: f64| tidy(x, 1e15);
    prim.set(
        "xformOp:translate",
        SpecValue::Double3([metres(t.x), metres(t.y), metres(t.z)]),
    );
    prim.set(
        "xformOp:orient",
        SpecValue::Quatd([unit(q.w), unit(q.x), unit(q.y), unit(q.z)]),
    );
    prim.set_uniform(
        "xformOpOrder",
        SpecValue::TokenArray(vec!["xformOp:translate".into(), "xformOp:orient".into()]),
    );
}

/// Converts the pose of an optical frame (z forward, y down) to the pose of a camera prim (−z forward, y up).
pub(super) fn of_camera_prim(body_from_camera: &RigidTransform) -> RigidTransform {
    RigidTransform::new(
        body_from_camera.rotation * Axes::OpenCv.rotation_from(Axes::Usd),
        body_from_camera.translation,
    )
}

/// Rounds to a multiple of `1 / steps`; −0 becomes 0.
fn tidy(x: f64, steps: f64) -> f64 {
    (x * steps).round() / steps + 0.0
}
