mod latency;
mod text;

use std::path::Path;

use oaktwin::files;
use oaktwin::fit::{self, FitError, FitOptions};

use crate::args::{Also, FitArgs};
use crate::context::{Context, Exit, Result};
use crate::plot::Plot;
use crate::{destination, output, progress};

pub(crate) fn run(context: &Context, args: &FitArgs) -> Result<Exit> {
    let Some(model) = args.model.as_deref().filter(|_| !args.latency) else {
        return latency::run(args);
    };
    let plot = args.plot.as_deref().map(Plot::new).transpose()?;
    let options = FitOptions {
        sensor: args.sensor.clone(),
        engine: args.engine.options()?,
        optics: args.unit.optics(),
        region: args.region / 100.0,
        depth_scale: args.depth_scale,
        from_m: args.from,
        fits_focal_length: args.fit.contains(&Also::Focal),
    };
    let (twin, mut findings) = context.twin(model, &args.unit.unit())?;
    let written = [args.output.as_deref(), args.plot.as_deref()];
    for file in written.into_iter().flatten() {
        let inputs = args.recordings.iter().map(|path| Some(path.as_path()));
        let others = [args.unit.calibration.as_deref()];
        destination::spare_inputs(file, inputs.chain(others).chain(args.engine.files().map(Some)))?;
    }
    args.threads.apply();
    let fitted = progress::watched(|watch| fit::fit(&twin, &args.recordings, &options, watch));
    let (fit, more) = match fitted {
        Err(error @ FitError::Interrupted) => {
            output::say(&error.to_string());
            return Ok(Exit::Interrupted);
        }
        fitted => fitted?,
    };
    findings.extend(more);
    let report = fit.report();
    if let Some(file) = &args.output {
        files::write(file, report.toml().as_bytes())?;
    }
    if let Some(plot) = &plot {
        plot.draw(&fit.figures())?;
    }
    if args.json {
        output::print_json(report)?;
    } else {
        let mut text = text::report(report);
        for file in written.into_iter().flatten() {
            text += &format!("Written: {}\n", file.display());
        }
        output::print(&text)?;
    }
    let about = args
        .unit
        .calibration
        .as_deref()
        .unwrap_or(Path::new(&twin.device.name));
    output::say_findings(about, &findings);
    Ok(if report.passed {
        Exit::Success
    } else {
        Exit::Findings
    })
}
