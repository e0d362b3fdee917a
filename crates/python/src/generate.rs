use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

use oaktwin::catalog::Catalog;
use oaktwin::generate::recipe::{RecipeFile, Texts};
use oaktwin::generate::{GenerateError, GenerateOptions, Generator};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::error;
use crate::finding;
use crate::threads;

/// Generates a data set of random scenes from a recipe, as `oaktwin generate` does.
///
/// recipe: the TOML file.
/// output: the folder of the data set.
/// frames: the first frame and the frame after the last one, such as (0, 100); by default all frames of the recipe.
/// resume: whether an existing data set is completed or extended.
/// formats: the names of formats instead of the recipe's, such as ["bop", "coco"].
/// seed: the seed instead of the recipe's.
/// workers: the number of frames that are made at the same time; by default that of the processors, if there is enough memory.
/// only_frames: whether files that span frames are left to another call with resume=True. Several processes, also on several
///     machines with a common folder, can make different frames of one data set in this way.
///
/// Returns a mapping: "frames", the number of frames that were made, "skipped", those that were complete already, "missing", those of
/// the recipe that are not there, "files" and "bytes".
///
/// Warns with oaktwin.FindingWarning. Raises oaktwin.Error for an invalid recipe or an impossible placement; what is complete
/// remains and can be resumed, also after Ctrl-C.
#[pyfunction]
#[pyo3(signature = (recipe, output, *, frames = None, resume = false, formats = None, seed = None, workers = None, only_frames = false))]
#[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
#[expect(clippy::too_many_arguments, reason = "options of Python")]
pub(crate) fn generate(
    py: Python<'_>,
    recipe: PathBuf,
    output: PathBuf,
    frames: Option<(u64, u64)>,
    resume: bool,
    formats: Option<Vec<String>>,
    seed: Option<u64>,
    workers: Option<usize>,
    only_frames: bool,
) -> PyResult<Py<PyDict>> {
    let options = GenerateOptions {
        frames: frames.map(|(first, end)| first..end),
        resume,
        workers,
        only_frames,
    };
    let made = threads::interruptible(py, |stop| {
        let mut file = RecipeFile::read(&recipe)?;
        if let Some(formats) = formats {
            file.recipe.output.formats = Texts(formats);
        }
        file.recipe.seed = seed.unwrap_or(file.recipe.seed);
        let generator = Generator::open(file, Catalog::builtin())?;
        let watch = |_| match stop.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        generator.generate(&output, &options, &watch)
    })?;
    let made = made.map_err(|cause: GenerateError| error(cause))?;
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
