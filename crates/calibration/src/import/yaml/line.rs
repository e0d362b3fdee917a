use super::Problem;

/// A line with content, without its comment.
#[derive(Clone, Copy, Debug)]
pub(super) struct YamlLine<'a> {
    /// The number in the file, from 1.
    pub(super) number: usize,
    /// The column of the first character, from 0.
    pub(super) indent: usize,
    /// The content, trimmed.
    pub(super) text: &'a str,
}

/// Returns the lines of the first document.
pub(super) fn lines(text: &str) -> Result<Vec<YamlLine<'_>>, Problem> {
    let mut lines: Vec<YamlLine<'_>> = Vec::new();
    for (number, whole) in (1..).zip(text.lines()) {
        if let Some(c) = whole.chars().find(|c| c.is_control() && *c != '\t') {
            return Err(Problem::new(
                number,
                format!("contains the control character U+{:04X}", u32::from(c)),
            ));
        }
        let content = without_comment(whole).trim_end();
        let text = content.trim_start_matches(' ');
        if text.is_empty() || content.starts_with('%') {
            continue;
        }
        let marker = content == "---" || content == "...";
        if marker && !lines.is_empty() {
            break;
        }
        if marker {
            continue;
        }
        if text.starts_with('\t') {
            return Err(Problem::new(number, "indented by a tab instead of spaces"));
        }
        lines.push(YamlLine {
            number,
            indent: content.len() - text.len(),
            text,
        });
    }
    Ok(lines)
}

/// Returns the line up to a `#` at its start or after a blank, outside of quotes.
fn without_comment(line: &str) -> &str {
    let (mut quote, mut before) = (None, ' ');
    for (at, c) in line.char_indices() {
        match quote {
            Some(open) if c == open && !(open == '"' && before == '\\') => quote = None,
            Some(_) => {}
            None if c == '#' && before.is_whitespace() => return line.get(..at).unwrap_or(line),
            // A quote in the middle of a word is an apostrophe.
            None if (c == '"' || c == '\'') && !before.is_alphanumeric() => quote = Some(c),
            None => {}
        }
        before = c;
    }
    line
}
