//! The arranged scenes of a data set as USD.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oaktwin_files::{self as files, FileError};
use oaktwin_pipeline::render::usd_files;
use oaktwin_scene::{Scene, TextureSource};

use crate::GenerateError;
use crate::arrange::Stage;

/// The folder of the scenes in a data set.
const FOLDER: &str = "scenes";

/// The maximum size of an image file.
const MAX_BYTES: u64 = 1 << 30;

/// Returns the files of an arrangement relative to the data set: `scenes/NUMBER.usda`, and its images beside it.
pub(crate) fn scene_files(stage: &Stage, number: u64) -> Result<Vec<(PathBuf, Vec<u8>)>, GenerateError> {
    let scene = with_images(stage.renderer().scene())?;
    let files = usd_files(&scene, Path::new(&format!("{number:06}.usda")))?;
    Ok(files
        .into_iter()
        .map(|(path, bytes)| (Path::new(FOLDER).join(path), bytes))
        .collect())
}

/// Returns a scene that contains its images, so that a data set can be moved. Images of other formats than PNG and JPEG stay where they are.
fn with_images(scene: &Scene) -> Result<Scene, GenerateError> {
    let mut scene = scene.clone();
    for texture in &mut scene.textures {
        let TextureSource::File(path) = &texture.source else {
            continue;
        };
        let extension = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        texture.source = if ["png", "jpg", "jpeg"].contains(&extension.as_str()) {
            let bytes = files::read_regular(path, MAX_BYTES);
            TextureSource::Encoded {
                name: path.display().to_string(),
                bytes: Arc::from(bytes.map_err(|error| FileError::reading(path, &error))?),
            }
        } else {
            let place = std::path::absolute(path).map_err(|error| FileError::reading(path, &error))?;
            TextureSource::File(place)
        };
    }
    Ok(scene)
}
