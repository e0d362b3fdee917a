use oaktwin_camera::math::DVec3;

use super::*;
use crate::MeshAttribute;

fn corners(mesh: &Mesh, triangle: usize) -> [DVec3; 3] {
    mesh.corners(triangle)
        .unwrap()
        .map(|p| DVec3::from(p.map(f64::from)))
}

/// Checks that a mesh is closed, oriented outwards and without slivers; returns its volume and area.
fn measure(mesh: &Mesh) -> (f64, f64) {
    let (mut volume, mut area) = (0.0, 0.0);
    let mut edges = std::collections::BTreeMap::new();
    for triangle in 0..mesh.triangles.len() {
        let [a, b, c] = corners(mesh, triangle);
        let normal = (b - a).cross(c - a);
        assert!(normal.length() > 0.0, "triangle {triangle} is empty");
        volume += a.dot(b.cross(c)) / 6.0;
        area += normal.length() / 2.0;
        // Normals agree with the winding.
        let Some(MeshAttribute::Vertex(normals)) = &mesh.normals else {
            panic!("no normals")
        };
        for vertex in mesh.triangles[triangle] {
            let authored = DVec3::from(normals[vertex as usize].map(f64::from));
            assert!((authored.length() - 1.0).abs() < 1e-6);
            assert!(authored.dot(normal.normalize()) > 0.99, "triangle {triangle}");
        }
        // Every edge, by position, has an opposite.
        let bits = mesh
            .corners(triangle)
            .unwrap()
            .map(|p| p.map(|x| (x + 0.0).to_bits()));
        for i in 0..3 {
            *edges.entry((bits[i], bits[(i + 1) % 3])).or_insert(0) += 1;
            *edges.entry((bits[(i + 1) % 3], bits[i])).or_insert(0) -= 1;
        }
    }
    assert!(edges.values().all(|&count| count == 0), "it is open");
    (volume, area)
}

fn assert_close(measured: f64, exact: f64) {
    let ratio = measured / exact;
    assert!((0.998..1.000_001).contains(&ratio), "{measured} of {exact}");
}

fn extent(mesh: &Mesh) -> [[f32; 3]; 2] {
    mesh.positions
        .iter()
        .fold([[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], |[low, high], p| {
            [0, 1].map(|end| {
                [0, 1, 2].map(|i| {
                    if end == 0 {
                        low[i].min(p[i])
                    } else {
                        high[i].max(p[i])
                    }
                })
            })
        })
}

#[test]
fn shapes_are_closed_with_the_exact_volume_and_area() {
    use std::f64::consts::PI;
    let (volume, area) = measure(&cube(3.0));
    assert!((volume - 27.0).abs() < 1e-9 && (area - 54.0).abs() < 1e-9);
    let (volume, area) = measure(&sphere(0.5));
    assert_close(volume, PI / 6.0);
    assert_close(area, PI);
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let (volume, area) = measure(&cylinder(2.0, 5.0, axis));
        assert_close(volume, 20.0 * PI);
        assert_close(area, 28.0 * PI);
        let (volume, area) = measure(&cone(3.0, 4.0, axis));
        assert_close(volume, 12.0 * PI);
        assert_close(area, 24.0 * PI);
        let (volume, _) = measure(&capsule(1.0, 2.0, axis));
        assert_close(volume, PI * (2.0 + 4.0 / 3.0));
    }
}

#[test]
fn shapes_extend_along_their_axes() {
    assert_eq!(extent(&cube(2.0)), [[-1.0; 3], [1.0; 3]]);
    assert_eq!(extent(&sphere(2.0)), [[-2.0; 3], [2.0; 3]]);
    assert_eq!(extent(&cylinder(1.0, 6.0, Axis::X))[1], [3.0, 1.0, 1.0]);
    assert_eq!(extent(&cone(1.0, 6.0, Axis::Y))[1], [1.0, 3.0, 1.0]);
    assert_eq!(extent(&capsule(1.0, 6.0, Axis::Z))[1], [1.0, 1.0, 4.0]);
    // The tip is on the positive side.
    let tips = cone(1.0, 6.0, Axis::Y)
        .positions
        .into_iter()
        .filter(|p| p[1] > 2.0);
    assert!(tips.clone().count() > 0);
    for tip in tips {
        assert_eq!(tip, [0.0, 3.0, 0.0]);
    }
}

#[test]
fn planes_face_along_their_axes() {
    for (axis, extents, normal) in [
        (Axis::X, [0.0, 3.0, 2.0], [1.0, 0.0, 0.0]),
        (Axis::Y, [2.0, 0.0, 3.0], [0.0, 1.0, 0.0]),
        (Axis::Z, [2.0, 3.0, 0.0], [0.0, 0.0, 1.0]),
    ] {
        let mesh = plane(4.0, 6.0, axis);
        assert_eq!(extent(&mesh)[1], extents, "{axis:?}");
        assert!(mesh.double_sided);
        for triangle in 0..2 {
            let [a, b, c] = corners(&mesh, triangle);
            assert_eq!((b - a).cross(c - a).normalize(), DVec3::from(normal));
        }
        assert_eq!(
            mesh.normals,
            Some(MeshAttribute::Vertex(vec![normal.map(|x| x as f32); 4]))
        );
    }
}

#[test]
fn invalid_sizes_give_no_triangles() {
    for size in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e300, 1e-300] {
        assert_eq!(cube(size), Mesh::default());
        assert_eq!(sphere(size), Mesh::default());
        assert_eq!(cylinder(1.0, size, Axis::Z), Mesh::default());
        assert_eq!(cone(size, 1.0, Axis::Z), Mesh::default());
        assert_eq!(capsule(1.0, size, Axis::Z), Mesh::default());
        assert_eq!(plane(1.0, size, Axis::Z), Mesh::default());
    }
}
