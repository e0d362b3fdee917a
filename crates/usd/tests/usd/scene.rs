//! Scenes of unusual or broken stages: valid prims are read and the others are reported. Well-formed stages are compared
//! with OpenUSD in `tests/oracles/test_usd_scene.py`.
#![expect(clippy::unwrap_used, reason = "a test")]

use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_scene::{ColorSpace, TextureSource, Up, Wrap};
use oaktwin_usd::stage::{SceneOptions, StageScene, open_scene};
use oaktwin_usd::usdz;

const TRIANGLE: &str = r#"
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
"#;

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, bytes).unwrap();
        path
    }

    fn usda(&self, name: &str, body: &str) -> PathBuf {
        self.write(name, format!("#usda 1.0\n(\n    metersPerUnit = 1\n)\n{body}"))
    }
}

fn open(path: &Path) -> StageScene {
    open_scene(path, &SceneOptions::default()).unwrap()
}

fn codes(read: &StageScene) -> Vec<(&str, &str)> {
    let of = |finding: &oaktwin_base::diagnostic::Finding| finding.code;
    read.findings
        .iter()
        .map(|finding| (of(finding), finding.place.as_str()))
        .collect()
}

fn paths(read: &StageScene) -> Vec<&str> {
    read.scene
        .instances
        .iter()
        .map(|instance| instance.path.as_str())
        .collect()
}

#[test]
fn empty_stage_is_an_empty_scene() {
    let folder = Folder::new();
    let read = open(&folder.write("empty.usda", "#usda 1.0\n"));
    assert!(read.scene.instances.is_empty() && read.cameras.is_empty() && read.findings.is_empty());
    assert_eq!(read.scene.up, Up::Y);
    assert_eq!(read.scene.meters_per_unit.0, 0.01);
}

#[test]
fn reports_missing_files_and_reads_the_rest() {
    let folder = Folder::new();
    let path = folder.usda(
        "root.usda",
        &format!(
            r#"
def Xform "Reference" (references = @./nowhere.usd@) {{ }}
def Xform "Payload" (payload = @./nowhere.usda@</P>) {{ }}
def Xform "Loop" (references = </Loop/Inside>) {{ def Xform "Inside" (references = </Loop>) {{ }} }}
def Mesh "There" {{ {TRIANGLE} rel material:binding = </Nothing> }}
def DomeLight "Sky" {{ asset inputs:texture:file = @no.hdr@ }}
def Camera "Camera" {{ }}
"#
        ),
    );
    let read = open(&path);
    assert_eq!(paths(&read), ["/There"]);
    assert_eq!(read.cameras.len(), 1);
    let codes = codes(&read);
    for wanted in [
        ("composition", "/Reference"),
        ("composition", "/Payload"),
        ("missing-material", "/There"),
        ("missing-texture", "/Sky"),
    ] {
        assert!(codes.contains(&wanted), "{wanted:?} in {codes:?}");
    }
    assert_eq!(
        read.scene.lights.len(),
        1,
        "a dome light without its image is kept"
    );
}

#[test]
fn broken_meshes_are_reported_and_skipped() {
    let folder = Folder::new();
    let path = folder.usda(
        "root.usda",
        &format!(
            r#"
def Mesh "None" {{ }}
def Mesh "Counts" {{ int[] faceVertexCounts = [3, 3] int[] faceVertexIndices = [0, 1, 2] point3f[] points = [(0,0,0),(1,0,0),(0,1,0)] }}
def Mesh "Index" {{ int[] faceVertexCounts = [3] int[] faceVertexIndices = [0, 1, 7] point3f[] points = [(0,0,0),(1,0,0),(0,1,0)] }}
def Mesh "Wrong" {{ string faceVertexCounts = "3" float points = 2 }}
def Mesh "Values" {{ {TRIANGLE} color3f[] primvars:displayColor = [(1,0,0), (0,1,0)] (interpolation = "vertex") }}
def Mesh "Infinite" {{ {TRIANGLE} double3 xformOp:translate = (inf, 0, 0) uniform token[] xformOpOrder = ["xformOp:translate"] }}
def Sphere "Nan" {{ double radius = nan }}
def Mesh "Good" {{ {TRIANGLE} }}
"#
        ),
    );
    let read = open(&path);
    let paths = paths(&read);
    assert!(
        paths.contains(&"/Good") && paths.contains(&"/Values"),
        "{paths:?}"
    );
    for gone in ["/None", "/Index", "/Wrong", "/Infinite", "/Nan"] {
        assert!(!paths.contains(&gone), "{gone}");
    }
    let codes = codes(&read);
    for reported in ["/Counts", "/Index", "/Values", "/Infinite", "/Nan"] {
        assert!(
            codes.iter().any(|(_, place)| *place == reported),
            "{reported} in {codes:?}"
        );
    }
}

#[test]
fn point_instancer_inside_itself_terminates() {
    let folder = Folder::new();
    let path = folder.usda(
        "root.usda",
        &format!(
            r#"
def PointInstancer "Outer" {{
    rel prototypes = </Outer/Proto>
    int[] protoIndices = [0, 0, 5]
    point3f[] positions = [(0,0,0), (1,0,0), (2,0,0)]
    float3[] scales = [(1,1,1)]
    def Xform "Proto" {{
        def Mesh "M" {{ {TRIANGLE} }}
        def PointInstancer "Again" {{
            rel prototypes = </Outer>
            int[] protoIndices = [0]
            point3f[] positions = [(0,0,0)]
        }}
    }}
}}
"#
        ),
    );
    let read = open(&path);
    assert_eq!(paths(&read), ["/Outer[0]/Proto/M", "/Outer[1]/Proto/M"]);
    assert_eq!(read.scene.meshes.len(), 1);
    let reported: Vec<_> = codes(&read)
        .into_iter()
        .filter(|(code, _)| *code == "point-instancer")
        .collect();
    assert!(reported.len() >= 3, "{reported:?}");
}

const MATERIALS: &str = r#"
def Material "Painted" {
    token outputs:surface.connect = </Painted/S.outputs:surface>
    def Shader "S" {
        uniform token info:id = "UsdPreviewSurface"
        color3f inputs:diffuseColor.connect = </Painted/Image.outputs:rgb>
        float inputs:roughness = 0.25
        float inputs:metallic = 1
        color3f inputs:emissiveColor = (1, 2, 3)
        token outputs:surface
    }
    def Shader "Image" {
        uniform token info:id = "UsdUVTexture"
        asset inputs:file = @./tex/a.png@
        token inputs:wrapS = "black"
        float4 inputs:fallback = (0.5, 0.25, 0.125, 1)
        float3 outputs:rgb
    }
}
"#;

fn textured(body: &str) -> String {
    format!(
        "{MATERIALS}\ndef Mesh \"M\" {{ {TRIANGLE} {body} rel material:binding = </Painted> texCoord2f[] primvars:st = [(0,0),(1,0),(0,1)] (interpolation = \"vertex\") }}"
    )
}

#[test]
fn missing_texture_uses_its_fallback() {
    let folder = Folder::new();
    let path = folder.usda("root.usda", &textured(""));
    let read = open(&path);
    assert_eq!(codes(&read), [("missing-texture", "/Painted")]);
    let material = &read.scene.materials[0];
    assert_eq!(material.base_color, Some([0.5, 0.25, 0.125]));
    assert_eq!(material.base_color_texture, None);
    assert_eq!((material.roughness, material.metallic), (0.25, 1.0));
    assert_eq!(material.emissive, [1.0, 2.0, 3.0]);

    let image = folder.write("tex/a.png", b"not decoded here");
    let read = open(&path);
    assert!(read.findings.is_empty());
    let used = read.scene.materials[0].base_color_texture.unwrap();
    assert_eq!((used.wrap_s, used.wrap_t), (Wrap::Black, Wrap::Repeat));
    let texture = &read.scene.textures[used.texture as usize];
    assert_eq!(texture.source, TextureSource::File(image.canonicalize().unwrap()));
    assert_eq!(texture.color_space, ColorSpace::Auto);
    assert!(read.scene.meshes[0].uvs.is_some());
}

#[test]
fn uses_the_first_udim_tile() {
    let folder = Folder::new();
    let path = folder.usda("root.usda", &textured("").replace("a.png", "a.<UDIM>.png"));
    let first = folder.write("tex/a.1001.png", b"");
    let read = open(&path);
    assert_eq!(codes(&read), [("udim-texture", "/Painted")]);
    assert_eq!(
        read.scene.textures[0].source,
        TextureSource::File(first.canonicalize().unwrap())
    );
}

#[test]
fn reads_textures_from_packages() {
    let folder = Folder::new();
    let layer = format!("#usda 1.0\n{}", textured(""));
    let package = |image: &str| {
        let files = [("root.usda", layer.as_bytes()), (image, b"an image".as_slice())];
        usdz::pack(&files).unwrap()
    };
    let path = folder.write("good.usdz", package("tex/a.png"));
    let read = open(&path);
    assert!(read.findings.is_empty(), "{:?}", read.findings);
    let TextureSource::Encoded { name, bytes } = &read.scene.textures[0].source else {
        panic!("{:?}", read.scene.textures);
    };
    assert!(name.ends_with("good.usdz[tex/a.png]"), "{name}");
    assert_eq!(&bytes[..], b"an image");

    let path = folder.write("other.usdz", package("tex/b.png"));
    assert_eq!(codes(&open(&path)), [("missing-texture", "/Painted")]);

    // A size in the directory that exceeds the file.
    let mut lying = package("tex/a.png");
    let entry = lying.windows(4).rposition(|w| w == b"PK\x01\x02").unwrap();
    for at in [entry + 20, entry + 24] {
        lying[at..at + 4].copy_from_slice(&u32::MAX.to_le_bytes());
    }
    let path = folder.write("lying.usdz", lying);
    assert!(open_scene(&path, &SceneOptions::default()).is_err());
}

#[test]
fn reads_referenced_materialx() {
    let folder = Folder::new();
    folder.write(
        "look/wood.mtlx",
        r#"<?xml version="1.0"?><materialx version="1.38">
  <nodegraph name="G"><image name="i" type="color3"><input name="file" type="filename" value="w.png" colorspace="srgb_texture"/></image>
    <output name="o" type="color3" nodename="i"/></nodegraph>
  <standard_surface name="S" type="surfaceshader"><input name="base_color" type="color3" nodegraph="G" output="o"/>
    <input name="base" type="float" value="0.5"/><input name="specular_roughness" type="float" value="0.75"/></standard_surface>
  <surfacematerial name="Wood" type="material"><input name="surfaceshader" type="surfaceshader" nodename="S"/></surfacematerial>
</materialx>"#,
    );
    let image = folder.write("look/w.png", b"");
    let body = format!(
        r#"
def Scope "Looks" (references = @./look/wood.mtlx@</MaterialX/Materials>) {{ }}
def Mesh "M" {{ {TRIANGLE} rel material:binding = </Looks/Wood> }}
"#
    );
    let path = folder.usda("root.usda", &body);
    let read = open(&path);
    assert!(read.findings.is_empty(), "{:?}", read.findings);
    let material = &read.scene.materials[0];
    assert_eq!(material.name, "/Looks/Wood");
    assert_eq!(material.base_color, Some([0.5; 3]));
    assert_eq!(material.roughness, 0.75);
    let texture = &read.scene.textures[material.base_color_texture.unwrap().texture as usize];
    assert_eq!(texture.source, TextureSource::File(image.canonicalize().unwrap()));
    assert_eq!(texture.color_space, ColorSpace::Srgb);

    folder.write("look/wood.mtlx", "<materialx><broken");
    let codes_of_broken = open(&path);
    let codes = codes(&codes_of_broken);
    assert_eq!(codes[0], ("composition", "/Looks"));
    assert_eq!(codes[1].0, "missing-material");
}

#[test]
fn reads_only_the_diffuse_inputs_of_mdl() {
    let folder = Folder::new();
    let material = |name: &str, inputs: &str| {
        format!(
            r#"
def Material "{name}" {{
    token outputs:mdl:surface.connect = </{name}/S.outputs:out>
    def Shader "S" {{
        uniform token info:implementationSource = "sourceAsset"
        uniform asset info:mdl:sourceAsset = @OmniPBR.mdl@
        {inputs}
        token outputs:out
    }}
}}
def Mesh "On{name}" {{ {TRIANGLE} rel material:binding = </{name}> }}
"#
        )
    };
    let known =
        "color3f inputs:diffuse_color_constant = (0.5, 0.5, 1) color3f inputs:diffuse_tint = (1, 0.5, 0.5)";
    let body = material("Known", known) + &material("Other", "");
    let read = open(&folder.usda("root.usda", &body));
    assert_eq!(
        codes(&read),
        [
            ("unsupported-material", "/Known"),
            ("unsupported-material", "/Other")
        ]
    );
    assert_eq!(read.scene.materials[0].base_color, Some([0.5, 0.25, 0.5]));
    assert_eq!(read.scene.materials[1].base_color, Some([0.18; 3]));
}

#[test]
fn counts_excess_findings_of_a_code() {
    let folder = Folder::new();
    let curves: String = (0..50)
        .map(|i| format!("def BasisCurves \"C{i}\" {{ }}\n"))
        .collect();
    let read = open(&folder.usda("root.usda", &curves));
    assert_eq!(read.findings.len(), 21);
    assert_eq!(read.findings[20].message, "30 more of this kind");
}

#[test]
fn scenes_are_deterministic() {
    let folder = Folder::new();
    let path = folder.usda("root.usda", &textured(""));
    assert_eq!(open(&path), open(&path));
}

#[test]
fn cameras_and_products_inside_nested_instances_keep_their_attributes() {
    let folder = Folder::new();
    folder.usda(
        "sensor.usda",
        r#"def Xform "Sensor"
{
    def Camera "Cam"
    {
        float focalLength = 10
        float focalLength.timeSamples = { 0: 10, 10: 20 }
    }
    def RenderProduct "Product"
    {
        rel camera = </Sensor/Cam>
        int2 resolution = (640, 400)
    }
}
"#,
    );
    folder.usda(
        "robot.usda",
        "def Xform \"Robot\"\n{\n def \"Head\" (instanceable = true references = @sensor.usda@</Sensor>)\n {\n }\n}\n",
    );
    let path = folder.usda(
        "stage.usda",
        "def \"A\" (instanceable = true references = @robot.usda@</Robot>)\n{\n}\n\
         def \"B\" (instanceable = true references = @robot.usda@</Robot>)\n{\n}\n",
    );
    let options = SceneOptions {
        time: Some(5.0),
        ..SceneOptions::default()
    };
    for (read, focal_length) in [(open(&path), 10.0), (open_scene(&path, &options).unwrap(), 15.0)] {
        for (at, root) in ["/A", "/B"].iter().enumerate() {
            let (camera, product) = (&read.cameras[at], &read.products[at]);
            assert_eq!(camera.prim.path, format!("{root}/Head/Cam"));
            assert!((camera.focal_length() - focal_length).abs() < 1e-6);
            assert_eq!(product.prim.path, format!("{root}/Head/Product"));
            assert_eq!(product.resolution().map(|size| size.width), Some(640));
            assert_eq!(product.cameras[0].path, format!("{root}/Head/Cam"));
            assert_eq!(product.cameras[0].type_name.as_deref(), Some("Camera"));
        }
    }
}

#[test]
fn an_animated_stage_says_at_which_time_it_was_read() {
    let folder = Folder::new();
    let head = "#usda 1.0\n(\n metersPerUnit = 1\n startTimeCode = 2\n endTimeCode = 9\n)\n";
    let cube = "def Cube \"C\"\n{\n double size.timeSamples = { 2: 1 }\n}\n";
    let path = folder.write("stage.usda", format!("{head}{cube}"));
    let read = open(&path);
    assert_eq!(codes(&read), [("time", "stage")]);
    assert!(read.findings[0].message.to_string().contains("from 2 to 9"));
    let at = SceneOptions {
        time: Some(3.0),
        ..SceneOptions::default()
    };
    assert_eq!(codes(&open_scene(&path, &at).unwrap()), []);
}

#[test]
fn a_spline_is_reported() {
    let folder = Folder::new();
    let cube = "def Cube \"C\"\n{\n double size = 2\n double size.spline = {\n 1: 2; post held,\n }\n}\n";
    let path = folder.usda("stage.usda", cube);
    let at = SceneOptions {
        time: Some(3.0),
        ..SceneOptions::default()
    };
    assert_eq!(codes(&open_scene(&path, &at).unwrap()), [("spline", "/C.size")]);
}
