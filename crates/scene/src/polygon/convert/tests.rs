use super::*;
use crate::MeshAttribute;
use crate::polygon::{FaceMaterial, Interpolation, Subdivision};
use proptest::collection::vec;
use proptest::prelude::*;

/// A row of unit squares along x.
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
fn reverses_left_handed_meshes() {
    let mut left = strip(1);
    left.left_handed = true;
    left.uvs = Some(Primvar::new(
        Interpolation::FaceVarying,
        vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.0]],
    ));
    let (mesh, _) = left.into_mesh("/m");
    assert_eq!(mesh.triangles, [[0, 3, 2], [0, 1, 3]]);
    // The values stay at their points.
    let uvs = mesh.uvs.unwrap();
    assert_eq!(
        uvs,
        MeshAttribute::Vertex(vec![[0.0, 0.0], [0.5, 1.0], [1.0, 0.0], [1.0, 1.0]])
    );
}

#[test]
fn triangles_are_unchanged() {
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
        Some(MeshAttribute::Triangle(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
    );
    assert_eq!(
        mesh.uvs,
        Some(MeshAttribute::Vertex(vec![[0.75, 0.5], [0.25, 0.5], [0.75, 0.5]]))
    );
}

#[test]
fn a_seam_adds_only_its_values() {
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
    let MeshAttribute::Corner { values, .. } = uvs else {
        panic!("{uvs:?}")
    };
    assert_eq!(values.len(), 6 + 2);
}

#[test]
fn constant_face_varying_values_are_stored_per_triangle() {
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
        Some(MeshAttribute::Triangle(vec![unit, unit, right, right]))
    );
}

#[test]
fn skips_holes_and_faces_with_fewer_than_three_corners() {
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
        Some(MeshAttribute::Triangle(vec![
            [0.0; 3], [0.0; 3], [2.0; 3], [2.0; 3]
        ]))
    );
    assert_eq!(codes(&findings), ["mesh-unknown-face"]);
}

#[test]
fn skips_faces_with_unusable_points() {
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
fn inconsistent_counts_keep_the_consistent_faces() {
    let mut mesh = strip(2);
    mesh.face_vertex_counts = vec![4, -3, 3, 7];
    let (mesh, findings) = mesh.into_mesh("/m");
    assert_eq!(mesh.triangles, [[0, 2, 3], [0, 3, 1], [2, 4, 5]]);
    assert_eq!(codes(&findings), ["mesh-counts"]);
    assert_eq!(
        findings[0].message,
        "faces and corners are inconsistent: 1 faces have a negative number of corners, 1 faces lack corners, 1 corners belong to no face"
    );
}

#[test]
fn ignores_primvars_that_do_not_fit() {
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
        "its texture coordinates are ignored: index 6 is out of range: there are 6 values"
    );
}

#[test]
fn groups_alternating_materials() {
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
    let Some(MeshAttribute::Triangle(colors)) = mesh.colors else {
        panic!("{:?}", mesh.colors)
    };
    assert_eq!(
        colors.iter().map(|c| c[0]).collect::<Vec<_>>(),
        [0., 0., 2., 2., 1., 1., 3., 3.]
    );
}

#[test]
fn smooth_schemes_give_smooth_normals() {
    // The corner of a tetrahedron with three right angles: the normal is the diagonal for any triangulation.
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
        Some(MeshAttribute::Vertex(normals)) => normals[0],
        normals => panic!("{normals:?}"),
    };
    let expected = -(3.0_f32.sqrt().recip());
    for x in smooth(&mesh) {
        assert!((x - expected).abs() < 1e-3, "{x}");
    }
    mesh.normals = Some(Primvar::new(Interpolation::Vertex, vec![[0.0, 3.0, 4.0]; 5]));
    assert_eq!(smooth(&mesh), [0.0, 0.6, 0.8]);
    // A zero normal is replaced by its triangle's.
    mesh.normals = Some(Primvar::new(Interpolation::Vertex, vec![[0.0; 3]; 5]));
    assert_eq!(smooth(&mesh), [0.0, 0.0, -1.0]);
}

proptest! {
    #[test]
    fn knows_whether_there_are_triangles(
        counts in vec(-1..5_i32, 0..5),
        indices in vec(-1..4_i32, 0..12),
        holes in vec(0..4_i32, 0..3),
        is_finite in any::<bool>(),
    ) {
        let mesh = PolygonMesh {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, if is_finite { 1.0 } else { f32::NAN }, 0.0]],
            face_vertex_counts: counts,
            face_vertex_indices: indices,
            holes,
            ..PolygonMesh::default()
        };
        prop_assert_eq!(mesh.has_triangles(), !mesh.into_mesh("").0.triangles.is_empty());
    }
}
