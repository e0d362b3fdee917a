//! Meshes: the primitives of a `<geometry>`.

use std::collections::HashMap;

use oaktwin_camera::math::DVec3;
use oaktwin_files::xml::{Element, XmlError};
use oaktwin_image::srgb;

use super::super::error::DAMAGED;
use super::super::origin::{FAR_M, relative};
use super::primitive::{Faces, Ids, Input, Primitive};
use super::source;
use crate::import::builder::Builder;
use crate::polygon::{FaceMaterial, Interpolation, PolygonMesh, Primvar};

/// The corners of all meshes of a file.
pub(super) const MAX_CORNERS: usize = 1 << 28;

/// What an instance binds to a name of a geometry.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Bound {
    pub(super) material: u32,
    /// The set of texture coordinates of its image.
    pub(super) set: Option<usize>,
    /// Whether the colours of the mesh are not used.
    pub(super) has_color: bool,
}

/// The primitives of a mesh that have values of the same kinds.
struct Part<'a> {
    kinds: [bool; 3],
    corners: [Vec<i32>; 4],
    counts: Vec<i32>,
    materials: Vec<FaceMaterial>,
    points: Pool<'a, 3>,
    normals: Pool<'a, 3>,
    uvs: Pool<'a, 2>,
    colors: Pool<'a, 3>,
}

/// The values of several sources, one after the other.
struct Pool<'a, const N: usize> {
    values: Vec<[f64; N]>,
    /// The number of values before the first one of a source, and its own. Never iterated.
    starts: HashMap<&'a str, (usize, usize)>,
}

impl<const N: usize> Default for Pool<'_, N> {
    fn default() -> Self {
        Self {
            values: Vec::new(),
            starts: HashMap::new(),
        }
    }
}

impl<'a, const N: usize> Pool<'a, N> {
    /// Returns the indices of the corners' values.
    fn indices(
        &mut self,
        input: &Input<'a>,
        ids: &Ids<'a>,
        primitive: &Primitive<'a>,
        faces: &Faces,
    ) -> Result<Vec<i32>, XmlError> {
        let (start, count) = match self.starts.get(input.source) {
            Some(known) => *known,
            None => {
                let element = ids.find("source", input.source, primitive.element)?;
                let read = source::read::<N>(element)?;
                let place = (self.values.len(), read.len());
                self.values.extend(read);
                self.starts.insert(input.source, place);
                place
            }
        };
        let index = |corner: &usize| {
            let own = faces.numbers[corner * primitive.stride + input.offset];
            let own = usize::try_from(own).ok().filter(|own| *own < count)?;
            i32::try_from(start + own).ok()
        };
        Ok(faces
            .corners
            .iter()
            .map(|corner| index(corner).unwrap_or(-1))
            .collect())
    }
}

/// Reads the meshes of a geometry, one for each combination of normals, texture coordinates and colours, with their origins. `bound` returns what is bound to
/// a name of a material. `left` is the number of corners that may still be read; `lines` counts what is not a surface.
pub(super) fn read(
    mesh: &Element,
    bound: &dyn Fn(&str) -> Option<Bound>,
    left: &mut usize,
    lines: &mut usize,
    builder: &Builder,
) -> Result<Vec<(PolygonMesh, DVec3)>, XmlError> {
    let ids = Ids::new(mesh);
    let mut parts: Vec<Part<'_>> = Vec::new();
    for element in &mesh.children {
        match element.tag.as_str() {
            "lines" | "linestrips" => *lines += 1,
            "triangles" | "polylist" | "polygons" | "tristrips" | "trifans" => {
                let primitive = Primitive::new(element, &ids)?;
                let faces = primitive.faces()?;
                *left = left.checked_sub(faces.corners.len()).ok_or_else(|| {
                    let message = format!("there are more than {MAX_CORNERS} corners");
                    element.wrong(message, "export a part of the scene")
                })?;
                let bound = element.get("material").and_then(bound);
                add(&mut parts, &primitive, faces, &ids, bound)?;
            }
            _ => {}
        }
    }
    Ok(parts.into_iter().map(|part| part.finish(builder)).collect())
}

fn add<'a>(
    parts: &mut Vec<Part<'a>>,
    primitive: &Primitive<'a>,
    faces: Faces,
    ids: &Ids<'a>,
    bound: Option<Bound>,
) -> Result<(), XmlError> {
    let points = primitive
        .input("POSITION", None)
        .ok_or_else(|| primitive.element.wrong("has no positions", DAMAGED))?;
    let normals = primitive.input("NORMAL", None);
    let uvs = primitive.input("TEXCOORD", bound.and_then(|bound| bound.set));
    let colors = primitive.input("COLOR", None);
    let colors = colors.filter(|_| !bound.is_some_and(|bound| bound.has_color));
    let kinds = [normals.is_some(), uvs.is_some(), colors.is_some()];
    let at = parts.iter().position(|part| part.kinds == kinds);
    let at = at.unwrap_or_else(|| {
        parts.push(Part {
            kinds,
            corners: Default::default(),
            counts: Vec::new(),
            materials: Vec::new(),
            points: Pool::default(),
            normals: Pool::default(),
            uvs: Pool::default(),
            colors: Pool::default(),
        });
        parts.len() - 1
    });
    let part = &mut parts[at];
    let own = part.points.indices(points, ids, primitive, &faces)?;
    part.corners[0].extend(own);
    if let Some(input) = normals {
        let own = part.normals.indices(input, ids, primitive, &faces)?;
        part.corners[1].extend(own);
    }
    if let Some(input) = uvs {
        let own = part.uvs.indices(input, ids, primitive, &faces)?;
        part.corners[2].extend(own);
    }
    if let Some(input) = colors {
        let own = part.colors.indices(input, ids, primitive, &faces)?;
        part.corners[3].extend(own);
    }
    let first = part.counts.len();
    part.counts.extend(faces.counts);
    if let Some(bound) = bound {
        let faces = (first..part.counts.len()).filter_map(|face| i32::try_from(face).ok());
        part.materials.push(FaceMaterial {
            faces: faces.collect(),
            material: bound.material,
        });
    }
    Ok(())
}

impl Part<'_> {
    fn finish(self, builder: &Builder) -> (PolygonMesh, DVec3) {
        let [points, normals, uvs, colors] = self.corners;
        let [has_normals, has_uvs, has_colors] = self.kinds;
        let used = points.iter();
        let used = used.filter_map(|&at| self.points.values.get(usize::try_from(at).ok()?).copied());
        let origin = builder.origin(used, FAR_M);
        let placed = self.points.values.into_iter();
        let mut mesh = PolygonMesh {
            points: placed.map(|point| relative(point, origin)).collect(),
            face_vertex_counts: self.counts,
            face_vertex_indices: points,
            normals: has_normals.then(|| at_corners(self.normals.values, normals)),
            uvs: has_uvs.then(|| at_corners(self.uvs.values, uvs)),
            colors: has_colors.then(|| at_corners(self.colors.values, colors)),
            ..PolygonMesh::default()
        };
        for value in mesh.colors.iter_mut().flat_map(|colors| &mut colors.values) {
            *value = value.map(srgb::linear);
        }
        // One material for all faces needs no list of them.
        let one = self.materials.first().map(|first| first.material);
        let covered: usize = self.materials.iter().map(|own| own.faces.len()).sum();
        let is_one = self.materials.iter().all(|own| Some(own.material) == one);
        if is_one && covered == mesh.face_vertex_counts.len() {
            mesh.material = one;
        } else {
            mesh.face_materials = self.materials;
        }
        (mesh, origin)
    }
}

#[expect(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn at_corners<const N: usize>(values: Vec<[f64; N]>, indices: Vec<i32>) -> Primvar<[f32; N]> {
    let values = values.into_iter().map(|value| value.map(|x| x as f32));
    Primvar {
        interpolation: Interpolation::FaceVarying,
        values: values.collect(),
        indices: Some(indices),
    }
}
