use std::f64::consts::FRAC_PI_2;

use oaktwin_camera::math::DVec3;
use oaktwin_scene::{Attribute, LightKind, TextureSource, Up, Wrap};

use crate::support::{Files, error, floats, messages, open, triangles};

/// The parts of a glTF file: JSON members, and bytes that accessors are about.
#[derive(Clone, Default)]
pub(crate) struct Builder {
    views: Vec<String>,
    accessors: Vec<String>,
    bytes: Vec<u8>,
    members: Vec<String>,
}

impl Builder {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    pub(crate) fn view(&mut self, bytes: &[u8], stride: Option<usize>) -> usize {
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let stride = stride
            .map(|stride| format!(r#","byteStride":{stride}"#))
            .unwrap_or_default();
        self.views.push(format!(
            r#"{{"buffer":0,"byteOffset":{},"byteLength":{}{stride}}}"#,
            self.bytes.len(),
            bytes.len()
        ));
        self.bytes.extend(bytes);
        self.views.len() - 1
    }

    pub(crate) fn accessor(&mut self, members: &str) -> usize {
        self.accessors.push(format!("{{{members}}}"));
        self.accessors.len() - 1
    }

    fn floats(&mut self, shape: &str, numbers: &[f32]) -> usize {
        let size = match shape {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            _ => 4,
        };
        let view = self.view(&floats(numbers), None);
        let count = numbers.len() / size;
        self.accessor(&format!(
            r#""bufferView":{view},"componentType":5126,"count":{count},"type":"{shape}""#
        ))
    }

    fn shorts(&mut self, numbers: &[u16]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|i| i.to_le_bytes()).collect();
        let view = self.view(&bytes, None);
        let count = numbers.len();
        self.accessor(&format!(
            r#""bufferView":{view},"componentType":5123,"count":{count},"type":"SCALAR""#
        ))
    }

    /// A member of the root, `"nodes":[…]`.
    fn member(mut self, member: &str) -> Self {
        self.members.push(member.into());
        self
    }

    fn json(&self, buffer: &str) -> String {
        let list = |name: &str, list: &[String]| match list {
            [] => String::new(),
            _ => format!(r#","{name}":[{}]"#, list.join(",")),
        };
        let members: String = self.members.iter().map(|member| format!(",{member}")).collect();
        format!(
            r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{buffer}}}]{}{}{members}}}"#,
            self.bytes.len(),
            list("bufferViews", &self.views),
            list("accessors", &self.accessors),
        )
    }

    pub(crate) fn with_uri(&self, uri: &str) -> String {
        self.json(&format!(r#","uri":"{uri}""#))
    }

    pub(crate) fn embedded(&self) -> String {
        let data: String = self.bytes.iter().map(|byte| format!("%{byte:02x}")).collect();
        self.with_uri(&format!("data:application/octet-stream,{data}"))
    }

    pub(crate) fn binary(&self) -> Vec<u8> {
        let mut json = self.json("").into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bin = self.bytes.clone();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let word = |size: usize| (size as u32).to_le_bytes();
        [
            b"glTF".as_slice(),
            &word(2),
            &word(28 + json.len() + bin.len()),
            &word(json.len()),
            b"JSON",
            &json,
            &word(bin.len()),
            b"BIN\0",
            &bin,
        ]
        .concat()
    }

    /// A square of four points in the x-y plane, and its two triangles.
    fn square(&mut self) -> (usize, usize) {
        let positions = self.floats("VEC3", &[0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.]);
        (positions, self.shorts(&[0, 1, 2, 0, 2, 3]))
    }

    /// One mesh of a square in one node.
    fn simple() -> Self {
        let mut builder = Self::new();
        let (positions, indices) = builder.square();
        builder
            .member(&format!(
                r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices}}}]}}]"#
            ))
            .member(r#""nodes":[{"mesh":0,"name":"it"}]"#)
    }

    /// Some of all that is read.
    pub(crate) fn everything() -> Self {
        let mut b = Self::new();
        let (positions, indices) = b.square();
        let normals = b.floats("VEC3", &[0., 0., 1., 0., 0., 1., 0., 0., 1., 0., 0., 1.]);
        let uvs = b.floats("VEC2", &[0., 0., 1., 0., 1., 1., 0., 1.]);
        let color_view = b.view(
            &[255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 51, 51, 51, 255],
            None,
        );
        let colors = b.accessor(&format!(
            r#""bufferView":{color_view},"componentType":5121,"normalized":true,"count":4,"type":"VEC4""#
        ));
        let sparse_at = b.view(&[2, 0], None);
        let sparse = b.view(&floats(&[5., 5., 5.]), None);
        let moved = b.accessor(&format!(
            r#""bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{{"count":1,"indices":{{"bufferView":{sparse_at},"componentType":5123}},"values":{{"bufferView":{sparse}}}}}"#
        ));
        let image = b.view(b"an image", None);
        b.member(&format!(
            r#""meshes":[{{"primitives":[
                {{"attributes":{{"POSITION":{positions},"NORMAL":{normals},"TEXCOORD_1":{uvs}}},"indices":{indices},"material":0}},
                {{"attributes":{{"POSITION":{moved},"COLOR_0":{colors}}},"mode":5,"material":1}},
                {{"attributes":{{"POSITION":{moved}}},"mode":1}}]}},
              {{"primitives":[{{"attributes":{{"POSITION":{positions}}},"mode":6}}]}}]"#
        ))
        .member(&format!(r#""images":[{{"bufferView":{image},"mimeType":"image/png","name":"picture"}}]"#))
        .member(r#""samplers":[{"wrapS":33071,"wrapT":33648}],"textures":[{"source":0,"sampler":0}]"#)
        .member(
            r#""materials":[
                {"name":"painted","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0,"roughnessFactor":0.75,
                 "baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.5,0],"scale":[2,4],"texCoord":1}}}}},
                {"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1]},"emissiveFactor":[1,2,3]}]"#,
        )
        .member(r#""cameras":[{"type":"perspective","perspective":{"yfov":0.8,"aspectRatio":1.6,"znear":0.1}},
            {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":9,"znear":0}}]"#)
        .member(r#""extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[
            {"type":"directional","intensity":3,"color":[1,0.5,0]},{"type":"point","intensity":10},
            {"type":"spot","intensity":2,"spot":{}}]}}"#)
        .member(
            r#""nodes":[
                {"name":"root","children":[1,2,3,4,5,6,7],"translation":[10,0,0],"rotation":[0,0,0.70710678,0.70710678],"scale":[2,2,2]},
                {"name":"a","mesh":0},{"name":"a","mesh":0,"translation":[0,0,1]},
                {"name":"flat/fan","mesh":1,"matrix":[1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,7,1]},
                {"camera":0,"rotation":[0.70710678,0,0,0.70710678]},{"camera":1},
                {"extensions":{"KHR_lights_punctual":{"light":1}}},{"extensions":{"KHR_lights_punctual":{"light":2}}},
                {"extensions":{"KHR_lights_punctual":{"light":0}},"rotation":[-0.70710678,0,0,0.70710678]}],
              "scenes":[{"nodes":[0,8]}],"scene":0"#,
        )
    }
}

#[test]
fn text_binary_and_external_are_the_same() {
    let builder = Builder::simple();
    let embedded = open("a.gltf", builder.embedded()).scene;
    let binary = open("a.glb", builder.binary()).scene;
    let files = Files::new()
        .with("sub/a.gltf", builder.with_uri("../my%20data.bin"))
        .with("my data.bin", &builder.bytes);
    assert_eq!(embedded, binary);
    assert_eq!(embedded, files.open("sub/a.gltf").scene);
    assert_eq!(embedded.up, Up::Y);
    assert_eq!(embedded.instances[0].path, "/it");
    assert_eq!(embedded.meshes[0].triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn nodes_place_meshes_that_they_share() {
    let imported = open("a.glb", Builder::everything().binary());
    let scene = &imported.scene;
    let paths: Vec<&str> = scene.instances.iter().map(|i| i.path.as_str()).collect();
    assert_eq!(paths, ["/root/a", "/root/a_2", "/root/flat_fan"]);
    assert_eq!(scene.instances[0].mesh, scene.instances[1].mesh);
    // (1, 0, 0) and half-way up: scaled by 2, turned by 90° about z, moved.
    let at = |i: usize, p: [f64; 3]| {
        scene.instances[i]
            .world_from_mesh
            .transform_point3(DVec3::from(p))
    };
    assert!((at(0, [1., 0., 0.]) - DVec3::new(10., 2., 0.)).length() < 1e-6);
    assert!((at(1, [0., 1., 0.]) - DVec3::new(8., 0., 2.)).length() < 1e-6);
    // What is squashed flat is a mesh of its own.
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
    // A strip of four points is two triangles, both seen from the same side.
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
    // Seen from the lower left.
    let Some(Attribute::Vertex(uvs)) = &mesh.uvs else {
        panic!("{:?}", mesh.uvs)
    };
    assert_eq!(uvs[..4], [[0., 1.], [1., 1.], [1., 0.], [0., 0.]]);
    // Vertices' colours have the factor in them; the other primitive has its own.
    let Some(Attribute::Vertex(colors)) = &mesh.colors else {
        panic!("{:?}", mesh.colors)
    };
    assert_eq!(colors[0], [0.5, 0.25, 1.0]);
    assert_eq!(colors[4], [0.5, 0.0, 0.0]);
    assert!((colors[7][0] - 0.1).abs() < 1e-6);
}

#[test]
fn materials_have_their_textures() {
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
fn cameras_and_lights_are_where_their_nodes_are() {
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
    // Turned by −90° about x, −z is down.
    let direction = sun.world_from_light.transform_vector3(DVec3::NEG_Z);
    assert!((direction - DVec3::NEG_Y).length() < 1e-6, "{direction}");
    assert_eq!(
        messages(&imported),
        [
            "meshes[0]: lines are left out: 1",
            "/root/node_5: an orthographic camera is left out",
            "/root/node_7: the cone of a spot light is left out: it shines forwards",
        ]
    );
}

#[test]
fn a_camera_looks_along_its_node() {
    let builder = Builder::simple()
        .member(r#""cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}]"#);
    let nodes = r#""nodes":[{"mesh":0},{"camera":0,"translation":[1,2,3],"scale":[3,3,3],"rotation":[0,0.70710678,0,0.70710678]}]"#;
    let mut builder = builder;
    builder.members.retain(|member| !member.starts_with(r#""nodes""#));
    let imported = open("a.gltf", builder.member(nodes).embedded());
    let pose = imported.cameras[0].world_from_camera;
    // Turned by 90° about y, −z becomes −x: forward; down is −y.
    assert!((pose.rotation * DVec3::Z - DVec3::NEG_X).length() < 1e-6);
    assert!((pose.rotation * DVec3::Y - DVec3::NEG_Y).length() < 1e-6);
    assert!(pose.orthonormality_error() < 1e-12);
    assert_eq!(pose.translation, DVec3::new(1.0, 2.0, 3.0));
    assert!(FRAC_PI_2 > imported.cameras[0].vfov);
    assert_eq!(imported.cameras[0].aspect, None);
}

#[test]
fn numbers_may_be_small_interleaved_and_shared() {
    let mut b = Builder::new();
    // Positions in bytes among other bytes; a long list of which a part is used.
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
fn trees_may_be_deep_and_knotted() {
    let mut builder = Builder::simple();
    builder.members.retain(|member| !member.starts_with(r#""nodes""#));
    let depth = 50_000;
    let mut nodes: Vec<String> = (0..depth)
        .map(|i| format!(r#"{{"mesh":0,"children":[{}]}}"#, i + 1))
        .collect();
    // The last is its own ancestor, and of one that has another parent.
    nodes.push(r#"{"children":[0,7]}"#.into());
    let nodes = format!(r#""nodes":[{}],"scenes":[{{"nodes":[0]}}]"#, nodes.join(","));
    let imported = open("a.gltf", builder.member(&nodes).embedded());
    assert_eq!(imported.scene.instances.len(), depth);
    assert!(imported.scene.instances.iter().all(|i| i.path.len() < 1100));
    assert!(
        messages(&imported)[0].contains("taken once: 2"),
        "{:?}",
        messages(&imported)
    );
}

#[test]
fn what_is_not_supported_is_said() {
    let mut b = Builder::new();
    let (positions, indices) = b.square();
    let empty = b.accessor(r#""componentType":5126,"count":4,"type":"VEC3""#);
    let imported = open(
        "a.gltf",
        b.member(&format!(
            r#""extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices},"targets":[{{}}]}},
                {{"attributes":{{"POSITION":{empty}}}}},{{"attributes":{{"POSITION":{positions}}},"mode":0}},
                {{"attributes":{{"POSITION":{positions}}},"mode":17}}]}}]"#
        ))
        .member(r#""skins":[{"joints":[0]}],"animations":[{"channels":[],"samplers":[]}]"#)
        .member(r#""nodes":[{"mesh":0,"skin":0}],"scenes":[{"nodes":[0]},{"nodes":[]}]"#)
        .embedded(),
    );
    assert_eq!(
        messages(&imported),
        [
            "KHR_draco_mesh_compression: the file needs this extension, which is not supported: something may be missing or wrong",
            "scenes: only scene 0 of 2 is rendered",
            "/node_0: its skin is left out: it is rendered as it was modelled",
            "meshes[0].primitives[0]: its morph targets are left out",
            "meshes[0]: points are left out: 1",
            "meshes[0]: primitives compressed by Draco are left out: 1",
            "meshes[0]: primitives of an unknown mode are left out: 1",
            "animations: left out: 1",
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
    assert!(messages(&imported)[0].ends_with("none.png: the image is not there"));
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
            .contains("buffers[0]: should have 60 bytes and has 10"),
        "{}",
        short.error("a.gltf")
    );
    let web = error("a.gltf", builder.with_uri("https://example.org/a.bin"));
    assert!(
        web.contains("buffers[0]: an address that is no local file"),
        "{web}"
    );
}

#[test]
fn lying_numbers_are_errors() {
    let with = |from: &str, to: &str| error("a.gltf", Builder::simple().embedded().replacen(from, to, 1));
    assert!(
        with(r#""count":4"#, r#""count":5"#)
            .contains("accessors[0]: its 5 elements are not inside its bufferView")
    );
    assert!(with(r#""count":4"#, r#""count":18446744073709551615"#).contains("not inside"));
    assert!(with(r#""bufferView":0,"#, r#""bufferView":9,"#).contains("bufferViews[9] is not there"));
    assert!(
        with(
            r#""bufferView":0,"componentType":5126,"count":4"#,
            r#""componentType":5126,"count":9999999999"#
        )
        .contains("much more of its bytes")
    );
    assert!(
        with(r#""byteOffset":0"#, r#""byteOffset":18446744073709551600"#)
            .contains("bufferViews[0] is not inside buffers[0]")
    );
    assert!(with(r#""type":"VEC3""#, r#""type":"VEC9""#).contains("accessors[0]: is of no known type"));
    assert!(with(r#""mesh":0"#, r#""mesh":4"#).contains("nodes[0].mesh: is not there"));
    assert!(
        with(r#""version":"2.0""#, r#""version":"1.0""#)
            .contains("asset.version: is 1.0; convert it to glTF 2.0")
    );
    assert!(error("a.gltf", "{").contains("JSON: "));
    assert!(error("a.glb", "{}").contains("is no binary glTF file"));
    assert!(error("a.glb", &Builder::simple().binary()[..40]).contains("the file ends too early"));
    // A small file that says the same a million times.
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
        files.error("a.gltf").contains("much more of its bytes"),
        "{}",
        files.error("a.gltf")
    );
}
