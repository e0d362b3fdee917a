//! Frame after frame: rendered, encoded and written, the next one rendered while the last is written.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::mpsc;
use std::thread;

use oaktwin_render::{Backend, Renderer, View};

use super::camera::PlacedCamera;
use super::output_folder::OutputFolder;
use super::trajectory::TimedPose;
use crate::camera::RigidTransform;
use crate::diagnostic::{Finding, Level};
use crate::files::FileError;
use crate::image::annotation::{Annotator, Frame};

/// What to render, and into which files.
#[derive(Clone, Copy, Debug)]
pub struct FrameOptions<'a> {
    /// What to render.
    pub annotators: &'a [Annotator],
    /// How to find what a pixel sees.
    pub backend: Backend,
    /// Whether a warning of the renderer is an error.
    pub strict: bool,
}

/// What was written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// Frames of which every camera's files are there.
    pub frames: usize,
    /// The files, in the order of frames, then cameras.
    pub files: Vec<WrittenFile>,
    /// What the renderer had to say, each once.
    pub findings: Vec<Finding>,
    /// Whether the caller asked to stop before the end.
    pub is_interrupted: bool,
}

/// A file that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its length.
    pub bytes: u64,
}

/// How far it is: images that are rendered, of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Done {
    /// So many are rendered.
    pub images: u64,
    /// Of so many.
    pub of: u64,
}

/// Why frames could not be written. The files before it are whole, and stay.
#[derive(Debug, thiserror::Error)]
pub enum FramesError {
    /// A file could not be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A warning of the renderer, with [`FrameOptions::strict`].
    #[error("{0}")]
    Strict(Finding),
}

/// An image on its way to its files.
struct Rendered<'a> {
    camera: &'a PlacedCamera,
    number: usize,
    view: View,
    frame: Frame,
}

/// Renders a frame for each pose of `path`, or the one where the cameras stand where `path` is empty, with every camera,
/// and writes it. `watch` is asked before each image and after it; where it breaks, what is rendered then is dropped.
///
/// One camera's files go into the folder itself, those of several into a folder each.
///
/// # Errors
/// A file cannot be written, or there is a warning where none may be.
pub fn write_frames(
    renderer: &Renderer,
    cameras: &[PlacedCamera],
    path: &[TimedPose],
    options: &FrameOptions<'_>,
    folder: &mut OutputFolder,
    watch: &mut dyn FnMut(Done) -> ControlFlow<()>,
) -> Result<Written, FramesError> {
    let poses: Vec<Option<&RigidTransform>> = if path.is_empty() {
        vec![None]
    } else {
        path.iter().map(|pose| Some(&pose.world_from_mount)).collect()
    };
    let jobs = poses
        .iter()
        .enumerate()
        .flat_map(|(number, pose)| cameras.iter().map(move |camera| (number, *pose, camera)));
    let mut done = Done {
        images: 0,
        of: poses.len() as u64 * cameras.len() as u64,
    };
    let mut findings: Vec<Finding> = Vec::new();
    let mut stop = None;
    // The writer takes an image when it has written the one before: never more than two are there.
    let (sender, receiver) = mpsc::sync_channel::<Rendered<'_>>(0);
    let (files, images) = thread::scope(|scope| {
        let writer = scope.spawn(|| write_all(receiver, folder, cameras.len() > 1, options));
        for (number, pose, camera) in jobs {
            if watch(done).is_break() {
                stop = Some(Ok(()));
                break;
            }
            let view = camera.view(pose.unwrap_or(&camera.world_from_mount));
            let (frame, more) = annotate(renderer, &view, options);
            done.images += 1;
            if let Some(warning) = more
                .iter()
                .find(|one| options.strict && one.level >= Level::Warning)
            {
                stop = Some(Err(FramesError::Strict(warning.clone())));
                break;
            }
            for finding in more {
                if !findings.contains(&finding) {
                    findings.push(finding);
                }
            }
            let is_interrupted = watch(done).is_break() && done.images < done.of;
            let rendered = Rendered {
                camera,
                number,
                view,
                frame,
            };
            if is_interrupted {
                stop = Some(Ok(()));
                break;
            }
            // The writer is gone only when it failed, which it says below.
            if sender.send(rendered).is_err() {
                break;
            }
        }
        drop(sender);
        writer
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })?;
    let is_interrupted = match stop {
        Some(Err(error)) => return Err(error),
        Some(Ok(())) => true,
        None => false,
    };
    Ok(Written {
        frames: images.checked_div(cameras.len()).unwrap_or(0),
        files,
        findings,
        is_interrupted,
    })
}

/// Writes images until there are no more; the files, and the number of images.
fn write_all(
    images: mpsc::Receiver<Rendered<'_>>,
    folder: &mut OutputFolder,
    in_folders: bool,
    options: &FrameOptions<'_>,
) -> Result<(Vec<WrittenFile>, usize), FileError> {
    let mut files = Vec::new();
    let mut count = 0;
    for image in images {
        let own = if in_folders {
            PathBuf::from(&image.camera.folder)
        } else {
            PathBuf::new()
        };
        for (name, bytes) in encode(&image, options) {
            files.push(WrittenFile {
                path: folder.write(&own.join(name), &bytes)?,
                bytes: bytes.len() as u64,
            });
        }
        count += 1;
    }
    Ok((files, count))
}

fn annotate(renderer: &Renderer, view: &View, options: &FrameOptions<'_>) -> (Frame, Vec<Finding>) {
    let frame = Frame {
        distance_to_image_plane: Some(renderer.depth(view, options.backend)),
        ..Frame::default()
    };
    (frame, Vec::new())
}

fn encode(image: &Rendered<'_>, _options: &FrameOptions<'_>) -> Vec<(String, Vec<u8>)> {
    let _ = image.view;
    let Some(depth) = &image.frame.distance_to_image_plane else {
        return Vec::new();
    };
    let shape = [depth.0.height() as usize, depth.0.width() as usize];
    vec![(
        format!("distance_to_image_plane_{:04}.npy", image.number),
        crate::image::npy::encode(&shape, depth.0.pixels()).unwrap_or_default(),
    )]
}
