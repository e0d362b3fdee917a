use std::path::{Path, PathBuf};

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::files;
use oaktwin::usd::asset::{self, Asset, AssetOptions, Format, OverrideBase};
use oaktwin::usd::stage;
use serde::Serialize;

use crate::args::AssetArgs;
use crate::context::{Context, Exit, Result};
use crate::{destination, output};

/// One file that was written.
#[derive(Debug, Serialize)]
struct Written {
    model: String,
    path: PathBuf,
    /// About the asset.
    findings: Vec<Finding>,
    /// About the calibration it was made from.
    calibration_findings: Vec<Finding>,
}

pub(crate) fn run(context: &Context, args: &AssetArgs) -> Result<Exit> {
    let written = write(context, args)?;
    if args.json {
        output::print_json(&written)?;
    } else {
        for file in &written {
            if let Some(calibration) = &args.unit.calibration {
                output::say_findings(calibration, &file.calibration_findings);
            }
            output::say_findings(&file.path, &file.findings);
            output::print(&format!("{}\n", file.path.display()))?;
        }
    }
    Ok(Exit::Good)
}

fn write(context: &Context, args: &AssetArgs) -> Result<Vec<Written>> {
    if !args.model.eq_ignore_ascii_case("all") {
        let (twin, findings) = context.twin(&args.model, &args.unit)?;
        return Ok(vec![write_one(&twin, findings, args)?]);
    }
    if args.unit.calibration.is_some() {
        return Err("--calibration belongs to one model: name it instead of `all`".into());
    }
    let format = args.format.unwrap_or_default().into();
    let devices = context.catalog.devices();
    let twins = context.catalog.nominals();
    // Every asset is made before the first is written, so that an error leaves nothing behind.
    let made = asset::files(&twins, &args.options(), format)?;
    let mut written = Vec::new();
    for (device, file) in devices.iter().zip(made) {
        let path = destination::in_folder(&args.output, &file.name)?;
        files::write(&path, &file.bytes)?;
        written.push(Written {
            model: device.name.clone(),
            path,
            findings: file.findings,
            calibration_findings: Vec::new(),
        });
    }
    Ok(written)
}

fn write_one(twin: &Twin, calibration_findings: Vec<Finding>, args: &AssetArgs) -> Result<Written> {
    let format = format(args)?;
    let options = args.options();
    let made = match &args.over {
        Some(base) => over(twin, &options, base, args)?,
        None => asset::asset(twin, &options)?,
    };
    let bytes = made.bytes(format)?;
    let path = destination::file_or_folder(&args.output, &made.file_name(format))?;
    destination::spare_inputs(&path, [args.unit.calibration.as_deref(), args.over.as_deref()])?;
    files::write(&path, &bytes)?;
    Ok(Written {
        model: twin.device.name.clone(),
        path,
        findings: made.findings,
        calibration_findings,
    })
}

/// What `--format` says, else the output's extension.
fn format(args: &AssetArgs) -> Result<Format> {
    let asked = args.format.map(Format::from);
    if destination::names_folder(&args.output) {
        return Ok(asked.unwrap_or_default());
    }
    let extension = args.output.extension().and_then(|e| e.to_str());
    let named = extension.and_then(|e| {
        [Format::Usda, Format::Usd, Format::Usdz]
            .into_iter()
            .find(|f| f.extension() == e)
    });
    let path = args.output.display();
    match (asked, named, extension) {
        (Some(asked), Some(named), _) if asked != named => Err(format!(
            "{path}: --format {} and the extension disagree; leave one out",
            asked.extension()
        )
        .into()),
        (None, None, Some(extension)) => Err(format!(
            "{path}: .{extension} is no USD format; use .usda, .usd or .usdz, or say --format"
        )
        .into()),
        _ => Ok(asked.or(named).unwrap_or_default()),
    }
}

/// The layer of overrides on somebody's asset, which it names relative to its own folder.
fn over(twin: &Twin, options: &AssetOptions, base: &Path, args: &AssetArgs) -> Result<Asset> {
    let stage = stage::open(base)?;
    let folder = if destination::names_folder(&args.output) {
        args.output.clone()
    } else {
        args.output.parent().map(Path::to_owned).unwrap_or_default()
    };
    let name = files::relative(&folder, base)?;
    Ok(asset::overrides(
        twin,
        options,
        &OverrideBase::of(&stage, &name, twin)?,
    )?)
}

impl AssetArgs {
    fn options(&self) -> AssetOptions {
        AssetOptions {
            isaac: self.isaac.into(),
            target: self.target.into(),
            lens: self.unit.lens.into(),
            aperture_offsets: self.aperture_offsets.into(),
            extended_disparity: self.extended_disparity,
            legacy_distortion: self.legacy_distortion,
            rigid_body: self.rigid_body,
            body: !self.no_body,
        }
    }
}
