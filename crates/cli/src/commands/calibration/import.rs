use std::path::Path;

use oaktwin::calibration::import::{CalibrationImportOptions, FileFinding, InputFile, import};
use oaktwin::calibration::raw::MAX_BYTES;
use oaktwin::calibration::{self, Calibration};
use oaktwin::{files, unit};

use crate::args::CalibrationImportArgs;
use crate::context::{Context, Exit, Result};
use crate::{destination, output, size};

pub(crate) fn run(context: &Context, args: &CalibrationImportArgs) -> Result<Exit> {
    let device = args
        .model
        .as_deref()
        .map(|model| context.device(model))
        .transpose()?;
    let nominal = device.map(|device| context.catalog.nominal(device));
    let inputs = args
        .files
        .iter()
        .map(|path| {
            Ok(InputFile {
                name: path.display().to_string(),
                bytes: files::read(path, MAX_BYTES as u64, "a calibration")?,
            })
        })
        .collect::<Result<Vec<InputFile>>>()?;
    let options = CalibrationImportOptions {
        cameras: args.cameras.clone(),
        unit: args.unit,
        size: size::parse("--size", args.size.as_deref())?,
        is_fisheye: args.fisheye,
    };
    let imported = import(&inputs, &options, nominal.as_ref())?;
    say(&imported.findings, args)?;
    let (calibration, mut findings) = Calibration::from_raw(&imported.raw)?;
    if let Some(nominal) = &nominal {
        findings.extend(calibration::check_against(
            &calibration,
            nominal,
            &context.catalog,
        ));
    }
    let findings: Vec<FileFinding> = findings
        .into_iter()
        .map(|finding| imported.located(finding))
        .collect();
    say(&findings, args)?;
    let text = imported.raw.to_text();
    match &args.output {
        None => output::print(&text)?,
        Some(path) => {
            let path = destination::file_or_folder(path, "calibration.json")?;
            destination::spare_inputs(&path, args.files.iter().map(|file| Some(file.as_path())))?;
            files::write(&path, text.as_bytes())?;
            output::print(&format!("{}\n", path.display()))?;
        }
    }
    Ok(Exit::Success)
}

/// Prints findings, each with its file, up to an error that is not ignored.
fn say(findings: &[FileFinding], args: &CalibrationImportArgs) -> Result<()> {
    for FileFinding { file, finding } in findings {
        let (file, mut finding) = (Path::new(file), [finding.clone()]);
        unit::accept(file, &mut finding, args.force)?;
        output::say_findings(file, &finding);
    }
    Ok(())
}
