use oaktwin_base::diagnostic::{fold_name, suggest};
use oaktwin_catalog::{DepthKind, Role, Twin, TwinDepthSensor};
use oaktwin_depth::ParameterError;

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

/// Returns the left and the right camera of a stereo depth sensor of a prim or kind. The default is the device's first pair, or the
/// cameras with the roles `left` and `right` if it has none.
///
/// # Errors
/// Returns an error if the device has no such depth sensor, or it has no pair.
pub fn stereo_cameras(twin: &Twin, name: Option<&str>) -> Result<(Role, Role), ParameterError> {
    let pairs = || twin.depth_sensors.iter().filter_map(|sensor| sensor.spec.pair());
    let Some(name) = name else {
        return Ok(pairs().next().unwrap_or((Role::Left, Role::Right)));
    };
    let sensor = depth_sensor(twin, Some(name))?;
    sensor.spec.pair().ok_or_else(|| {
        let others = twin.depth_sensors.iter();
        let stereo = others.filter(|sensor| sensor.spec.pair().is_some());
        let stereo: Vec<&str> = stereo.map(|sensor| sensor.spec.prim.as_str()).collect();
        ParameterError {
            name: "sensor".to_owned(),
            what: format!(
                "{} of {} is not a stereo pair",
                sensor.spec.prim, twin.device.name
            ),
            remedy: match stereo.is_empty() {
                true => "choose a model with a stereo pair".to_owned(),
                false => format!("choose {}", stereo.join(" or ")),
            },
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::Catalog;

    #[test]
    fn every_pair_has_a_name() {
        let catalog = Catalog::builtin();
        let twin = |model: &str| catalog.nominal(catalog.device(model).unwrap());
        let long = twin("OAK-D LR");
        for (name, expected) in [
            (None, (Role::Left, Role::Right)),
            (Some("stereo"), (Role::Left, Role::Right)),
            (Some("Camera_pseudo_depth"), (Role::Left, Role::Right)),
            (Some("camera_pseudo_depth_100mm"), (Role::Left, Role::Rgb)),
            (Some("Camera_pseudo_depth_50mm"), (Role::Rgb, Role::Right)),
        ] {
            assert_eq!(stereo_cameras(&long, name), Ok(expected), "{name:?}");
        }
        let error = stereo_cameras(&long, Some("Camera_pseudo_depth_60mm")).unwrap_err();
        assert!(error.remedy.contains("Camera_pseudo_depth_50mm"), "{error:?}");
        let error = stereo_cameras(&twin("OAK-D ToF"), Some("tof")).unwrap_err();
        assert_eq!(
            (error.what.as_str(), error.remedy.as_str()),
            (
                "Camera_pseudo_depth_tof of OAK-D ToF is not a stereo pair",
                "choose Camera_pseudo_depth_stereo"
            )
        );
    }
}
