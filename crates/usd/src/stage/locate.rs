use openusd::usda;

/// The maximum size of a layer to search, in bytes: each step parses up to the whole layer.
const MAX_BYTES: usize = 4 << 20;

/// Returns the line at which parsing a text layer fails: the end of the shortest prefix that fails with the same
/// message. The parser does not report positions, but it reads in order, so later lines have no effect.
pub(super) fn failing_line(text: &str) -> Option<usize> {
    if text.len() > MAX_BYTES {
        return None;
    }
    let message = |text: &str| usda::parse(text).err().map(|error| format!("{error:#}"));
    let whole = message(text)?;
    let ends: Vec<usize> = text
        .match_indices('\n')
        .map(|(at, _)| at + 1)
        .chain([text.len()])
        .collect();
    // A truncated text fails with this message from its first line on.
    if whole.contains("nexpected end") {
        return Some(text.lines().count());
    }
    let same = |lines: usize| message(&text[..ends[lines]]).is_some_and(|message| message == whole);
    let (mut low, mut high) = (0, ends.len() - 1);
    while low < high {
        let middle = usize::midpoint(low, high);
        if same(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    Some(low + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_invalid_values_and_truncation() {
        let wrong =
            "#usda 1.0\ndef Camera \"Cam\"\n{\n    float focalLength = \"wide\"\n}\ndef \"Next\"\n{\n}\n";
        assert_eq!(failing_line(wrong), Some(4));
        assert_eq!(
            failing_line("#usda 1.0\ndef \"Cam\"\n{\n    float f = 2"),
            Some(4)
        );
        assert_eq!(failing_line("#usda 1.0\n"), None);
    }
}
