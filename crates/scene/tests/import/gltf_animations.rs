//! Animations and morph targets, compared with arithmetic by hand.

use oaktwin_camera::math::{DQuat, DVec3};
use oaktwin_scene::import::{self, ImportOptions, ImportedScene};

use crate::gltf_builder::Builder;
use crate::support::{Files, check, messages};

const NONE: [&str; 0] = [];

fn at(file: &str, time_s: Option<f64>) -> ImportedScene {
    let files = Files::new().with("a.gltf", file);
    let options = ImportOptions {
        time_s,
        ..ImportOptions::default()
    };
    let imported = import::open(&files.path("a.gltf"), &options).unwrap();
    check(&imported.scene);
    imported
}

fn origin(imported: &ImportedScene) -> DVec3 {
    imported.scene.instances[0].world_from_mesh.translation
}

/// A channel: path, interpolation, keyframes, and the shape and the numbers of its values.
type Channel<'a> = (&'a str, &'a str, &'a [f32], &'a str, &'a [f32]);

/// A square whose node has channels.
fn moving(channels: &[Channel<'_>]) -> String {
    let mut b = Builder::new();
    let (positions, indices) = b.square();
    let (mut samplers, mut targets) = (Vec::new(), Vec::new());
    for (path, interpolation, keys, shape, values) in channels {
        let (input, output) = (b.floats("SCALAR", keys), b.floats(shape, values));
        targets.push(format!(
            r#"{{"sampler":{},"target":{{"node":0,"path":"{path}"}}}}"#,
            samplers.len()
        ));
        samplers.push(format!(
            r#"{{"input":{input},"output":{output},"interpolation":"{interpolation}"}}"#
        ));
    }
    b.member(&format!(
        r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices}}}]}}],
        "nodes":[{{"mesh":0,"translation":[5,0,0]}}],
        "animations":[{{"channels":[{}],"samplers":[{}]}}]"#,
        targets.join(","),
        samplers.join(",")
    ))
    .embedded()
}

#[test]
fn nodes_move_between_keyframes() {
    let keys = &[1.0, 3.0][..];
    let file = moving(&[("translation", "LINEAR", keys, "VEC3", &[0., 0., 0., 4., 8., 0.])]);
    // Before the first keyframe and after the last, their values hold; without a time, the node stands as in the file.
    for (time_s, expected) in [
        (None, [5., 0., 0.]),
        (Some(0.0), [0., 0., 0.]),
        (Some(1.5), [1., 2., 0.]),
        (Some(3.0), [4., 8., 0.]),
        (Some(9.0), [4., 8., 0.]),
    ] {
        let imported = at(&file, time_s);
        assert_eq!(origin(&imported), DVec3::from(expected), "{time_s:?}");
        assert_eq!(imported.animated_s, Some((1.0, 3.0)));
        let notes = if time_s.is_none() { 1 } else { 0 };
        assert_eq!(imported.findings.len(), notes);
    }
    let step = moving(&[("translation", "STEP", keys, "VEC3", &[1., 0., 0., 4., 8., 0.])]);
    assert_eq!(origin(&at(&step, Some(2.9))), DVec3::X);
    // The cubic with the values 0 and 4, and the tangents 1 and −2 per second, over 2 s.
    let values = [
        0., 0., 0., 0., 0., 0., 1., 0., 0., -2., 0., 0., 4., 0., 0., 0., 0., 0.,
    ];
    let spline = moving(&[("translation", "CUBICSPLINE", keys, "VEC3", &values)]);
    let u: f64 = 0.25;
    let expected = 2.0 * (u.powi(3) - 2.0 * u * u + u) + 4.0 * (3.0 * u * u - 2.0 * u.powi(3))
        - 4.0 * (u.powi(3) - u * u);
    assert!((origin(&at(&spline, Some(1.5))).x - expected).abs() < 1e-12);
}

#[test]
fn rotations_turn_at_a_constant_rate_and_scales_grow() {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let file = moving(&[
        (
            "rotation",
            "LINEAR",
            &[0.0, 3.0],
            "VEC4",
            &[0., 0., 0., 1., 0., 0., half, half],
        ),
        ("scale", "LINEAR", &[0.0, 3.0], "VEC3", &[1., 1., 1., 4., 1., 1.]),
    ]);
    let imported = at(&file, Some(1.0));
    let turned = DQuat::from_rotation_z(30f64.to_radians());
    let found = imported.scene.instances[0].world_from_mesh;
    assert!((found.matrix3.x_axis - turned * DVec3::X * 2.0).length() < 1e-6);
    assert!((found.matrix3.y_axis - turned * DVec3::Y).length() < 1e-6);
    assert_eq!(found.translation, DVec3::new(5.0, 0.0, 0.0));
}

#[test]
fn one_keyframe_is_a_pose() {
    let file = moving(&[("translation", "LINEAR", &[2.0], "VEC3", &[7., 0., 0.])]);
    for time_s in [0.0, 2.0, 5.0] {
        assert_eq!(origin(&at(&file, Some(time_s))), DVec3::new(7.0, 0.0, 0.0));
    }
}

#[test]
fn contradictory_animations_are_ignored_with_a_reason() {
    let values = &[0., 0., 0., 4., 8., 0.][..];
    for (file, part) in [
        (
            moving(&[("translation", "LINEAR", &[3.0, 1.0], "VEC3", values)]),
            "do not increase",
        ),
        (
            moving(&[("translation", "LINEAR", &[1.0, 2.0, 3.0], "VEC3", values)]),
            "its 3 keyframes have 2 values",
        ),
        (
            moving(&[("translation", "CUBICSPLINE", &[1.0, 2.0], "VEC3", values)]),
            "its 2 keyframes have 2 values",
        ),
        (
            moving(&[("rotation", "LINEAR", &[1.0, 2.0], "VEC3", values)]),
            "2 values",
        ),
    ] {
        // Another channel makes the file an animated one.
        let imported = at(&file, Some(1.5));
        let found = messages(&imported);
        assert!(
            imported.animated_s.is_none() || found.iter().any(|message| message.contains(part)),
            "{found:?}"
        );
        assert_eq!(origin(&imported), DVec3::new(5.0, 0.0, 0.0));
    }
}

/// A triangle with two morph targets, of which the second turns its normals.
fn morphing(weights: &str, node: &str) -> String {
    let mut b = Builder::new();
    let positions = b.floats("VEC3", &[0., 0., 0., 1., 0., 0., 0., 1., 0.]);
    let normals = b.floats("VEC3", &[0., 0., 1.].repeat(3));
    let up = b.floats("VEC3", &[0., 0., 1., 0., 0., 2., 0., 0., 3.]);
    let side = b.floats("VEC3", &[1., 0., 0.].repeat(3));
    let turn = b.floats("VEC3", &[1., 0., -1.].repeat(3));
    let keys = b.floats("SCALAR", &[0.0, 2.0]);
    let values = b.floats("SCALAR", &[0.0, 0.0, 1.0, 0.5]);
    b.member(&format!(
        r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions},"NORMAL":{normals}}},
            "targets":[{{"POSITION":{up}}},{{"POSITION":{side},"NORMAL":{turn}}}]}}]{weights}}}],
        "nodes":[{{"mesh":0{node}}}],
        "animations":[{{"channels":[{{"sampler":0,"target":{{"node":0,"path":"weights"}}}}],
            "samplers":[{{"input":{keys},"output":{values}}}]}}]"#
    ))
    .embedded()
}

#[test]
fn morph_targets_displace_vertices() {
    let points = |file: &str, time_s| {
        let imported = at(file, time_s);
        imported.scene.meshes[0].positions.clone()
    };
    let plain = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
    assert_eq!(points(&morphing("", ""), None), plain);
    // The weights of the mesh, of the node, and of the animation take precedence in this order.
    let own = r#","weights":[0.5,0]"#;
    let half = [[0., 0., 0.5], [1., 0., 1.], [0., 1., 1.5]];
    assert_eq!(points(&morphing(own, ""), None), half);
    let other = r#","weights":[0,2]"#;
    assert_eq!(
        points(&morphing(own, other), None),
        [[2., 0., 0.], [3., 0., 0.], [2., 1., 0.]]
    );
    assert_eq!(
        points(&morphing(own, other), Some(1.0)),
        [[0.25, 0., 0.5], [1.25, 0., 1.], [0.25, 1., 1.5]]
    );
    let turned = at(&morphing("", r#","weights":[0,0.5]"#), None);
    let normals = turned.scene.meshes[0].normals.as_ref().unwrap();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    for normal in normals.corners(0, [0, 1, 2]).unwrap() {
        assert!((normal[0] - half).abs() < 1e-6 && (normal[2] - half).abs() < 1e-6);
    }
    assert_eq!(messages(&at(&morphing(own, other), Some(1.0))), NONE);
}
