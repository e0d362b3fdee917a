use std::ops::Range;

/// The brackets and ends of statements in a text layer that are not inside strings, asset paths or comments.
pub(super) struct Structure<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The strings so far with escape sequences.
    pub(super) escaped: Vec<Quoted>,
}

/// A string in a text layer.
#[derive(Debug)]
pub(super) struct Quoted {
    /// The bytes between the quotes.
    pub(super) content: Range<usize>,
    /// The length of the quotes on each side: 1 or 3.
    pub(super) marks: usize,
}

impl<'a> Structure<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            at: 0,
            escaped: Vec::new(),
        }
    }

    /// Skips to the end of a text that a delimiter opened and closes, or to the end of the layer if it is not closed.
    fn skip_delimited(&mut self, open: usize, close: &[u8]) {
        self.at += open;
        while self.at < self.bytes.len() && !self.bytes[self.at..].starts_with(close) {
            self.at += 1;
        }
        self.at += close.len();
    }

    fn skip_string(&mut self, quote: &[u8]) {
        self.at += quote.len();
        let start = self.at;
        let mut has_escapes = false;
        while self.at < self.bytes.len() {
            if self.bytes[self.at..].starts_with(quote) {
                if has_escapes {
                    self.escaped.push(Quoted {
                        content: start..self.at,
                        marks: quote.len(),
                    });
                }
                self.at += quote.len();
                return;
            }
            let is_escape = self.bytes[self.at] == b'\\';
            has_escapes |= is_escape;
            self.at += 1 + usize::from(is_escape);
        }
    }
}

impl Iterator for Structure<'_> {
    type Item = (usize, u8);

    fn next(&mut self) -> Option<Self::Item> {
        while let Some(&byte) = self.bytes.get(self.at) {
            let rest = &self.bytes[self.at..];
            match byte {
                b'#' => {
                    while self.bytes.get(self.at).is_some_and(|byte| *byte != b'\n') {
                        self.at += 1;
                    }
                }
                b'"' | b'\'' => {
                    let triple = [byte; 3];
                    if rest.starts_with(&triple) {
                        self.skip_string(&triple);
                    } else {
                        self.skip_string(&[byte]);
                    }
                }
                b'@' if rest.starts_with(b"@@@") => self.skip_delimited(3, b"@@@"),
                b'@' => self.skip_delimited(1, b"@"),
                b'/' if rest.starts_with(b"/*") => self.skip_delimited(2, b"*/"),
                b'{' | b'}' | b'(' | b')' | b'[' | b']' | b'\n' | b';' => {
                    self.at += 1;
                    return Some((self.at - 1, byte));
                }
                _ => self.at += 1,
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ignores_brackets_in_strings_comments_and_asset_paths() {
        let text = br#"#usda 1.0 (((
def "a(" { string s = """ ]]] " """ asset p = @x(y@ asset q = @@@a@b{@@@ /* don't ( */ string t = 'don\'t(' }"#;
        let seen: Vec<u8> = Structure::new(text).map(|(_, byte)| byte).collect();
        assert_eq!(seen, b"\n{}");
    }
}
