//! Where surfaces of a stage are invisible. Rendered masks are compared with independent arithmetic in
//! `tests/oracles/test_usd_opacity.py`.
#![expect(clippy::unwrap_used, reason = "a test")]

use oaktwin_scene::Opacity;
use oaktwin_usd::stage::{SceneOptions, StageScene, open_scene};

/// Reads a triangle whose material has a surface with these inputs.
fn read(id: &str, inputs: &str) -> StageScene {
    let text = format!(
        r#"#usda 1.0
def Mesh "M" {{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (0, 1)] (interpolation = "vertex")
    texCoord2f[] primvars:cut = [(0, 0), (0.5, 0), (0, 1)] (interpolation = "vertex")
    rel material:binding = </Look>
}}
def Material "Look" {{
    token outputs:surface.connect = </Look/S.outputs:surface>
    def Shader "S" {{
        uniform token info:id = "{id}"
        {inputs}
        token outputs:surface
    }}
    def Shader "T" {{
        uniform token info:id = "UsdUVTexture"
        asset inputs:file = @mask.png@
        float4 inputs:scale = (1, 2, 3, 4)
        float2 inputs:st.connect = </Look/R.outputs:result>
        float outputs:g
        float outputs:a
    }}
    def Shader "R" {{
        uniform token info:id = "UsdPrimvarReader_float2"
        string inputs:varname = "cut"
        float2 outputs:result
    }}
    def Shader "Image" {{
        uniform token info:id = "ND_image_color4"
        asset inputs:file = @mask.png@
        color4f outputs:out
    }}
    def Shader "Blue" {{
        uniform token info:id = "ND_separate4_color4"
        color4f inputs:in.connect = </Look/Image.outputs:out>
        float outputs:outb
    }}
    def Shader "Noise" {{
        uniform token info:id = "ND_fractal3d_float"
        float outputs:out
    }}
}}
"#
    );
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mask.png"), b"not decoded here").unwrap();
    let path = folder.path().join("a.usda");
    std::fs::write(&path, text).unwrap();
    open_scene(&path, &SceneOptions::default()).unwrap()
}

/// The opacity, and the codes of the findings.
fn opacity(id: &str, inputs: &str) -> (Option<Opacity>, Vec<&'static str>) {
    let read = read(id, inputs);
    let codes = read.findings.iter().map(|finding| finding.code);
    (read.scene.materials[0].opacity, codes.collect())
}

#[test]
fn preview_surfaces() {
    let preview = |inputs: &str| opacity("UsdPreviewSurface", inputs);
    assert_eq!(preview("float inputs:opacity = 1"), (None, vec![]));
    let (half, codes) = preview("float inputs:opacity = 0.5");
    assert!(half.unwrap().is_partial() && half.unwrap().at(1.0) == 0.5 && codes.is_empty());
    let (bright, codes) = preview("float inputs:opacity = 1.5");
    assert_eq!((bright, codes), (None, vec!["material-value"]));
    assert_eq!(
        preview("float inputs:opacity = 0.5 float inputs:opacityThreshold = 0.25"),
        (None, vec![])
    );
    for invisible in [
        "float inputs:opacity = 0",
        "float inputs:opacity = 0.5 float inputs:opacityThreshold = 0.75",
    ] {
        let (opacity, codes) = preview(invisible);
        assert!(opacity.unwrap().at(1.0) == 0.0 && codes.is_empty(), "{invisible}");
    }
    let (cut, codes) =
        preview("float inputs:opacity.connect = </Look/T.outputs:g> float inputs:opacityThreshold = 0.5");
    let (cut, mask) = (cut.unwrap(), cut.unwrap().mask.unwrap());
    assert_eq!(
        (mask.channel, mask.texture.scale, cut.threshold),
        (1, [1.0, 2.0, 3.0, 4.0], 0.5)
    );
    assert!(codes.is_empty());
    let (faded, codes) = preview("float inputs:opacity.connect = </Look/T.outputs:a>");
    assert!(faded.unwrap().is_partial() && codes.is_empty());
    let unknown = preview("float inputs:opacity.connect = </Look/Noise.outputs:out>");
    assert_eq!(unknown, (None, vec!["unsupported-material"]));
}

#[test]
fn masks_have_their_own_texture_coordinates() {
    let read = read(
        "UsdPreviewSurface",
        "float inputs:opacity.connect = </Look/T.outputs:a> float inputs:opacityThreshold = 0.5",
    );
    let mesh = &read.scene.meshes[0];
    let uvs = mesh.uvs.as_ref().unwrap().corners(0, [0, 1, 2]).unwrap();
    assert_eq!(uvs[1], [0.5, 0.0]);
}

#[test]
fn other_shaders() {
    let channel = |id: &str, inputs: &str| opacity(id, inputs).0.unwrap().mask.unwrap().channel;
    let blue = "color3f inputs:opacity.connect = </Look/Blue.outputs:outb>";
    assert_eq!(channel("ND_standard_surface_surfaceshader", blue), 2);
    let hidden = [
        (
            "ND_standard_surface_surfaceshader",
            "color3f inputs:opacity = (0, 0, 0)",
        ),
        (
            "ND_open_pbr_surface_surfaceshader",
            "float inputs:geometry_opacity = 0",
        ),
        (
            "ND_gltf_pbr_surfaceshader",
            "float inputs:alpha = 0.25 int inputs:alpha_mode = 1",
        ),
        (
            "OmniPBR",
            "color3f inputs:diffuse_color_constant = (1, 1, 1) bool inputs:enable_opacity = 1 float inputs:opacity_constant = 0",
        ),
    ];
    for (id, inputs) in hidden {
        assert!(opacity(id, inputs).0.unwrap().at(1.0) == 0.0, "{id}");
    }
    let solid = [
        (
            "ND_gltf_pbr_surfaceshader",
            "float inputs:alpha = 0 int inputs:alpha_mode = 0",
        ),
        (
            "OmniPBR",
            "color3f inputs:diffuse_color_constant = (1, 1, 1) float inputs:opacity_constant = 0",
        ),
    ];
    for (id, inputs) in solid {
        assert_eq!(opacity(id, inputs).0, None, "{id}");
    }
    let image = "color3f inputs:diffuse_color_constant = (1, 1, 1) bool inputs:enable_opacity = 1
        bool inputs:enable_opacity_texture = 1 asset inputs:opacity_texture = @mask.png@ int inputs:opacity_mode = 0";
    assert_eq!(channel("OmniPBR", image), 3);
}

#[test]
fn glass_and_mirrors() {
    let material = |id: &str, inputs: &str| {
        let read = read(id, inputs);
        let codes: Vec<_> = read.findings.iter().map(|finding| finding.code).collect();
        (read.scene.materials[0].clone(), codes)
    };
    let (preview, codes) = material(
        "UsdPreviewSurface",
        "float inputs:ior = 1.33 int inputs:useSpecularWorkflow = 1 color3f inputs:specularColor = (0.9, 0.8, 0.7)",
    );
    assert_eq!((preview.index, preview.specular), (1.33, Some([0.9, 0.8, 0.7])));
    assert!(preview.transmission.is_none() && codes.is_empty());
    let (bad, codes) = material("UsdPreviewSurface", "float inputs:ior = 0");
    assert_eq!((bad.index, codes), (1.5, vec!["material-value"]));

    let (standard, codes) = material(
        "ND_standard_surface_surfaceshader",
        "float inputs:transmission = 0.9 color3f inputs:transmission_color = (0.5, 1, 0.5) float inputs:specular_IOR = 1.6",
    );
    let transmission = standard.transmission.unwrap();
    assert_eq!(
        (transmission.share, transmission.tint),
        (0.9, Some([0.5, 1.0, 0.5]))
    );
    assert!(transmission.refracts && standard.index == 1.6 && codes.is_empty());

    let (open, _) = material(
        "ND_open_pbr_surface_surfaceshader",
        "float inputs:transmission_weight = 1 bool inputs:geometry_thin_walled = 1",
    );
    let transmission = open.transmission.unwrap();
    assert_eq!(
        (transmission.tint, transmission.refracts),
        (Some([1.0; 3]), false)
    );

    let image = "float inputs:transmission_weight.connect = </Look/T.outputs:r>";
    let (textured, codes) = material("ND_open_pbr_surface_surfaceshader", image);
    let transmission = textured.transmission.unwrap();
    assert_eq!((transmission.share, transmission.mask.unwrap().channel), (1.0, 0));
    assert!(codes.is_empty(), "{codes:?}");
    let noise = "float inputs:transmission_weight.connect = </Look/Noise.outputs:out>";
    let (unknown, codes) = material("ND_open_pbr_surface_surfaceshader", noise);
    assert_eq!(
        (unknown.transmission, codes),
        (None, vec!["unsupported-material"])
    );

    let (gltf, _) = material("ND_gltf_pbr_surfaceshader", "float inputs:transmission = 0.5");
    let transmission = gltf.transmission.unwrap();
    assert_eq!(
        (transmission.share, transmission.tint, transmission.refracts),
        (0.5, None, false)
    );

    let (glass, codes) = material(
        "",
        r#"uniform asset info:mdl:sourceAsset = @OmniGlass.mdl@
        uniform token info:mdl:sourceAsset:subIdentifier = "OmniGlass"
        color3f inputs:glass_color = (0.8, 0.9, 1) float inputs:glass_ior = 1.52"#,
    );
    let transmission = glass.transmission.unwrap();
    assert_eq!(
        (transmission.share, transmission.tint),
        (1.0, Some([0.8, 0.9, 1.0]))
    );
    assert_eq!((glass.index, glass.roughness, codes), (1.52, 0.0, vec![]));
}

#[test]
fn prims_without_a_material_have_their_display_opacity() {
    let text = r#"#usda 1.0
def Xform "Pale" {
    float[] primvars:displayOpacity = [0.25] (interpolation = "constant")
    def Sphere "Inherits" {}
    def Cube "Own" { float[] primvars:displayOpacity = [0] }
    def Cube "Bound" { rel material:binding = </Look> }
    def Mesh "Varies" {
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
        color3f[] primvars:displayColor = [(1, 0, 0)]
        float[] primvars:displayOpacity = [0, 0.5, 1] (interpolation = "vertex")
    }
    def Cube "Solid" { float[] primvars:displayOpacity = [1] }
    def Cube "Wrong" { float[] primvars:displayOpacity = [2] }
}
def Material "Look" {
    token outputs:surface.connect = </Look/S.outputs:surface>
    def Shader "S" {
        uniform token info:id = "UsdPreviewSurface"
        token outputs:surface
    }
}
"#;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.usda");
    std::fs::write(&path, text).unwrap();
    let StageScene { scene, findings, .. } = open_scene(&path, &SceneOptions::default()).unwrap();
    let opacity = |name: &str| {
        let mut instances = scene.instances.iter();
        let instance = instances
            .find(|instance| instance.path == format!("/Pale/{name}"))
            .unwrap();
        let mesh = &scene.meshes[instance.mesh as usize];
        let material = mesh.material(0).map(|index| &scene.materials[index as usize]);
        (
            material.and_then(|material| material.opacity).map(|o| o.at(1.0)),
            mesh.colors.is_some(),
        )
    };
    assert_eq!(opacity("Inherits"), (Some(0.25), false));
    assert_eq!(opacity("Own"), (Some(0.0), false));
    assert_eq!(opacity("Varies"), (Some(0.5), true));
    for solid in ["Bound", "Solid", "Wrong"] {
        assert_eq!(opacity(solid), (None, false), "{solid}");
    }
    let found: Vec<_> = findings.iter().map(|finding| finding.code).collect();
    assert_eq!(found, ["unsupported-material", "material-value"]);
}
