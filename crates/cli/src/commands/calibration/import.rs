use std::path::Path;

use oaktwin::calibration::import::{FileFinding, ImportOptions, Imported, InputFile, import};
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
    let options = ImportOptions {
        cameras: args.cameras.clone(),
        unit: args.unit,
        size: size::parse("--size", args.size.as_deref())?,
        is_fisheye: args.fisheye,
    };
    let Imported { raw, findings: about } = import(&inputs, &options, nominal.as_ref())?;
    for FileFinding { file, finding } in about {
        let (file, mut finding) = (Path::new(&file), [finding]);
        unit::accept(file, &mut finding, args.force)?;
        output::say_findings(file, &finding);
    }
    let (calibration, mut findings) = Calibration::from_raw(&raw)?;
    if let Some(nominal) = &nominal {
        findings.extend(calibration::check_against(
            &calibration,
            nominal,
            &context.catalog,
        ));
    }
    let first = args.files.first().map_or(Path::new(""), |path| path.as_path());
    unit::accept(first, &mut findings, args.force)?;
    output::say_findings(first, &findings);
    let text = raw.to_text();
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
