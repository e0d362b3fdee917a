//! What somebody recorded: which files are of which distance, and what is known of the truth.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::FitError;
use crate::accuracy::distances;
use crate::accuracy::measured::{self, Curve};
use crate::table::{self, wrong};
use oaktwin_diagnostic::nearest;
use oaktwin_files::FileError;
use oaktwin_pipeline::input::name::Name;
use oaktwin_pipeline::input::replicator;
use oaktwin_pipeline::sense::InputKind;

/// The table of distances in a folder.
pub const TABLE: &str = "distances.csv";

const SENSED: &str = "depth_sensor_distance";
const EXTENSIONS: [&str; 4] = ["npy", "png", "exr", "pfm"];

/// All that was given.
pub(super) enum Recording {
    /// Errors over distance, without images.
    Curve(PathBuf, Curve),
    /// Images, near to far.
    Stands(Vec<Stand>),
}

/// Images of a target that stood still, or with their truth beside them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stand {
    /// For people.
    pub(super) name: String,
    /// Along the optical axis, m, where it is known.
    pub(super) distance_m: Option<f64>,
    /// In the order of time.
    pub(super) files: Vec<Files>,
}

/// What a sensor reported, and what was there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Files {
    pub(super) sensed: PathBuf,
    /// Depth along the axis, m.
    pub(super) truth: Option<PathBuf>,
}

/// A file or folder, and its images.
type Named = (PathBuf, Vec<Files>);

/// Reads what was given: one curve, or images. Of a folder by camera, that of `prim` where there is one.
pub(super) fn open(paths: &[PathBuf], prim: &str) -> Result<Recording, FitError> {
    let mut stands: Vec<Stand> = Vec::new();
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
            stands.extend(folder(path, prim)?);
        } else {
            stands.push(Stand {
                name: path.display().to_string(),
                distance_m: None,
                files: vec![alone(path.clone())],
            });
        }
    }
    // Bits of numbers above 0 are in their order.
    for (bits, of) in distances {
        let name = match &of[..] {
            [(name, _)] => name.display().to_string(),
            [(first, _), ..] => format!("{} and {} more", first.display(), of.len() - 1),
            [] => continue,
        };
        stands.push(Stand {
            name,
            distance_m: Some(f64::from_bits(bits)),
            files: of.into_iter().flat_map(|(_, files)| files).collect(),
        });
    }
    Ok(Recording::Stands(stands))
}

fn alone(sensed: PathBuf) -> Files {
    Files { sensed, truth: None }
}

/// The rows of a table of distances: of each the distance, m, and the file or folder with its images.
fn listed(file: &Path) -> Result<Vec<(f64, Named)>, FileError> {
    let text = table::text(file, "a table of distances")?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let in_table = |wrong: table::Wrong| wrong.of(file);
    let mut seen = BTreeMap::new();
    let mut all = Vec::new();
    for row in table::rows(&text, ["file", "distance_m"]).map_err(in_table)? {
        let name = row.fields[0].as_str();
        let line = row.line;
        if name.is_empty() {
            let what = format!("line {line}: file: there is no name");
            return Err(in_table(wrong(what, "name a file or folder beside the table")));
        }
        let distance_m = distances::in_row(&row, 1).map_err(in_table)?;
        if let Some(before) = seen.insert(name.to_owned(), line) {
            let what = format!("line {line}: {name} stands in line {before} too");
            return Err(in_table(wrong(what, "leave one of them out")));
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
                "name files and folders as they are beside the table".to_owned()
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

/// A folder without a table: with ground truth beside the sensor's images, or images alone.
fn folder(path: &Path, prim: &str) -> Result<Vec<Stand>, FileError> {
    let Ok(cameras) = replicator::cameras(path) else {
        let files = images(path)?;
        if files.is_empty() {
            return Err(nothing(path));
        }
        return Ok(vec![Stand {
            name: path.display().to_string(),
            distance_m: None,
            files: files.into_iter().map(alone).collect(),
        }]);
    };
    let is_of_sensor = |name: &Path| name == Path::new(prim);
    let any = cameras.iter().any(|camera| is_of_sensor(&camera.name));
    let mut stands = Vec::new();
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
                    "is the distance from the camera, and the truth is needed along its axis",
                    "render distance_to_image_plane",
                ));
            }
            files.push(Files {
                sensed,
                truth: Some(frame.depth),
            });
        }
        if !files.is_empty() {
            stands.push(Stand {
                name: own.display().to_string(),
                distance_m: None,
                files,
            });
        }
    }
    if stands.is_empty() {
        return Err(FileError::new(
            path,
            format!("holds ground truth and nothing that a sensor reported: no {SENSED}_0000.npy"),
            format!("name the sensor's own recording, with a {TABLE} of file,distance_m"),
        ));
    }
    Ok(stands)
}

fn nothing(path: &Path) -> FileError {
    FileError::new(
        path,
        "holds no depth images",
        format!("give NPY, 16-bit PNG, EXR or PFM files, and a {TABLE} of file,distance_m beside them"),
    )
}

/// The depth images in a folder by name: what a sensor reported where names say so.
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
    // In time: by number first, so that 10 comes after 9.
    images.sort_by(|(a, a_path), (b, b_path)| (&a.base, a.number, a_path).cmp(&(&b.base, b.number, b_path)));
    Ok(images.into_iter().map(|(_, path)| path).collect())
}

fn names(folder: &Path) -> Result<Vec<String>, FileError> {
    let entries = replicator::entries(folder)?;
    let name = |path: PathBuf| path.file_name().map(|name| name.to_string_lossy().into_owned());
    Ok(entries.into_iter().filter_map(name).collect())
}
