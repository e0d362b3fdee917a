use std::path::{Path, PathBuf};

use oaktwin_files::{self as files, FileError};
use oaktwin_scene::Scene;
use oaktwin_usd::scene_file::{ImageFiles, scene_file};

/// Checks that a scene can be written to a file of this name.
///
/// # Errors
/// Returns an error for an extension other than `.usda` and `.usd`.
pub fn check_saved_name(path: &Path) -> Result<(), FileError> {
    let extension = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    if ["usda", "usd"].contains(&extension.as_str()) {
        return Ok(());
    }
    Err(FileError::new(
        path,
        "scenes are written in USD's text format",
        "use a name that ends in .usda or .usd",
    ))
}

/// Writes a scene as a USD file in the text format, and its images to a folder `NAME_textures` beside it.
///
/// # Errors
/// Returns an error for an extension other than `.usda` and `.usd`, for a texture that cannot be decoded, and if a file cannot be
/// written.
pub fn save_usd(scene: &Scene, path: &Path) -> Result<(), FileError> {
    check_saved_name(path)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    for (file, bytes) in usd_files(scene, path, ImageFiles::Referenced)? {
        let file = folder.join(file);
        if let Some(parent) = file.parent() {
            files::make_folder(parent)?;
        }
        files::write(&file, &bytes)?;
    }
    Ok(())
}

/// Returns the files of [`save_usd`] relative to the folder of `path`, the USD file last.
///
/// # Errors
/// Returns an error for a texture that cannot be decoded, or copied.
pub fn usd_files(
    scene: &Scene,
    path: &Path,
    files: ImageFiles,
) -> Result<Vec<(PathBuf, Vec<u8>)>, FileError> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let saved = scene_file(scene, &format!("{name}_textures"), files).map_err(|error| error.in_file(path))?;
    let images = saved.images.into_iter();
    let mut files: Vec<(PathBuf, Vec<u8>)> = images
        .map(|(image, bytes)| (image.trim_start_matches("./").into(), bytes))
        .collect();
    let own = path.file_name().unwrap_or_default().into();
    files.push((own, saved.layer.text().into_bytes()));
    Ok(files)
}
