use std::path::{Path, PathBuf, absolute};
use std::sync::Arc;

use numpy::{PyArray1, PyArray3, PyArrayMethods};
use oaktwin::dataset::FrameCamera;
use oaktwin::generate::recipe::{RecipeFile, Texts};
use oaktwin::generate::{GenerateError, GenerateOptions, Generated, Generator};
use oaktwin::sensor::EngineRef;
use pyo3::exceptions::{PyIndexError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PySlice, PyTuple};

use crate::arguments::{formats, frame, frame_range, frames, optional};
use crate::camera::Camera;
use crate::engine::{PythonEngine, serve_all};
use crate::error::{error, reading, wrong};
use crate::layers::layers;
use crate::models::Models;
use crate::pose::{Of, rows};
use crate::progress::ProgressCallback;
use crate::settings::{self, mistyped};
use crate::{finding, json, threads};

/// A recipe of a data set of random scenes, with its scenes and the list of its objects.
///
/// source: the TOML file, or its contents as a mapping, whose paths are relative to the working directory.
/// formats: the names of formats instead of the recipe's, such as ["bop", "coco"].
/// seed: the seed instead of the recipe's.
/// save_scenes: whether each arrangement is also written as a USD scene, scenes/NUMBER.usda.
/// catalog: a folder of TOML files with additional devices and sensors.
/// engine: an engine instead of the recipe's: its name, or a callable as for `DepthSensor`.
///
/// A frame depends only on the recipe, the seed and its number: it has the same bytes on every machine, whichever frames are made
/// before it. Unpickling reads the files again.
///
/// Raises oaktwin.Error for an invalid recipe, with the line and the nearest name, FileNotFoundError or another OSError for a file that cannot be
/// read.
#[pyclass(frozen, module = "oaktwin")]
#[derive(Debug)]
pub(crate) struct Recipe {
    source: RecipeSource,
    formats: Option<Vec<String>>,
    seed: Option<u64>,
    save_scenes: bool,
    models: Models,
    engine: Option<EngineRef>,
    generator: Generator,
}

/// Where a recipe is from.
#[derive(Debug)]
enum RecipeSource {
    File(PathBuf),
    /// A mapping, with the folder that its paths are relative to.
    Mapping(Py<PyAny>),
}

impl RecipeSource {
    fn of(object: &Bound<'_, PyAny>) -> PyResult<Self> {
        if object.hasattr("items")? {
            return Ok(Self::Mapping(object.clone().unbind()));
        }
        let path = object.extract();
        let kinds = "the path of a TOML file, or a mapping";
        path.map(Self::File)
            .map_err(|_| mistyped("source", object, kinds))
    }

    fn object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self {
            Self::File(path) => Ok(path.into_pyobject(py)?.into_any()),
            Self::Mapping(mapping) => Ok(mapping.bind(py).clone()),
        }
    }
}

/// Whether Ray makes the frames, and where.
#[derive(FromPyObject)]
pub(crate) enum Ray {
    Switch(bool),
    Address(String),
}

#[pymethods]
impl Recipe {
    #[new]
    #[pyo3(signature = (source, *, formats = None, seed = None, save_scenes = false, catalog = None, engine = None))]
    fn new(
        py: Python<'_>,
        source: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = formats)] formats: Option<Vec<String>>,
        #[pyo3(from_py_with = optional::seed)] seed: Option<u64>,
        save_scenes: bool,
        catalog: Option<PathBuf>,
        engine: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let models = Models::open(catalog)?;
        let engine = engine
            .map(|engine| settings::engine("engine", engine))
            .transpose()?;
        let source = RecipeSource::of(source)?;
        let file = match &source {
            RecipeSource::File(path) => threads::run(py, || RecipeFile::read(path))?
                .map_err(|cause| reading(path, &GenerateError::from(cause)))?,
            RecipeSource::Mapping(mapping) => {
                let values: serde_json::Value = json::from_python("source", mapping.bind(py))?;
                let folder = std::env::current_dir()?;
                RecipeFile::of_values(&folder, &values).map_err(error)?
            }
        };
        let path = file.path.clone();
        let generator = threads::run(py, || {
            let mut file = file;
            if let Some(formats) = &formats {
                file.recipe.output.formats = Texts(formats.clone());
            }
            file.recipe.seed = seed.unwrap_or(file.recipe.seed);
            file.recipe.output.scenes |= save_scenes;
            match engine.clone() {
                Some(engine) => Generator::open_with(file, models.get(), engine),
                None => Generator::open(file, models.get()),
            }
        })?;
        let generator = generator.map_err(|cause: GenerateError| match &source {
            RecipeSource::File(_) => reading(&path, &cause),
            RecipeSource::Mapping(_) => error(cause),
        })?;
        Ok(Self {
            source,
            formats,
            seed,
            save_scenes,
            models,
            engine,
            generator,
        })
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<((Bound<'py, PyAny>,), Bound<'py, PyDict>)> {
        let options = PyDict::new(py);
        options.set_item("formats", &self.formats)?;
        options.set_item("seed", self.seed)?;
        options.set_item("save_scenes", self.save_scenes)?;
        options.set_item("catalog", self.models.folder())?;
        options.set_item("engine", self.engine_object(py)?)?;
        Ok(((self.source.object(py)?,), options))
    }

    fn __repr__(&self) -> String {
        let name = match &self.source {
            RecipeSource::File(path) => path.display().to_string(),
            RecipeSource::Mapping(_) => "of a mapping".to_owned(),
        };
        format!("<oaktwin.Recipe {name} ({} frames)>", self.frames())
    }

    /// The number of frames.
    #[getter]
    fn frames(&self) -> u64 {
        self.generator.frames()
    }

    fn __len__(&self) -> PyResult<usize> {
        usize::try_from(self.frames()).map_err(error)
    }

    fn __iter__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let py = slf.py();
        let numbers = py
            .import("builtins")?
            .getattr("range")?
            .call1((slf.get().frames(),))?;
        py.import("builtins")?
            .getattr("map")?
            .call1((slf.getattr("__getitem__")?, numbers))
    }

    /// Makes a frame in memory, or several for a slice.
    ///
    /// Returns a `Sample`: a dictionary of the arrays whose files a data set has, by the names of their annotators.
    ///
    /// Raises IndexError for a frame that the recipe does not have, and oaktwin.Error if an object or the camera has no place.
    fn __getitem__<'py>(slf: &Bound<'py, Self>, index: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = slf.py();
        let count = slf.get().__len__()?;
        if let Ok(slice) = index.cast::<PySlice>() {
            let numbers = slice.call_method1("indices", (count,))?;
            let numbers = py
                .import("builtins")?
                .getattr("range")?
                .call1(numbers.cast_into::<PyTuple>()?)?;
            let samples = numbers.try_iter()?.map(|number| Self::__getitem__(slf, &number?));
            return Ok(PyList::new(py, samples.collect::<PyResult<Vec<_>>>()?)?.into_any());
        }
        let number = index
            .call_method0("__index__")
            .and_then(|number| number.extract::<i64>());
        let number = number.map_err(|_| {
            let text = index
                .get_type()
                .name()
                .map_or_else(|_| "object".to_owned(), |name| name.to_string());
            PyTypeError::new_err(format!("frame: is a {text}; pass a whole number, or a slice"))
        })?;
        let from_end =
            i64::try_from(count).map_or(number, |count| if number < 0 { number + count } else { number });
        match u64::try_from(from_end) {
            Ok(frame) if frame < slf.get().frames() => slf.get().sample(py, frame),
            _ => {
                let text =
                    format!("frame: {number} is beyond the {count} frames of the recipe; choose one of them");
                Err(PyIndexError::new_err(text))
            }
        }
    }

    /// Returns all random choices of a frame: the scene, the objects with their poses, the lights, the camera.
    ///
    /// Raises oaktwin.Error if an object or the camera has no place.
    fn explain<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = frame)] frame: u64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let explained = threads::run(py, || self.generator.explain(frame))?;
        json::to_python(py, &explained.map_err(error)?)
    }

    /// Returns a contact sheet of the first frames as an sRGB image (H, W, 3) of uint8: colour, exact depth and measured depth.
    ///
    /// frames: the number of frames, at least 1.
    /// progress: as in `generate`.
    #[pyo3(signature = (frames = 16, *, progress = ProgressCallback::default()), text_signature = "($self, frames=16, *, progress=False)")]
    fn preview<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = frames)] frames: u64,
        progress: ProgressCallback,
    ) -> PyResult<Bound<'py, PyArray3<u8>>> {
        if frames == 0 {
            return Err(wrong("frames", "is 0", "pass at least 1"));
        }
        let sheet = serve_all(py, self.python().as_slice(), progress, |task| {
            self.generator.preview(frames, &|progress| task.watch(progress))
        })?;
        let sheet = sheet.map_err(error)?;
        let shape = [sheet.height() as usize, sheet.width() as usize, 3];
        PyArray1::from_slice(py, sheet.pixels().as_flattened()).reshape(shape)
    }

    /// Generates the data set, or a part of it, in a folder, as oaktwin.generate does.
    ///
    /// output: the folder of the data set.
    /// frames: the frames, such as range(0, 100), or the first one and the one after the last: (0, 100); by default all of the recipe.
    /// resume: whether an existing data set is completed or extended.
    /// verify: whether the contents of finished files are compared, not only their lengths, and changed frames are made again; with resume.
    /// workers: the number of frames to make at once; by default one per processor, or fewer if memory is short.
    /// only_frames: whether files that span frames are left to another call with resume=True. Several processes, also on several
    ///     machines with a common folder, can make different frames of one data set in this way.
    /// ray: whether Ray distributes the frames: True, or the address of a cluster, such as "auto", "host:6379" or
    ///     "ray://host:10001".
    /// progress: whether a progress bar is shown on standard error; or a callable that gets the numbers of frames that are done and in total.
    ///     Not with Ray, which shows its own.
    #[pyo3(
        signature = (output, *, frames = None, resume = false, verify = false, workers = None, only_frames = false, ray = Ray::Switch(false),
            progress = ProgressCallback::default()),
        text_signature = "($self, output, *, frames=None, resume=False, verify=False, workers=None, only_frames=False, ray=False, progress=False)"
    )]
    #[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    fn generate(
        &self,
        py: Python<'_>,
        output: PathBuf,
        #[pyo3(from_py_with = frame_range)] frames: Option<(u64, u64)>,
        resume: bool,
        verify: bool,
        #[pyo3(from_py_with = optional::workers)] workers: Option<usize>,
        only_frames: bool,
        ray: Ray,
        progress: ProgressCallback,
    ) -> PyResult<Py<PyDict>> {
        if verify && !resume {
            return Err(wrong(
                "verify",
                "applies to existing data sets",
                "pass resume=True too",
            ));
        }
        let options = GenerateOptions {
            frames: frames.map(|(first, end)| first..end),
            resume,
            verify,
            workers,
            only_frames,
        };
        let made = match ray {
            Ray::Switch(false) => self.generate_here(py, &output, &options, progress),
            Ray::Switch(true) => self.generate_with_ray(py, &output, &options, None),
            Ray::Address(address) => self.generate_with_ray(py, &output, &options, Some(address)),
        }?;
        finding::warn(py, &made.findings)?;
        let result = PyDict::new(py);
        for (name, value) in [
            ("frames", made.made),
            ("skipped", made.skipped),
            ("missing", made.missing),
            ("files", made.files),
            ("bytes", made.bytes),
        ] {
            result.set_item(name, value)?;
        }
        Ok(result.unbind())
    }
}

impl Recipe {
    /// The engine, if it is written in Python.
    fn python(&self) -> Option<Arc<PythonEngine>> {
        self.engine.as_ref().and_then(PythonEngine::behind)
    }

    fn engine_object<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        Ok(match (&self.engine, self.python()) {
            (_, Some(engine)) => Some(engine.object.bind(py).clone()),
            (Some(engine), None) => Some(engine.name.to_string().into_pyobject(py)?.into_any()),
            (None, None) => None,
        })
    }

    /// A frame in memory.
    fn sample<'py>(&self, py: Python<'py>, frame: u64) -> PyResult<Bound<'py, PyAny>> {
        let engine = self.python();
        let made = serve_all(py, engine.as_slice(), ProgressCallback::default(), |_| {
            self.generator.sample(frame)
        })?;
        let (shots, findings) = made.map_err(error)?;
        finding::warn(py, &findings)?;
        let all = PyDict::new(py);
        let [cameras, poses, measured] = [PyDict::new(py), PyDict::new(py), PyDict::new(py)];
        let objects = PyList::empty(py);
        for shot in shots {
            let name = shot.render_product.clone().unwrap_or_else(|| "camera".to_owned());
            let prefix = shot
                .render_product
                .as_ref()
                .map_or_else(String::new, |name| format!("{name}/"));
            let Some(view) = shot.view else { continue };
            let mount_from_world = shot.world_from_mount.inverse();
            let camera = |view: &FrameCamera| {
                let body_from_camera = mount_from_world * view.world_from_camera;
                Camera {
                    name: name.clone(),
                    ..Camera::rectified(view.camera, body_from_camera)
                }
            };
            cameras.set_item(&name, camera(&view))?;
            poses.set_item(&name, Of::Camera.array(py, &view.world_from_camera)?)?;
            if let Some(view) = &shot.sensor_view {
                measured.set_item(&name, camera(view))?;
            }
            for (layer, array) in layers(py, shot.frame, view.camera.intrinsics.size)? {
                all.set_item(format!("{prefix}{layer}"), array)?;
            }
            if objects.is_empty() {
                for object in &shot.objects {
                    let about = PyDict::new(py);
                    about.set_item("path", &object.path)?;
                    about.set_item("name", &object.model.name)?;
                    about.set_item("label", &object.model.label)?;
                    about.set_item("world_from_object", rows(py, &object.world_from_model)?)?;
                    objects.append(about)?;
                }
            }
        }
        let class = py.import("oaktwin._datasets")?.getattr("Sample")?;
        class.call1((all, frame, cameras, poses, measured, objects))
    }

    fn generate_here(
        &self,
        py: Python<'_>,
        output: &Path,
        options: &GenerateOptions,
        progress: ProgressCallback,
    ) -> PyResult<Generated> {
        let made = serve_all(py, self.python().as_slice(), progress, |task| {
            self.generator
                .generate(output, options, &|progress| task.watch(progress))
        })?;
        made.map_err(error)
    }

    fn generate_with_ray(
        &self,
        py: Python<'_>,
        output: &Path,
        options: &GenerateOptions,
        address: Option<String>,
    ) -> PyResult<Generated> {
        if options.only_frames {
            return Err(wrong(
                "only_frames",
                "has no effect with Ray, whose workers make only frames",
                "remove it",
            ));
        }
        let generation = threads::run(py, || self.generator.start(output, options))?;
        let mut generation = generation.map_err(error)?;
        if generation.total() > 0 {
            let job = PyDict::new(py);
            let recipe = match &self.source {
                RecipeSource::File(path) => absolute(path)?.into_pyobject(py)?.into_any(),
                RecipeSource::Mapping(mapping) => mapping.bind(py).clone(),
            };
            job.set_item("recipe", recipe)?;
            job.set_item("engine", self.engine_object(py)?)?;
            job.set_item("output", absolute(output)?)?;
            job.set_item("formats", &self.formats)?;
            job.set_item("seed", self.seed)?;
            job.set_item("save_scenes", self.save_scenes)?;
            job.set_item("catalog", self.models.folder())?;
            let batches = generation.batches().iter();
            let batches: Vec<_> = batches.map(|batch| (batch.start, batch.end)).collect();
            let settings = PyDict::new(py);
            settings.set_item("address", address)?;
            settings.set_item("workers", options.workers)?;
            let frames = py.import("oaktwin._ray")?.getattr("frames")?;
            for batch in frames.call((batches, job), Some(&settings))?.try_iter()? {
                let (start, end) = batch?.extract()?;
                py.detach(|| generation.add(&(start..end))).map_err(error)?;
            }
        }
        threads::run(py, || generation.finish())?.map_err(error)
    }
}
