//! A mesh of polygons into triangles.

use oaktwin_camera::math::DVec3;
use oaktwin_diagnostic::{Finding, Level};

use super::attribute::{Triangles, Value, attribute};
use super::faces::Faces;
use super::material::FaceMaterials;
use super::primvar::Elements;
use super::triangulate::Triangulator;
use super::{Interpolation, PolygonMesh, Primvar, Scheme, normals};
use crate::{MaterialSpan, Mesh};

impl PolygonMesh {
    /// Its triangles. `place` is what findings say it is: a prim's path.
    ///
    /// * A face is fanned from its first corner, or where that does not cover it has its ears clipped; fewer than three
    ///   corners are no face. Triangles keep the order of the faces, unless materials alternate: then the faces of one
    ///   material follow each other.
    /// * Faces with a corner that is out of range or not finite are left out, holes too.
    /// * Primvars of the wrong length are left out.
    /// * Normals are smooth where there are none and the scheme is a smooth one: it is the cage of a smooth surface.
    ///
    /// A mesh of triangles takes over its points and its values as they are.
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
                format!("{unknown} faces of its materials do not exist"),
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
                format!("faces and corners do not add up: {}", parts.join(", ")),
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

    /// Cuts the faces into triangles.
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
                format!("{lost} triangles have points that do not exist or are not finite, and are left out"),
            );
        }
        if uncut > 0 {
            findings.warn(
                "mesh-polygon-too-large",
                format!(
                    "{uncut} concave faces have too many corners and may be covered wrongly; triangulate them"
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
                format!("{unknown} holes are faces that do not exist"),
            );
        }
        mask
    }

    /// Of a corner that is usable.
    fn point_of(&self, corner: u32) -> DVec3 {
        let index = usize::try_from(self.face_vertex_indices[corner as usize]).unwrap_or(0);
        DVec3::from(self.points[index].map(f64::from))
    }

    /// Points that no triangle can have stand where they widen no bounds.
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

/// The triangles, as corners of the mesh.
struct Cut {
    /// Whether the winding is turned round.
    flipped: bool,
    /// `None` where triangle `i` is face `i` with the corners `3i..3i + 3`.
    listed: Option<Listed>,
}

struct Listed {
    /// Empty once nothing asks for it.
    corners: Vec<[u32; 3]>,
    /// Empty if nothing asks for it.
    of_face: Vec<u32>,
}

impl Cut {
    fn is_direct(&self) -> bool {
        self.listed.is_none()
    }

    /// The points of each triangle; of corners that are usable.
    fn vertices(&mut self, indices: &[i32], keep_corners: bool) -> Vec<[u32; 3]> {
        let vertex = |corner: u32| u32::try_from(indices[corner as usize]).unwrap_or(0);
        let flipped = self.flipped;
        let turned = |[a, b, c]: [u32; 3]| if flipped { [a, c, b] } else { [a, b, c] };
        match &mut self.listed {
            // In the same memory.
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

/// Collects findings about one mesh.
struct Findings<'a> {
    place: &'a str,
    list: Vec<Finding>,
}

impl Findings<'_> {
    fn warn(&mut self, code: &'static str, message: String) {
        self.list
            .push(Finding::new(code, Level::Warning, self.place, message, ""));
    }

    /// The primvar, if it fits the mesh; values that are not finite become zero.
    fn check<T: Value>(
        &mut self,
        name: &str,
        primvar: Option<Primvar<T>>,
        elements: Elements,
    ) -> Option<Primvar<T>> {
        let mut primvar = primvar?;
        if let Err(message) = primvar.check(elements) {
            self.warn("mesh-primvar", format!("its {name} are left out: {message}"));
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
                format!("{bad} of its {name} are not finite; taken as zero"),
            );
        }
        Some(primvar)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Attribute;
    use crate::polygon::{FaceMaterial, Interpolation, Subdivision};

    /// A row of unit squares along x, each a quad.
    fn strip(quads: i16) -> PolygonMesh {
        let mut mesh = PolygonMesh::default();
        for x in 0..=quads {
            mesh.points.push([f32::from(x), 0.0, 0.0]);
            mesh.points.push([f32::from(x), 1.0, 0.0]);
        }
        for x in 0..i32::from(quads) {
            mesh.face_vertex_counts.push(4);
            mesh.face_vertex_indices.extend([0, 2, 3, 1].map(|i| 2 * x + i));
        }
        mesh
    }

    fn codes(findings: &[Finding]) -> Vec<&str> {
        findings.iter().map(|finding| finding.code).collect()
    }

    #[test]
    fn quads_are_fanned_from_their_first_corner() {
        let (mesh, findings) = strip(2).into_mesh("/m");
        assert!(findings.is_empty());
        assert_eq!(mesh.triangles, [[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]]);
        assert_eq!(mesh.normals, None);
    }

    #[test]
    fn a_left_handed_mesh_is_turned_round() {
        let mut left = strip(1);
        left.left_handed = true;
        left.uvs = Some(Primvar::new(
            Interpolation::FaceVarying,
            vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.0]],
        ));
        let (mesh, _) = left.into_mesh("/m");
        assert_eq!(mesh.triangles, [[0, 3, 2], [0, 1, 3]]);
        // The values stay with their points.
        let uvs = mesh.uvs.unwrap();
        assert_eq!(
            uvs,
            Attribute::Vertex(vec![[0.0, 0.0], [0.5, 1.0], [1.0, 0.0], [1.0, 1.0]])
        );
    }

    #[test]
    fn triangles_are_taken_as_they_are() {
        let mut triangles = strip(0);
        triangles.points.push([1.0, 0.0, 0.0]);
        triangles.face_vertex_counts = vec![3, 3];
        triangles.face_vertex_indices = vec![0, 2, 1, 1, 2, 0];
        triangles.colors = Some(Primvar::new(
            Interpolation::Uniform,
            vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        ));
        triangles.uvs = Some(Primvar {
            interpolation: Interpolation::Vertex,
            values: vec![[0.25, 0.5], [0.75, 0.5]],
            indices: Some(vec![1, 0, 1]),
        });
        let (mesh, findings) = triangles.into_mesh("/m");
        assert!(findings.is_empty());
        assert_eq!(mesh.triangles, [[0, 2, 1], [1, 2, 0]]);
        assert_eq!(
            mesh.colors,
            Some(Attribute::Triangle(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
        );
        assert_eq!(
            mesh.uvs,
            Some(Attribute::Vertex(vec![[0.75, 0.5], [0.25, 0.5], [0.75, 0.5]]))
        );
    }

    #[test]
    fn a_seam_adds_only_its_own_values() {
        let mut seam = strip(2);
        // The middle edge, points 2 and 3, has u = 1 on its left and u = 0 on its right.
        let quad = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        seam.uvs = Some(Primvar::new(Interpolation::FaceVarying, [quad, quad].concat()));
        let (mesh, _) = seam.into_mesh("/m");
        let uvs = mesh.uvs.unwrap();
        for (triangle, corners) in [
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
            [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
            [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        ]
        .into_iter()
        .enumerate()
        {
            assert_eq!(uvs.corners(triangle, mesh.triangles[triangle]), Some(corners));
        }
        let Attribute::Corner { values, .. } = uvs else {
            panic!("{uvs:?}")
        };
        assert_eq!(values.len(), 6 + 2);
    }

    #[test]
    fn face_varying_values_of_flat_faces_become_one_for_each_triangle() {
        let mut flat = strip(2);
        let (left, right) = ([0.0, 0.0, 2.0], [0.0, 1.0, 0.0]);
        flat.normals = Some(Primvar::new(
            Interpolation::FaceVarying,
            [[left; 4], [right; 4]].concat(),
        ));
        let (mesh, _) = flat.into_mesh("/m");
        let unit = [0.0, 0.0, 1.0];
        assert_eq!(
            mesh.normals,
            Some(Attribute::Triangle(vec![unit, unit, right, right]))
        );
    }

    #[test]
    fn holes_and_slivers_of_fewer_than_three_corners_are_no_faces() {
        let mut mesh = strip(3);
        mesh.holes = vec![1, 7];
        mesh.face_vertex_counts.push(2);
        mesh.face_vertex_indices.extend([0, 1]);
        mesh.colors = Some(Primvar::new(
            Interpolation::Uniform,
            vec![[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]],
        ));
        let (mesh, findings) = mesh.into_mesh("/m");
        assert_eq!(mesh.triangles, [[0, 2, 3], [0, 3, 1], [4, 6, 7], [4, 7, 5]]);
        assert_eq!(
            mesh.colors,
            Some(Attribute::Triangle(vec![[0.0; 3], [0.0; 3], [2.0; 3], [2.0; 3]]))
        );
        assert_eq!(codes(&findings), ["mesh-unknown-face"]);
    }

    #[test]
    fn faces_with_unusable_points_are_left_out_and_counted_once() {
        let mut mesh = strip(4);
        mesh.points[0][1] = f32::NAN;
        mesh.points[8][2] = f32::INFINITY;
        mesh.face_vertex_indices[4] = -1;
        mesh.face_vertex_indices[5] = 10;
        let (mesh, findings) = mesh.into_mesh("/m");
        assert_eq!(mesh.triangles, [[4, 6, 7], [4, 7, 5]]);
        assert_eq!(codes(&findings), ["mesh-bad-triangles"]);
        assert!(findings[0].message.starts_with("6 triangles"), "{}", findings[0]);
        assert!(mesh.positions.iter().all(Value::is_finite));
    }

    #[test]
    fn counts_that_do_not_add_up_give_the_faces_that_do() {
        let mut mesh = strip(2);
        mesh.face_vertex_counts = vec![4, -3, 3, 7];
        let (mesh, findings) = mesh.into_mesh("/m");
        assert_eq!(mesh.triangles, [[0, 2, 3], [0, 3, 1], [2, 4, 5]]);
        assert_eq!(codes(&findings), ["mesh-counts"]);
        assert_eq!(
            findings[0].message,
            "faces and corners do not add up: 1 faces have a negative number of corners, 1 faces lack corners, 1 corners belong to no face"
        );
    }

    #[test]
    fn primvars_that_do_not_fit_are_left_out() {
        for (interpolation, count, fits) in [
            (Interpolation::Constant, 0, false),
            (Interpolation::Constant, 1, true),
            (Interpolation::Uniform, 2, true),
            (Interpolation::Uniform, 3, false),
            (Interpolation::Vertex, 6, true),
            (Interpolation::Vertex, 5, false),
            (Interpolation::FaceVarying, 8, true),
            (Interpolation::FaceVarying, 6, false),
        ] {
            let mut mesh = strip(2);
            mesh.uvs = Some(Primvar::new(interpolation, vec![[0.5, 0.5]; count]));
            let (mesh, findings) = mesh.into_mesh("/m");
            assert_eq!(mesh.uvs.is_some(), fits, "{interpolation:?} {count}");
            assert_eq!(findings.is_empty(), fits);
        }
        let mut mesh = strip(2);
        mesh.uvs = Some(Primvar {
            interpolation: Interpolation::Vertex,
            values: vec![[0.0; 2]; 6],
            indices: Some(vec![0, 1, 2, 3, 4, 6]),
        });
        let (mesh, findings) = mesh.into_mesh("/m");
        assert_eq!(mesh.uvs, None);
        assert_eq!(
            findings[0].message,
            "its texture coordinates are left out: index 6 among 6 values"
        );
    }

    #[test]
    fn alternating_materials_are_brought_together() {
        let mut mesh = strip(4);
        mesh.material = Some(9);
        mesh.face_materials = vec![FaceMaterial {
            faces: vec![1, 3],
            material: 4,
        }];
        mesh.colors = Some(Primvar::new(
            Interpolation::Uniform,
            vec![[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]],
        ));
        let (mesh, findings) = mesh.into_mesh("/m");
        assert!(findings.is_empty());
        let span = |end, material| MaterialSpan {
            end,
            material: Some(material),
        };
        assert_eq!(mesh.materials, [span(4, 9), span(8, 4)]);
        let first: Vec<u32> = mesh.triangles.iter().map(|triangle| triangle[0]).collect();
        assert_eq!(first, [0, 0, 4, 4, 2, 2, 6, 6]);
        let Some(Attribute::Triangle(colors)) = mesh.colors else {
            panic!("{:?}", mesh.colors)
        };
        assert_eq!(
            colors.iter().map(|c| c[0]).collect::<Vec<_>>(),
            [0., 0., 2., 2., 1., 1., 3., 3.]
        );
    }

    #[test]
    fn the_cage_of_a_smooth_surface_has_smooth_normals() {
        // A tetrahedron's corner of three right angles: the normal is the diagonal whatever the triangulation.
        let mut mesh = PolygonMesh {
            points: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
                [1.0, 1.0, 0.0],
            ],
            face_vertex_counts: vec![4, 3, 3],
            face_vertex_indices: vec![0, 2, 4, 1, 0, 3, 2, 0, 1, 3],
            subdivision: Subdivision {
                scheme: Scheme::CatmullClark,
                ..Subdivision::default()
            },
            ..PolygonMesh::default()
        };
        let smooth = |mesh: &PolygonMesh| match mesh.clone().into_mesh("/m").0.normals {
            Some(Attribute::Vertex(normals)) => normals[0],
            normals => panic!("{normals:?}"),
        };
        let expected = -(3.0_f32.sqrt().recip());
        for x in smooth(&mesh) {
            assert!((x - expected).abs() < 1e-3, "{x}");
        }
        mesh.normals = Some(Primvar::new(Interpolation::Vertex, vec![[0.0, 3.0, 4.0]; 5]));
        assert_eq!(smooth(&mesh), [0.0, 0.6, 0.8]);
        // An authored normal without a direction is its triangle's.
        mesh.normals = Some(Primvar::new(Interpolation::Vertex, vec![[0.0; 3]; 5]));
        assert_eq!(smooth(&mesh), [0.0, 0.0, -1.0]);
    }
}
