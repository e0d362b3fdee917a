//! A stage's depth sensor: from its attributes to a sensor.

use super::DepthSensorError;
use crate::sensor::{self, ParameterError, Sensor, SensorOptions};
use oaktwin_depth::single_view::Parameters;
use oaktwin_diagnostic::{Finding, Level, nearest};
use oaktwin_usd::asset::IsaacVersion;
use oaktwin_usd::depth_sensor::{DepthSensor, OUTLIER_REMOVAL, attribute_types};
use oaktwin_usd::stage::{Attribute, Value};

/// The schema's attributes that shape what the sensor reports, all but its switches, with the types they may have.
fn shaping() -> impl Iterator<Item = (&'static str, &'static str)> {
    let shapes = attribute_types()
        .into_iter()
        .filter(|(_, type_name)| *type_name != "bool");
    shapes.map(|(name, type_name)| match name {
        OUTLIER_REMOVAL => (name, "int (Isaac Sim 5.1) or bool (6)"),
        _ => (name, type_name),
    })
}

/// The names of these.
fn shaping_names() -> impl Iterator<Item = &'static str> {
    shaping().map(|(name, _)| name)
}

/// The sensor that a stage describes, its noise keyed by `name`.
pub(super) fn sensor(
    stage: &DepthSensor,
    name: &str,
    options: &SensorOptions,
    isaac: Option<IsaacVersion>,
) -> Result<(Sensor, Vec<Finding>), DepthSensorError> {
    let (parameters, mut findings) = parameters(stage, isaac)?;
    let (sensor, more) =
        sensor::of_render_product(name, parameters, options).map_err(|error| at(stage, error))?;
    findings.extend(more);
    Ok((sensor, findings))
}

fn at(stage: &DepthSensor, error: ParameterError) -> DepthSensorError {
    DepthSensorError {
        place: stage.prim().path.clone(),
        error,
    }
}

/// What the stage says, and the schema's defaults for what it does not.
fn parameters(
    stage: &DepthSensor,
    isaac: Option<IsaacVersion>,
) -> Result<(Parameters, Vec<Finding>), DepthSensorError> {
    let isaac = isaac.or_else(|| stage.isaac()).unwrap_or_default();
    let (defaults, isaac_name) = match isaac {
        IsaacVersion::V5_1 => (Parameters::isaac_5_1(), "5.1"),
        IsaacVersion::V6 => (Parameters::isaac_6(), "6"),
    };
    let mut parameters = defaults;
    let mut findings = Vec::new();
    let mut authored = Vec::new();
    for (name, attribute) in stage.attributes() {
        let Some((name, types)) = shaping().find(|(known, _)| *known == name) else {
            findings.extend(unknown(stage, name));
            continue;
        };
        // Declared, or blocked.
        let Some(value) = &attribute.value else { continue };
        let wrong = |what: String, remedy: String| {
            let name = stage.full_name(name);
            at(stage, ParameterError { name, what, remedy })
        };
        let text = text(name, value, attribute).ok_or_else(|| {
            wrong(
                format!("is of type {}", attribute.type_name),
                format!("author it as {types}"),
            )
        })?;
        parameters
            .set(name, &text)
            .map_err(|error| wrong(error.what, error.remedy))?;
        if attribute.animated {
            findings.push(animated(stage, name, &text));
        }
        authored.push(name);
    }
    let missing: Vec<&str> = shaping_names()
        .filter(|name| !authored.contains(name) && *name != "rgbDepthOutputMode")
        .collect();
    if !missing.is_empty() {
        findings.push(Finding::new(
            "depth-sensor-default",
            Level::Note,
            &stage.prim().path,
            format!(
                "not authored, so the default of Isaac Sim {isaac_name}: {}",
                missing.join(", ")
            ),
            "",
        ));
    }
    Ok((parameters, findings))
}

/// As a person would have typed it: single precision in as few digits as tell it apart, so that 0.1 is 0.1. `None` for
/// another type than the attribute may have.
fn text(name: &str, value: &Value, attribute: &Attribute) -> Option<String> {
    match (name, value) {
        (OUTLIER_REMOVAL, Value::Bool(on)) => Some(u8::from(*on).to_string()),
        (OUTLIER_REMOVAL | "rgbDepthOutputMode", Value::Int(int)) => Some(int.to_string()),
        (OUTLIER_REMOVAL | "rgbDepthOutputMode", _) => None,
        (_, Value::Int(int)) => Some(int.to_string()),
        #[expect(clippy::cast_possible_truncation, reason = "it was one")]
        (_, Value::Float(float)) if attribute.type_name == "float" => Some((*float as f32).to_string()),
        (_, Value::Float(float)) => Some(float.to_string()),
        _ => None,
    }
}

/// A finding, but for the schema's switches: whoever asks for the sensor's output has switched it on.
fn unknown(stage: &DepthSensor, name: &str) -> Option<Finding> {
    if Parameters::names().contains(&name) {
        return None;
    }
    let remedy = match nearest(name, shaping_names()).first() {
        Some(near) => format!("write {near}, or remove it"),
        None => "remove it".to_owned(),
    };
    Some(Finding::new(
        "depth-attribute-unknown",
        Level::Warning,
        &stage.prim().path,
        format!(
            "{} is no attribute that is known, and has no effect",
            stage.full_name(name)
        ),
        remedy,
    ))
}

fn animated(stage: &DepthSensor, name: &str, text: &str) -> Finding {
    Finding::new(
        "depth-attribute-animated",
        Level::Warning,
        &stage.prim().path,
        format!(
            "{} has time samples: {text} holds for all frames",
            stage.full_name(name)
        ),
        "author one value",
    )
}
