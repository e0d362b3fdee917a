use std::collections::BTreeMap;

use oaktwin_diagnostic::{Finding, Level, Message};

/// More of one kind are only counted.
const MOST_OF_A_KIND: usize = 20;

/// Collects findings; of each kind a bounded number.
#[derive(Default)]
pub(in crate::stage) struct Findings {
    list: Vec<Finding>,
    counts: BTreeMap<&'static str, usize>,
}

impl Findings {
    /// Something odd: the rest is rendered all the same.
    pub(in crate::stage) fn warn(
        &mut self,
        code: &'static str,
        place: &str,
        message: impl Into<Message>,
        remedy: &str,
    ) {
        self.push(Finding::new(code, Level::Warning, place, message, remedy));
    }

    /// Takes a finding in.
    pub(in crate::stage) fn push(&mut self, finding: Finding) {
        let count = self.counts.entry(finding.code).or_default();
        *count += 1;
        if *count <= MOST_OF_A_KIND {
            self.list.push(finding);
        }
    }

    /// All of them, and for each kind of which there were too many a line that says how many.
    pub(in crate::stage) fn into_list(mut self) -> Vec<Finding> {
        for (code, count) in self.counts {
            if let Some(more) = count.checked_sub(MOST_OF_A_KIND)
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
