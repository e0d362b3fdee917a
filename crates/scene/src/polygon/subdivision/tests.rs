//! Refinement against closed forms: what one level gives, and limits that no level may move.

use proptest::prelude::*;

use super::*;
use crate::polygon::{Interpolation, PolygonMesh, Primvar};

/// A cube of edge 2 about the origin.
fn cube() -> PolygonMesh {
    let signs = [-1.0_f32, 1.0];
    let points = (0..8)
        .map(|i| [signs[i & 1], signs[i >> 1 & 1], signs[i >> 2]])
        .collect();
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    mesh(points, &faces.map(|face| face.to_vec()), Scheme::CatmullClark)
}

fn octahedron() -> PolygonMesh {
    let points = vec![
        [1., 0., 0.],
        [-1., 0., 0.],
        [0., 1., 0.],
        [0., -1., 0.],
        [0., 0., 1.],
        [0., 0., -1.],
    ];
    let faces = [
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ];
    mesh(points, &faces.map(|face| face.to_vec()), Scheme::Loop)
}

/// A sheet of `n`×`n` unit squares.
fn sheet(n: u8) -> PolygonMesh {
    let side = i32::from(n) + 1;
    let points = (0..=n)
        .flat_map(|y| (0..=n).map(move |x| [f32::from(x), f32::from(y), 0.0]))
        .collect();
    let faces: Vec<Vec<i32>> = (0..side - 1)
        .flat_map(|y| (0..side - 1).map(move |x| y * side + x))
        .map(|first| vec![first, first + 1, first + side + 1, first + side])
        .collect();
    mesh(points, &faces, Scheme::CatmullClark)
}

fn mesh(points: Vec<[f32; 3]>, faces: &[Vec<i32>], scheme: Scheme) -> PolygonMesh {
    PolygonMesh {
        points,
        face_vertex_counts: faces.iter().map(|face| face.len() as i32).collect(),
        face_vertex_indices: faces.concat(),
        subdivision: Subdivision {
            scheme,
            ..Subdivision::default()
        },
        ..PolygonMesh::default()
    }
}

fn refined(mesh: &PolygonMesh, levels: u32) -> PolygonMesh {
    let (refined, findings) = mesh.clone().subdivided(levels, "/m");
    assert!(findings.is_empty(), "{findings:?}");
    refined
}

fn assert_near(a: [f32; 3], b: [f32; 3]) {
    assert!(distance(a, b) < 1e-6, "{a:?} is not {b:?}");
}

fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// The faces' corners, one list each.
fn faces(mesh: &PolygonMesh) -> Vec<&[i32]> {
    let mut rest = mesh.face_vertex_indices.as_slice();
    let mut faces = Vec::new();
    for &count in &mesh.face_vertex_counts {
        let (face, tail) = rest.split_at(count as usize);
        faces.push(face);
        rest = tail;
    }
    faces
}

/// Neighbours along edges and, in each face of four, across it.
fn neighbours(mesh: &PolygonMesh, point: usize) -> (Vec<usize>, Vec<usize>) {
    let (mut along, mut across) = (Vec::new(), Vec::new());
    for face in faces(mesh) {
        let n = face.len();
        for (i, &corner) in face.iter().enumerate() {
            if corner as usize == point {
                along.extend([face[(i + 1) % n] as usize, face[(i + n - 1) % n] as usize]);
                if n == 4 {
                    across.push(face[(i + 2) % n] as usize);
                }
            }
        }
    }
    along.sort_unstable();
    along.dedup();
    (along, across)
}

fn weighted(mesh: &PolygonMesh, parts: &[(&[usize], f64)]) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for (points, weight) in parts {
        for &point in *points {
            for (sum, x) in sum.iter_mut().zip(mesh.points[point]) {
                *sum += weight * f64::from(x);
            }
        }
    }
    sum.map(|x| x as f32)
}

/// Where a point inside a surface of quads ends up: the eigenvector of Catmull and Clark's matrix.
fn catmull_clark_limit(mesh: &PolygonMesh, point: usize) -> [f32; 3] {
    let (along, across) = neighbours(mesh, point);
    let n = along.len() as f64;
    let whole = n * (n + 5.0);
    weighted(
        mesh,
        &[
            (&[point], n * n / whole),
            (&along, 4.0 / whole),
            (&across, 1.0 / whole),
        ],
    )
}

fn loop_limit(mesh: &PolygonMesh, point: usize) -> [f32; 3] {
    let (along, _) = neighbours(mesh, point);
    let n = along.len() as f64;
    let cosine = (std::f64::consts::TAU / n).cos();
    let beta = (0.625 - (0.375 + 0.25 * cosine).powi(2)) / n;
    let chi = 1.0 / (0.375 / beta + n);
    weighted(mesh, &[(&[point], 1.0 - n * chi), (&along, chi)])
}

#[test]
fn a_cube_once() {
    let once = refined(&cube(), 1);
    assert_eq!(once.face_vertex_counts, [4; 24]);
    assert_eq!(once.points.len(), 8 + 12 + 6);
    for (point, cage) in once.points.iter().zip(cube().points) {
        assert_near(*point, cage.map(|x| x * 5.0 / 9.0));
    }
    for edge in &once.points[8..20] {
        assert_near(
            edge.map(f32::abs),
            edge.map(|x| if x == 0.0 { 0.0 } else { 0.75 }),
        );
    }
    for face in &once.points[20..] {
        assert_eq!(face.iter().map(|x| x.abs()).sum::<f32>(), 1.0);
    }
    // The first child of a face is in its first corner and winds as it does.
    assert_eq!(faces(&once)[0][0], 0);
    let (mesh, _) = refined(&cube(), 2).into_mesh("/m");
    for triangle in 0..mesh.triangles.len() {
        let [a, b, c] = mesh
            .corners(triangle)
            .unwrap()
            .map(|p| oaktwin_camera::math::DVec3::from(p.map(f64::from)));
        assert!((b - a).cross(c - a).dot(a + b + c) > 0.0);
    }
}

#[test]
fn an_octahedron_once() {
    let once = refined(&octahedron(), 1);
    assert_eq!(once.face_vertex_counts, [3; 32]);
    for (point, cage) in once.points.iter().zip(octahedron().points) {
        assert_near(*point, cage.map(|x| x * 33.0 / 64.0));
    }
    for edge in &once.points[6..] {
        assert_near(
            edge.map(f32::abs),
            edge.map(|x| if x == 0.0 { 0.0 } else { 0.375 }),
        );
    }
}

#[test]
fn linear_refinement_moves_nothing() {
    let mut cage = cube();
    cage.subdivision.scheme = Scheme::Bilinear;
    let fine = refined(&cage, 2);
    assert_eq!(fine.points[..8], cage.points);
    for point in &fine.points {
        assert_eq!(point.iter().fold(0.0_f32, |m, x| m.max(x.abs())), 1.0);
    }
    assert_eq!(fine.face_vertex_counts.len(), 6 * 16);
}

#[test]
fn polygons_of_any_kind_become_quads() {
    let points = vec![
        [0., 0., 0.],
        [2., 0., 0.],
        [2., 2., 0.],
        [0., 2., 0.],
        [1., 1., 2.],
    ];
    let pyramid = mesh(
        points,
        &[
            vec![0, 3, 2, 1],
            vec![0, 1, 4],
            vec![1, 2, 4],
            vec![2, 3, 4],
            vec![3, 0, 4],
        ],
        Scheme::CatmullClark,
    );
    let once = refined(&pyramid, 1);
    assert_eq!(once.face_vertex_counts, [4; 16]);
    // The tip, by the rule for n = 4: (F + 2R + P) / 4.
    assert_near(once.points[4], [1.0, 1.0, (2.0 / 3.0 + 2.0 + 2.0) / 4.0]);
}

/// What `OpenSubdiv` 3 answers (through the Python package `pyOpenSubdiv` 0.0.3, which interpolates edges only).
#[test]
fn an_open_mesh_of_triangles_and_quads_as_opensubdiv_has_it() {
    let points = vec![
        [0., 0., 0.],
        [2., 0., 0.],
        [2., 2., 0.],
        [0., 2., 0.],
        [1., 1., 2.],
        [4., 0., 0.5],
        [4., 2., 1.],
    ];
    let faces = [
        vec![0, 1, 4],
        vec![1, 2, 4],
        vec![2, 3, 4],
        vec![3, 0, 4],
        vec![1, 5, 6, 2],
    ];
    let mut cage = mesh(points, &faces, Scheme::CatmullClark);
    cage.subdivision.boundary = BoundaryRule::EdgeOnly;
    let once = refined(&cage, 1);
    let answer = [
        [0.25, 0.25, 0.0],
        [2.0, 0.0, 0.0625],
        [2.0, 2.0, 0.125],
        [0.25, 1.75, 0.0],
        [1.0, 1.0, 1.16667],
        [3.75, 0.25, 0.5],
        [3.75, 1.75, 0.8125],
        [1.0, 0.33333, 0.66667],
        [1.66667, 1.0, 0.66667],
        [1.0, 1.66667, 0.66667],
        [0.33333, 1.0, 0.66667],
        [3.0, 1.0, 0.375],
        [1.0, 0.0, 0.0],
        [1.41667, 0.58333, 0.83333],
        [0.58333, 0.58333, 0.83333],
        [2.16667, 1.0, 0.26042],
        [1.41667, 1.41667, 0.83333],
        [1.0, 2.0, 0.0],
        [0.58333, 1.41667, 0.83333],
        [0.0, 1.0, 0.0],
        [3.0, 0.0, 0.25],
        [4.0, 1.0, 0.75],
        [3.0, 2.0, 0.5],
    ];
    assert_eq!(once.points.len(), answer.len());
    for (i, point) in answer.iter().enumerate() {
        if i < cage.points.len() {
            assert!(
                distance(*point, once.points[i]) < 1e-5,
                "{point:?} {:?}",
                once.points[i]
            );
        }
        let near = once.points.iter().filter(|own| distance(*point, **own) < 1e-5);
        assert_eq!(near.count(), 1, "{point:?}");
    }
}

#[test]
fn borders_are_splines_and_corners_stay_if_asked() {
    for (rule, corner) in [
        (BoundaryRule::EdgeAndCorner, [0.0, 0.0, 0.0]),
        (BoundaryRule::EdgeOnly, [0.125, 0.125, 0.0]),
    ] {
        let mut cage = sheet(2);
        cage.points[1][2] = 1.0;
        cage.subdivision.boundary = rule;
        let once = refined(&cage, 1);
        let z = if rule == BoundaryRule::EdgeOnly {
            0.125
        } else {
            0.0
        };
        assert_near(once.points[0], [corner[0], corner[1], z]);
        assert_near(once.points[1], [1.0, 0.0, 0.75]);
    }
    let mut cage = sheet(4);
    cage.subdivision.boundary = BoundaryRule::None;
    let once = refined(&cage, 1);
    assert_eq!(once.holes.len(), 4 * 12);
    assert_eq!(once.into_mesh("/m").0.triangles.len(), 2 * 4 * 4);
}

#[test]
fn creases_hold_as_long_as_they_say() {
    let ring = vec![0, 1, 3, 2, 0];
    let with = |sharpness: f32| {
        let mut cage = cube();
        cage.subdivision.creases.push(Crease {
            points: ring.clone(),
            sharpness: vec![sharpness],
        });
        cage
    };
    // A square with creases all round is a curve of its own: two levels of a spline.
    let forever = refined(&with(10.0), 1);
    assert_near(forever.points[0], [-0.75, -0.75, -1.0]);
    assert_eq!(refined(&with(2.0), 2).points, refined(&with(10.0), 2).points);
    assert_ne!(refined(&with(2.0), 3).points, refined(&with(10.0), 3).points);
    // Below one it is a mixture.
    let (smooth, sharp, between) = (
        refined(&cube(), 1),
        refined(&with(1.0), 1),
        refined(&with(0.25), 1),
    );
    for ((a, b), c) in smooth.points.iter().zip(&sharp.points).zip(&between.points) {
        assert_near(*c, [0, 1, 2].map(|i| 0.75 * a[i] + 0.25 * b[i]));
    }
}

#[test]
fn corners_hold_as_long_as_they_say() {
    let with = |sharpness: f32| {
        let mut cage = cube();
        cage.subdivision.corners.push((0, sharpness));
        cage
    };
    assert_near(refined(&with(10.0), 3).points[0], [-1.0; 3]);
    assert_near(refined(&with(1.0), 1).points[0], [-1.0; 3]);
    let half = -(1.0 + 5.0 / 9.0) / 2.0;
    assert_near(refined(&with(0.5), 1).points[0], [half; 3]);
    // Three creases that meet are a corner.
    let mut cage = cube();
    for end in [1, 2, 4] {
        cage.subdivision.creases.push(Crease {
            points: vec![0, end],
            sharpness: vec![10.0],
        });
    }
    assert_near(refined(&cage, 2).points[0], [-1.0; 3]);
}

#[test]
fn texture_coordinates_follow_a_flat_sheet_across_a_seam() {
    use FaceVaryingRule::{All, Boundaries, CornersOnly, CornersPlus1, CornersPlus2};
    for rule in [CornersOnly, CornersPlus1, CornersPlus2, Boundaries, All] {
        let mut cage = sheet(2);
        cage.subdivision.face_varying = rule;
        let corner = |(corner, &point): (usize, &i32)| {
            let [x, y, _] = cage.points[point as usize];
            // The faces on the right have an island of their own.
            if corner / 4 % 2 == 0 {
                [x, y]
            } else {
                [x + 10.0, y]
            }
        };
        let values: Vec<[f32; 2]> = cage.face_vertex_indices.iter().enumerate().map(corner).collect();
        cage.uvs = Some(Primvar::new(Interpolation::FaceVarying, values));
        // So that positions are linear too.
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
                // Linear, where the sheet's own corners draw the points beside them.
                assert!((u - shift - x).abs() < 0.2 && (v - y).abs() < 0.2);
            } else {
                assert_near([u - shift, v, 0.0], [x, y, 0.0]);
            }
        }
        // 2·(9·5) values and no more: only the seam has two.
        assert_eq!(uvs.values.len(), 2 * 45, "{rule:?}");
    }
}

#[test]
fn rules_of_face_varying_values_differ_where_they_should() {
    use FaceVaryingRule::{All, Boundaries, CornersOnly, CornersPlus1, CornersPlus2, None};
    // Four squares round a point: the first alone on an island, the others on one that bends round it.
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
        // Child 2 of face 0 and child 3 of face 1 begin at the centre's neighbours; find the corner at the centre.
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
fn what_belongs_to_faces_goes_to_their_children() {
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
    // The faces of one material follow each other.
    assert_eq!([red(0), red(8), red(15), red(16)], [0.0, 3.0, 3.0, 2.0]);
    assert_eq!(
        [7, 8, 16].map(|triangle| mesh.material(triangle)),
        [Some(1), Some(1), Some(7)]
    );
}

#[test]
fn levels_end_before_there_are_too_many_faces() {
    let (cage, _) = cage::Cage::of(&sheet(1));
    let affordable = |points| cage.affordable(Scheme::CatmullClark, u32::MAX, points);
    assert_eq!(u64::pow(4, affordable(4)), cage::MOST_FACES / 2);
    assert_eq!(affordable(usize::MAX), 0);
    assert_eq!(cage.affordable(Scheme::Loop, 3, 4), 3);
}

#[test]
fn loops_scheme_wants_triangles() {
    let mut quads = sheet(1);
    quads.subdivision.scheme = Scheme::Loop;
    let (same, findings) = quads.clone().subdivided(2, "/m");
    assert_eq!(same, quads);
    assert_eq!(findings[0].code, "mesh-subdivision");
}

#[test]
fn unusable_faces_and_creases_are_left_out() {
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
    assert!(messages[0].ends_with("left out: 2"), "{messages:?}");
    assert!(messages[1].ends_with("points: 3"), "{messages:?}");
    assert!(fine.into_mesh("/m").1.is_empty());
}

#[test]
fn three_faces_at_an_edge_keep_it_straight() {
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
    fn limits_of_quads_stay(offsets in prop::collection::vec(prop::array::uniform3(-0.3..0.3_f32), 26)) {
        // Every point of a cube once refined, moved about: points of 3 and of 4 edges.
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
    fn limits_of_triangles_stay(offsets in prop::collection::vec(prop::array::uniform3(-0.3..0.3_f32), 18)) {
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

    /// Whatever the faces, levels end and give a mesh whose indices fit.
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
