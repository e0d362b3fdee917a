use oaktwin_scene::import::{self, ImportOptions};
use oaktwin_scene::{MetersPerUnit, Up};

use crate::support::{Files, error};

const TRIANGLE: &str = "v 0 0 0\nv 10 0 0\nv 0 20 0\nf 1 2 3\n";

#[test]
fn units_become_metres_and_axes_stay() {
    let files = Files::new().with("a.obj", TRIANGLE);
    let open = |up, scale| {
        import::open(
            &files.path("a.obj"),
            &ImportOptions {
                up,
                scale,
                ..ImportOptions::default()
            },
        )
        .unwrap()
    };
    let plain = open(None, 1.0).scene;
    assert_eq!((plain.up, plain.meters_per_unit), (Up::Y, MetersPerUnit(1.0)));
    let scaled = open(Some(Up::Z), 0.001).scene;
    assert_eq!((scaled.up, scaled.meters_per_unit), (Up::Z, MetersPerUnit(0.001)));
    let bounds = scaled.bounds().unwrap();
    assert!((bounds.max - oaktwin_camera::math::DVec3::new(0.01, 0.02, 0.0)).length() < 1e-15);
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = import::open(
            &files.path("a.obj"),
            &ImportOptions {
                scale,
                ..ImportOptions::default()
            },
        )
        .unwrap_err();
        assert_eq!(error.remedy, "use a finite scale above zero");
    }
}

#[test]
fn extensions_determine_the_format() {
    assert_eq!(
        error("a.fbx", "x"),
        "a.fbx: .fbx files are not supported; use a file that ends in .dae, .glb, .gltf, .obj, .ply or .stl"
    );
    assert_eq!(
        error("mesh", "x"),
        "mesh: the name has no extension; use a file that ends in .dae, .glb, .gltf, .obj, .ply or .stl"
    );
    assert_eq!(error("a.obj", ""), "a.obj: is empty; export it again");
    let files = Files::new().with("a.OBJ", TRIANGLE).with("folder.stl/a", "");
    files.open("a.OBJ");
    assert_eq!(
        files.error("folder.stl"),
        "folder.stl: cannot be read: is a directory; check its name and permissions"
    );
    assert!(files.error("none.ply").starts_with("none.ply: cannot be read: "));
    assert!(import::is_importable("a.GLB".as_ref()) && !import::is_importable("a.usda".as_ref()));
}
