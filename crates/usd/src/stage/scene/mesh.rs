use oaktwin_scene::polygon::{
    BoundaryRule, Crease, FaceMaterial, FaceVaryingRule, Interpolation, PolygonMesh, Scheme, Subdivision,
};

use super::super::reader::{Reader, Record};
use super::super::value::{boolean, floats, ints, text, vec2s, vec3s};
use super::context::Context;
use super::primvar::{attribute, primvar};

/// The surface data to read for a mesh.
pub(super) struct MeshRequest<'a> {
    /// The primvar with texture coordinates, without its prefix; `None` if no material needs them.
    pub(super) uv: Option<&'a str>,
    /// Whether its own colours are visible.
    pub(super) colors: bool,
    /// Whether it will be subdivided.
    pub(super) refined: bool,
}

/// Reads a `Mesh` without materials.
pub(super) fn read(
    reader: &Reader,
    prim: &Record,
    context: &Context,
    request: &MeshRequest<'_>,
) -> PolygonMesh {
    let integers = |name: &str| reader.value(prim, name).and_then(ints).unwrap_or_default();
    let token = |name: &str| reader.value(prim, name).and_then(text);
    let normals = primvar(reader, prim, context, "primvars:normals", vec3s).or_else(|| {
        let own = prim.has("normals").then_some(&prim.path)?;
        attribute(reader, own, "normals", Interpolation::Vertex, vec3s)
    });
    PolygonMesh {
        points: reader.value(prim, "points").and_then(vec3s).unwrap_or_default(),
        face_vertex_counts: integers("faceVertexCounts"),
        face_vertex_indices: integers("faceVertexIndices"),
        holes: integers("holeIndices"),
        left_handed: token("orientation").is_some_and(|orientation| orientation == "leftHanded"),
        double_sided: reader
            .value(prim, "doubleSided")
            .is_some_and(|v| boolean(&v) == Some(true)),
        normals,
        uvs: request.uv.and_then(|name| {
            primvar(reader, prim, context, &format!("primvars:{name}"), vec2s)
                .or_else(|| primvar(reader, prim, context, "primvars:st", vec2s))
        }),
        colors: request
            .colors
            .then(|| primvar(reader, prim, context, "primvars:displayColor", vec3s))
            .flatten()
            .filter(|colors| !colors.values.is_empty()),
        face_materials: Vec::new(),
        material: None,
        subdivision: subdivision(reader, prim, request.refined),
    }
}

fn subdivision(reader: &Reader, prim: &Record, refined: bool) -> Subdivision {
    let token = |name: &str| reader.value(prim, name).and_then(text).unwrap_or_default();
    let scheme = match token("subdivisionScheme").as_str() {
        "none" => Scheme::None,
        "loop" => Scheme::Loop,
        "bilinear" => Scheme::Bilinear,
        _ => Scheme::CatmullClark,
    };
    let mut subdivision = Subdivision {
        scheme,
        ..Subdivision::default()
    };
    if !refined || scheme == Scheme::None {
        return subdivision;
    }
    let integers = |name: &str| reader.value(prim, name).and_then(ints).unwrap_or_default();
    let numbers = |name: &str| reader.value(prim, name).and_then(floats).unwrap_or_default();
    subdivision.creases = creases(
        &integers("creaseIndices"),
        &integers("creaseLengths"),
        &numbers("creaseSharpnesses"),
    );
    subdivision.corners = integers("cornerIndices")
        .into_iter()
        .zip(numbers("cornerSharpnesses"))
        .collect();
    subdivision.boundary = match token("interpolateBoundary").as_str() {
        "none" => BoundaryRule::None,
        "edgeOnly" => BoundaryRule::EdgeOnly,
        _ => BoundaryRule::EdgeAndCorner,
    };
    subdivision.face_varying = match token("faceVaryingLinearInterpolation").as_str() {
        "none" => FaceVaryingRule::None,
        "cornersOnly" => FaceVaryingRule::CornersOnly,
        "cornersPlus2" => FaceVaryingRule::CornersPlus2,
        "boundaries" => FaceVaryingRule::Boundaries,
        "all" => FaceVaryingRule::All,
        _ => FaceVaryingRule::CornersPlus1,
    };
    subdivision
}

/// Reads creases, which are stored consecutively with one sharpness per crease or per edge.
fn creases(indices: &[i32], lengths: &[i32], sharpnesses: &[f32]) -> Vec<Crease> {
    let per_crease = sharpnesses.len() == lengths.len();
    let (mut point, mut edge) = (0, 0);
    let mut creases = Vec::new();
    for (i, length) in lengths.iter().enumerate() {
        let Some(length) = usize::try_from(*length).ok().filter(|length| *length >= 2) else {
            break;
        };
        let sharpness = if per_crease {
            sharpnesses.get(i..=i)
        } else {
            sharpnesses.get(edge..edge + length - 1)
        };
        let (Some(points), Some(sharpness)) = (indices.get(point..point + length), sharpness) else {
            break;
        };
        creases.push(Crease {
            points: points.to_vec(),
            sharpness: sharpness.to_vec(),
        });
        point += length;
        edge += length - 1;
    }
    creases
}

/// Returns the faces of a `GeomSubset` that binds a material.
pub(super) fn subset_faces(reader: &Reader, subset: &Record) -> Option<Vec<i32>> {
    let token = |name: &str| reader.value(subset, name).and_then(text);
    let of_faces = token("elementType").is_none_or(|kind| kind == "face");
    let binds = token("familyName").is_some_and(|family| family == "materialBind");
    (of_faces && binds).then_some(())?;
    reader.value(subset, "indices").and_then(ints)
}

/// Creates a subset of faces with its own material.
pub(super) fn face_material(faces: Vec<i32>, material: u32) -> FaceMaterial {
    FaceMaterial { faces, material }
}
