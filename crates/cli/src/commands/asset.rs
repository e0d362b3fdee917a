mod format;

use std::path::{Path, PathBuf};

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::files;
use oaktwin::usd::asset::{self, Asset, AssetOptions, OverrideBase};
use oaktwin::usd::stage;
use serde::Serialize;

use crate::args::AssetArgs;
use crate::context::{Context, Exit, Result};
use crate::{destination, output};

/// A written file.
#[derive(Debug, Serialize)]
struct Written {
    model: String,
    path: PathBuf,
    /// Findings about the asset.
    findings: Vec<Finding>,
    /// Findings about the calibration.
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
    Ok(Exit::Success)
}

fn write(context: &Context, args: &AssetArgs) -> Result<Vec<Written>> {
    let is = |name: &str| args.model.eq_ignore_ascii_case(name);
    let devices: Vec<_> = if is("all") {
        context.catalog.devices().iter().collect()
    } else if is("sheet") {
        context.catalog.sheet().collect()
    } else {
        let (twin, findings) = context.twin_with_axes(&args.model, &args.unit, &args.axes)?;
        return Ok(vec![write_one(&twin, findings, args)?]);
    };
    if args.unit.calibration.is_some() {
        let name = &args.model;
        return Err(format!("--calibration applies to one model; name it instead of `{name}`").into());
    }
    let format = args.format.unwrap_or_default();
    let twins: Vec<Twin> = devices
        .iter()
        .map(|device| {
            let axes = args.axes.imu_frame.unwrap_or_default();
            context.catalog.nominal(&device.with_imu_frame(axes))
        })
        .collect();
    // All assets are created before the first is written, so that an error leaves no files behind.
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
    let format = format::of(args)?;
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

/// Creates a layer of overrides on an existing asset, which it references relative to its own folder.
fn over(twin: &Twin, options: &AssetOptions, base: &Path, args: &AssetArgs) -> Result<Asset> {
    let stage = stage::open(base, args.scene_limit)?;
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
            isaac: self.isaac,
            target: self.target,
            lens: self.unit.lens,
            aperture_offsets: self.aperture_offsets,
            extended_disparity: self.extended_disparity,
            legacy_distortion: self.legacy_distortion,
            rigid_body: self.rigid_body,
            body: !self.no_body,
        }
    }
}
