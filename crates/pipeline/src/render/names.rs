//! Folder names for cameras.

use std::collections::{BTreeMap, BTreeSet};

/// Returns a unique folder name for each camera, in order: the last part of its path, or the whole path if that is ambiguous,
/// with a number if even that is. Characters other than letters, digits, `-`, `_` and `.` become `_`; names are compared
/// without case. A name that Windows reserves for a device, such as `aux`, gets a leading `_`.
#[must_use]
pub fn folder_names<'a>(paths: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let paths: Vec<&str> = paths.into_iter().collect();
    let short = |path: &str| clean(path.rsplit('/').next().unwrap_or(path));
    let mut uses: BTreeMap<String, usize> = BTreeMap::new();
    for path in &paths {
        *uses.entry(short(path).to_lowercase()).or_default() += 1;
    }
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut names = Vec::with_capacity(paths.len());
    for path in paths {
        let mut name = short(path);
        if uses.get(&name.to_lowercase()).is_some_and(|uses| *uses > 1) {
            name = clean(path.trim_start_matches('/'));
        }
        let unique = (1..)
            .map(|n: u32| match n {
                1 => name.clone(),
                n => format!("{name}_{n}"),
            })
            .find(|candidate| !taken.contains(&candidate.to_lowercase()))
            .unwrap_or(name);
        taken.insert(unique.to_lowercase());
        names.push(unique);
    }
    names
}

fn clean(name: &str) -> String {
    const LONGEST: usize = 100;
    let kept = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    let cleaned: String = name.chars().map(|c| if kept(c) { c } else { '_' }).collect();
    // The end of a path is more specific than its beginning; leading dots would hide the folder or leave its parent.
    let tail = cleaned
        .get(cleaned.len().saturating_sub(LONGEST)..)
        .unwrap_or(&cleaned);
    let visible = tail.trim_start_matches('.').trim_end_matches('.');
    if visible.is_empty() {
        "camera".to_owned()
    } else if is_reserved(visible) {
        format!("_{visible}")
    } else {
        visible.to_owned()
    }
}

/// Whether Windows takes a name for a device, with any extension.
fn is_reserved(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or(name).to_ascii_lowercase();
    let numbered = |device: &str| {
        let number = stem.strip_prefix(device);
        number.is_some_and(|number| number.len() == 1 && number.bytes().all(|byte| byte.is_ascii_digit()))
    };
    matches!(stem.as_str(), "con" | "prn" | "aux" | "nul") || numbered("com") || numbered("lpt")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn prefers_short_names() {
        assert_eq!(folder_names(["/World/Left", "/World/Right"]), ["Left", "Right"]);
        assert_eq!(
            folder_names(["/A/Camera", "/B/camera", "/B/Other"]),
            ["A_Camera", "B_camera", "Other"]
        );
        assert_eq!(folder_names(["/A/x y", "/A/x:y"]), ["A_x_y", "A_x_y_2"]);
        assert_eq!(folder_names([".."]), ["camera"]);
        assert_eq!(
            folder_names(["/A/Aux", "/A/com1.left", "/A/com10", "/A/_aux"]),
            ["A_Aux", "_com1.left", "com10", "A__aux"]
        );
    }

    proptest! {
        #[test]
        fn names_are_unique_and_safe(paths in prop::collection::vec("(/[A-Za-z_ .é]{0,4}){1,3}", 0..12)) {
            let names = folder_names(paths.iter().map(String::as_str));
            let mut folded: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
            folded.sort();
            folded.dedup();
            prop_assert_eq!(folded.len(), paths.len());
            for name in names {
                prop_assert!(!name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\']));
            }
        }
    }
}
