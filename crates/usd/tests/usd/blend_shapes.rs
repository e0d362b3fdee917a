//! Blend shapes, compared with what `UsdSkel.BakeSkinning` of OpenUSD 26.11 makes of the same stage.

#![expect(clippy::unwrap_used, reason = "a test")]

use std::path::Path;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_usd::stage::{SceneOptions, StageScene, open_scene};

const BODY: &str = include_str!("blend_shapes.usda");

fn open(text: &str, time: f64) -> StageScene {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("face.usda");
    std::fs::write(&path, text).unwrap();
    let options = SceneOptions {
        time: Some(time),
        ..SceneOptions::default()
    };
    open_scene(Path::new(&path), &options).unwrap()
}

#[test]
fn blend_shapes_displace_points_before_the_skin() {
    // A weight between the in-between and the shape, one below it, and one beyond the shape, where displacements are extrapolated.
    let baked = [
        (
            5.0,
            [
                [0.570_710_7, 0.070_710_7, -0.15],
                [1.242_462_1, 0.742_462, 0.25],
                [-0.277_817_4, 0.777_817_5, 0.25],
                [0.323_223_4, 1.590_990_2, 0.65],
            ],
            [0.0, 0.0, 1.0],
        ),
        (
            8.0,
            [
                [0.556_568_5, 0.056_568_5, 1.18],
                [1.189_429_2, 0.689_429_1, 0.25],
                [-0.171_751_4, 0.671_751_5, 0.25],
                [0.146_446_8, 1.767_767, 0.375],
            ],
            [0.832_05, 0.0, 0.554_7],
        ),
        (
            10.0,
            [
                [0.358_578_6, -0.141_421_3, 1.05],
                [1.277_817_5, 0.777_817_4, 0.25],
                [-0.348_528_1, 0.848_528_2, 0.25],
                [0.146_446_8, 1.767_767, 0.05],
            ],
            [0.894_43, 0.0, -0.447_21],
        ),
    ];
    for (time, expected, normal) in baked {
        let read = open(BODY, time);
        assert!(read.findings.is_empty(), "{:?}", read.findings);
        let instance = &read.scene.instances[0];
        let mesh = &read.scene.meshes[instance.mesh as usize];
        for (point, expected) in mesh.positions.iter().zip(expected) {
            let at = instance
                .world_from_mesh
                .transform_point3(DVec3::from(point.map(f64::from)));
            assert!(
                (at - DVec3::from(expected)).length() < 2e-6,
                "{time}: {at} {expected:?}"
            );
        }
        // The skin turns everything by 45° about z.
        let turned = DMat3::from_rotation_z(45f64.to_radians()) * DVec3::from(normal);
        let normals = mesh.normals.as_ref().unwrap();
        let found = normals.corners(0, mesh.triangles[0]).unwrap()[0];
        assert!(
            (DVec3::from(found.map(f64::from)) - turned).length() < 2e-5,
            "{time}: {found:?}"
        );
    }
}

#[test]
fn contradictory_blend_shapes_are_reported() {
    for (from, to, part) in [
        ("[1.5, 1]", "[1.5]", "1 weights for 2 blend shapes"),
        (
            "pointIndices = [0, 3]",
            "pointIndices = [0, 9]",
            "beyond the 4 points",
        ),
        (
            "pointIndices = [0, 3]",
            "pointIndices = [0]",
            "2 offsets for 1 points",
        ),
        (
            "[</Root/Face/Frown>, </Root/Face/Smile>]",
            "[</Root/Face/Frown>]",
            "2 blend shapes and 1 targets",
        ),
        ("Face/Smile>", "Face/Grin>", "does not exist"),
    ] {
        let text = BODY.replace(from, to);
        assert_ne!(text, BODY);
        let read = open(&text, 10.0);
        let messages: Vec<String> = read.findings.iter().map(ToString::to_string).collect();
        assert!(
            messages.iter().any(|message| message.contains(part)),
            "{part}: {messages:?}"
        );
    }
}
