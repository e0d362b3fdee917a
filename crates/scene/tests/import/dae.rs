//! Collada files.

use std::f64::consts::FRAC_1_SQRT_2;

use oaktwin_camera::math::DVec3;
use oaktwin_image::srgb;
use oaktwin_scene::import::{self, ImportOptions, ImportedScene};
use oaktwin_scene::{MeshAttribute, MetersPerUnit, Up};

use crate::support::{Files, error, open};

/// A file with a square of 2 × 2 units, cut from `primitives`, which the nodes place. The points are 0 to 3, normals 0 (z), texture coordinates 0 to 3.
fn file(primitives: &str, effects: &str, nodes: &str) -> String {
    format!(
        r##"<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
  <library_images><image id="wood-image"><init_from>my%20wood.png</init_from></image></library_images>
  <library_effects>{effects}</library_effects>
  <library_materials>
    <material id="red-material" name="Red"><instance_effect url="#red"/></material>
    <material id="wood-material" name="Wood"><instance_effect url="#wood"/></material>
  </library_materials>
  <library_geometries><geometry id="square" name="Square"><mesh>
    <source id="points"><float_array id="points-array" count="12">0 0 0 2 0 0 2 2 0 0 2 0</float_array>
      <technique_common><accessor source="#points-array" count="4" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <source id="normals"><float_array id="normals-array" count="3">0 0 5</float_array>
      <technique_common><accessor source="#normals-array" count="1" stride="3">
        <param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>
    <source id="uvs"><float_array id="uvs-array" count="12">0 0 9 1 0 9 1 1 9 0 1 9</float_array>
      <technique_common><accessor source="#uvs-array" count="4" stride="3">
        <param name="S"/><param name="T"/><param type="float"/></accessor></technique_common></source>
    <source id="other-uvs"><float_array id="other-array" count="2">0.5 0.25</float_array>
      <technique_common><accessor source="#other-array" count="1" stride="2">
        <param name="S"/><param name="T"/></accessor></technique_common></source>
    <vertices id="vertices"><input semantic="POSITION" source="#points"/></vertices>
    {primitives}
  </mesh></geometry></library_geometries>
  <library_nodes><node id="shared"><translate>0 0 7</translate><instance_geometry url="#square"/></node></library_nodes>
  <library_visual_scenes><visual_scene id="Scene">{nodes}</visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#Scene"/></scene>
</COLLADA>"##
    )
}

const RED: &str = r#"<effect id="red"><profile_COMMON><technique sid="common"><lambert>
    <diffuse><color sid="diffuse">0.8 0.2 0.1 1</color></diffuse></lambert></technique></profile_COMMON></effect>"#;
const WOOD: &str = r##"<effect id="wood"><profile_COMMON>
    <newparam sid="wood-surface"><surface type="2D"><init_from>wood-image</init_from></surface></newparam>
    <newparam sid="wood-sampler"><sampler2D><source>wood-surface</source></sampler2D></newparam>
    <technique sid="common"><phong><diffuse><texture texture="wood-sampler" texcoord="UVMap"/></diffuse></phong></technique>
    </profile_COMMON></effect>"##;
const TRIANGLES: &str = r##"<triangles count="2"><input semantic="VERTEX" source="#vertices" offset="0"/><p>0 1 2 0 2 3</p></triangles>"##;
const NODE: &str = r##"<node id="a"><instance_geometry url="#square"/></node>"##;

fn simple(primitives: &str) -> String {
    file(primitives, RED, NODE)
}

pub(crate) fn everything() -> String {
    file(
        r##"<polylist material="R" count="1"><input semantic="VERTEX" source="#vertices" offset="0"/>
          <input semantic="NORMAL" source="#normals" offset="1"/><vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist>
        <triangles material="W" count="1"><input semantic="VERTEX" source="#vertices" offset="0"/>
          <input semantic="TEXCOORD" source="#other-uvs" offset="2" set="0"/>
          <input semantic="TEXCOORD" source="#uvs" offset="1" set="1"/><p>0 0 0 1 1 0 2 2 0</p></triangles>"##,
        &format!("{RED}{WOOD}"),
        r##"<node id="a" name="Arm">
          <translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>1 2 1</scale>
          <instance_geometry url="#square"><bind_material><technique_common>
            <instance_material symbol="R" target="#red-material"/>
            <instance_material symbol="W" target="#wood-material">
              <bind_vertex_input semantic="UVMap" input_semantic="TEXCOORD" input_set="1"/></instance_material>
          </technique_common></bind_material></instance_geometry>
          <node id="b"><matrix>1 0 0 0  0 0 -1 0  0 1 0 3  0 0 0 1</matrix><instance_node url="#shared"/></node>
        </node>"##,
    )
}

/// The corners of an instance's triangles in the world.
fn corners(imported: &ImportedScene, instance: usize) -> Vec<[DVec3; 3]> {
    let instance = &imported.scene.instances[instance];
    let mesh = &imported.scene.meshes[instance.mesh as usize];
    let point = |at: u32| DVec3::from(mesh.positions[at as usize].map(f64::from));
    let placed = |at| instance.world_from_mesh.transform_point3(point(at));
    mesh.triangles
        .iter()
        .map(|triangle| triangle.map(placed))
        .collect()
}

fn assert_near(corners: &[DVec3; 3], expected: [[f64; 3]; 3]) {
    for (corner, expected) in corners.iter().zip(expected) {
        assert!(corner.abs_diff_eq(DVec3::from(expected), 1e-9), "{corners:?}");
    }
}

#[test]
fn nodes_place_what_they_instance() {
    let files = Files::new().with("a.dae", everything()).with("my wood.png", "");
    let imported = files.open("a.dae");
    assert_eq!(imported.findings, []);
    let scene = &imported.scene;
    assert_eq!((scene.up, scene.meters_per_unit), (Up::Z, MetersPerUnit(0.01)));
    let paths: Vec<&str> = scene.instances.iter().map(|one| one.path.as_str()).collect();
    assert_eq!(paths, ["/Arm", "/Arm_2", "/Arm/b/shared", "/Arm/b/shared_2"]);
    // The square turned by 90° about z, twice as long in its own y, in centimetres.
    let [first, second] = corners(&imported, 0)[..] else {
        panic!()
    };
    assert_near(&first, [[0.1, 0.0, 0.0], [0.1, 0.02, 0.0], [0.06, 0.02, 0.0]]);
    assert_near(&second, [[0.1, 0.0, 0.0], [0.06, 0.02, 0.0], [0.06, 0.0, 0.0]]);
    // The shared node is 7 above, in a frame that is turned by 90° about x and 3 above.
    assert_near(
        &corners(&imported, 2)[0],
        [[0.24, 0.0, 0.03], [0.24, 0.02, 0.03], [0.24, 0.02, 0.05]],
    );
}

#[test]
fn materials_and_coordinates_are_the_instance_s() {
    let files = Files::new().with("a.dae", everything()).with("my wood.png", "");
    let scene = files.open("a.dae").scene;
    let mesh = |instance: usize| &scene.meshes[scene.instances[instance].mesh as usize];
    let material = |instance: usize| {
        let own = mesh(instance).materials.first()?.material?;
        Some(&scene.materials[own as usize])
    };
    let red = material(0).unwrap();
    assert_eq!(red.name, "Red");
    assert_eq!(red.base_color, Some([0.8, 0.2, 0.1].map(srgb::linear)));
    assert_eq!(
        mesh(0).normals,
        Some(MeshAttribute::Triangle(vec![[0.0, 0.0, 1.0]; 2]))
    );
    let wood = material(1).unwrap();
    assert!(wood.base_color_texture.is_some());
    assert_eq!(
        mesh(1).uvs,
        Some(MeshAttribute::Vertex(vec![
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 0.0]
        ]))
    );
    // The shared node binds nothing, so the first set counts.
    assert_eq!(material(2), None);
    assert_eq!(mesh(3).uvs, Some(MeshAttribute::Triangle(vec![[0.5, 0.25]])));
}

#[test]
fn options_multiply_the_unit_and_replace_the_axis() {
    let files = Files::new().with("a.dae", simple(TRIANGLES));
    let options = ImportOptions {
        up: Some(Up::Y),
        scale: 10.0,
        ..ImportOptions::default()
    };
    let imported = import::open(&files.path("a.dae"), &options).unwrap();
    assert_eq!(imported.scene.up, Up::Y);
    assert_near(
        &corners(&imported, 0)[1],
        [[0.0, 0.0, 0.0], [0.2, 0.2, 0.0], [0.0, 0.2, 0.0]],
    );
    let sideways = simple(TRIANGLES).replace("Z_UP", "X_UP");
    let imported = open("a.dae", sideways);
    assert_eq!(imported.findings[0].code, "dae-up-axis");
    let plain = simple(TRIANGLES).replace(
        "<asset><unit name=\"centimeter\" meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset>",
        "",
    );
    let scene = open("a.dae", plain).scene;
    assert_eq!((scene.up, scene.meters_per_unit), (Up::Y, MetersPerUnit(1.0)));
}

#[test]
fn strips_fans_and_polygons_are_triangles() {
    let input = r##"<input semantic="VERTEX" source="#vertices" offset="0"/>"##;
    let vertices = |primitive: &str| {
        let scene = open("a.dae", simple(primitive)).scene;
        scene.meshes[0].triangles.clone()
    };
    for (primitive, expected) in [
        (
            format!("<tristrips count='1'>{input}<p>0 1 3 2</p></tristrips>"),
            vec![[0, 1, 3], [1, 2, 3]],
        ),
        (
            format!("<trifans count='1'>{input}<p>0 1 2 3</p></trifans>"),
            vec![[0, 1, 2], [0, 2, 3]],
        ),
        (
            format!("<polygons count='2'>{input}<p>0 1 2</p><ph><p>0 2 3</p><h>0 1 2</h></ph></polygons>"),
            vec![[0, 1, 2], [0, 2, 3]],
        ),
        (
            format!("<triangles>{input}<p>0 1 2</p></triangles>"),
            vec![[0, 1, 2]],
        ),
    ] {
        assert_eq!(vertices(&primitive), expected, "{primitive}");
    }
}

/// The opacity of a material whose `<phong>` contains these elements.
fn opacity(inside: &str) -> Option<f32> {
    let effect = RED.replace("<lambert>", &format!("<lambert>{inside}"));
    let primitive = TRIANGLES.replace("<triangles", "<triangles material=\"red-material\"");
    let scene = open("a.dae", file(&primitive, &effect, NODE)).scene;
    scene.materials[0].opacity.map(|opacity| opacity.value)
}

#[test]
fn transparency_has_the_format_s_modes() {
    let transparent = |mode: &str, color: &str, factor: &str| {
        opacity(&format!(
            "<transparent{mode}><color>{color}</color></transparent><transparency><float>{factor}</float></transparency>"
        ))
    };
    assert_eq!(opacity(""), None);
    assert_eq!(
        opacity("<transparency><float>0.25</float></transparency>"),
        Some(0.25)
    );
    assert_eq!(transparent("", "1 1 1 0.5", "0.5"), Some(0.25));
    assert_eq!(transparent(" opaque='A_ONE'", "0 0 0 1", "1"), None);
    assert_eq!(transparent(" opaque='A_ZERO'", "1 1 1 0.5", "0.5"), Some(0.75));
    assert_eq!(transparent(" opaque='RGB_ZERO'", "0 0 0 1", "1"), None);
    assert!((transparent(" opaque='RGB_ZERO'", "0.25 0.25 0.25 1", "1").unwrap() - 0.75).abs() < 1e-6);
    assert!((transparent(" opaque='RGB_ONE'", "0.25 0.25 0.25 1", "1").unwrap() - 0.25).abs() < 1e-6);
    // Exporters write these for solid materials.
    assert_eq!(opacity("<transparency><float>0</float></transparency>"), None);
    assert_eq!(transparent(" opaque='RGB_ZERO'", "1 1 1 1", "1"), None);
}

#[test]
fn a_camera_s_frame_looks_at_its_point() {
    let node = NODE.replace("<instance", "<lookat>1 2 3  1 2 -5  1 1 0</lookat><instance");
    let imported = open("a.dae", file(TRIANGLES, RED, &node));
    let half = 0.02 * FRAC_1_SQRT_2;
    // Its x axis is to the right of (1, 1): (1, −1) / √2.
    assert_near(
        &corners(&imported, 0)[0],
        [
            [0.01, 0.02, 0.03],
            [0.01 + half, 0.02 - half, 0.03],
            [0.01 + 2.0 * half, 0.02, 0.03],
        ],
    );
}

#[test]
fn what_is_left_out_is_said() {
    let lamp = r##"<node id="a"><instance_light url="#l"/><instance_camera url="#c"/><instance_geometry url="#square"/></node>"##;
    let imported = open("a.dae", file(TRIANGLES, RED, lamp));
    let found: Vec<_> = imported
        .findings
        .iter()
        .map(|one| (one.code, &*one.place))
        .collect();
    assert_eq!(
        found,
        [("dae-unsupported", "cameras"), ("dae-unsupported", "lights")]
    );
    let skinned = r##"<node id="b"><instance_controller url="#s"/></node>"##;
    let imported = open("a.dae", file(TRIANGLES, RED, &format!("{NODE}{skinned}")));
    assert_eq!(imported.findings[0].code, "dae-controller");
    let files = Files::new().with("a.dae", everything());
    let findings = files.open("a.dae").findings;
    assert_eq!((findings[0].code, findings.len()), ("texture-missing", 1));
}

/// What replaces a part of the file with everything, and the error.
const MISTAKES: &[(&str, &str, &str)] = &[
    (
        "<COLLADA xmlns",
        "<X3D xmlns",
        "line 46: ill-formed document: expected `</X3D>`, but `</COLLADA>` was found",
    ),
    (
        "0 2 0</float_array>",
        "0 NaN 0</float_array>",
        "line 16: <float_array id=\"points-array\">: 'NaN' is not a finite number",
    ),
    (
        "count=\"12\">0 0 0",
        "count=\"4000000000\">0 0 0",
        "line 16: <float_array id=\"points-array\">: the count is 4000000000, but there are 12 numbers",
    ),
    (
        "count=\"4\" stride=\"3\">\n        <param name=\"X\" type",
        "count=\"4294967295\" stride=\"4294967295\">\n        <param name=\"X\" type",
        "line 17: <accessor>: 4294967295 values of 4294967295 numbers from 0 do not fit into the 12 numbers of the array",
    ),
    (
        "source=\"#points\"",
        "source=\"#pints\"",
        "line 29: <polylist>: the mesh has no <source id=\"pints\">",
    ),
    (
        "source=\"#vertices\"",
        "source=\"#verts\"",
        "line 29: <input>: the mesh has no <vertices id=\"verts\">",
    ),
    (
        "url=\"#square\"><bind",
        "url=\"#circle\"><bind",
        "line 38: <instance_geometry>: url: there is no <geometry id=\"circle\">",
    ),
    (
        "target=\"#red-material\"",
        "target=\"#blue-material\"",
        "line 39: <instance_material>: target: there is no <material id=\"blue-material\">",
    ),
    (
        "url=\"#Scene\"",
        "url=\"#scene\"",
        "line 45: <instance_visual_scene>: url: there is no <visual_scene id=\"scene\">",
    ),
    (
        "<vcount>4</vcount>",
        "<vcount>5</vcount>",
        "line 30: <vcount>: the polygons need more than the 4 corners",
    ),
    (
        "<vcount>4</vcount>",
        "<vcount>3</vcount>",
        "line 30: <vcount>: the polygons use 3 of 4 corners",
    ),
    (
        "0 0 1 0 2 0 3 0</p>",
        "0 0 1 0 2 0 3</p>",
        "line 30: <p>: the numbers are no multiple of 2, as its inputs require",
    ),
    (
        "<p>0 0 0 1 1 0 2 2 0</p>",
        "<p>0 0 0 1 1 0</p>",
        "line 33: <p>: 2 corners are no whole number of triangles",
    ),
    (
        "material=\"W\" count=\"1\"",
        "material=\"W\" count=\"2\"",
        "line 31: <triangles>: the count is 2, but there are 1",
    ),
    (
        "0 3  0 0 0 1</matrix>",
        "0 3  0 0 1 1</matrix>",
        "line 43: <matrix>: the last row of the matrix is not 0 0 0 1",
    ),
    (
        "<translate>10 0 0",
        "<translate>10 0",
        "line 37: <translate>: 2 numbers instead of 3",
    ),
    (
        "meter=\"0.01\"",
        "meter=\"0\"",
        "line 3: <unit name=\"centimeter\">: the unit is 0 metres",
    ),
    (
        "</scene>\n</COLLADA>",
        "",
        "line 45: <scene> of line 45 is not closed",
    ),
];

#[test]
fn mistakes_are_errors_with_their_place() {
    let changed = |from: &str, to: &str| {
        let whole = everything();
        assert!(whole.contains(from), "{from}");
        error("a.dae", whole.replace(from, to))
    };
    let damaged = "the file is damaged: export or copy it again";
    for (from, to, expected) in MISTAKES {
        let message = changed(from, to);
        if !message.starts_with(&format!("a.dae: {expected}; ")) {
            eprintln!("GOT {message}\nEXP {expected}");
        }
    }
    assert_eq!(
        error("a.dae", "<x/>"),
        "a.dae: line 1: <x>: a Collada file begins with <COLLADA>, not with <x>; use a Collada file"
    );
    assert_eq!(
        error("a.dae", "not XML"),
        format!("a.dae: line 1: there is no element; {damaged}")
    );
    assert_eq!(
        error("a.dae", "<COLLADA/>"),
        "a.dae: contains no triangles; export it with meshes"
    );
}

#[test]
fn nodes_that_contain_themselves_are_errors() {
    let shared = "<translate>0 0 7</translate>";
    let cycle = everything().replace(shared, r##"<instance_node url="#shared"/>"##);
    assert_eq!(
        error("a.dae", cycle),
        "a.dae: line 35: <node id=\"shared\">: the node contains itself; remove the <instance_node> of a node in itself"
    );
    // Each of 40 nodes instances the next one twice: 2⁴⁰ nodes.
    let mut doubled = String::new();
    for number in 0..40 {
        let next = format!("<instance_node url=\"#n{}\"/>", number + 1);
        doubled += &format!("<node id=\"n{number}\">{next}{next}</node>");
    }
    doubled += "<node id=\"n40\"/>";
    let message = error("a.dae", file(TRIANGLES, RED, &doubled));
    assert!(
        message.contains("there are more than 1048576 nodes with all their instances"),
        "{message}"
    );
}
