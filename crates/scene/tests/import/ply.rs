use oaktwin_scene::{MeshAttribute, Up};

use crate::support::{error, messages, open};

const HEADER: &str = "element vertex 4
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property uchar alpha
property float s
property float t
element face 2
property list uchar int vertex_indices
end_header
";

/// Two sides of a pyramid, a triangle and a quad, with all supported attributes.
pub(crate) fn text() -> String {
    let mut text = format!("ply\nformat ascii 1.0\ncomment made by a test\n{HEADER}");
    for (i, [x, y]) in [[0, 0], [1, 0], [1, 1], [0, 1]].into_iter().enumerate() {
        text += &format!("{x} {y} 0 0 0 2 {} 0 255 255 {x} {y}\n", 64 * i);
    }
    text + "3 0 1 2\n4 0 1 2 3\n"
}

pub(crate) fn binary(big: bool) -> Vec<u8> {
    let format = if big {
        "binary_big_endian"
    } else {
        "binary_little_endian"
    };
    let mut bytes = format!("ply\nformat {format} 1.0\n{HEADER}").into_bytes();
    let float = |x: f32| if big { x.to_be_bytes() } else { x.to_le_bytes() };
    let int = |i: i32| if big { i.to_be_bytes() } else { i.to_le_bytes() };
    for (i, [x, y]) in [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].into_iter().enumerate() {
        for number in [x, y, 0.0, 0.0, 0.0, 2.0] {
            bytes.extend(float(number));
        }
        bytes.extend([64 * i as u8, 0, 255, 255]);
        for number in [x, y] {
            bytes.extend(float(number));
        }
    }
    bytes.push(3);
    bytes.extend([0, 1, 2].into_iter().flat_map(int));
    bytes.push(4);
    bytes.extend([0, 1, 2, 3].into_iter().flat_map(int));
    bytes
}

#[test]
fn all_encodings_are_equivalent() {
    let scene = open("scan.ply", text()).scene;
    assert_eq!(scene, open("scan.ply", binary(false)).scene);
    assert_eq!(scene, open("scan.ply", binary(true)).scene);
    assert_eq!(scene, open("scan.ply", text().replace('\n', "\r\n")).scene);
    assert_eq!(scene.up, Up::Z);
    let mesh = &scene.meshes[0];
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 1, 2], [0, 2, 3]]);
    assert_eq!(
        mesh.normals,
        Some(MeshAttribute::Vertex(vec![[0.0, 0.0, 1.0]; 4]))
    );
    let Some(MeshAttribute::Vertex(uvs)) = &mesh.uvs else {
        panic!("{:?}", mesh.uvs)
    };
    assert_eq!(uvs[2], [1.0, 1.0]);
    let Some(MeshAttribute::Vertex(colors)) = &mesh.colors else {
        panic!("{:?}", mesh.colors)
    };
    // sRGB 128 is 0.2158605 in linear light.
    assert!((colors[2][0] - 0.215_860_5).abs() < 1e-6);
    assert_eq!((colors[0], colors[2][2]), ([0.0, 0.0, 1.0], 1.0));
}

#[test]
fn indices_of_all_kinds_are_read() {
    for kind in ["char", "uint8", "short", "uint16", "int32", "uint", "float64"] {
        let text = text().replace("list uchar int", &format!("list {kind} {kind}"));
        assert_eq!(open("a.ply", text).scene.meshes[0].triangles.len(), 3, "{kind}");
    }
}

#[test]
fn unknown_elements_and_properties_are_skipped() {
    let text = "ply\nformat ascii 1.0\nelement camera 1\nproperty list int float view\nelement vertex 3\n\
        property double z\nproperty double y\nproperty double x\nproperty float quality\nelement face 1\n\
        property int flags\nproperty list uchar uint vertex_index\nproperty list uchar float texcoord\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
        2 0.5 0.5\n3 2 1 9\n3 2 4 9\n3 5 1 9\n7 3 0 1 2 6 0 0 1 0 1 1\n0\n";
    let imported = open("a.ply", text);
    assert_eq!(
        imported.scene.meshes[0].positions,
        [[1., 2., 3.], [4., 2., 3.], [1., 5., 3.]]
    );
    assert_eq!(
        messages(&imported),
        ["tristrips: triangle strips are not supported; skipped"]
    );
}

#[test]
fn surplus_values_of_a_row_are_ignored() {
    let plain = open("a.ply", text()).scene;
    let surplus = text()
        .replace("3 0 1 2\n", "3 0 1 2 6 0 0 1 0 1 1\n")
        .replace(" 255 255 ", " 255 255 0 ");
    // The vertex rows now have one value too many at their end.
    let imported = open("a.ply", surplus.replace("4 0 1 2 3\n", "4 0 1 2 3 255 0 0"));
    assert_eq!(imported.scene.meshes[0].triangles, plain.meshes[0].triangles);
    assert_eq!(imported.scene.meshes[0].positions, plain.meshes[0].positions);
    // Rows need not be on separate lines.
    let (header, body) = text()
        .split_once("end_header\n")
        .map(|(h, b)| (h.to_string(), b.to_string()))
        .unwrap();
    let joined = format!("{header}end_header\n{}", body.replace('\n', " "));
    assert_eq!(open("a.ply", joined).scene, plain);
    let split = format!("{header}end_header\n{}", body.replace(' ', "\n"));
    assert_eq!(open("a.ply", split).scene, plain);
}

#[test]
fn header_lines_without_a_keyword_are_ignored() {
    let text = text()
        .replace("comment made", "made")
        .replace("element face", "by hand\nelement face");
    assert_eq!(
        messages(&open("a.ply", text)),
        ["line 3: unknown header line; ignored: made by a test"]
    );
}

#[test]
fn rejects_point_clouds() {
    let cloud = text().replace("element face 2", "element face 0");
    assert_eq!(
        error("a.ply", &cloud[..cloud.len() - 18]),
        "a.ply: face: is a point cloud of 4 points without faces; convert it to a mesh first, for example by Poisson reconstruction"
    );
}

#[test]
fn rejects_counts_that_exceed_the_file() {
    let lie = |from: &str, to: &str| {
        let bytes = binary(false);
        let body = bytes
            .windows(11)
            .position(|window| window == b"end_header\n")
            .unwrap();
        let header = String::from_utf8_lossy(&bytes[..body]).replace(from, to);
        error("a.ply", [header.as_bytes(), &bytes[body..]].concat())
    };
    assert!(
        lie("vertex 4", "vertex 4000000000000000000")
            .contains("vertex: 4000000000000000000 elements do not fit")
    );
    assert!(lie("face 2", "face 99999").contains("face: 99999 elements do not fit"));
    assert!(lie("vertex 4", "vertex -4").contains("line 3: invalid element"));
    assert!(lie("float x", "quad x").contains("line 4: invalid property"));
    assert!(lie("uchar int v", "float int v").contains("is longer than the file"));
    // Elements without properties take no time, regardless of their number.
    let many = text().replace(
        "element vertex",
        "element nothing 18446744073709551615\nelement vertex",
    );
    open("a.ply", many);
}

#[test]
fn rejects_incomplete_files() {
    let broken = |from: &str, to: &str| error("a.ply", text().replace(from, to));
    assert!(broken("ply\n", "").contains("line 1: is not a PLY file"));
    assert!(broken("format ascii 1.0\n", "").contains("the format is missing"));
    assert!(broken("format ascii", "format morse").contains("line 2: unknown format"));
    assert!(broken("end_header", "").contains("end_header is missing"));
    assert!(broken("property float z\n", "property float w\n").contains("x, y and z are missing"));
    assert!(broken("vertex_indices", "others").contains("the list vertex_indices is missing"));
    assert!(broken("4 0 1 2 3", "4 0 1 2").contains("the file ends before its last element"));
    assert!(broken("3 0 1 2", "3 0 one 2").contains("line 24: invalid number: one"));
    let imported = open("a.ply", text().replace("3 0 1 2\n", "3 0 1 9\n"));
    assert_eq!(imported.findings[0].code, "mesh-bad-triangles");
}
