//! Sequences of input files, and the names of their outputs.

use crate::sensor::depth_sensor;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{InputKind, SenseError, SenseInput, SenseOptions};
use crate::input::name::Name;
use crate::input::replicator;
use oaktwin_base::diagnostic::{Finding, Level, fold_name, message, opt};
use oaktwin_catalog::{Twin, TwinDepthSensor};
use oaktwin_dataset::InputName;
use oaktwin_files::FileError;

/// The name of standard input in messages.
pub const STANDARD_INPUT: &str = "standard input";

/// A depth file with its colour images and camera.
#[derive(Clone, Debug)]
pub(super) struct DepthFile {
    pub(super) path: PathBuf,
    pub(super) is_standard_input: bool,
    pub(super) kind: InputKind,
    pub(super) frame: u64,
    pub(super) rgb: Vec<PathBuf>,
    pub(super) params: Option<PathBuf>,
    pub(super) results: InputName,
}

/// The files of one camera in the order of their frames, processed by one sensor.
#[derive(Debug)]
pub(super) struct Sequence<'a> {
    pub(super) sensor: &'a TwinDepthSensor,
    /// Whether the files are named after this sensor.
    is_of_model: bool,
    /// The key of the noise, if it is not the sensor's prim.
    pub(super) name: Option<String>,
    pub(super) files: Vec<DepthFile>,
}

/// Groups inputs into sequences.
pub(super) fn sequences<'a>(
    twin: &'a Twin,
    inputs: &[SenseInput],
    options: &SenseOptions,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Sequence<'a>>, SenseError> {
    let chosen = depth_sensor(twin, options.depth_sensor.as_deref())?;
    let mut sequences = Vec::new();
    let mut named: BTreeMap<(PathBuf, String, String), Vec<DepthFile>> = BTreeMap::new();
    for input in inputs {
        match input {
            SenseInput::Folder { path, output } => {
                folder(twin, chosen, path, output, options, &mut sequences, findings)?;
            }
            SenseInput::File { path, output, rgb } => {
                let name = Name::of(path);
                let file = DepthFile {
                    path: path.clone(),
                    is_standard_input: false,
                    kind: kind(path, name.kind, options)?,
                    frame: name.number.unwrap_or(0),
                    rgb: rgb.clone(),
                    params: None,
                    results: InputName {
                        folder: output.clone(),
                        by_annotator: false,
                        prefix: name.prefix(),
                        suffix: name.suffix(),
                        ..InputName::default()
                    },
                };
                let folder = path.parent().map(Path::to_owned).unwrap_or_default();
                let extension = path
                    .extension()
                    .unwrap_or_default()
                    .to_string_lossy()
                    .into_owned();
                // A file without a number is a separate sequence.
                let base = if name.number.is_some() {
                    name.base
                } else {
                    path.display().to_string()
                };
                named.entry((folder, base, extension)).or_default().push(file);
            }
            SenseInput::StandardInput { output, rgb } => sequences.push(Sequence {
                sensor: chosen,
                is_of_model: false,
                name: None,
                files: vec![DepthFile {
                    path: STANDARD_INPUT.into(),
                    is_standard_input: true,
                    kind: kind(Path::new(STANDARD_INPUT), None, options)?,
                    frame: 0,
                    rgb: rgb.clone(),
                    params: None,
                    results: InputName {
                        folder: output.clone(),
                        ..InputName::default()
                    },
                }],
            }),
        }
    }
    for (_, mut files) in named {
        files.sort_by(|a, b| (a.frame, &a.path).cmp(&(b.frame, &b.path)));
        sequences.push(Sequence {
            sensor: chosen,
            is_of_model: false,
            name: None,
            files,
        });
    }
    one_result_each(&sequences)?;
    let is_used = sequences
        .iter()
        .any(|one| one.sensor == chosen && !one.is_of_model);
    if is_used && options.depth_sensor.is_none() && twin.depth_sensors.len() > 1 {
        findings.push(chosen_sensor(twin, chosen));
    }
    Ok(sequences)
}

/// A note about the choice among several depth sensors.
fn chosen_sensor(twin: &Twin, chosen: &TwinDepthSensor) -> Finding {
    let (prim, kind) = (&chosen.spec.prim, chosen.spec.kind);
    Finding::new(
        "chosen-sensor",
        Level::Note,
        &twin.device.name,
        format!("several depth sensors; using {prim} ({kind})"),
        message!["choose with ", opt("sensor")],
    )
}

/// The cameras of a folder: only the model's depth sensors if there are any, else all.
fn folder<'a>(
    twin: &'a Twin,
    chosen: &'a TwinDepthSensor,
    path: &Path,
    output: &Path,
    options: &SenseOptions,
    sequences: &mut Vec<Sequence<'a>>,
    findings: &mut Vec<Finding>,
) -> Result<(), SenseError> {
    let cameras = replicator::cameras(path)?;
    let of_model = |name: &Path| {
        let wanted = options.depth_sensor.as_deref().map(fold_name);
        let is_wanted = |sensor: &&TwinDepthSensor| {
            let own = [sensor.spec.kind.as_str(), &sensor.spec.prim];
            let mut own = own.into_iter().map(fold_name);
            wanted.as_ref().is_none_or(|wanted| own.any(|own| own == *wanted))
        };
        twin.depth_sensors
            .iter()
            .filter(is_wanted)
            .find(|sensor| name == Path::new(&sensor.spec.prim))
    };
    let any_of_model = cameras.iter().any(|camera| of_model(&camera.name).is_some());
    for camera in cameras {
        let own = of_model(&camera.name);
        if any_of_model && own.is_none() {
            findings.push(Finding::new(
                "camera-left-out",
                Level::Note,
                path.join(&camera.name).display().to_string(),
                format!("not a depth sensor of {}; skipped", twin.device.name),
                "name its files to process them",
            ));
            continue;
        }
        let is_named = own.is_none() && camera.name != Path::new("");
        let files = camera.frames.into_iter().map(|frame| {
            let name = Name::of(&frame.depth);
            DepthFile {
                kind: frame.kind,
                is_standard_input: false,
                frame: name.number.unwrap_or(0),
                rgb: frame.rgb.into_iter().collect(),
                params: frame.params,
                results: InputName {
                    folder: output.join(&camera.name),
                    by_annotator: camera.by_annotator,
                    suffix: name.suffix(),
                    ..InputName::default()
                },
                path: frame.depth,
            }
        });
        sequences.push(Sequence {
            sensor: own.unwrap_or(chosen),
            is_of_model: own.is_some(),
            name: is_named.then(|| camera.name.to_string_lossy().into_owned()),
            files: files.collect(),
        });
    }
    Ok(())
}

/// The kind of depth, from the options or the file's name.
fn kind(path: &Path, named: Option<InputKind>, options: &SenseOptions) -> Result<InputKind, SenseError> {
    match (options.input_kind, named) {
        (Some(kind), _) => Ok(kind),
        (None, Some(kind)) => Ok(kind),
        (None, None) => Err(FileError::new(
            path,
            "unknown kind of depth: along the optical axis, or distance from the camera",
            message![
                "set ",
                opt("input-kind").with("z"),
                " or ",
                opt("input-kind").with("range")
            ],
        )
        .into()),
    }
}

/// Rejects inputs with outputs of the same name.
fn one_result_each(sequences: &[Sequence<'_>]) -> Result<(), SenseError> {
    let mut taken: BTreeMap<PathBuf, &Path> = BTreeMap::new();
    for file in sequences.iter().flat_map(|sequence| &sequence.files) {
        let result = file
            .results
            .path("depth_sensor_distance", "depth_sensor_distance", "npy");
        if let Some(other) = taken.insert(result.clone(), &file.path) {
            let message = format!(
                "output path collision: {} also writes {}",
                other.display(),
                result.display()
            );
            return Err(FileError::new(
                &file.path,
                message,
                "process them one by one, each with its own output folder",
            )
            .into());
        }
    }
    Ok(())
}
