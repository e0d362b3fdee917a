use std::path::Path;

use oaktwin::calibration::export::{self, CalibrationFiles, Format};
use oaktwin::calibration::{Calibration, Raw, nominal_calibration};
use oaktwin::diagnostic::Finding;
use oaktwin::{files, unit};

use crate::args::CalibrationExportArgs;
use crate::context::{Context, Exit, Result};
use crate::{destination, output};

pub(crate) fn run(context: &Context, args: &CalibrationExportArgs) -> Result<Exit> {
    let file = Path::new(&args.from);
    let (raw, calibration, mut findings) = open(context, file, args)?;
    let mut made = export::export(&raw, &calibration, args.to)?;
    // A single file or standard output has room for one.
    let is_folder = args.output.as_deref().is_some_and(destination::names_folder);
    if args.to == Format::Kalibr && is_folder {
        made.extend(imu(context, &args.from, &calibration));
    }
    let CalibrationFiles {
        files,
        findings: losses,
    } = made;
    findings.extend(losses);
    unit::accept(file, &mut findings, args.force)?;
    output::say_findings(file, &findings);
    match &args.output {
        None => output::print(&joined(&files))?,
        Some(folder) if files.len() > 1 => {
            for (name, text) in &files {
                put(&destination::in_folder(folder, name)?, file, text)?;
            }
        }
        Some(path) => {
            for (name, text) in &files {
                put(&destination::file_or_folder(path, name)?, file, text)?;
            }
        }
    }
    Ok(Exit::Success)
}

/// Opens a calibration file or, if there is no such file, the nominal calibration of a model.
fn open(
    context: &Context,
    file: &Path,
    args: &CalibrationExportArgs,
) -> Result<(Raw, Calibration, Vec<Finding>)> {
    if !file.exists() {
        let device = context
            .device(&args.from)
            .map_err(|unknown| format!("{}: no such file, and {unknown}", file.display()))?;
        let raw = nominal_calibration(&context.catalog.nominal(device));
        let (calibration, findings) = Calibration::from_raw(&raw)?;
        return Ok((raw, calibration, findings));
    }
    let (raw, calibration, mut findings) = unit::read_calibration(file)?;
    unit::accept(file, &mut findings, args.force)?;
    Ok((raw, calibration, findings))
}

/// Returns the file of the inertial sensor of the named model, or of the model of the calibration's board.
fn imu(context: &Context, name: &str, calibration: &Calibration) -> CalibrationFiles {
    let catalog = &context.catalog;
    let board = &calibration.board;
    let device = catalog
        .device(name)
        .or_else(|_| catalog.device_of_unit(&board.product_name, &board.board_name));
    let part = device.ok().and_then(|device| catalog.inertial_part_of(device));
    part.map(export::kalibr_imu).unwrap_or_default()
}

fn put(path: &Path, input: &Path, text: &str) -> Result<()> {
    destination::spare_inputs(path, [Some(input)])?;
    files::write(path, text.as_bytes())?;
    output::print(&format!("{}\n", path.display()))
}

/// Joins several files, each under a line with its name. A single file is returned unchanged.
fn joined(files: &[(String, String)]) -> String {
    match files {
        [(_, text)] => text.clone(),
        _ => files
            .iter()
            .map(|(name, text)| format!("# {name}\n{text}\n"))
            .collect(),
    }
}
