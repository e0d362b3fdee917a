//! The state of a fit.

use std::path::Path;

use super::Options;
use super::report::{NotFound, Parameter, Report};
use oaktwin_base::diagnostic::{Finding, Level, Message};

/// The state of a fit.
pub(super) struct Work<'a> {
    pub(super) report: Report,
    pub(super) options: &'a Options,
    pub(super) findings: Vec<Finding>,
}

impl Work<'_> {
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

    /// Moves the parameters of the systematic error before the parameters of the noise.
    pub(super) fn put_first(&mut self, mut parameters: Vec<Parameter>) {
        parameters.append(&mut self.report.parameters);
        self.report.parameters = parameters;
    }
}
