//! Valid names for ROS.

use std::collections::BTreeSet;

/// Returns a unique name of letters, digits and `_` that does not start with a digit; other characters become `_` (ROS 2's rules
/// for a part of a topic's name, also used for frames).
pub fn unique_name(name: &str, taken: &mut BTreeSet<String>) -> String {
    let allowed = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let mut clean: String = name.chars().map(allowed).collect();
    // Repeated underscores are not allowed.
    while clean.contains("__") {
        clean = clean.replace("__", "_");
    }
    if clean.trim_matches('_').is_empty() {
        clean = "camera".to_owned();
    } else if clean.starts_with(|c: char| c.is_ascii_digit()) {
        clean.insert(0, '_');
    }
    let clean = clean.trim_end_matches('_');
    let candidates = (1u32..).map(|n| match n {
        1 => clean.to_owned(),
        n => format!("{clean}_{n}"),
    });
    for candidate in candidates {
        if taken.insert(candidate.clone()) {
            return candidate;
        }
    }
    clean.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converts_names() {
        let mut taken = BTreeSet::from(["world".to_owned()]);
        let names = ["left", "OAK-D Pro/left", "left", "3d", "ä..b_", "", "world"];
        let made = names.map(|name| unique_name(name, &mut taken));
        assert_eq!(
            made,
            [
                "left",
                "OAK_D_Pro_left",
                "left_2",
                "_3d",
                "_b",
                "camera",
                "world_2"
            ]
        );
    }
}
