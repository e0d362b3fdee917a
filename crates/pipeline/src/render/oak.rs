//! The cameras of an OAK in a scene.

use std::borrow::Cow;

use oaktwin_render::Clip;

use super::camera::{CameraAttributes, CameraError, DepthSensorSource, PlacedCamera};
use super::folder_names;
use crate::limits::check_size;
use oaktwin_base::diagnostic::{Finding, Level, fold_name, nearest};
use oaktwin_camera::{Camera, ImageSize, LensModel, RigidTransform, UsdOptics};
use oaktwin_catalog::{DepthKind, LensChoice, Origin, Twin, TwinCamera};
use oaktwin_depth::imager::Photosites;
use oaktwin_usd::asset::{AssetError, render_product_name};

/// The name for every depth sensor.
const DEPTH: &str = "depth";

/// The cameras of an OAK to render.
#[derive(Clone, Copy, Debug, Default)]
pub struct OakOptions<'a> {
    /// The cameras by role (`rgb`, `left`, `right`, `tof`), prim or depth sensor (`depth`, or `depth_stereo` and
    /// `depth_tof`). If empty, the camera of every depth sensor, as in a stage, or all cameras of a device without one.
    pub cameras: &'a [String],
    /// The lens of the left and right cameras of the wide models.
    pub lens: LensChoice,
    /// The image size, resized by `DepthAI`'s rule; by default the sensor's own.
    pub size: Option<ImageSize>,
}

/// A camera of the device, or the virtual one of a depth sensor.
struct Candidate<'a> {
    prim: &'a str,
    /// The role; of a depth sensor [`Twin::depth_role`].
    role: String,
    names: Vec<String>,
    is_depth: bool,
    camera: Cow<'a, TwinCamera>,
    clipping_range_m: (f64, f64),
    focus_distance: f64,
}

/// Returns the cameras of a twin with its body (x forward, y left, z up) at `world_from_body` in metres, and the findings.
///
/// The camera of a depth sensor is the rectified image's, as in an asset: [`Twin::depth_camera`].
///
/// # Errors
/// Returns an error if a name is not a camera's or an image size is invalid.
pub fn oak_cameras(
    twin: &Twin,
    world_from_body: &RigidTransform,
    options: &OakOptions<'_>,
) -> Result<(Vec<PlacedCamera>, Vec<Finding>), CameraError> {
    let candidates = candidates(twin);
    let mut chosen: Vec<&Candidate<'_>> = Vec::new();
    if options.cameras.is_empty() {
        let has_depth = candidates.iter().any(|candidate| candidate.is_depth);
        chosen.extend(
            candidates
                .iter()
                .filter(|candidate| candidate.is_depth || !has_depth),
        );
    }
    for name in options.cameras {
        let wanted = fold_name(name);
        let before = chosen.len();
        let mut known = false;
        for candidate in &candidates {
            if candidate.names.iter().any(|name| fold_name(name) == wanted) {
                known = true;
                if !chosen.iter().any(|one| one.prim == candidate.prim) {
                    chosen.push(candidate);
                }
            }
        }
        if !known && before == chosen.len() {
            return Err(unknown(twin, name, &candidates));
        }
    }
    let mut findings = Vec::new();
    let mut cameras = Vec::new();
    for candidate in &chosen {
        cameras.push(place(twin, candidate, world_from_body, options)?);
    }
    if options.lens == LensChoice::Fisheye {
        findings.extend(lens_findings(twin, &cameras));
    }
    let prims = chosen.iter().map(|candidate| candidate.prim);
    for (camera, folder) in cameras.iter_mut().zip(folder_names(prims)) {
        camera.folder = folder;
    }
    Ok((cameras, findings))
}

/// Checks that a model has the chosen lens.
///
/// # Errors
/// Returns an error if the lens is a fisheye and the model has none.
pub fn check_lens(twin: &Twin, lens: LensChoice) -> Result<(), AssetError> {
    let is_wide = twin
        .cameras
        .iter()
        .any(|camera| camera.spec.fisheye_hfov_deg.is_some());
    if lens == LensChoice::Fisheye && !is_wide {
        return Err(AssetError::NoFisheyeLens {
            model: twin.device.name.clone(),
        });
    }
    Ok(())
}

fn candidates(twin: &Twin) -> Vec<Candidate<'_>> {
    let own = twin.cameras.iter().map(|camera| Candidate {
        prim: &camera.spec.prim,
        role: camera.spec.role.to_string(),
        names: vec![camera.spec.role.to_string(), camera.spec.prim.clone()],
        is_depth: false,
        camera: Cow::Borrowed(camera),
        clipping_range_m: camera.spec.clipping_range_m,
        focus_distance: camera.spec.focus_distance,
    });
    let depth = twin.depth_sensors.iter().filter_map(|sensor| {
        let kind = match sensor.spec.kind {
            DepthKind::Stereo => "depth_stereo",
            DepthKind::Tof => "depth_tof",
        };
        let prim = &sensor.spec.prim;
        Some(Candidate {
            prim,
            role: twin.depth_role(sensor),
            names: vec![
                DEPTH.to_owned(),
                kind.to_owned(),
                twin.depth_role(sensor),
                prim.clone(),
                render_product_name(prim),
            ],
            is_depth: true,
            camera: Cow::Owned(twin.depth_camera(sensor)?),
            clipping_range_m: sensor.spec.clipping_range_m,
            focus_distance: sensor.spec.focus_distance,
        })
    });
    own.chain(depth).collect()
}

fn unknown(twin: &Twin, name: &str, candidates: &[Candidate<'_>]) -> CameraError {
    let names = || candidates.iter().flat_map(|c| c.names.iter().map(String::as_str));
    let mut known: Vec<String> = Vec::new();
    for candidate in candidates {
        let name = if candidate.is_depth {
            DEPTH
        } else {
            candidate.camera.spec.role.as_str()
        };
        if !known.iter().any(|one| one == name) {
            known.push(name.to_owned());
        }
    }
    let mut near: Vec<String> = nearest(name, names()).into_iter().map(str::to_owned).collect();
    near.dedup();
    CameraError::Unknown {
        place: twin.device.name.clone(),
        name: name.to_owned(),
        nearest: near,
        known,
    }
}

fn place(
    twin: &Twin,
    candidate: &Candidate<'_>,
    world_from_body: &RigidTransform,
    options: &OakOptions<'_>,
) -> Result<PlacedCamera, CameraError> {
    let own = match candidate.is_depth {
        true => Camera::new(candidate.camera.intrinsics, LensModel::Pinhole),
        false => twin.optics(&candidate.camera, options.lens),
    };
    let path = format!("{}/{}", twin.device.name, candidate.prim);
    let size = options.size.unwrap_or(own.intrinsics.size);
    check_size(size).map_err(|error| CameraError::Size {
        camera: path.clone(),
        error,
    })?;
    let intrinsics = if size == own.intrinsics.size {
        own.intrinsics
    } else {
        own.intrinsics.resized(size, true)
    };
    // The focal length in millimetres is constant, so pixels grow as the image shrinks.
    let focal_length_um = candidate.camera.pixel_size_um * own.intrinsics.mean_focal_length();
    let pixel_size_um = focal_length_um / intrinsics.mean_focal_length();
    let (near_m, far_m) = candidate.clipping_range_m;
    Ok(PlacedCamera {
        path,
        folder: String::new(),
        role: Some(candidate.role.clone()),
        camera: Camera::new(intrinsics, own.lens),
        clip: Clip { near_m, far_m },
        mount_from_camera: candidate.camera.body_from_camera,
        world_from_mount: *world_from_body,
        readout_s: Some(candidate.camera.readout_s),
        photosites: Photosites {
            pitch_um: candidate.camera.pixel_size_um,
            per_pixel: pixel_size_um / candidate.camera.pixel_size_um,
            is_monochrome: candidate.camera.is_monochrome,
        },
        attributes: CameraAttributes {
            optics: UsdOptics::from_intrinsics(&intrinsics, pixel_size_um, Default::default()),
            focus_distance: candidate.focus_distance,
            f_stop: candidate.camera.spec.f_stop,
        },
        depth_sensor: candidate
            .is_depth
            .then(|| DepthSensorSource::Twin(candidate.prim.to_owned())),
    })
}

fn lens_findings(twin: &Twin, cameras: &[PlacedCamera]) -> Option<Finding> {
    if twin.origin != Origin::Nominal {
        return Some(Finding::new(
            "lens-from-calibration",
            Level::Note,
            &twin.device.name,
            "the lens models of the calibration are used instead of the nominal fisheye",
            "",
        ));
    }
    let bent = cameras
        .iter()
        .any(|camera| matches!(camera.camera.lens, LensModel::OpenCvFisheye(_)));
    (!bent).then(|| {
        Finding::new(
            "no-fisheye-camera",
            Level::Note,
            &twin.device.name,
            "none of the rendered cameras has the fisheye lens; depth is a pinhole's",
            "choose the left or the right camera",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::math::DVec3;
    use oaktwin_camera::{OpenCv, PixelPoint, Usd};
    use oaktwin_catalog::Catalog;

    fn twin(model: &str) -> Twin {
        let catalog = Catalog::builtin();
        catalog.nominal(catalog.device(model).unwrap())
    }

    fn chosen(twin: &Twin, names: &[&str], options: OakOptions<'_>) -> Vec<PlacedCamera> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        let options = OakOptions {
            cameras: &names,
            ..options
        };
        oak_cameras(twin, &RigidTransform::IDENTITY, &options).unwrap().0
    }

    #[test]
    fn selects_all_depth_sensors_by_default() {
        let folders = |model| -> Vec<String> {
            let cameras = chosen(&twin(model), &[], OakOptions::default());
            cameras.into_iter().map(|camera| camera.folder).collect()
        };
        assert_eq!(folders("OAK4-D"), ["Camera_pseudo_depth"]);
        assert_eq!(
            folders("OAK-D ToF"),
            ["Camera_pseudo_depth_stereo", "Camera_pseudo_depth_tof"]
        );
        assert_eq!(folders("OAK-1"), ["Camera_rgb_imx378"]);
    }

    #[test]
    fn selects_cameras_by_role_prim_and_sensor() {
        let twin = twin("OAK-D ToF");
        let paths = |names: &[&str]| -> Vec<String> {
            let cameras = chosen(&twin, names, OakOptions::default());
            cameras.into_iter().map(|camera| camera.path).collect()
        };
        assert_eq!(paths(&["left", "LEFT"]).len(), 1);
        assert_eq!(paths(&["depth"]).len(), 2);
        assert_eq!(paths(&["depth-tof"]), ["OAK-D ToF/Camera_pseudo_depth_tof"]);
        assert_eq!(paths(&["tof"]), ["OAK-D ToF/Camera_tof_33d"]);
        let names = ["lefft".to_owned()];
        let options = OakOptions {
            cameras: &names,
            ..OakOptions::default()
        };
        let error = oak_cameras(&twin, &RigidTransform::IDENTITY, &options).unwrap_err();
        assert!(error.to_string().contains("did you mean 'left'"), "{error}");
    }

    #[test]
    fn places_cameras_relative_to_the_body() {
        let twin = twin("OAK-D Pro PoE");
        let left = &chosen(&twin, &["left"], OakOptions::default())[0];
        let body = crate::render::look_at(DVec3::new(0.0, 0.0, 1.0), DVec3::new(0.0, 5.0, 1.0), DVec3::Z);
        let view = left.view(&body.unwrap());
        // Looking along y, left is −x.
        assert!((view.world_from_camera.translation - DVec3::new(-0.0375, 0.0, 1.0)).length() < 1e-12);
        assert!((view.world_from_camera.rotation * DVec3::Z - DVec3::Y).length() < 1e-12);
        assert!((view.world_from_camera.rotation * DVec3::NEG_Y - DVec3::Z).length() < 1e-12);
    }

    #[test]
    fn resizes_by_the_rule_of_calibrations() {
        let twin = twin("OAK-D Pro PoE");
        let size = ImageSize::new(640, 480);
        let left = &chosen(
            &twin,
            &["left"],
            OakOptions {
                size: Some(size),
                ..OakOptions::default()
            },
        )[0];
        let full = twin.cameras[1].intrinsics;
        let c = left.camera.intrinsics.principal_point::<OpenCv>();
        assert!((left.camera.intrinsics.fx - full.fx / 2.0).abs() < 1e-9);
        assert_eq!(c, PixelPoint::new(319.75, 239.75));
        // The attributes describe the same camera.
        let said = left.attributes.optics.openusd_intrinsics(size);
        assert!((said.fx - left.camera.intrinsics.fx).abs() < 1e-9);
        assert!((said.principal_point::<Usd>().x - 320.25).abs() < 1e-9);
        let full_mm = UsdOptics::from_intrinsics(&full, twin.cameras[1].pixel_size_um, Default::default());
        assert!((left.attributes.optics.focal_length_mm - full_mm.focal_length_mm).abs() < 1e-9);
    }

    #[test]
    fn only_stereo_cameras_have_a_fisheye() {
        let twin = twin("OAK-D Pro W PoE");
        let options = OakOptions {
            lens: LensChoice::Fisheye,
            ..OakOptions::default()
        };
        let cameras = chosen(&twin, &["left", "rgb", "depth"], options);
        assert!(matches!(cameras[0].camera.lens, LensModel::OpenCvFisheye(_)));
        assert_eq!(cameras[1].camera.lens, LensModel::Pinhole);
        assert_eq!(cameras[2].camera.lens, LensModel::Pinhole);
        let (_, findings) = oak_cameras(&twin, &RigidTransform::IDENTITY, &options).unwrap();
        assert_eq!(findings[0].code, "no-fisheye-camera");
        assert!(check_lens(&self::twin("OAK4-D"), LensChoice::Fisheye).is_err());
    }

    #[test]
    fn rejects_empty_images() {
        let twin = twin("OAK4-D");
        let options = OakOptions {
            size: Some(ImageSize::new(0, 5)),
            ..OakOptions::default()
        };
        let error = oak_cameras(&twin, &RigidTransform::IDENTITY, &options).unwrap_err();
        assert!(error.to_string().contains("no pixel"), "{error}");
    }
}
