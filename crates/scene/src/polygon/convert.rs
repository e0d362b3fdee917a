//! Converts polygon meshes to triangle meshes.

use std::collections::HashSet;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::DVec3;

use super::attribute::{Triangles, attribute};
use super::faces::Faces;
use super::material::FaceMaterials;
use super::primvar::Elements;
use super::triangulate::Triangulator;
use super::value::Value;
use super::{Interpolation, PolygonMesh, Primvar, Scheme, normals};
use crate::{MaterialSpan, Mesh};

impl PolygonMesh {
    /// Triangulates the mesh. `place` names it in findings, such as the path of a prim.
    ///
    /// * A face is split into a fan from its first corner or, if a fan does not cover it, by ear clipping; faces with fewer than
    ///   three corners are ignored. Triangles keep the order of the faces, except that the faces of one material are grouped
    ///   together.
    /// * Faces with a corner that is out of range or not finite are skipped, and so are holes.
    /// * Primvars of the wrong length are ignored.
    /// * Without authored normals, a mesh with a smooth subdivision scheme gets smooth normals.
    ///
    /// The points and values of a mesh of triangles are moved, not copied.
    #[must_use]
    pub fn into_mesh(mut self, place: &str) -> (Mesh, Vec<Finding>) {
        let mut findings = Findings {
            place,
            list: Vec::new(),
        };
        let faces = self.checked_faces(&mut findings);
        let elements = Elements {
            faces: self.face_vertex_counts.len(),
            points: self.points.len(),
            corners: self.face_vertex_indices.len(),
        };
        self.face_vertex_counts = Vec::new();
        let (materials, unknown) = FaceMaterials::of(&self.face_materials, self.material, &faces);
        if unknown > 0 {
            findings.warn(
                "mesh-unknown-face",
                format!("{unknown} faces with a material do not exist"),
            );
        }
        self.face_materials = Vec::new();
        let normals = findings.check("normals", self.normals.take(), elements);
        let uvs = findings.check("texture coordinates", self.uvs.take(), elements);
        let colors = findings.check("colours", self.colors.take(), elements);

        let uses = |wanted| {
            normals
                .as_ref()
                .is_some_and(|primvar| primvar.interpolation == wanted)
                || uvs
                    .as_ref()
                    .is_some_and(|primvar| primvar.interpolation == wanted)
                || colors
                    .as_ref()
                    .is_some_and(|primvar| primvar.interpolation == wanted)
        };
        let needs_faces = uses(Interpolation::Uniform) || !materials.is_one();
        let needs_corners = uses(Interpolation::FaceVarying);
        let mut cut = self.cut(&faces, &materials, needs_faces, &mut findings);
        self.hide_unusable_points();
        let vertices = cut.vertices(&self.face_vertex_indices, needs_corners);
        self.face_vertex_indices = Vec::new();
        let mut mesh = Mesh {
            positions: self.points,
            materials: spans(&materials, &cut, vertices.len()),
            double_sided: self.double_sided,
            ..Mesh::default()
        };
        let triangles = Triangles {
            vertices: &vertices,
            points: mesh.positions.len(),
            face: &|triangle| cut.face(triangle),
            corners: &|triangle| cut.corners(triangle),
            are_faces: cut.is_direct(),
        };
        mesh.uvs = uvs.map(|primvar| attribute(primvar, &triangles));
        mesh.colors = colors.map(|primvar| attribute(primvar, &triangles));
        mesh.normals = match normals {
            Some(primvar) => {
                let normals = attribute(primvar, &triangles);
                normals::unit(normals, &mesh.positions, &triangles)
            }
            None if matches!(self.subdivision.scheme, Scheme::CatmullClark | Scheme::Loop) => {
                Some(normals::smooth(&mesh.positions, &vertices))
            }
            None => None,
        };
        mesh.triangles = vertices;
        (mesh, findings.list)
    }

    /// Whether [`into_mesh`](Self::into_mesh) makes any triangle.
    #[must_use]
    pub fn has_triangles(&self) -> bool {
        let (faces, _) = Faces::of(self);
        let holes: HashSet<i32> = self.holes.iter().copied().collect();
        (0..faces.len()).any(|face| {
            let mut corners = faces.corners(face);
            let is_hole = i32::try_from(face).is_ok_and(|face| holes.contains(&face));
            corners.len() >= 3 && !is_hole && corners.all(|corner| self.is_usable(corner))
        })
    }

    fn checked_faces(&self, findings: &mut Findings<'_>) -> Faces {
        let (faces, faults) = Faces::of(self);
        if faults.any() {
            let mut parts = Vec::new();
            if faults.negative > 0 {
                parts.push(format!(
                    "{} faces have a negative number of corners",
                    faults.negative
                ));
            }
            if faults.faces_without_corners > 0 {
                parts.push(format!("{} faces lack corners", faults.faces_without_corners));
            }
            if faults.corners_without_face > 0 {
                parts.push(format!(
                    "{} corners belong to no face",
                    faults.corners_without_face
                ));
            }
            findings.warn(
                "mesh-counts",
                format!("faces and corners are inconsistent: {}", parts.join(", ")),
            );
        }
        faces
    }

    fn is_usable(&self, corner: u32) -> bool {
        usize::try_from(self.face_vertex_indices[corner as usize])
            .ok()
            .and_then(|index| self.points.get(index))
            .is_some_and(Value::is_finite)
    }

    /// Splits the faces into triangles.
    fn cut(
        &self,
        faces: &Faces,
        materials: &FaceMaterials,
        needs_faces: bool,
        findings: &mut Findings<'_>,
    ) -> Cut {
        let all_usable = self.points.iter().all(Value::is_finite)
            && self
                .face_vertex_indices
                .iter()
                .all(|&index| usize::try_from(index).is_ok_and(|index| index < self.points.len()));
        if faces.all_triangles() && self.holes.is_empty() && all_usable && materials.order.is_none() {
            return Cut {
                flipped: self.left_handed,
                listed: None,
            };
        }
        let is_hole = self.hole_mask(faces, findings);
        let mut corners = Vec::with_capacity(self.triangle_count(faces));
        let mut of_face = Vec::with_capacity(if needs_faces { corners.capacity() } else { 0 });
        let mut triangulator = Triangulator::default();
        let mut polygon = Vec::new();
        let (mut lost, mut uncut) = (0_u64, 0_u64);
        for position in 0..faces.len() {
            let face = materials
                .order
                .as_ref()
                .map_or(position, |order| order[position as usize]);
            let range = faces.corners(face);
            if range.len() < 3 || is_hole.get(face as usize).is_some_and(|&is_hole| is_hole) {
                continue;
            }
            if !all_usable && !range.clone().all(|corner| self.is_usable(corner)) {
                lost += range.len() as u64 - 2;
                continue;
            }
            polygon.clear();
            polygon.extend(range.clone().map(|corner| self.point_of(corner)));
            let whole = triangulator.triangulate(&polygon, |triangle| {
                corners.push(triangle.map(|corner| range.start + corner));
                if needs_faces {
                    of_face.push(face);
                }
            });
            uncut += u64::from(!whole);
        }
        if lost > 0 {
            findings.warn(
                "mesh-bad-triangles",
                format!("{lost} triangles have points that are missing or not finite; skipped"),
            );
        }
        if uncut > 0 {
            findings.warn(
                "mesh-polygon-too-large",
                format!(
                    "{uncut} concave faces have too many corners and may be triangulated wrongly; triangulate them first"
                ),
            );
        }
        Cut {
            flipped: self.left_handed,
            listed: Some(Listed { corners, of_face }),
        }
    }

    fn triangle_count(&self, faces: &Faces) -> usize {
        match faces {
            Faces::Regular { corners, count } => *count as usize * corners.saturating_sub(2) as usize,
            Faces::Varied { .. } => self
                .face_vertex_indices
                .len()
                .saturating_sub(2 * faces.len() as usize),
        }
    }

    fn hole_mask(&self, faces: &Faces, findings: &mut Findings<'_>) -> Vec<bool> {
        if self.holes.is_empty() {
            return Vec::new();
        }
        let mut mask = vec![false; faces.len() as usize];
        let mut unknown = 0;
        for &hole in &self.holes {
            match usize::try_from(hole).ok().and_then(|hole| mask.get_mut(hole)) {
                Some(is_hole) => *is_hole = true,
                None => unknown += 1,
            }
        }
        if unknown > 0 {
            findings.warn(
                "mesh-unknown-face",
                format!("{unknown} holes refer to faces that do not exist"),
            );
        }
        mask
    }

    /// The point of a usable corner.
    fn point_of(&self, corner: u32) -> DVec3 {
        let index = usize::try_from(self.face_vertex_indices[corner as usize]).unwrap_or(0);
        DVec3::from(self.points[index].map(f64::from))
    }

    /// Replaces non-finite points, which no triangle uses, by a finite one.
    fn hide_unusable_points(&mut self) {
        let stand_in = self
            .points
            .iter()
            .copied()
            .find(Value::is_finite)
            .unwrap_or([0.0; 3]);
        for point in &mut self.points {
            if !point.is_finite() {
                *point = stand_in;
            }
        }
    }
}

/// The triangles, as indices of the mesh's corners.
struct Cut {
    /// Whether the winding is reversed.
    flipped: bool,
    /// `None` if triangle `i` is face `i` with the corners `3i..3i + 3`.
    listed: Option<Listed>,
}

struct Listed {
    /// Empty once no longer needed.
    corners: Vec<[u32; 3]>,
    /// Empty if not needed.
    of_face: Vec<u32>,
}

impl Cut {
    fn is_direct(&self) -> bool {
        self.listed.is_none()
    }

    /// The vertices of each triangle; all corners must be usable.
    fn vertices(&mut self, indices: &[i32], keep_corners: bool) -> Vec<[u32; 3]> {
        let vertex = |corner: u32| u32::try_from(indices[corner as usize]).unwrap_or(0);
        let flipped = self.flipped;
        let turned = |[a, b, c]: [u32; 3]| if flipped { [a, c, b] } else { [a, b, c] };
        match &mut self.listed {
            // Reuses the memory.
            Some(listed) if !keep_corners => std::mem::take(&mut listed.corners)
                .into_iter()
                .map(|corners| turned(corners).map(vertex))
                .collect(),
            Some(listed) => listed
                .corners
                .iter()
                .map(|&corners| turned(corners).map(vertex))
                .collect(),
            None => (0..indices.len() / 3)
                .map(|triangle| self.corners(triangle).map(vertex))
                .collect(),
        }
    }

    #[allow(clippy::cast_possible_truncation, reason = "corners have 32 bits")]
    fn corners(&self, triangle: usize) -> [u32; 3] {
        let [a, b, c] = match &self.listed {
            Some(listed) => listed.corners[triangle],
            None => [0, 1, 2].map(|i| (3 * triangle + i) as u32),
        };
        if self.flipped { [a, c, b] } else { [a, b, c] }
    }

    #[allow(clippy::cast_possible_truncation, reason = "faces have 32 bits")]
    fn face(&self, triangle: usize) -> u32 {
        self.listed
            .as_ref()
            .map_or(triangle as u32, |listed| listed.of_face[triangle])
    }
}

fn spans(materials: &FaceMaterials, cut: &Cut, count: usize) -> Vec<MaterialSpan> {
    if materials.is_one() {
        let material = materials.get(0);
        let end = u32::try_from(count).unwrap_or(u32::MAX);
        let span = material
            .filter(|_| count > 0)
            .map(|_| MaterialSpan { end, material });
        return span.into_iter().collect();
    }
    let mut spans: Vec<MaterialSpan> = Vec::new();
    let mut end = 0;
    for triangle in 0..count {
        end += 1;
        let material = materials.get(cut.face(triangle));
        match spans.last_mut() {
            Some(span) if span.material == material => span.end = end,
            _ => spans.push(MaterialSpan { end, material }),
        }
    }
    if spans.iter().all(|span| span.material.is_none()) {
        spans.clear();
    }
    spans
}

/// Collects the findings about one mesh.
struct Findings<'a> {
    place: &'a str,
    list: Vec<Finding>,
}

impl Findings<'_> {
    fn warn(&mut self, code: &'static str, message: String) {
        self.list
            .push(Finding::new(code, Level::Warning, self.place, message, ""));
    }

    /// The primvar, if it fits the mesh; non-finite values become zero.
    fn check<T: Value>(
        &mut self,
        name: &str,
        primvar: Option<Primvar<T>>,
        elements: Elements,
    ) -> Option<Primvar<T>> {
        let mut primvar = primvar?;
        if let Err(message) = primvar.check(elements) {
            self.warn("mesh-primvar", format!("its {name} are ignored: {message}"));
            return None;
        }
        let mut bad = 0_usize;
        for value in &mut primvar.values {
            if !value.is_finite() {
                *value = T::ZERO;
                bad += 1;
            }
        }
        if bad > 0 {
            self.warn(
                "mesh-primvar",
                format!("{bad} of its {name} are not finite; replaced by zero"),
            );
        }
        Some(primvar)
    }
}

#[cfg(test)]
mod tests;
