use std::collections::BTreeMap;

use oaktwin_diagnostic::{Finding, Level, Message};

/// The maximum number of findings with the same code; more are only counted.
const MAX_PER_CODE: usize = 20;

/// Collects findings, a bounded number per code.
#[derive(Default)]
pub(in crate::stage) struct Findings {
    list: Vec<Finding>,
    counts: BTreeMap<&'static str, usize>,
}

impl Findings {
    /// Adds a warning.
    pub(in crate::stage) fn warn(
        &mut self,
        code: &'static str,
        place: &str,
        message: impl Into<Message>,
        remedy: &str,
    ) {
        self.push(Finding::new(code, Level::Warning, place, message, remedy));
    }

    /// Adds a finding.
    pub(in crate::stage) fn push(&mut self, finding: Finding) {
        let count = self.counts.entry(finding.code).or_default();
        *count += 1;
        if *count <= MAX_PER_CODE {
            self.list.push(finding);
        }
    }

    /// Returns the findings, and for each code with too many a finding with the number of omitted ones.
    pub(in crate::stage) fn into_list(mut self) -> Vec<Finding> {
        for (code, count) in self.counts {
            if let Some(more) = count.checked_sub(MAX_PER_CODE)
                && more > 0
            {
                self.list.push(Finding::new(
                    code,
                    Level::Warning,
                    "stage",
                    format!("{more} more of this kind"),
                    "",
                ));
            }
        }
        self.list
    }
}
