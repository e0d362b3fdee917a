//! Scenes of other formats than USD.

use std::path::Path;
use std::sync::LazyLock;

use oaktwin_scene::import::{ImportOptions, from_bytes};
use serde_json::{Value, json};

use crate::random::Random;
use crate::{file, json, scene};

fn import(bytes: Vec<u8>, path: &Path) {
    if let Ok(imported) = from_bytes(bytes, path, &ImportOptions::default()) {
        scene::check(&imported.scene);
        for camera in &imported.cameras {
            assert!(camera.world_from_camera.translation.is_finite(), "{camera:?}");
        }
    }
}

/// The first byte selects a file, or the facets of a binary file.
pub(crate) fn stl(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    if first % 2 == 0 {
        return import(rest.to_vec(), Path::new("x.stl"));
    }
    let count = rest.len() / 50;
    let mut file = vec![b' '; 80];
    file.extend(u32::try_from(count).unwrap_or(0).to_le_bytes());
    file.extend(&rest[..count * 50]);
    import(file, Path::new("x.stl"));
}

pub(crate) fn stl_seeds() -> Vec<Vec<u8>> {
    let text = b"\0solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5e-1 0\nendloop\nendfacet\nendsolid x\n";
    let facets: Vec<u8> = (0..36u8).map(f32::from).flat_map(f32::to_le_bytes).collect();
    let mut binary = vec![1];
    for facet in facets.chunks(36) {
        binary.extend([0; 12]);
        binary.extend(facet);
        binary.extend([0; 2]);
    }
    vec![text.to_vec(), binary]
}

/// The first byte selects a file, or a header that fits the rest.
pub(crate) fn ply(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    if first % 2 == 0 {
        return import(rest.to_vec(), Path::new("x.ply"));
    }
    let mut random = Random::new(rest);
    let format = random.pick(&["ascii", "binary_little_endian", "binary_big_endian"]);
    let kinds = [
        "float", "double", "char", "uchar", "short", "ushort", "int", "uint",
    ];
    let names = [
        "x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "s", "t", "other",
    ];
    let mut header = format!("ply\nformat {format} 1.0\nelement vertex {}\n", random.up_to(40));
    let main = random.pick(&kinds);
    for name in &names[..3 + random.up_to(9) as usize] {
        let kind = if random.up_to(7) == 7 {
            random.pick(&kinds)
        } else {
            main
        };
        header += &format!("property {kind} {name}\n");
    }
    let faces = random.up_to(40);
    let (length, index) = (random.pick(&["uchar", "int", "ushort"]), random.pick(&kinds));
    let corners = random.pick(&["vertex_indices", "vertex_index"]);
    header += &format!("element face {faces}\nproperty list {length} {index} {corners}\nend_header\n");
    let mut file = header.into_bytes();
    while !random.is_empty() {
        if format == "ascii" {
            file.extend(format!("{} ", random.number()).bytes());
        } else {
            file.push(random.byte());
        }
    }
    import(file, Path::new("x.ply"));
}

pub(crate) fn ply_seeds() -> Vec<Vec<u8>> {
    let head = |format: &str| {
        format!(
            "\0ply\nformat {format} 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let text = head("ascii") + "0 0 0 1\n1 0 0 2\n0 1 0 255\n3 0 1 2\n";
    let mut binary = head("binary_little_endian").into_bytes();
    for position in [[0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
        binary.extend(position.iter().flat_map(|x| x.to_le_bytes()));
        binary.push(9);
    }
    binary.push(3);
    binary.extend([0i32, 1, 2].iter().flat_map(|index| index.to_le_bytes()));
    vec![
        text.into_bytes(),
        binary,
        (0..250).collect(),
        (1..250).rev().collect(),
    ]
}

/// An OBJ, a zero byte, and the MTL that it finds as `m.mtl`.
pub(crate) fn obj(bytes: &[u8]) {
    let at = bytes.iter().position(|&byte| byte == 0);
    let (obj, mtl) = bytes.split_at(at.unwrap_or(bytes.len()));
    if mtl.len() < 2 {
        return import(obj.to_vec(), Path::new("no-such-folder/x.obj"));
    }
    file::with("m.mtl", &mtl[1..], |library| {
        import(obj.to_vec(), &library.with_file_name("x.obj"));
    });
}

pub(crate) fn obj_seeds() -> Vec<Vec<u8>> {
    let obj = "mtllib m.mtl\no Box\ng a b\nv 0 0 0\nv 1 0 0 0.5 0.5 1\nv 1 1 0\nv 0 1e0 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl Red\nf 1/1/1 2/2/1 3//1 -1\nusemtl Blue\nf 1 2 \\\n3\nl 1 2\ns off\n";
    let mtl = "newmtl Red\nKd 0.8 0.1 0.1\nKe 0 0 1\nNs 200\nd 0.5\nillum 2\nPr 0.4\nPm 1\nmap_Kd -s 2 2 1 -o 0.5 0 -clamp on t.png\nnewmtl Blue\nKd spectral x\n";
    vec![
        obj.as_bytes().to_vec(),
        [obj.as_bytes(), b"\0", mtl.as_bytes()].concat(),
    ]
}

pub(crate) fn dae(bytes: &[u8]) {
    import(bytes.to_vec(), Path::new("no-such-folder/x.dae"));
}

pub(crate) fn dae_seeds() -> Vec<Vec<u8>> {
    let source = |id: &str, numbers: &str, count: usize, params: &str| {
        format!(
            "<source id='{id}'><float_array id='{id}a'>{numbers}</float_array><technique_common><accessor source='#{id}a' count='{count}' stride='{}'>{params}</accessor></technique_common></source>",
            params.matches("<param").count()
        )
    };
    let xyz = "<param name='X'/><param name='Y'/><param name='Z'/>";
    let mesh = [
        source("p", "0 0 0 1 0 0 1 1 0 0 1e0 0", 4, xyz),
        source("n", "0 0 1", 1, xyz),
        source("t", "0 0 1 1", 2, "<param name='S'/><param name='T'/>"),
        "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>".to_owned(),
    ]
    .concat();
    let vertex = "<input semantic='VERTEX' source='#v' offset='0'/>";
    let all = format!(
        "{vertex}<input semantic='NORMAL' source='#n' offset='1'/><input semantic='TEXCOORD' source='#t' offset='2' set='1'/>"
    );
    let primitives = format!(
        "<polylist material='M' count='1'>{all}<vcount>4</vcount><p>0 0 0 1 0 1 2 0 1 3 0 0</p></polylist><triangles count='1'>{vertex}<p>0 1 2</p></triangles><tristrips>{vertex}<p>0 1 3 2</p></tristrips><trifans>{vertex}<p>0 1 2 3</p></trifans><polygons>{vertex}<ph><p>0 1 2</p><h>0</h></ph></polygons><lines/>"
    );
    let effect = "<effect id='e'><profile_COMMON><newparam sid='s'><surface><init_from>i</init_from></surface></newparam><newparam sid='m'><sampler2D><source>s</source></sampler2D></newparam><technique><phong><emission><color>0 0 0 1</color></emission><diffuse><texture texture='m' texcoord='U'/></diffuse><transparent opaque='RGB_ZERO'><color>0.5 0.5 0.5 1</color></transparent><transparency><float>0.5</float></transparency><index_of_refraction><float>1.4</float></index_of_refraction></phong></technique></profile_COMMON></effect>";
    let nodes = "<node id='a'><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><translate>1 2 3</translate><rotate>0 0 1 30</rotate><scale>1 -1 0</scale><lookat>1 2 3 0 0 0 0 0 1</lookat><instance_geometry url='#g'><bind_material><technique_common><instance_material symbol='M' target='#m'><bind_vertex_input semantic='U' input_semantic='TEXCOORD' input_set='1'/></instance_material></technique_common></bind_material></instance_geometry><instance_node url='#b'/><instance_light url='#l'/></node>";
    let whole = format!(
        "<COLLADA version='1.4.1'><asset><unit meter='0.01'/><up_axis>Y_UP</up_axis></asset><library_images><image id='i'><init_from>a%20b.png</init_from></image></library_images><library_effects>{effect}</library_effects><library_materials><material id='m'><instance_effect url='#e'/></material></library_materials><library_geometries><geometry id='g'><mesh>{mesh}{primitives}</mesh></geometry></library_geometries><library_nodes><node id='b'><instance_geometry url='#g'/></node></library_nodes><library_visual_scenes><visual_scene id='z'>{nodes}</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#z'/></scene></COLLADA>"
    );
    // A node that contains itself.
    let cycle = whole.replace("<node id='b'>", "<node id='b'><instance_node url='#b'/>");
    vec![whole.into_bytes(), cycle.into_bytes()]
}

/// A document with most features, whose buffer has 512 bytes.
static GLTF: LazyLock<Value> = LazyLock::new(|| {
    json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"mesh": 0, "name": "A", "translation": [1, 2, 3], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1], "children": [2, 3]},
            {"camera": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]},
            {"mesh": 1, "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"mesh": 0, "name": "A"},
        ],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}}],
        "meshes": [
            {"primitives": [
                {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0},
                {"attributes": {"POSITION": 0, "COLOR_0": 4}, "mode": 5},
            ]},
            {"primitives": [{"attributes": {"POSITION": 5}, "mode": 6, "material": 1}]},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 4, "type": "VEC2", "normalized": true},
            {"bufferView": 2, "componentType": 5121, "count": 6, "type": "SCALAR"},
            {"bufferView": 3, "componentType": 5121, "count": 4, "type": "VEC4", "normalized": true},
            {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 2,
                "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 0}}},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 16},
            {"buffer": 0, "byteOffset": 112, "byteLength": 8}, {"buffer": 0, "byteOffset": 120, "byteLength": 16, "byteStride": 4},
            {"buffer": 0, "byteOffset": 136, "byteLength": 4}, {"buffer": 0, "byteOffset": 140, "byteLength": 200},
        ],
        "buffers": [{"byteLength": 512}],
        "materials": [
            {"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.2, 1], "metallicFactor": 0.2, "roughnessFactor": 0.9,
                "baseColorTexture": {"index": 0, "texCoord": 0,
                    "extensions": {"KHR_texture_transform": {"offset": [0, 0.5], "rotation": 0.3, "scale": [2, 2]}}}},
                "emissiveFactor": [0, 1, 0], "doubleSided": true, "alphaMode": "MASK"},
            {"extensions": {"KHR_materials_unlit": {}}},
        ],
        "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071, "wrapT": 33648}],
        "images": [{"bufferView": 5, "mimeType": "image/png"}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 20, "range": 4, "spot": {"outerConeAngle": 0.6}}]}},
    })
});

/// The first byte selects: a glTF, a GLB, the JSON of a GLB, or changes of a document and of its buffer.
pub(crate) fn gltf(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    match first % 4 {
        0 => import(rest.to_vec(), Path::new("no-such-folder/x.gltf")),
        1 => import(rest.to_vec(), Path::new("no-such-folder/x.glb")),
        2 => import(glb(rest, &buffer()), Path::new("no-such-folder/x.glb")),
        _ => {
            let (changes, buffer_changes) = rest.split_at(rest.len() / 2);
            let mut document = GLTF.clone();
            json::change(&mut document, &mut Random::new(changes));
            let mut buffer = buffer();
            for change in buffer_changes.chunks_exact(3) {
                buffer[usize::from(u16::from_le_bytes([change[0], change[1]])) % 512] = change[2];
            }
            import(
                glb(document.to_string().as_bytes(), &buffer),
                Path::new("no-such-folder/x.glb"),
            );
        }
    }
}

fn glb(json: &[u8], buffer: &[u8]) -> Vec<u8> {
    let mut file = b"glTF\x02\0\0\0".to_vec();
    let mut json = json.to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = |bytes: &[u8]| u32::try_from(bytes.len()).unwrap_or(0);
    file.extend((28 + length(&json) + length(buffer)).to_le_bytes());
    for (chunk, kind) in [(&json[..], b"JSON"), (buffer, b"BIN\0")] {
        file.extend(length(chunk).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    file
}

/// The positions, normals, coordinates, indices and so on of the document.
fn buffer() -> Vec<u8> {
    let mut buffer = Vec::new();
    for corner in [
        [0f32, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ] {
        buffer.extend(corner.iter().flat_map(|x| x.to_le_bytes()));
    }
    for _ in 0..4 {
        buffer.extend([0f32, 0.0, 1.0].iter().flat_map(|x| x.to_le_bytes()));
    }
    buffer.extend((0..8u16).flat_map(|at| (at * 8000).to_le_bytes()));
    buffer.extend([0, 1, 2, 0, 2, 3, 0, 0]);
    buffer.extend((0..16).map(|at| at * 15));
    buffer.extend([1, 0, 3, 0]);
    buffer.resize(512, 7);
    buffer
}

pub(crate) fn gltf_seeds() -> Vec<Vec<u8>> {
    let text = GLTF.to_string().into_bytes();
    vec![
        [&[0], &text[..]].concat(),
        [&[1], &glb(&text, &buffer())[..]].concat(),
        [&[2], &text[..]].concat(),
        vec![3],
        (3..90).collect(),
    ]
}
