//! The cameras of a scene file.

use std::path::Path;

use oaktwin_render::Clip;

use super::camera::{CameraAttributes, CameraError, DepthSensorSource, PlacedCamera};
use super::scene_file::SceneFile;
use super::{around, folder_names};
use crate::limits::check_size;
use oaktwin_base::diagnostic::{Finding, Level, fold_name, message, nearest, opt};
use oaktwin_camera::{ImageSize, RigidTransform};
use oaktwin_depth::imager::Photosites;
use oaktwin_usd::depth_sensor;
use oaktwin_usd::optics::{self, OpticsError, Projection};
use oaktwin_usd::stage::{RenderProduct, SceneCamera};

/// The largest pitch of photosites, µm: the default aperture of a camera would give pixels of 16 µm.
const MAX_PITCH_UM: f64 = 3.0;

/// The cameras of a scene to render.
#[derive(Clone, Copy, Debug, Default)]
pub struct SceneCameraOptions<'a> {
    /// The cameras by path or unique name; the path or name of a render product selects its camera. If empty, the camera of
    /// every depth sensor's product, else every camera.
    pub cameras: &'a [String],
    /// The image size of every camera; by default its product's, else
    /// [its apertures'](optics::default_size).
    pub size: Option<ImageSize>,
    /// The interpretation of apertures.
    pub projection: Projection,
}

/// A camera, by its own path or its render product's.
#[derive(Clone, Copy)]
struct Candidate<'a> {
    path: &'a str,
    camera: &'a SceneCamera,
    /// The source of the resolution.
    product: Option<&'a RenderProduct>,
}

impl<'a> Candidate<'a> {
    fn camera(scene: &'a SceneFile, camera: &'a SceneCamera) -> Self {
        let shows_it = |product: &&RenderProduct| {
            camera_of(scene, product).is_some_and(|shown| shown.prim.path == camera.prim.path)
        };
        // Prefers the product of a depth sensor.
        let shown_by = || scene.products.iter().filter(shows_it);
        Self {
            path: &camera.prim.path,
            camera,
            product: shown_by()
                .find(|product| optics::is_depth_product(product, None))
                .or_else(|| shown_by().next()),
        }
    }
}

/// Returns the cameras of a scene and the findings. A camera that cannot be rendered is skipped with a warning unless it was
/// selected by name.
///
/// # Errors
/// Returns an error if a name is unknown or ambiguous, the scene has no camera, or a selected camera cannot be rendered.
pub fn scene_cameras(
    scene: &SceneFile,
    options: &SceneCameraOptions<'_>,
) -> Result<(Vec<PlacedCamera>, Vec<Finding>), CameraError> {
    let mut findings = Vec::new();
    let chosen = if options.cameras.is_empty() {
        all(scene, &mut findings)
    } else {
        named(scene, options.cameras)?
    };
    if chosen.is_empty() {
        return Err(CameraError::NoCamera {
            file: scene.path.display().to_string(),
            remedy: message![
                "add an OAK with ",
                opt("model").with("OAK-D-Pro-PoE"),
                " and ",
                opt("look-at").with(around::look_at(&scene.scene))
            ],
        });
    }
    let mut cameras = Vec::new();
    let mut first_error = None;
    for candidate in &chosen {
        match place(&scene.path, scene.scene.meters_per_unit.0, candidate, options) {
            Ok((camera, more)) => {
                cameras.push(camera);
                findings.extend(more);
            }
            Err(CameraError::Optics { error, file }) if options.cameras.is_empty() => {
                findings.push(left_out(&error));
                first_error.get_or_insert(CameraError::Optics { error, file });
            }
            Err(error) => return Err(error),
        }
    }
    if let (true, Some(error)) = (cameras.is_empty(), first_error) {
        return Err(error);
    }
    let folders = {
        let paths = cameras.iter().map(|camera| camera.path.as_str());
        folder_names(paths)
    };
    for (camera, folder) in cameras.iter_mut().zip(folders) {
        camera.folder = folder;
    }
    Ok((cameras, findings))
}

fn left_out(error: &OpticsError) -> Finding {
    Finding::new(
        "camera-left-out",
        Level::Warning,
        &error.prim,
        format!("{}: the camera is skipped", error.what),
        error.remedy,
    )
}

/// The products of depth sensors that have a camera, else every camera.
fn all<'a>(scene: &'a SceneFile, findings: &mut Vec<Finding>) -> Vec<Candidate<'a>> {
    let mut chosen = Vec::new();
    for product in &scene.products {
        let camera = camera_of(scene, product);
        if !optics::is_depth_product(product, camera) {
            continue;
        }
        match camera {
            Some(camera) => chosen.push(Candidate {
                camera,
                path: &product.prim.path,
                product: Some(product),
            }),
            None => findings.push(Finding::new(
                "product-without-camera",
                Level::Warning,
                &product.prim.path,
                "the `camera` relationship has no camera as its target; the product is skipped",
                "set exactly one Camera as its target",
            )),
        }
    }
    if chosen.is_empty() {
        chosen.extend(
            scene
                .cameras
                .iter()
                .map(|camera| Candidate::camera(scene, camera)),
        );
    }
    chosen
}

/// The one camera of a product.
fn camera_of<'a>(scene: &'a SceneFile, product: &RenderProduct) -> Option<&'a SceneCamera> {
    let [target] = &product.cameras[..] else {
        return None;
    };
    scene
        .cameras
        .iter()
        .find(|camera| camera.prim.path == target.path)
}

/// The cameras with these names, without duplicates.
fn named<'a>(scene: &'a SceneFile, names: &[String]) -> Result<Vec<Candidate<'a>>, CameraError> {
    let cameras = scene
        .cameras
        .iter()
        .map(|camera| Candidate::camera(scene, camera));
    let products = scene.products.iter().filter_map(|product| {
        Some(Candidate {
            path: &product.prim.path,
            camera: camera_of(scene, product)?,
            product: Some(product),
        })
    });
    let candidates: Vec<Candidate<'a>> = cameras.chain(products).collect();
    if candidates.is_empty() {
        return Ok(candidates);
    }
    let mut chosen: Vec<Candidate<'a>> = Vec::new();
    for name in names {
        let found = find(scene, name, &candidates)?;
        if !chosen.iter().any(|one| one.path == found.path) {
            chosen.push(found);
        }
    }
    Ok(chosen)
}

fn find<'a>(
    scene: &SceneFile,
    name: &str,
    candidates: &[Candidate<'a>],
) -> Result<Candidate<'a>, CameraError> {
    if let Some(exact) = candidates.iter().find(|one| one.path == name) {
        return Ok(*exact);
    }
    let wanted = fold_name(name);
    let last = |path: &str| path.rsplit('/').next().map(fold_name);
    let matching: Vec<&Candidate<'a>> = candidates
        .iter()
        .filter(|one| last(one.path).as_ref() == Some(&wanted))
        .collect();
    let place = || scene.path.display().to_string();
    match matching[..] {
        [one] => Ok(*one),
        [] => {
            let paths = || candidates.iter().map(|one| one.path);
            let names = paths().filter_map(|path| path.rsplit('/').next());
            let mut near = nearest(name, paths());
            if near.is_empty() {
                near = nearest(name, names);
                near.dedup();
            }
            Err(CameraError::Unknown {
                place: place(),
                name: name.to_owned(),
                nearest: near.into_iter().map(str::to_owned).collect(),
                known: paths().take(5).map(str::to_owned).collect(),
            })
        }
        _ => Err(CameraError::Ambiguous {
            place: place(),
            name: name.to_owned(),
            paths: matching.iter().map(|one| one.path.to_owned()).collect(),
        }),
    }
}

fn place(
    file: &Path,
    meters_per_unit: f64,
    candidate: &Candidate<'_>,
    options: &SceneCameraOptions<'_>,
) -> Result<(PlacedCamera, Vec<Finding>), CameraError> {
    let (camera, path) = (candidate.camera, candidate.path);
    let unusable = |error| CameraError::Optics {
        file: file.display().to_string(),
        error,
    };
    let size = match options.size.or_else(|| candidate.product?.resolution()) {
        Some(size) => size,
        None => optics::default_size(camera).map_err(unusable)?,
    };
    check_size(size).map_err(|error| CameraError::Size {
        camera: path.to_owned(),
        error,
    })?;
    let (seen, mut findings) = optics::camera(camera, size, options.projection).map_err(unusable)?;
    let (range_m, odd) = optics::clipping_range_m(camera, meters_per_unit);
    findings.extend(odd);
    Ok((
        PlacedCamera {
            path: path.to_owned(),
            folder: String::new(),
            role: None,
            camera: seen,
            clip: range_m.map_or_else(Clip::default, |(near_m, far_m)| Clip { near_m, far_m }),
            mount_from_camera: RigidTransform::IDENTITY,
            world_from_mount: camera.world_from_camera,
            readout_s: None,
            photosites: Photosites {
                pitch_um: (camera.optics().horizontal_aperture_mm * 1e3 / f64::from(size.width))
                    .min(MAX_PITCH_UM),
                per_pixel: 1.0,
                is_monochrome: false,
            },
            attributes: CameraAttributes {
                optics: camera.optics(),
                focus_distance: camera.prim.number("focusDistance").unwrap_or(0.0),
                f_stop: camera.f_stop(),
            },
            depth_sensor: depth_sensor::of_product(candidate.product, Some(camera)).map(|sensor| {
                DepthSensorSource::Stage {
                    camera: camera.prim.name().to_owned(),
                    sensor: Box::new(sensor),
                }
            }),
        },
        findings,
    ))
}

#[cfg(test)]
mod tests;
