//! Meshes, whose primitives each have their own material and vertex attributes.

mod merge;

use std::collections::BTreeMap;

use ::gltf::json;
use json::mesh::{Mode, Semantic};
use json::validation::Checked;

use super::accessor::Accessor;
use super::document::Document;
use super::material::{MaterialInfo, Materials};
use super::morph;
use super::skin::Pose;
use crate::Mesh;
use crate::import::builder::Builder;
use crate::import::error::Fault;
use crate::polygon::{Interpolation, PolygonMesh, Primvar};

/// Reads a mesh, with the weights of its morph targets if its node has its own, and in a pose if it has one; it has no triangles if none of its primitives can be rendered.
pub(super) fn read(
    document: &Document,
    index: usize,
    materials: &Materials,
    weights: Option<&[f64]>,
    pose: Option<&Pose>,
    builder: &mut Builder,
) -> Result<Mesh, Fault> {
    let place = format!("meshes[{index}]");
    let Some(mesh) = document.root.meshes.get(index) else {
        return Err(Fault::damaged(place, "does not exist"));
    };
    let own: Vec<f64> = mesh
        .weights
        .iter()
        .flatten()
        .map(|weight| f64::from(*weight))
        .collect();
    let weights = weights.unwrap_or(&own);
    let mut unsupported: BTreeMap<&str, usize> = BTreeMap::new();
    let mut parts = Vec::new();
    for (i, primitive) in mesh.primitives.iter().enumerate() {
        let place = format!("{place}.primitives[{i}]");
        let Checked::Valid(mode) = primitive.mode else {
            *unsupported.entry("primitives with an unknown mode").or_default() += 1;
            continue;
        };
        match mode {
            Mode::Points => *unsupported.entry("points").or_default() += 1,
            Mode::Lines | Mode::LineLoop | Mode::LineStrip => *unsupported.entry("lines").or_default() += 1,
            Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan => {
                let material = primitive
                    .material
                    .and_then(|material| materials.get(material.value()));
                let part = Part::read(
                    document,
                    (primitive, mode),
                    material,
                    (weights, pose),
                    &place,
                    builder,
                )
                .map_err(|message| Fault::damaged(&place, message))?;
                parts.push(part);
            }
        }
    }
    for (what, count) in unsupported {
        builder.warn(
            "gltf-unsupported",
            &place,
            format!("{what} are not supported: {count} skipped"),
        );
    }
    Ok(merge::merge(parts))
}

/// The triangles of a primitive.
pub(super) struct Part {
    mesh: Mesh,
    /// The factor that its vertex colours were multiplied by.
    factor: [f32; 3],
}

impl Part {
    fn read(
        document: &Document,
        (primitive, mode): (&json::mesh::Primitive, Mode),
        material: Option<MaterialInfo>,
        (weights, pose): (&[f64], Option<&Pose>),
        place: &str,
        builder: &mut Builder,
    ) -> Result<Self, String> {
        let find = |semantic: Semantic| {
            let index = primitive.attributes.get(&Checked::Valid(semantic))?;
            Some(Accessor::find(document, index.value()))
        };
        let positions = find(Semantic::Positions).ok_or("has no POSITION")??;
        if positions.components() != 3 {
            return Err("its POSITION is not a VEC3".into());
        }
        let (indices, vertices) = indices(document, primitive, mode, positions.count)?;
        document.allow(3 * indices.len() as u64 + vertices.len() as u64)?;
        let factor = material.map_or([1.0; 3], |material| material.factor);
        let mut polygons = PolygonMesh {
            points: vertices.iter().map(|at| positions.floats(at)).collect(),
            face_vertex_counts: vec![3; indices.len() / 3],
            face_vertex_indices: indices,
            double_sided: material.is_some_and(|material| material.double_sided),
            material: material.map(|material| material.number),
            ..PolygonMesh::default()
        };
        let mut optional = |name: &str, semantic: Semantic| {
            let fault = match find(semantic)? {
                Ok(accessor) if accessor.count == positions.count => return Some(accessor),
                Ok(accessor) => format!("{} values instead of {}", accessor.count, positions.count),
                Err(message) => message,
            };
            builder.warn("mesh-primvar", place, format!("its {name} are ignored: {fault}"));
            None
        };
        polygons.normals = optional("normals", Semantic::Normals)
            .map(|normals| vertex_values(&vertices, |at| normals.floats(at)));
        let uv_set = material.and_then(|material| material.uv_set).unwrap_or(0);
        polygons.uvs = optional("texture coordinates", Semantic::TexCoords(uv_set)).map(|uvs| {
            vertex_values(&vertices, |at| {
                let [u, v] = uvs.floats(at);
                [u, 1.0 - v]
            })
        });
        polygons.colors = optional("colours", Semantic::Colors(0)).map(|colors| {
            vertex_values(&vertices, |at| {
                let color: [f32; 3] = colors.floats(at);
                [0, 1, 2].map(|i| color[i] * factor[i])
            })
        });
        let morphed = morph::apply(
            document,
            primitive,
            weights,
            positions.count,
            vertices.iter(),
            &mut polygons.points,
            polygons.normals.as_mut().map(|normals| &mut normals.values[..]),
        );
        if let Err(why) = morphed {
            builder.warn(
                "gltf-morph",
                place,
                format!("its morph targets are ignored: {why}"),
            );
        }
        if let Some(pose) = pose {
            let normals = polygons.normals.as_mut().map(|normals| &mut normals.values[..]);
            let posed = pose.apply(
                document,
                primitive,
                vertices.iter(),
                &mut polygons.points,
                normals,
            );
            if let Err(why) = posed {
                builder.warn("gltf-skin", place, format!("its skin is ignored: {why}"));
            }
        }
        let (mesh, findings) = polygons.into_mesh(place);
        builder.findings.extend(findings);
        Ok(Self { mesh, factor })
    }
}

fn vertex_values<T>(vertices: &Vertices, value: impl Fn(usize) -> T) -> Primvar<T> {
    Primvar::new(Interpolation::Vertex, vertices.iter().map(value).collect())
}

/// The vertices that a primitive uses.
enum Vertices {
    /// All vertices, with their number.
    All(usize),
    /// The vertices in the list, ordered.
    Some(Vec<i32>),
}

impl Vertices {
    fn len(&self) -> usize {
        match self {
            Self::All(count) => *count,
            Self::Some(list) => list.len(),
        }
    }

    fn iter(&self) -> impl Iterator<Item = usize> + Clone {
        let at = |i: usize| match self {
            Self::All(_) => i,
            // Indices in the list are not negative.
            Self::Some(list) => usize::try_from(list[i]).unwrap_or(0),
        };
        (0..self.len()).map(at)
    }
}

/// The vertex index of each triangle corner, and the vertices that the indices refer to.
fn indices(
    document: &Document,
    primitive: &json::mesh::Primitive,
    mode: Mode,
    count: usize,
) -> Result<(Vec<i32>, Vertices), String> {
    let Some(index) = primitive.indices else {
        let all = i32::try_from(count).map_err(|_| "has too many vertices")?;
        return Ok((
            triangles(mode, count, |at| i32::try_from(at).unwrap_or(all)),
            Vertices::All(count),
        ));
    };
    let accessor = Accessor::find(document, index.value())?;
    document.allow(accessor.count as u64)?;
    let mut corners = triangles(mode, accessor.count, |at| accessor.index(at));
    // Many primitives may share one long vertex list of which each uses a part.
    if corners.len() >= count / 2 {
        return Ok((corners, Vertices::All(count)));
    }
    let mut used: Vec<i32> = corners.clone();
    used.sort_unstable();
    used.dedup();
    used.retain(|&at| usize::try_from(at).is_ok_and(|at| at < count));
    for corner in &mut corners {
        *corner = used
            .binary_search(corner)
            .ok()
            .and_then(|at| i32::try_from(at).ok())
            .unwrap_or(-1);
    }
    Ok((corners, Vertices::Some(used)))
}

/// Converts strips and fans to separate triangles, with glTF's winding.
fn triangles(mode: Mode, count: usize, index: impl Fn(usize) -> i32) -> Vec<i32> {
    let strip = count.saturating_sub(2);
    match mode {
        Mode::TriangleStrip => (0..strip)
            .flat_map(|i| [i, i + 1 + i % 2, i + 2 - i % 2])
            .map(index)
            .collect(),
        Mode::TriangleFan => (0..strip).flat_map(|i| [0, i + 1, i + 2]).map(index).collect(),
        _ => (0..count / 3 * 3).map(index).collect(),
    }
}
