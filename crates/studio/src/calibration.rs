//! Calibrations that were dropped onto the page.

use std::collections::VecDeque;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::calibration::{Calibration, Raw};
use oaktwin::catalog::{Catalog, Device, Twin};
use oaktwin::unit;

use crate::protocol::{CalibrationInfo, Failure};

/// The number of calibrations that are kept.
const KEPT: usize = 32;

/// A calibration.
#[derive(Debug)]
struct Dropped {
    id: String,
    name: String,
    raw: Raw,
}

/// The calibrations by id.
#[derive(Debug, Default)]
pub(crate) struct Calibrations(Mutex<(u64, VecDeque<Arc<Dropped>>)>);

impl Calibrations {
    /// Reads a calibration and keeps it.
    pub(crate) fn add(
        &self,
        catalog: &Catalog,
        name: &str,
        bytes: &[u8],
    ) -> Result<CalibrationInfo, Failure> {
        let raw = Raw::parse(bytes, name).map_err(|error| Failure::from(error.to_string()))?;
        let read = Calibration::from_raw(&raw);
        let (calibration, findings) = read.map_err(|error| Failure::from(format!("{name}: {error}")))?;
        let board = &calibration.board;
        let model = catalog.device_of_unit(&board.product_name, &board.board_name);
        let model = model.ok().map(|device| device.name.clone());
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.0 += 1;
        let id = format!("calibration-{}", known.0);
        known.1.push_back(Arc::new(Dropped {
            id: id.clone(),
            name: name.to_owned(),
            raw,
        }));
        while known.1.len() > KEPT {
            known.1.pop_front();
        }
        Ok(CalibrationInfo {
            id,
            name: name.to_owned(),
            model,
            findings,
        })
    }

    /// Returns the twin of a unit.
    pub(crate) fn twin(&self, catalog: &Catalog, device: &Device, id: &str) -> Result<Twin, Failure> {
        let dropped = self.get(id)?;
        let twin = unit::of_raw(catalog, device, &dropped.raw, Path::new(&dropped.name), false);
        let (twin, _) = twin.map_err(|error| Failure::of("calibration", &error))?;
        Ok(twin)
    }

    /// Returns the name of the file.
    pub(crate) fn name(&self, id: &str) -> Result<String, Failure> {
        Ok(self.get(id)?.name.clone())
    }

    fn get(&self, id: &str) -> Result<Arc<Dropped>, Failure> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known.1.iter().find(|calibration| calibration.id == id).cloned();
        found.ok_or_else(|| {
            Failure::of(
                "calibration",
                &format!("no calibration '{id}'; drop the file onto the page again"),
            )
        })
    }
}
