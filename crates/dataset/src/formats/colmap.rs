use std::collections::BTreeMap;
use std::path::PathBuf;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_files::OutputFiles;
use oaktwin_image::Image;
use serde_json::{Value, json};

use super::common::{FrameFiles, by_folder, in_product, quaternion, rgb, text};
use super::lens::{Lens, lens};
use crate::{Format, FrameCamera, Records, Shot, WriteError};

const NAME: &str = "colmap";
/// The maximum number of points of an image.
const MAX_POINTS: f64 = 1000.0;

/// COLMAP's text model with known poses, one folder for each sequence: `images/` and `sparse/0/{cameras,images,points3D,rigs,frames}.txt`.
/// The cameras of a frame form a rig whose reference is the first camera. The centre of the first pixel is at 0.5. `points3D.txt` has points of the
/// exact depth, each seen in the image that it comes from.
#[derive(Debug, Default)]
pub(super) struct Colmap;

impl Format for Colmap {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let (view, lens) = lens(NAME, shot, 6)?;
        let rgb = rgb(NAME, shot)?;
        let folder = PathBuf::from(format!("{:06}", shot.sequence));
        let name = in_product(shot, format!("{:06}.png", shot.number));
        let mut frame = FrameFiles::default();
        frame.add_rgb(folder.join("images").join(&name), rgb);
        frame.write(output)?;
        let intrinsics = &view.camera.intrinsics;
        let center = intrinsics.principal_point::<Usd>();
        let (model, terms) = model(lens);
        let distortion: String = terms.iter().map(|term| format!(" {term:.15}")).collect();
        let pose = |transform: oaktwin_camera::RigidTransform| {
            let [x, y, z, w] = quaternion(&transform.rotation);
            let [tx, ty, tz] = transform.translation.to_array();
            format!("{w:.15} {x:.15} {y:.15} {z:.15} {tx:.12} {ty:.12} {tz:.12}")
        };
        Ok(json!({
            "folder": folder.to_string_lossy(),
            "frame": shot.number,
            "camera": shot.camera + 1,
            "name": name,
            "camera_line": format!(
                "{model} {} {} {:.12} {:.12} {:.12} {:.12}{distortion}",
                intrinsics.size.width, intrinsics.size.height, intrinsics.fx, intrinsics.fy, center.x, center.y
            ),
            "points": points(shot, view, rgb),
            "camera_from_world": pose(view.world_from_camera.inverse()),
            "sensor_from_mount": pose(view.world_from_camera.inverse() * shot.world_from_mount),
        }))
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        let (sequences, _) = by_folder(records, Model::add)?;
        for (folder, model) in sequences {
            let folder = PathBuf::from(folder).join("sparse/0");
            for (name, text) in model.files() {
                output.write(&folder.join(name), text.as_bytes())?;
            }
        }
        Ok(Vec::new())
    }
}

/// The model of a lens and its terms.
fn model(lens: Lens) -> (&'static str, Vec<f64>) {
    match lens {
        Lens::Pinhole => ("PINHOLE", Vec::new()),
        Lens::Fisheye(k) => ("OPENCV_FISHEYE", k.to_vec()),
        Lens::Radial { k, p } if k[2..] == [0.0; 4] => ("OPENCV", vec![k[0], k[1], p[0], p[1]]),
        Lens::Radial { k, p } => (
            "FULL_OPENCV",
            vec![k[0], k[1], p[0], p[1], k[2], k[3], k[4], k[5]],
        ),
    }
}

/// Returns points of the exact depth on a grid of pixels: the place in the image, in the world, and the colour.
fn points(shot: &Shot, view: &FrameCamera, rgb: &Image<[u8; 4]>) -> Vec<String> {
    let Some(depth) = &shot.frame.distance_to_image_plane else {
        return Vec::new();
    };
    let (width, height) = (depth.0.width(), depth.0.height());
    let pixels = f64::from(width) * f64::from(height);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a small number"
    )]
    let step = (pixels / MAX_POINTS).sqrt().ceil().max(1.0) as u32;
    let places = (step / 2..height)
        .step_by(step as usize)
        .flat_map(|y| (step / 2..width).step_by(step as usize).map(move |x| (x, y)));
    let point = |(x, y): (u32, u32)| {
        let z = f64::from(*depth.0.get(x, y)?);
        let at = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let ray = view.camera.unproject(at).filter(|ray| ray.z > 0.0)?;
        if !z.is_finite() {
            return None;
        }
        let place = view.world_from_camera.apply(ray * (z / ray.z));
        let [r, g, b, _] = *rgb.get(x, y)?;
        Some(format!(
            "{} {} {:.6} {:.6} {:.6} {r} {g} {b}",
            at.x, at.y, place.x, place.y, place.z
        ))
    };
    places.filter_map(point).collect()
}

/// The text model of a sequence. Intrinsics may differ between frames, in which case each has its own cameras and rig.
#[derive(Default)]
struct Model {
    /// The cameras by their description and their place in the rig.
    cameras: Vec<(u64, String)>,
    images: String,
    points: String,
    point_count: usize,
    frames: BTreeMap<u64, Vec<(usize, usize, String, String)>>,
    count: usize,
}

impl Model {
    fn add(&mut self, record: &Value) {
        let key = (
            record["camera"].as_u64().unwrap_or(1),
            text(record, "camera_line").to_owned(),
        );
        let known = self.cameras.iter().position(|camera| *camera == key);
        let camera = known.unwrap_or_else(|| {
            self.cameras.push(key);
            self.cameras.len() - 1
        }) + 1;
        self.count += 1;
        let mut seen = Vec::new();
        let points = record["points"].as_array().into_iter().flatten();
        for (index, point) in points.filter_map(Value::as_str).enumerate() {
            let words: Vec<&str> = point.split(' ').collect();
            let [x, y, place @ ..] = words.as_slice() else {
                continue;
            };
            self.point_count += 1;
            seen.push(format!("{x} {y} {}", self.point_count));
            self.points += &format!(
                "{} {} 0 {} {index}\n",
                self.point_count,
                place.join(" "),
                self.count
            );
        }
        self.images += &format!(
            "{} {} {camera} {}\n{}\n",
            self.count,
            text(record, "camera_from_world"),
            text(record, "name"),
            seen.join(" ")
        );
        self.frames
            .entry(record["frame"].as_u64().unwrap_or_default())
            .or_default()
            .push((
                camera,
                self.count,
                text(record, "sensor_from_mount").to_owned(),
                text(record, "camera_from_world").to_owned(),
            ));
    }

    fn files(&self) -> [(&'static str, String); 5] {
        let mut cameras = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n".to_owned();
        for (index, (_, line)) in self.cameras.iter().enumerate() {
            cameras += &format!("{} {line}\n", index + 1);
        }
        let images = format!(
            "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, POINT3D_ID)\n{}",
            self.images
        );
        let (mut rigs, mut frames) = (
            "# RIG_ID, NUM_SENSORS, REF_SENSOR_TYPE, REF_SENSOR_ID, SENSORS[]\n".to_owned(),
            "# FRAME_ID, RIG_ID, RIG_FROM_WORLD[], NUM_DATA_IDS, DATA_IDS[]\n".to_owned(),
        );
        // A rig is a list of cameras; the first one is its reference.
        let mut known: BTreeMap<Vec<(usize, String)>, usize> = BTreeMap::new();
        for (index, sensors) in self.frames.values().enumerate() {
            let (first, _, reference_from_mount, _) = &sensors[0];
            let others = sensors[1..].iter();
            let others = others.map(|(camera, _, sensor_from_mount, _)| {
                (*camera, relative(sensor_from_mount, reference_from_mount))
            });
            let key: Vec<_> = [(*first, String::new())].into_iter().chain(others).collect();
            let next = known.len() + 1;
            let rig = *known.entry(key.clone()).or_insert_with(|| {
                let mut line = format!("{next} {} CAMERA {first}", sensors.len());
                for (camera, pose) in &key[1..] {
                    line += &format!(" CAMERA {camera} 1 {pose}");
                }
                rigs += &format!("{line}\n");
                next
            });
            let (_, _, _, reference_from_world) = &sensors[0];
            let mut line = format!("{} {rig} {reference_from_world} {}", index + 1, sensors.len());
            for (camera, image, ..) in sensors {
                line += &format!(" CAMERA {camera} {image}");
            }
            frames += &format!("{line}\n");
        }
        let points = format!(
            "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n{}",
            self.points
        );
        [
            ("cameras.txt", cameras),
            ("images.txt", images),
            ("points3D.txt", points),
            ("rigs.txt", rigs),
            ("frames.txt", frames),
        ]
    }
}

/// Returns the pose of a sensor relative to the reference, from both poses relative to the mount, as text.
fn relative(sensor_from_mount: &str, reference_from_mount: &str) -> String {
    use oaktwin_camera::RigidTransform;
    use oaktwin_camera::math::{DMat3, DQuat, DVec3};

    let parse = |text: &str| -> RigidTransform {
        let numbers: Vec<f64> = text.split(' ').filter_map(|word| word.parse().ok()).collect();
        let [w, x, y, z, tx, ty, tz] = numbers[..] else {
            return RigidTransform::IDENTITY;
        };
        let rotation = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
        RigidTransform::new(rotation, DVec3::new(tx, ty, tz))
    };
    let transform = parse(sensor_from_mount) * parse(reference_from_mount).inverse();
    let [x, y, z, w] = quaternion(&transform.rotation);
    let [tx, ty, tz] = transform.translation.to_array();
    format!("{w:.15} {x:.15} {y:.15} {z:.15} {tx:.12} {ty:.12} {tz:.12}")
}
