use oaktwin_scene::{MeshAttribute, TextureSource, Up, Wrap};

use crate::support::{Files, error, messages, open, triangles};

#[test]
fn objects_and_groups_are_instances_with_their_own_points() {
    let scene = open(
        "room.obj",
        "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
         o table\ng top\nf 2 3 4\ng legs\nf 2 3 5\no chair\nf -4 -3 -1\no table\ng top\nf 3 4 5\n",
    )
    .scene;
    let paths: Vec<&str> = scene.instances.iter().map(|i| i.path.as_str()).collect();
    assert_eq!(paths, ["/table/top", "/table/legs", "/chair/legs"]);
    assert_eq!(scene.up, Up::Y);
    // A repeated name continues its part; no part has points of others.
    assert_eq!(scene.meshes[0].triangles.len(), 2);
    assert_eq!(scene.meshes[0].positions.len(), 4);
    assert_eq!(
        scene.meshes[2].positions,
        [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]
    );
}

#[test]
fn polygons_may_be_concave() {
    let scene = open("a.obj", "v 2 1 0\nv 0.5 0 0\nv 2 -1 0\nv 0 0 0\nf 3 2 1 4\n").scene;
    let area: f64 = triangles(&scene)
        .iter()
        .map(|[a, b, c]| (*b - *a).cross(*c - *a).z / 2.0)
        .sum();
    assert!((area.abs() - 0.5).abs() < 1e-6, "{area}");
    assert!(
        triangles(&scene)
            .iter()
            .all(|[a, b, c]| (*b - *a).cross(*c - *a).z * area > 0.0)
    );
}

#[test]
fn corners_pick_texture_coordinates_and_normals() {
    let scene = open(
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5\nvn 0 0 3\nvn 0 1 0\n\
         f 1/1/1 2/2/1 3/3/1\nf 1/4/2 3/3/2 4/-1/-1\n",
    )
    .scene;
    let mesh = &scene.meshes[0];
    let uvs = mesh.uvs.as_ref().unwrap();
    assert_eq!(
        uvs.corners(0, mesh.triangles[0]).unwrap(),
        [[0., 0.], [1., 0.], [1., 1.]]
    );
    assert_eq!(
        uvs.corners(1, mesh.triangles[1]).unwrap(),
        [[0.5, 0.], [1., 1.], [0.5, 0.]]
    );
    assert_eq!(
        mesh.normals,
        Some(MeshAttribute::Triangle(vec![[0., 0., 1.], [0., 1., 0.]]))
    );
    // Incomplete normals are ignored; corners without texture coordinates get the origin.
    let scene = open(
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2//1 3\n",
    )
    .scene;
    let mesh = &scene.meshes[0];
    assert_eq!(mesh.normals, None);
    assert_eq!(
        mesh.uvs,
        Some(MeshAttribute::Vertex(vec![[1., 1.], [0., 0.], [0., 0.]]))
    );
}

#[test]
fn points_may_have_colours() {
    let scene = open("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 1.0 0 1 0\nv 1 1 0\nf 1 2 3\n").scene;
    assert_eq!(
        scene.meshes[0].colors,
        Some(MeshAttribute::Vertex(vec![
            [1., 0., 0.],
            [0., 1., 0.],
            [1., 1., 1.]
        ]))
    );
}

#[test]
fn materials_come_from_libraries() {
    let files = Files::new()
        .with(
            "my room.mtl",
            "newmtl red paint\nKd 1 0.5 0\nKe 2 2 2\nPr 0.25\nPm 3\n\
            newmtl wood\nKd 0 0 0\nmap_Kd -s 2 3 1 -o 0.5 -clamp on images\\my wood.png\n\
            newmtl lost\nKd 0.5\nmap_Kd none.png\nnewmtl wood\nKd 1 1 1\n",
        )
        .with("images/my wood.png", "not read")
        .with(
            "a.obj",
            "mtllib my room.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl wood\nf 1 2 3\n\
            usemtl red paint\nf 1 2 3\nusemtl lost\nf 1 2 3\nusemtl wood\nf 3 2 1\nusemtl nowhere\nf 1 2 3\n",
        );
    let imported = files.open("a.obj");
    let scene = &imported.scene;
    let mesh = &scene.meshes[0];
    let name = |triangle| {
        scene.materials[mesh.material(triangle).unwrap() as usize]
            .name
            .as_str()
    };
    assert_eq!(
        [0, 1, 2, 3, 4].map(name),
        ["wood", "wood", "red paint", "lost", "nowhere"]
    );
    let material = |name: &str| scene.materials.iter().find(|m| m.name == name).unwrap();
    let red = material("red paint");
    assert_eq!((red.base_color, red.emissive), (Some([1.0, 0.5, 0.0]), [2.0; 3]));
    assert_eq!((red.roughness, red.metallic), (0.25, 1.0));
    // A black factor would hide the image.
    let wood = material("wood");
    assert_eq!(wood.base_color, Some([1.0; 3]));
    let texture = wood.base_color_texture.unwrap();
    assert_eq!(texture.image_from_uv, [[2.0, 0.0, 0.5], [0.0, 3.0, 0.0]]);
    assert_eq!((texture.wrap_s, texture.wrap_t), (Wrap::Clamp, Wrap::Clamp));
    assert_eq!(scene.textures.len(), 1);
    assert_eq!(
        scene.textures[0].source,
        TextureSource::File(files.path("images/my wood.png"))
    );
    assert_eq!(material("lost").base_color, Some([0.5; 3]));
    assert_eq!(material("nowhere").base_color, None);
    assert_eq!(imported.findings.len(), 1);
    assert!(messages(&imported)[0].ends_with("none.png: the image does not exist"));
}

#[test]
fn a_hash_within_a_name_is_no_comment() {
    let files = Files::new()
        .with("c#.mtl", "# made by hand\nnewmtl Material #25\nKd 1 0 0\nmap_Kd wood #2.png\nnewmtl #2\nKd 0 1 0\n")
        .with("wood #2.png", "not read")
        .with(
            "a.obj",
            "  # a comment\nmtllib c#.mtl # by hand\nv 0 0 0 # first\nv 1 0 0#second\nv 1 1 0\n\
            o Bolt#1\nusemtl Material #25\nf 1 2 3 # one\n\
            o Bolt#2\nusemtl #2\nf 1 2 3\nusemtl Material #25 # again\nf 1 2 3\nusemtl plain # no such material\nf 1 2 3\n",
        );
    let imported = files.open("a.obj");
    let scene = &imported.scene;
    assert_eq!(messages(&imported), [""; 0]);
    let paths: Vec<&str> = scene.instances.iter().map(|i| i.path.as_str()).collect();
    assert_eq!(paths, ["/Bolt#1", "/Bolt#2"]);
    let name = |mesh: usize, triangle| {
        let material = scene.meshes[mesh].material(triangle).unwrap();
        scene.materials[material as usize].name.as_str()
    };
    assert_eq!(name(0, 0), "Material #25");
    assert_eq!(
        [0, 1, 2].map(|i| name(1, i)),
        ["#2", "Material #25", "plain # no such material"]
    );
    assert_eq!(
        scene.textures[0].source,
        TextureSource::File(files.path("wood #2.png"))
    );
}

#[test]
fn unsupported_statements_are_counted() {
    let imported = open(
        "a.obj",
        "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\np 1 2\nl 1 2\nl 2 3\nf 1 2 3\nf 1 2\nf 1/7 2/1 3/1\nf 1 2 9\nf 0 1 2\n",
    );
    let found = messages(&imported);
    assert!(found[0].ends_with("none.mtl: does not exist: its materials are ignored"));
    assert_eq!(
        found[1..],
        [
            "lines: not supported: 2 skipped",
            "points: not supported: 1 skipped",
            "f: 1 indices of texture coordinates and normals are out of range",
            "/a: 2 triangles have points that are missing or not finite; skipped",
        ]
    );
    assert_eq!(imported.scene.meshes[0].triangles.len(), 2);
}

#[test]
fn all_encodings_and_line_ends_are_equivalent() {
    let text = "# C:\\folder\\\nv 0 0 0\nv 1 0 \\\n 0\nv 1 1 0\nv 0 1 0\no Würfel\nf 1 2 \\ \n3 \\\n4\n";
    let plain = open("a.obj", text);
    assert_eq!(plain.scene.instances[0].path, "/Würfel");
    assert_eq!(plain.scene.meshes[0].triangles, [[0, 1, 2], [0, 2, 3]]);
    let utf16 = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
    let (little, big) = (utf16(u16::to_le_bytes), utf16(u16::to_be_bytes));
    for bytes in [
        [b"\xff\xfe", &little[..]].concat(),
        [b"\xfe\xff", &big[..]].concat(),
        little,
        big,
        [b"\xef\xbb\xbf", text.as_bytes()].concat(),
        text.replace('\n', "\r\n").into_bytes(),
        text.replace('\n', "\r").into_bytes(),
    ] {
        assert_eq!(open("a.obj", &bytes).scene, plain.scene, "{:?}", &bytes[..8]);
    }
    let materials = "newmtl red\nKd 1 0 0\n".encode_utf16().flat_map(u16::to_le_bytes);
    let files = Files::new()
        .with(
            "a.obj",
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3",
        )
        .with("a.mtl", materials.collect::<Vec<u8>>());
    assert_eq!(
        files.open("a.obj").scene.materials[0].base_color,
        Some([1.0, 0.0, 0.0])
    );
}

#[test]
fn invalid_lines_are_rejected() {
    assert_eq!(
        error("a.obj", "v 0 0 0\nv 1 zero 0\n"),
        "a.obj: line 2: expected three coordinates: v 1 zero 0; the file is damaged: export or copy it again"
    );
    assert!(error("a.obj", "v 0 0 0\nf 1 x 1\n").contains("line 2: invalid index of a corner"));
    assert!(error("a.obj", "#usda 1.0\ndef Xform {}\n").contains("is not an OBJ file"));
    assert!(error("a.obj", "v 0 0 0\n").contains("contains no triangles"));
}

/// Takes a minute if the search for a material is linear.
#[test]
fn each_of_many_materials_keeps_its_faces() {
    const MATERIALS: u32 = 200_000;
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for material in (0..MATERIALS).chain(0..MATERIALS) {
        text += &format!("usemtl {material}\nf 1 2 3\n");
    }
    let scene = open("a.obj", &text).scene;
    assert_eq!(scene.materials.len(), MATERIALS as usize);
    let mesh = &scene.meshes[0];
    assert_eq!(mesh.triangles.len(), 2 * MATERIALS as usize);
    let mut faces = vec![0; MATERIALS as usize];
    for triangle in 0..2 * MATERIALS {
        faces[mesh.material(triangle).unwrap() as usize] += 1;
    }
    assert!(faces.iter().all(|faces| *faces == 2));
}
