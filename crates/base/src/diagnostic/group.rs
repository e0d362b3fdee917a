use std::collections::HashMap;
use std::fmt;

use crate::diagnostic::{Finding, Level, Message};

/// The number of places that a line lists.
const PLACES: usize = 8;

/// Findings that differ only in their places.
#[derive(Clone, Debug)]
pub struct FindingGroup<'a> {
    first: &'a Finding,
    places: Vec<&'a str>,
}

impl FindingGroup<'_> {
    /// The severity of the findings.
    #[must_use]
    pub fn level(&self) -> Level {
        self.first.level
    }
}

/// Groups findings that differ only in their places, in the order of the first of each.
#[must_use]
pub fn group(findings: &[Finding]) -> Vec<FindingGroup<'_>> {
    let mut groups: Vec<FindingGroup<'_>> = Vec::new();
    let mut known: HashMap<(&str, Level, &Message, &Message), usize> = HashMap::new();
    for finding in findings {
        let key = (finding.code, finding.level, &finding.message, &finding.remedy);
        let index = *known.entry(key).or_insert_with(|| {
            groups.push(FindingGroup {
                first: finding,
                places: Vec::new(),
            });
            groups.len() - 1
        });
        let places = &mut groups[index].places;
        if !places.contains(&finding.place.as_str()) {
            places.push(&finding.place);
        }
    }
    groups
}

/// `note[legacy-distortion]: /A, /B: …; remedy`
impl fmt::Display for FindingGroup<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let more = self.places.len().saturating_sub(PLACES);
        let mut places = self.places[..self.places.len() - more].join(", ");
        if more > 0 {
            places += &format!(" and {more} more");
        }
        self.first.write_at(f, &places)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(code: &'static str, place: &str, message: &str) -> Finding {
        Finding::new(code, Level::Note, place, message, "")
    }

    fn lines(findings: &[Finding]) -> Vec<String> {
        group(findings).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn equal_findings_share_a_line_with_their_places() {
        let findings = [
            finding("legacy", "/A", "3 attributes"),
            finding("units", "/A", "in metres"),
            finding("legacy", "/B", "3 attributes"),
            finding("legacy", "/B", "3 attributes"),
            finding("legacy", "/C", "5 attributes"),
        ];
        assert_eq!(
            lines(&findings),
            [
                "note[legacy]: /A, /B: 3 attributes",
                "note[units]: /A: in metres",
                "note[legacy]: /C: 5 attributes",
            ]
        );
    }

    #[test]
    fn a_line_lists_a_limited_number_of_places() {
        let findings: Vec<Finding> = (1..=10)
            .map(|i| finding("legacy", &format!("/{i}"), "old"))
            .collect();
        assert_eq!(
            lines(&findings),
            ["note[legacy]: /1, /2, /3, /4, /5, /6, /7, /8 and 2 more: old"]
        );
    }
}
