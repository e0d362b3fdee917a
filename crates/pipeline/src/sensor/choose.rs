use oaktwin_catalog::{DepthKind, Twin, TwinDepthSensor};
use oaktwin_depth::ParameterError;
use oaktwin_diagnostic::{fold_name, suggest};

/// Returns the depth sensor of a prim or kind (`stereo`, `tof`). The default is time of flight if the device has it, else
/// the first sensor.
///
/// # Errors
/// Returns an error if the device has no such depth sensor.
pub fn depth_sensor<'a>(twin: &'a Twin, name: Option<&str>) -> Result<&'a TwinDepthSensor, ParameterError> {
    let sensors = &twin.depth_sensors;
    let found = match name.map(fold_name) {
        None => {
            let tof = sensors.iter().find(|sensor| sensor.spec.kind == DepthKind::Tof);
            tof.or(sensors.first())
        }
        Some(name) => sensors.iter().find(|sensor| {
            let own = [sensor.spec.prim.as_str(), sensor.spec.kind.as_str()];
            own.iter().any(|own| fold_name(own) == name)
        }),
    };
    found.ok_or_else(|| {
        let model = &twin.device.name;
        let (what, remedy) = match name {
            _ if sensors.is_empty() => (
                format!("{model} has no depth sensor"),
                format!("choose a model with one: {}", twin.device.models_with_depth(None)),
            ),
            name => {
                let name = name.unwrap_or_default();
                let names = sensors
                    .iter()
                    .flat_map(|sensor| [sensor.spec.kind.as_str(), sensor.spec.prim.as_str()]);
                (
                    format!("{model} has no depth sensor '{name}'"),
                    suggest(name, names),
                )
            }
        };
        ParameterError {
            name: "sensor".to_owned(),
            what,
            remedy,
        }
    })
}
