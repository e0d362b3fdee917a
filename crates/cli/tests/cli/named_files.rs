//! Files that a scene names: regular files only, and no pipe is waited for.

#![cfg(unix)]

use std::fs;
use std::process::Command;

use crate::program::{Ended, Program};

/// A square with a texture, and what else the stage says.
fn stage(texture: &str, more: &str) -> String {
    format!(
        r#"#usda 1.0
( upAxis = "Z" metersPerUnit = 1 )
def Mesh "M" ( prepend apiSchemas = ["MaterialBindingAPI"] ) {{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(2, -1, 0), (2, 1, 0), (2, 1, 2), (2, -1, 2)]
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "vertex" )
    rel material:binding = </Mat>
}}
def Material "Mat" {{
    token outputs:surface.connect = </Mat/S.outputs:surface>
    def Shader "S" {{
        uniform token info:id = "UsdPreviewSurface"
        color3f inputs:diffuseColor.connect = </Mat/T.outputs:rgb>
        token outputs:surface
    }}
    def Shader "T" {{
        uniform token info:id = "UsdUVTexture"
        asset inputs:file = @{texture}@
        float3 outputs:rgb
    }}
}}
{more}
"#
    )
}

fn program() -> Program {
    let program = Program::new();
    for name in [
        "pipe",
        "pipe.png",
        "pipe.mtlx",
        "pipe.usda",
        "pipe.bin",
        "pipe.mtl",
    ] {
        let made = Command::new("mkfifo").arg(program.path(name)).status();
        assert!(made.unwrap().success());
    }
    program
}

/// Runs the program, which must end by itself.
fn ended(program: &Program, arguments: &str) -> Ended {
    let arguments: Vec<&str> = arguments.split(' ').collect();
    program.signalled(&[], &arguments, |_| true)
}

const VIEW: &str = "--model oak4-d --look-at 0 0 1 2 0 1 --resolution 32x20 --annotators rgb -o out";

#[test]
fn textures_that_are_no_files_are_reported() {
    for texture in ["pipe.png", "pipe", "/dev/zero", "/dev/tty"] {
        let program = program();
        program.put("a.usda", stage(texture, ""));
        let ended = ended(&program, &format!("render a.usda {VIEW}"));
        assert_eq!(ended.code, 0, "{texture}: {}", ended.stderr);
        assert!(
            ended.stderr.contains("is not a regular file"),
            "{texture}: {}",
            ended.stderr
        );
        assert!(program.path("out/rgb_0000.png").exists());
    }
}

#[test]
fn layers_and_documents_that_are_no_files_are_reported() {
    for reference in ["pipe.mtlx", "pipe.usda", "/dev/zero"] {
        let program = program();
        let more = format!("def \"R\" ( references = @{reference}@</X> ) {{}}");
        program.put("a.usda", stage("none.png", &more));
        let rendered = ended(&program, &format!("render a.usda {VIEW}"));
        assert_eq!(rendered.code, 0, "{reference}: {}", rendered.stderr);
        assert!(rendered.stderr.contains(reference), "{}", rendered.stderr);
        let checked = ended(&program, "check a.usda");
        assert!(
            checked.stdout.contains(reference),
            "{}{}",
            checked.stdout,
            checked.stderr
        );
    }
}

#[test]
fn buffers_and_material_libraries_that_are_no_files_are_reported() {
    let program = program();
    program.put(
        "a.gltf",
        r#"{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "pipe.bin"}]}"#,
    );
    let gltf = ended(&program, &format!("render a.gltf {VIEW}"));
    assert_eq!(gltf.code, 2);
    assert!(
        gltf.stderr.contains("pipe.bin: is not a regular file"),
        "{}",
        gltf.stderr
    );
    program.put(
        "a.obj",
        "mtllib pipe.mtl\nv 2 -1 0\nv 2 1 0\nv 2 0 2\nusemtl x\nf 1 2 3\n",
    );
    let obj = ended(&program, &format!("render a.obj {VIEW}"));
    assert_eq!(obj.code, 0, "{}", obj.stderr);
    assert!(obj.stderr.contains("pipe.mtl"), "{}", obj.stderr);
}

#[test]
fn buffers_outside_the_folder_need_an_option() {
    let program = Program::new();
    fs::create_dir(program.path("scene")).unwrap();
    let corners: Vec<u8> = [2.0f32, -1.0, 0.0, 2.0, 1.0, 0.0, 2.0, 0.0, 2.0]
        .iter()
        .flat_map(|number| number.to_le_bytes())
        .collect();
    program.put("secret.bin", corners);
    program.put(
        "scene/a.gltf",
        r#"{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "../secret.bin"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]}"#,
    );
    let command = format!("render scene/a.gltf --up z {VIEW}");
    let arguments: Vec<&str> = command.split(' ').collect();
    assert_eq!(
        program.refused(&arguments),
        "error: scene/a.gltf: buffers[0]: scene/../secret.bin: is outside the folder of the glTF file; \
         move it there, or add --allow-outside if the scene is trusted\n"
    );
    program.good(&[&arguments[..], &["--allow-outside"]].concat());
}
