use openusd::sdf::Path;

/// The maximum depth of prims, and of dictionaries in text. The library's run time grows with the cube of the depth.
pub(super) const MAX_DEPTH: usize = 256;

/// Returns why the USD library cannot follow a path to the root, if it cannot. The library takes paths
/// apart as text: the parent of a path with a stray `}` is the path itself.
pub(super) fn defect(path: &Path) -> Option<String> {
    let text = path.as_str();
    if text.bytes().filter(|byte| *byte == b'/').count() > MAX_DEPTH {
        return Some(format!("is more than {MAX_DEPTH} prims deep"));
    }
    // Every step makes other paths shorter.
    if !text.contains(['{', '}', '[', ']']) {
        return None;
    }
    let mut ancestor = path.clone();
    while let Some(parent) = ancestor.parent() {
        if parent.as_str().len() >= ancestor.as_str().len() {
            return Some("is not a valid path".to_owned());
        }
        ancestor = parent;
    }
    None
}

/// The beginning of a path, to be shown.
pub(super) fn beginning(path: &str) -> String {
    let mut start: String = path.chars().take(60).collect();
    if start.len() < path.len() {
        start.push('…');
    }
    start
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_paths_that_do_not_lead_to_the_root() {
        let defect = |text: &str| defect(&Path::new(text).unwrap());
        for sound in [
            "/",
            "/A/B.c:d",
            "/A{v=s}B{w=}",
            "/A{v=s}B.c",
            "A.b",
            "/A.b{c",
            "..",
        ] {
            assert_eq!(defect(sound), None, "{sound}");
        }
        for broken in ["/A}b", "/A.b}c", "/A/B.c}d", "A.b}c", "/A}"] {
            assert_eq!(defect(broken).as_deref(), Some("is not a valid path"), "{broken}");
        }
        let deep = |depth: usize| "/A".repeat(depth);
        assert_eq!(defect(&deep(MAX_DEPTH)), None);
        assert!(defect(&deep(MAX_DEPTH + 1)).unwrap().contains("deep"));
    }
}
