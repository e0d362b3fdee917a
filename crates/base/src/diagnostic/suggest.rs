/// Of more valid names than this, half as many are listed.
const MAX_LISTED: usize = 60;

/// A name reduced to what matters in a comparison: lower case, without spaces, hyphens and underscores.
#[must_use]
pub fn fold_name(name: &str) -> String {
    name.chars()
        .filter(|c| !matches!(c, ' ' | '-' | '_'))
        .flat_map(char::to_lowercase)
        .collect()
}

/// The candidates nearest to a misspelt name, best first, at most three. Empty if none is near. The name may be the last part of a
/// path.
#[must_use]
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let wanted = fold_name(name);
    let mut scored: Vec<(f64, &str)> = candidates
        .into_iter()
        .map(|candidate| {
            let is_last = candidate
                .rsplit('/')
                .next()
                .is_some_and(|last| fold_name(last) == wanted);
            let score = strsim::jaro_winkler(&wanted, &fold_name(candidate));
            (if is_last { 1.0 } else { score }, candidate)
        })
        .filter(|(score, _)| *score > 0.75)
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    scored
        .into_iter()
        .take(3)
        .map(|(_, candidate)| candidate)
        .collect()
}

/// The remedy for an unknown name: `did you mean 'a' or 'b'?`, or `expected one of …` if no candidate is near.
#[must_use]
pub fn suggest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> String {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    suggestion(&nearest(name, candidates.iter().copied()), &candidates)
}

/// The same remedy from the nearest names, best first, and all valid ones, for an error that keeps them as data.
#[must_use]
pub fn suggestion(nearest: &[impl AsRef<str>], valid: &[impl AsRef<str>]) -> String {
    if let Some((last, others)) = nearest.split_last() {
        let last = last.as_ref();
        let others: Vec<String> = others.iter().map(|name| format!("'{}'", name.as_ref())).collect();
        return match others.is_empty() {
            true => format!("did you mean '{last}'?"),
            false => format!("did you mean {} or '{last}'?", others.join(", ")),
        };
    }
    let valid: Vec<&str> = valid.iter().map(AsRef::as_ref).collect();
    match valid[..] {
        [] => "remove it".to_owned(),
        [only] => format!("expected '{only}'"),
        _ if valid.len() > MAX_LISTED => {
            let more = valid.len() - MAX_LISTED / 2;
            format!(
                "expected one of {} or {more} others",
                valid[..MAX_LISTED / 2].join(", ")
            )
        }
        _ => format!("expected one of {}", valid.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODELS: [&str; 5] = [
        "OAK-D Pro PoE",
        "OAK-D Pro W PoE",
        "OAK4-D",
        "OAK4-D Wide",
        "OAK-D ToF",
    ];

    #[test]
    fn the_last_part_of_a_path_is_enough() {
        let links: Vec<String> = (0..100).map(|link| format!("arm/link_{link}")).collect();
        let names = || links.iter().map(String::as_str);
        assert_eq!(nearest("link_7", names())[0], "arm/link_7");
        let listed = suggest("other", names());
        assert!(listed.ends_with("arm/link_29 or 70 others"), "{listed}");
    }

    #[test]
    fn nearest_ignores_case_and_hyphens() {
        assert_eq!(nearest("oak4d", MODELS)[0], "OAK4-D");
        assert_eq!(nearest("OAK D TOFF", MODELS)[0], "OAK-D ToF");
        assert!(nearest("kinect", MODELS).is_empty());
    }

    #[test]
    fn near_names_are_suggested() {
        assert_eq!(suggest("jiter", ["jitter", "bias"]), "did you mean 'jitter'?");
        let none: [&str; 0] = [];
        assert_eq!(suggestion(&["a", "b"], &none), "did you mean 'a' or 'b'?");
        assert_eq!(
            suggestion(&["a", "b", "c"], &none),
            "did you mean 'a', 'b' or 'c'?"
        );
    }

    #[test]
    fn without_a_near_name_all_valid_ones_are_listed() {
        assert_eq!(suggest("kinect", ["x", "y"]), "expected one of x, y");
        assert_eq!(suggest("kinect", ["x"]), "expected 'x'");
        assert_eq!(suggest("kinect", []), "remove it");
    }
}
