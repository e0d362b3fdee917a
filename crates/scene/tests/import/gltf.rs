use std::f64::consts::FRAC_PI_2;

use oaktwin_camera::math::DVec3;
use oaktwin_scene::import::{self, ImportOptions};
use oaktwin_scene::{LightKind, MeshAttribute, TextureSource, Up, Wrap};

use crate::gltf_builder::Builder;
use crate::support::{Files, error, messages, open, triangles};

#[test]
fn text_binary_and_external_files_are_equivalent() {
    let builder = Builder::simple();
    let embedded = open("a.gltf", builder.embedded()).scene;
    let binary = open("a.glb", builder.binary()).scene;
    let files = Files::new()
        .with("a.gltf", builder.with_uri("sub/my%20data.bin"))
        .with("sub/my data.bin", &builder.bytes);
    assert_eq!(embedded, binary);
    assert_eq!(embedded, files.open("a.gltf").scene);
    assert_eq!(embedded.up, Up::Y);
    assert_eq!(embedded.instances[0].path, "/it");
    assert_eq!(embedded.meshes[0].triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn files_outside_the_folder_are_refused() {
    let builder = Builder::simple();
    let files = Files::new().with("data.bin", &builder.bytes);
    let absolute = files.path("data.bin").display().to_string();
    let trusting = ImportOptions {
        allow_outside: true,
        ..ImportOptions::default()
    };
    for uri in ["../data.bin", &absolute, "inner/../../data.bin"] {
        let files = Files::new()
            .with("data.bin", &builder.bytes)
            .with("sub/inner/x", "")
            .with("sub/a.gltf", builder.with_uri(uri));
        let error = files.error("sub/a.gltf");
        assert!(error.starts_with("sub/a.gltf: buffers[0]: "), "{error}");
        assert!(error.ends_with(
            "data.bin: is outside the folder of the glTF file; move it there, or add 'allow-outside' if the scene is trusted"
        ), "{error}");
        let trusted = import::open(&files.path("sub/a.gltf"), &trusting).unwrap();
        assert_eq!(trusted.scene, open("a.gltf", builder.embedded()).scene);
    }
    let files = files.with("sub/a.gltf", builder.with_uri("link.bin"));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../data.bin", files.path("sub/link.bin")).unwrap();
        assert!(files.error("sub/a.gltf").contains("is outside the folder"));
    }
}

#[test]
fn nodes_share_meshes() {
    let imported = open("a.glb", Builder::everything().binary());
    let scene = &imported.scene;
    let paths: Vec<&str> = scene.instances.iter().map(|i| i.path.as_str()).collect();
    assert_eq!(paths, ["/root/a", "/root/a_2", "/root/flat_fan"]);
    assert_eq!(scene.instances[0].mesh, scene.instances[1].mesh);
    // (1, 0, 0): scaled by 2, rotated by 90° about z, translated.
    let at = |i: usize, p: [f64; 3]| {
        scene.instances[i]
            .world_from_mesh
            .transform_point3(DVec3::from(p))
    };
    assert!((at(0, [1., 0., 0.]) - DVec3::new(10., 2., 0.)).length() < 1e-6);
    assert!((at(1, [0., 1., 0.]) - DVec3::new(8., 0., 2.)).length() < 1e-6);
    // A singular transform is baked into a new mesh.
    assert_ne!(scene.instances[2].mesh, scene.instances[0].mesh);
    assert_eq!(
        scene.instances[2].world_from_mesh,
        oaktwin_camera::math::DAffine3::IDENTITY
    );
    let flat = &triangles(scene)[8..];
    assert_eq!(flat.len(), 2);
    assert!(flat.iter().flatten().all(|p| (p.z - 14.0).abs() < 1e-5));
}

#[test]
fn primitives_become_one_mesh_with_their_materials() {
    let imported = open("a.glb", Builder::everything().binary());
    let scene = &imported.scene;
    let mesh = &scene.meshes[scene.instances[0].mesh as usize];
    // A strip of four points is two triangles with the same winding.
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [4, 5, 6], [5, 7, 6]]);
    assert_eq!(mesh.positions[6], [5.0; 3]);
    assert_eq!(
        [0, 1, 2, 3].map(|i| mesh.material(i)),
        [Some(0), Some(0), Some(1), Some(1)]
    );
    assert!(mesh.double_sided);
    let normals = mesh.normals.as_ref().unwrap();
    assert_eq!(normals.corners(1, mesh.triangles[1]).unwrap(), [[0., 0., 1.]; 3]);
    assert_eq!(
        normals.corners(2, mesh.triangles[2]).unwrap(),
        [mesh.flat_normal(2); 3]
    );
    // The origin is at the lower left.
    let Some(MeshAttribute::Vertex(uvs)) = &mesh.uvs else {
        panic!("{:?}", mesh.uvs)
    };
    assert_eq!(uvs[..4], [[0., 1.], [1., 1.], [1., 0.], [0., 0.]]);
    // The first primitive's vertex colours include the factor; the other has its own.
    let Some(MeshAttribute::Vertex(colors)) = &mesh.colors else {
        panic!("{:?}", mesh.colors)
    };
    assert_eq!(colors[0], [0.5, 0.25, 1.0]);
    assert_eq!(colors[4], [0.5, 0.0, 0.0]);
    assert!((colors[7][0] - 0.1).abs() < 1e-6);
}

#[test]
fn materials_refer_to_textures() {
    let imported = open("a.glb", Builder::everything().binary());
    let [painted, other] = imported.scene.materials.as_slice() else {
        panic!("{:?}", imported.scene.materials)
    };
    assert_eq!(
        (painted.name.as_str(), other.name.as_str()),
        ("painted", "material_1")
    );
    assert_eq!(painted.base_color, Some([0.5, 0.25, 1.0]));
    assert_eq!((painted.metallic, painted.roughness), (0.0, 0.75));
    assert_eq!(other.emissive, [1.0, 2.0, 3.0]);
    let texture = painted.base_color_texture.unwrap();
    assert_eq!((texture.wrap_s, texture.wrap_t), (Wrap::Clamp, Wrap::Mirror));
    // v′ = 1 − 4·(1 − v)
    assert_eq!(texture.image_from_uv, [[2.0, 0.0, 0.5], [0.0, 4.0, -3.0]]);
    let TextureSource::Encoded { name, bytes } = &imported.scene.textures[0].source else {
        panic!("{:?}", imported.scene.textures)
    };
    assert_eq!((name.as_str(), &bytes[..]), ("picture", b"an image".as_slice()));
}

#[test]
fn cameras_and_lights_have_the_poses_of_their_nodes() {
    let imported = open("a.glb", Builder::everything().binary());
    let [camera] = imported.cameras.as_slice() else {
        panic!("{:?}", imported.cameras)
    };
    assert_eq!(camera.path, "/root/node_4");
    assert!((camera.vfov - 0.8).abs() < 1e-7 && (camera.aspect.unwrap() - 1.6).abs() < 1e-6);
    let kinds: Vec<LightKind> = imported.scene.lights.iter().map(|light| light.kind).collect();
    assert!(matches!(kinds[0], LightKind::Sphere { .. }) && matches!(kinds[1], LightKind::Disk { .. }));
    let sun = imported.scene.lights.last().unwrap();
    assert!(matches!(sun.kind, LightKind::Distant { .. }));
    assert_eq!(sun.radiance, [3.0, 1.5, 0.0]);
    // Rotated by −90° about x, −z becomes down.
    let direction = sun.world_from_light.transform_vector3(DVec3::NEG_Z);
    assert!((direction - DVec3::NEG_Y).length() < 1e-6, "{direction}");
    assert_eq!(
        messages(&imported),
        [
            "meshes[0]: lines are not supported: 1 skipped",
            "/root/node_5: orthographic cameras are not supported; skipped",
            "/root/node_7: the cone of the spot light is ignored: it is rendered as a disk light",
        ]
    );
}

#[test]
fn a_camera_faces_along_its_node() {
    let builder = Builder::simple()
        .member(r#""cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}]"#);
    let nodes = r#""nodes":[{"mesh":0},{"camera":0,"translation":[1,2,3],"scale":[3,3,3],"rotation":[0,0.70710678,0,0.70710678]}]"#;
    let mut builder = builder;
    builder.members.retain(|member| !member.starts_with(r#""nodes""#));
    let imported = open("a.gltf", builder.member(nodes).embedded());
    let pose = imported.cameras[0].world_from_camera;
    // Rotated by 90° about y, the forward axis −z becomes −x; down is −y.
    assert!((pose.rotation * DVec3::Z - DVec3::NEG_X).length() < 1e-6);
    assert!((pose.rotation * DVec3::Y - DVec3::NEG_Y).length() < 1e-6);
    assert!(pose.orthonormality_error() < 1e-12);
    assert_eq!(pose.translation, DVec3::new(1.0, 2.0, 3.0));
    assert!(FRAC_PI_2 > imported.cameras[0].vfov);
    assert_eq!(imported.cameras[0].aspect, None);
}

#[test]
fn accessors_may_be_small_interleaved_and_shared() {
    let mut b = Builder::new();
    // Interleaved positions in bytes; a long vertex list of which a part is used.
    let mut bytes = Vec::new();
    for i in 0..100_u8 {
        bytes.extend([i, i % 7, i % 5, 0, 9, 9, 9, 9]);
    }
    let view = b.view(&bytes, Some(8));
    let positions = b.accessor(&format!(
        r#""bufferView":{view},"componentType":5121,"count":100,"type":"VEC3""#
    ));
    let quantized = b.accessor(&format!(
        r#""bufferView":{view},"componentType":5121,"normalized":true,"count":100,"type":"VEC3""#
    ));
    let indices = b.shorts(&[90, 8, 33, 33, 8, 200]);
    let imported = open(
        "a.gltf",
        b.member(&format!(
            r#""extensionsRequired":["KHR_mesh_quantization"],"meshes":[{{"primitives":[
                {{"attributes":{{"POSITION":{positions}}},"indices":{indices}}},
                {{"attributes":{{"POSITION":{quantized}}},"indices":{indices}}}]}}]"#
        ))
        .member(r#""nodes":[{"mesh":0}]"#)
        .embedded(),
    );
    let mesh = &imported.scene.meshes[0];
    assert_eq!(mesh.positions.len(), 6);
    assert_eq!(
        mesh.corners(0).unwrap(),
        [[90., 6., 0.], [8., 1., 3.], [33., 5., 3.]]
    );
    assert_eq!(mesh.corners(1).unwrap()[0][0], 90.0 / 255.0);
    assert_eq!(imported.findings.len(), 2, "{:?}", messages(&imported));
}

#[test]
fn trees_may_be_deep_and_cyclic() {
    let mut builder = Builder::simple();
    builder.members.retain(|member| !member.starts_with(r#""nodes""#));
    let depth = 50_000;
    let mut nodes: Vec<String> = (0..depth)
        .map(|i| format!(r#"{{"mesh":0,"children":[{}]}}"#, i + 1))
        .collect();
    // The last node is its own ancestor, and the parent of a node that has another parent.
    nodes.push(r#"{"children":[0,7]}"#.into());
    let nodes = format!(r#""nodes":[{}],"scenes":[{{"nodes":[0]}}]"#, nodes.join(","));
    let imported = open("a.gltf", builder.member(&nodes).embedded());
    assert_eq!(imported.scene.instances.len(), depth);
    assert!(imported.scene.instances.iter().all(|i| i.path.len() < 1100));
    assert!(
        messages(&imported)[0].contains("2 references to nodes"),
        "{:?}",
        messages(&imported)
    );
}

#[test]
fn unsupported_features_are_reported() {
    let mut b = Builder::new();
    let (positions, indices) = b.square();
    let imported = open(
        "a.gltf",
        b.member(&format!(
            r#""extensionsUsed":["KHR_animation_pointer"],"extensionsRequired":["KHR_animation_pointer"],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices},"targets":[{{}}]}},
                {{"attributes":{{"POSITION":{positions}}},"mode":0}},
                {{"attributes":{{"POSITION":{positions}}},"mode":17}}]}}]"#
        ))
        .member(r#""skins":[{"joints":[0]}],"animations":[{"channels":[],"samplers":[]}]"#)
        .member(r#""nodes":[{"mesh":0,"skin":0}],"scenes":[{"nodes":[0]},{"nodes":[]}]"#)
        .embedded(),
    );
    assert_eq!(
        messages(&imported),
        [
            "KHR_animation_pointer: the file requires this extension, which is not supported; the result may be incomplete or wrong",
            "scenes: only scene 0 of 2 is rendered",
            "meshes[0].primitives[0]: its skin is ignored: it has no JOINTS_0 and WEIGHTS_0",
            "meshes[0]: points are not supported: 1 skipped",
            "meshes[0]: primitives with an unknown mode are not supported: 1 skipped",
        ]
    );
}

#[test]
fn missing_images_are_findings_and_missing_buffers_errors() {
    let image = Builder::simple()
        .member(r#""images":[{"uri":"none.png"}],"textures":[{"source":0},{}],"materials":[
            {"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},{"pbrMetallicRoughness":{"baseColorTexture":{"index":1}}},
            {"pbrMetallicRoughness":{"baseColorTexture":{"index":7}}}]"#);
    let imported = open("a.gltf", image.embedded());
    assert_eq!(imported.findings.len(), 3, "{:?}", messages(&imported));
    assert!(messages(&imported)[0].ends_with("none.png: the image does not exist"));
    assert!(imported.scene.textures.is_empty());
    let builder = Builder::simple();
    let missing = error("a.gltf", builder.with_uri("none.bin"));
    assert!(missing.starts_with("a.gltf: buffers[0]: none.bin: "), "{missing}");
    assert!(missing.ends_with("; put it beside the glTF file"), "{missing}");
    let short = Files::new()
        .with("a.gltf", builder.with_uri("a.bin"))
        .with("a.bin", [0; 10]);
    assert!(
        short
            .error("a.gltf")
            .contains("buffers[0]: 60 bytes required, 10 available"),
        "{}",
        short.error("a.gltf")
    );
    let web = error("a.gltf", builder.with_uri("https://example.org/a.bin"));
    assert!(
        web.contains("buffers[0]: a URI that does not refer to a local file"),
        "{web}"
    );
}

#[test]
fn inconsistent_numbers_are_errors() {
    let with = |from: &str, to: &str| error("a.gltf", Builder::simple().embedded().replacen(from, to, 1));
    assert!(
        with(r#""count":4"#, r#""count":5"#).contains("accessors[0]: its 5 elements exceed its bufferView")
    );
    assert!(with(r#""count":4"#, r#""count":18446744073709551615"#).contains("exceed its"));
    assert!(with(r#""bufferView":0,"#, r#""bufferView":9,"#).contains("bufferViews[9] does not exist"));
    assert!(
        with(
            r#""bufferView":0,"componentType":5126,"count":4"#,
            r#""componentType":5126,"count":9999999999"#
        )
        .contains("far larger than the file")
    );
    assert!(
        with(r#""byteOffset":0"#, r#""byteOffset":18446744073709551600"#)
            .contains("bufferViews[0] exceeds buffers[0]")
    );
    assert!(with(r#""type":"VEC3""#, r#""type":"VEC9""#).contains("accessors[0]: has an unknown type"));
    assert!(with(r#""mesh":0"#, r#""mesh":4"#).contains("nodes[0].mesh: does not exist"));
    assert!(with(r#""version":"2.0""#, r#""version":"1.0""#).contains(
        "asset.version: is glTF 1.0; only glTF 2.0 is supported; convert it to glTF 2.0, for example"
    ));
    assert!(
        error("a.gltf", r#"{"meshes":{"it":{}},"nodes":{}}"#)
            .contains("asset.version: is glTF 1.0; only glTF 2.0 is supported; convert")
    );
    assert!(
        error("a.glb", b"glTF\x01\0\0\0\x20\0\0\0\x02\0\0\0\0\0\0\0{}")
            .contains("header: is glTF 1.0; only glTF 2.0 is supported; convert")
    );
    assert!(error("a.gltf", "[]").contains("JSON: is not an object"));
    assert!(error("a.gltf", "{").contains("JSON: "));
    assert!(error("a.glb", "{}").contains("is not a binary glTF file"));
    assert!(error("a.glb", &Builder::simple().binary()[..40]).contains("the file ends too early"));
    // A small file that refers to the same data a million times.
    let primitive = r#"{"attributes":{"POSITION":0},"indices":1}"#;
    let many = Builder::simple()
        .embedded()
        .replacen(primitive, &[primitive; 60_000].join(","), 1);
    open("a.gltf", &many);
    let mut dense = Builder::simple();
    let indices = dense.shorts(&[0; 30_000]);
    let primitive = format!(r#"{{"attributes":{{"POSITION":0}},"indices":{indices}}}"#);
    let json = dense.with_uri("a.bin").replacen(
        r#"{"attributes":{"POSITION":0},"indices":1}"#,
        &vec![primitive; 3000].join(","),
        1,
    );
    let files = Files::new().with("a.gltf", json).with("a.bin", &dense.bytes);
    assert!(
        files.error("a.gltf").contains("far larger than the file"),
        "{}",
        files.error("a.gltf")
    );
}

#[test]
fn slips_of_older_exporters_are_repaired() {
    let plain = open("a.gltf", Builder::simple().embedded());
    let text = Builder::simple()
        .member(r#""cameras":[{"name":7,"perspective":{"yfov":0.8}},{"type":"perspective","perspective":{"aspectRatio":1.5,"yfov":1,"zfar":NaN}}]"#)
        .member(r#""scenes":[{"extras":{"units":"in"}}],"scene":-1,"animations":[{"name":"turn"}],"skins":[{}]"#)
        .member(r#""materials":[{"name":null,"emissiveFactor":[0,0,0,1],"pbrMetallicRoughness":{"baseColorFactor":[1,0,0]}}]"#)
        .embedded()
        .replace(r#""asset":{"version":"2.0"}"#, r#""asset":{"version":2.0,"generator":null}"#)
        .replace(r#""count":4"#, r#""count":4.0,"max":[NaN,-Infinity]"#)
        .replace(r#""nodes":[{"mesh":0,"#, r#""nodes":[{"mesh":0,"camera":1,"skin":-1,"#)
        .replace(r#""byteLength":48"#, r#""byteLength":48,"byteStride":0"#);
    assert!(
        text.contains(r#""byteStride":0"#) && text.contains("Infinity") && text.contains(r#""camera":1"#)
    );
    // A scene without nodes displays nothing; without a scene, all roots are displayed.
    let imported = open(
        "a.gltf",
        text.replace(r#""scenes":[{"extras":{"units":"in"}}],"#, ""),
    );
    assert_eq!(imported.scene.meshes, plain.scene.meshes);
    assert_eq!(imported.scene.instances, plain.scene.instances);
    assert_eq!(imported.scene.materials[0].base_color, Some([1.0, 0.0, 0.0]));
    assert_eq!(
        (imported.cameras[0].vfov, imported.cameras[0].path.as_str()),
        (1.0, "/it_2")
    );
    assert!(messages(&imported).is_empty());
    assert!(error("a.gltf", text).contains("contains no triangles"));
    // The length in the header may be wrong.
    let mut long = Builder::simple().binary();
    long[8] += 1;
    assert_eq!(open("a.glb", long).scene, plain.scene);
}
