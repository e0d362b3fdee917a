//! Morph targets (glTF 2.0, section 3.7.2.2): weighted displacements of vertices, before their skin.

use ::gltf::json::mesh::Primitive;
use oaktwin_camera::math::DVec3;

use super::accessor::Accessor;
use super::document::Document;

/// Displaces the points and normals of a primitive's vertices. Returns why targets are ignored, if some are.
pub(super) fn apply(
    document: &Document,
    primitive: &Primitive,
    weights: &[f64],
    count: usize,
    vertices: impl Iterator<Item = usize> + Clone,
    points: &mut [[f32; 3]],
    normals: Option<&mut [[f32; 3]]>,
) -> Result<(), String> {
    let targets = primitive.targets.as_deref().unwrap_or_default();
    let used = targets.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
    let (mut moves, mut turns) = (Vec::new(), Vec::new());
    for (target, weight) in used {
        for (accessor, found) in [(target.positions, &mut moves), (target.normals, &mut turns)] {
            let Some(accessor) = accessor else { continue };
            let accessor = Accessor::find(document, accessor.value())?;
            if accessor.count != count || accessor.components() != 3 {
                return Err(format!(
                    "a target has {} values instead of {count}",
                    accessor.count
                ));
            }
            document.allow(3 * points.len() as u64)?;
            found.push((accessor, *weight));
        }
    }
    displace(&moves, vertices.clone(), points, |point| point);
    if let Some(normals) = normals.filter(|_| !turns.is_empty()) {
        displace(&turns, vertices, normals, DVec3::normalize_or_zero);
    }
    Ok(())
}

/// Adds weighted displacements.
#[expect(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn displace(
    by: &[(Accessor<'_>, f64)],
    vertices: impl Iterator<Item = usize>,
    values: &mut [[f32; 3]],
    finish: impl Fn(DVec3) -> DVec3,
) {
    if by.is_empty() {
        return;
    }
    for (value, vertex) in values.iter_mut().zip(vertices) {
        let wide = |vector: [f32; 3]| DVec3::from(vector.map(f64::from));
        let moves = by
            .iter()
            .map(|(moves, weight)| wide(moves.floats(vertex)) * *weight);
        *value = finish(wide(*value) + moves.sum::<DVec3>())
            .to_array()
            .map(|x| x as f32);
    }
}
