//! The sensor models over a pipe, for oracles in other languages: one JSON request per line on standard input, one JSON
//! answer per line on standard output, `{"error": …}` if the request failed. Images are NPY files named in the request.

mod files;
mod filters;
mod rectify;
mod single_view;
mod stereo_matching;
mod stereo_noise;
mod time_of_flight;

use std::error::Error;
use std::io::{self, BufRead, Write};

use serde::Deserialize;
use serde_json::{Value, json};

#[derive(Deserialize)]
#[serde(tag = "op", rename_all = "snake_case")]
enum Request {
    /// Filters of disparity and depth.
    Filters(filters::Request),
    /// Rectification of raw image pairs.
    Rectify(rectify::Request),
    /// Isaac Sim's depth sensor.
    SingleView(single_view::Request),
    /// The stereo matcher on an image pair.
    StereoMatching(stereo_matching::Request),
    /// The parameters of the stereo matcher by name.
    StereoMatchingParameters(stereo_matching::ParametersRequest),
    /// The error model of stereo depth.
    StereoNoise(stereo_noise::Request),
    /// The error model of time-of-flight depth.
    TimeOfFlight(time_of_flight::Request),
    /// `DepthAI`'s confidence filter of time-of-flight depth.
    DepthConfidence(time_of_flight::Confidence),
}

fn answer(line: &str) -> Result<Value, Box<dyn Error>> {
    match serde_json::from_str(line)? {
        Request::Filters(request) => request.answer(),
        Request::Rectify(request) => request.answer(),
        Request::SingleView(request) => request.answer(),
        Request::StereoMatching(request) => request.answer(),
        Request::StereoMatchingParameters(request) => request.answer(),
        Request::StereoNoise(request) => request.answer(),
        Request::TimeOfFlight(request) => request.answer(),
        Request::DepthConfidence(request) => request.answer(),
    }
}

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let answer = answer(&line?).unwrap_or_else(|error| json!({"error": error.to_string()}));
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}
