//! The individual unit of an OAK: drawn from the population of its model, and its drift since the calibration.

use std::path::Path;

use oaktwin::calibration::Raw;
use oaktwin::camera::StereoDrift;
use oaktwin::catalog::{Catalog, Device, Twin};
use oaktwin::diagnostic::Finding;
use oaktwin::population::Population;
use oaktwin::unit;

use crate::protocol::{Failure, OakState};

/// The number of the unit: each seed has its own population, so that one number identifies a unit.
const NUMBER: u64 = 0;

/// A unit of a model's population.
pub(crate) struct Drawn {
    population: Population,
}

impl Drawn {
    pub(crate) fn new(catalog: &Catalog, device: &Device, seed: u64) -> Self {
        Self {
            population: Population::new(&catalog.nominal(device), seed),
        }
    }

    /// Returns the unit's twin, as its calibration file describes it.
    pub(crate) fn twin(&self, catalog: &Catalog, device: &Device) -> Result<Twin, Failure> {
        let unit = self.population.unit(NUMBER);
        let name = unit.file_name();
        let text = self.population.calibration(&unit).to_text();
        let failed = |error: &dyn ToString| Failure::of("populationSeed", &error.to_string());
        let raw = Raw::parse(text.as_bytes(), &name).map_err(|error| failed(&error))?;
        let twin = unit::of_raw(catalog, device, &raw, Path::new(&name), false);
        let (twin, _) = twin.map_err(|error| failed(&error))?;
        Ok(twin)
    }

    /// The name of the unit's calibration in the folder that `oaktwin population` writes.
    pub(crate) fn file_name(&self) -> String {
        self.population.unit(NUMBER).file_name()
    }

    /// A note about the origin of the spread.
    pub(crate) fn finding(&self) -> Finding {
        self.population.finding()
    }
}

impl OakState {
    /// Returns the drift of the pair, if there is one.
    pub(crate) fn drift(&self) -> Result<Option<StereoDrift>, Failure> {
        let settings = self.drift.iter().map(|(name, value)| {
            let setting = format!("{name}={value}");
            let parsed = StereoDrift::parse(&setting);
            parsed.map_err(|error| Failure::of(&format!("drift.{name}"), &error))?;
            Ok(setting)
        });
        let settings = settings.collect::<Result<Vec<_>, Failure>>()?;
        let drift = StereoDrift::parse(&settings.join(","));
        let drift = drift.map_err(|error| Failure::of("drift", &error))?;
        Ok((!drift.is_none()).then_some(drift))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_differ_by_their_seed() {
        let catalog = Catalog::builtin();
        let device = catalog.device("OAK-D Pro PoE").unwrap();
        let twin = |seed| Drawn::new(catalog, device, seed).twin(catalog, device).unwrap();
        assert_eq!(twin(1), twin(1));
        assert_ne!(twin(1).cameras, twin(2).cameras);
        assert_eq!(
            Drawn::new(catalog, device, 1).file_name(),
            "oak_d_pro_poe_000000.json"
        );
    }
}
