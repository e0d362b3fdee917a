//! The words of the text format: white space, comments, names, numbers, strings, asset paths and paths of prims.

use super::super::inspect::Problem;
use super::escapes::unescape;

/// What to do about a text layer that this reader refuses.
const CONVERT: &str =
    "correct the line; if OpenUSD reads the file, convert it: `usdcat --out NEW.usdc OLD.usda`";

pub(super) type Outcome<T> = Result<T, Problem>;

/// A position in the text of a layer.
#[derive(Clone, Debug)]
pub(super) struct Lexer<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Lexer<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// Returns an error at the current position.
    pub(super) fn error<T>(&self, what: impl Into<String>) -> Outcome<T> {
        self.error_at(self.at, what)
    }

    /// Returns an error at a position that [`Lexer::position`] has returned.
    pub(super) fn error_at<T>(&self, at: usize, what: impl Into<String>) -> Outcome<T> {
        let breaks = self.bytes().iter().take(at).filter(|byte| **byte == b'\n');
        Err(Problem::new(
            format!("line {}", 1 + breaks.count()),
            what,
            CONVERT,
        ))
    }

    /// Returns an error that says what was expected, and what the text has.
    pub(super) fn expected<T>(&self, what: &str) -> Outcome<T> {
        let rest = &self.text[self.at..];
        let word: String = rest
            .split_terminator(char::is_whitespace)
            .next()
            .unwrap_or_default()
            .chars()
            .take(40)
            .collect();
        if word.is_empty() {
            return self.error(format!("ends where {what} is expected: it is truncated"));
        }
        self.error(format!("has `{word}` where {what} is expected"))
    }

    pub(super) fn position(&self) -> usize {
        self.at
    }

    fn bytes(&self) -> &'a [u8] {
        self.text.as_bytes()
    }

    fn rest(&self) -> &'a [u8] {
        &self.bytes()[self.at..]
    }

    /// Skips the first line and returns it.
    pub(super) fn line(&mut self) -> &'a str {
        let rest = &self.text[self.at..];
        let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    /// Skips white space and comments.
    pub(super) fn skip_space(&mut self) {
        while let Some(&byte) = self.bytes().get(self.at) {
            match byte {
                b' ' | b'\t' | b'\n' | b'\r' | b'\x0b' | b'\x0c' => self.at += 1,
                b'#' => self.skip_line(),
                b'/' if self.rest().starts_with(b"//") => self.skip_line(),
                b'/' if self.rest().starts_with(b"/*") => {
                    let end = self.text[self.at + 2..].find("*/");
                    self.at = end.map_or(self.text.len(), |end| self.at + end + 4);
                }
                _ => return,
            }
        }
    }

    fn skip_line(&mut self) {
        let rest = self.rest();
        self.at += rest
            .iter()
            .position(|byte| matches!(byte, b'\n' | b'\r'))
            .unwrap_or(rest.len());
    }

    /// Returns the next byte after white space, without taking it.
    pub(super) fn peek(&mut self) -> Option<u8> {
        self.skip_space();
        self.bytes().get(self.at).copied()
    }

    /// Takes the next byte after white space if it is `byte`.
    pub(super) fn eat(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    /// Takes `byte`, which must be next.
    pub(super) fn expect(&mut self, byte: u8) -> Outcome<()> {
        if self.eat(byte) {
            return Ok(());
        }
        self.expected(&format!("`{}`", char::from(byte)))
    }

    /// Skips the commas and semicolons that separate the items of a list or a block.
    pub(super) fn skip_separators(&mut self) {
        while self.eat(b',') || self.eat(b';') {}
    }

    /// Takes a name without name spaces; `None` if there is none.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        self.skip_space();
        self.name(|_| false)
    }

    /// Takes the name of a property, whose name spaces colons separate.
    pub(super) fn property_name(&mut self) -> Outcome<&'a str> {
        self.skip_space();
        match self.name(|c| c == ':') {
            Some(name) if !name.ends_with(':') && !name.contains("::") => Ok(name),
            _ => self.expected("the name of a property"),
        }
    }

    /// Takes the type of a prim, whose name spaces dots or colons separate; `None` if there is none.
    pub(super) fn prim_type(&mut self) -> Option<&'a str> {
        self.skip_space();
        self.name(|c| matches!(c, '.' | ':'))
    }

    fn name(&mut self, separates: fn(char) -> bool) -> Option<&'a str> {
        let rest = &self.text[self.at..];
        let begins = |c: char| c == '_' || c.is_alphabetic();
        if !rest.starts_with(begins) {
            return None;
        }
        let end = rest.find(|c: char| !(c == '_' || c.is_alphanumeric() || separates(c)));
        let name = &rest[..end.unwrap_or(rest.len())];
        self.at += name.len();
        Some(name)
    }

    /// Takes the next name if it is `word`.
    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        let mut ahead = self.clone();
        let found = ahead.word() == Some(word);
        if found {
            *self = ahead;
        }
        found
    }

    /// Takes a number, as text; `None` if there is none.
    pub(super) fn number(&mut self) -> Option<&'a str> {
        self.skip_space();
        let rest = self.rest();
        let sign = usize::from(matches!(rest.first(), Some(b'-' | b'+')));
        let digits = |from: usize| {
            rest[from..]
                .iter()
                .take_while(|byte| byte.is_ascii_digit())
                .count()
        };
        let whole = digits(sign);
        let mut end = sign + whole;
        let mut count = whole;
        if rest.get(end) == Some(&b'.') {
            let fraction = digits(end + 1);
            count += fraction;
            end += 1 + fraction;
        }
        if count == 0 {
            let names = [&b"inf"[..], b"nan"];
            let name = names.into_iter().find(|name| rest[sign..].starts_with(name))?;
            end = sign + name.len();
        } else if matches!(rest.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(rest.get(end + 1), Some(b'-' | b'+')));
            let exponent = digits(end + 1 + sign);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        let continues = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.');
        if rest.get(end).is_some_and(continues) {
            return None;
        }
        let number = &self.text[self.at..self.at + end];
        self.at += end;
        Some(number)
    }

    /// Whether a string is next.
    pub(super) fn at_string(&mut self) -> bool {
        matches!(self.peek(), Some(b'"' | b'\''))
    }

    /// Takes a string and decodes its escape sequences.
    pub(super) fn string(&mut self) -> Outcome<String> {
        if !self.at_string() {
            return self.expected("a string");
        }
        let start = self.at;
        let quote = self.bytes()[start];
        let is_triple = self.rest().starts_with(&[quote; 3]);
        let marks = if is_triple { 3 } else { 1 };
        let content = start + marks;
        let mut at = content;
        while let Some(&byte) = self.bytes().get(at) {
            match byte {
                b'\\' => at += 2,
                b'\n' | b'\r' if !is_triple => break,
                _ if byte == quote && (!is_triple || self.bytes()[at..].starts_with(&[quote; 3])) => {
                    // Up to two more quotation marks before the closing ones belong to the string.
                    let more = self.bytes()[at..]
                        .iter()
                        .take_while(|byte| **byte == quote)
                        .count()
                        - marks;
                    at += if is_triple { more.min(2) } else { 0 };
                    self.at = at + marks;
                    // In a binary layer, a zero byte ends a string.
                    return Ok(unescape(&self.text[content..at]).replace('\0', "\u{fffd}"));
                }
                _ => at += 1,
            }
        }
        self.error_at(start, "a string is not closed")
    }

    /// Takes an asset path between `@` or `@@@`.
    pub(super) fn asset(&mut self) -> Outcome<String> {
        if self.peek() != Some(b'@') {
            return self.expected("an asset path");
        }
        let start = self.at;
        let rest = &self.text[start..];
        let line = &rest[..rest.find(['\n', '\r']).unwrap_or(rest.len())];
        if let Some(content) = line.strip_prefix("@@@") {
            let mut from = 0;
            while let Some(found) = content[from..].find("@@@") {
                let end = from + found;
                if content[..end].ends_with('\\') {
                    from = end + 3;
                    continue;
                }
                let more = content[end + 3..]
                    .bytes()
                    .take_while(|byte| *byte == b'@')
                    .count();
                let end = end + more.min(2);
                self.at = start + 3 + end + 3;
                return Ok(content[..end].replace("\\@@@", "@@@"));
            }
        } else if let Some(end) = line[1..].find('@') {
            self.at = start + end + 2;
            return Ok(line[1..=end].to_owned());
        }
        self.error_at(start, "an asset path is not closed")
    }

    /// Takes the path of a prim or a property between `<` and `>`.
    pub(super) fn path(&mut self) -> Outcome<&'a str> {
        if self.peek() != Some(b'<') {
            return self.expected("a path");
        }
        let rest = &self.text[self.at + 1..];
        match rest.find(['>', '\n']) {
            Some(end) if rest[end..].starts_with('>') => {
                self.at += end + 2;
                Ok(rest[..end].trim())
            }
            _ => self.error("a path is not closed"),
        }
    }

    /// Skips a value of any kind.
    pub(super) fn skip_value(&mut self) -> Outcome<()> {
        let mut depth = 0_usize;
        loop {
            match self.peek() {
                Some(b'"' | b'\'') => drop(self.string()?),
                Some(b'@') => drop(self.asset()?),
                Some(b'<') => drop(self.path()?),
                Some(b'(' | b'[' | b'{') => {
                    depth += 1;
                    self.at += 1;
                }
                Some(b')' | b']' | b'}') if depth > 0 => {
                    depth -= 1;
                    self.at += 1;
                }
                Some(b',' | b';' | b'=' | b':' | b'.' | b'&') if depth > 0 => self.at += 1,
                Some(_) => {
                    if self.number().is_none() && self.word().is_none() {
                        return self.expected("a value");
                    }
                }
                None => return self.expected("a value"),
            }
            if depth == 0 {
                return Ok(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_openusds() {
        for number in [
            "1", "-1", "1.", ".5", "-.5", "1.e5", "1e-5", "+1", "inf", "-inf", "nan",
        ] {
            let text = format!(" {number},");
            assert_eq!(Lexer::new(&text).number(), Some(number));
        }
        for other in ["", "-", ".", "e5", "1f", "0x10", "infinite", "1.2.3"] {
            assert_eq!(Lexer::new(other).number(), None, "{other}");
        }
    }

    #[test]
    fn asset_paths_contain_marks() {
        for (text, path) in [
            ("@a.usd@", "a.usd"),
            ("@@", ""),
            ("@@@x@y@@@", "x@y"),
            ("@@@x@@@@", "x@"),
            (r"@@@x\@@@y@@@ @@@z@@@", "x@@@y"),
        ] {
            assert_eq!(Lexer::new(text).asset().as_deref(), Ok(path));
        }
        for open in ["@a\n@", "@@@a@@", "@"] {
            assert!(Lexer::new(open).asset().is_err(), "{open}");
        }
    }

    #[test]
    fn values_of_any_kind_are_skipped() {
        for value in [
            "3",
            "foo",
            "\"(\"",
            "@(@",
            "</A.b>",
            "[(1, 2), {a = [b]; c: 1}]",
            "None",
        ] {
            let text = format!("{value} next");
            let mut lexer = Lexer::new(&text);
            assert!(lexer.skip_value().is_ok(), "{value}");
            assert_eq!(lexer.word(), Some("next"), "{value}");
        }
        for open in ["(", "[1", "", ")"] {
            assert!(Lexer::new(open).skip_value().is_err(), "{open}");
        }
    }
}
