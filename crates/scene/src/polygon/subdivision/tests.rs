//! Tests of subdivision against closed forms: the results of one level, and limit points, which no level moves.

mod values;

use super::*;
use crate::polygon::{Interpolation, PolygonMesh, Primvar};

/// A cube with edges of length 2, centred on the origin.
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

/// The corners of each face.
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

/// The neighbours along edges and, in quads, across the diagonal.
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

/// The limit of a point inside a surface of quads: the eigenvector of the Catmull-Clark matrix.
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
fn refines_a_cube_once() {
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
    // The first child of a face is at its first corner and has its winding.
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
fn refines_an_octahedron_once() {
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
fn all_polygons_become_quads() {
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

/// Expected values from `OpenSubdiv` 3 (Python package `pyOpenSubdiv` 0.0.3, which only interpolates at edges).
#[test]
fn an_open_mesh_of_triangles_and_quads_matches_opensubdiv() {
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
fn borders_are_splines_with_optionally_fixed_corners() {
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
fn creases_last_for_their_sharpness() {
    let ring = vec![0, 1, 3, 2, 0];
    let with = |sharpness: f32| {
        let mut cage = cube();
        cage.subdivision.creases.push(Crease {
            points: ring.clone(),
            sharpness: vec![sharpness],
        });
        cage
    };
    // A square with creases all round is a spline curve: two levels of it.
    let forever = refined(&with(10.0), 1);
    assert_near(forever.points[0], [-0.75, -0.75, -1.0]);
    assert_eq!(refined(&with(2.0), 2).points, refined(&with(10.0), 2).points);
    assert_ne!(refined(&with(2.0), 3).points, refined(&with(10.0), 3).points);
    // A sharpness below one interpolates.
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
fn corners_last_for_their_sharpness() {
    let with = |sharpness: f32| {
        let mut cage = cube();
        cage.subdivision.corners.push((0, sharpness));
        cage
    };
    assert_near(refined(&with(10.0), 3).points[0], [-1.0; 3]);
    assert_near(refined(&with(1.0), 1).points[0], [-1.0; 3]);
    let half = -(1.0 + 5.0 / 9.0) / 2.0;
    assert_near(refined(&with(0.5), 1).points[0], [half; 3]);
    // Three creases that meet act as a corner.
    let mut cage = cube();
    for end in [1, 2, 4] {
        cage.subdivision.creases.push(Crease {
            points: vec![0, end],
            sharpness: vec![10.0],
        });
    }
    assert_near(refined(&cage, 2).points[0], [-1.0; 3]);
}
