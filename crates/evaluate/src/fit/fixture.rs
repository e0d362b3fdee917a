//! Simulated recordings of a board and their fits, for the tests of all methods.

use std::fmt::Write;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use oaktwin_depth::DepthShot;

use super::{FitOptions, FitReport, TABLE, fit};
use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::ImageSize;
use oaktwin_catalog::{Catalog, Twin};
use oaktwin_image::{Image, ZDepth, npy};
use oaktwin_pipeline::sensor::ParameterFile;

pub(super) fn twin(model: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(model).unwrap())
}

/// Returns the depth of a board through (0, 0, z), rotated about the vertical axis.
pub(super) fn board(size: ImageSize, focal_px: f64, z: f64, turned_deg: f64) -> Image<f32> {
    let slope = turned_deg.to_radians().tan();
    let pixels = (0..size.width * size.height).map(|i| {
        let x = (f64::from(i % size.width) + 0.5 - f64::from(size.width) / 2.0) / focal_px;
        #[expect(clippy::cast_possible_truncation, reason = "a depth")]
        let depth = (z / (1.0 + slope * x)) as f32;
        depth
    });
    Image::new(size.width, size.height, pixels.collect()).unwrap()
}

/// Writes a file of all frames for each board, as `sense` measures it, and the table of distances.
pub(super) fn record(
    folder: &Path,
    boards: impl IntoIterator<Item = (Image<f32>, f64)>,
    frames: u64,
    sense: impl Fn(&DepthShot<'_>) -> ZDepth,
) {
    let mut table = "file,distance_m\n".to_owned();
    for (number, (depth, said_m)) in (0u32..).zip(boards) {
        let mut values = Vec::new();
        for frame in 0..frames {
            let mut shot = DepthShot::new((&depth).into());
            shot.frame = frame;
            shot.item = number;
            values.extend_from_slice(sense(&shot).0.pixels());
        }
        let shape = [
            usize::try_from(frames).unwrap(),
            depth.height() as usize,
            depth.width() as usize,
        ];
        let bytes = npy::encode(&shape, &values).unwrap();
        fs::write(folder.join(format!("{number}.npy")), bytes).unwrap();
        let _ = writeln!(table, "{number}.npy,{said_m}");
    }
    fs::write(folder.join(TABLE), table).unwrap();
}

/// Fits, draws and parses the result.
pub(super) fn fitted(
    model: &str,
    paths: &[&Path],
    options: &FitOptions,
) -> Result<(FitReport, Vec<Finding>, ParameterFile), String> {
    let paths: Vec<PathBuf> = paths.iter().map(|path| path.to_path_buf()).collect();
    let (fit, findings) = fit(&twin(model), &paths, options, &|_| ControlFlow::Continue(()))
        .map_err(|error| error.to_string())?;
    assert!(!crate::figure::svg(&fit.figures()).unwrap().contains("NaN"));
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.toml");
    fs::write(&file, fit.report().toml()).unwrap();
    let read = ParameterFile::read(&file).unwrap();
    Ok((fit.report().clone(), findings, read))
}

/// Whether the interval of a fitted parameter contains its true value.
pub(super) fn has(report: &FitReport, name: &str, truth: f64) -> bool {
    let [low, high] = report.parameter(name).unwrap().interval_95.unwrap();
    (low..=high).contains(&truth)
}

pub(super) fn codes(findings: &[Finding]) -> Vec<&str> {
    findings.iter().map(|finding| finding.code).collect()
}
