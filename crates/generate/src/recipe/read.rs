use std::path::Path;

use oaktwin_base::diagnostic::suggest;
use oaktwin_camera::StereoDrift;
use oaktwin_catalog::{CatalogError, Document};
use oaktwin_files::{self as files, FileError};

use oaktwin_base::parameter::Table;
use serde::Serialize;

use super::{
    Appearance, CameraRule, DriftRule, MotionRule, ObjectRule, Quantity, Recipe, RecipeFile, Region, Target,
    UnitRule,
};

/// The maximum size of a recipe.
const MAX_BYTES: u64 = 1 << 20;

/// The maximum number of objects of a rule in one arrangement.
const MAX_COUNT: f64 = 10_000.0;

/// An error in a recipe.
#[derive(Debug, thiserror::Error)]
pub enum RecipeError {
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file is not a valid recipe.
    #[error(transparent)]
    Content(#[from] CatalogError),
}

impl RecipeFile {
    /// Reads a recipe.
    ///
    /// # Errors
    /// Returns an error with the file, the line and the remedy if the file cannot be read or is not a valid recipe.
    pub fn read(path: &Path) -> Result<Self, RecipeError> {
        let bytes = files::read(path, MAX_BYTES, "a recipe")?;
        let text = std::str::from_utf8(&bytes)
            .map_err(|_| FileError::new(path, "is not text", "give a TOML file in UTF-8"))?;
        Ok(Self {
            path: path.to_owned(),
            recipe: Recipe::parse(path, text)?,
        })
    }
}

impl RecipeFile {
    /// Makes a recipe of the values that a file would have. Their paths are relative to a folder.
    ///
    /// # Errors
    /// Returns an error with the remedy if the values are not a valid recipe.
    pub fn of_values(folder: &Path, values: &impl Serialize) -> Result<Self, CatalogError> {
        let name = Path::new("recipe");
        let parsed = toml::to_string(values)
            .map_err(|error| CatalogError {
                file: name.to_owned(),
                line: None,
                problem: error.to_string(),
                remedy: "give tables, lists, texts and numbers".to_owned(),
            })
            .and_then(|text| Recipe::parse(name, &text));
        match parsed {
            Ok(recipe) => Ok(Self {
                path: folder.join(name),
                recipe,
            }),
            // The values have no lines.
            Err(error) => Err(CatalogError { line: None, ..error }),
        }
    }
}

impl Recipe {
    /// Parses a recipe; `file` is its name in errors.
    ///
    /// # Errors
    /// Returns an error with the line and the remedy if the text is not a valid recipe.
    pub fn parse(file: &Path, text: &str) -> Result<Self, CatalogError> {
        let document = Document::parse(file, text, "a recipe")?;
        let recipe: Self = document.deserialize()?;
        let wrong = |(place, problem, remedy): RecipeProblem| document.error(&place, problem, remedy);
        recipe.check().map_err(wrong)?;
        Ok(recipe)
    }

    fn check(&self) -> Result<(), RecipeProblem> {
        whole("frames", self.frames, 1..=u64::from(u32::MAX))?;
        whole("frames_per_scene", self.frames_per_scene, 1..=u64::from(u32::MAX))?;
        if self.seed > i64::MAX as u64 {
            return Err(wrong("seed", "is too large", "give a number below 2^63"));
        }
        for (index, rule) in self.objects.iter().enumerate() {
            check_objects(&format!("objects.{index}"), rule)?;
        }
        for (index, rule) in self.looks.iter().enumerate() {
            if rule.prims.0.is_empty() {
                let place = format!("looks.{index}");
                return Err(wrong(
                    &place,
                    "names no prims",
                    "add prims, such as prims = \"/World/Table\"",
                ));
            }
            check_look(&format!("looks.{index}.look"), &rule.look)?;
        }
        self.check_light()?;
        check_camera(&self.camera)?;
        check_unit(&self.unit)?;
        // Formats name files by their time in nanoseconds.
        let interval_s = self.output.interval_s;
        if interval_s.is_some_and(|interval_s| !(1e-6..=1e5).contains(&interval_s)) {
            return Err(wrong(
                "output.interval_s",
                "is not a time from 1e-6 to 1e5",
                "give a time in seconds, such as 0.05",
            ));
        }
        if self.output.formats.0.is_empty() {
            return Err(wrong(
                "output.formats",
                "is empty",
                "name a format, such as basic",
            ));
        }
        Ok(())
    }

    fn check_light(&self) -> Result<(), RecipeProblem> {
        let light = &self.light;
        within("light.infrared_ambient", &light.infrared_ambient, 0.0, 1e6)?;
        if let Some(projector) = &light.projector {
            within("light.projector", projector, 0.0, 1.0)?;
        }
        if let Some(sun) = &light.sun {
            within("light.sun.intensity", &sun.intensity, 0.0, 1e9)?;
            within("light.sun.elevation_deg", &sun.elevation_deg, -90.0, 90.0)?;
            within("light.sun.temperature_k", &sun.temperature_k, 1000.0, 40_000.0)?;
        }
        if let Some(sky) = &light.sky {
            within("light.sky.intensity", &sky.intensity, 0.0, 1e9)?;
        }
        if let Some(lamps) = &light.lamps {
            within("light.lamps.count", &lamps.count, 0.0, 100.0)?;
            within("light.lamps.intensity", &lamps.intensity, 0.0, 1e12)?;
            within("light.lamps.size_m", &lamps.size_m, 1e-3, 1e3)?;
            within(
                "light.lamps.temperature_k",
                &lamps.temperature_k,
                1000.0,
                40_000.0,
            )?;
            check_region("light.lamps.region", lamps.region)?;
        }
        Ok(())
    }
}

/// A place in the document, the problem and the remedy.
type RecipeProblem = (String, String, String);

fn wrong(place: &str, problem: impl Into<String>, remedy: impl Into<String>) -> RecipeProblem {
    let name = place.rsplit('.').next().unwrap_or(place);
    (
        place.to_owned(),
        format!("{name}: {}", problem.into()),
        remedy.into(),
    )
}

fn whole(place: &str, value: u64, range: std::ops::RangeInclusive<u64>) -> Result<(), RecipeProblem> {
    if range.contains(&value) {
        return Ok(());
    }
    let remedy = format!("give a whole number from {} to {}", range.start(), range.end());
    Err(wrong(place, format!("{value} is out of range"), remedy))
}

fn within(place: &str, quantity: &Quantity, min: f64, max: f64) -> Result<(), RecipeProblem> {
    let [low, high] = quantity.range();
    if low >= min && high <= max {
        return Ok(());
    }
    let value = if low < min { low } else { high };
    let value = match value.abs() < 1e15 {
        true => value.to_string(),
        false => format!("{value:e}"),
    };
    Err(wrong(
        place,
        format!("can be {value}, which is out of range"),
        format!("give numbers from {min} to {max}"),
    ))
}

fn check_region(place: &str, region: Option<Region>) -> Result<(), RecipeProblem> {
    match region {
        Some(Region { min, max }) if (0..3).any(|axis| min[axis] > max[axis]) => Err(wrong(
            place,
            "min is larger than max",
            "give the minimum corner of the box first",
        )),
        _ => Ok(()),
    }
}

fn check_look(place: &str, look: &Appearance) -> Result<(), RecipeProblem> {
    let at = |name: &str| format!("{place}.{name}");
    for (name, probability) in [("keep", look.keep), ("textured", look.textured)] {
        within(&at(name), &probability.into(), 0.0, 1.0)?;
    }
    for (name, quantity) in [
        ("saturation", &look.saturation),
        ("albedo", &look.albedo),
        ("roughness", &look.roughness),
        ("metallic", &look.metallic),
    ] {
        within(&at(name), quantity, 0.0, 1.0)?;
    }
    (look.infrared.as_ref()).map_or(Ok(()), |infrared| within(&at("infrared"), infrared, 0.0, 1.0))
}

fn check_objects(place: &str, rule: &ObjectRule) -> Result<(), RecipeProblem> {
    let at = |name: &str| format!("{place}.{name}");
    if rule.files.0.is_empty() {
        let remedy = "add files = \"objects/\", a folder or a list of files";
        return Err(wrong(&at("files"), "names no object", remedy));
    }
    within(&at("count"), &rule.count, 0.0, MAX_COUNT)?;
    within(&at("scale"), &rule.scale, 1e-9, 1e9)?;
    if let Some(size_m) = &rule.size_m {
        within(&at("size_m"), size_m, 1e-6, 1e6)?;
    }
    within(&at("gap_m"), &rule.gap_m.into(), 0.0, 10.0)?;
    whole(&at("attempts"), rule.attempts.into(), 1..=1_000_000)?;
    check_region(&at("region"), rule.region)?;
    if rule.label.as_ref().is_some_and(|label| label.trim().is_empty()) {
        return Err(wrong(&at("label"), "is empty", "remove it, or name the objects"));
    }
    rule.look
        .as_ref()
        .map_or(Ok(()), |look| check_look(&at("look"), look))
}

fn check_unit(unit: &UnitRule) -> Result<(), RecipeProblem> {
    if unit.calibration.is_some() && unit.population.is_some() {
        let remedy = "remove it or unit.calibration";
        return Err(wrong("unit.population", "a calibration is one unit", remedy));
    }
    if let Some(count) = unit.count {
        whole("unit.count", count, 1..=u64::from(u32::MAX))?;
        if unit.population.is_none() {
            let remedy = "add population = \"factory\", or remove it";
            return Err(wrong(
                "unit.count",
                "is the number of units of a population",
                remedy,
            ));
        }
    }
    for (key, name, quantity) in unit.drift.iter().flat_map(DriftRule::quantities) {
        let place = format!("unit.drift.{key}");
        let about = StereoDrift::row(name).map(|row| &row.about);
        let [min, max] = about.map_or([f64::NEG_INFINITY, f64::INFINITY], |about| [about.min, about.max]);
        within(&place, quantity, min, max)?;
    }
    Ok(())
}

fn check_motion(motion: &MotionRule, is_path: bool) -> Result<(), RecipeProblem> {
    for (key, quantity, [min, max]) in motion.quantities() {
        within(&format!("camera.motion.{key}"), &quantity, min, max)?;
    }
    match (motion.has_velocity(), is_path) {
        (true, true) => Err(wrong(
            "camera.motion",
            "has a velocity, and the trajectory another one",
            "remove velocity_m_s and angular_velocity_deg_s, or camera.trajectory",
        )),
        (false, false) => Err(wrong(
            "camera.motion",
            "has no velocity",
            "add velocity_m_s, angular_velocity_deg_s or camera.trajectory",
        )),
        _ => Ok(()),
    }
}

fn check_camera(camera: &CameraRule) -> Result<(), RecipeProblem> {
    if camera.model.0.is_empty() {
        return Err(wrong(
            "camera.model",
            "is empty",
            "name a model; oaktwin models lists them",
        ));
    }
    let places = [
        ("camera.sphere", camera.sphere.is_some()),
        ("camera.box", camera.inside.is_some()),
        ("camera.trajectory", camera.trajectory.is_some()),
    ];
    let mut given = places.iter().filter(|(_, is_given)| *is_given);
    if let (Some((first, _)), Some((second, _))) = (given.next(), given.next()) {
        let remedy = format!("remove it or {first}");
        return Err(wrong(second, "is a second pose of the camera", remedy));
    }
    if camera.imu.is_some() && camera.trajectory.is_none() {
        let remedy = "add camera.trajectory, or remove it";
        return Err(wrong("camera.imu", "requires poses that form a motion", remedy));
    }
    if let Some(rate_hz) = camera.imu.as_ref().and_then(|imu| imu.rate_hz) {
        within("camera.imu.rate_hz", &rate_hz.into(), 1e-3, 1e5)?;
    }
    if let Some(motion) = &camera.motion {
        check_motion(motion, camera.trajectory.is_some())?;
    }
    if let Some(sphere) = &camera.sphere {
        within("camera.sphere.distance_m", &sphere.distance_m, 1e-3, 1e6)?;
        within("camera.sphere.elevation_deg", &sphere.elevation_deg, -89.9, 89.9)?;
    }
    if let Some(inside) = &camera.inside {
        let (min, max) = (inside.min, inside.max);
        check_region("camera.box", Some(Region { min, max }))?;
        within("camera.box.tilt_deg", &inside.tilt_deg, -89.9, 89.9)?;
    }
    within("camera.min_coverage", &camera.min_coverage.into(), 0.0, 1.0)?;
    within("camera.clearance_m", &camera.clearance_m.into(), 0.0, 1e3)?;
    within("camera.look_jitter_m", &camera.look_jitter_m.into(), 0.0, 1e3)?;
    whole("camera.attempts", camera.attempts.into(), 1..=1_000_000)?;
    match &camera.look_at {
        Target::Name(name) if !name.starts_with('/') && !["objects", "scene"].contains(&name.as_str()) => {
            let remedy = format!(
                "{}, or give the path of a prim",
                suggest(name, ["objects", "scene"])
            );
            Err(wrong(
                "camera.look_at",
                format!("unknown target '{name}'"),
                remedy,
            ))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        Recipe::parse(Path::new("r.toml"), text).unwrap_err().to_string()
    }

    #[test]
    fn two_lines_are_a_recipe() {
        let recipe = Recipe::parse(
            Path::new("r.toml"),
            "scene = 'room.usda'\nobjects = [{ files = 'cups/' }]\n",
        )
        .unwrap();
        assert_eq!((recipe.frames, recipe.objects[0].attempts), (100, 200));
        let written = toml::to_string(&serde_json::to_value(&recipe).unwrap()).unwrap();
        assert_eq!(Recipe::parse(Path::new("r.toml"), &written).unwrap(), recipe);
    }

    #[test]
    fn errors_name_the_line_and_the_remedy() {
        for (text, expected) in [
            ("", "the file is empty"),
            ("frames = 0", "r.toml:1: frames: 0 is out of range"),
            (
                "frame = 3",
                "r.toml:1: unknown key 'frame'; did you mean 'frames'?",
            ),
            (
                "\n[camera]\nlook_at = 'object'",
                "r.toml:3: look_at: unknown target 'object'; did you mean 'objects'",
            ),
            ("[[objects]]\nlabel = 'x'", "names no object"),
            (
                "[[objects]]\nfiles='a'\npose = 'upwright'",
                "did you mean 'upright'",
            ),
            (
                "[[objects]]\nfiles='a'\ncount = { uniform = [-1, 4] }",
                "r.toml:3: count: can be -1",
            ),
            (
                "[camera.sphere]\n[camera.box]\nmin=[0,0,0]\nmax=[1,1,1]",
                "second pose of the camera",
            ),
            ("[camera.box]\nmin=[0,0,2]\nmax=[1,1,1]", "min is larger"),
            ("[camera.imu]", "r.toml:1: imu: requires poses that form a motion"),
            ("seed = nan", "not a finite number"),
            (
                "[sensor.parameters]\njitter = [1]",
                "expected a number, a distribution",
            ),
            ("[unit]\npopulation = 'factry'", "did you mean 'factory'"),
            (
                "[unit]\npopulation = 'factory'\ncalibration = 'a.json'",
                "r.toml:2: population: a calibration is",
            ),
            (
                "[unit]\ncount = 3",
                "r.toml:2: count: is the number of units of a population",
            ),
            (
                "[unit.drift]\nyaw_mrad = { normal = [0, 30] }",
                "r.toml:2: yaw_mrad: can be -90, which is out of range; give numbers from -50 to 50",
            ),
            ("[unit.drift]\nyaw = 1", "did you mean"),
            ("[light]\nprojector = 2", "can be 2, which is out of range"),
            (
                "[light]\nprojector = 1e308",
                "can be 1e308, which is out of range",
            ),
            ("frames = -3", "integer `-3`, expected a whole number, 0 or more"),
            (
                "frames = 1e300",
                "floating point `1e300`, expected a whole number, 0 or more",
            ),
            (
                "[output]\ninterval_s = 1e-9",
                "r.toml:2: interval_s: is not a time from 1e-6 to 1e5",
            ),
            ("[output]\nshard_frames = 0", "r.toml:2"),
        ] {
            let error = error(text);
            assert!(error.contains(expected), "{text:?}: {error}");
        }
    }
}
