use serde_json::Value;

use crate::{Device, InertialPart, Sensor};

/// Returns the JSON schema of a sensor's file.
#[must_use]
pub fn sensor_schema() -> Value {
    described(
        schemars::schema_for!(Sensor).into(),
        "An image sensor of an oaktwin catalog",
    )
}

/// Returns the JSON schema of a device's file.
#[must_use]
pub fn device_schema() -> Value {
    described(
        schemars::schema_for!(Device).into(),
        "A depth camera of an oaktwin catalog",
    )
}

/// Returns the JSON schema of an inertial part's file.
#[must_use]
pub fn inertial_part_schema() -> Value {
    described(
        schemars::schema_for!(InertialPart).into(),
        "An inertial sensor of an oaktwin catalog",
    )
}

/// Returns the names and texts of the schemas in this crate's folder `schema/`.
#[must_use]
pub fn schema_files() -> [(&'static str, String); 3] {
    [
        ("sensor.schema.json", sensor_schema()),
        ("device.schema.json", device_schema()),
        ("imu.schema.json", inertial_part_schema()),
    ]
    .map(|(name, schema)| (name, format!("{schema:#}\n")))
}

/// Returns the schema with its dialect and title first, as is customary.
fn described(schema: Value, title: &str) -> Value {
    let Value::Object(mut rest) = schema else {
        return schema;
    };
    let mut ordered = serde_json::Map::new();
    for (key, value) in [
        ("$schema", rest.remove("$schema")),
        ("title", Some(title.into())),
        ("description", rest.remove("description")),
    ] {
        rest.remove(key);
        if let Some(value) = value {
            ordered.insert(key.to_owned(), value);
        }
    }
    ordered.append(&mut rest);
    Value::Object(ordered)
}
