//! The current state as a command line, a Python script and a file of parameters, which reproduce it to the byte.

mod along;
mod coverage;
mod images;
mod python;

use std::fmt::Write;

use oaktwin::sensor::{EngineInput, Scalar};

use crate::protocol::{ExportRequest, Failure, OakState};
use crate::robot::SceneRobot;
use crate::scene::LoadedScene;
use crate::size::image_size;
use crate::studio::Studio;
use along::{Along, along};
pub(crate) use coverage::coverage;
pub(crate) use python::python;

/// The folder of the calibrations of units that a command draws.
const UNITS: &str = "units";
/// The file of a robot's posture.
const POSTURE: &str = "posture.csv";

/// Returns the changed parameters as a file for `--params`.
pub(crate) fn toml(state: &OakState) -> Result<String, Failure> {
    let engine = state.engine()?;
    let mut out = format!("engine = \"{engine}\"\n\n[parameters]\n");
    for (name, value) in &state.parameters {
        let _ = writeln!(out, "{} = {}", key(name), toml_value(&Scalar::of(value)));
    }
    Ok(out)
}

/// A key of TOML.
fn key(name: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "_-.".contains(letter);
    match !name.is_empty() && name.split('.').all(|part| !part.is_empty()) && name.chars().all(is_plain) {
        true => name.to_owned(),
        false => quoted(name),
    }
}

/// A value of TOML: a number, a flag or a string.
fn toml_value(value: &Scalar) -> String {
    match value {
        Scalar::Number(number) => format!("{number:?}"),
        Scalar::Text(text) => quoted(text),
        value => value.to_string(),
    }
}

/// Returns the commands that write the files of a scene, and the first words of one that opens it, without its robot.
fn begun(scene: &LoadedScene, command: &str) -> (String, Vec<String>) {
    let mut out = String::new();
    if let Some(command) = &scene.made_by {
        let _ = writeln!(out, "{command}");
    }
    let mut words = ["oaktwin", command].map(str::to_owned).to_vec();
    words.push(shell(&file(&scene.argument)));
    let options = &scene.options;
    if let Some(up) = options.up {
        words.extend(["--up".to_owned(), up.name().to_owned()]);
    }
    if let Some(scale) = options.scale {
        words.extend(["--scale".to_owned(), format!("{scale:?}")]);
    }
    for (name, value) in &options.infrared {
        option(&mut words, "infrared", &format!("{name}={value:?}"));
    }
    (out, words)
}

/// Adds an option to the words of a command.
fn option(words: &mut Vec<String>, name: &str, value: &str) {
    // A value that begins like an option follows an equals sign.
    match value.starts_with('-') {
        true => words.push(shell(&format!("--{name}={value}"))),
        false => words.extend([format!("--{name}"), shell(value)]),
    }
}

/// Returns a command that writes the images of the state.
pub(crate) fn command(studio: &Studio, request: &ExportRequest) -> Result<String, Failure> {
    let state = &request.state;
    let scene = studio.scenes.get(&request.scene)?;
    let (mut out, mut words) = begun(&scene, "render");
    if let Some(robot) = &scene.robot {
        let (table, arguments) = posture(robot);
        out += &table;
        words.extend(arguments.iter().map(|word| shell(word)));
    }
    let path = along(studio, request)?;
    if let Some(time) = scene.time {
        match &path {
            None => option(&mut words, "time", &format!("{time:?}")),
            Some(path) => option(&mut words, "frames", &path.codes(request)?),
        }
    }
    let size = image_size(request.size)?.map(|size| size.to_string());
    words.extend(oak(studio, state, ("camera", &state.sensor), size, &mut out)?);
    images::arguments(state, &mut words)?;
    option(
        &mut words,
        "annotators",
        "rgb,distance_to_image_plane,depth_sensor_distance",
    );
    option(&mut words, "output", "oak");
    words.extend(pose(state, path.as_ref(), &mut out));
    let _ = writeln!(out, "{}", words.join(" "));
    Ok(out)
}

/// Returns the options that describe an OAK, whose depth sensor is named by the option `sensor`. Adds the command that writes its unit.
fn oak(
    studio: &Studio,
    state: &OakState,
    sensor: (&str, &str),
    size: Option<String>,
    out: &mut String,
) -> Result<Vec<String>, Failure> {
    let mut words = Vec::new();
    let mut option = |name: &str, value: &str| option(&mut words, name, value);
    option("model", &state.model);
    if let Some(id) = &state.calibration {
        option("calibration", &file(&studio.calibrations.name(id)?));
    }
    if let (Some(drawn), Some(seed)) = (state.drawn(studio)?, state.population_seed) {
        let model = shell(&state.model);
        let _ = writeln!(
            out,
            "oaktwin population {model} --units 1 --seed {seed} --output {UNITS}"
        );
        option("calibration", &format!("{UNITS}/{}", drawn.file_name()));
    }
    if state.lens != "pinhole" {
        option("lens", &state.lens);
    }
    option(sensor.0, sensor.1);
    if let Some(size) = size {
        option("resolution", &size);
    }
    option("engine", &state.engine);
    if let Some(preset) = &state.preset {
        option("preset", preset);
    }
    for filter in state.filters.iter().flatten() {
        option("filter", filter);
    }
    for (name, value) in &state.parameters {
        option("param", &format!("{name}={value}"));
    }
    if state.seed != 0 {
        option("seed", &state.seed.to_string());
    }
    if let Some(seed) = state.device_seed {
        option("device-seed", &seed.to_string());
    }
    if let Some(drift) = state.drift()? {
        option("drift", &drift.to_text());
    }
    let is_lit = state.lit_options(studio)?.parameters.len() > state.parameters.len();
    if state.engine()?.input == EngineInput::Pair || is_lit {
        option("projector", &state.projector.to_string());
        option("ambient", &state.ambient.to_string());
    }
    if state.extended_disparity {
        words.push("--extended-disparity".to_owned());
    }
    Ok(words)
}

/// Returns the words that place the OAK.
fn pose(state: &OakState, path: Option<&Along>, out: &mut String) -> Vec<String> {
    match path {
        Some(path) => {
            let _ = writeln!(out, "# The page shows frame {}.", state.frame);
            vec!["--trajectory".to_owned(), shell(&file(&path.0.info.name))]
        }
        None => {
            let numbers = state.pose.numbers().map(|number| format!("{number:?}"));
            std::iter::once("--pose".to_owned()).chain(numbers).collect()
        }
    }
}

/// Returns a command that writes the joint positions of a robot's posture, and the options that put the robot into the scene.
fn posture(robot: &SceneRobot) -> (String, Vec<String>) {
    let joints: Vec<usize> = robot.placed.robot().free_joints().collect();
    let has_joints = !joints.is_empty();
    let names = joints
        .iter()
        .map(|&joint| robot.placed.robot().joints[joint].name.clone());
    let positions = joints
        .iter()
        .map(|&joint| format!("{:?}", robot.positions[joint]));
    let line = |words: Vec<String>| shell(&words.join(","));
    let table = format!(
        "printf '%s\\n' {} {} > {POSTURE}\n",
        line(names.collect()),
        line(positions.collect())
    );
    let joints = ["--joints".to_owned(), POSTURE.to_owned()];
    match has_joints {
        true => (table, robot.arguments.iter().cloned().chain(joints).collect()),
        false => (String::new(), robot.arguments.clone()),
    }
}

/// The name of a file that no program takes for an option.
fn file(name: &str) -> String {
    match name.starts_with('-') {
        true => format!("./{name}"),
        false => name.to_owned(),
    }
}

/// A string of Python, JSON and TOML.
fn quoted(text: &str) -> String {
    // The only control character that JSON does not escape.
    serde_json::Value::from(text)
        .to_string()
        .replace('\u{7f}', "\\u007f")
}

/// A word of a POSIX shell.
fn shell(word: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "._-/=,:+".contains(letter);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::io::Write as _;
    use std::process::{Command, Stdio};

    /// What a file, a prim or a parameter may be called.
    const NAMES: [&str; 12] = [
        "a/b.usd",
        "OAK-D Pro",
        "it's; rm *",
        "",
        "$(touch made) `touch made` ${HOME} $HOME",
        "\"double\" and \\back\\slash\\",
        "two\nlines\r\n\tand a tab",
        "~/a !! ?* [a] {b,c} # & | < >",
        "-rf",
        "--output=/etc",
        "é ü 漢字 😀 \u{2028} \u{7f} \u{1b}[31m",
        "\"\"\" ''' \\N{BULLET} \\x41 %s {0}",
    ];

    /// Runs a program with a script on its standard input; `None` if there is no such program.
    fn said(program: &str, script: &str) -> Option<String> {
        let folder = tempfile::tempdir().unwrap();
        let mut child = Command::new(program)
            .current_dir(folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .ok()?;
        let mut input = child.stdin.take().unwrap();
        input.write_all(script.as_bytes()).unwrap();
        drop(input);
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success(), "{script}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "{script}");
        Some(String::from_utf8(output.stdout).unwrap())
    }

    #[test]
    fn words_are_quoted_for_the_shell() {
        assert_eq!(shell("a/b.usd"), "a/b.usd");
        assert_eq!(shell("OAK-D Pro"), "'OAK-D Pro'");
        assert_eq!(shell("it's; rm *"), "'it'\\''s; rm *'");
        assert_eq!(shell(""), "''");
        assert_eq!(file("-rf"), "./-rf");
    }

    #[cfg(unix)]
    #[test]
    fn a_shell_reads_every_name_as_one_word() {
        let words: Vec<String> = NAMES.iter().map(|name| shell(name)).collect();
        let script = format!("printf '<%s>' {}\n", words.join(" "));
        let expected: String = NAMES.iter().map(|name| format!("<{name}>")).collect();
        assert_eq!(said("sh", &script).unwrap(), expected);
    }

    #[test]
    fn python_reads_every_name_as_a_string() {
        let names: Vec<String> = NAMES.iter().map(|name| quoted(name)).collect();
        let script = format!("import json\nprint(json.dumps([{}]))\n", names.join(", "));
        let Some(text) = said("python3", &script) else {
            eprintln!("skipped: there is no python3");
            return;
        };
        let read: Vec<String> = serde_json::from_str(&text).unwrap();
        assert_eq!(read, NAMES);
    }

    #[test]
    fn parameters_are_valid_toml() {
        for (value, expected) in [
            ("7", "7"),
            ("-5", "-5"),
            ("0.5", "0.5"),
            ("+5", "\"+5\""),
            ("1e300", "\"1e300\""),
            ("inf", "\"inf\""),
            ("true", "true"),
            ("a\nb = 1", "\"a\\nb = 1\""),
        ] {
            let value = Scalar::of(value);
            assert_eq!(toml_value(&value), expected);
        }
        assert_eq!(key("censusTransform.threshold"), "censusTransform.threshold");
        assert_eq!(key("a = 1\n[b"), "\"a = 1\\n[b\"");
        assert_eq!((key(""), key("a..b")), ("\"\"".to_owned(), "\"a..b\"".to_owned()));
    }
}
