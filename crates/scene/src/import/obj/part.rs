use std::collections::HashMap;

use oaktwin_camera::math::DVec3;

use crate::import::origin::relative;
use crate::polygon::{FaceMaterial, Interpolation, PolygonMesh, Primvar};

/// The values that the faces of a file refer to.
#[derive(Default)]
pub(super) struct Pool {
    points: Vec<[f64; 3]>,
    /// The colours of the points; may be shorter than the points if the last ones have none.
    colors: Vec<[f32; 3]>,
    pub(super) uvs: Vec<[f32; 2]>,
    pub(super) normals: Vec<[f32; 3]>,
    /// Scratch: the index in the current part of each value in the pool.
    numbers: Vec<i32>,
}

/// The colour of points without one.
const WHITE: [f32; 3] = [1.0; 3];

impl Pool {
    pub(super) fn push_point(&mut self, point: [f64; 3], color: Option<[f32; 3]>) {
        if let Some(color) = color {
            self.colors.resize(self.points.len(), WHITE);
            self.colors.push(color);
        }
        self.points.push(point);
    }

    pub(super) fn point(&self, index: i64) -> i32 {
        super::index(index, self.points.len())
    }

    /// The points of corners, relative to an origin, as far as they exist.
    pub(super) fn points_of(&self, corners: &[Corner], origin: DVec3) -> impl Iterator<Item = [f64; 3]> {
        let found = corners
            .iter()
            .filter_map(|corner| self.points.get(usize::try_from(corner.point).ok()?));
        found.map(move |point| (DVec3::from(*point) - origin).to_array())
    }
}

/// The zero-based indices of a corner.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) point: i32,
    pub(super) uv: i32,
    pub(super) normal: i32,
}

impl Corner {
    /// The index is absent.
    pub(super) const NONE: i32 = -2;
    /// The index is out of range.
    pub(super) const BAD: i32 = -1;
}

/// The faces with the same object and group name.
pub(super) struct Part {
    pub(super) path: String,
    pub(super) counts: Vec<i32>,
    pub(super) corners: Vec<Corner>,
    /// The first face of each run of one material, with that material.
    materials: Vec<(usize, Option<u32>)>,
}

impl Part {
    pub(super) fn new(path: &str) -> Self {
        Self {
            path: path.into(),
            counts: Vec::new(),
            corners: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// Sets the material of the face that was added last.
    pub(super) fn set_material(&mut self, material: Option<u32>) {
        if self.materials.last().is_none_or(|last| last.1 != material) {
            self.materials.push((self.counts.len() - 1, material));
        }
    }

    /// Builds a mesh with only the values that its faces refer to, with points relative to an origin.
    pub(super) fn polygons(self, pool: &mut Pool, origin: DVec3) -> PolygonMesh {
        let Self {
            counts,
            corners,
            materials,
            ..
        } = self;
        let numbers = &mut pool.numbers;
        let mut mesh = PolygonMesh::default();
        let has_color = !pool.colors.is_empty();
        let mut colors = Vec::new();
        let points = corners.iter().map(|corner| corner.point);
        let (picked_points, point_indices) = picked(&pool.points, points.clone(), numbers);
        mesh.points = picked_points
            .into_iter()
            .map(|point| relative(point, origin))
            .collect();
        mesh.face_vertex_indices = point_indices;
        if has_color {
            pool.colors.resize(pool.points.len(), WHITE);
            colors = picked(&pool.colors, points, numbers).0;
        }
        mesh.colors = has_color.then(|| Primvar::new(Interpolation::Vertex, colors));
        if corners.iter().any(|corner| corner.uv >= 0) {
            let (mut values, mut indices) =
                picked(&pool.uvs, corners.iter().map(|corner| corner.uv), numbers);
            // Corners without texture coordinates get the origin.
            let origin = i32::try_from(values.len()).unwrap_or(-1);
            values.push([0.0; 2]);
            for index in &mut indices {
                *index = if *index < 0 { origin } else { *index };
            }
            mesh.uvs = Some(Primvar {
                interpolation: Interpolation::FaceVarying,
                values,
                indices: Some(indices),
            });
        }
        // Normals are used only if all corners have one.
        if corners.iter().all(|corner| corner.normal >= 0) {
            let (values, indices) =
                picked(&pool.normals, corners.iter().map(|corner| corner.normal), numbers);
            mesh.normals = Some(Primvar {
                interpolation: Interpolation::FaceVarying,
                values,
                indices: Some(indices),
            });
        }
        (mesh.material, mesh.face_materials) = face_materials(&materials, counts.len());
        mesh.face_vertex_counts = counts;
        mesh
    }
}

/// The values that are referred to, in order of first use, and the indices into them; negative indices are kept.
/// `numbers` must be zero everywhere, and is so again on return.
fn picked<T: Copy>(
    values: &[T],
    picks: impl Iterator<Item = i32>,
    numbers: &mut Vec<i32>,
) -> (Vec<T>, Vec<i32>) {
    if numbers.len() < values.len() {
        numbers.resize(values.len(), 0);
    }
    let mut kept = Vec::new();
    let mut touched = Vec::new();
    let indices = picks
        .map(|pick| {
            let Ok(at) = usize::try_from(pick) else {
                return pick;
            };
            // Counts from one, so that zero means unused.
            if numbers[at] == 0 {
                kept.push(values[at]);
                touched.push(at);
                numbers[at] = i32::try_from(kept.len()).unwrap_or(i32::MAX);
            }
            numbers[at] - 1
        })
        .collect();
    for at in touched {
        numbers[at] = 0;
    }
    (kept, indices)
}

/// The material of most faces, and the faces with other materials.
fn face_materials(runs: &[(usize, Option<u32>)], faces: usize) -> (Option<u32>, Vec<FaceMaterial>) {
    let first = runs.first().and_then(|run| run.1);
    let mut others: Vec<FaceMaterial> = Vec::new();
    let mut other_of_material: HashMap<u32, usize> = HashMap::new();
    for (i, &(start, material)) in runs.iter().enumerate() {
        let end = runs.get(i + 1).map_or(faces, |next| next.0);
        let (Some(material), true) = (material, material != first) else {
            continue;
        };
        let other = *other_of_material.entry(material).or_insert_with(|| {
            others.push(FaceMaterial {
                faces: Vec::new(),
                material,
            });
            others.len() - 1
        });
        let run = (start..end).filter_map(|face| i32::try_from(face).ok());
        others[other].faces.extend(run);
    }
    (first, others)
}
