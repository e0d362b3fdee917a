//! Calibrations that were dropped onto the page.

use std::collections::VecDeque;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::calibration::{Calibration, Raw};
use oaktwin::catalog::{Catalog, Device, Twin};
use oaktwin::unit;

use crate::protocol::{CalibrationInfo, Failure};
use crate::upload::bytes_id;

/// The number of calibrations that are kept.
const KEPT: usize = 32;

/// A calibration.
#[derive(Debug)]
pub(crate) struct Dropped {
    pub(crate) info: CalibrationInfo,
    pub(crate) bytes: Vec<u8>,
    raw: Raw,
}

/// The calibrations by id.
#[derive(Debug, Default)]
pub(crate) struct Calibrations(Mutex<VecDeque<Arc<Dropped>>>);

impl Dropped {
    /// Reads a calibration.
    pub(crate) fn read(catalog: &Catalog, name: &str, bytes: Vec<u8>) -> Result<Self, Failure> {
        let raw = Raw::parse(&bytes, name).map_err(|error| Failure::from(error.to_string()))?;
        let read = Calibration::from_raw(&raw);
        let (calibration, findings) = read.map_err(|error| Failure::from(format!("{name}: {error}")))?;
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
    /// Keeps a calibration.
    pub(crate) fn add(&self, dropped: Dropped) -> CalibrationInfo {
        let info = dropped.info.clone();
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|other| other.info.id != info.id);
        known.push_back(Arc::new(dropped));
        while known.len() > KEPT {
            known.pop_front();
        }
        info
    }

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

    pub(crate) fn get(&self, id: &str) -> Result<Arc<Dropped>, Failure> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known
            .iter()
            .find(|calibration| calibration.info.id == id)
            .cloned();
        found.ok_or_else(|| {
            Failure::of(
                "calibration",
                &format!("no calibration '{id}'; drop the file onto the page again"),
            )
        })
    }
}
