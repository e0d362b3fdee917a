//! Where surfaces are invisible.

use oaktwin_scene::Opacity;

use super::gltf_builder::Builder;
use super::support::{Files, open};

/// The opacity of each material of a glTF file whose materials have these members.
fn gltf(materials: &str) -> Vec<Option<Opacity>> {
    let content = Builder::everything().embedded();
    let start = content.find(r#""materials":["#).unwrap() + r#""materials":["#.len();
    let content = format!("{}{materials},{}", &content[..start], &content[start..]);
    let imported = open("a.gltf", content);
    imported
        .scene
        .materials
        .iter()
        .map(|material| material.opacity)
        .collect()
}

#[test]
fn gltf_masks_cut_surfaces() {
    let textured =
        r#""pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.75],"baseColorTexture":{"index":0}}"#;
    let plain = r#""pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]}"#;
    let read = gltf(&format!(
        r#"{{"alphaMode":"MASK",{textured}}},{{"alphaMode":"MASK","alphaCutoff":0.125,{plain}}},
        {{"alphaMode":"MASK",{plain}}},{{"alphaMode":"BLEND",{plain}}},{{"alphaMode":"OPAQUE",{textured}}},{{{plain}}}"#
    ));
    let masked = read[0].unwrap();
    assert_eq!((masked.value, masked.threshold), (0.75, 0.5));
    assert_eq!(masked.mask.unwrap().channel, 3);
    // A quarter is above an eighth and below a half; translucent surfaces are solid.
    assert_eq!(read[1], None);
    assert!(!read[2].unwrap().shows(1.0));
    assert_eq!(&read[3..6], [None, None, None]);
}

#[test]
fn obj_masks_cut_surfaces() {
    let files = Files::new()
        .with("leaf.png", "not decoded here")
        .with("mask.png", "not decoded here")
        .with(
            "a.mtl",
            "newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\nnewmtl card\nmap_Kd leaf.png\nmap_d mask.png\nnewmtl glass\nd 0.1\n\
             newmtl hidden\nTr 1\nnewmtl solid\nd 1.0\nTr 0\n",
        )
        .with(
            "a.obj",
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl leaf\nf 1/1 2/1 3/1\nusemtl card\nf 1/1 2/1 3/1\n",
        );
    let imported = files.open("a.obj");
    let opacity = |name: &str| {
        let mut materials = imported.scene.materials.iter();
        materials.find(|material| material.name == name).unwrap().opacity
    };
    let channel = |name| opacity(name).unwrap().mask.unwrap().channel;
    assert_eq!((channel("leaf"), channel("card")), (3, 0));
    assert_eq!(opacity("leaf").unwrap().threshold, 0.5);
    let reported: Vec<_> = imported
        .findings
        .iter()
        .map(|finding| finding.place.as_str())
        .collect();
    assert_eq!(reported, ["glass", "hidden"]);
    assert!(
        ["glass", "hidden", "solid"]
            .into_iter()
            .all(|name| opacity(name).is_none())
    );
}
