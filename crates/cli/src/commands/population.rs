use std::path::Path;

use oaktwin::catalog::TextTable;
use oaktwin::diagnostic::Finding;
use oaktwin::files::OutputFiles;
use oaktwin::population::{Basis, Population, Spread, Statistics, UnitSummary};
use oaktwin::progress::{Progress, Watch};
use serde::Serialize;

use crate::args::PopulationArgs;
use crate::context::{Context, Exit, Result};
use crate::{output, progress};

/// What `population` has written.
#[derive(Serialize)]
struct Written<'a> {
    model: &'a str,
    basis: Basis,
    spread: &'a Spread,
    units: Vec<UnitSummary>,
    findings: Vec<Finding>,
}

pub(crate) fn run(context: &Context, args: &PopulationArgs) -> Result<Exit> {
    let nominal = context.catalog.nominal(context.device(&args.model)?);
    let population = Population::new(&nominal, args.seed);
    let mut files = OutputFiles::in_folder(&args.output)?;
    let write = |watch: &Watch<'_>| -> Result<Option<Vec<UnitSummary>>> {
        let mut units = Vec::new();
        for number in 0..args.units {
            let progress = Progress {
                done: number,
                total: args.units,
            };
            if watch(progress).is_break() {
                return Ok(None);
            }
            let unit = population.unit(number);
            let text = population.calibration(&unit).to_text();
            files.write(Path::new(&unit.file_name()), text.as_bytes())?;
            units.push(unit.summary());
        }
        files.write(Path::new("units.csv"), table(&units).as_bytes())?;
        Ok(Some(units))
    };
    let Some(units) = progress::watched(write)? else {
        output::say("interrupted; the calibrations so far are complete");
        return Ok(Exit::Interrupted);
    };
    let (spread, basis) = population.spread();
    let finding = population.finding();
    if args.json {
        output::print_json(&Written {
            model: &nominal.device.name,
            basis,
            spread,
            units,
            findings: vec![finding],
        })?;
        return Ok(Exit::Success);
    }
    let mut text = output::number_table(&statistics(&units));
    text += &format!(
        "Written: {} calibrations in {}\n",
        args.units,
        args.output.display()
    );
    output::print(&text)?;
    output::say_findings(&args.output, &[finding]);
    Ok(Exit::Success)
}

/// Returns the units as CSV.
fn table(units: &[UnitSummary]) -> String {
    let names: Vec<&str> = UnitSummary::NUMBERS.iter().map(|(name, _)| *name).collect();
    let mut text = format!("number,file,{}\n", names.join(","));
    for unit in units {
        let values = UnitSummary::NUMBERS.iter().map(|(_, value)| value(unit));
        let values: Vec<String> = values
            .map(|value| value.map(|value| format!("{value:.6}")).unwrap_or_default())
            .collect();
        text += &format!("{},{},{}\n", unit.number, unit.file, values.join(","));
    }
    text
}

/// Returns the mean, the standard deviation and the range of each number.
fn statistics(units: &[UnitSummary]) -> TextTable {
    let rows = UnitSummary::NUMBERS.iter().filter_map(|(name, value)| {
        let values: Vec<f64> = units.iter().filter_map(value).collect();
        let Statistics {
            mean,
            deviation,
            smallest,
            largest,
        } = Statistics::of(&values)?;
        let numbers = [mean, deviation, smallest, largest].map(|number| format!("{number:.2}"));
        Some([vec![(*name).to_owned()], numbers.to_vec()].concat())
    });
    TextTable {
        title: String::new(),
        header: ["", "Mean", "Deviation", "Smallest", "Largest"]
            .map(str::to_owned)
            .to_vec(),
        rows: rows.collect(),
    }
}
