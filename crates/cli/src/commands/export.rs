use std::path::{Path, PathBuf};

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::robot;
use oaktwin::unit;
use serde::Serialize;

use crate::args::{ExportArgs, UnitArgs};
use crate::context::{Context, Exit, Result};
use crate::{destination, output};

/// What `export` has written.
#[derive(Serialize)]
struct Written {
    model: String,
    files: Vec<PathBuf>,
    findings: Vec<Finding>,
    calibration_findings: Vec<Finding>,
}

pub(crate) fn run(context: &Context, args: &ExportArgs) -> Result<Exit> {
    let (twin, calibration_findings) = twin(context, args)?;
    let attachment = args.attachment()?;
    let made = robot::export(&context.catalog, &twin, &attachment, args.to)?;
    let calibration = calibration_file(args);
    for (name, _) in &made.files {
        destination::spare_inputs(&args.output.join(name), [calibration])?;
    }
    let written = made.write(&args.output)?;
    if args.json {
        output::print_json(&Written {
            model: twin.device.name.clone(),
            files: written,
            findings: made.findings,
            calibration_findings,
        })?;
        return Ok(Exit::Success);
    }
    if let Some(calibration) = calibration {
        output::say_findings(calibration, &calibration_findings);
    }
    output::say_findings(&args.output, &made.findings);
    // The meshes are not worth a line each.
    for path in written
        .iter()
        .filter(|path| path.parent() == Some(args.output.as_path()))
    {
        output::print(&format!("{}\n", path.display()))?;
    }
    Ok(Exit::Success)
}

fn calibration_file(args: &ExportArgs) -> Option<&Path> {
    let named = Path::new(&args.model);
    args.unit
        .calibration
        .as_deref()
        .or_else(|| named.is_file().then_some(named))
}

/// Returns the twin of a model, or of the unit whose calibration is named instead of a model.
fn twin(context: &Context, args: &ExportArgs) -> Result<(Twin, Vec<Finding>)> {
    let file = Path::new(&args.model);
    if !file.is_file() {
        return context.twin_with_axes(&args.model, &args.unit, &args.axes);
    }
    if args.unit.calibration.is_some() {
        return Err(format!("{} is a calibration already; omit --calibration", file.display()).into());
    }
    let (_, calibration, _) = unit::read_calibration(file)?;
    let board = &calibration.board;
    let of_unit = context
        .catalog
        .device_of_unit(&board.product_name, &board.board_name);
    let unit = UnitArgs {
        calibration: Some(file.to_owned()),
        force: args.unit.force,
        lens: args.unit.lens,
    };
    let explained = |error: &dyn std::fmt::Display| {
        let remedy = "give the model, and the file with --calibration";
        format!("{}: {error}; {remedy}", file.display())
    };
    let device = of_unit.map_err(|unknown| explained(&unknown))?;
    context
        .twin_with_axes(&device.id, &unit, &args.axes)
        .map_err(|error| explained(&error).into())
}
