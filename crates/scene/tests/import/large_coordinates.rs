//! Files in coordinates of a national grid, as surveys and scans have them.

use oaktwin_camera::math::DVec3;

use crate::gltf_builder::Builder;
use crate::support::{messages, open, triangles};

const ORIGIN: DVec3 = DVec3::new(499_123.4, 4_649_776.2, 215.7);
/// Two triangles with edges of a few centimetres; the last point belongs to none.
const POINTS: [[f64; 3]; 5] = [
    [0.0, 0.0, 0.01],
    [0.05, 0.0, -0.012],
    [0.0501, 0.05, 0.0203],
    [0.0, 0.0503, 0.0004],
    [-1e6, -1e6, -1e6],
];
const TRIANGLES: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

fn point(i: usize) -> DVec3 {
    ORIGIN + DVec3::from(POINTS[i])
}

fn obj() -> String {
    let points: String = (0..5)
        .map(point)
        .map(|p| format!("v {} {} {}\n", p.x, p.y, p.z))
        .collect();
    let [first, second] = TRIANGLES.map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    format!("{points}o one\n{first}o two\n{second}")
}

fn ply_header(format: &str, kind: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex 5\nproperty {kind} x\nproperty {kind} y\nproperty {kind} z\n\
        element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    )
}

fn text_ply() -> Vec<u8> {
    let points: String = (0..5)
        .map(point)
        .map(|p| format!("{} {} {}\n", p.x, p.y, p.z))
        .collect();
    let faces: String = TRIANGLES.map(|[a, b, c]| format!("3 {a} {b} {c}\n")).concat();
    (ply_header("ascii", "float") + &points + &faces).into()
}

fn binary_ply() -> Vec<u8> {
    let mut bytes = ply_header("binary_little_endian", "double").into_bytes();
    bytes.extend(
        (0..5)
            .flat_map(|i| point(i).to_array())
            .flat_map(f64::to_le_bytes),
    );
    for triangle in TRIANGLES {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|i| (*i as i32).to_le_bytes()));
    }
    bytes
}

fn stl() -> String {
    let facet = |corners: [usize; 3]| {
        let vertex = |p: DVec3| format!("vertex {} {} {}\n", p.x, p.y, p.z);
        let corners: String = corners.map(point).map(vertex).concat();
        format!("facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n")
    };
    format!("solid\n{}endsolid\n", TRIANGLES.map(facet).concat())
}

/// A node with a transform in double precision.
fn gltf(transform: &str) -> Vec<u8> {
    let mut b = Builder::new();
    let numbers: Vec<f32> = POINTS[..4].iter().flatten().map(|x| *x as f32).collect();
    let (positions, indices) = (b.floats("VEC3", &numbers), b.shorts(&[0, 1, 2, 0, 2, 3]));
    b.member(&format!(
        r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices}}}]}}],
        "nodes":[{{"mesh":0,{transform}}}]"#
    ))
    .embedded()
    .into()
}

#[test]
fn every_format_keeps_the_digits() {
    let [x, y, z] = ORIGIN.to_array();
    for (name, bytes) in [
        ("a.obj", obj().into_bytes()),
        ("text.ply", text_ply()),
        ("binary.ply", binary_ply()),
        ("a.stl", stl().into_bytes()),
        ("moved.gltf", gltf(&format!(r#""translation":[{x},{y},{z}]"#))),
        (
            "matrix.gltf",
            gltf(&format!(r#""matrix":[1,0,0,0,0,1,0,0,0,0,1,0,{x},{y},{z},1]"#)),
        ),
    ] {
        let imported = open(name, bytes);
        assert_eq!(messages(&imported), [""; 0], "{name}");
        let found = triangles(&imported.scene);
        assert_eq!(found.len(), 2, "{name}");
        for (found, corners) in found.iter().zip(TRIANGLES) {
            for (found, corner) in found.iter().zip(corners) {
                let error = (*found - point(corner)).length();
                assert!(error < 1e-7, "{name}: {error}");
            }
        }
    }
}

#[test]
fn objects_share_the_points_between_them() {
    let scene = open("a.obj", obj()).scene;
    let [one, two] = [0, 1].map(|i| &scene.instances[i]);
    assert_eq!(one.world_from_mesh, two.world_from_mesh);
    let [one, two] = [one, two].map(|instance| &scene.meshes[instance.mesh as usize].positions);
    assert_eq!((one[0], one[2]), (two[0], two[1]));
}

#[test]
fn objects_far_apart_are_each_exact() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3000000.5 0 0\nv 3000001.25 0 0\nv 3000000.5 1.125 0\n\
        o here\nf 1 2 3\no there\nf 4 5 6\n";
    let found = triangles(&open("a.obj", text).scene);
    assert_eq!(found[0][1], DVec3::X);
    assert_eq!(found[1][1], DVec3::new(3_000_001.25, 0.0, 0.0));
    assert_eq!(found[1][2], DVec3::new(3_000_000.5, 1.125, 0.0));
}
