use std::path::Path;
use std::sync::LazyLock;

use oaktwin_base::diagnostic::{fold_name, nearest};
use serde::Serialize;

use crate::document::Document;
use crate::{CatalogError, DepthKind, Device, InertialPart, Sensor, Source, UnknownModel, builtin, check};

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
        let makers: Vec<String> = self.makers().into_iter().map(str::to_owned).collect();
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

    /// Returns the devices: the sheet's in its order, the others by manufacturer, then user-defined ones by file name.
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

    /// Returns the devices of the parameter sheet in its order.
    pub fn sheet(&self) -> impl Iterator<Item = &Device> {
        self.devices
            .iter()
            .filter(|device| device.source == Source::Document)
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
    /// The product name of a unit may add its focus (`-AF`, `-FF`) and a custom build (`-C16`, `-C56M52`). A name that is
    /// unknown with these suffixes is the one without them.
    ///
    /// # Errors
    /// Returns an error with the nearest names if no device has this name.
    pub fn device(&self, name: &str) -> Result<&Device, UnknownModel> {
        let found =
            std::iter::successors(Some(name), |name| without_suffix(name)).find_map(|name| self.find(name));
        found.ok_or_else(|| self.unknown(name))
    }

    /// Returns the device of a unit whose calibration has these names of product and board. Without a name of the product, the
    /// board identifies the device if its name is one of [`Device::boards`], or the name of a model, as in early calibrations.
    ///
    /// # Errors
    /// Returns an error with the nearest names if the device is unknown.
    pub fn device_of_unit(&self, product: &str, board: &str) -> Result<&Device, UnknownModel> {
        if !product.is_empty() || board.is_empty() {
            return self.device(product);
        }
        let wanted = fold_name(board);
        let is_on = |device: &&Device| device.boards.iter().any(|own| fold_name(own) == wanted);
        let found = self.devices.iter().find(is_on);
        found.map_or_else(|| self.device(board), Ok)
    }

    fn find(&self, name: &str) -> Option<&Device> {
        let wanted = fold_name(name);
        let named = |device: &&Device| device.names().any(|name| fold_name(name) == wanted);
        let in_asset = |device: &&Device| fold_name(&device.prim) == wanted;
        let devices = || self.devices.iter();
        devices().find(named).or_else(|| devices().find(in_asset))
    }

    fn unknown(&self, name: &str) -> UnknownModel {
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
        }
    }

    /// Adds files to the catalog. An entry replaces an earlier one with the same id.
    pub(crate) fn with_files(mut self, files: &[SourceFile<'_>]) -> Result<Self, CatalogError> {
        let documents = files
            .iter()
            .map(|source| Document::parse(source.file, source.text, "a sensor or a device"))
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

impl Device {
    /// Returns the names of the built-in models with a depth sensor, of one kind if it is given, comma-separated: only the same
    /// manufacturer's if it has any.
    #[must_use]
    pub fn models_with_depth(&self, kind: Option<DepthKind>) -> String {
        let has = |device: &&Device| {
            let mut kinds = device.depth_sensors.iter().map(|sensor| sensor.kind);
            kinds.any(|own| kind.is_none_or(|kind| own == kind))
        };
        let all: Vec<&Device> = Catalog::builtin().devices.iter().filter(has).collect();
        let is_sibling = |device: &&&Device| device.manufacturer == self.manufacturer;
        let siblings: Vec<&str> = all
            .iter()
            .filter(is_sibling)
            .map(|device| device.name.as_str())
            .collect();
        if siblings.is_empty() {
            let all: Vec<&str> = all.iter().map(|device| device.name.as_str()).collect();
            return all.join(", ");
        }
        siblings.join(", ")
    }
}

/// Whether a file describes a device: these have cameras or a prim, sensors have neither.
fn is_device(document: &Document<'_>) -> bool {
    ["camera", "prim", "body", "depth_sensor"]
        .iter()
        .any(|key| document.has(key))
}

/// Returns a product name without its last part if that is a focus or a custom build.
fn without_suffix(name: &str) -> Option<&str> {
    let (rest, last) = name.trim_end().rsplit_once(['-', '_', ' '])?;
    let is_focus = ["AF", "FF"].iter().any(|focus| last.eq_ignore_ascii_case(focus));
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let custom = last.strip_prefix(['C', 'c']);
    let is_custom = custom.is_some_and(|numbers| numbers.splitn(2, ['M', 'm']).all(is_number));
    (is_focus || is_custom).then_some(rest)
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

    const SHEET: [&str; 5] = [
        "OAK-D Pro PoE",
        "OAK-D Pro W PoE",
        "OAK4-D",
        "OAK4-D Wide",
        "OAK-D ToF",
    ];

    #[test]
    fn builtin_catalog_is_valid() {
        let catalog = Catalog::builtin();
        let sheet: Vec<&str> = catalog.sheet().map(|d| d.name.as_str()).collect();
        let first: Vec<&str> = catalog
            .devices()
            .iter()
            .map(|d| d.name.as_str())
            .take(5)
            .collect();
        assert_eq!(sheet, first);
        assert_eq!(sheet, SHEET);
        let mut makers: Vec<&str> = catalog
            .devices()
            .iter()
            .map(|d| d.manufacturer.as_str())
            .collect();
        makers.dedup();
        assert_eq!(makers, ["Luxonis", "Microsoft", "Orbbec", "Intel", "Stereolabs"]);
    }

    #[test]
    fn gaps_are_explained() {
        for device in Catalog::builtin().devices() {
            let has_note = |topic: &str| device.notes.iter().any(|note| note.topic == topic);
            assert!(device.imu.is_some() || has_note("imu"), "{}: imu", device.id);
            assert!(
                device.accuracy.len() >= device.depth_sensors.len() || has_note("accuracy"),
                "{}: accuracy",
                device.id
            );
            assert!(
                !device.depth_sensors.is_empty() || has_note("depth"),
                "{}: depth",
                device.id
            );
        }
    }

    #[test]
    fn finds_devices_by_any_spelling() {
        let catalog = Catalog::builtin();
        for (asked, id) in [
            ("oak-d pro poe", "oak_d_pro_poe"),
            ("OAK_D_PRO", "oak_d_pro"),
            ("OAK-D Pro AF", "oak_d_pro"),
            ("OAK-D-PRO-POE-C16", "oak_d_pro_poe"),
            ("OAK-D-PRO-POE-AF-C16", "oak_d_pro_poe"),
            ("OAK-4-D-C56M52", "oak4_d"),
            ("OAK-D-LITE", "oak_d_lite"),
            ("D435i", "realsense_d435i"),
            ("OAK-D-PRO-W-POE", "oak_d_pro_w_poe"),
            ("oak4d", "oak4_d"),
            ("OAK 4 D", "oak4_d"),
            ("OAK-4-D-W", "oak4_d_wide"),
            ("OAK-D-SR-POE", "oak_d_tof"),
            ("OAK 4 CS", "oak4_cs"),
            ("OAK-4-CS-OG05B10", "oak4_cs"),
            ("OAK-1-W", "oak_1_w"),
            ("OAK-1-LITE-AF", "oak_1_lite"),
            ("oak-1 max", "oak_1_max"),
            ("OAK-D-CM4", "oak_d_cm4"),
            ("OAK Thermal", "oak_thermal"),
            ("OAK-T", "oak_thermal"),
            ("D457", "realsense_d457"),
            ("RealSense D555", "realsense_d555"),
        ] {
            assert_eq!(catalog.device(asked).unwrap().id, id, "{asked}");
        }
        let error = catalog.device("OAK-D TofF").unwrap_err();
        assert_eq!(error.nearest[0], "OAK-D ToF");
        for unknown in ["OAK-D-PRO-POE-97", "OAK-D-C", "-C16", "OAK-D-C1X"] {
            assert!(catalog.device(unknown).is_err(), "{unknown}");
        }
        let error = catalog.device("primesense").unwrap_err().to_string();
        assert_eq!(error, "unknown model 'primesense'; 'models' lists all");
    }

    #[test]
    fn units_without_a_product_name_are_found_by_their_board() {
        let catalog = Catalog::builtin();
        assert_eq!(catalog.device_of_unit("", "BW1098OBC").unwrap().id, "oak_d");
        assert_eq!(
            catalog.device_of_unit("OAK-D-S2", "DM9098").unwrap().id,
            "oak_d_s2"
        );
        assert_eq!(catalog.device_of_unit("", "OAK-D").unwrap().id, "oak_d");
        assert!(
            catalog.device_of_unit("", "DM9098").is_err(),
            "several models have it"
        );
        assert!(catalog.device_of_unit("", "").is_err());
        assert!(catalog.device_of_unit("another", "BW1098OBC").is_err());
    }
}
