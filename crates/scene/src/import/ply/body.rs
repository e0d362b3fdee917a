use super::header::{Encoding, Header, NumberKind};
use crate::import::error::Fault;
use crate::import::text;

/// Reads the numbers of the body in sequence.
pub(super) struct Body<'a> {
    rest: &'a [u8],
    encoding: Encoding,
    line: usize,
    has_line_per_row: bool,
}

impl<'a> Body<'a> {
    pub(super) fn new(rest: &'a [u8], header: &Header) -> Self {
        Self {
            rest,
            encoding: header.encoding,
            line: header.lines,
            has_line_per_row: header.has_line_per_row(rest),
        }
    }

    /// Skips values that the header does not declare: `MeshLab` writes some after a row.
    pub(super) fn end_row(&mut self) {
        if self.has_line_per_row {
            let end = self.rest.iter().position(|&byte| byte == b'\n');
            self.rest = &self.rest[end.unwrap_or(self.rest.len())..];
        }
    }

    /// The number of bytes left.
    pub(super) fn left(&self) -> usize {
        self.rest.len()
    }

    /// Reads a number; a double represents all values of all types.
    pub(super) fn number(&mut self, kind: NumberKind) -> Result<f64, Fault> {
        match self.encoding {
            Encoding::Text => {
                let word = self.word();
                text::number(word).ok_or_else(|| self.bad_number(word))
            }
            Encoding::LittleEndian => self.take(kind, |bytes| bytes),
            Encoding::BigEndian => self.take(kind, |mut bytes| {
                bytes[..kind.size()].reverse();
                bytes
            }),
        }
    }

    pub(super) fn length(&mut self, kind: NumberKind) -> Result<usize, Fault> {
        let length = self.number(kind)?;
        let shortest = if self.encoding == Encoding::Text { 2 } else { 1 };
        // In text the last number needs no separator.
        #[allow(clippy::cast_precision_loss, reason = "an upper bound")]
        let max = (self.left() / shortest + 1) as f64;
        if length >= 0.0 && length <= max && length.fract() == 0.0 {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
            return Ok(length as usize);
        }
        Err(Fault::damaged(
            self.place(),
            format!("a list of {length} numbers is longer than the file"),
        ))
    }

    pub(super) fn skip(&mut self, kind: NumberKind, count: usize) -> Result<(), Fault> {
        if self.encoding == Encoding::Text {
            for _ in 0..count {
                self.number(kind)?;
            }
            return Ok(());
        }
        match count
            .checked_mul(kind.size())
            .and_then(|size| self.rest.get(size..))
        {
            Some(rest) => {
                self.rest = rest;
                Ok(())
            }
            None => Err(self.too_short()),
        }
    }

    fn word(&mut self) -> &'a [u8] {
        let start = self
            .rest
            .iter()
            .position(|byte| !byte.is_ascii_whitespace())
            .unwrap_or(self.rest.len());
        self.line += self.rest[..start].iter().filter(|&&byte| byte == b'\n').count();
        let word = &self.rest[start..];
        let end = word
            .iter()
            .position(u8::is_ascii_whitespace)
            .unwrap_or(word.len());
        self.rest = &word[end..];
        &word[..end]
    }

    fn take(&mut self, kind: NumberKind, order: impl Fn([u8; 8]) -> [u8; 8]) -> Result<f64, Fault> {
        let Some((head, rest)) = self.rest.split_at_checked(kind.size()) else {
            return Err(self.too_short());
        };
        self.rest = rest;
        let mut bytes = [0; 8];
        bytes[..head.len()].copy_from_slice(head);
        let [a, b, c, d, ..] = order(bytes);
        Ok(match kind {
            NumberKind::I8 => f64::from(a.cast_signed()),
            NumberKind::U8 => f64::from(a),
            NumberKind::I16 => f64::from(i16::from_le_bytes([a, b])),
            NumberKind::U16 => f64::from(u16::from_le_bytes([a, b])),
            NumberKind::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            NumberKind::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            NumberKind::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            NumberKind::F64 => f64::from_le_bytes(order(bytes)),
        })
    }

    fn place(&self) -> String {
        match self.encoding {
            Encoding::Text => format!("line {}", self.line),
            _ => "body".into(),
        }
    }

    fn bad_number(&self, word: &[u8]) -> Fault {
        if word.is_empty() {
            return self.too_short();
        }
        Fault::damaged(self.place(), format!("invalid number: {}", text::shown(word)))
    }

    pub(super) fn too_short(&self) -> Fault {
        Fault::damaged(self.place(), "the file ends before its last element")
    }
}
