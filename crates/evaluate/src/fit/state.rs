//! The state of a fit.

use std::path::Path;

use super::FitOptions;
use super::report::{FitReport, NotFound, Parameter};
use oaktwin_base::diagnostic::{Finding, Level, Message};

/// The state of a fit.
pub(super) struct FitState<'a> {
    pub(super) report: FitReport,
    pub(super) options: &'a FitOptions,
    pub(super) findings: Vec<Finding>,
}

impl FitState<'_> {
    pub(super) fn without_images(&mut self, path: &Path, names: &[&'static str]) {
        for name in names {
            self.report.not_found.push(NotFound {
                name,
                why: format!("{} contains errors instead of images", path.display()),
            });
        }
    }

    pub(super) fn not_found(&mut self, name: &'static str, why: &str, remedy: impl Into<Message>) {
        self.report.not_found.push(NotFound {
            name,
            why: why.to_owned(),
        });
        self.findings.push(Finding::new(
            "not-identifiable",
            Level::Warning,
            name,
            format!("cannot be determined: {why}"),
            remedy,
        ));
    }

    /// Removes fitted parameters that are so uncertain that the measurements do not determine them. Returns whether none was.
    pub(super) fn keep_determined(&mut self) -> bool {
        let (kept, lost): (Vec<Parameter>, Vec<Parameter>) = std::mem::take(&mut self.report.parameters)
            .into_iter()
            .partition(is_determined);
        self.report.parameters = kept;
        for parameter in &lost {
            let why = "its 95 % interval is wider than any camera's values";
            self.not_found(
                parameter.name,
                why,
                "record more distances, and several frames of each",
            );
        }
        lost.is_empty()
    }

    /// Moves the parameters of the systematic error before the parameters of the noise.
    pub(super) fn put_first(&mut self, mut parameters: Vec<Parameter>) {
        parameters.append(&mut self.report.parameters);
        self.report.parameters = parameters;
    }
}

/// Whether a parameter and its interval are numbers that a camera may have.
fn is_determined(parameter: &Parameter) -> bool {
    let most = match parameter.unit {
        "electrons" => 1e9,
        _ if parameter.name == "focalLength" => 1e6,
        _ => 1e3,
    };
    let ends = parameter.interval_95.into_iter().flatten();
    let mut numbers = ends.chain([parameter.value]);
    !parameter.is_fitted || numbers.all(|number| number.abs() <= most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absurd_intervals_determine_nothing() {
        let fitted = |value, interval_95| Parameter {
            name: "bias",
            value,
            interval_95,
            unit: "px",
            what: "",
            is_fitted: true,
        };
        assert!(is_determined(&fitted(0.2, Some([-0.1, 0.5]))));
        assert!(is_determined(&fitted(0.2, None)));
        for (value, interval) in [
            (0.2, Some([-1e133, 1e133])),
            (f64::NAN, None),
            (0.2, Some([f64::NEG_INFINITY, f64::INFINITY])),
            (1e9, None),
        ] {
            assert!(!is_determined(&fitted(value, interval)), "{value} {interval:?}");
        }
    }
}
