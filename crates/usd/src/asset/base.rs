use oaktwin_catalog::Twin;

use super::{AssetError, OverrideBase, PrimNames};
use crate::stage::Stage;
use crate::text::UpAxis;

impl<'a> OverrideBase<'a> {
    /// Reads the properties of an existing asset that a layer of overrides needs. `stage` is the opened asset and
    /// `asset` the path under which the layer refers to it.
    ///
    /// # Errors
    /// Returns an error if the asset lacks the twin's depth cameras, or if they are not two prims below the root.
    pub fn of(stage: &'a Stage, asset: &'a str, twin: &Twin) -> Result<Self, AssetError> {
        let not_found = |what: String| AssetError::NoBase {
            asset: stage.file.clone(),
            model: twin.device.name.clone(),
            what,
        };
        for names in [PrimNames::Document, PrimNames::Isaac] {
            let wanted: Vec<&str> = prims(twin).into_iter().map(|prim| names.of(prim)).collect();
            let has = |name: &&str| stage.cameras.iter().any(|camera| camera.prim.name() == *name);
            if !wanted.iter().all(has) {
                continue;
            }
            let found = stage
                .cameras
                .iter()
                .find(|camera| wanted.contains(&camera.prim.name()));
            let path = found.map_or("", |camera| camera.prim.path.as_str());
            let mut parts = path.split('/').skip(1);
            let (Some(root), Some(device), Some(_), None) =
                (parts.next(), parts.next(), parts.next(), parts.next())
            else {
                return Err(not_found(format!("{path} is not two prims below the root")));
            };
            return Ok(Self {
                asset,
                names,
                root,
                device,
                meters_per_unit: stage.metadata.meters_per_unit.unwrap_or(0.01),
                up_axis: match stage.metadata.up_axis.as_deref() {
                    Some("Z") => UpAxis::Z,
                    _ => UpAxis::Y,
                },
            });
        }
        Err(not_found(format!("no camera prim {}", prims(twin).join(" and "))))
    }
}

/// Returns the prims of the depth sensors, or of the cameras if the device has none.
fn prims(twin: &Twin) -> Vec<&str> {
    let depth = twin.depth_sensors.iter().map(|sensor| sensor.spec.prim.as_str());
    if twin.depth_sensors.is_empty() {
        twin.cameras
            .iter()
            .map(|camera| camera.spec.prim.as_str())
            .collect()
    } else {
        depth.collect()
    }
}
