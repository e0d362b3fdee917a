//! Small stages that compose more than fits in memory.

use crate::program::{EXAMPLE, Program};

const RENDER: [&str; 8] = ["--model", "oak4-d", "--look-at", "-2", "0", "1", "0", "0"];

/// Each of 40 pairs of prims inherits both prims of the pair before.
fn stage() -> String {
    let mut text = "#usda 1.0\nclass \"A0\" { def Cube \"c\" {} }\nclass \"B0\" {}\n".to_owned();
    for at in 1..=40 {
        for name in ["A", "B"] {
            let to = at - 1;
            text += &format!("class \"{name}{at}\" (inherits = [</A{to}>, </B{to}>]) {{}}\n");
        }
    }
    text
}

#[test]
fn commands_report_the_prim_and_the_option() {
    let program = Program::new();
    program.put("stage.usda", stage());
    let render = [&["render", "stage.usda"], &RENDER[..], &["0", "-o", "out"]].concat();
    let asset = [
        "asset",
        "oak-d-pro-poe",
        "--calibration",
        EXAMPLE,
        "--over",
        "stage.usda",
        "-o",
        "out.usda",
    ];
    for command in [vec!["check", "stage.usda"], render, asset.to_vec()] {
        assert_eq!(
            program.refused(&command),
            "error: stage.usda: /A40: its references, inherits, specializes and variants multiply beyond the limit of \
            251328 sites; remove repeated references and instancers, or raise --scene-limit from 1\n"
        );
        let raised = [&command[..], &["--scene-limit", "2"]].concat();
        assert!(
            program
                .refused(&raised)
                .ends_with("or raise --scene-limit from 2\n")
        );
        let invalid = [&command[..], &["--scene-limit", "0"]].concat();
        let ended = program.run(&invalid);
        assert_eq!(ended.code, 2);
        assert!(
            ended.stderr.contains("must be a finite number > 0"),
            "{}",
            ended.stderr
        );
    }
}
