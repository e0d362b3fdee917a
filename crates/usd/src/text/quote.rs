use std::fmt::Write;

/// Appends a quoted string: in single quotes if it holds double but no single quotes, else in double quotes, which are
/// tripled if it has line breaks.
pub(super) fn push_string(out: &mut String, text: &str) {
    let quote = if text.contains('"') && !text.contains('\'') {
        '\''
    } else {
        '"'
    };
    let multiline = text.contains('\n');
    let marks = if multiline { 3 } else { 1 };
    out.extend(std::iter::repeat_n(quote, marks));
    for c in text.chars() {
        match c {
            '\n' => out.push('\n'),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            '\\' => out.push_str("\\\\"),
            c if c == quote => out.extend(['\\', c]),
            c if c.is_ascii_control() => {
                let _ = write!(out, "\\x{:02x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.extend(std::iter::repeat_n(quote, marks));
}

/// Appends an asset path between at signs: three on each side if the path holds one.
pub(super) fn push_asset(out: &mut String, path: &str) {
    if path.contains('@') {
        out.push_str("@@@");
        out.push_str(&path.replace("@@@", "\\@@@"));
        out.push_str("@@@");
    } else {
        out.push('@');
        out.push_str(path);
        out.push('@');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn string(text: &str) -> String {
        let mut out = String::new();
        push_string(&mut out, text);
        out
    }

    /// The expected texts come from usd-core 24.5.
    #[test]
    fn quotes_strings_like_openusd() {
        for (text, quoted) in [
            ("plain é", "\"plain é\""),
            ("has \"quote\"", "'has \"quote\"'"),
            ("\"both\" and '", "\"\\\"both\\\" and '\""),
            ("tab\tx\\\u{1}", "\"tab\\tx\\\\\\x01\""),
            ("two\nlines", "\"\"\"two\nlines\"\"\""),
            ("two\n\"lines\"", "'''two\n\"lines\"'''"),
        ] {
            assert_eq!(string(text), quoted);
        }
    }

    #[test]
    fn quotes_asset_paths_with_at_signs() {
        let mut out = String::new();
        push_asset(&mut out, "./a.usd");
        push_asset(&mut out, "a@b.usd");
        assert_eq!(out, "@./a.usd@@@@a@b.usd@@@");
    }
}
