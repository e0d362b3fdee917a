use super::{Node, Position, Value};

/// The maximum size of a file, bytes. A real calibration has about ten thousand.
pub const MAX_BYTES: usize = 4 << 20;

/// The maximum nesting depth. A real calibration has six levels.
pub const MAX_DEPTH: usize = 64;

/// A syntax error.
#[derive(Debug)]
pub(super) struct Problem {
    pub(super) at: Position,
    pub(super) what: String,
    pub(super) remedy: &'static str,
}

const EXPORT_AGAIN: &str = "export it again with DepthAI's eepromToJsonFile";

/// Parses a document.
pub(super) fn document(bytes: &[u8]) -> Result<Node, Problem> {
    let start = Position { line: 1, column: 1 };
    let problem = |at, what: String| Problem {
        at,
        what,
        remedy: EXPORT_AGAIN,
    };
    if bytes.len() > MAX_BYTES {
        let what = format!(
            "the file has {} bytes, more than the maximum of {MAX_BYTES}",
            bytes.len()
        );
        return Err(Problem {
            at: start,
            what,
            remedy: "pass the JSON file that DepthAI exported",
        });
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text),
        Err(e) => {
            let at = valid_prefix(bytes, e.valid_up_to()).map_or(start, |text| position(text, text.len()));
            let what = if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
                "the text is UTF-16, not UTF-8".to_owned()
            } else {
                format!(
                    "byte 0x{:02x} is not UTF-8",
                    bytes.get(e.valid_up_to()).unwrap_or(&0)
                )
            };
            return Err(Problem {
                at,
                what,
                remedy: "save it as UTF-8, or pass the JSON file that DepthAI exported",
            });
        }
    };
    let mut parser = Parser {
        text,
        at: 0,
        counted_to: 0,
        position: start,
    };
    parser.skip_space();
    if parser.peek().is_none() {
        return Err(problem(start, "the file is empty".to_owned()));
    }
    let parsed = parser.node(0).and_then(|node| {
        parser.skip_space();
        match parser.peek() {
            None => Ok(node),
            Some(c) => Err(format!("{} after the end of the document", shown(c))),
        }
    });
    parsed.map_err(|what| problem(position(text, parser.at), what))
}

fn valid_prefix(bytes: &[u8], end: usize) -> Option<&str> {
    std::str::from_utf8(bytes.get(..end)?).ok()
}

fn position(text: &str, offset: usize) -> Position {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    Position {
        line: before.matches('\n').count() + 1,
        column: before.get(line_start..).unwrap_or("").chars().count() + 1,
    }
}

fn shown(c: char) -> String {
    if c.is_control() {
        format!("character U+{:04X}", u32::from(c))
    } else {
        format!("'{c}'")
    }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    /// The offset of `position`. Positions are computed in order, each from the previous one.
    counted_to: usize,
    position: Position,
}

type Parsed<T> = Result<T, String>;

impl Parser<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn eat(&mut self, c: char) -> bool {
        let found = self.peek() == Some(c);
        if found {
            self.at += c.len_utf8();
        }
        found
    }

    fn skip_while(&mut self, accept: impl Fn(u8) -> bool) -> usize {
        let n = self.rest().bytes().take_while(|b| accept(*b)).count();
        self.at += n;
        n
    }

    fn skip_space(&mut self) {
        self.skip_while(|b| matches!(b, b' ' | b'\t' | b'\n' | b'\r'));
    }

    fn here(&mut self) -> Position {
        for c in self.text.get(self.counted_to..self.at).unwrap_or("").chars() {
            if c == '\n' {
                self.position.line += 1;
                self.position.column = 1;
            } else {
                self.position.column += 1;
            }
        }
        self.counted_to = self.at;
        self.position
    }

    fn expected(&self, what: &str) -> String {
        match self.peek() {
            Some(c) => format!("found {} instead of {what}", shown(c)),
            None => format!("the file ends instead of {what}"),
        }
    }

    fn node(&mut self, depth: usize) -> Parsed<Node> {
        if depth > MAX_DEPTH {
            return Err(format!("nested deeper than {MAX_DEPTH} levels"));
        }
        let at = self.here();
        let value = match self.peek() {
            Some('{') => self.object(depth)?,
            Some('[') => self.array(depth)?,
            Some('"') => Value::String(self.string()?),
            Some('-' | '0'..='9') => self.number()?,
            Some(c) if c.is_ascii_alphabetic() => self.word()?,
            _ => return Err(self.expected("a value")),
        };
        Ok(Node { value, at })
    }

    fn word(&mut self) -> Parsed<Value> {
        let len = self.rest().bytes().take_while(u8::is_ascii_alphanumeric).count();
        let word = self.rest().get(..len).unwrap_or("");
        let value = match word {
            "null" => Value::Null,
            "true" => Value::Bool(true),
            "false" => Value::Bool(false),
            "NaN" | "nan" | "Infinity" | "inf" => return Err(format!("{word} is not a number in JSON")),
            _ => return Err(self.expected("a value")),
        };
        self.at += len;
        Ok(value)
    }

    fn number(&mut self) -> Parsed<Value> {
        let start = self.at;
        self.eat('-');
        if self.rest().starts_with("Infinity") || self.rest().starts_with("inf") {
            return Err("-Infinity is not a number in JSON".to_owned());
        }
        if !self.eat('0') && self.skip_while(|b| b.is_ascii_digit()) == 0 {
            return Err(self.expected("a digit"));
        }
        if self.eat('.') && self.skip_while(|b| b.is_ascii_digit()) == 0 {
            return Err(self.expected("a digit"));
        }
        if self.eat('e') || self.eat('E') {
            if !self.eat('+') {
                self.eat('-');
            }
            if self.skip_while(|b| b.is_ascii_digit()) == 0 {
                return Err(self.expected("a digit"));
            }
        }
        Ok(Value::Number(
            self.text.get(start..self.at).unwrap_or("").to_owned(),
        ))
    }

    fn array(&mut self, depth: usize) -> Parsed<Value> {
        self.eat('[');
        let mut items = Vec::new();
        self.skip_space();
        if self.eat(']') {
            return Ok(Value::Array(items));
        }
        loop {
            self.skip_space();
            items.push(self.node(depth + 1)?);
            self.skip_space();
            if self.eat(']') {
                return Ok(Value::Array(items));
            }
            if !self.eat(',') {
                return Err(self.expected("',' or ']'"));
            }
        }
    }

    fn object(&mut self, depth: usize) -> Parsed<Value> {
        self.eat('{');
        let mut entries = Vec::new();
        self.skip_space();
        if self.eat('}') {
            return Ok(Value::Object(entries));
        }
        loop {
            self.skip_space();
            if self.peek() != Some('"') {
                return Err(self.expected("a key in quotes"));
            }
            let key = self.string()?;
            self.skip_space();
            if !self.eat(':') {
                return Err(self.expected("':'"));
            }
            self.skip_space();
            entries.push((key, self.node(depth + 1)?));
            self.skip_space();
            if self.eat('}') {
                return Ok(Value::Object(entries));
            }
            if !self.eat(',') {
                return Err(self.expected("',' or '}'"));
            }
        }
    }

    fn string(&mut self) -> Parsed<String> {
        self.eat('"');
        let mut value = String::new();
        loop {
            let plain = self.at;
            self.skip_while(|b| b >= 0x20 && b != b'"' && b != b'\\');
            value.push_str(self.text.get(plain..self.at).unwrap_or(""));
            if self.eat('"') {
                return Ok(value);
            }
            if !self.eat('\\') {
                return Err(self.expected("the end of a string"));
            }
            value.push(self.escape()?);
        }
    }

    fn escape(&mut self) -> Parsed<char> {
        let Some(c) = self.peek() else {
            return Err(self.expected("an escape"));
        };
        let plain = match c {
            '"' | '\\' | '/' => c,
            'b' => '\u{8}',
            'f' => '\u{c}',
            'n' => '\n',
            'r' => '\r',
            't' => '\t',
            'u' => {
                self.at += 1;
                return self.unicode_escape();
            }
            _ => return Err(self.expected("an escape")),
        };
        self.at += 1;
        Ok(plain)
    }

    fn unicode_escape(&mut self) -> Parsed<char> {
        let high = self.hex4()?;
        if !(0xd800..0xdc00).contains(&high) {
            return char::from_u32(high).ok_or_else(|| "half a surrogate pair".to_owned());
        }
        if !(self.eat('\\') && self.eat('u')) {
            return Err("half a surrogate pair".to_owned());
        }
        let low = self.hex4()?;
        if !(0xdc00..0xe000).contains(&low) {
            return Err("half a surrogate pair".to_owned());
        }
        char::from_u32(0x1_0000 + ((high - 0xd800) << 10) + (low - 0xdc00))
            .ok_or_else(|| "half a surrogate pair".to_owned())
    }

    fn hex4(&mut self) -> Parsed<u32> {
        let digits = self
            .rest()
            .get(..4)
            .filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()))
            .ok_or_else(|| self.expected("four hexadecimal digits"))?;
        let value = u32::from_str_radix(digits, 16).map_err(|e| e.to_string())?;
        self.at += 4;
        Ok(value)
    }
}
