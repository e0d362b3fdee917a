//! Recordings: the files of each distance, and the true distances.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::FitError;
use crate::accuracy::distances;
use crate::accuracy::measured::{self, MeasuredCurve};
use crate::table::{self, wrong};
use oaktwin_base::diagnostic::nearest;
use oaktwin_files::FileError;
use oaktwin_pipeline::input::name::Name;
use oaktwin_pipeline::input::reader::DepthImageReader;
use oaktwin_pipeline::input::replicator;
use oaktwin_pipeline::sense::InputKind;

/// The name of the table of distances in a folder.
pub const TABLE: &str = "distances.csv";

const SENSED: &str = "depth_sensor_distance";
const EXTENSIONS: [&str; 7] = ["npy", "npz", "png", "exr", "pfm", "tif", "tiff"];

/// What is fitted to.
#[derive(Clone, Copy, Debug)]
pub enum Recordings<'a> {
    /// Files and folders.
    Files(&'a [PathBuf]),
    /// Images in memory.
    Images(&'a [TargetImages]),
}

/// Images of a target, in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetImages {
    /// The depth of the target along the optical axis, metres.
    pub distance_m: f64,
    /// The images in chronological order, as the bytes of an NPY file of (N, H, W).
    pub npy: Arc<[u8]>,
}

impl<'a> From<&'a Vec<PathBuf>> for Recordings<'a> {
    fn from(paths: &'a Vec<PathBuf>) -> Self {
        Self::Files(paths)
    }
}

impl Recordings<'_> {
    /// The names for reports.
    pub(super) fn names(&self) -> Vec<String> {
        match self {
            Self::Files(paths) => paths.iter().map(|path| path.display().to_string()).collect(),
            Self::Images(all) => all.iter().map(TargetImages::name).collect(),
        }
    }

    /// Reads the inputs; see [`open`].
    pub(super) fn open(&self, prim: &str) -> Result<Recording, FitError> {
        let images = match self {
            Self::Files(paths) => return open(paths, prim),
            Self::Images(images) => images,
        };
        let mut images = images.to_vec();
        images.sort_by(|a, b| a.distance_m.total_cmp(&b.distance_m));
        if let Some(wrong) = images
            .iter()
            .find(|one| !(one.distance_m > 0.0 && one.distance_m.is_finite()))
        {
            let what = format!("{} is no distance; give metres above 0", wrong.name());
            return Err(FitError::Option(format!("recordings: {what}").into()));
        }
        let target = |one: TargetImages| TargetRecording {
            name: one.name(),
            distance_m: Some(one.distance_m),
            files: vec![Files {
                sensed: one.name().into(),
                npy: Some(one.npy),
                truth: None,
            }],
        };
        Ok(Recording::Targets(images.into_iter().map(target).collect()))
    }
}

impl TargetImages {
    fn name(&self) -> String {
        format!("images at {} m", self.distance_m)
    }
}

/// The content of the inputs.
pub(super) enum Recording {
    /// Errors over distance, without images.
    Curve(PathBuf, MeasuredCurve),
    /// Images in order of distance.
    Targets(Vec<TargetRecording>),
}

/// Images of a static target, or with the ground truth of each.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TargetRecording {
    /// The path to report.
    pub(super) name: String,
    /// The depth along the optical axis in metres, if it is known.
    pub(super) distance_m: Option<f64>,
    /// The images in chronological order.
    pub(super) files: Vec<Files>,
}

/// A measured image and its ground truth.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Files {
    /// The file, or what images in memory are called.
    pub(super) sensed: PathBuf,
    /// The content of images in memory.
    pub(super) npy: Option<Arc<[u8]>>,
    /// The true depth along the optical axis in metres.
    pub(super) truth: Option<PathBuf>,
}

/// A file or folder and its images.
type Named = (PathBuf, Vec<Files>);

/// Reads the inputs: one curve, or images. In a folder with several cameras, `prim` selects the camera.
pub(super) fn open(paths: &[PathBuf], prim: &str) -> Result<Recording, FitError> {
    let mut recordings: Vec<TargetRecording> = Vec::new();
    let mut distances: BTreeMap<u64, Vec<Named>> = BTreeMap::new();
    for path in paths {
        let is_table = path
            .extension()
            .is_some_and(|extension| extension.eq_ignore_ascii_case("csv"));
        if is_table && !table::has_column(&table::text(path, "a table of distances")?, "file") {
            let curve = measured::read(path).map_err(|error| FitError::Option(error.to_string().into()))?;
            if paths.len() > 1 {
                return Err(FitError::Option(
                    format!(
                        "{}: an error curve cannot be combined with other recordings; give it alone",
                        path.display()
                    )
                    .into(),
                ));
            }
            return Ok(Recording::Curve(path.clone(), curve));
        }
        let table = if is_table { path.clone() } else { path.join(TABLE) };
        if is_table || table.is_file() {
            for (distance_m, of) in listed(&table)? {
                distances.entry(distance_m.to_bits()).or_default().push(of);
            }
        } else if path.is_dir() {
            recordings.extend(folder(path, prim)?);
        } else {
            recordings.push(TargetRecording {
                name: path.display().to_string(),
                distance_m: None,
                files: vec![alone(path.clone())],
            });
        }
    }
    // The bit patterns of positive numbers are in the order of the numbers.
    for (bits, of) in distances {
        let name = match &of[..] {
            [(name, _)] => name.display().to_string(),
            [(first, _), ..] => format!("{} and {} more", first.display(), of.len() - 1),
            [] => continue,
        };
        recordings.push(TargetRecording {
            name,
            distance_m: Some(f64::from_bits(bits)),
            files: of.into_iter().flat_map(|(_, files)| files).collect(),
        });
    }
    Ok(Recording::Targets(recordings))
}

fn alone(sensed: PathBuf) -> Files {
    Files {
        sensed,
        npy: None,
        truth: None,
    }
}

impl Files {
    /// Opens the measured images. Integer pixels are multiplied by `unit_m`.
    pub(super) fn open(&self, unit_m: f64) -> Result<DepthImageReader, FileError> {
        match &self.npy {
            None => DepthImageReader::open(&self.sensed, unit_m),
            Some(npy) => {
                let (reader, length) = (Cursor::new(Arc::clone(npy)), npy.len() as u64);
                DepthImageReader::read(&self.sensed, Box::new(reader), Some(length), unit_m)
            }
        }
    }
}

/// Returns the rows of a table of distances: the distance in metres, and the file or folder of images.
fn listed(file: &Path) -> Result<Vec<(f64, Named)>, FileError> {
    let text = table::text(file, "a table of distances")?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let in_table = |wrong: table::TableProblem| wrong.of(file);
    let mut seen = BTreeMap::new();
    let mut all = Vec::new();
    for row in table::rows(&text, ["file", "distance_m"]).map_err(in_table)? {
        let name = row.fields[0].as_str();
        let line = row.line;
        if name.is_empty() {
            let what = format!("line {line}: file: the name is missing");
            return Err(in_table(wrong(what, "name a file or folder beside the table")));
        }
        let distance_m = distances::in_row(&row, 1).map_err(in_table)?;
        if let Some(before) = seen.insert(name.to_owned(), line) {
            let what = format!("line {line}: {name} is also in line {before}");
            return Err(in_table(wrong(what, "remove one of them")));
        }
        let path = folder.join(name);
        let images = if path.is_dir() {
            let images = images(&path)?;
            if images.is_empty() {
                return Err(nothing(&path));
            }
            images
        } else if path.is_file() {
            vec![path.clone()]
        } else {
            let names = names(folder)?;
            let near = nearest(name, names.iter().map(String::as_str));
            let remedy = if near.is_empty() {
                "name files and folders that lie beside the table".to_owned()
            } else {
                format!("did you mean {}?", near.join(" or "))
            };
            let what = format!("line {line}: there is no {}", path.display());
            return Err(in_table(wrong(what, remedy)));
        };
        all.push((distance_m, (path, images.into_iter().map(alone).collect())));
    }
    Ok(all)
}

/// Reads a folder without a table: with ground truth beside the sensor's images, or images alone.
fn folder(path: &Path, prim: &str) -> Result<Vec<TargetRecording>, FileError> {
    let Ok(cameras) = replicator::cameras(path) else {
        let files = images(path)?;
        if files.is_empty() {
            return Err(nothing(path));
        }
        return Ok(vec![TargetRecording {
            name: path.display().to_string(),
            distance_m: None,
            files: files.into_iter().map(alone).collect(),
        }]);
    };
    let is_of_sensor = |name: &Path| name == Path::new(prim);
    let any = cameras.iter().any(|camera| is_of_sensor(&camera.name));
    let mut recordings = Vec::new();
    for camera in cameras {
        if any && !is_of_sensor(&camera.name) {
            continue;
        }
        let own = path.join(&camera.name);
        let within = if camera.by_annotator {
            own.join(SENSED)
        } else {
            own.clone()
        };
        let mut files = Vec::new();
        for frame in camera.frames {
            let sensed = within.join(format!("{SENSED}_{}.npy", Name::of(&frame.depth).digits));
            if !sensed.is_file() {
                continue;
            }
            if frame.kind != InputKind::Z {
                return Err(FileError::new(
                    &frame.depth,
                    "is the distance from the camera, but depth along the optical axis is required",
                    "render distance_to_image_plane",
                ));
            }
            files.push(Files {
                sensed,
                npy: None,
                truth: Some(frame.depth),
            });
        }
        if !files.is_empty() {
            recordings.push(TargetRecording {
                name: own.display().to_string(),
                distance_m: None,
                files,
            });
        }
    }
    if recordings.is_empty() {
        return Err(FileError::new(
            path,
            format!("contains ground truth but no output of a depth sensor ({SENSED}_0000.npy)"),
            format!("name the sensor's own recording, with a {TABLE} of file,distance_m"),
        ));
    }
    Ok(recordings)
}

fn nothing(path: &Path) -> FileError {
    FileError::new(
        path,
        "contains no depth images",
        format!(
            "give NPY, NPZ, 16-bit PNG, TIFF, EXR or PFM files, and a {TABLE} of file,distance_m beside them"
        ),
    )
}

/// Returns the depth images of a folder by name, only the depth sensor's if the names distinguish them.
fn images(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let is_image = |path: &PathBuf| {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        EXTENSIONS.iter().any(|known| extension == *known)
    };
    let mut images: Vec<(Name, PathBuf)> = replicator::files(folder)?
        .into_iter()
        .filter(is_image)
        .map(|path| (Name::of(&path), path))
        .filter(|(name, _)| name.base != "rgb")
        .collect();
    let is_sensed = |(name, path): &(Name, PathBuf)| {
        name.base.ends_with(SENSED) && path.extension().is_some_and(|extension| extension == "npy")
    };
    if images.iter().any(is_sensed) {
        images.retain(is_sensed);
    }
    // Chronologically: by number first, so that 10 follows 9.
    images.sort_by(|(a, a_path), (b, b_path)| (&a.base, a.number, a_path).cmp(&(&b.base, b.number, b_path)));
    Ok(images.into_iter().map(|(_, path)| path).collect())
}

fn names(folder: &Path) -> Result<Vec<String>, FileError> {
    let entries = replicator::entries(folder)?;
    let name = |path: PathBuf| path.file_name().map(|name| name.to_string_lossy().into_owned());
    Ok(entries.into_iter().filter_map(name).collect())
}
