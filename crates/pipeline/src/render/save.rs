use std::path::Path;

use oaktwin_files::{self as files, FileError};
use oaktwin_scene::Scene;
use oaktwin_usd::scene_file::scene_file;

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
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let saved = scene_file(scene, &format!("{name}_textures")).map_err(|error| error.in_file(path))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    for (image, bytes) in &saved.images {
        let image = folder.join(image.trim_start_matches("./"));
        if let Some(parent) = image.parent() {
            files::make_folder(parent)?;
        }
        files::write(&image, bytes)?;
    }
    files::write(path, saved.layer.text().as_bytes())
}
