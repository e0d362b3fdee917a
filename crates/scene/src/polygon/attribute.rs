//! Converts primvars to attributes of triangles, stored as compactly as their values allow.

use super::value::Value;
use super::weld::Welder;
use super::{Interpolation, Primvar};
use crate::MeshAttribute;

/// The triangulation, as far as attributes depend on it.
pub(super) struct Triangles<'a> {
    pub(super) vertices: &'a [[u32; 3]],
    pub(super) points: usize,
    /// The face of each triangle.
    pub(super) face: &'a dyn Fn(usize) -> u32,
    /// The corners of each triangle, as indices into all corners of the mesh.
    pub(super) corners: &'a dyn Fn(usize) -> [u32; 3],
    /// Whether triangle `i` is face `i` for all triangles.
    pub(super) are_faces: bool,
}

/// Converts a checked primvar to an attribute.
pub(super) fn attribute<T: Value>(primvar: Primvar<T>, triangles: &Triangles<'_>) -> MeshAttribute<T> {
    let value = |element: u32| primvar.get(element as usize).unwrap_or(T::ZERO);
    match primvar.interpolation {
        Interpolation::Constant => MeshAttribute::Constant(value(0)),
        Interpolation::Uniform if triangles.are_faces && primvar.indices.is_none() => {
            MeshAttribute::Triangle(primvar.values)
        }
        Interpolation::Uniform => {
            let of_triangle = |triangle| value((triangles.face)(triangle));
            MeshAttribute::Triangle((0..triangles.vertices.len()).map(of_triangle).collect())
        }
        Interpolation::Vertex => match &primvar.indices {
            None => MeshAttribute::Vertex(primvar.values),
            Some(indices) => MeshAttribute::Vertex(
                (0..indices.len())
                    .map(|i| primvar.get(i).unwrap_or(T::ZERO))
                    .collect(),
            ),
        },
        Interpolation::FaceVarying => face_varying(&value, triangles),
    }
}

/// Most vertices have the same value at all their corners: such values are stored once.
fn face_varying<T: Value>(value: &dyn Fn(u32) -> T, triangles: &Triangles<'_>) -> MeshAttribute<T> {
    if let Some(values) = one_for_each_triangle(value, triangles) {
        return MeshAttribute::Triangle(values);
    }
    let mut welder = Welder::new(triangles.points);
    // Indices are stored only once a corner's value differs from the first one at its vertex.
    let mut indices: Option<Vec<[u32; 3]>> = None;
    for (triangle, vertices) in triangles.vertices.iter().enumerate() {
        let corners = (triangles.corners)(triangle);
        let picked = [0, 1, 2].map(|i| welder.index(vertices[i], value(corners[i])));
        if indices.is_none() && picked != *vertices {
            let mut list = Vec::with_capacity(triangles.vertices.len());
            list.extend_from_slice(&triangles.vertices[..triangle]);
            indices = Some(list);
        }
        if let Some(indices) = &mut indices {
            indices.push(picked);
        }
    }
    let values = welder.values;
    match indices {
        None => MeshAttribute::Vertex(values),
        Some(indices) => MeshAttribute::Corner { values, indices },
    }
}

/// The value of each triangle, if all its corners have the same.
fn one_for_each_triangle<T: Value>(value: &dyn Fn(u32) -> T, triangles: &Triangles<'_>) -> Option<Vec<T>> {
    let one = |triangle| {
        let [a, b, c] = (triangles.corners)(triangle).map(value);
        (a == b && a == c).then_some(a)
    };
    // Tests a few triangles before memory is allocated for all.
    let count = triangles.vertices.len();
    (0..count.min(64)).map(one).collect::<Option<Vec<T>>>()?;
    (0..count).map(one).collect()
}
