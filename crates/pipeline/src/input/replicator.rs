//! Folders in the layout of Replicator's `BasicWriter`: the files of one camera in the folder itself, the files of several in folders
//! by camera and annotator.

use std::fs;
use std::path::{Path, PathBuf};

use super::InputKind;
use super::name::Name;
use oaktwin_files::FileError;

/// The depth annotators in order of preference.
const DEPTH: [(&str, InputKind); 2] = [
    ("distance_to_image_plane", InputKind::Z),
    ("distance_to_camera", InputKind::Range),
];

/// The frames of a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraFolder {
    /// The path below the opened folder; empty for the folder itself.
    pub name: PathBuf,
    /// Whether each annotator has its own folder.
    pub by_annotator: bool,
    /// The frames, ordered by number.
    pub frames: Vec<FrameFiles>,
}

/// The files of one frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameFiles {
    /// The depth image.
    pub depth: PathBuf,
    /// The kind of depth.
    pub kind: InputKind,
    /// The colour image.
    pub rgb: Option<PathBuf>,
    /// `camera_params`.
    pub params: Option<PathBuf>,
}

/// Returns the cameras with depth images in a folder, ordered by name.
///
/// # Errors
/// Returns an error if the folder cannot be read or has no depth images.
pub fn cameras(folder: &Path) -> Result<Vec<CameraFolder>, FileError> {
    let mut found = Vec::new();
    if let Some(frames) = frames(folder, folder, folder, false)? {
        found.push(CameraFolder {
            name: PathBuf::new(),
            by_annotator: false,
            frames,
        });
    }
    for camera in folders(folder)? {
        let name = camera.file_name().map(PathBuf::from).unwrap_or_default();
        if let Some(frames) = frames(&camera, &camera, &camera, false)? {
            found.push(CameraFolder {
                name,
                by_annotator: false,
                frames,
            });
            continue;
        }
        let below = |annotator: &str| camera.join(annotator);
        for (annotator, _) in DEPTH {
            if let Some(frames) = frames(&below(annotator), &below("rgb"), &below("camera_params"), true)? {
                found.push(CameraFolder {
                    name: name.clone(),
                    by_annotator: true,
                    frames,
                });
                break;
            }
        }
    }
    if found.is_empty() {
        return Err(FileError::new(
            folder,
            "contains no depth images: no distance_to_image_plane_0000.npy or distance_to_camera_0000.npy",
            "name a folder of Replicator's BasicWriter or of oaktwin render, or the files themselves",
        ));
    }
    Ok(found)
}

/// The frames with depth in one folder; `None` if there are none.
fn frames(
    depth: &Path,
    rgb: &Path,
    params: &Path,
    may_be_missing: bool,
) -> Result<Option<Vec<FrameFiles>>, FileError> {
    if may_be_missing && !depth.is_dir() {
        return Ok(None);
    }
    let names = files(depth)?;
    for (annotator, kind) in DEPTH {
        let mut numbered: Vec<(u64, String, PathBuf)> = names
            .iter()
            .filter(|path| path.extension().is_some_and(|extension| extension == "npy"))
            .filter_map(|path| {
                let name = Name::of(path);
                let number = name.number.filter(|_| name.base == annotator)?;
                Some((number, name.digits, path.clone()))
            })
            .collect();
        if numbered.is_empty() {
            continue;
        }
        numbered.sort();
        let beside = |folder: &Path, annotator: &str, digits: &str, extension: &str| {
            let path = folder.join(format!("{annotator}_{digits}.{extension}"));
            path.is_file().then_some(path)
        };
        let frames = numbered.into_iter().map(|(_, digits, path)| FrameFiles {
            depth: path,
            kind,
            rgb: beside(rgb, "rgb", &digits, "png"),
            params: beside(params, "camera_params", &digits, "json"),
        });
        return Ok(Some(frames.collect()));
    }
    Ok(None)
}

/// Returns the sorted entries of a folder.
///
/// # Errors
/// Returns an error if the folder cannot be read.
pub fn entries(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let unreadable =
        |error: std::io::Error| FileError::new(folder, format!("cannot be read ({error})"), "check the path");
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        paths.push(entry.map_err(unreadable)?.path());
    }
    paths.sort();
    Ok(paths)
}

/// Returns the sorted files of a folder.
///
/// # Errors
/// Returns an error if the folder cannot be read.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    Ok(entries(folder)?
        .into_iter()
        .filter(|path| path.is_file())
        .collect())
}

fn folders(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    Ok(entries(folder)?
        .into_iter()
        .filter(|path| path.is_dir())
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_both_layouts() {
        let root = tempfile::tempdir().unwrap();
        let put = |name: &str| {
            let path = root.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "").unwrap();
        };
        assert!(
            cameras(root.path())
                .unwrap_err()
                .to_string()
                .contains("contains no depth")
        );
        put("flat/distance_to_image_plane_0002.npy");
        put("flat/distance_to_image_plane_0010.npy");
        put("flat/distance_to_camera_0002.npy");
        put("flat/depth_sensor_distance_0002.npy");
        put("flat/rgb_0002.png");
        let flat = cameras(&root.path().join("flat")).unwrap();
        assert_eq!(
            (flat.len(), flat[0].by_annotator, flat[0].frames.len()),
            (1, false, 2)
        );
        assert!(flat[0].frames[0].rgb.is_some() && flat[0].frames[1].rgb.is_none());
        assert_eq!(flat[0].frames[0].kind, InputKind::Z);
        put("many/b/distance_to_camera/distance_to_camera_0000.npy");
        put("many/b/camera_params/camera_params_0000.json");
        put("many/a/distance_to_image_plane_0000.npy");
        put("many/c/rgb/rgb_0000.png");
        let many = cameras(&root.path().join("many")).unwrap();
        let names: Vec<_> = many.iter().map(|camera| camera.name.to_str().unwrap()).collect();
        assert_eq!(names, ["a", "b"]);
        assert!(many[1].by_annotator && many[1].frames[0].kind == InputKind::Range);
        assert!(many[1].frames[0].params.is_some());
    }
}
