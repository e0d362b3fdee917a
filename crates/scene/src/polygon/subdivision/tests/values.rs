//! Tests of face-varying values, materials, limits and invalid input.

use proptest::prelude::*;

use super::*;

#[test]
fn texture_coordinates_follow_a_flat_sheet_across_a_seam() {
    use FaceVaryingRule::{All, Boundaries, CornersOnly, CornersPlus1, CornersPlus2};
    for rule in [CornersOnly, CornersPlus1, CornersPlus2, Boundaries, All] {
        let mut cage = sheet(2);
        cage.subdivision.face_varying = rule;
        let corner = |(corner, &point): (usize, &i32)| {
            let [x, y, _] = cage.points[point as usize];
            // The faces on the right have their own island.
            if corner / 4 % 2 == 0 {
                [x, y]
            } else {
                [x + 10.0, y]
            }
        };
        let values: Vec<[f32; 2]> = cage.face_vertex_indices.iter().enumerate().map(corner).collect();
        cage.uvs = Some(Primvar::new(Interpolation::FaceVarying, values));
        // Makes positions linear, too.
        cage.subdivision.scheme = Scheme::CatmullClark;
        let fine = refined(&cage, 2);
        let uvs = fine.uvs.as_ref().unwrap();
        let indices = uvs.indices.as_ref().unwrap();
        for (i, (&point, &index)) in fine.face_vertex_indices.iter().zip(indices).enumerate() {
            let [x, y, _] = fine.points[point as usize];
            let [u, v] = uvs.values[index as usize];
            let left = i / 64 % 2 == 0;
            let shift = if left { 0.0 } else { 10.0 };
            if rule == All {
                // Linear except where the sheet's corners attract the neighbouring points.
                assert!((u - shift - x).abs() < 0.2 && (v - y).abs() < 0.2);
            } else {
                assert_near([u - shift, v, 0.0], [x, y, 0.0]);
            }
        }
        // 2·(9·5) values: only the seam has two per point.
        assert_eq!(uvs.values.len(), 2 * 45, "{rule:?}");
    }
}

#[test]
fn face_varying_rules_differ_at_seams() {
    use FaceVaryingRule::{All, Boundaries, CornersOnly, CornersPlus1, CornersPlus2, None};
    // Four squares around a point: the first on its own island, the others on one that bends around it.
    let value_at_center = |rule, island_of: fn(usize) -> f32| {
        let mut cage = sheet(2);
        cage.subdivision.face_varying = rule;
        let corner = |(corner, &point): (usize, &i32)| {
            let [x, y, _] = cage.points[point as usize];
            [x * x + island_of(corner / 4), y * y]
        };
        let values: Vec<[f32; 2]> = cage.face_vertex_indices.iter().enumerate().map(corner).collect();
        cage.uvs = Some(Primvar::new(Interpolation::FaceVarying, values));
        let fine = refined(&cage, 1);
        let uvs = fine.uvs.unwrap();
        // The corners at the centre belong to child 2 of face 0 and child 3 of face 1.
        let mut found: Vec<[f32; 2]> = fine
            .face_vertex_indices
            .iter()
            .zip(uvs.indices.unwrap())
            .filter(|(point, _)| **point == 4)
            .map(|(_, index)| uvs.values[index as usize])
            .collect();
        found.dedup();
        found
    };
    let alone = |face: usize| if face == 0 { 0.0 } else { 10.0 };
    let pinned = [[1.0, 1.0], [11.0, 1.0]];
    for rule in [CornersPlus2, Boundaries, All] {
        assert_eq!(value_at_center(rule, alone), pinned, "{rule:?}");
    }
    for rule in [CornersOnly, CornersPlus1] {
        let values = value_at_center(rule, alone);
        assert_eq!(values[0], pinned[0], "{rule:?}");
        assert_ne!(values[1], pinned[1], "{rule:?}");
    }
    assert_ne!(value_at_center(None, alone)[0], pinned[0]);
    let three = |face: usize| [0.0, 10.0, 20.0, 20.0][face];
    assert_eq!(
        value_at_center(CornersPlus1, three),
        [[1.0, 1.0], [11.0, 1.0], [21.0, 1.0]]
    );
    assert_ne!(value_at_center(CornersOnly, three)[2], [21.0, 1.0]);
}

#[test]
fn children_inherit_uniform_values_and_materials() {
    let mut cage = sheet(2);
    cage.colors = Some(Primvar::new(
        Interpolation::Uniform,
        vec![[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]],
    ));
    cage.holes = vec![1];
    cage.face_materials = vec![crate::polygon::FaceMaterial {
        faces: vec![2, 99],
        material: 7,
    }];
    cage.material = Some(1);
    let fine = refined(&cage, 1);
    assert_eq!(fine.holes, [4, 5, 6, 7]);
    assert_eq!(fine.face_materials[0].faces, [-1, 8, 9, 10, 11]);
    let (mesh, findings) = fine.into_mesh("/m");
    assert_eq!(findings.len(), 1, "the face that does not exist: {findings:?}");
    let red = |triangle: usize| mesh.colors.as_ref().unwrap().corners(triangle, [0; 3]).unwrap()[0][0];
    // The faces of one material are consecutive.
    assert_eq!([red(0), red(8), red(15), red(16)], [0.0, 3.0, 3.0, 2.0]);
    assert_eq!(
        [7, 8, 16].map(|triangle| mesh.material(triangle)),
        [Some(1), Some(1), Some(7)]
    );
}

#[test]
fn limits_the_levels_by_the_number_of_faces() {
    let (cage, _) = cage::Cage::of(&sheet(1));
    let affordable = |points| cage.affordable(Scheme::CatmullClark, u32::MAX, points);
    assert_eq!(u64::pow(4, affordable(4)), cage::MAX_FACES / 2);
    assert_eq!(affordable(usize::MAX), 0);
    assert_eq!(cage.affordable(Scheme::Loop, 3, 4), 3);
}

#[test]
fn loop_rejects_quads() {
    let mut quads = sheet(1);
    quads.subdivision.scheme = Scheme::Loop;
    let (same, findings) = quads.clone().subdivided(2, "/m");
    assert_eq!(same, quads);
    assert_eq!(findings[0].code, "mesh-subdivision");
}

#[test]
fn skips_unusable_faces_and_creases() {
    let mut cage = sheet(2);
    cage.points[0][0] = f32::NAN;
    cage.face_vertex_indices[6] = 99;
    cage.subdivision.creases = vec![
        Crease {
            points: vec![4, 8],
            sharpness: vec![1.0],
        },
        Crease {
            points: vec![7, 8, 9],
            sharpness: vec![1.0; 3],
        },
        Crease {
            points: vec![4, 5],
            sharpness: vec![1.0],
        },
    ];
    cage.subdivision.corners = vec![(-1, 2.0)];
    let (fine, findings) = cage.subdivided(1, "/m");
    assert_eq!(fine.face_vertex_counts.len(), 8);
    let messages: Vec<&str> = findings.iter().map(|f| f.message.as_str()).collect();
    assert!(messages[0].starts_with("2 faces with fewer"), "{messages:?}");
    assert!(messages[1].starts_with("3 creases"), "{messages:?}");
    assert!(fine.into_mesh("/m").1.is_empty());
}

#[test]
fn an_edge_with_three_faces_stays_straight() {
    let points = vec![
        [0., 0., 0.],
        [1., 0., 0.],
        [1., 1., 0.],
        [0., 1., 0.],
        [1., -1., 1.],
        [0., -1., 1.],
        [1., -1., -1.],
        [0., -1., -1.],
    ];
    let book = mesh(
        points,
        &[vec![0, 1, 2, 3], vec![1, 0, 5, 4], vec![0, 1, 6, 7]],
        Scheme::CatmullClark,
    );
    let fine = refined(&book, 1);
    assert_eq!(fine.points[..2], book.points[..2]);
}

proptest! {
    #[test]
    fn limits_of_quads_are_invariant(offsets in prop::collection::vec(prop::array::uniform3(-0.3..0.3_f32), 26)) {
        // A cube refined once and deformed: points with 3 and with 4 edges.
        let mut cage = refined(&cube(), 1);
        for (point, offset) in cage.points.iter_mut().zip(&offsets) {
            for axis in 0..3 {
                point[axis] += offset[axis];
            }
        }
        let once = refined(&cage, 1);
        for point in 0..cage.points.len() {
            let (before, after) = (catmull_clark_limit(&cage, point), catmull_clark_limit(&once, point));
            prop_assert!(distance(before, after) < 1e-6, "{before:?} {after:?}");
        }
    }

    #[test]
    fn limits_of_triangles_are_invariant(offsets in prop::collection::vec(prop::array::uniform3(-0.3..0.3_f32), 18)) {
        let mut cage = refined(&octahedron(), 1);
        for (point, offset) in cage.points.iter_mut().zip(&offsets) {
            for axis in 0..3 {
                point[axis] += offset[axis];
            }
        }
        let once = refined(&cage, 1);
        for point in 0..cage.points.len() {
            let (before, after) = (loop_limit(&cage, point), loop_limit(&once, point));
            prop_assert!(distance(before, after) < 1e-6, "{before:?} {after:?}");
        }
    }

    /// For any faces, refinement terminates and gives a mesh with valid indices.
    #[test]
    fn any_faces_are_refined(
        faces in prop::collection::vec(prop::collection::vec(-1..9_i32, 0..6), 0..12),
        loop_scheme in any::<bool>(),
        face_varying in any::<bool>(),
    ) {
        let points = (0..8).map(|i| [i as f32, (i * i % 5) as f32, (i % 3) as f32]).collect();
        let scheme = if loop_scheme { Scheme::Loop } else { Scheme::CatmullClark };
        let mut cage = mesh(points, &faces, scheme);
        let count = cage.face_vertex_indices.len();
        let uvs: Vec<[f32; 2]> = (0..count).map(|i| [(i % 4) as f32, 0.0]).collect();
        cage.uvs = face_varying.then_some(Primvar::new(Interpolation::FaceVarying, uvs));
        cage.subdivision.face_varying = FaceVaryingRule::CornersPlus2;
        let (fine, _) = cage.subdivided(2, "/m");
        let (mesh, _) = fine.into_mesh("/m");
        for (i, triangle) in mesh.triangles.iter().enumerate() {
            prop_assert!(mesh.corners(i).unwrap().iter().flatten().all(|x| x.is_finite()));
            if let Some(uvs) = &mesh.uvs {
                prop_assert!(uvs.corners(i, *triangle).is_some());
            }
        }
    }
}
