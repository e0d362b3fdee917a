//! What the formats share: depth, cameras, files by path, and JSON that is written piece by piece.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::math::{DMat3, DQuat};
use oaktwin_camera::{Intrinsics, LensModel, OpenCv, RigidTransform};
use oaktwin_files::{AtomicFile, OutputFiles};
use oaktwin_image::annotation::Reasons;
use oaktwin_image::{Image, png};
use serde_json::{Value, json};

use crate::file::{Content, DatasetFile, Fault, write_all};
use crate::listing::reason_legend;
use crate::{DatasetError, FrameCamera, Records, Shot, WriteError, json as files};

/// The files of a frame, which are encoded in parallel.
#[derive(Default)]
pub(super) struct FrameFiles<'a> {
    files: Vec<(PathBuf, DatasetFile<'a>)>,
}

impl<'a> FrameFiles<'a> {
    pub(super) fn add(
        &mut self,
        path: impl Into<PathBuf>,
        encode: impl Fn() -> Result<Vec<u8>, Fault> + Send + Sync + 'a,
    ) {
        let file = DatasetFile {
            folder: "",
            name: String::new(),
            extension: "",
            content: Content::Whole(Box::new(encode)),
        };
        self.files.push((path.into(), file));
    }

    /// Adds the colour image without its coverage.
    pub(super) fn add_rgb(&mut self, path: impl Into<PathBuf>, rgb: &'a Image<[u8; 4]>) {
        self.add(path, move || {
            Ok(png::encode(&rgb.map(|[r, g, b, _]| [*r, *g, *b]))?)
        });
    }

    /// Adds depth as 16-bit PNG with this many units per metre; 0 where there is none, or where it does not fit.
    pub(super) fn add_depth(&mut self, path: impl Into<PathBuf>, metres: &'a Image<f32>, per_metre: f32) {
        self.add(path, move || Ok(png::encode(&fixed(metres, per_metre))?));
    }

    /// Adds the depth of a frame in the folder `depth`, `depth_exact` if that is measured, and what is known about the measurement:
    /// `depth_reason` and `depth_confidence`.
    pub(super) fn add_depths(&mut self, depths: &Depths<'a>, per_metre: f32, path: impl Fn(&str) -> PathBuf) {
        for (folder, depth) in [("depth", depths.main), ("depth_exact", depths.exact)] {
            if let Some(depth) = depth {
                self.add_depth(path(folder), depth, per_metre);
            }
        }
        self.add_quality(depths, path);
    }

    /// Adds the reasons for missing values and the confidence, if they are known.
    pub(super) fn add_quality<P: Into<PathBuf>>(&mut self, depths: &Depths<'a>, path: impl Fn(&str) -> P) {
        if let Some(reasons) = depths.reasons {
            self.add(path("depth_reason"), || Ok(png::encode(&reasons.codes)?));
        }
        if let Some(confidence) = depths.confidence {
            self.add(path("depth_confidence"), || Ok(png::encode(confidence)?));
        }
    }

    pub(super) fn write(self, output: &mut OutputFiles) -> Result<(), WriteError> {
        write_all(&self.files, output)
    }
}

/// Returns numbers of fixed steps; 0 for values that are not positive and finite, or do not fit.
pub(super) fn fixed(values: &Image<f32>, per_unit: f32) -> Image<u16> {
    values.map(|value| {
        let steps = (value * per_unit).round_ties_even();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "checked to fit"
        )]
        let whole = steps as u16;
        if steps > 0.0 && steps <= 65535.0 { whole } else { 0 }
    })
}

/// Returns the number of positive, finite values that do not fit into 16 bits with these steps: too large, or rounded to 0.
pub(super) fn count_lost(values: &Image<f32>, per_unit: f32) -> usize {
    let is_lost = |value: &&f32| {
        let steps = (**value * per_unit).round_ties_even();
        value.is_finite() && **value > 0.0 && !(1.0..=65535.0).contains(&steps)
    };
    values.pixels().iter().filter(is_lost).count()
}

/// What all frames have in common: the data that a format cannot hold, and the meanings of the codes of missing values.
#[derive(Default)]
pub(super) struct DepthSummary {
    lost_depth: u64,
    lost_disparity: u64,
    /// The number of frames whose sensor has another camera than the colour image.
    foreign: u64,
    legend: Value,
}

impl DepthSummary {
    /// Adds a frame, from its record.
    pub(super) fn add(&mut self, record: &Value) {
        self.lost_depth += number(record, "lost_depth");
        self.lost_disparity += number(record, "lost_disparity");
        self.foreign += number(record, "foreign_sensor");
        if let Some(legend) = record.get("reasons") {
            legend.clone_into(&mut self.legend);
        }
    }

    /// Adds up all frames.
    pub(super) fn of(records: &mut Records<'_>) -> Result<Self, WriteError> {
        let mut summary = Self::default();
        for record in records {
            summary.add(&record?);
        }
        Ok(summary)
    }

    /// Writes the meanings of the codes of missing values, if there are any, and returns the findings; `limit_m` is the largest depth of
    /// the format.
    pub(super) fn finish(
        &self,
        format: &str,
        limit_m: f64,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        if !self.legend.is_null() {
            output.write("depth_reasons.json".as_ref(), &files::encode(&self.legend))?;
        }
        Ok(self.findings(format, limit_m))
    }

    fn findings(&self, format: &str, limit_m: f64) -> Vec<Finding> {
        let warning = |count: u64, code: &'static str, text: &str, remedy: &'static str| {
            (count > 0).then(|| Finding::new(code, Level::Warning, format, format!("{count} {text}"), remedy))
        };
        let far = format!(
            "depths are beyond {limit_m:.1} m, or rounded to 0, which the format cannot hold; they have no value"
        );
        let findings = [
            warning(
                self.lost_depth,
                "depth-out-of-range",
                &far,
                "use a format with floating-point depth, such as basic, or nearer scenes",
            ),
            warning(
                self.lost_disparity,
                "disparity-out-of-range",
                "disparities are 256 px or more, or rounded to 0, which the format cannot hold; they have no value",
                "use a format with floating-point disparity, such as middlebury, or scenes further away",
            ),
            warning(
                self.foreign,
                "sensor-camera",
                "frames have measured depth of another camera or size than the colour image, which the format cannot hold; only \
                 exact depth is written",
                "use the format basic, or a sensor without decimation",
            ),
        ];
        findings.into_iter().flatten().collect()
    }
}

/// The depth of a frame: what a network gets as input, and the truth beside it.
pub(super) struct Depths<'a> {
    /// Measured depth if it was written and is an image of the colour camera, else exact depth.
    pub(super) main: Option<&'a Image<f32>>,
    /// Exact depth, if `main` is measured.
    pub(super) exact: Option<&'a Image<f32>>,
    /// The reasons for missing values of measured depth.
    pub(super) reasons: Option<&'a Reasons>,
    /// The confidence of measured depth.
    pub(super) confidence: Option<&'a Image<u16>>,
    /// Whether there is measured depth, but of another camera.
    is_foreign: bool,
}

impl<'a> Depths<'a> {
    pub(super) fn of(shot: &'a Shot) -> Self {
        let exact = shot.frame.distance_to_image_plane.as_ref().map(|depth| &depth.0);
        let measured = shot.frame.depth_sensor_distance.as_ref().map(|depth| &depth.0);
        let is_same_camera = match (&shot.view, &shot.sensor_view) {
            (Some(view), Some(sensor)) => {
                view.camera == sensor.camera && view.world_from_camera == sensor.world_from_camera
            }
            _ => false,
        };
        match measured.filter(|_| is_same_camera) {
            Some(measured) => Self {
                main: Some(measured),
                exact,
                reasons: shot.frame.depth_sensor_reason.as_ref(),
                confidence: shot.frame.depth_sensor_confidence.as_ref(),
                is_foreign: false,
            },
            None => Self {
                main: exact,
                exact: None,
                reasons: None,
                confidence: None,
                is_foreign: measured.is_some(),
            },
        }
    }
}

impl Depths<'_> {
    /// Adds what a format with this many steps per metre loses to a frame's record, and the meanings of the codes.
    pub(super) fn add_losses(&self, per_metre: f32, record: &mut Value) {
        let depths = [self.main, self.exact].into_iter().flatten();
        let lost: usize = depths.map(|depth| count_lost(depth, per_metre)).sum();
        record["lost_depth"] = lost.into();
        self.add_common(record);
    }

    /// Adds whether measured depth is left out to a frame's record, and the meanings of the codes.
    pub(super) fn add_common(&self, record: &mut Value) {
        record["foreign_sensor"] = u64::from(self.is_foreign).into();
        if let Some(reasons) = self.reasons {
            record["reasons"] = reason_legend(&reasons.legend);
        }
    }
}

/// Collects the records of each folder, and what all frames have in common.
pub(super) fn by_folder<T: Default>(
    records: &mut Records<'_>,
    add: impl Fn(&mut T, &Value),
) -> Result<(BTreeMap<String, T>, DepthSummary), WriteError> {
    let (mut folders, mut summary) = (BTreeMap::new(), DepthSummary::default());
    for record in records {
        let record = record?;
        summary.add(&record);
        add(
            folders.entry(text(&record, "folder").to_owned()).or_default(),
            &record,
        );
    }
    Ok((folders, summary))
}

/// Returns the view of a shot, which must be a pinhole.
pub(super) fn pinhole<'a>(format: &'static str, shot: &'a Shot) -> Result<&'a FrameCamera, WriteError> {
    let view = shot
        .view
        .as_ref()
        .ok_or_else(|| missing(format, "the camera of each frame"))?;
    if view.camera.lens != LensModel::Pinhole {
        return Err(DatasetError::Missing {
            format,
            what: "images without lens distortion",
            remedy: message!["choose the depth camera, or another ", opt("lens")],
        }
        .into());
    }
    Ok(view)
}

/// Returns the colour image of a shot, which must have one.
pub(super) fn rgb<'a>(format: &'static str, shot: &'a Shot) -> Result<&'a Image<[u8; 4]>, WriteError> {
    let rgb = shot.frame.rgb.as_ref();
    rgb.ok_or_else(|| missing(format, "the annotator rgb"))
}

/// Creates the error of a frame without something that annotators or recipes provide.
pub(super) fn missing(format: &'static str, what: &'static str) -> WriteError {
    DatasetError::Missing {
        format,
        what,
        remedy: "generate the data set from a recipe with it, or choose another format".into(),
    }
    .into()
}

/// The principal point with the first pixel's centre at 0.
pub(super) fn center(intrinsics: &Intrinsics) -> [f64; 2] {
    let point = intrinsics.principal_point::<OpenCv>();
    [point.x, point.y]
}

/// The nine numbers of a camera matrix, row by row, with the first pixel's centre at 0.
pub(super) fn camera_matrix(intrinsics: &Intrinsics) -> [f64; 9] {
    let [cx, cy] = center(intrinsics);
    [intrinsics.fx, 0.0, cx, 0.0, intrinsics.fy, cy, 0.0, 0.0, 1.0]
}

/// The model of a lens, as OpenCV's functions for it or `pinhole`, and its coefficients in the model's order.
pub(super) fn distortion(lens: &LensModel) -> Value {
    json!({"model": lens.names().report, "coefficients": lens.coefficients()})
}

/// The nine numbers of a rotation, row by row.
pub(super) fn rows(rotation: &DMat3) -> [f64; 9] {
    rotation.transpose().to_cols_array()
}

/// The quaternion of a rotation in the order x, y, z, w, with w not negative.
pub(super) fn quaternion(rotation: &DMat3) -> [f64; 4] {
    let quaternion = DQuat::from_mat3(rotation).normalize().to_array();
    if quaternion[3] < 0.0 {
        quaternion.map(|part| -part)
    } else {
        quaternion
    }
}

/// The 16 numbers of a transform, row by row.
pub(super) fn matrix(transform: &RigidTransform) -> [[f64; 4]; 4] {
    let [x, y, z] = [0, 1, 2].map(|row| {
        let rotation = transform.rotation.row(row);
        [rotation.x, rotation.y, rotation.z, transform.translation[row]]
    });
    [x, y, z, [0.0, 0.0, 0.0, 1.0]]
}

/// The folder of a sequence, in which each of several cameras has its own folder.
pub(super) fn sequence_folder(shot: &Shot) -> PathBuf {
    let sequence = PathBuf::from(format!("{:06}", shot.sequence));
    match &shot.render_product {
        Some(product) => sequence.join(product),
        None => sequence,
    }
}

/// Returns a path in the folder of the shot's render product, if it has one.
pub(super) fn in_product(shot: &Shot, path: String) -> String {
    match &shot.render_product {
        Some(product) => format!("{product}/{path}"),
        None => path,
    }
}

/// Seconds with nine decimals.
pub(super) fn seconds(time_ns: u64) -> String {
    format!("{}.{:09}", time_ns / 1_000_000_000, time_ns % 1_000_000_000)
}

/// A file of lines or JSON members that is written piece by piece.
pub(super) struct Pieces {
    file: AtomicFile,
    is_empty: bool,
}

impl Pieces {
    pub(super) fn create(output: &mut OutputFiles, path: &Path) -> Result<Self, WriteError> {
        Ok(Self {
            file: output.create(path)?,
            is_empty: true,
        })
    }

    pub(super) fn write(&mut self, text: &str) -> Result<(), WriteError> {
        Ok(self.file.append(text.as_bytes())?)
    }

    /// Writes an element, after a comma unless it is the first.
    pub(super) fn element(&mut self, text: &str) -> Result<(), WriteError> {
        let separator = if std::mem::replace(&mut self.is_empty, false) {
            "\n"
        } else {
            ",\n"
        };
        self.write(&format!("{separator}{text}"))
    }

    pub(super) fn finish(self, output: &mut OutputFiles) -> Result<(), WriteError> {
        Ok(output.finish(self.file)?)
    }
}

/// Returns a text member of a record.
pub(super) fn text<'a>(record: &'a Value, name: &str) -> &'a str {
    record[name].as_str().unwrap_or_default()
}

/// Returns a whole number of a record.
pub(super) fn number(record: &Value, name: &str) -> u64 {
    record[name].as_u64().unwrap_or_default()
}

/// Returns the description that readers of COCO's annotations require. It has no date, so that the same data set has the same bytes.
pub(super) fn coco_info() -> Value {
    json!({
        "description": "synthetic images by oaktwin",
        "version": env!("CARGO_PKG_VERSION"),
        "contributor": "",
    })
}
