use oaktwin_scene::Up;

use crate::support::{error, messages, open};

/// The corners of a tetrahedron's facets.
const FACETS: [[[f32; 3]; 3]; 4] = [
    [[0., 0., 0.], [0., 1., 0.], [1., 0., 0.]],
    [[0., 0., 0.], [1., 0., 0.], [0., 0., 1.]],
    [[0., 0., 0.], [0., 0., 1.], [0., 1., 0.]],
    [[1., 0., 0.], [0., 1., 0.], [0., -0., 1.]],
];

pub(crate) fn binary(header: &str) -> Vec<u8> {
    let mut bytes = format!("{header:80}").into_bytes();
    bytes.extend((FACETS.len() as u32).to_le_bytes());
    for facet in FACETS {
        bytes.extend([0; 12]);
        for x in facet.iter().flatten() {
            bytes.extend(x.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

pub(crate) fn text(name: &str) -> String {
    let mut text = format!("solid {name}\n");
    for facet in FACETS {
        text += " facet normal 0 0 0\n  outer loop\n";
        for [x, y, z] in facet {
            text += &format!("   vertex {x:e} {y:?} {z}\n");
        }
        text += "  endloop\n endfacet\n";
    }
    text + &format!("endsolid {name}\n")
}

#[test]
fn binary_and_text_are_equivalent() {
    let a = open("part.stl", binary("made by a test")).scene;
    let b = open("part.stl", text("part")).scene;
    let c = open("part.stl", binary("solid as many programs write it")).scene;
    assert_eq!(a, b);
    assert_eq!(a, c);
    assert_eq!(a.up, Up::Z);
    assert_eq!(a.instances[0].path, "/part");
    // Points are shared; 0 and −0 are equal.
    assert_eq!(a.meshes[0].positions.len(), 4);
    assert_eq!(a.meshes[0].triangles[..2], [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(a.meshes[0].normals, None);
}

#[test]
fn every_solid_is_an_instance() {
    let scene = open("a.stl", text("one") + &text("two/three") + &text("one")).scene;
    let paths: Vec<&str> = scene.instances.iter().map(|i| i.path.as_str()).collect();
    assert_eq!(paths, ["/one", "/two_three", "/one_2"]);
}

#[test]
fn lengths_are_checked() {
    let mut long = binary("a");
    long.extend([1, 2, 3]);
    assert_eq!(
        messages(&open("a.stl", &long)),
        ["end: 3 extra bytes after the last facet"]
    );
    let short = &binary("a")[..200];
    assert_eq!(
        error("a.stl", short),
        "a.stl: header: 284 bytes required, 200 available; the file is damaged: export or copy it again"
    );
    let mut huge = binary("a");
    huge[80..84].fill(0xff);
    assert!(error("a.stl", &huge).contains("214748364834 bytes required"));
    assert!(error("a.stl", "no such thing").contains("neither a binary nor a text STL file"));
}

#[test]
fn invalid_text_is_rejected_by_line() {
    assert_eq!(
        error(
            "a.stl",
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0\n"
        ),
        "a.stl: line 4: expected three coordinates of a vertex; the file is damaged: export or copy it again"
    );
    assert!(
        error("a.stl", text("a").replacen("   vertex 0e0 0.0 0\n", "", 1)).contains("a facet has 2 vertices")
    );
    assert!(error("a.stl", text("a").replace("endsolid a", "")).contains("endsolid is missing"));
    assert!(error("a.stl", "solid a\nrubbish\n").contains("line 2: unknown keyword: rubbish"));
    assert!(error("a.stl", "solid a\nendsolid a\n").contains("contains no triangles"));
}

#[test]
fn skips_facets_with_non_finite_points() {
    let imported = open("a.stl", text("a").replacen("0e0 0.0 0", "nan 0 0", 1));
    assert_eq!(imported.scene.meshes[0].triangles.len(), 3);
    assert_eq!(imported.findings[0].code, "mesh-bad-triangles");
}
