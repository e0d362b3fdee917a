//! USD: layers, packages, `MaterialX`, and the emitter.

use std::path::Path;

use oaktwin_usd::check::CheckOptions;
use oaktwin_usd::stage::{self, SceneLimit, SceneOptions};
use oaktwin_usd::text::{AttributeSpec, Layer, PrimSpec, SpecValue, UpAxis};
use oaktwin_usd::{check, materialx, usdz};

use crate::random::Random;
use crate::{file, scene};

/// Opens a file as `render` does, or, for one length in four, as `check` does.
fn open(bytes: &[u8], extension: &str) {
    let is_checked = bytes.len().is_multiple_of(4);
    file::with(&format!("x.{extension}"), bytes, |path| read(path, is_checked));
}

fn read(path: &Path, is_checked: bool) {
    let error = if is_checked {
        check::check(path, &CheckOptions::default())
            .err()
            .map(|error| error.to_string())
    } else {
        let options = SceneOptions {
            time: None,
            subdivide: 1,
            ..SceneOptions::default()
        };
        match stage::open_scene(path, &options) {
            Ok(opened) => {
                scene::check(&opened.scene);
                None
            }
            Err(error) => Some(error.to_string()),
        }
    };
    if let Some(error) = error {
        assert!(error.starts_with(&*path.to_string_lossy()), "{error}");
    }
}

/// The first byte selects text, or a stage that is drawn.
pub(crate) fn usda(bytes: &[u8]) {
    match bytes.split_first() {
        Some((0, rest)) => open(rest, "usda"),
        Some((_, rest)) => open(drawn(rest).as_bytes(), "usda"),
        None => open(&[], "usda"),
    }
}

pub(crate) fn usdc(bytes: &[u8]) {
    open(bytes, "usdc");
}

/// The first byte selects a package, or layers to pack.
pub(crate) fn usdz(bytes: &[u8]) {
    match bytes.split_first() {
        Some((0, rest)) => open(rest, "usdz"),
        Some((1, rest)) => pack(&[("x.usda", rest)]),
        Some((_, rest)) => {
            let (first, second) = rest.split_at(rest.len() / 2);
            let root = "#usda 1.0\n(\n    subLayers = [@./a/b.usda@]\n)\ndef \"R\" (prepend references = @c.usda@</P0>)\n{\n}\n";
            pack(&[
                ("x.usda", root.as_bytes()),
                ("a/b.usda", drawn(first).as_bytes()),
                ("c.usda", drawn(second).as_bytes()),
            ]);
        }
        None => open(&[], "usdz"),
    }
}

fn pack(files: &[(&str, &[u8])]) {
    let package = usdz::pack(files).unwrap_or_else(|error| panic!("{error}"));
    open(&package, "usdz");
}

pub(crate) fn materialx(bytes: &[u8]) {
    if let Ok(layer) = materialx::to_layer(bytes) {
        let text = layer.text();
        assert!(text.starts_with("#usda 1.0"));
    }
}

/// Emits a layer of drawn names and values, and reads it.
pub(crate) fn emitter(bytes: &[u8]) {
    let mut random = Random::new(bytes);
    let width = random.number();
    let text = random.text();
    let mut camera = PrimSpec::def("Camera", "Camera").documented(random.text());
    camera.set("focalLength", SpecValue::Float(positive(&mut random)));
    camera.set("horizontalAperture", SpecValue::Float(positive(&mut random)));
    camera.set(
        "test:double",
        SpecValue::Double(if width.is_finite() { width } else { 1.0 }),
    );
    camera.set("test:text", SpecValue::string(text.clone()));
    camera.set("test:asset", SpecValue::Asset("a.png".to_owned()));
    camera.add(AttributeSpec::new("test:token", SpecValue::token(random.text())));
    let layer = Layer {
        documentation: Some(random.text()),
        default_prim: Some("World".to_owned()),
        up_axis: Some(UpAxis::Z),
        meters_per_unit: Some(1.0),
        prims: vec![PrimSpec::def("Xform", "World").with_child(camera)],
        ..Layer::default()
    };
    let emitted = layer.text();
    let stage = file::with("x.usda", emitted.as_bytes(), |path| {
        stage::open(path, SceneLimit::default())
    })
    .unwrap_or_else(|error| panic!("{error}\n{emitted}"));
    let read = &stage.cameras[0];
    let text = text.replace('\0', "\u{fffd}");
    assert_eq!(read.prim.text("test:text"), Some(text.as_str()), "{emitted}");
    if width.is_finite() {
        assert_eq!(
            read.prim.number("test:double").map(f64::to_bits),
            Some(width.to_bits()),
            "{emitted}"
        );
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a float attribute")]
fn positive(random: &mut Random<'_>) -> f32 {
    let number = random.number().abs() as f32;
    if number.is_finite() { number } else { 1.0 }
}

/// Types of prims, and attributes with values that suit a mesh of four points.
const TYPES: [&str; 22] = [
    "Mesh",
    "Mesh",
    "Xform",
    "Camera",
    "Material",
    "Shader",
    "Scope",
    "Cube",
    "Sphere",
    "Cylinder",
    "Cone",
    "Capsule",
    "Plane",
    "GeomSubset",
    "PointInstancer",
    "DistantLight",
    "DomeLight",
    "SphereLight",
    "RenderProduct",
    "BasisCurves",
    "Points",
    "",
];
const PROPERTIES: [&str; 44] = [
    "point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]",
    "int[] faceVertexCounts = [4]",
    "int[] faceVertexIndices = [0, 1, 2, 3]",
    "int[] faceVertexCounts = [3, 3]",
    "int[] faceVertexIndices = [0, 1, 2, 0, 2, 3]",
    "int[] faceVertexIndices = [0, 1, 2, 0, 2, $]",
    "int[] holeIndices = [$]",
    "normal3f[] normals = [(0, 0, 1), (0, 0, 1), (0, 0, 1), (0, 0, $)] (interpolation = \"vertex\")",
    "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, $)] (interpolation = \"varying\")",
    "int[] primvars:st:indices = [0, 1, 2, $]",
    "color3f[] primvars:displayColor = [($, 0.5, 0.2)]",
    "uniform token subdivisionScheme = \"none\"",
    "uniform token subdivisionScheme = \"loop\"",
    "uniform token orientation = \"leftHanded\"",
    "int[] creaseIndices = [0, 1]",
    "int[] creaseLengths = [2]",
    "float[] creaseSharpnesses = [$]",
    "int[] cornerIndices = [$]",
    "float[] cornerSharpnesses = [2]",
    "double3 xformOp:translate = ($, 0, 1)",
    "float3 xformOp:scale = (1, $, 1)",
    "float xformOp:rotateZ = $",
    "matrix4d xformOp:transform = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, $, 0), (0, 0, 0, 1))",
    "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:scale\", \"xformOp:rotateZ\"]",
    "uniform token[] xformOpOrder = [\"!resetXformStack!\", \"xformOp:transform\", \"!invert!xformOp:scale\"]",
    "float focalLength = $",
    "float horizontalAperture = $",
    "float2 clippingRange = (0.1, $)",
    "double size = $",
    "double radius = $",
    "double height = $",
    "token visibility = \"invisible\"",
    "uniform token purpose = \"guide\"",
    "rel material:binding = </P0/P1>",
    "rel prototypes = [</P0/P0>]",
    "int[] protoIndices = [0, $]",
    "point3f[] positions = [(0, 0, 0), ($, 0, 0)]",
    "quath[] orientations = [(1, 0, 0, 0), (0.5, 0.5, $, 0.5)]",
    "float3[] scales = [(1, 1, 1), ($, 1, 1)]",
    "float inputs:intensity = $",
    "uniform token info:id = \"UsdPreviewSurface\"",
    "token outputs:surface.connect = </P0/P1.outputs:surface>",
    "double radius.timeSamples = { 0: 1, $: 2 }",
    "asset inputs:texture:file = @t.png@",
];
const METADATA: [&str; 8] = [
    "",
    "",
    "",
    "",
    "instanceable = true",
    "prepend apiSchemas = [\"MaterialBindingAPI\"]",
    "active = false",
    "prepend references = </P0/P1>",
];

/// Writes a stage of at most 24 prims. Few references, since they multiply.
fn drawn(bytes: &[u8]) -> String {
    let mut random = Random::new(bytes);
    let up = random.pick(&["Y", "Z"]);
    let unit = random.pick(&["1", "0.01", "0", "-1", "1e300"]);
    let mut text = format!(
        "#usda 1.0\n(\n    defaultPrim = \"P0\"\n    metersPerUnit = {unit}\n    upAxis = \"{up}\"\n)\n"
    );
    let mut count = 24;
    let mut references = 3;
    for number in 0..3 {
        prim(number, 0, &mut count, &mut references, &mut random, &mut text);
    }
    text
}

fn prim(
    number: u32,
    depth: u32,
    count: &mut u32,
    references: &mut u32,
    random: &mut Random<'_>,
    text: &mut String,
) {
    if *count == 0 || (random.is_empty() && number > 0) {
        return;
    }
    *count -= 1;
    let mut metadata = random.pick(&METADATA);
    if metadata.contains("references") {
        if *references == 0 {
            metadata = "";
        }
        *references = references.saturating_sub(1);
    }
    let kind = random.pick(&TYPES);
    *text += &format!("def {kind} \"P{number}\" ({metadata})\n{{\n");
    let mut used = Vec::new();
    if kind == "Mesh" && random.up_to(3) > 0 {
        used = vec![0, 1, 2];
    }
    for _ in 0..random.up_to(8) {
        used.push(random.up_to(43) as usize);
    }
    used.dedup();
    for property in used {
        let number = match random.up_to(2) {
            0 => format!("{}", f64::from(random.up_to(5)) - 1.0),
            1 => random.up_to(9).to_string(),
            _ => format!("{:?}", random.number()).replace("NaN", "nan"),
        };
        *text += &PROPERTIES[property].replace('$', &number);
        *text += "\n";
    }
    if depth < 4 {
        for child in 0..random.up_to(3) {
            prim(child, depth + 1, count, references, random, text);
        }
    }
    *text += "}\n";
}

pub(crate) fn usda_seeds() -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = (1..6u8)
        .map(|seed| {
            (0..200u8)
                .map(|at| at.wrapping_mul(seed * 2 + 1).wrapping_add(1))
                .collect()
        })
        .collect();
    all.extend((2..5u8).map(|seed| {
        [
            b"\0",
            drawn(
                &(0..200u8)
                    .map(|at| at.wrapping_mul(seed * 2 + 1))
                    .collect::<Vec<_>>(),
            )
            .as_bytes(),
        ]
        .concat()
    }));
    all.push(b"\0#usda 1.0\ndef Mesh \"M\"\n{\n    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]\n    int[] faceVertexCounts = [3]\n    int[] faceVertexIndices = [0, 1, 2]\n}\n".to_vec());
    all
}

pub(crate) fn usdc_seeds() -> Vec<Vec<u8>> {
    vec![include_bytes!("../../usd/fixtures/binary.usdc").to_vec()]
}

pub(crate) fn usdz_seeds() -> Vec<Vec<u8>> {
    let layer = drawn(&(0..200u8).map(|at| at.wrapping_mul(7)).collect::<Vec<_>>());
    let package = usdz::pack(&[("x.usda", layer.as_bytes())]).unwrap_or_default();
    vec![
        [&[0], &package[..]].concat(),
        [b"\x01", layer.as_bytes()].concat(),
        (2..240).collect(),
    ]
}

pub(crate) fn materialx_seeds() -> Vec<Vec<u8>> {
    vec![
        br#"<?xml version="1.0"?>
<materialx version="1.38">
  <nodegraph name="NG"><image name="i" type="color3"><input name="file" type="filename" value="t.png"/></image>
    <output name="out" type="color3" nodename="i"/></nodegraph>
  <standard_surface name="S" type="surfaceshader"><input name="base_color" type="color3" nodegraph="NG" output="out"/>
    <input name="metalness" type="float" value="0.5"/></standard_surface>
  <surfacematerial name="M" type="material"><input name="surfaceshader" type="surfaceshader" nodename="S"/></surfacematerial>
</materialx>"#
            .to_vec(),
    ]
}

pub(crate) fn emitter_seeds() -> Vec<Vec<u8>> {
    (1..5u8)
        .map(|seed| (0..120u8).map(|at| at.wrapping_mul(seed * 2 + 1)).collect())
        .collect()
}
