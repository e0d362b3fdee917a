//! What every crate tells people with: findings as values, and the nearest valid names for a misspelt one.

use std::fmt;

use serde::Serialize;

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// Worth knowing; nothing to do.
    Note,
    /// Odd: the result holds, but look at it.
    Warning,
    /// The result would be meaningless.
    Error,
}

/// Something found in an input: where, what, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// A short stable name for machines, `baseline-off`.
    pub code: &'static str,
    /// How bad it is.
    pub level: Level,
    /// Where: a field's path or a prim's path.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// What to do; empty where there is nothing to do.
    pub remedy: String,
}

impl Finding {
    /// A finding; the remedy may be empty.
    pub fn new(
        code: &'static str,
        level: Level,
        place: impl Into<String>,
        message: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            code,
            level,
            place: place.into(),
            message: message.into(),
            remedy: remedy.into(),
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

/// `warning[baseline-off]: extrinsics: …; remedy`
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}[{}]: {}: {}",
            self.level, self.code, self.place, self.message
        )?;
        if !self.remedy.is_empty() {
            write!(f, "; {}", self.remedy)?;
        }
        Ok(())
    }
}

/// Names compare equal without regard to case, spaces, hyphens and underscores.
#[must_use]
pub fn fold_name(name: &str) -> String {
    name.chars()
        .filter(|c| !matches!(c, ' ' | '-' | '_'))
        .flat_map(char::to_lowercase)
        .collect()
}

/// The candidates nearest to a misspelt name, best first, at most three. Empty where none is near.
#[must_use]
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let wanted = fold_name(name);
    let mut scored: Vec<(f64, &str)> = candidates
        .into_iter()
        .map(|candidate| (strsim::jaro_winkler(&wanted, &fold_name(candidate)), candidate))
        .filter(|(score, _)| *score > 0.75)
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    scored
        .into_iter()
        .take(3)
        .map(|(_, candidate)| candidate)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_forgives_case_and_hyphens() {
        let models = [
            "OAK-D Pro PoE",
            "OAK-D Pro W PoE",
            "OAK4-D",
            "OAK4-D Wide",
            "OAK-D ToF",
        ];
        assert_eq!(nearest("oak4d", models)[0], "OAK4-D");
        assert_eq!(nearest("OAK D TOFF", models)[0], "OAK-D ToF");
        assert!(nearest("kinect", models).is_empty());
    }

    #[test]
    fn a_finding_reads_as_one_line() {
        let f = Finding::new(
            "baseline-off",
            Level::Warning,
            "extrinsics",
            "8 cm",
            "recalibrate",
        );
        assert_eq!(
            f.to_string(),
            "warning[baseline-off]: extrinsics: 8 cm; recalibrate"
        );
    }
}
