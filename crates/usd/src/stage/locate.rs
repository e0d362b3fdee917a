use openusd::usda;

/// Larger layers are not searched: each step parses up to all of it.
const LARGEST: usize = 4 << 20;

/// The line at which parsing a text layer fails: the fewest lines that fail in the same words. The parser does not
/// say where it stopped, but it reads in order, so more lines change nothing.
pub(super) fn failing_line(text: &str) -> Option<usize> {
    if text.len() > LARGEST {
        return None;
    }
    let message = |text: &str| usda::parse(text).err().map(|error| format!("{error:#}"));
    let whole = message(text)?;
    let ends: Vec<usize> = text
        .match_indices('\n')
        .map(|(at, _)| at + 1)
        .chain([text.len()])
        .collect();
    // A text that is cut short fails in these words from its first line on.
    if whole.contains("nexpected end") {
        return Some(text.lines().count());
    }
    let same = |lines: usize| message(&text[..ends[lines]]).is_some_and(|message| message == whole);
    let (mut fewest, mut most) = (0, ends.len() - 1);
    while fewest < most {
        let middle = usize::midpoint(fewest, most);
        if same(middle) {
            most = middle;
        } else {
            fewest = middle + 1;
        }
    }
    Some(fewest + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_value_is_found_and_a_missing_end_is_at_the_end() {
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
