//! Decodes the escape sequences in the strings of a text layer, which the USD library keeps.
//!
//! Values in memory no longer show whether they come from a text layer, so the text is rewritten before the library reads
//! it, with quotes that need no escape sequences.

use std::borrow::Cow;

use super::Problem;
use super::structure::Structure;

/// A text layer without escape sequences.
#[derive(Debug, Default, PartialEq, Eq)]
pub(in crate::stage) struct Decoded {
    pub(in crate::stage) bytes: Vec<u8>,
    /// The lines that end in a decoded `\n`, counted from 1, ascending: the file has no line break there.
    breaks: Vec<usize>,
}

impl Decoded {
    /// Returns bytes that are not decoded.
    pub(super) fn verbatim(bytes: Vec<u8>) -> Self {
        Self {
            bytes,
            breaks: Vec::new(),
        }
    }

    /// Returns the line in the file that corresponds to a line of the decoded text.
    pub(in crate::stage) fn line_in_file(&self, line: usize) -> usize {
        line - self.breaks.partition_point(|end| *end < line)
    }
}

/// Decodes a layer. Most have no escape sequences and are returned unchanged.
pub(super) fn decode(bytes: Vec<u8>) -> Result<Decoded, Problem> {
    if bytes.contains(&b'\\')
        && let Ok(text) = std::str::from_utf8(&bytes)
    {
        let mut decoded = Decoded::default();
        let mut structure = Structure::new(&bytes);
        structure.by_ref().for_each(drop);
        let mut at = 0;
        let (mut line, mut line_in_file) = (1, 1);
        for string in &structure.escaped {
            let before = &text[at..string.content.start - string.marks];
            let content = unescape(&text[string.content.clone()]);
            let Some(quote) = quote(&content) else {
                let line = line_in_file + line_breaks(before);
                return Err(Problem::new(
                    format!("line {line}"),
                    "a string contains quotation marks of both kinds that no quotes can enclose",
                    "replace the triple quotation marks inside the string",
                ));
            };
            for part in [before, quote, &content, quote] {
                decoded.bytes.extend_from_slice(part.as_bytes());
            }
            let source = &text[at..string.content.end + string.marks];
            line += line_breaks(before);
            line_in_file += line_breaks(source);
            // Which of a string's line breaks are decoded does not matter: all lines within it are reported as its last.
            let decoded_breaks = line_breaks(&content) - line_breaks(&text[string.content.clone()]);
            decoded.breaks.extend(line..line + decoded_breaks);
            line += line_breaks(&content);
            at = string.content.end + string.marks;
        }
        decoded.bytes.extend_from_slice(&bytes[at..]);
        return Ok(decoded);
    }
    Ok(Decoded::verbatim(bytes))
}

fn line_breaks(text: &str) -> usize {
    text.bytes().filter(|byte| *byte == b'\n').count()
}

/// Returns quotes that enclose `content` without escape sequences. The library keeps backslashes only between triple ones.
fn quote(content: &str) -> Option<&'static str> {
    ["\"", "'"]
        .into_iter()
        .find(|quote| !content.contains(quote) && !content.contains('\\'))
        .or_else(|| {
            let encloses = |triple: &&str| !content.contains(triple) && !content.ends_with(&triple[..1]);
            ["\"\"\"", "'''"].into_iter().find(encloses)
        })
}

/// Decodes the content of a string as OpenUSD does: up to two hexadecimal or three octal digits make one byte, and an
/// unknown sequence is its character.
fn unescape(raw: &str) -> Cow<'_, str> {
    let mut bytes = Vec::with_capacity(raw.len());
    let mut rest = raw.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        rest = after;
        if byte != b'\\' {
            bytes.push(byte);
            continue;
        }
        let Some((&kind, after)) = rest.split_first() else {
            break;
        };
        let digits = |from: &[u8], radix: u32, maximum: usize| {
            let digit = |byte: &u8| char::from(*byte).to_digit(radix);
            let count = from.iter().take(maximum).take_while(|byte| digit(byte).is_some());
            count.count()
        };
        let (byte, length) = match kind {
            b'a' => (0x07, 1),
            b'b' => (0x08, 1),
            b'f' => (0x0c, 1),
            b'n' => (b'\n', 1),
            b'r' => (b'\r', 1),
            b't' => (b'\t', 1),
            b'v' => (0x0b, 1),
            b'x' => {
                let count = digits(after, 16, 2);
                (number(&after[..count], 16), 1 + count)
            }
            b'0'..=b'7' => {
                let count = digits(rest, 8, 3);
                (number(&rest[..count], 8), count)
            }
            other => (other, 1),
        };
        bytes.push(byte);
        rest = &rest[length..];
    }
    match String::from_utf8(bytes) {
        Ok(text) => Cow::Owned(text),
        Err(error) => Cow::Owned(String::from_utf8_lossy(error.as_bytes()).into_owned()),
    }
}

/// Returns the lowest byte of a number.
fn number(digits: &[u8], radix: u8) -> u8 {
    digits.iter().fold(0, |number: u8, digit| {
        let digit = char::from(*digit).to_digit(radix.into()).unwrap_or(0);
        number
            .wrapping_mul(radix)
            .wrapping_add(u8::try_from(digit).unwrap_or(0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(text: &str) -> String {
        String::from_utf8(decode(text.as_bytes().to_vec()).unwrap().bytes).unwrap()
    }

    /// The expected values are OpenUSD 26.11's; `test_usd_strings.py` compares with the library itself.
    #[test]
    fn decodes_like_openusd() {
        for (raw, text) in [
            (r"a\tb\r\a\b\f\v", "a\tb\r\u{7}\u{8}\u{c}\u{b}"),
            (r"\x41 \x4142 \x4g \xg", "A A42 \u{4}g \0g"),
            (r"\101 \1012 \18 \8 \0 \400", "A A2 \u{1}8 8 \0 \0"),
            (r"\q \? \é \u00e9", "q ? é u00e9"),
            (r"\xc3\xa9 \xff", "é \u{fffd}"),
            (r"\\x41", r"\x41"),
        ] {
            assert_eq!(unescape(raw), text, "{raw}");
        }
    }

    #[test]
    fn encloses_what_quotes_can() {
        for (text, rewritten) in [
            (r#"s = "a\"b""#, r#"s = 'a"b'"#),
            (r#"s = """a\"""" t"#, r#"s = 'a"' t"#),
            (r#"s = "\\\"'""#, r#"s = """\"'""""#),
            (r#"s = "'\\\"""#, r#"s = ''''\"'''"#),
            (
                "# \"\\t\"\n/* don't \\ */ s = '\\n'",
                "# \"\\t\"\n/* don't \\ */ s = \"\n\"",
            ),
            (r"a = @C:\t.usd@", r"a = @C:\t.usd@"),
            (r#"s = "open \t"#, r#"s = "open \t"#),
        ] {
            assert_eq!(decoded(text), rewritten);
        }
        let neither = decode(b"\ns = \"\\t'''\\\"\"".to_vec()).unwrap_err();
        assert_eq!(neither.place, "line 2");
    }

    #[test]
    fn keeps_the_lines_of_the_file() {
        let text = "1\n\"\\n\\n\"\n3 \"\"\"\\\"4\n5\"\"\"\n\"\\n\" 6\n7";
        let decoded = decode(text.as_bytes().to_vec()).unwrap();
        let rewritten = std::str::from_utf8(&decoded.bytes).unwrap();
        let lines = rewritten.lines().enumerate();
        let file: Vec<(usize, &str)> = lines
            .map(|(at, line)| (decoded.line_in_file(at + 1), line))
            .collect();
        let expected = [
            (1, "1"),
            (2, "\""),
            (2, ""),
            (2, "\""),
            (3, "3 '\"4"),
            (4, "5'"),
            (5, "\""),
            (5, "\" 6"),
            (6, "7"),
        ];
        assert_eq!(file, expected);
    }
}
