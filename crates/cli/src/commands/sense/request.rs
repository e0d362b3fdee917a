//! Converts the arguments of the command to options.

use std::path::{Path, PathBuf};

use oaktwin::files::FileError;
use oaktwin::image::annotation::Annotator;
use oaktwin::render;
use oaktwin::sense::{FieldOfView, SenseInput, SenseOptions};

use crate::args::SenseArgs;
use crate::context::Result;

pub(super) fn options(args: &SenseArgs) -> Result<SenseOptions> {
    Ok(SenseOptions {
        sensor: args.engine.options()?,
        depth_sensor: args.sensor.clone(),
        input_kind: args.input_kind,
        depth_scale: args.depth_scale,
        field_of_view: FieldOfView::given(args.fx, args.hfov),
        resample: args.resample,
        is_sequence: args.sequence,
        lens: args.unit.lens,
        align: args.align.to()?,
        annotators: annotators(args)?,
        extras: args.outputs.extras(),
        cloud: args.outputs.ply.then_some(args.ply_frame),
    })
}

fn annotators(args: &SenseArgs) -> Result<Vec<Annotator>> {
    let mut chosen = Vec::new();
    for name in &args.outputs.annotators {
        let annotator = render::annotator(name.trim())?;
        if !annotator.is_depth_sensor() {
            return Err(format!(
                "--annotators {}: is ground truth, not an output of a depth sensor; remove it",
                annotator.name()
            )
            .into());
        }
        if !chosen.contains(&annotator) {
            chosen.push(annotator);
        }
    }
    Ok(chosen)
}

/// Whether the result goes to standard output.
pub(super) fn is_stream(args: &SenseArgs) -> bool {
    args.output.is_none() && args.depth.iter().any(|path| is_standard_input(path))
}

fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

pub(super) fn inputs(args: &SenseArgs) -> Result<Vec<SenseInput>> {
    let from_pipe = args.depth.iter().filter(|path| is_standard_input(path)).count();
    if from_pipe > 1 {
        return Err("- is standard input, which can be read only once; name it once".into());
    }
    if is_stream(args) {
        if args.depth.len() > 1 {
            return Err("- with other inputs: standard output takes a single result; set -o DIR".into());
        }
        let writes_files = [
            (args.outputs.png16, "--png16"),
            (args.outputs.exr, "--exr"),
            (args.outputs.preview, "--preview"),
            (args.outputs.ply, "--ply"),
            (!args.outputs.annotators.is_empty(), "--annotators"),
            (args.json, "--json"),
        ];
        if let Some((_, option)) = writes_files.iter().find(|(given, _)| *given) {
            return Err(format!("{option}: standard output takes only the distances; set -o DIR").into());
        }
    }
    let files = args.depth.iter().filter(|path| !path.is_dir()).count();
    if !args.rgb.is_empty() && files < args.depth.len() {
        return Err(
            "--rgb: the colour images of a folder are found automatically; remove it, or name files".into(),
        );
    }
    if files > 1 && !args.rgb.is_empty() && args.rgb.len() != files {
        return Err(format!(
            "--rgb: {} colour images for {files} depth files; give one for each",
            args.rgb.len()
        )
        .into());
    }
    let mut inputs = Vec::new();
    for (i, path) in args.depth.iter().enumerate() {
        let rgb: Vec<PathBuf> = match files {
            1 => args.rgb.clone(),
            _ => args.rgb.get(i).cloned().into_iter().collect(),
        };
        let output = args.output.clone();
        inputs.push(if is_standard_input(path) {
            SenseInput::StandardInput {
                output: output.unwrap_or_default(),
                rgb,
            }
        } else if path.is_dir() {
            SenseInput::Folder {
                path: path.clone(),
                output: output.unwrap_or_else(|| path.clone()),
            }
        } else {
            std::fs::metadata(path).map_err(|error| FileError::reading(path, &error))?;
            let output =
                output.ok_or_else(|| format!("{}: output directory required (-o DIR)", path.display()))?;
            SenseInput::File {
                path: path.clone(),
                output,
                rgb,
            }
        });
    }
    Ok(inputs)
}
