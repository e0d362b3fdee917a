//! Small stages that compose enormous scenes give an error at a count, and large stages load.
#![expect(clippy::unwrap_used, reason = "a test")]

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_usd::check::{CheckOptions, check};
use oaktwin_usd::stage::{SceneLimit, SceneOptions, StageScene, open_scene};
use oaktwin_usd::usdz;

/// Writes a stage whose composition doubles `depth` times, and returns its path and its number of cubes.
type Bomb = fn(folder: &Path, depth: u32) -> (PathBuf, usize);

const BOMBS: [(&str, Bomb); 13] = [
    ("references", |folder, depth| {
        layers(folder, depth, "references = @./LAYER@")
    }),
    ("payloads", |folder, depth| {
        layers(folder, depth, "payload = @./LAYER@")
    }),
    ("instances", |folder, depth| {
        layers(folder, depth, "references = @./LAYER@\ninstanceable = true")
    }),
    ("diamonds", |folder, depth| {
        let arcs = "references = [@./LAYER@</A>, @./LAYER@</B>]";
        pairs_of_layers(folder, depth, arcs)
    }),
    ("payload diamonds", |folder, depth| {
        pairs_of_layers(folder, depth, "payload = [@./LAYER@</A>, @./LAYER@</B>]")
    }),
    ("sublayers", sublayers),
    ("internal references", internal_references),
    ("internal diamonds", |folder, depth| {
        pairs(folder, depth, "references")
    }),
    ("internal payloads", |folder, depth| {
        pairs(folder, depth, "payload")
    }),
    ("inherits", |folder, depth| pairs(folder, depth, "inherits")),
    ("specializes", |folder, depth| pairs(folder, depth, "specializes")),
    ("variants", variants),
    ("point instancers", point_instancers),
];

fn write(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    fs::write(&path, format!("#usda 1.0\n{text}")).unwrap();
    path
}

/// Each layer has two prims with an arc to the layer before.
fn layers(folder: &Path, depth: u32, arc: &str) -> (PathBuf, usize) {
    let head = "(defaultPrim = \"A\")\ndef Xform \"A\"";
    let mut path = write(folder, "l0.usda", &format!("{head} {{ def Cube \"c\" {{}} }}"));
    for at in 1..=depth {
        let arc = arc.replace("LAYER", &format!("l{}.usda", at - 1));
        let child = |name: &str| format!("def Xform \"{name}\" ({arc}) {{}}");
        let text = format!("{head} {{\n{}\n{}\n}}", child("a"), child("b"));
        path = write(folder, &format!("l{at}.usda"), &text);
    }
    (path, 1 << depth)
}

/// Each layer has two prims with arcs to both prims of the layer before.
fn pairs_of_layers(folder: &Path, depth: u32, arcs: &str) -> (PathBuf, usize) {
    let cubes = "def Xform \"A\" { def Cube \"c\" {} }\ndef Xform \"B\" { def Cube \"c\" {} }";
    let mut path = write(folder, "l0.usda", cubes);
    for at in 1..=depth {
        let arcs = arcs.replace("LAYER", &format!("l{}.usda", at - 1));
        let text = format!("def Xform \"A\" ({arcs}) {{}}\ndef Xform \"B\" ({arcs}) {{}}");
        path = write(folder, &format!("l{at}.usda"), &text);
    }
    (path, 2)
}

/// Each layer has the layer before twice as a sublayer.
fn sublayers(folder: &Path, depth: u32) -> (PathBuf, usize) {
    let mut path = write(folder, "l0.usda", "def Cube \"c\" {}");
    for at in 1..=depth {
        let below = format!("@./l{}.usda@", at - 1);
        path = write(
            folder,
            &format!("l{at}.usda"),
            &format!("(subLayers = [{below}, {below}])"),
        );
    }
    (path, 1)
}

/// Each prim has two children with a reference to the prim before.
fn internal_references(folder: &Path, depth: u32) -> (PathBuf, usize) {
    let mut text = "def Xform \"A0\" { def Cube \"c\" {} }\n".to_owned();
    for at in 1..=depth {
        let child = |name: &str| format!("def Xform \"{name}\" (references = </A{}>) {{}}", at - 1);
        writeln!(text, "def Xform \"A{at}\" {{ {} {} }}", child("a"), child("b")).unwrap();
    }
    (write(folder, "stage.usda", &text), (2 << depth) - 1)
}

/// Each of two prims has arcs to both prims before.
fn pairs(folder: &Path, depth: u32, arc: &str) -> (PathBuf, usize) {
    let mut text = "class \"A0\" { def Cube \"c\" {} }\nclass \"B0\" { def Cube \"c\" {} }\n".to_owned();
    for at in 1..=depth {
        for name in ["A", "B"] {
            let to = at - 1;
            writeln!(text, "class \"{name}{at}\" ({arc} = [</A{to}>, </B{to}>]) {{}}").unwrap();
        }
    }
    writeln!(text, "def Xform \"Root\" ({arc} = </A{depth}>) {{}}").unwrap();
    (write(folder, "stage.usda", &text), 1)
}

/// Each prim has two variant sets, whose variants have a reference to a prim before.
fn variants(folder: &Path, depth: u32) -> (PathBuf, usize) {
    let mut text = "def Xform \"A0\" { def Cube \"c\" {} }\n".to_owned();
    for at in 1..=depth {
        let set = |name: &str| {
            let to = at - 1;
            format!(
                "variantSet \"{name}\" = {{ \"x\" {{ def Xform \"{name}\" (references = </A{to}>) {{}} }} }}"
            )
        };
        let chosen = "variants = { string a = \"x\" string b = \"x\" } prepend variantSets = [\"a\", \"b\"]";
        writeln!(
            text,
            "def Xform \"A{at}\" ({chosen}) {{\n{}\n{}\n}}",
            set("a"),
            set("b")
        )
        .unwrap();
    }
    (write(folder, "stage.usda", &text), (2 << depth) - 1)
}

/// Each point instancer has two points with the next one as their prototype.
fn point_instancers(folder: &Path, depth: u32) -> (PathBuf, usize) {
    let mut text = "def Xform \"Root\"\n{\n".to_owned();
    for at in 0..depth {
        let points = "int[] protoIndices = [0, 0]\npoint3f[] positions = [(0, 0, 0), (1, 0, 0)]";
        let next = at + 1;
        writeln!(
            text,
            "def PointInstancer \"P{at}\" {{\nrel prototypes = </Root/P{next}>\n{points}\n}}"
        )
        .unwrap();
    }
    writeln!(text, "def Cube \"P{depth}\" {{}}\n}}").unwrap();
    (write(folder, "stage.usda", &text), (2 << depth) - 1)
}

fn open(path: &Path, factor: f64) -> Result<StageScene, String> {
    let options = SceneOptions {
        limit: SceneLimit::new(factor).unwrap(),
        ..SceneOptions::default()
    };
    open_scene(path, &options).map_err(|error| error.to_string())
}

#[test]
fn small_depths_load_with_every_prim() {
    for (kind, bomb) in BOMBS {
        let folder = tempfile::tempdir().unwrap();
        let (path, cubes) = bomb(folder.path(), 4);
        let scene = open(&path, 1.0).unwrap();
        assert_eq!(scene.scene.instances.len(), cubes, "{kind}: {:?}", scene.findings);
    }
}

#[test]
fn exponential_depths_give_an_error_that_names_a_prim_and_the_option() {
    for (kind, bomb) in BOMBS {
        let folder = tempfile::tempdir().unwrap();
        let (path, _) = bomb(folder.path(), 40);
        let error = open(&path, 0.02).unwrap_err();
        let place = error.split(": ").nth(1).unwrap();
        let names_a_place = place.starts_with('/') || place == "l40.usda";
        assert!(
            names_a_place && error.contains("'scene-limit'"),
            "{kind}: {error}"
        );
        // The count decides, so the error is the same every time.
        assert_eq!(open(&path, 0.02).unwrap_err(), error, "{kind}");
        if kind != "point instancers" {
            let limit = SceneLimit::new(0.02).unwrap();
            let options = CheckOptions {
                limit,
                ..CheckOptions::default()
            };
            let error = check(&path, &options).unwrap_err().to_string();
            assert!(error.contains("'scene-limit'"), "{kind}: {error}");
        }
    }
}

#[test]
fn packages_are_limited() {
    let folder = tempfile::tempdir().unwrap();
    let (path, _) = layers(folder.path(), 40, "references = @./LAYER@");
    let files: Vec<(String, Vec<u8>)> = (0..=40)
        .rev()
        .map(|at| format!("l{at}.usda"))
        .map(|name| (name.clone(), fs::read(path.with_file_name(name)).unwrap()))
        .collect();
    let files: Vec<(&str, &[u8])> = files.iter().map(|(name, bytes)| (&**name, &**bytes)).collect();
    let package = path.with_extension("usdz");
    fs::write(&package, usdz::pack(&files).unwrap()).unwrap();
    let error = open(&package, 0.02).unwrap_err();
    assert!(
        error.contains("/a/a") && error.contains("'scene-limit'"),
        "{error}"
    );
}

#[test]
fn templates_of_value_clips_are_limited() {
    let folder = tempfile::tempdir().unwrap();
    write(
        folder.path(),
        "manifest.usda",
        "over \"Root\" { double3 xformOp:translate }",
    );
    let stage = |end: u64| {
        let template = format!(
            "string primPath = \"/Root\"\nasset manifestAssetPath = @./manifest.usda@\n\
            string templateAssetPath = \"clip.####.usda\"\ndouble templateStartTime = 1\n\
            double templateEndTime = {end}\ndouble templateStride = 1"
        );
        let text = format!(
            "def Xform \"Root\" (\nclips = {{ dictionary default = {{\n{template}\n}} }}\n) {{\n\
            double3 xformOp:translate\nuniform token[] xformOpOrder = [\"xformOp:translate\"]\n\
            def Cube \"c\" {{}}\n}}"
        );
        write(folder.path(), "stage.usda", &text)
    };
    assert_eq!(open(&stage(100), 1.0).unwrap().scene.instances.len(), 1);
    let error = open(&stage(100_000_000_000), 1.0).unwrap_err();
    assert!(error.contains("limit of 100000 clips"), "{error}");
}

#[test]
fn a_prim_may_have_many_properties() {
    let folder = tempfile::tempdir().unwrap();
    let properties: String = (0..200_000).map(|at| format!("float a{at} = 1\n")).collect();
    let text = format!("def Cube \"Root\"\n{{\n{properties}}}\n");
    let path = write(folder.path(), "stage.usda", &text);
    assert_eq!(open(&path, 1.0).unwrap().scene.instances.len(), 1);
}

#[test]
fn layers_of_a_stage_are_limited() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::new();
    for at in 0..50 {
        write(
            folder.path(),
            &format!("b{at}.usda"),
            "(defaultPrim = \"B\")\ndef Cube \"B\" {}",
        );
        writeln!(text, "def \"A{at}\" (references = @./b{at}.usda@) {{}}").unwrap();
    }
    let path = write(folder.path(), "many.usda", &text);
    assert_eq!(open(&path, 1.0).unwrap().scene.instances.len(), 50);
    let error = open(&path, 0.01).unwrap_err();
    assert!(
        error.contains("b39.usda: up to this one, layers multiply beyond the limit of 40 layers"),
        "{error}"
    );
}

#[test]
fn the_limit_can_be_raised() {
    let folder = tempfile::tempdir().unwrap();
    let (path, cubes) = layers(folder.path(), 9, "references = @./LAYER@");
    let error = open(&path, 0.01).unwrap_err();
    assert!(error.contains("beyond the limit of 2504 sites"), "{error}");
    assert_eq!(open(&path, 0.5).unwrap().scene.instances.len(), cubes);
    for invalid in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(SceneLimit::new(invalid), None);
    }
}

#[test]
fn layers_that_reference_each_other_in_cycles_load() {
    let folder = tempfile::tempdir().unwrap();
    let names = ["A", "B", "C"];
    let mut text = String::new();
    for name in names {
        let others = names.iter().filter(|other| **other != name);
        let arcs: Vec<String> = others.map(|other| format!("</{other}>")).collect();
        writeln!(
            text,
            "def Xform \"{name}\" (references = [{}]) {{ def Cube \"{name}\" {{}} }}",
            arcs.join(", ")
        )
        .unwrap();
    }
    let scene = open(&write(folder.path(), "stage.usda", &text), 1.0).unwrap();
    assert_eq!(scene.scene.instances.len(), 9);
    assert!(
        scene
            .findings
            .iter()
            .any(|finding| finding.message.contains("cycle"))
    );
}

#[test]
fn large_real_shapes_load_under_the_default_limits() {
    let folder = tempfile::tempdir().unwrap();
    // 300 000 points.
    let points: Vec<String> = (0..300_000).map(|at| format!("({at}, 0, 0)")).collect();
    let indices = vec!["0"; points.len()].join(", ");
    let text = format!(
        "def PointInstancer \"P\" {{\nrel prototypes = </P/Cube>\nint[] protoIndices = [{indices}]\n\
        point3f[] positions = [{}]\ndef Cube \"Cube\" {{}}\n}}",
        points.join(", ")
    );
    let scene = open(&write(folder.path(), "points.usda", &text), 1.0).unwrap();
    assert_eq!(scene.scene.instances.len(), 300_000);
    // 5 000 instances of one asset with ten parts, and 5 000 plain prims.
    let parts: String = (0..10).map(|at| format!("def Cube \"c{at}\" {{}}\n")).collect();
    write(
        folder.path(),
        "asset.usda",
        &format!("(defaultPrim = \"A\")\ndef Xform \"A\" {{\n{parts}}}"),
    );
    let mut text = String::new();
    for at in 0..5_000 {
        writeln!(
            text,
            "def \"i{at}\" (instanceable = true\nreferences = @./asset.usda@) {{}}"
        )
        .unwrap();
        writeln!(text, "def Cube \"p{at}\" {{}}").unwrap();
    }
    let scene = open(&write(folder.path(), "stage.usda", &text), 1.0).unwrap();
    assert_eq!(scene.scene.instances.len(), 55_000);
}
