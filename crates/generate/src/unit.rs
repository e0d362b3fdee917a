//! The unit that an arrangement is seen by.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::path::Path;

use oaktwin_base::parameter::Table;
use oaktwin_camera::StereoDrift;
use oaktwin_dataset::WriteError;
use oaktwin_files::OutputFiles;
use serde::{Deserialize, Serialize};

use crate::context::Context;
use crate::recipe::DriftRule;
use crate::units::Units;

/// The folder of calibrations in a data set.
const FOLDER: &str = "units";

/// A unit as drawn for an arrangement.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub(crate) struct DrawnUnit {
    pub(crate) model: String,
    /// The number in the population; `None` for a nominal or calibrated unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) number: Option<u64>,
    /// The change of its stereo pair since its calibration.
    #[serde(with = "text", skip_serializing_if = "StereoDrift::is_none", default)]
    pub(crate) drift: StereoDrift,
}

impl DrawnUnit {
    /// Draws the unit of an arrangement of this number.
    pub(crate) fn draw(context: &Context, model: &str, arrangement: u64) -> Self {
        let rule = &context.file.recipe.unit;
        let number = rule
            .population
            .map(|_| rule.count.map_or(arrangement, |count| arrangement % count.max(1)));
        let mut drift = StereoDrift::default();
        for (key, name, quantity) in rule.drift.iter().flat_map(DriftRule::quantities) {
            let place = format!("unit.drift.{key}");
            let mut numbers = context.random.numbers(&place, number.unwrap_or(arrangement));
            // The recipe's ranges were checked.
            let _ = drift.set_by_name(name, quantity.draw(&mut numbers));
        }
        Self {
            model: model.to_owned(),
            number,
            drift,
        }
    }

    /// Returns the name and the text of the calibration file of a unit of a population.
    fn calibration(&self, context: &Context) -> Option<(String, String)> {
        let Units::Population(population) = context.units(&self.model) else {
            return None;
        };
        let unit = population.unit(self.number?);
        Some((unit.file_name(), population.calibration(&unit).to_text()))
    }
}

/// Writes the calibrations of the units of frames, and `units/frames.csv`, which names the unit of each frame.
pub(crate) fn write(
    context: &Context,
    frames: &[(u64, DrawnUnit)],
    output: &mut OutputFiles,
) -> Result<(), WriteError> {
    let rule = &context.file.recipe.unit;
    if rule.population.is_none() && rule.drift.is_none() {
        return Ok(());
    }
    let mut table = "frame,model,unit,calibration,drift\n".to_owned();
    let mut names: BTreeMap<(&str, Option<u64>), String> = BTreeMap::new();
    for (frame, unit) in frames {
        let name = match names.entry((unit.model.as_str(), unit.number)) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => {
                let file = unit.calibration(context);
                if let Some((name, text)) = &file {
                    output.write(&Path::new(FOLDER).join(name), text.as_bytes())?;
                }
                new.insert(file.map(|(name, _)| name).unwrap_or_default())
            }
        };
        let line = [
            frame.to_string(),
            quoted(&unit.model),
            unit.number.map(|number| number.to_string()).unwrap_or_default(),
            name.clone(),
            quoted(&unit.drift.to_text()),
        ];
        table.push_str(&line.join(","));
        table.push('\n');
    }
    output.write(&Path::new(FOLDER).join("frames.csv"), table.as_bytes())?;
    Ok(())
}

/// A text as a field of a CSV file.
fn quoted(text: &str) -> String {
    if text.contains(',') {
        format!("\"{text}\"")
    } else {
        text.to_owned()
    }
}

/// Serialization of a drift as text.
mod text {
    use oaktwin_camera::StereoDrift;
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(drift: &StereoDrift, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&drift.to_text())
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<StereoDrift, D::Error> {
        StereoDrift::parse(&String::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}
