//! Skinned meshes, in the pose of their joints' nodes.

use oaktwin_camera::math::{DAffine3, DQuat, DVec3};

use crate::gltf_builder::Builder;
use crate::support::{messages, open, triangles};

const NONE: [&str; 0] = [];

fn columns(transform: DAffine3) -> [f32; 16] {
    let m = transform.matrix3;
    let columns = [m.x_axis, m.y_axis, m.z_axis, transform.translation];
    let mut numbers = [0.0; 16];
    for (i, column) in columns.iter().enumerate() {
        let column = column.to_array().map(|x| x as f32);
        numbers[4 * i..4 * i + 3].copy_from_slice(&column);
    }
    numbers[15] = 1.0;
    numbers
}

/// A strip of three squares' width along x, whose left points follow joint 0 and whose right points follow joint 1; the points
/// between follow both.
fn strip(inverse_bind: &[DAffine3], nodes: &str) -> Builder {
    let mut b = Builder::new();
    let positions = b.floats(
        "VEC3",
        &[
            0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0., 2., 0., 0., 2., 1., 0.,
        ],
    );
    let normals = b.floats("VEC3", &[0., 0., 1.].repeat(6));
    let indices = b.shorts(&[0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5]);
    let joints = b.view(&[0, 1, 0, 0].repeat(6), None);
    let joints = b.accessor(&format!(
        r#""bufferView":{joints},"componentType":5121,"count":6,"type":"VEC4""#
    ));
    // In bytes, and not quite normalized.
    let weights: Vec<u8> = [
        [255, 0, 0, 0],
        [255, 0, 0, 0],
        [127, 127, 0, 0],
        [127, 127, 0, 0],
        [0, 255, 0, 0],
        [0, 255, 0, 0],
    ]
    .concat();
    let weights = b.view(&weights, None);
    let weights = b.accessor(&format!(
        r#""bufferView":{weights},"componentType":5121,"normalized":true,"count":6,"type":"VEC4""#
    ));
    let matrices: Vec<f32> = inverse_bind.iter().flat_map(|m| columns(*m)).collect();
    let matrices = b.floats("MAT4", &matrices);
    b.member(&format!(
        r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions},"NORMAL":{normals},
            "JOINTS_0":{joints},"WEIGHTS_0":{weights}}},"indices":{indices}}}]}}],
        "skins":[{{"joints":[1,2],"inverseBindMatrices":{matrices}}}],"nodes":[{nodes}]"#
    ))
}

/// The points of the strip: left, middle and right, each below and above.
fn points(imported: &oaktwin_scene::import::ImportedScene) -> [DVec3; 6] {
    let [a, b, c, d] = triangles(&imported.scene).try_into().unwrap();
    [a[0], a[2], a[1], b[2], c[1], d[2]]
}

#[test]
fn the_node_s_own_transform_has_no_effect() {
    let identity = [DAffine3::IDENTITY; 2];
    // Exporters scale the armature, and the mesh beside it has the file's numbers in centimetres.
    let nodes = r#"{"name":"body","mesh":0,"skin":0,"translation":[7,8,9],"scale":[3,3,3]},
        {"name":"hips","children":[2],"scale":[0.01,0.01,0.01],"translation":[0,0,-1]},{"name":"chest"}"#;
    let imported = open("a.gltf", strip(&identity, nodes).embedded());
    assert_eq!(messages(&imported), NONE);
    let scene = &imported.scene;
    assert_eq!(scene.instances[0].path, "/body");
    // In its bind pose a mesh keeps the file's numbers.
    assert_eq!(scene.meshes[0].positions[4], [2.0, 0.0, 0.0]);
    let found = points(&imported);
    assert!(
        (found[5] - DVec3::new(0.02, 0.01, -1.0)).length() < 1e-9,
        "{}",
        found[5]
    );
}

#[test]
fn vertices_follow_their_joints() {
    // The joints are at the strip's left end and middle; in the file's pose the second is turned upwards about y.
    let inverse_bind = [DAffine3::IDENTITY, DAffine3::from_translation(-DVec3::X)];
    let half = 0.5_f64.sqrt();
    let nodes = format!(
        r#"{{"mesh":0,"skin":0}},{{"children":[2]}},{{"translation":[1,0,0],"rotation":[0,{},0,{half}]}}"#,
        -half
    );
    let imported = open("a.gltf", strip(&inverse_bind, &nodes).embedded());
    let turned =
        DAffine3::from_rotation_translation(DQuat::from_rotation_y(-std::f64::consts::FRAC_PI_2), DVec3::X);
    let second = turned * inverse_bind[1];
    for (i, found) in points(&imported).into_iter().enumerate() {
        let point = DVec3::new((i / 2) as f64, (i % 2) as f64, 0.0);
        let follows = [
            point,
            point.midpoint(second.transform_point3(point)),
            second.transform_point3(point),
        ];
        assert!((found - follows[i / 2]).length() < 1e-6, "{i}: {found}");
    }
    let normals = imported.scene.meshes[0].normals.as_ref().unwrap();
    let [_, right, _] = normals.corners(2, imported.scene.meshes[0].triangles[2]).unwrap();
    assert!((right[0] + 1.0).abs() < 1e-6, "{right:?}");
}

#[test]
fn invalid_skins_leave_the_mesh_at_its_node() {
    let nodes = r#"{"mesh":0,"skin":0,"translation":[0,0,3]},{"children":[2]},{"name":"b"}"#;
    let good = strip(&[DAffine3::IDENTITY; 2], nodes).embedded();
    for (from, to, why) in [
        (
            r#""skin":0"#,
            r#""skin":4"#,
            "/node_0: its skin is ignored: it does not exist",
        ),
        (
            r#""joints":[1,2]"#,
            r#""joints":[]"#,
            "/node_0: its skin is ignored: it has no joints",
        ),
        (
            r#""joints":[1,2]"#,
            r#""joints":[1,9]"#,
            "/node_0: its skin is ignored: a joint does not exist",
        ),
        (
            r#""joints":[1,2]"#,
            r#""joints":[1,2,1]"#,
            "/node_0: its skin is ignored: its 3 joints have no inverse bind matrices",
        ),
        (
            r#""joints":[1,2]"#,
            r#""joints":[1]"#,
            "meshes[0].primitives[0]: its skin is ignored: a vertex follows joint 1 of 1",
        ),
        (
            "WEIGHTS_0",
            "WEIGHTS_1",
            "meshes[0].primitives[0]: its skin is ignored: it has no JOINTS_0 and WEIGHTS_0",
        ),
    ] {
        let imported = open("a.gltf", good.replace(from, to));
        assert_eq!(messages(&imported), [why]);
        let found = points(&imported);
        assert!(
            (found[5] - DVec3::new(2.0, 1.0, 3.0)).length() < 1e-6,
            "{why}: {}",
            found[5]
        );
    }
}
