use std::fmt;
use std::str::FromStr;

use oaktwin_diagnostic::{fold_name, nearest};

use super::{
    Brightness, Decimation, DecimationMode, Filter, Median, PersistencyMode, Spatial, Speckle, Temporal,
    Threshold,
};
use crate::ParameterError;

/// The names of the filters in text.
pub const NAMES: [&str; 7] = [
    "median",
    "spatial",
    "temporal",
    "speckle",
    "decimation",
    "threshold",
    "brightness",
];

/// A filter of its text, `NAME` or `NAME:SETTING=VALUE,…`; what is not said has `DepthAI`'s default.
///
/// The settings: `median:size=3|5|7`, `spatial:alpha,delta,radius,iterations`, `temporal:alpha,delta,persistency` (a
/// number from 0 to 8 or `DepthAI`'s name), `speckle:range,difference`, `decimation:factor,mode` (`DepthAI`'s name),
/// `threshold:min,max` (mm), `brightness:min,max`. `DepthAI`'s names of settings are understood too.
///
/// # Errors
/// A name or setting that does not exist, with the nearest ones; a value that cannot be.
pub fn parse(text: &str) -> Result<Filter, ParameterError> {
    let (name, settings) = text.split_once(':').unwrap_or((text, ""));
    let known = find(name, &NAMES, "filter", text)?;
    let mut filter = match known {
        "median" => Filter::Median(Median::default()),
        "spatial" => Filter::Spatial(Spatial::default()),
        "temporal" => Filter::Temporal(Temporal::default()),
        "speckle" => Filter::Speckle(Speckle::default()),
        "decimation" => Filter::Decimation(Decimation::default()),
        "threshold" => Filter::Threshold(Threshold::default()),
        _ => Filter::Brightness(Brightness::default()),
    };
    for setting in settings
        .split(',')
        .map(str::trim)
        .filter(|setting| !setting.is_empty())
    {
        let (key, value) = setting.split_once('=').ok_or_else(|| {
            ParameterError::new(
                text,
                format!("{setting:?} has no value"),
                format!("write {setting}=VALUE"),
            )
        })?;
        set(&mut filter, key.trim(), value.trim(), text)?;
    }
    filter.check()?;
    Ok(filter)
}

impl FromStr for Filter {
    type Err = ParameterError;

    fn from_str(text: &str) -> Result<Self, ParameterError> {
        parse(text)
    }
}

fn set(filter: &mut Filter, key: &str, value: &str, text: &str) -> Result<(), ParameterError> {
    let keys: &[&str] = match filter {
        Filter::Median(_) => &["size", "kernel"],
        Filter::Spatial(_) => &[
            "alpha",
            "delta",
            "radius",
            "iterations",
            "holeFillingRadius",
            "numIterations",
        ],
        Filter::Temporal(_) => &["alpha", "delta", "persistency", "persistencyMode"],
        Filter::Speckle(_) => &["range", "difference", "speckleRange", "differenceThreshold"],
        Filter::Decimation(_) => &["factor", "mode", "decimationFactor", "decimationMode"],
        Filter::Threshold(_) => &["min", "max", "minRange", "maxRange"],
        Filter::Brightness(_) => &["min", "max", "minBrightness", "maxBrightness"],
    };
    let key = find(key, keys, "setting", text)?;
    let number = Number { key, value, text };
    match (filter, key) {
        (Filter::Median(median), _) => {
            *median = match value.trim_start_matches("KERNEL_") {
                "3" | "3x3" => Median::Kernel3x3,
                "5" | "5x5" => Median::Kernel5x5,
                "7" | "7x7" => Median::Kernel7x7,
                _ => return Err(number.error("3, 5 or 7")),
            }
        }
        (Filter::Spatial(spatial), "alpha") => spatial.alpha = number.read("a number from 0 to 1")?,
        (Filter::Spatial(spatial), "delta") => spatial.delta = number.read(DELTA)?,
        (Filter::Spatial(spatial), "radius" | "holeFillingRadius") => {
            spatial.hole_filling_radius = number.read("a whole number from 0 to 255")?;
        }
        (Filter::Spatial(spatial), _) => spatial.num_iterations = number.read("a whole number")?,
        (Filter::Temporal(temporal), "alpha") => temporal.alpha = number.read("a number from 0 to 1")?,
        (Filter::Temporal(temporal), "delta") => temporal.delta = number.read(DELTA)?,
        (Filter::Temporal(temporal), _) => {
            let modes = PersistencyMode::ALL;
            temporal.persistency_mode = number.choose(&modes, PersistencyMode::name)?;
        }
        (Filter::Speckle(speckle), "range" | "speckleRange") => {
            speckle.speckle_range = number.read("a whole number of pixels")?;
        }
        (Filter::Speckle(speckle), _) => speckle.difference_threshold = number.read("a whole number")?,
        (Filter::Decimation(decimation), "factor" | "decimationFactor") => {
            decimation.factor = number.read("1, 2, 3 or 4")?;
        }
        (Filter::Decimation(decimation), _) => {
            decimation.mode = number.choose(&DecimationMode::ALL, DecimationMode::name)?;
        }
        (Filter::Threshold(threshold), "min" | "minRange") => threshold.min_range = number.read(RANGE)?,
        (Filter::Threshold(threshold), _) => threshold.max_range = number.read(RANGE)?,
        (Filter::Brightness(brightness), "min" | "minBrightness") => {
            brightness.min_brightness = number.read("-1 to 255")?;
        }
        (Filter::Brightness(brightness), _) => brightness.max_brightness = number.read("0 to 256")?,
    }
    Ok(())
}

const DELTA: &str = "a whole number from 0 to 255: DepthAI keeps 8 bits of it";
const RANGE: &str = "whole millimetres from 0 to 65535";

struct Number<'a> {
    key: &'a str,
    value: &'a str,
    text: &'a str,
}

impl Number<'_> {
    fn read<T: FromStr>(&self, wanted: &str) -> Result<T, ParameterError> {
        self.value.parse().map_err(|_| self.error(wanted))
    }

    /// By its number or its name.
    fn choose<T: Copy>(&self, all: &[T], name: impl Fn(T) -> &'static str) -> Result<T, ParameterError> {
        if let Ok(number) = self.value.parse::<usize>() {
            let last = all.len() - 1;
            return all
                .get(number)
                .copied()
                .ok_or_else(|| self.error(&format!("0 to {last}, or a name")));
        }
        let names: Vec<&str> = all.iter().map(|&choice| name(choice)).collect();
        let found = find(self.value, &names, self.key, self.text)?;
        let named = all.iter().find(|&&choice| name(choice) == found);
        named.copied().ok_or_else(|| self.error("a name"))
    }

    fn error(&self, wanted: &str) -> ParameterError {
        let Self { key, value, text } = self;
        ParameterError::new(
            *text,
            format!("{value:?} cannot be its {key}"),
            format!("give {wanted}"),
        )
    }
}

/// The one of these names; case, hyphens and underscores do not matter.
fn find<'a>(name: &str, names: &[&'a str], what: &str, text: &str) -> Result<&'a str, ParameterError> {
    if let Some(found) = names.iter().find(|known| fold_name(known) == fold_name(name)) {
        return Ok(found);
    }
    let near = nearest(name, names.iter().copied());
    let remedy = if near.is_empty() {
        format!("use one of {}", names.join(", "))
    } else {
        format!("did you mean {}?", near.join(" or "))
    };
    Err(ParameterError::new(
        text,
        format!("there is no {what} {name:?}"),
        remedy,
    ))
}

/// As [`parse`] reads it, all settings named.
impl fmt::Display for Filter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.name())?;
        match self {
            Self::Median(median) => write!(f, "size={}", median.size()),
            Self::Spatial(s) => write!(
                f,
                "alpha={},delta={},radius={},iterations={}",
                s.alpha, s.delta, s.hole_filling_radius, s.num_iterations
            ),
            Self::Temporal(t) => {
                let mode = t.persistency_mode.name();
                write!(f, "alpha={},delta={},persistency={mode}", t.alpha, t.delta)
            }
            Self::Speckle(s) => write!(
                f,
                "range={},difference={}",
                s.speckle_range, s.difference_threshold
            ),
            Self::Decimation(d) => write!(f, "factor={},mode={}", d.factor, d.mode.name()),
            Self::Threshold(t) => write!(f, "min={},max={}", t.min_range, t.max_range),
            Self::Brightness(b) => write!(f, "min={},max={}", b.min_brightness, b.max_brightness),
        }
    }
}
