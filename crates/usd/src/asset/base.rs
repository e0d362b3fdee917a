use oaktwin_catalog::Twin;

use super::{AssetError, OverrideBase, PrimNames};
use crate::stage::Stage;
use crate::text::UpAxis;

impl<'a> OverrideBase<'a> {
    /// What a layer of overrides must know of an asset, read from the asset itself: `stage` is it, `asset` its path as
    /// the layer is to say it.
    ///
    /// # Errors
    /// It has none of the twin's cameras, or not two prims deep as the sheet has them.
    pub fn of(stage: &'a Stage, asset: &'a str, twin: &Twin) -> Result<Self, AssetError> {
        let not_found = |what: String| AssetError::NoBase {
            asset: stage.file.clone(),
            model: twin.device.name.clone(),
            what,
        };
        for names in [PrimNames::Document, PrimNames::Isaac] {
            let wanted: Vec<&str> = twin
                .depth_sensors
                .iter()
                .map(|sensor| names.of(&sensor.spec.prim))
                .collect();
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
        let wanted: Vec<&str> = twin
            .depth_sensors
            .iter()
            .map(|sensor| sensor.spec.prim.as_str())
            .collect();
        Err(not_found(format!("no camera prim {}", wanted.join(" and "))))
    }
}
