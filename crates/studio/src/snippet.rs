//! The current state as a command line, a Python script and a file of parameters, which reproduce it to the byte.

use std::fmt::Write;

use oaktwin::camera::RigidTransform;
use oaktwin::sensor::EngineInput;

use crate::oak::image_size;
use crate::protocol::{ExportRequest, Failure, OakState};
use crate::studio::Studio;

/// The folder of the calibrations of units that a command draws.
const UNITS: &str = "units";

/// Returns the changed parameters as a file for `--params`.
pub(crate) fn toml(state: &OakState) -> Result<String, Failure> {
    let engine = state.engine()?;
    let mut out = format!("engine = \"{engine}\"\n\n[parameters]\n");
    for (name, value) in &state.parameters {
        let is_plain =
            value.parse::<f64>().is_ok_and(f64::is_finite) || matches!(value.as_str(), "true" | "false");
        let value = if is_plain { value.clone() } else { quoted(value) };
        let _ = writeln!(out, "{name} = {value}");
    }
    Ok(out)
}

/// Returns a command that writes the images of the state.
pub(crate) fn command(studio: &Studio, request: &ExportRequest) -> Result<String, Failure> {
    let state = &request.state;
    let scene = studio.scenes.get(&request.scene)?;
    let mut out = String::new();
    let mut words = vec!["oaktwin".to_owned(), "render".to_owned(), shell(&scene.argument)];
    let mut option = |name: &str, value: &str| words.extend([format!("--{name}"), shell(value)]);
    option("model", &state.model);
    if let Some(id) = &state.calibration {
        option("calibration", &studio.calibrations.name(id)?);
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
    option("camera", &state.sensor);
    if let Some(size) = image_size(request.size)? {
        option("resolution", &size.to_string());
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
    if state.engine()?.input == EngineInput::Pair {
        option("projector", &state.projector.to_string());
        option("ambient", &state.ambient.to_string());
    }
    option("annotators", "rgb,distance_to_image_plane,depth_sensor_distance");
    option("output", "oak");
    if state.extended_disparity {
        words.push("--extended-disparity".to_owned());
    }
    words.push("--pose".to_owned());
    words.extend(state.pose.numbers().map(|number| format!("{number:?}")));
    let _ = writeln!(out, "{}", words.join(" "));
    Ok(out)
}

/// Returns a script that computes the images of the state.
pub(crate) fn python(studio: &Studio, request: &ExportRequest) -> Result<String, Failure> {
    let state = &request.state;
    let scene = studio.scenes.get(&request.scene)?;
    let device = device(studio, state)?;
    let world_from_body = matrix(&state.pose.transform()?);
    let size = image_size(request.size)?;
    let mut out = format!(
        "import numpy as np\nimport oaktwin\n\n{device}\nscene = oaktwin.Scene.open({})\nworld_from_body = np.array({world_from_body})\n",
        quoted(&scene.argument)
    );
    let options = options(state);
    let unit = unit(state)?;
    if state.engine()?.input == EngineInput::Pair {
        let size = size.map_or_else(String::new, |size| {
            format!("size=({}, {}), ", size.width, size.height)
        });
        let _ = write!(
            out,
            "\npair = scene.render_pair(\n    device, world_from_body, {size}projector={:?}, ambient={:?}, seed={}{unit}\n)\n\
             matcher = oaktwin.StereoMatcher(device, raw=False{options})\n\
             depth = matcher(pair[\"rectified_left\"], pair[\"rectified_right\"])[\"depth\"]\n",
            state.projector, state.ambient, state.seed
        );
        return Ok(out);
    }
    let kind = state.sensor_kind();
    let resized = size.map_or_else(String::new, |size| {
        format!(".resized({}, {})", size.width, size.height)
    });
    let mut engine = format!(", engine={}", quoted(&state.engine));
    if state.seed != 0 {
        let _ = write!(engine, ", seed={}", state.seed);
    }
    engine.push_str(&unit);
    let _ = write!(
        out,
        "camera = device.depth_camera({kind}){resized}\n\n\
         seen = scene.render(\n    camera,\n    world_from_body @ camera.body_from_camera,\n    annotators=[\"rgb\", \"distance_to_image_plane\"],\n)\n\
         sensor = oaktwin.DepthSensor(device, sensor={kind}, camera=camera{engine}{options})\n\
         depth = sensor(seen[\"distance_to_image_plane\"], seen[\"rgb\"])\n",
        kind = quoted(kind)
    );
    Ok(out)
}

fn device(studio: &Studio, state: &OakState) -> Result<String, Failure> {
    let lens = match state.lens.as_str() {
        "pinhole" => String::new(),
        lens => format!(", lens={}", quoted(lens)),
    };
    Ok(match &state.calibration {
        Some(id) => {
            let name = studio.calibrations.name(id)?;
            format!(
                "device = oaktwin.Device.from_calibration({}, {}{lens})",
                quoted(&name),
                quoted(&state.model)
            )
        }
        None => {
            let unit = state.population_seed.map_or_else(String::new, |seed| {
                format!("\ndevice = device.population(1, seed={seed})[0]")
            });
            format!("device = oaktwin.Device({}{lens}){unit}", quoted(&state.model))
        }
    })
}

/// The arguments that describe the unit, each with a comma in front.
fn unit(state: &OakState) -> Result<String, Failure> {
    let mut out = String::new();
    if let Some(seed) = state.device_seed {
        let _ = write!(out, ", device_seed={seed}");
    }
    if let Some(drift) = state.drift()? {
        let _ = write!(out, ", drift={}", quoted(&drift.to_text()));
    }
    Ok(out)
}

/// The arguments that sensors and matchers share, each with a comma in front.
fn options(state: &OakState) -> String {
    let mut out = String::new();
    if let Some(preset) = &state.preset {
        let _ = write!(out, ", preset={}", quoted(&preset.to_lowercase()));
    }
    let filters: Vec<String> = state
        .filters
        .iter()
        .flatten()
        .map(|filter| quoted(filter))
        .collect();
    if !filters.is_empty() {
        let _ = write!(out, ", filters=[{}]", filters.join(", "));
    }
    if !state.parameters.is_empty() {
        let pairs = state.parameters.iter();
        let pairs: Vec<String> = pairs
            .map(|(name, value)| format!("{}: {}", quoted(name), quoted(value)))
            .collect();
        let _ = write!(out, ", parameters={{{}}}", pairs.join(", "));
    }
    if state.extended_disparity {
        out.push_str(", extended_disparity=True");
    }
    out
}

fn matrix(transform: &RigidTransform) -> String {
    let row = |row: [f64; 4]| format!("[{}]", row.map(|x| format!("{x:?}")).join(", "));
    format!("[{}]", transform.rows().map(row).join(", "))
}

/// A string of Python, JSON and TOML.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
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

    #[test]
    fn words_are_quoted_for_the_shell() {
        assert_eq!(shell("a/b.usd"), "a/b.usd");
        assert_eq!(shell("OAK-D Pro"), "'OAK-D Pro'");
        assert_eq!(shell("it's; rm *"), "'it'\\''s; rm *'");
        assert_eq!(shell(""), "''");
    }
}
