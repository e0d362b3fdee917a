//! The options of a depth sensor as keyword arguments.

use std::path::PathBuf;

use oaktwin::diagnostic::suggest;
use oaktwin::sensor::{
    EngineKind, EngineRef, OptionValue, ParameterFile, Scalar, SensorOption, SensorOptions, assignment,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyString};

use crate::array::readable;
use crate::engine::PythonEngine;
use crate::error::{error, reading, wrong};

/// Reads options from the keyword arguments of a function. `others` are the arguments that it also has.
pub(crate) fn sensor_options(
    function: &str,
    others: &[&str],
    keywords: Option<&Bound<'_, PyDict>>,
    is_offered: fn(&SensorOption) -> bool,
) -> PyResult<SensorOptions> {
    let mut options = SensorOptions::default();
    let Some(keywords) = keywords else {
        return Ok(options);
    };
    let fresh = keywords.get_item("seed")?;
    let offered = || SensorOption::without_files().filter(|option| is_offered(option));
    for name in keywords.keys() {
        let name: String = name.extract()?;
        if !offered().any(|option| option.name == name) {
            let known = offered().map(|option| option.name).chain(others.iter().copied());
            let remedy = suggest(&name, known);
            let text = format!("{function}() got an unexpected keyword argument '{name}'; {remedy}");
            return Err(PyTypeError::new_err(text));
        }
    }
    if function != "DepthSensor" && fresh.is_some_and(|seed| seed.is_none()) {
        let is = format!("is None, but {function}() does not tell which seed is drawn");
        return Err(wrong("seed", is, "pass a number"));
    }
    for option in offered() {
        let Some(value) = keywords.get_item(option.name)?.filter(|value| !value.is_none()) else {
            continue;
        };
        if matches!(option.value, OptionValue::Assignments)
            && let Some(file) = parameter_file(option.name, &value)?
        {
            file.1.apply(&mut options).map_err(|found| {
                wrong(
                    &file.0,
                    format_args!("{}: {}", found.name, found.what),
                    &found.remedy,
                )
            })?;
            continue;
        }
        if option.name == "engine" {
            options.engine = Some(engine(option.name, &value)?);
            continue;
        }
        for text in texts(option, &value)? {
            (option.set)(&mut options, &text).map_err(error)?;
        }
    }
    Ok(options)
}

/// Returns an engine: one of ours by its name, or a callable.
pub(crate) fn engine(name: &str, value: &Bound<'_, PyAny>) -> PyResult<EngineRef> {
    match value.extract::<&str>() {
        Ok(text) => EngineKind::parse(text).map(EngineRef::from).map_err(error),
        Err(_) if value.is_callable() => PythonEngine::of(value),
        Err(_) => Err(mistyped(name, value, "the name of an engine, or a callable")),
    }
}

/// Reads parameters of an engine from a `Fit` or a file, and returns them with the place for messages; `None` for a mapping.
fn parameter_file(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Option<(String, ParameterFile)>> {
    if value.hasattr("items")? {
        return Ok(None);
    }
    if value.hasattr("toml")? {
        let text: String = value.getattr("toml")?.extract()?;
        let file = ParameterFile::parse(&text);
        let file = file.map_err(|(what, remedy)| wrong(name, what, remedy))?;
        return Ok(Some((name.to_owned(), file)));
    }
    let kinds = "a mapping of parameters by name, the path of a file, or a Fit";
    let path: PathBuf = value.extract().map_err(|_| mistyped(name, value, kinds))?;
    if path.to_string_lossy().contains('\n') {
        let remedy = format!("pass {kinds}");
        return Err(wrong(name, "is a text of several lines, not a path", remedy));
    }
    let file = ParameterFile::read(&path).map_err(|found| reading(&path, &found))?;
    Ok(Some((path.display().to_string(), file)))
}

/// Returns a change of a stereo pair as text: a text, or a mapping from names to numbers.
pub(crate) fn drift(name: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
    if !value.hasattr("items")? {
        let kinds = "a mapping such as {\"yaw\": 0.3}";
        return value.extract().map_err(|_| mistyped(name, value, kinds));
    }
    let all = assignments(name, value)?.into_iter();
    let all: Vec<String> = all.map(|(name, value)| format!("{name}={value}")).collect();
    Ok(all.join(","))
}

/// Returns a seed of fresh entropy, as NumPy draws it, if the keyword arguments have `seed=None`.
pub(crate) fn fresh_seed(py: Python<'_>, keywords: Option<&Bound<'_, PyDict>>) -> PyResult<Option<u64>> {
    match keywords
        .map(|keywords| keywords.get_item("seed"))
        .transpose()?
        .flatten()
    {
        Some(seed) if seed.is_none() => entropy(py).map(Some),
        _ => Ok(None),
    }
}

/// Returns a seed, or one of fresh entropy for None.
pub(crate) fn seed_or_entropy(seed: &Bound<'_, PyAny>) -> PyResult<u64> {
    if seed.is_none() {
        entropy(seed.py())
    } else {
        whole("seed", seed)
    }
}

fn entropy(py: Python<'_>) -> PyResult<u64> {
    py.import("secrets")?.call_method1("randbits", (64,))?.extract()
}

/// Returns the keyword arguments that give these options.
pub(crate) fn keywords<'py>(
    py: Python<'py>,
    options: &SensorOptions,
    is_offered: fn(&SensorOption) -> bool,
) -> PyResult<Bound<'py, PyDict>> {
    let keywords = PyDict::new(py);
    for option in SensorOption::without_files().filter(|option| is_offered(option)) {
        let values = (option.get)(options);
        let Some(first) = values.first() else {
            continue;
        };
        if option.name == "engine"
            && let Some(engine) = PythonEngine::in_options(options)
        {
            keywords.set_item(option.name, &engine.object)?;
            continue;
        }
        match option.value {
            OptionValue::Flag => keywords.set_item(option.name, true)?,
            OptionValue::Number => keywords.set_item(option.name, first.parse::<u64>()?)?,
            OptionValue::Text(..) | OptionValue::File | OptionValue::Choice(..) => {
                keywords.set_item(option.name, first)?;
            }
            OptionValue::List(_) => keywords.set_item(option.name, values)?,
            OptionValue::Assignments => {
                let mapping = PyDict::new(py);
                for text in &values {
                    let (name, value) = assignment(text).map_err(error)?;
                    mapping.set_item(name, value)?;
                }
                keywords.set_item(option.name, mapping)?;
            }
        }
    }
    Ok(keywords)
}

/// Returns the values of an option as texts.
fn texts(option: &SensorOption, value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    let name = option.name;
    match option.value {
        OptionValue::Flag => {
            let is_set: bool = value
                .extract()
                .map_err(|_| mistyped(name, value, "True or False"))?;
            Ok(is_set.then(|| "true".to_owned()).into_iter().collect())
        }
        OptionValue::Number => whole::<u64>(name, value).map(|number| vec![number.to_string()]),
        OptionValue::Choice(..) if value.is_instance_of::<PyInt>() || value.is_instance_of::<PyFloat>() => {
            Ok(vec![value.str()?.to_string()])
        }
        OptionValue::Text(_, names) if names().is_empty() => Ok(vec![drift(name, value)?]),
        OptionValue::Text(..) | OptionValue::Choice(..) => {
            let text = value.extract().map_err(|_| mistyped(name, value, "a string"))?;
            Ok(vec![text])
        }
        OptionValue::List(_) => strings(name, value),
        OptionValue::File => Ok(Vec::new()),
        OptionValue::Assignments => {
            let all = assignments(name, value)?.into_iter();
            Ok(all.map(|(name, value)| format!("{name}={value}")).collect())
        }
    }
}

/// Returns a list of strings. A single string is rejected, since it is a sequence of strings too.
pub(crate) fn strings(argument: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    if let Ok(text) = value.cast::<PyString>() {
        let is = format!("must be a list of strings (got {})", text.repr()?);
        return Err(wrong(argument, is, format_args!("write [{}]", text.repr()?)));
    }
    let all = value
        .try_iter()
        .and_then(|all| all.map(|one| one?.extract()).collect());
    all.map_err(|_| mistyped(argument, value, "a list of strings"))
}

/// Returns the numbers of items of a batch: numbers, or a mask.
pub(crate) fn item_numbers(argument: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<usize>> {
    let numpy = value.py().import("numpy")?;
    let wrong = || mistyped(argument, value, "the numbers of items, or a mask");
    let mut array = readable(argument, value).map_err(|_| wrong())?.into_any();
    if array.getattr("dtype")?.getattr("kind")?.extract::<char>()? == 'b' {
        array = numpy.call_method1("flatnonzero", (array,))?;
    }
    let is_empty = array.getattr("size")?.extract::<usize>()? == 0;
    let numbers = array.call_method0("ravel")?.call_method0("tolist")?;
    match numbers.extract() {
        Ok(numbers) => Ok(numbers),
        // NumPy makes an array of floats of an empty list.
        Err(_) if is_empty => Ok(Vec::new()),
        Err(_) => Err(wrong()),
    }
}

/// Returns a whole number of an unsigned type.
pub(crate) fn whole<T: TryFrom<u64>>(argument: &str, value: &Bound<'_, PyAny>) -> PyResult<T> {
    let number = value
        .extract::<u64>()
        .ok()
        .and_then(|number| T::try_from(number).ok());
    number.ok_or_else(|| {
        let range = format!("a whole number from 0 to 2**{} - 1", 8 * size_of::<T>());
        mistyped(argument, value, &range)
    })
}

/// Returns a whole number of an unsigned type, or None.
pub(crate) fn maybe_whole<T: TryFrom<u64>>(argument: &str, value: &Bound<'_, PyAny>) -> PyResult<Option<T>> {
    (!value.is_none()).then(|| whole(argument, value)).transpose()
}

/// Returns an error for a value of the wrong type.
pub(crate) fn mistyped(argument: &str, value: &Bound<'_, PyAny>, expected: &str) -> PyErr {
    let got = value
        .repr()
        .map_or_else(|_| "an object".to_owned(), |repr| shortened(&repr.to_string()));
    wrong(
        argument,
        format_args!("invalid value {got}"),
        format_args!("pass {expected}"),
    )
}

fn shortened(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    match line.char_indices().nth(60) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}

/// Returns the text of a value: true or false, also of NumPy's type, and whole numbers without a fraction, which integers accept.
fn assigned(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(flag) = value.extract::<bool>() {
        return Ok(flag.to_string());
    }
    let text = value.str()?.to_string();
    let whole = text
        .strip_suffix(".0")
        .filter(|whole| whole.parse::<i64>().is_ok());
    Ok(match whole {
        Some(whole) if !value.is_instance_of::<PyString>() => whole.to_owned(),
        _ => text,
    })
}

/// Converts a mapping from names to numbers, strings or booleans to the assignments of a command line.
pub(crate) fn assignments(option: &str, parameters: &Bound<'_, PyAny>) -> PyResult<Vec<(String, Scalar)>> {
    let items = parameters
        .call_method0("items")
        .map_err(|_| mistyped(option, parameters, "a dictionary from names to values"))?;
    let assignment = |item: PyResult<Bound<'_, PyAny>>| {
        let (name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item?.extract()?;
        let name = name
            .extract()
            .map_err(|_| mistyped(option, &name, "names as keys"))?;
        Ok((name, Scalar::of(&assigned(&value)?)))
    };
    items.try_iter()?.map(assignment).collect()
}
