//! `fit --latency`.

use std::path::Path;

use oaktwin::latency::{self, LatencyReport, Track};

use crate::args::FitArgs;
use crate::context::{Exit, Result};
use crate::output;

pub(super) fn run(args: &FitArgs) -> Result<Exit> {
    let [camera, reference] = &args.recordings[..] else {
        let count = args.recordings.len();
        let files = if count == 1 { "file" } else { "files" };
        return Err(
            format!("--latency: {count} {files} given; give the camera's and the reference's").into(),
        );
    };
    let (camera, reference) = (Track::read(camera)?, Track::read(reference)?);
    let (report, findings) = latency::latency(&camera, &reference, args.longest)?;
    if args.json {
        output::print_json(&report)?;
    } else {
        output::print(&text(&report))?;
    }
    output::say_findings(Path::new(&camera.name), &findings);
    Ok(match report.passed {
        true => Exit::Success,
        false => Exit::Findings,
    })
}

fn text(report: &LatencyReport) -> String {
    let [latency, low, high, jitter] = [
        report.latency_s,
        report.interval_95_s.0,
        report.interval_95_s.1,
        report.jitter_s,
    ]
    .map(|seconds| 1e3 * seconds);
    format!(
        "Latency {latency:.2} ms (95 %: {low:.2} to {high:.2} ms), from the middle of an exposure until its image arrives\n\
         Jitter {jitter:.2} ms (standard deviation); the edge scatters by {:.3} of the camera's unit\n\
         {} images over {:.1} s, correlation {:.5}\n\
         Stream(latency={:.4}), bridge --latency {:.4}\n",
        report.edge_noise,
        report.images,
        report.seconds,
        report.correlation,
        report.latency_s,
        report.latency_s,
    )
}
