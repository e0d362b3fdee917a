mod text;

use std::ops::ControlFlow;
use std::path::Path;

use oaktwin::accuracy::{self, Bench, Options, measured};

use crate::args::AccuracyArgs;
use crate::context::{Context, Exit, Result};
use crate::plot::Plot;
use crate::progress::SharedProgress;
use crate::{destination, output};

pub(crate) fn run(context: &Context, args: &AccuracyArgs) -> Result<Exit> {
    let plot = args.plot.as_deref().map(Plot::new).transpose()?;
    let options = options(args)?;
    let (twin, mut findings) = context.twin(&args.model, &args.unit.unit())?;
    let curve = args.measured.as_deref().map(measured::read).transpose()?;
    if let Some(plot) = &plot {
        let inputs = [args.measured.as_deref(), args.unit.calibration.as_deref()];
        destination::spare_inputs(plot.file, inputs)?;
    }
    args.threads.apply();
    let (bench, more) = Bench::new(&twin, &options)?;
    findings.extend(more);
    let progress = SharedProgress::new();
    let watch = |done: u64, of: u64| {
        progress.at(done, of);
        ControlFlow::Continue(())
    };
    let measurement = bench.measure(args.measured.as_deref().zip(curve.as_ref()), &watch)?;
    if let Some(plot) = &plot {
        plot.draw(&[measurement.figure(&watch)?])?;
    }
    drop(progress);
    let report = measurement.report();
    if args.json {
        output::print_json(report)?;
    } else {
        let mut text = text::report(report);
        if let Some(plot) = &plot {
            text += &format!("Written: {}\n", plot.file.display());
        }
        output::print(&text)?;
    }
    let about = args
        .unit
        .calibration
        .as_deref()
        .unwrap_or(Path::new(&twin.device.name));
    output::say_findings(about, &findings);
    Ok(if report.is_good {
        Exit::Good
    } else {
        Exit::Findings
    })
}

fn options(args: &AccuracyArgs) -> Result<Options> {
    Ok(Options {
        sensor: args.sensor.clone(),
        engine: args.engine.options()?,
        distances_m: args
            .distances
            .as_deref()
            .map(accuracy::parse_distances)
            .transpose()?,
        devices: args.devices,
        captures: args.captures,
        region: args.region / 100.0,
        optics: args.unit.optics(),
        from_m: args.from,
    })
}
