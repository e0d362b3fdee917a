//! Calibrations that were dropped onto the page.

use std::path::Path;

use oaktwin::calibration::{Calibration, Raw};
use oaktwin::catalog::{Catalog, Device, Twin};
use oaktwin::unit;

use crate::kept::{Keep, Kept};
use crate::protocol::{CalibrationInfo, Failure};
use crate::upload::bytes_id;

/// A calibration.
#[derive(Debug)]
pub(crate) struct Dropped {
    pub(crate) info: CalibrationInfo,
    pub(crate) bytes: Vec<u8>,
    raw: Raw,
}

pub(crate) type Calibrations = Kept<Dropped>;

impl Keep for Dropped {
    type Info = CalibrationInfo;
    const NAME: &'static str = "calibration";
    const COUNT: usize = 32;

    fn known(&self) -> (&str, &CalibrationInfo) {
        (&self.info.id, &self.info)
    }
}

impl Dropped {
    /// Reads a calibration.
    pub(crate) fn read(catalog: &Catalog, name: &str, bytes: Vec<u8>) -> Result<Self, Failure> {
        let raw = Raw::parse(&bytes, name).map_err(|error| Failure::from(error.to_string()))?;
        let read = Calibration::from_raw(&raw);
        let (calibration, findings) = read.map_err(|error| Failure::from(error.to_string()))?;
        let board = &calibration.board;
        let model = catalog.device_of_unit(&board.product_name, &board.board_name);
        let info = CalibrationInfo {
            id: format!("calibration-{}", bytes_id(name, &bytes)),
            name: name.to_owned(),
            model: model.ok().map(|device| device.name.clone()),
            findings,
        };
        Ok(Self { info, bytes, raw })
    }
}

impl Calibrations {
    /// Returns the twin of a unit.
    pub(crate) fn twin(&self, catalog: &Catalog, device: &Device, id: &str) -> Result<Twin, Failure> {
        let dropped = self.get(id)?;
        let twin = unit::of_raw(
            catalog,
            device,
            &dropped.raw,
            Path::new(&dropped.info.name),
            false,
        );
        let (twin, _) = twin.map_err(|error| Failure::of("calibration", &error))?;
        Ok(twin)
    }

    /// Returns the name of the file.
    pub(crate) fn name(&self, id: &str) -> Result<String, Failure> {
        Ok(self.get(id)?.info.name.clone())
    }
}
