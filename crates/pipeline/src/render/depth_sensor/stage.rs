//! The depth sensor of a stage, from its attributes.

use super::DepthSensorError;
use crate::sensor::{self, ParameterError, Sensor, SensorOptions};
use oaktwin_base::diagnostic::{Finding, Level, nearest};
use oaktwin_depth::single_view::Parameters;
use oaktwin_usd::asset::IsaacVersion;
use oaktwin_usd::depth_sensor::{OUTLIER_REMOVAL, StageDepthSensor, attribute_types};
use oaktwin_usd::stage::{Attribute, AttributeValue};

/// The schema's attributes that affect the sensor's output, all but its switches, with their types.
fn shaping() -> impl Iterator<Item = (&'static str, &'static str)> {
    let shapes = attribute_types()
        .into_iter()
        .filter(|(_, type_name)| *type_name != "bool");
    shapes.map(|(name, type_name)| match name {
        OUTLIER_REMOVAL => (name, "int (Isaac Sim 5.1) or bool (6)"),
        _ => (name, type_name),
    })
}

/// The names of [`shaping`] attributes.
fn shaping_names() -> impl Iterator<Item = &'static str> {
    shaping().map(|(name, _)| name)
}

/// The sensor of a stage, with `name` as its noise key.
pub(super) fn sensor(
    stage: &StageDepthSensor,
    name: &str,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), DepthSensorError> {
    let (parameters, mut findings) = parameters(stage, options.isaac)?;
    let (sensor, more) =
        sensor::of_render_product(name, parameters, options).map_err(|error| at(stage, error))?;
    findings.extend(more);
    Ok((sensor, findings))
}

fn at(stage: &StageDepthSensor, error: ParameterError) -> DepthSensorError {
    DepthSensorError {
        place: stage.prim().path.clone(),
        error,
    }
}

/// The parameters of the stage, with the schema's defaults for attributes that are not authored.
fn parameters(
    stage: &StageDepthSensor,
    isaac: Option<IsaacVersion>,
) -> Result<(Parameters, Vec<Finding>), DepthSensorError> {
    let isaac = isaac.or_else(|| stage.isaac()).unwrap_or_default();
    let mut parameters = match isaac {
        IsaacVersion::V5_1 => Parameters::isaac_5_1(),
        IsaacVersion::V6 => Parameters::isaac_6(),
    };
    let mut findings = Vec::new();
    let mut authored = Vec::new();
    for (name, attribute) in stage.attributes() {
        let Some((name, types)) = shaping().find(|(known, _)| *known == name) else {
            findings.extend(unknown(stage, name));
            continue;
        };
        // Declared without a value, or blocked.
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
                "not authored, using the defaults of Isaac Sim {isaac}: {}",
                missing.join(", ")
            ),
            "",
        ));
    }
    Ok((parameters, findings))
}

/// The shortest text of a value: single precision in as few digits as identify it, so that 0.1 is 0.1. `None` for an
/// unsupported type.
fn text(name: &str, value: &AttributeValue, attribute: &Attribute) -> Option<String> {
    match (name, value) {
        (OUTLIER_REMOVAL, AttributeValue::Bool(on)) => Some(u8::from(*on).to_string()),
        (OUTLIER_REMOVAL | "rgbDepthOutputMode", AttributeValue::Int(int)) => Some(int.to_string()),
        (OUTLIER_REMOVAL | "rgbDepthOutputMode", _) => None,
        (_, AttributeValue::Int(int)) => Some(int.to_string()),
        #[expect(clippy::cast_possible_truncation, reason = "it was a float")]
        (_, AttributeValue::Float(float)) if attribute.type_name == "float" => {
            Some((*float as f32).to_string())
        }
        (_, AttributeValue::Float(float)) => Some(float.to_string()),
        _ => None,
    }
}

/// A finding about an unknown attribute. The schema's switches are ignored: requesting the output enables the sensor.
fn unknown(stage: &StageDepthSensor, name: &str) -> Option<Finding> {
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
        format!("unknown attribute {}, ignored", stage.full_name(name)),
        remedy,
    ))
}

fn animated(stage: &StageDepthSensor, name: &str, text: &str) -> Finding {
    Finding::new(
        "depth-attribute-animated",
        Level::Warning,
        &stage.prim().path,
        format!(
            "{} has time samples; using {text} for all frames",
            stage.full_name(name)
        ),
        "author one value",
    )
}
