use std::fs;
use std::path::Path;

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::files;
use oaktwin::usd::asset::{self, AssetOptions, Format, LensChoice, OverrideBase};
use oaktwin::usd::stage::{self, SceneLimit};
use pyo3::PyResult;

use crate::choice::named;
use crate::error::{error, reading, wrong};

/// The asset options of Python.
pub(crate) struct AssetSettings<'a> {
    pub(crate) isaac: &'a str,
    pub(crate) target: &'a str,
    pub(crate) aperture_offsets: &'a str,
    pub(crate) extended_disparity: bool,
    pub(crate) legacy_distortion: bool,
    pub(crate) rigid_body: bool,
    pub(crate) body: bool,
}

impl AssetSettings<'_> {
    pub(crate) fn options(&self, lens: LensChoice) -> PyResult<AssetOptions> {
        Ok(AssetOptions {
            isaac: named("isaac", self.isaac)?,
            target: named("target", self.target)?,
            lens,
            aperture_offsets: named("aperture_offsets", self.aperture_offsets)?,
            extended_disparity: self.extended_disparity,
            legacy_distortion: self.legacy_distortion,
            rigid_body: self.rigid_body,
            body: self.body,
        })
    }
}

/// The format of the file name extension.
pub(crate) fn format(path: &Path) -> PyResult<Format> {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let mut all = Format::ALL.iter().copied();
    all.find(|format| format.extension() == extension).ok_or_else(|| {
        let is = format!(".{extension} is not a USD format");
        wrong(path.display(), is, "use .usda, .usd or .usdz")
    })
}

/// Reads the factor on the limits for composing a stage.
pub(crate) fn scene_limit(factor: f64) -> PyResult<SceneLimit> {
    SceneLimit::new(factor).ok_or_else(|| {
        let is = format!("must be a finite number > 0 (got {factor})");
        wrong("scene_limit", is, "pass a larger number")
    })
}

/// The overrides layer at `path` for an existing asset.
pub(crate) fn overrides(
    twin: &Twin,
    options: &AssetOptions,
    format: Format,
    (base, limit): (&Path, SceneLimit),
    path: &Path,
) -> PyResult<(Vec<u8>, Vec<Finding>)> {
    let stage = stage::open(base, limit).map_err(|error| reading(base, &error))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = files::relative(folder, base).map_err(error)?;
    if fs::canonicalize(path).is_ok_and(|path| fs::canonicalize(base).is_ok_and(|base| base == path)) {
        return Err(wrong(
            path.display(),
            "is the asset to override",
            "write to another file",
        ));
    }
    let base = OverrideBase::of(&stage, &name, twin).map_err(error)?;
    let made = asset::overrides(twin, options, &base).map_err(error)?;
    Ok((made.bytes(format).map_err(error)?, made.findings))
}

/// The contents of the asset file.
pub(crate) fn bytes(
    twin: &Twin,
    options: &AssetOptions,
    format: Format,
) -> PyResult<(Vec<u8>, Vec<Finding>)> {
    let made = asset::asset(twin, options).map_err(error)?;
    Ok((made.bytes(format).map_err(error)?, made.findings))
}
