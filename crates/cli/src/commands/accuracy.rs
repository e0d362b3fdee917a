mod cells;
mod tables;
mod text;
mod verdict;

use std::path::Path;

use oaktwin::accuracy::{self, AccuracyError, AccuracyOptions, Bench, measured};

use crate::args::AccuracyArgs;
use crate::context::{Context, Exit, Result};
use crate::plot::Plot;
use crate::{destination, output, progress};

pub(crate) fn run(context: &Context, args: &AccuracyArgs) -> Result<Exit> {
    let plot = args.plot.as_deref().map(Plot::new).transpose()?;
    let options = options(args)?;
    let (twin, mut findings) = context.twin(&args.model, &args.unit.unit())?;
    let curve = args.measured.as_deref().map(measured::read).transpose()?;
    if let Some(plot) = &plot {
        let inputs = [args.measured.as_deref(), args.unit.calibration.as_deref()];
        destination::spare_inputs(plot.file, inputs.into_iter().chain(args.engine.files().map(Some)))?;
    }
    args.threads.apply();
    let (bench, more) = Bench::new(&twin, &options)?;
    findings.extend(more);
    let measured = progress::watched(|watch| {
        let measurement = bench.measure(args.measured.as_deref().zip(curve.as_ref()), watch)?;
        let figure = plot.is_some().then(|| measurement.figure(watch)).transpose()?;
        Ok((measurement, figure))
    });
    let (measurement, figure) = match measured {
        Err(error @ AccuracyError::Interrupted) => {
            output::say(&error.to_string());
            return Ok(Exit::Interrupted);
        }
        measured => measured?,
    };
    if let (Some(plot), Some(figure)) = (&plot, figure) {
        plot.draw(&[figure])?;
    }
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
    Ok(if report.passed {
        Exit::Success
    } else {
        Exit::Findings
    })
}

fn options(args: &AccuracyArgs) -> Result<AccuracyOptions> {
    Ok(AccuracyOptions {
        sensor: args.sensor.clone(),
        engine: args.engine.options()?,
        distances_m: args
            .distances
            .as_deref()
            .map(accuracy::parse_distances)
            .transpose()?,
        devices: args.devices,
        population: args.population,
        captures: args.captures,
        region: args.region / 100.0,
        optics: args.unit.optics(),
        from_m: args.from,
    })
}
