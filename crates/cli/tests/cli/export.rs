//! `export`: the files of each format, and bad inputs. What other programs make of the files is tested in `tests/oracles`.

use oaktwin::catalog::Catalog;

use crate::program::Program;

const FORMATS: [&str; 6] = ["urdf", "sdf", "drake", "mjcf", "webots", "blender"];

#[test]
fn exhaustive_formats_of_models() {
    let program = Program::new();
    for format in FORMATS {
        for device in Catalog::builtin().devices() {
            let out = program.good(&["export", &device.id, "--to", format, "-o", &device.id]);
            assert!(!out.is_empty(), "{format} {}", device.id);
        }
    }
    let text = std::fs::read_to_string(program.path("oak_d_tof/model.sdf")).unwrap();
    assert!(
        text.contains("<sensor name=\"oak_tof_depth\" type=\"rgbd_camera\">"),
        "{text}"
    );
}

#[test]
fn the_urdf_of_a_mounted_oak() {
    let program = Program::new();
    let mount = [
        "--parent", "wrist", "--mount", "back", "--xyz", "0", "0", "0.1", "--rpy", "0", "0.5", "0",
    ];
    let mut command = vec!["export", "OAK4-D", "--to", "urdf", "-o", "out"];
    command.extend(mount);
    insta::assert_snapshot!(program.good(&command));
    let text = std::fs::read_to_string(program.path("out/oak.urdf")).unwrap();
    let start = text.find("<joint name=\"oak_center_joint\"").unwrap();
    insta::assert_snapshot!(&text[start..start + 260]);
}

#[test]
fn a_calibration_finds_its_model() {
    let program = Program::new();
    program.put(
        "unit.json",
        program.good(&["calibration", "export", "OAK-D Pro PoE", "--to", "depthai"]),
    );
    let out = program.good(&["export", "unit.json", "--to", "mjcf", "-o", "out", "--json"]);
    assert!(
        out.contains("\"model\": \"OAK-D Pro PoE\"") && out.contains("oak.xml"),
        "{out}"
    );
    let twice = "export unit.json --to mjcf -o out --calibration unit.json";
    insta::assert_snapshot!(program.refused(&twice.split(' ').collect::<Vec<_>>()));
    let other = program.run(&[
        "export",
        "OAK4-D",
        "--to",
        "mjcf",
        "-o",
        "out",
        "--calibration",
        "unit.json",
    ]);
    assert!(
        other.code == 0 && other.stderr.contains("not for an OAK4-D"),
        "{}",
        other.stderr
    );
}

#[test]
fn bad_input() {
    let program = Program::new();
    program.put("file", "");
    let mut text = String::new();
    for command in [
        "export OAK4-E --to urdf -o out",
        "export OAK4-D --to urdff -o out",
        "export OAK4-D --to urdf -o out --mount bottm",
        "export OAK4-D --to urdf -o out --name 4-oak",
        "export OAK4-D --to urdf -o out --parent oak",
        "export OAK4-D --to urdf -o out --parent a<b",
        "export OAK4-D --to urdf -o out --xyz 0 nan 0",
        "export OAK4-D --to urdf -o file",
        "export file --to urdf -o out",
        "export nothing.json --to urdf -o out",
    ] {
        let ended = program.run(&command.split(' ').collect::<Vec<_>>());
        assert_eq!(
            (ended.code, ended.stdout.as_str()),
            (2, ""),
            "{command}: {}",
            ended.stderr
        );
        text += &format!("$ {command}\n{}\n", ended.stderr);
    }
    insta::assert_snapshot!(text);
    assert!(!program.path("out").exists());
}
