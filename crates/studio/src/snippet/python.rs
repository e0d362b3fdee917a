//! The current state as a script of Python.

use std::fmt::Write;

use oaktwin::camera::RigidTransform;
use oaktwin::pair::PairOptions;
use oaktwin::sensor::Scalar;

use super::images::images;
use super::{quoted, toml_value};
use crate::protocol::{ExportRequest, Failure, OakState};
use crate::scene::LoadedScene;
use crate::size::image_size;
use crate::studio::Studio;

/// Returns a script that computes the images of the state.
pub(crate) fn python(studio: &Studio, request: &ExportRequest) -> Result<String, Failure> {
    let state = &request.state;
    let scene = studio.scenes.get(&request.scene)?;
    if scene.robot.is_some() {
        let error = "robots are not available in Python; take the command";
        return Err(Failure::of("scene", error));
    }
    let device = device(studio, state)?;
    let world_from_body = matrix(&state.pose.transform()?);
    let size = image_size(request.size)?;
    let comment = |command: &String| format!("# `{command}` writes the scene.\n");
    let made_by = scene.made_by.as_ref().map(comment).unwrap_or_default();
    let (up, scale) = (scene.options.up, scene.options.scale);
    let up = up.map_or_else(String::new, |up| format!(", up={}", quoted(up.name())));
    let time = scene
        .time
        .map_or_else(String::new, |time| format!(", time={time:?}"));
    let units = time
        + &scale.map_or_else(String::new, |scale| format!(", scale={scale:?}"))
        + &up
        + &infrared(&scene);
    let frame = match state.frame {
        0 => String::new(),
        frame => format!(", frame={frame}"),
    };
    let mut out = format!(
        "{made_by}import numpy as np\nimport oaktwin\n\n{device}\nscene = oaktwin.Scene.open({}{units})\nworld_from_body = np.array({world_from_body})\n",
        quoted(&scene.argument)
    );
    let kind = quoted(state.sensor_kind());
    let engine = quoted(&state.engine);
    let seed = match state.seed {
        0 => String::new(),
        seed => format!(", seed={seed}"),
    };
    let mut light = size.map_or_else(String::new, |size| {
        format!(", size=({}, {})", size.width, size.height)
    });
    let usual = PairOptions::default();
    let projector = state.projector(studio)?;
    for (name, value, usual) in [
        ("projector", projector, usual.projector),
        ("ambient", state.ambient, usual.ambient),
    ] {
        #[expect(clippy::float_cmp, reason = "a default that nobody changed")]
        if value != usual {
            let _ = write!(light, ", {name}={value:?}");
        }
    }
    let _ = write!(
        out,
        "sensor = oaktwin.DepthSensor(device, sensor={kind}, engine={engine}{seed}{}{})\n\n\
         shot = sensor.shoot(scene, world_from_body{light}{frame})\n\
         depth = shot.depth\n",
        unit(state)?,
        options(state)?
    );
    out += &images(state, image_size(request.size)?)?;
    Ok(out)
}

/// The argument with the reflectances of a scene, with a comma in front.
fn infrared(scene: &LoadedScene) -> String {
    let all = scene.options.infrared.iter();
    let all: Vec<String> = all
        .map(|(name, value)| format!("{}: {value:?}", quoted(name)))
        .collect();
    match all.is_empty() {
        true => String::new(),
        false => format!(", infrared={{{}}}", all.join(", ")),
    }
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

/// The arguments that describe the mode of the sensor, each with a comma in front.
fn options(state: &OakState) -> Result<String, Failure> {
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
    let parameters = state.options()?.parameters;
    let pairs: Vec<String> = parameters
        .iter()
        .map(|(name, value)| format!("{}: {}", quoted(name), python_value(value)))
        .collect();
    if !pairs.is_empty() {
        let _ = write!(out, ", parameters={{{}}}", pairs.join(", "));
    }
    if state.extended_disparity {
        out.push_str(", extended_disparity=True");
    }
    Ok(out)
}

fn matrix(transform: &RigidTransform) -> String {
    let row = |row: [f64; 4]| format!("[{}]", row.map(|x| format!("{x:?}")).join(", "));
    format!("[{}]", transform.rows().map(row).join(", "))
}

/// A value of Python.
fn python_value(value: &Scalar) -> String {
    match value {
        Scalar::Flag(true) => "True".to_owned(),
        Scalar::Flag(false) => "False".to_owned(),
        value => toml_value(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_values_of_python() {
        for (value, expected) in [
            ("true", "True"),
            ("0.2", "0.2"),
            ("-3", "-3"),
            ("0x1F", "\"0x1F\""),
        ] {
            assert_eq!(python_value(&Scalar::of(value)), expected);
        }
    }
}
