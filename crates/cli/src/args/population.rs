use std::path::PathBuf;

use clap::{Args, ValueHint};

#[derive(Args, Debug)]
#[command(
    after_help = "Each unit has its own focal lengths, principal points, distortion and camera poses, drawn around the nominal \
    values with the spread of real factory calibrations. A unit depends only on the model, the seed and its number.\n\n\
    The calibrations are DepthAI's JSON, for --calibration of other commands and for DepthAI itself; units.csv lists how the \
    units differ."
)]
pub(crate) struct PopulationArgs {
    /// The model
    pub(crate) model: String,

    /// The number of units
    #[arg(short = 'n', long = "units", value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    pub(crate) units: u64,

    /// The seed of the population
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,

    /// The output folder
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,

    /// Print the spread and the units as JSON
    #[arg(long)]
    pub(crate) json: bool,
}
