//! The units of mesh files, and the names of files in errors.

use serde_json::{Value, json};

use super::super::render::program;
use super::client::{Server, frame, request, send, state};
use super::server;

#[test]
fn dropped_meshes_are_read_in_the_given_units() {
    let program = program();
    let server = server(&program);
    let mesh = std::fs::read(program.path("crate.obj")).unwrap();
    let read = |query: &str| server.post(&format!("/api/scenes?name=a.obj{query}"), &mesh);
    let size = |info: &Value| info["bounds"][1][0].as_f64().unwrap() - info["bounds"][0][0].as_f64().unwrap();
    let (_, metres) = read("");
    assert_eq!((&metres["scale"], &metres["up"]), (&json!(1.0), &json!("y")));
    let (_, inches) = read("&scale=0.0254&up=z");
    assert_eq!((&inches["scale"], &inches["up"]), (&json!(0.0254), &json!("z")));
    assert!((size(&inches) - 0.0254 * size(&metres)).abs() < 1e-9, "{inches}");
    assert_ne!(inches["id"], metres["id"]);
    assert_eq!(read("&scale=0.0254&up=z").1["id"], inches["id"]);
    for (query, field) in [("&scale=0", "scale"), ("&scale=-1", "scale"), ("&up=x", "up")] {
        let (status, answer) = read(query);
        assert_eq!(
            (status, &answer["field"]),
            (422, &json!(field)),
            "{query}: {answer}"
        );
    }
}

#[test]
fn units_of_the_command_line_need_a_scene() {
    let program = program();
    for (arguments, needle) in [
        (&["studio", "--scale", "0.001"][..], "SCENE"),
        (&["studio", "--up", "z"], "SCENE"),
        (
            &["studio", "crate.obj", "--scale", "0"],
            "--scale: must be a finite number > 0",
        ),
    ] {
        let ended = program.run(arguments);
        assert_eq!(ended.code, 2, "{arguments:?}: {}", ended.stderr);
        assert!(ended.stderr.contains(needle), "{arguments:?}: {}", ended.stderr);
    }
}

#[test]
fn errors_name_files_as_the_page_knows_them() {
    let program = program();
    let server = server(&program);
    let document = json!({
        "asset": {"version": "2.0"},
        "buffers": [{"uri": "points.bin", "byteLength": 36}],
    });
    let (status, answer) = server.post("/api/scenes?name=a.gltf", document.to_string().as_bytes());
    let error = answer["error"].as_str().unwrap();
    assert_eq!(status, 422, "{answer}");
    assert!(
        error.starts_with("a.gltf: ") && error.contains("points.bin"),
        "{error}"
    );
    assert!(!error.contains("oaktwin-studio-"), "{error}");
}

/// A plate whose texture is in a folder that does not exist.
const PAINTED: &str = r#"#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
)
def Mesh "Plate" (prepend apiSchemas = ["MaterialBindingAPI"])
{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(-2, 0, -2), (2, 0, -2), (2, 0, 2), (-2, 0, 2)]
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = "vertex")
    rel material:binding = </Wood>
}
def Material "Wood"
{
    token outputs:surface.connect = </Wood/Surface.outputs:surface>
    def Shader "Surface"
    {
        uniform token info:id = "UsdPreviewSurface"
        color3f inputs:diffuseColor.connect = </Wood/Texture.outputs:rgb>
        token outputs:surface
    }
    def Shader "Texture"
    {
        uniform token info:id = "UsdUVTexture"
        asset inputs:file = @TEXTURE@
        float2 inputs:st.connect = </Wood/Place.outputs:result>
        float3 outputs:rgb
    }
    def Shader "Place"
    {
        uniform token info:id = "UsdPrimvarReader_float2"
        string inputs:varname = "st"
        float2 outputs:result
    }
}
"#;

#[test]
fn findings_have_no_folders_of_the_server() {
    let program = program();
    for texture in ["./textures/wood.png", "../elsewhere/wood.png"] {
        let stage = PAINTED.replace("TEXTURE", texture);
        std::fs::create_dir_all(program.path("rooms")).unwrap();
        program.put("rooms/plate.usda", &stage);
        let path = program.path("rooms/plate.usda");
        for named in [path.to_str().unwrap(), "rooms/plate.usda"] {
            let server = Server::start(&program, &[named]);
            let (_, dropped) = server.post("/api/scenes?name=dropped.usda", stage.as_bytes());
            let mut found = 0;
            let mut page = server.page();
            for (id, scene) in [(1, server.get("/api/scenes/first")), (2, dropped)] {
                let mut asked = request(id, &state());
                asked["scene"] = scene["id"].clone();
                send(&mut page, &asked);
                let seen = frame(&mut page).header["findings"].clone();
                let all = format!("{} {seen}", scene["findings"]);
                found += usize::from(all.contains("wood.png"));
                let folder = program.path("");
                let whole = folder.canonicalize().unwrap();
                for private in [
                    folder.to_str().unwrap(),
                    whole.to_str().unwrap(),
                    "oaktwin-studio-",
                ] {
                    assert!(!all.contains(private.trim_end_matches('/')), "{named}: {all}");
                }
            }
            assert_eq!(found, 2, "{named}: both say that the texture is missing");
        }
    }
}
