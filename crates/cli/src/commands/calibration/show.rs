use oaktwin::calibration;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::unit;

use super::text;
use crate::args::CalibrationShowArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

/// Prints a calibration and its findings. An error among them is also the command's.
pub(super) fn run(context: &Context, args: &CalibrationShowArgs) -> Result<Exit> {
    let (_, calibration, mut findings) = unit::read_calibration(&args.file)?;
    let named = args
        .model
        .as_deref()
        .map(|model| context.device(model))
        .transpose()?;
    let board = &calibration.board;
    let device_of_unit = || {
        context
            .catalog
            .device_of_unit(&board.product_name, &board.board_name)
    };
    let device = named.or_else(|| device_of_unit().ok());
    if let Some(device) = device {
        let nominal = context.catalog.nominal(device);
        findings.extend(calibration::check_against(
            &calibration,
            &nominal,
            &context.catalog,
        ));
    }
    let summary = calibration::summary(&calibration, &findings);
    if args.json {
        output::print_json(&summary)?;
    } else {
        output::print(&text::summary(&args.file, &summary, device))?;
    }
    let errors: Vec<&Finding> = findings
        .iter()
        .filter(|finding| finding.level == Level::Error)
        .collect();
    match errors.as_slice() {
        [] => Ok(Exit::Success),
        [error] => Err(format!("{}: {error}", args.file.display()).into()),
        [first, more @ ..] => {
            let more = more.len();
            Err(format!("{}: {first} (and {more} more, listed above)", args.file.display()).into())
        }
    }
}
