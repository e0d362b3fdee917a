use super::{FORMAT, MAGIC};
use crate::CodecError;

/// The number of digits that `numpy.save` reserves for the first axis.
const GROWTH_DIGITS: usize = 21;

/// The maximum length of a header, bytes, as in `NumPy`.
pub(super) const MAX_HEADER: usize = 10_000;

const REMEDY: &str = "save it again with numpy.save";

/// Returns the number of elements of a shape, or `None` on overflow.
pub(super) fn elements(shape: &[usize]) -> Option<usize> {
    shape
        .iter()
        .try_fold(1usize, |product, &axis| product.checked_mul(axis))
}

/// Returns the size of a type such as `<f4`, bytes.
pub(super) fn item_size(descr: &str) -> Option<usize> {
    match descr.as_bytes() {
        [_, _, size @ b'1'..=b'8'] => Some(usize::from(size - b'0')),
        _ => None,
    }
}

/// Encodes everything before the data; its length is a multiple of 64.
pub(super) fn encode(descr: &str, shape: &[usize]) -> Vec<u8> {
    let axes: Vec<String> = shape.iter().map(usize::to_string).collect();
    let tuple = match axes.as_slice() {
        [one] => format!("({one},)"),
        axes => format!("({})", axes.join(", ")),
    };
    let mut dict = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': {tuple}, }}");
    if let Some(first) = axes.first() {
        dict.extend(std::iter::repeat_n(
            ' ',
            GROWTH_DIGITS.saturating_sub(first.len()),
        ));
    }
    let used = MAGIC.len() + 4 + dict.len() + 1;
    dict.extend(std::iter::repeat_n(' ', 64 - used % 64));
    dict.push('\n');
    let mut out = MAGIC.to_vec();
    out.extend([1, 0]);
    // Headers of this crate's types and ranks are far below 64 KiB.
    out.extend(u16::try_from(dict.len()).unwrap_or(u16::MAX).to_le_bytes());
    out.extend(dict.bytes());
    out
}

/// A decoded header.
#[derive(Debug, PartialEq)]
pub(super) struct Header {
    pub descr: String,
    pub shape: Vec<usize>,
    pub is_fortran: bool,
    /// The offset of the data, bytes.
    pub end: usize,
}

/// Reads a header of format version 1, 2 or 3.
pub(super) fn decode(bytes: &[u8]) -> Result<Header, CodecError> {
    let broken = |problem: &str| CodecError::new(FORMAT, "header", problem, REMEDY);
    let rest = bytes
        .strip_prefix(MAGIC)
        .ok_or_else(|| CodecError::new(FORMAT, "byte 0", "not a NumPy array", "pass a .npy file"))?;
    let (length, start) = match *rest {
        [1, _, a, b, ..] => (usize::from(u16::from_le_bytes([a, b])), 10),
        [2 | 3, _, a, b, c, d, ..] => (
            usize::try_from(u32::from_le_bytes([a, b, c, d])).unwrap_or(usize::MAX),
            12,
        ),
        [version, _, ..] => return Err(broken(&format!("format version {version} is not supported"))),
        _ => return Err(broken("the file ends here")),
    };
    if length > MAX_HEADER {
        return Err(broken(&format!("{length} bytes long, more than {MAX_HEADER}")));
    }
    let end = start + length;
    let text = bytes
        .get(start..end)
        .ok_or_else(|| broken("the file ends here"))?;
    let text = std::str::from_utf8(text).map_err(|_| broken("not a text"))?;
    let mut parser = Parser { rest: text };
    let (mut descr, mut fortran, mut shape) = (None, None, None);
    parser.expect("{")?;
    while !parser.eat("}") {
        let key = parser.string()?;
        parser.expect(":")?;
        match key {
            "descr" => descr = Some(parser.descr()?),
            "fortran_order" => fortran = Some(parser.boolean()?),
            "shape" => shape = Some(parser.tuple()?),
            _ => return Err(broken(&format!("unknown key '{key}'"))),
        }
        if !parser.eat(",") {
            parser.expect("}")?;
            break;
        }
    }
    let (Some(descr), Some(fortran), Some(shape)) = (descr, fortran, shape) else {
        return Err(broken("descr, fortran_order or shape is missing"));
    };
    Ok(Header {
        descr,
        shape,
        is_fortran: fortran,
        end,
    })
}

/// A parser of the Python literals in headers.
struct Parser<'a> {
    rest: &'a str,
}

impl<'a> Parser<'a> {
    fn error(&self, expected: &str) -> CodecError {
        let found: String = self.rest.chars().take(12).collect();
        CodecError::new(
            FORMAT,
            "header",
            format!("{expected} expected, found '{}'", found.trim_end()),
            REMEDY,
        )
    }

    fn eat(&mut self, token: &str) -> bool {
        self.rest = self.rest.trim_start_matches(' ');
        match self.rest.strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn expect(&mut self, token: &str) -> Result<(), CodecError> {
        if self.eat(token) {
            Ok(())
        } else {
            Err(self.error(&format!("'{token}'")))
        }
    }

    fn string(&mut self) -> Result<&'a str, CodecError> {
        let quote = if self.eat("'") {
            '\''
        } else if self.eat("\"") {
            '"'
        } else {
            return Err(self.error("a quoted name"));
        };
        let (text, rest) = self.rest.split_once(quote).ok_or_else(|| self.error("a quote"))?;
        self.rest = rest;
        Ok(text)
    }

    fn descr(&mut self) -> Result<String, CodecError> {
        self.rest = self.rest.trim_start_matches(' ');
        if self.rest.starts_with('[') {
            return Err(CodecError::new(
                FORMAT,
                "descr",
                "a structured type",
                "save each field as a separate array",
            ));
        }
        self.string().map(str::to_owned)
    }

    fn boolean(&mut self) -> Result<bool, CodecError> {
        if self.eat("True") {
            Ok(true)
        } else if self.eat("False") {
            Ok(false)
        } else {
            Err(self.error("True or False"))
        }
    }

    fn tuple(&mut self) -> Result<Vec<usize>, CodecError> {
        let mut axes = Vec::new();
        self.expect("(")?;
        while !self.eat(")") {
            self.rest = self.rest.trim_start_matches(' ');
            let digits = self
                .rest
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(self.rest.len());
            let (number, rest) = self.rest.split_at(digits);
            axes.push(number.parse().map_err(|_| self.error("a length"))?);
            self.rest = rest;
            if !self.eat(",") {
                self.expect(")")?;
                break;
            }
        }
        Ok(axes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(dict: &str) -> Vec<u8> {
        let mut out = MAGIC.to_vec();
        out.extend([1, 0]);
        out.extend(u16::try_from(dict.len()).unwrap().to_le_bytes());
        out.extend(dict.bytes());
        out
    }

    #[test]
    fn accepts_any_order_and_quotes() {
        let bytes = file("{\"shape\":(3,),'fortran_order':True , 'descr': '<f4'}\n");
        let header = decode(&bytes).unwrap();
        assert_eq!(
            (header.descr.as_str(), header.shape.as_slice()),
            ("<f4", &[3][..])
        );
        assert_eq!(header.end, bytes.len());
    }

    #[test]
    fn reads_later_versions() {
        let dict = "{'descr': '<f4', 'fortran_order': False, 'shape': (), }";
        let mut bytes = MAGIC.to_vec();
        bytes.extend([2, 0]);
        bytes.extend(u32::try_from(dict.len()).unwrap().to_le_bytes());
        bytes.extend(dict.bytes());
        assert_eq!(decode(&bytes).unwrap().shape, []);
    }

    #[test]
    fn errors_state_a_remedy() {
        let says = |bytes: &[u8]| decode(bytes).unwrap_err().to_string();
        assert_eq!(says(b"PK"), "NPY: byte 0: not a NumPy array; pass a .npy file");
        assert_eq!(
            says(&file("{'descr': '<f4', 'fortran_order': no}")),
            "NPY: header: True or False expected, found 'no}'; save it again with numpy.save"
        );
        assert!(says(&file("{'descr': [('a', '<f4')]}")).contains("a structured type"));
        assert!(says(&file("{'descr': '<f4', }")).contains("is missing"));
        assert!(says(&file("{'shape': (99999999999999999999999,)}")).contains("a length"));
        assert!(says(&file("{'shape': (-1,)}")).contains("a length"));
        assert!(says(b"\x93NUMPY\x02\x00\xFF\xFF\xFF\xFF").contains("4294967295 bytes long"));
        assert!(says(b"\x93NUMPY\x01\x00\xFF\x00{").contains("the file ends here"));
        assert!(says(b"\x93NUMPY\x09\x00\xFF\x00{").contains("format version 9"));
    }
}
