use std::collections::BTreeMap;
use std::path::PathBuf;

use oaktwin_base::diagnostic::{Finding, Message};
use oaktwin_calibration::population::Population;
use oaktwin_catalog::Catalog;
use oaktwin_dataset::{FormatKind, Needs};
use oaktwin_image::annotation::Annotator;
use oaktwin_imu::Motion;
use oaktwin_pipeline::render::annotator;
use oaktwin_pipeline::render::trajectory::{self, TimedPose};
use oaktwin_pipeline::sensor::EngineRef;
use oaktwin_pipeline::unit;

use crate::GenerateError;
use crate::inertial::Inertial;
use crate::models::Models;
use crate::random::Random;
use crate::recipe::{Appearance, ObjectRule, PopulationKind, Quantity, RecipeFile};
use crate::units::Units;
use crate::world::{Base, ObjectFiles, files_of, is_image};

/// The data that all frames of a recipe share.
#[derive(Debug)]
pub(crate) struct Context {
    pub(crate) file: RecipeFile,
    pub(crate) random: Random,
    pub(crate) bases: Vec<Base>,
    pub(crate) object_files: ObjectFiles,
    /// The images of each rule's look.
    pub(crate) object_textures: Vec<Vec<PathBuf>>,
    pub(crate) look_textures: Vec<Vec<PathBuf>>,
    pub(crate) sky_images: Vec<PathBuf>,
    pub(crate) trajectory: Vec<TimedPose>,
    /// The times of its poses, seconds, if all have one and the recipe has no interval.
    pub(crate) times: Option<Vec<f64>>,
    /// The inertial sensors, if the recipe asks for their samples.
    pub(crate) inertial: Option<Inertial>,
    /// The motion along the trajectory, if frames take time.
    pub(crate) motion: Option<Motion>,
    pub(crate) annotators: Vec<Annotator>,
    pub(crate) formats: Vec<&'static FormatKind>,
    /// What at least one of the formats requires.
    pub(crate) needs: Needs,
    /// The units of each model.
    units: BTreeMap<String, Units>,
    pub(crate) models: Models,
    /// The engine instead of the recipe's.
    pub(crate) engine: Option<EngineRef>,
    /// Findings about the recipe and its files.
    pub(crate) findings: Vec<Finding>,
}

impl Context {
    /// Opens the base scenes and lists the objects of a recipe.
    pub(crate) fn open(file: RecipeFile, catalog: &Catalog) -> Result<Self, GenerateError> {
        let recipe = &file.recipe;
        let (units, findings) = units(&file, catalog)?;
        let formats = formats(&file)?;
        let annotators = recipe.output.annotators.0.iter().map(|name| annotator(name));
        let annotators = annotators.collect::<Result<Vec<_>, _>>()?;
        let images = |look: Option<&Appearance>| match look {
            Some(look) => files_of(&file, &look.textures, "images", is_image),
            None => Ok(Vec::new()),
        };
        let object_textures = recipe.objects.iter().map(|rule| images(rule.look.as_ref()));
        let look_textures = recipe.looks.iter().map(|rule| images(Some(&rule.look)));
        let (object_textures, look_textures) = (
            object_textures.collect::<Result<_, _>>()?,
            look_textures.collect::<Result<_, _>>()?,
        );
        let sky_images = match &recipe.light.sky {
            Some(sky) => files_of(&file, &sky.images, "images", is_image)?,
            None => Vec::new(),
        };
        let trajectory = match &recipe.camera.trajectory {
            Some(path) => trajectory::read(&file.resolve(path))?,
            None => Vec::new(),
        };
        let times = match recipe.output.interval_s {
            None => trajectory.iter().map(|pose| pose.time_s).collect(),
            Some(_) => None,
        };
        let object_files = ObjectFiles::new(&file)?;
        let mut bases = Vec::new();
        for name in &recipe.scene.0 {
            bases.push(Base::open(
                name,
                &file.resolve(name),
                &recipe.scene_options,
                !recipe.looks.is_empty(),
            )?);
        }
        if bases.is_empty() {
            bases.extend(Base::floor());
        }
        let inertial = Inertial::open(recipe, catalog);
        let inertial = inertial.map_err(|wrong| unfit(&file, wrong.place, wrong.problem, wrong.remedy))?;
        let mut context = Self {
            random: Random::new(recipe.seed),
            bases,
            object_files,
            object_textures,
            look_textures,
            sky_images,
            times,
            trajectory,
            inertial,
            motion: None,
            annotators,
            needs: Needs {
                objects: formats.iter().any(|format| format.needs.objects),
                stereo: formats.iter().any(|format| format.needs.stereo),
            },
            formats,
            units,
            models: Models::default(),
            engine: None,
            findings,
            file,
        };
        context.check_times()?;
        context.motion = context.open_motion()?;
        let findings = context.check_inertial()?;
        context.findings.extend(findings);
        Ok(context)
    }

    /// Returns the units of a model of the recipe.
    pub(crate) fn units(&self, model: &str) -> &Units {
        &self.units[model]
    }

    /// Returns the files that the recipe names, and the files in the folders that it names.
    pub(crate) fn inputs(&self) -> Vec<PathBuf> {
        let recipe = &self.file.recipe;
        let named = recipe
            .scene
            .0
            .iter()
            .chain(&recipe.camera.trajectory)
            .chain(&recipe.unit.calibration);
        let objects = self.object_files.entries.iter().map(|entry| entry.path.clone());
        let images = self.object_textures.iter().chain(&self.look_textures).flatten();
        let mut inputs: Vec<PathBuf> = named
            .map(|path| self.file.resolve(path))
            .chain(objects)
            .chain(images.chain(&self.sky_images).cloned())
            .collect();
        inputs.sort();
        inputs.dedup();
        inputs
    }

    /// Creates an error about a value of the recipe.
    pub(crate) fn unfit(
        &self,
        place: &str,
        problem: impl Into<Message>,
        remedy: impl Into<Message>,
    ) -> GenerateError {
        unfit(&self.file, place, problem, remedy)
    }
}

fn unfit(
    file: &RecipeFile,
    place: &str,
    problem: impl Into<Message>,
    remedy: impl Into<Message>,
) -> GenerateError {
    GenerateError::Unfit {
        recipe: file.path.clone(),
        place: place.to_owned(),
        problem: problem.into(),
        remedy: remedy.into(),
    }
}

/// Returns the units of each model of a recipe.
fn units(
    file: &RecipeFile,
    catalog: &Catalog,
) -> Result<(BTreeMap<String, Units>, Vec<Finding>), GenerateError> {
    let recipe = &file.recipe;
    let (mut all, mut findings) = (BTreeMap::new(), Vec::new());
    for model in &recipe.camera.model.0 {
        let device = catalog.device(model).map_err(|error| GenerateError::Model {
            recipe: file.path.clone(),
            error,
        })?;
        let units = match (&recipe.unit.calibration, recipe.unit.population) {
            (Some(path), _) => {
                let (twin, more) = unit::open(catalog, device, &file.resolve(path), false)?;
                findings.extend(more);
                Units::One(Box::new(twin))
            }
            (None, Some(PopulationKind::Factory)) => {
                let population = Population::new(&catalog.nominal(device), recipe.seed);
                findings.push(population.finding());
                Units::Population(Box::new(population))
            }
            (None, None) => Units::One(Box::new(catalog.nominal(device))),
        };
        all.insert(model.clone(), units);
    }
    Ok((all, findings))
}

/// Returns the formats of a recipe.
fn formats(file: &RecipeFile) -> Result<Vec<&'static FormatKind>, GenerateError> {
    let mut formats: Vec<&'static FormatKind> = Vec::new();
    for name in &file.recipe.output.formats.0 {
        let format = FormatKind::find(name)
            .map_err(|remedy| unfit(file, "output.formats", format!("unknown format '{name}'"), remedy))?;
        if formats.iter().any(|other| other.name == format.name) {
            return Err(unfit(
                file,
                "output.formats",
                format!("{name} appears twice"),
                "remove one of the two",
            ));
        }
        formats.push(format);
    }
    let varies = |quantity: &Quantity| quantity.range()[0] != quantity.range()[1];
    let scales = |rule: &ObjectRule| varies(&rule.scale) || rule.size_m.as_ref().is_some_and(varies);
    let describes = formats.iter().find(|format| format.needs.objects);
    if let (Some(format), Some(rule)) = (describes, file.recipe.objects.iter().position(scales)) {
        return Err(unfit(
            file,
            &format!(
                "objects.{rule}.{}",
                if varies(&file.recipe.objects[rule].scale) {
                    "scale"
                } else {
                    "size_m"
                }
            ),
            format!("{} describes objects by models of one size", format.name),
            "give a number instead of a distribution, or several rules with a number each",
        ));
    }
    Ok(formats)
}
