mod text;

use std::path::Path;
use std::sync::Mutex;

use oaktwin::accuracy::{self, Bench, MeasuredOptics, Measurement, Options, measured};
use oaktwin::files;
use oaktwin::image::png;
use oaktwin::render;

use crate::args::{AccuracyArgs, Lens, UnitArgs};
use crate::context::{Context, Exit, Result};
use crate::progress::Progress;
use crate::{destination, output};

pub(crate) fn run(context: &Context, args: &AccuracyArgs) -> Result<Exit> {
    let plot = args.plot.as_deref().map(Plot::new).transpose()?;
    let unit = UnitArgs {
        calibration: args.calibration.clone(),
        force: args.force,
        lens: Lens::Pinhole,
    };
    let options = options(args)?;
    let (twin, mut findings) = context.twin(&args.model, &unit)?;
    let curve = args.measured.as_deref().map(measured::read).transpose()?;
    if let Some(plot) = &plot {
        let inputs = [args.measured.as_deref(), args.calibration.as_deref()];
        destination::spare_inputs(plot.file, inputs)?;
    }
    if let Some(threads) = args.threads {
        render::use_threads(threads as usize);
    }
    let (bench, more) = Bench::new(&twin, &options)?;
    findings.extend(more);
    let progress = Mutex::new(Progress::new());
    let watch = |done: u64, of: u64| {
        if let Ok(mut progress) = progress.lock() {
            progress.at(done, of);
        }
    };
    let measurement = bench.measure(args.measured.as_deref().zip(curve.as_ref()), &watch)?;
    if let Some(plot) = &plot {
        plot.draw(&measurement, &watch)?;
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
        engine: args.engine.options(),
        distances_m: args
            .distances
            .as_deref()
            .map(accuracy::parse_distances)
            .transpose()?,
        devices: args.devices,
        captures: args.captures,
        region: args.region / 100.0,
        optics: MeasuredOptics {
            focal_length_px: args.focal_px,
            width_px: args.stereo_width,
        },
        from_m: args.from,
    })
}

/// A file to draw into.
struct Plot<'a> {
    file: &'a Path,
    is_svg: bool,
}

impl<'a> Plot<'a> {
    /// In the format that its extension says.
    fn new(file: &'a Path) -> Result<Self> {
        let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
        let is_svg = extension == "svg";
        if !is_svg && extension != "png" {
            return Err(format!(
                "{}: is neither SVG nor PNG; name it FILE.svg or FILE.png",
                file.display()
            )
            .into());
        }
        Ok(Self { file, is_svg })
    }

    fn draw(&self, measurement: &Measurement, watch: &(dyn Fn(u64, u64) + Sync)) -> Result<()> {
        let figure = measurement.figure(watch)?;
        let bytes = if self.is_svg {
            figure.svg().into_bytes()
        } else {
            png::encode(&figure.picture())?
        };
        Ok(files::write(self.file, &bytes)?)
    }
}
