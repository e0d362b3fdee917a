mod report;
mod request;

use std::io::{self, IsTerminal};

use oaktwin::sense::{self, SenseError, SenseOutput};

use crate::args::SenseArgs;
use crate::context::{Context, Exit, Result};
use crate::{output, progress};
use report::SenseReport;

pub(crate) fn run(context: &Context, args: &SenseArgs) -> Result<Exit> {
    let options = request::options(args)?;
    let inputs = request::inputs(args)?;
    let is_stream = request::is_stream(args);
    args.threads.apply();
    let (twin, calibration_findings) = context.twin(&args.model, &args.unit)?;
    if is_stream && io::stdout().is_terminal() {
        return Err(
            "standard output is a terminal, but the result is an array; redirect it, or set -o DIR".into(),
        );
    }
    let mut stdout = io::stdout();
    let to = if is_stream {
        SenseOutput::Stream(&mut stdout)
    } else {
        SenseOutput::Files
    };
    let sensed = progress::watched(|watch| sense::sense(&twin, &inputs, &options, to, watch));
    let sensed = sensed.map_err(|error| match error {
        SenseError::Stream(error) if error.kind() == io::ErrorKind::BrokenPipe => error.into(),
        SenseError::Stream(error) => {
            let text = format!("standard output: cannot be written ({error}); redirect it elsewhere");
            <Box<dyn std::error::Error>>::from(text)
        }
        error => error.into(),
    })?;
    if let Some(calibration) = args.unit.calibration.as_ref().filter(|_| !args.json) {
        output::say_findings(calibration, &calibration_findings);
    }
    let exit = if sensed.is_interrupted {
        Exit::Interrupted
    } else {
        Exit::Success
    };
    SenseReport::new(&twin, sensed, calibration_findings).print(args.json, is_stream)?;
    Ok(exit)
}
