//! Where surfaces are invisible or let light pass.

use oaktwin_scene::{Material, Opacity};

use super::gltf_builder::Builder;
use super::support::{Files, open};

/// The opacity of each material of a glTF file whose materials have these members.
fn gltf(materials: &str) -> Vec<Option<Opacity>> {
    let (read, _) = gltf_materials(materials);
    read.iter().map(|material| material.opacity).collect()
}

/// The materials of such a file, and the codes of the findings.
fn gltf_materials(materials: &str) -> (Vec<Material>, Vec<&'static str>) {
    let content = Builder::everything().embedded();
    let start = content.find(r#""materials":["#).unwrap() + r#""materials":["#.len();
    let content = format!("{}{materials},{}", &content[..start], &content[start..]);
    let imported = open("a.gltf", content);
    let codes = imported.findings.iter().map(|finding| finding.code).collect();
    (imported.scene.materials, codes)
}

#[test]
fn gltf_glass() {
    let (read, codes) = gltf_materials(
        r#"{"name":"bottle","extensions":{"KHR_materials_transmission":{"transmissionFactor":0.9},
            "KHR_materials_ior":{"ior":1.45},"KHR_materials_volume":{"thicknessFactor":0.1}}},
        {"name":"pane","extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}},
        {"name":"bad","extensions":{"KHR_materials_transmission":{"transmissionFactor":1.5},"KHR_materials_ior":{"ior":0}}}"#,
    );
    let [bottle, pane, bad] = [0, 1, 2].map(|index: usize| &read[index]);
    let transmission = bottle.transmission.unwrap();
    assert_eq!(
        (transmission.share, transmission.tint, transmission.refracts),
        (0.9, None, true)
    );
    assert_eq!(bottle.index, 1.45);
    assert!(!pane.transmission.unwrap().refracts && pane.index == 1.5);
    assert_eq!((bad.transmission.unwrap().share, bad.index), (1.0, 1.5));
    let values = codes.iter().filter(|code| **code == "material-value");
    assert_eq!(values.count(), 2);
}

#[test]
fn images_of_transmission_are_masks() {
    let textured = |factor: f32, color: &str, image: &str| {
        format!(
            r#"{{"pbrMetallicRoughness":{{{color}}},"extensions":{{"KHR_materials_transmission":{{"transmissionFactor":{factor},"transmissionTexture":{{{image}}}}}}}}}"#
        )
    };
    let (read, codes) = gltf_materials(&textured(0.9, "", r#""index":0,"texCoord":1"#));
    let transmission = read[0].transmission.unwrap();
    let mask = transmission.mask.unwrap();
    assert_eq!((transmission.share, mask.channel), (0.9, 0));
    assert!(!codes.contains(&"unsupported-material"), "{codes:?}");
    let (read, codes) = gltf_materials(&textured(0.0, "", r#""index":0"#));
    assert_eq!(read[0].transmission, None);
    assert!(!codes.contains(&"unsupported-material"), "{codes:?}");
    // The image of the colour is sRGB, and the same file as a mask is not.
    let color = r#""baseColorTexture":{"index":0}"#;
    let (read, codes) = gltf_materials(&textured(0.9, color, r#""index":0"#));
    let mask = read[0].transmission.unwrap().mask.unwrap();
    assert_ne!(read[0].base_color_texture.unwrap().texture, mask.texture.texture);
    assert!(!codes.contains(&"unsupported-material"), "{codes:?}");
    // A mesh has one set of texture coordinates here.
    let (read, codes) = gltf_materials(&textured(0.9, color, r#""index":0,"texCoord":1"#));
    assert_eq!(read[0].transmission.unwrap().mask, None);
    assert!(codes.contains(&"unsupported-material"), "{codes:?}");
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
    // A quarter is above an eighth and below a half.
    assert_eq!(read[1], None);
    assert!(read[2].unwrap().at(1.0) == 0.0);
    assert!(read[3].unwrap().is_partial() && read[3].unwrap().at(1.0) == 0.25);
    assert_eq!(&read[4..6], [None, None]);
}

#[test]
fn obj_masks_cut_surfaces() {
    let files = Files::new()
        .with("leaf.png", "not decoded here")
        .with("mask.png", "not decoded here")
        .with(
            "a.mtl",
            "newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\nnewmtl card\nmap_Kd leaf.png\nmap_d mask.png\nnewmtl glass\nd 0.1\n\
             newmtl hidden\nTr 1\nnewmtl solid\nd 1.0\nTr 0\nnewmtl void\nd 0\nnewmtl bad\nd 2\nNi 0.5\n\
             newmtl solid_glass\nd 0.25\nTr 0.9\nNi 1.5\nillum 7\nTf 0.5 0.6 0.7\nnewmtl mirror\nKs 0.9 0.8 0.7\nillum 3\n\
             newmtl shiny\nKs 0.9 0.9 0.9\nillum 2\n",
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
    assert_eq!(reported, ["hidden", "void", "bad", "bad"]);
    assert!(
        ["hidden", "solid", "void", "bad", "solid_glass", "mirror"]
            .into_iter()
            .all(|name| opacity(name).is_none())
    );
    assert_eq!(opacity("glass").unwrap().at(1.0), 0.1);
    let material = |name: &str| {
        let mut materials = imported.scene.materials.iter();
        materials.find(|material| material.name == name).unwrap().clone()
    };
    let transmission = material("solid_glass").transmission.unwrap();
    assert_eq!(
        (transmission.share, transmission.tint),
        (0.75, Some([0.5, 0.6, 0.7]))
    );
    assert!(transmission.refracts);
    let mirror = material("mirror");
    assert_eq!((mirror.specular, mirror.roughness), (Some([0.9, 0.8, 0.7]), 0.0));
    assert_eq!(material("shiny").specular, None);
}
