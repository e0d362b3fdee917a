use std::ops::Range;
use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueHint};
use oaktwin::dataset::FORMATS;

use super::ThreadArgs;
use super::render::format_value;

#[derive(Args, Debug)]
#[command(after_help = "A recipe is a TOML file; two lines are enough:\n\n    \
    scene = \"table.usda\"\n    objects = [{ files = \"cups/\", count = { uniform = [3, 8] } }]\n\n\
    A frame depends only on the recipe and its number: it has the same bytes on every machine, whichever frames are made before it.")]
pub(crate) struct GenerateArgs {
    /// The recipe
    #[arg(required_unless_present = "schema", value_hint = ValueHint::FilePath)]
    pub(crate) recipe: Option<PathBuf>,

    /// The folder of the data set, or with --preview the PNG file of the contact sheet
    #[arg(
        short,
        long,
        value_name = "DIR|FILE",
        required_unless_present_any = ["explain", "schema"],
        value_hint = ValueHint::AnyPath
    )]
    pub(crate) output: Option<PathBuf>,

    /// Make only the frames from A to B - 1, counted from 0
    #[arg(long, value_name = "A..B", value_parser = frames)]
    pub(crate) frames: Option<Range<u64>>,

    /// Complete a data set that was interrupted, or extend it to more frames
    #[arg(long)]
    pub(crate) resume: bool,

    /// Compare the contents of finished files, not only their lengths, and make changed frames again
    #[arg(long, requires = "resume")]
    pub(crate) verify: bool,

    /// Leave out the files that span frames, so that several machines can share one data set
    ///
    /// Each process makes other --frames in a common folder. A last run with --resume writes the files that span frames.
    #[arg(long, conflicts_with = "resume")]
    pub(crate) only_frames: bool,

    /// The formats, comma-separated [default: the recipe's]
    #[arg(
        long,
        value_name = "NAMES",
        value_delimiter = ',',
        value_parser = PossibleValuesParser::new(FORMATS.iter().map(format_value))
    )]
    pub(crate) formats: Vec<String>,

    /// Also write each arrangement as a USD scene, scenes/NUMBER.usda
    #[arg(long)]
    pub(crate) save_scenes: bool,

    /// The seed of all random numbers [default: the recipe's]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,

    /// Print all random choices of this frame as JSON
    #[arg(long, value_name = "FRAME", conflicts_with_all = ["preview", "resume", "frames", "only_frames"])]
    pub(crate) explain: Option<u64>,

    /// Write a contact sheet of the first N frames instead of a data set
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..), conflicts_with_all = ["resume", "frames", "only_frames"])]
    pub(crate) preview: Option<u64>,

    /// Print the JSON schema of recipes
    #[arg(long, exclusive = true)]
    pub(crate) schema: bool,

    /// The number of frames to make at once [default: one per core, or fewer if memory is short]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) workers: Option<u16>,

    /// Distribute the frames with Ray: local, or a cluster's address (auto, HOST:PORT, ray://HOST:PORT)
    ///
    /// All machines need the recipe, its files and the folder under the same paths. Requires `pip install oaktwin[ray]` for
    /// `python3`, or for the interpreter in the variable `OAKTWIN_PYTHON`.
    #[arg(long, value_name = "ADDRESS", conflicts_with_all = ["explain", "preview", "only_frames"])]
    pub(crate) ray: Option<String>,

    #[command(flatten)]
    pub(crate) threads: ThreadArgs,

    /// Print the result as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

fn frames(text: &str) -> Result<Range<u64>, String> {
    let error = || format!("'{text}' is not a range of frames; write one such as 0..100");
    let (start, end) = text.split_once("..").ok_or_else(error)?;
    let number = |text: &str| text.trim().parse::<u64>().map_err(|_| error());
    let (start, end) = (number(start)?, number(end)?);
    if start >= end {
        return Err(format!("'{text}' has no frames; the end is excluded"));
    }
    Ok(start..end)
}
