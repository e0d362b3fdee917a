use super::*;
use oaktwin_camera::Usd;
use oaktwin_usd::stage::{Attribute, AttributeValue, Prim, RelationshipTarget};

const DEPTH_SCHEMA: &str = "OmniSensorDepthSensorSingleViewAPI";

fn prim(path: &str, schemas: &[&str], attributes: &[(&str, AttributeValue)]) -> Prim {
    Prim {
        path: path.to_owned(),
        type_name: String::new(),
        api_schemas: schemas.iter().map(|s| (*s).to_owned()).collect(),
        attributes: attributes
            .iter()
            .map(|(name, value)| {
                let attribute = Attribute {
                    type_name: String::new(),
                    value: Some(value.clone()),
                    animated: false,
                };
                ((*name).to_owned(), attribute)
            })
            .collect(),
    }
}

fn camera(path: &str, focal: f64) -> SceneCamera {
    SceneCamera {
        prim: prim(
            path,
            &[],
            &[
                ("focalLength", AttributeValue::Float(focal)),
                ("horizontalAperture", AttributeValue::Float(20.0)),
                ("verticalAperture", AttributeValue::Float(10.0)),
                ("clippingRange", AttributeValue::Floats(vec![1.0, 100.0])),
            ],
        ),
        ..SceneCamera::default()
    }
}

fn product(path: &str, schemas: &[&str], camera: &str, size: Option<[i64; 2]>) -> RenderProduct {
    let resolution = size.map(|size| ("resolution", AttributeValue::Ints(size.to_vec())));
    RenderProduct {
        prim: prim(path, schemas, resolution.as_slice()),
        cameras: vec![RelationshipTarget {
            path: camera.to_owned(),
            type_name: Some("Camera".to_owned()),
        }],
    }
}

fn stage() -> SceneFile {
    let mut file = SceneFile {
        path: "room.usda".into(),
        cameras: vec![
            camera("/A/Camera", 10.0),
            camera("/B/Camera", 20.0),
            camera("/B/Depth", 20.0),
        ],
        products: vec![
            product("/Render/Plain", &[], "/A/Camera", Some([640, 480])),
            product(
                "/Render/Depth_product",
                &[DEPTH_SCHEMA],
                "/B/Depth",
                Some([320, 200]),
            ),
        ],
        ..SceneFile::default()
    };
    file.scene.meters_per_unit.0 = 0.01;
    file
}

fn chosen(file: &SceneFile, names: &[&str]) -> Result<Vec<PlacedCamera>, CameraError> {
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    let options = SceneCameraOptions {
        cameras: &names,
        ..SceneCameraOptions::default()
    };
    scene_cameras(file, &options).map(|(cameras, _)| cameras)
}

fn sizes(cameras: &[PlacedCamera]) -> Vec<(&str, String)> {
    cameras
        .iter()
        .map(|camera| (camera.path.as_str(), camera.camera.intrinsics.size.to_string()))
        .collect()
}

#[test]
fn depth_products_first_else_every_camera() {
    let mut file = stage();
    let cameras = chosen(&file, &[]).unwrap();
    assert_eq!(sizes(&cameras), [("/Render/Depth_product", "320x200".to_owned())]);
    assert_eq!(cameras[0].folder, "Depth_product");
    assert_eq!(cameras[0].camera.intrinsics.fx, 320.0);
    assert_eq!((cameras[0].clip.near_m, cameras[0].clip.far_m), (0.01, 1.0));
    file.products.clear();
    let cameras = chosen(&file, &[]).unwrap();
    assert_eq!(
        sizes(&cameras),
        [
            ("/A/Camera", "1280x640".to_owned()),
            ("/B/Camera", "1280x640".to_owned()),
            ("/B/Depth", "1280x640".to_owned()),
        ]
    );
    let folders: Vec<&str> = cameras.iter().map(|camera| camera.folder.as_str()).collect();
    assert_eq!(folders, ["A_Camera", "B_Camera", "Depth"]);
}

#[test]
fn a_camera_has_the_resolution_of_its_product() {
    let file = stage();
    let cameras = chosen(&file, &["/A/Camera", "depth", "/Render/Plain", "/A/Camera"]).unwrap();
    assert_eq!(
        sizes(&cameras),
        [
            ("/A/Camera", "640x480".to_owned()),
            ("/B/Depth", "320x200".to_owned()),
            ("/Render/Plain", "640x480".to_owned()),
        ]
    );
    let options = SceneCameraOptions {
        size: Some(ImageSize::new(100, 50)),
        ..SceneCameraOptions::default()
    };
    let (cameras, _) = scene_cameras(&file, &options).unwrap();
    assert_eq!(cameras[0].camera.intrinsics.fx, 100.0);
    assert_eq!(cameras[0].camera.intrinsics.principal_point::<Usd>().x, 50.0);
}

#[test]
fn rejects_unknown_and_ambiguous_names() {
    let file = stage();
    let error = |names: &[&str]| chosen(&file, names).unwrap_err().to_string();
    assert_eq!(
        error(&["Camera"]),
        "room.usda: 'Camera' is ambiguous: /A/Camera, /B/Camera; give the whole path"
    );
    assert!(error(&["/B/Dept"]).starts_with("room.usda: unknown camera '/B/Dept'; did you mean '/B/Depth'"));
    assert!(error(&["xyz"]).contains("expected one of /A/Camera, /B/Camera"));
    let empty = SceneFile {
        path: "empty.usda".into(),
        ..SceneFile::default()
    };
    for names in [&[][..], &["Camera"]] {
        let error = chosen(&empty, names).unwrap_err().to_string();
        assert!(
            error.contains("empty.usda: the scene has no camera; add an OAK"),
            "{error}"
        );
    }
}

#[test]
fn skips_invalid_cameras_unless_selected() {
    let mut file = stage();
    file.products = vec![product("/Render/Lost", &[DEPTH_SCHEMA], "/Nowhere", None)];
    file.cameras[0] = camera("/A/Camera", 0.0);
    let (cameras, findings) = scene_cameras(&file, &SceneCameraOptions::default()).unwrap();
    assert_eq!(cameras.len(), 2);
    let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["product-without-camera", "camera-left-out"]);
    let error = chosen(&file, &["/A/Camera"]).unwrap_err().to_string();
    assert!(
        error.contains("room.usda: /A/Camera: focalLength is 0"),
        "{error}"
    );
    file.cameras.truncate(1);
    assert!(chosen(&file, &[]).is_err());
}

#[test]
fn sizes_are_checked() {
    let mut file = stage();
    file.products = vec![product(
        "/Render/Huge",
        &[DEPTH_SCHEMA],
        "/A/Camera",
        Some([1 << 20, 1 << 20]),
    )];
    let error = chosen(&file, &[]).unwrap_err().to_string();
    assert!(
        error.contains("/Render/Huge: an image of 1048576x1048576 has more than 2^31"),
        "{error}"
    );
}
