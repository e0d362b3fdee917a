use super::Part;
use crate::{MaterialSpan, Mesh, MeshAttribute};

/// Merges the primitives of a mesh, in order.
pub(super) fn merge(mut parts: Vec<Part>) -> Mesh {
    parts.retain(|part| !part.mesh.triangles.is_empty());
    if parts.len() < 2 {
        return parts.pop().map(|part| part.mesh).unwrap_or_default();
    }
    let mut merged = Mesh {
        normals: normals(&parts),
        uvs: vertex_values(&parts, |part| part.mesh.uvs.as_ref(), |_| [0.0; 2]),
        colors: vertex_values(&parts, |part| part.mesh.colors.as_ref(), |part| part.factor),
        ..Mesh::default()
    };
    for Part { mesh, .. } in parts {
        let first = number(merged.positions.len());
        merged.positions.extend(mesh.positions);
        merged.triangles.extend(
            mesh.triangles
                .iter()
                .map(|triangle| triangle.map(|vertex| first + vertex)),
        );
        merged.double_sided |= mesh.double_sided;
        let end = number(merged.triangles.len());
        let material = mesh.materials.first().and_then(|span| span.material);
        match merged.materials.last_mut() {
            Some(last) if last.material == material => last.end = end,
            _ => merged.materials.push(MaterialSpan { end, material }),
        }
    }
    merged
}

/// The values of all parts if any part has some; parts without values get the default.
fn vertex_values<T: Copy>(
    parts: &[Part],
    get: impl Fn(&Part) -> Option<&MeshAttribute<T>>,
    otherwise: impl Fn(&Part) -> T,
) -> Option<MeshAttribute<T>> {
    if parts.iter().all(|part| get(part).is_none()) {
        return None;
    }
    let mut values = Vec::with_capacity(parts.iter().map(|part| part.mesh.positions.len()).sum());
    for part in parts {
        match get(part) {
            Some(MeshAttribute::Vertex(own)) => values.extend_from_slice(own),
            _ => values.extend(std::iter::repeat_n(otherwise(part), part.mesh.positions.len())),
        }
    }
    Some(MeshAttribute::Vertex(values))
}

/// The normals of all parts; parts without normals stay flat.
fn normals(parts: &[Part]) -> Option<MeshAttribute<[f32; 3]>> {
    let all = parts.iter().all(|part| part.mesh.normals.is_some());
    if all || parts.iter().all(|part| part.mesh.normals.is_none()) {
        return vertex_values(parts, |part| part.mesh.normals.as_ref(), |_| [0.0; 3]);
    }
    let (mut values, mut indices) = (Vec::new(), Vec::new());
    for Part { mesh, .. } in parts {
        let first = number(values.len());
        if let Some(MeshAttribute::Vertex(own)) = &mesh.normals {
            values.extend_from_slice(own);
            indices.extend(
                mesh.triangles
                    .iter()
                    .map(|triangle| triangle.map(|vertex| first + vertex)),
            );
        } else {
            values.extend((0..mesh.triangles.len()).map(|triangle| mesh.flat_normal(triangle)));
            indices.extend((0..number(mesh.triangles.len())).map(|triangle| [first + triangle; 3]));
        }
    }
    Some(MeshAttribute::Corner { values, indices })
}

/// Lists in memory have fewer than 2³² elements.
fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
