//! Extensions that place, multiply and hide meshes.

use oaktwin_camera::math::DVec3;

use crate::gltf_builder::Builder;
use crate::support::{error, messages, open, triangles};

const NONE: [&str; 0] = [];

fn paths(scene: &oaktwin_scene::Scene) -> Vec<&str> {
    scene.instances.iter().map(|i| i.path.as_str()).collect()
}

/// A square at a node with instances, the attributes of which are given.
fn instanced(attributes: impl FnOnce(&mut Builder) -> String) -> String {
    let mut b = Builder::new();
    let (positions, indices) = b.square();
    let attributes = attributes(&mut b);
    b.member(&format!(
        r#""extensionsUsed":["EXT_mesh_gpu_instancing"],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices}}}]}}],
        "nodes":[{{"name":"trees","mesh":0,"translation":[0,0,5],"scale":[2,2,2],
            "extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":{{{attributes}}}}}}}}}]"#
    ))
    .embedded()
}

#[test]
fn instances_are_placed_in_their_node() {
    let imported = open(
        "a.gltf",
        instanced(|b| {
            let translation = b.floats("VEC3", &[-1., 0., 0., 1., 0., 0.]);
            let scale = b.floats("VEC3", &[1., 1., 1., 3., 3., 3.]);
            // A quarter turn about z, as normalized shorts; then none.
            let turns: Vec<u8> = [0_i16, 0, 23170, 23170, 0, 0, 0, 32767]
                .iter()
                .flat_map(|x| x.to_le_bytes())
                .collect();
            let view = b.view(&turns, None);
            let rotation = b.accessor(&format!(
                r#""bufferView":{view},"componentType":5122,"normalized":true,"count":2,"type":"VEC4""#
            ));
            format!(r#""TRANSLATION":{translation},"SCALE":{scale},"ROTATION":{rotation},"_COLOR_0":{scale}"#)
        }),
    );
    let scene = &imported.scene;
    assert_eq!(paths(scene), ["/trees/instance_0", "/trees/instance_1"]);
    assert_eq!(scene.instances[0].mesh, scene.instances[1].mesh);
    let found = triangles(scene);
    let near = |point: DVec3, x, y, z| assert!((point - DVec3::new(x, y, z)).length() < 1e-4, "{point}");
    near(found[0][1], -2.0, 2.0, 5.0);
    near(found[2][1], 8.0, 0.0, 5.0);
    assert_eq!(
        messages(&imported),
        ["/trees: attributes of EXT_mesh_gpu_instancing are ignored: _COLOR_0"]
    );
}

#[test]
fn inconsistent_instances_are_errors() {
    let uneven = instanced(|b| {
        let two = b.floats("VEC3", &[0.; 6]);
        let three = b.floats("VEC3", &[1.; 9]);
        format!(r#""TRANSLATION":{two},"SCALE":{three}"#)
    });
    assert!(
        error("a.gltf", uneven)
            .contains("/trees: EXT_mesh_gpu_instancing: its attributes have 2 and 3 values")
    );
    let flat = instanced(|b| {
        let scalars = b.floats("SCALAR", &[0.; 6]);
        format!(r#""TRANSLATION":{scalars}"#)
    });
    assert!(error("a.gltf", flat).contains("TRANSLATION is not a VEC3"));
    // Without a buffer, a short text could ask for any number of instances.
    let endless = instanced(|b| {
        let zeros = b.accessor(r#""componentType":5126,"count":2000000000,"type":"VEC3""#);
        format!(r#""TRANSLATION":{zeros}"#)
    });
    assert!(error("a.gltf", endless).contains("the decoded data is far larger than the file"));
}

#[test]
fn hidden_nodes_hide_those_below() {
    let text = |extension: &str| {
        Builder::simple().embedded().replace(
            r#""nodes":[{"mesh":0,"name":"it"}]"#,
            &format!(
                r#""extensions":{{"KHR_lights_punctual":{{"lights":[{{"type":"point"}}]}}}},
                "cameras":[{{"type":"perspective","perspective":{{"yfov":1,"znear":0.1}}}}],
                "nodes":[{{"mesh":0,"name":"shown"}},
                {{"mesh":0,"name":"hidden","children":[2,3],"extensions":{{{extension}}}}},
                {{"mesh":0,"name":"below","extensions":{{"KHR_node_visibility":{{"visible":true}}}}}},
                {{"name":"eye","camera":0,"extensions":{{"KHR_lights_punctual":{{"light":0}}}}}}]"#
            ),
        )
    };
    for extension in [
        r#""KHR_node_visibility":{"visible":false}"#,
        r#""KHR_node_visibility":{"hidden":true}"#,
        r#""KHR_visibility":{"visible":false}"#,
    ] {
        let imported = open("a.gltf", text(extension));
        assert_eq!(paths(&imported.scene), ["/shown"], "{extension}");
        assert!(imported.scene.lights.is_empty(), "{extension}");
        assert_eq!(imported.cameras.len(), 1, "{extension}");
        assert_eq!(messages(&imported), NONE);
    }
    let imported = open("a.gltf", text(r#""KHR_node_visibility":{}"#));
    assert_eq!(imported.scene.instances.len(), 3);
    assert_eq!(imported.scene.lights.len(), 1);
}

#[test]
fn extensions_that_may_move_surfaces_are_reported() {
    let text = Builder::simple().embedded();
    let with = |used: &str| text.replace(r#""buffers""#, &format!(r#""extensionsUsed":[{used}],"buffers""#));
    let harmless = with(r#""KHR_materials_clearcoat","EXT_texture_avif","MSFT_lod","KHR_xmp_json_ld""#);
    assert_eq!(messages(&open("a.gltf", harmless)), NONE);
    let unknown =
        "not supported; if this extension changes geometry or visibility, the result is incomplete or wrong";
    let used = open("a.gltf", with(r#""CESIUM_RTC","KHR_materials_clearcoat""#));
    assert_eq!(messages(&used), [format!("CESIUM_RTC: {unknown}")]);
    // An extension that the file does not list.
    let unlisted = text.replace(
        r#""indices":1"#,
        r#""indices":1,"extensions":{"EXT_mesh_primitive_restart":{}}"#,
    );
    assert_eq!(
        messages(&open("a.gltf", unlisted)),
        [format!("EXT_mesh_primitive_restart: {unknown}")]
    );
}
