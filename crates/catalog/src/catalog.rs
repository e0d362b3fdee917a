use std::path::Path;
use std::sync::LazyLock;

use oaktwin_diagnostic::{fold_name, nearest};
use serde::Serialize;

use crate::document::Document;
use crate::{CatalogError, Device, InertialPart, Sensor, UnknownModel, builtin, check};

/// A collection of sensors, inertial parts and devices.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Catalog {
    sensors: Vec<Sensor>,
    inertial_parts: Vec<InertialPart>,
    devices: Vec<Device>,
}

/// The name and text of a catalog file.
pub(crate) struct SourceFile<'a> {
    pub(crate) file: &'a Path,
    pub(crate) text: &'a str,
}

impl Catalog {
    /// Returns the models and sensors of this crate.
    #[must_use]
    pub fn builtin() -> &'static Self {
        static BUILTIN: LazyLock<Catalog> = LazyLock::new(|| {
            let files: Vec<SourceFile<'_>> = builtin::FILES
                .iter()
                .map(|(file, text)| SourceFile {
                    file: Path::new(file),
                    text,
                })
                .collect();
            #[expect(
                clippy::expect_used,
                reason = "the files are part of the program, and a test loads them"
            )]
            let mut catalog = Catalog::empty()
                .with_files(&files)
                .expect("the built-in catalog is valid");
            catalog.group_by_maker();
            catalog
        });
        &BUILTIN
    }

    /// Sorts the devices by manufacturer, in the order in which these occur.
    fn group_by_maker(&mut self) {
        let mut makers: Vec<String> = Vec::new();
        for device in &self.devices {
            if !makers.contains(&device.manufacturer) {
                makers.push(device.manufacturer.clone());
            }
        }
        let place = |device: &Device| makers.iter().position(|maker| *maker == device.manufacturer);
        self.devices.sort_by_key(place);
    }

    const fn empty() -> Self {
        Self {
            sensors: Vec::new(),
            inertial_parts: Vec::new(),
            devices: Vec::new(),
        }
    }

    /// Returns the devices: those of the sheet in its order, the others by manufacturer, then user-defined ones by file name.
    #[must_use]
    pub fn devices(&self) -> &[Device] {
        &self.devices
    }

    /// Returns the sensors.
    #[must_use]
    pub fn sensors(&self) -> &[Sensor] {
        &self.sensors
    }

    /// Returns the sensor with an id.
    #[must_use]
    pub fn sensor(&self, id: &str) -> Option<&Sensor> {
        let id = fold_name(id);
        self.sensors.iter().find(|sensor| fold_name(&sensor.id) == id)
    }

    /// Returns the inertial parts.
    #[must_use]
    pub fn inertial_parts(&self) -> &[InertialPart] {
        &self.inertial_parts
    }

    /// Returns the inertial part with an id.
    #[must_use]
    pub fn inertial_part(&self, id: &str) -> Option<&InertialPart> {
        let id = fold_name(id);
        self.inertial_parts.iter().find(|part| fold_name(&part.id) == id)
    }

    /// Returns the part of a device whose accelerometer and gyroscope are simulated, if a source names it.
    #[must_use]
    pub fn inertial_part_of(&self, device: &Device) -> Option<&InertialPart> {
        let mut parts = device.imu.iter().flat_map(|imu| &imu.parts);
        parts.find_map(|id| self.inertial_part(id).filter(|part| part.is_inertial()))
    }

    /// Returns the device with a name: its id, name or an alias, otherwise its prim, ignoring case, spaces, hyphens and
    /// underscores.
    ///
    /// # Errors
    /// Returns an error with the nearest names if no device has this name.
    pub fn device(&self, name: &str) -> Result<&Device, UnknownModel> {
        let wanted = fold_name(name);
        let named = |device: &&Device| device.names().any(|name| fold_name(name) == wanted);
        let in_asset = |device: &&Device| fold_name(&device.prim) == wanted;
        let devices = || self.devices.iter();
        devices()
            .find(named)
            .or_else(|| devices().find(in_asset))
            .ok_or_else(|| {
                let all = self.devices.iter().flat_map(Device::names_and_prim);
                let mut names: Vec<String> = Vec::new();
                for near in nearest(name, all) {
                    for device in &self.devices {
                        if device.names_and_prim().any(|name| name == near) && !names.contains(&device.name) {
                            names.push(device.name.clone());
                        }
                    }
                }
                UnknownModel {
                    name: name.to_owned(),
                    nearest: names,
                    known: self.devices.iter().map(|device| device.name.clone()).collect(),
                }
            })
    }

    /// Adds files to the catalog. An entry replaces an earlier one with the same id.
    pub(crate) fn with_files(mut self, files: &[SourceFile<'_>]) -> Result<Self, CatalogError> {
        let documents = files
            .iter()
            .map(|source| Document::parse(source.file, source.text))
            .collect::<Result<Vec<_>, _>>()?;
        let (devices, parts): (Vec<_>, Vec<_>) = documents.iter().partition(|d| is_device(d));
        let (parts, sensors): (Vec<_>, Vec<_>) = parts.into_iter().partition(|d| is_inertial_part(d));
        let mut new_ids: Vec<String> = Vec::new();
        for document in sensors {
            let sensor: Sensor = document.deserialize()?;
            check::sensor(document, &sensor)?;
            check::new_id(document, &sensor.id, &mut new_ids)?;
            put(&mut self.sensors, sensor, |sensor| &sensor.id);
        }
        new_ids.clear();
        for document in parts {
            let part: InertialPart = document.deserialize()?;
            check::inertial_part(document, &part)?;
            check::new_id(document, &part.id, &mut new_ids)?;
            put(&mut self.inertial_parts, part, |part| &part.id);
        }
        new_ids.clear();
        for document in devices {
            let device: Device = document.deserialize()?;
            check::device(document, &device, &self)?;
            check::new_id(document, &device.id, &mut new_ids)?;
            put(&mut self.devices, device, |device| &device.id);
        }
        Ok(self)
    }
}

/// Whether a file describes a device: these have cameras or a prim, sensors have neither.
fn is_device(document: &Document<'_>) -> bool {
    ["camera", "prim", "body", "depth_sensor"]
        .iter()
        .any(|key| document.has(key))
}

/// Whether a file that does not describe a device describes an inertial part.
fn is_inertial_part(document: &Document<'_>) -> bool {
    ["accelerometer", "gyroscope", "magnetometer"]
        .iter()
        .any(|key| document.has(key))
}

fn put<T>(entries: &mut Vec<T>, new: T, id: impl Fn(&T) -> &str) {
    let folded = fold_name(id(&new));
    match entries.iter_mut().find(|entry| fold_name(id(entry)) == folded) {
        Some(entry) => *entry = new,
        None => entries.push(new),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn builtin_catalog_is_valid() {
        let catalog = Catalog::builtin();
        let names: Vec<&str> = catalog.devices().iter().map(|d| d.name.as_str()).collect();
        assert_eq!(
            names,
            [
                "OAK-D Pro PoE",
                "OAK-D Pro W PoE",
                "OAK4-D",
                "OAK4-D Wide",
                "OAK-D ToF"
            ]
        );
        let sensors: Vec<&str> = catalog.sensors().iter().map(|s| s.id.as_str()).collect();
        assert_eq!(sensors, ["33D", "IMX378", "IMX586", "OV9282", "OV9782"]);
    }

    #[test]
    fn finds_devices_by_any_spelling() {
        let catalog = Catalog::builtin();
        for (asked, id) in [
            ("oak-d pro poe", "oak_d_pro_poe"),
            ("OAK_D_PRO", "oak_d_pro_poe"),
            ("OAK-D-PRO-W-POE", "oak_d_pro_w_poe"),
            ("oak4d", "oak4_d"),
            ("OAK 4 D", "oak4_d"),
            ("OAK-4-D-W", "oak4_d_wide"),
            ("OAK-D-SR-POE", "oak_d_tof"),
        ] {
            assert_eq!(catalog.device(asked).unwrap().id, id, "{asked}");
        }
        let error = catalog.device("OAK-D TofF").unwrap_err();
        assert_eq!(error.nearest[0], "OAK-D ToF");
        assert_eq!(
            catalog.device("kinect").unwrap_err().to_string(),
            "unknown model 'kinect'; known models: OAK-D Pro PoE, OAK-D Pro W PoE, OAK4-D, OAK4-D Wide, OAK-D ToF"
        );
    }
}
