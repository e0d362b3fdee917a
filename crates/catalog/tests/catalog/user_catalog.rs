//! Files of a user's own catalog: which ones load, and the errors of the others.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;
use std::path::Path;

use oaktwin_catalog::{Catalog, Source};
use proptest::prelude::*;
use tempfile::TempDir;

const SENSOR: &str = include_str!("../../data/sensors/ov9282.toml");
const DEVICE: &str = include_str!("../../data/devices/oak_d_pro_poe.toml");

fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let dir = TempDir::new().unwrap();
    for (name, bytes) in files {
        let path = dir.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
    dir
}

/// The error of a folder with these files, without the folder's own path.
fn error(files: &[(&str, &[u8])]) -> String {
    let dir = folder(files);
    let error = Catalog::with_dir(dir.path()).unwrap_err().to_string();
    assert!(!error.contains('\n'), "{error}");
    error
        .replace(&format!("{}/", dir.path().display()), "")
        .replace(&dir.path().display().to_string(), "DIR")
}

/// The error of the built-in Pro under another name with one replacement, and the line of that.
fn device_error(from: &str, to: &str) -> String {
    let own = own_device();
    assert_eq!(own.matches(from).count().min(1), 1, "{from} is in the file");
    let line = own[..own.find(from).unwrap()].matches('\n').count() + 1;
    let text = own.replacen(from, to, 1);
    error(&[("mine.toml", text.as_bytes())]).replace(&format!(":{line}:"), ":LINE:")
}

fn own_device() -> String {
    DEVICE
        .replace("id = \"oak_d_pro_poe\"", "id = \"mine\"")
        .replace("\"OAK-D Pro PoE\"\nfull", "\"My camera\"\nfull")
        .replace("prim = \"oak_d_pro\"", "prim = \"my_camera\"")
        .replace(
            "\"OAK-D-PRO-POE\", \"OAK-D-PRO-POE-FF\", \"OAK-D-PRO-POE-AF\"",
            "\"mycam\"",
        )
}

#[test]
fn a_users_own_device_and_sensor_load() {
    let sensor = SENSOR
        .replace("\"OV9282\"", "\"AR0234\"")
        .replace("1280, 800", "1920, 1200");
    let device = own_device()
        .replace("\"OV9282\"", "\"AR0234\"")
        .replace("source = \"document\"", "source = \"user\"");
    for (sensor_name, device_name) in [
        ("sensors/ar0234.toml", "devices/mine.toml"),
        ("zz.toml", "aa.toml"),
        ("sensors/x.toml", "mine.toml"),
    ] {
        let dir = folder(&[
            (sensor_name, sensor.as_bytes()),
            (device_name, device.as_bytes()),
            ("readme.txt", b"not a catalog file"),
        ]);
        let catalog = Catalog::with_dir(dir.path()).unwrap();
        assert_eq!(catalog.devices().len(), Catalog::builtin().devices().len() + 1);
        let mine = catalog.device("MY-CAM").unwrap();
        assert_eq!((mine.name.as_str(), mine.source), ("My camera", Source::User));
        let left = &catalog.nominal(mine).cameras[1];
        assert_eq!(left.intrinsics.size.width, 1920);
    }
}

#[test]
fn the_same_id_replaces() {
    let device = DEVICE.replace("mass_g = 184.0", "mass_g = 200.0");
    let dir = folder(&[("pro.toml", device.as_bytes())]);
    let catalog = Catalog::with_dir(dir.path()).unwrap();
    assert_eq!(catalog.devices().len(), Catalog::builtin().devices().len());
    assert_eq!(catalog.device("oak-d pro poe").unwrap().body.mass_g, 200.0);
    assert_eq!(catalog.devices()[0].id, "oak_d_pro_poe", "it keeps its place");
}

#[cfg(unix)]
#[test]
fn symlinks_are_followed() {
    let dir = folder(&[("real/mine.txt", own_device().as_bytes())]);
    std::os::unix::fs::symlink(dir.path().join("real/mine.txt"), dir.path().join("mine.toml")).unwrap();
    let link = dir.path().join("link");
    std::os::unix::fs::symlink(dir.path(), &link).unwrap();
    assert!(Catalog::with_dir(&link).unwrap().device("mycam").is_ok());
    std::os::unix::fs::symlink(Path::new("nowhere"), dir.path().join("dangling.toml")).unwrap();
    let error = Catalog::with_dir(dir.path()).unwrap_err().to_string();
    assert!(error.contains("dangling.toml: cannot be read: "), "{error}");
}

#[test]
fn wrong_keys_say_the_line_and_the_right_key() {
    assert_eq!(
        device_error("hfov_deg = 64.0", "hfov_rad = 1.117"),
        "mine.toml:LINE: unknown key 'hfov_rad'; angles are in degrees here: use 'hfov_deg'"
    );
    assert_eq!(
        device_error("stereo_baseline_mm = 75.0", "stereo_baseline_cm = 7.5"),
        "mine.toml:LINE: unknown key 'stereo_baseline_cm'; this is in millimetres here: use 'stereo_baseline_mm'"
    );
    assert_eq!(
        device_error("min_distance_m = 0.6", "min_distance = 0.6"),
        "mine.toml:LINE: unknown key 'min_distance'; this is in metres here: use 'min_distance_m'"
    );
    assert_eq!(
        device_error("mass_g = 184.0", "mass_kg = 0.184"),
        "mine.toml:LINE: unknown key 'mass_kg'; masses are in grams here: use 'mass_g'"
    );
    assert_eq!(
        device_error("socket = 1", "sockets = 1"),
        "mine.toml:LINE: unknown key 'sockets'; did you mean 'socket'?"
    );
}

/// What is replaced in a device file, by what, and the message about it.
const INVALID_VALUES: [[&str; 3]; 27] = [
    [
        "hfov_deg = 77.0",
        "hfov_deg = \"77\"",
        "wrong type: string \"77\", expected a number; see the schema for the type of the key",
    ],
    [
        "hfov_deg = 77.0",
        "hfov_deg = nan",
        "not a finite number; set a finite number",
    ],
    [
        "baseline_mm = 75.0\nfocal",
        "baseline_mm = inf\nfocal",
        "not a finite number; set a finite number",
    ],
    [
        "hfov_deg = 77.0",
        "hfov_deg = -77.0",
        "a field of view of -77 degrees; a pinhole sees less than 180 degrees",
    ],
    [
        "hfov_deg = 77.0",
        "hfov_deg = 180",
        "a field of view of 180 degrees; a pinhole sees less than 180 degrees",
    ],
    [
        "sensor = \"OV9282\"",
        "sensor = \"OV928\"",
        "unknown sensor \"OV928\"; did you mean 'OV9282'? To add a sensor, describe it in a file",
    ],
    [
        "role = \"right\"",
        "role = \"left\"",
        "a second camera with the role 'left'; give each camera its own",
    ],
    [
        "role = \"right\"",
        "role = \"rihgt\"",
        "unknown value 'rihgt'; use one of 'rgb', 'left', 'right', 'tof'",
    ],
    [
        "mass_g = 184.0",
        "mass_g = 0.0",
        "0 is not above 0; give a positive number",
    ],
    [
        "stereo_baseline_mm = 75.0",
        "stereo_baseline_mm = 7.5",
        "7.5 mm, but the left and right cameras are 75 mm apart; make the positions and the baseline agree",
    ],
    [
        "confidence_threshold = 0.8",
        "confidence_threshold = 80",
        "80 is out of range; expected a number from 0 to 1",
    ],
    [
        "clipping_range_m = [0.01, 100.0]",
        "clipping_range_m = [100.0, 0.01]",
        "a range from 100 to 0.01; give the nearer end first, both more than 0",
    ],
    [
        "rotation = [[0.0, 0.0, -1.0]",
        "rotation = [[0.0, 0.0, 1.0]",
        "not a rotation; give three orthogonal rows of length 1 with determinant +1",
    ],
    [
        "parts = [\"BNO086\"]",
        "parts = [\"BNO085\"]",
        "unknown inertial part \"BNO085\"; did you mean 'BNO086'? To add a part, describe it in a file",
    ],
    [
        "camera = \"left\"",
        "camera = \"tof\"",
        "the device has no camera with the role 'tof'; name the role of one of its cameras",
    ],
    [
        "about = \"camera.left.hfov_deg\"",
        "about = \"camera.left.hfov\"",
        "evidence about \"camera.left.hfov\", which is not in this file; name a key as in 'camera.left.hfov_deg' or 'body.mass_g'",
    ],
    [
        "sources = { aliases = \"board-file\" }",
        "sources = { alias = \"board-file\" }",
        "a source for \"alias\", which is not in this table; name a key of the table, or remove the entry",
    ],
    [
        "prim = \"Camera_left_ov9282\"",
        "prim = \"Camera left\"",
        "\"Camera left\" cannot name a prim; use letters, digits and underscores, and begin with no digit",
    ],
    [
        "prim = \"Camera_left_ov9282\"",
        "prim = \"Camera_rgb_imx378\"",
        "a second prim 'Camera_rgb_imx378'; give each prim its own name",
    ],
    [
        "socket = 1",
        "socket = 1.5",
        "wrong type: floating point `1.5`, expected a whole number; see the schema for the type of the key",
    ],
    [
        "outlier_removal_range_px = 3",
        "outlier_removal_range_px = -3",
        "wrong value: integer `-3`, expected a whole number, 0 or more; see the schema for the type of the key",
    ],
    [
        "[body]",
        "body = 3\n[other]",
        "wrong type: integer `3`, expected a table; see the schema for the type of the key",
    ],
    [
        "stereo_role = \"left\"",
        "stereo_role = \"Left\"",
        "unknown value \"Left\"; use one of 'mono', 'left', 'right'",
    ],
    [
        "name = \"My camera\"",
        "name = \"My\\ncamera\"",
        "\"My\\ncamera\" is not a name; give a name on one line",
    ],
    [
        "id = \"mine\"",
        "id = \"../mine\"",
        "\"../mine\" cannot name a prim; use letters, digits and underscores, and begin with no digit",
    ],
    [
        "prim = \"my_camera\"",
        "prim = \"oak4_d\"",
        "\"oak4_d\" already means the OAK4-D; choose another, or use the id 'oak4_d' to replace that entry",
    ],
    [
        "id = \"mine\"",
        "id = \"mine",
        "not TOML: invalid basic string, expected `\"`; correct the syntax",
    ],
];

#[test]
fn invalid_values_have_a_line_and_a_remedy() {
    for [from, to, message] in INVALID_VALUES {
        assert_eq!(
            device_error(from, to),
            format!("mine.toml:LINE: {message}"),
            "{to}"
        );
    }
    let known: Vec<&str> = Catalog::builtin()
        .sensors()
        .iter()
        .map(|s| s.id.as_str())
        .collect();
    assert_eq!(
        device_error("sensor = \"OV9282\"", "sensor = \"\""),
        format!(
            "mine.toml:LINE: unknown sensor \"\"; expected one of {}; to add another, describe it in a file",
            known.join(", ")
        )
    );
}

#[test]
fn missing_keys_name_their_table() {
    let text = own_device().replacen("hfov_deg = 77.0\n", "", 1);
    let line = own_device()
        .lines()
        .position(|line| line == "role = \"left\"")
        .unwrap();
    assert_eq!(
        error(&[("devices/mine.toml", text.as_bytes())]),
        format!(
            "devices/mine.toml:{line}: the key 'hfov_deg' is missing in the table that starts here; add 'hfov_deg = ...'"
        )
    );
    assert_eq!(
        error(&[("s.toml", b"id = \"X\"\n")]),
        "s.toml:1: the key 'kind' is missing in the table that starts here; add 'kind = ...'"
    );
}

#[test]
fn sensors_are_checked_too() {
    for (from, to, message) in [
        (
            "used_resolution = [1280, 800]",
            "used_resolution = [1280, 801]",
            "sensor.toml:6: 1280x801 is more than the array's 1280x800; give a mode that the sensor has",
        ),
        (
            "used_resolution = [1280, 800]",
            "used_resolution = [1280, 0]",
            "sensor.toml:6: a resolution of 1280x0; give [width, height] in pixels, each 1 to 65535",
        ),
        (
            "\npixel_size_um = 3.0",
            "\npixel_size_mm = 0.003",
            "sensor.toml:9: unknown key 'pixel_size_mm'; this is in micrometres here: use 'pixel_size_um'",
        ),
        (
            "\npixel_size_um = 3.0",
            "\npixel_size_um = -3.0",
            "sensor.toml:9: -3 is not above 0; give a positive number",
        ),
    ] {
        let text = SENSOR.replacen(from, to, 1);
        assert_eq!(error(&[("sensor.toml", text.as_bytes())]), message);
    }
}

#[test]
fn rejects_invalid_folders() {
    assert_eq!(
        error(&[("notes.txt", b"")]),
        "DIR: the folder contains no TOML file; add sensors and devices to it or to its subfolders 'sensors', 'imus' and 'devices'"
    );
    assert_eq!(
        error(&[("a.toml", b" \n")]),
        "a.toml: the file is empty; describe a sensor or a device in it"
    );
    assert_eq!(
        error(&[("a.toml", b"a\0b")]),
        "a.toml: the file is binary; pass a TOML file of a sensor or a device"
    );
    assert_eq!(
        error(&[("a.toml", b"id = 1\n# \xff\xfe")]),
        "a.toml:2: not UTF-8 text; save the file as UTF-8"
    );
    assert_eq!(
        error(&[("a.toml", &vec![b'#'; 1 << 20 | 1])]),
        "a.toml: larger than 1 MiB; files of sensors and devices have a few kilobytes"
    );
    assert_eq!(
        error(&[("a.toml/b.txt", b"")]),
        "a.toml: not a file; rename it to an extension other than .toml, or remove it"
    );
    assert_eq!(
        error(&[
            ("a.toml", own_device().as_bytes()),
            ("devices/b.toml", own_device().as_bytes())
        ]),
        "devices/b.toml:2: a second file describes \"mine\"; remove one of them"
    );
    let deep = format!("id = {}", "[".repeat(100_000));
    assert!(error(&[("a.toml", deep.as_bytes())]).starts_with("a.toml:1: not TOML: "));
    let missing = Catalog::with_dir("/nonexistent/folder").unwrap_err().to_string();
    assert!(
        missing.starts_with("/nonexistent/folder: cannot list the folder: "),
        "{missing}"
    );
}

#[test]
fn a_truncated_file_never_panics() {
    let own = own_device();
    for end in (0..own.len())
        .step_by(97)
        .filter(|end| own.is_char_boundary(*end))
    {
        let dir = folder(&[("a.toml", &own.as_bytes()[..end])]);
        let _ = Catalog::with_dir(dir.path());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// However a file is damaged, it loads or is refused in one line.
    #[test]
    fn damage_never_panics(at in 0..10_000usize, with in prop::collection::vec(any::<u8>(), 0..4), cut in 0..6usize) {
        let mut bytes = own_device().into_bytes();
        let at = at % bytes.len();
        let end = (at + cut).min(bytes.len());
        bytes.splice(at..end, with);
        let dir = folder(&[("a.toml", &bytes)]);
        if let Err(error) = Catalog::with_dir(dir.path()) {
            prop_assert!(!error.to_string().contains('\n'), "{error}");
        }
    }
}
