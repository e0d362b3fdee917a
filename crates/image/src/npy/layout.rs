use half::f16;

use super::values::Values;
use super::{FORMAT, header};
use crate::CodecError;
use crate::bytes::Scalar;

/// The layout of an array in its file, for reading it in parts.
///
/// ```
/// use oaktwin_image::npy::{self, Layout};
///
/// let file = npy::encode(&[2, 3], &[0f32, 1.0, 2.0, 3.0, 4.0, 5.0])?;
/// let layout = Layout::parse(&file)?;
/// let second_row = &file[layout.data_offset + 3 * layout.number.bytes()..];
/// assert_eq!(layout.number.values(second_row), npy::Values::F32(vec![3.0, 4.0, 5.0]));
/// # Ok::<(), oaktwin_image::CodecError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The lengths of the axes.
    pub shape: Vec<usize>,
    /// The type of its numbers.
    pub number: Number,
    /// Whether the first axis is contiguous, as in Fortran and MATLAB, instead of the last.
    pub is_fortran: bool,
    /// The offset of its numbers, bytes.
    pub data_offset: usize,
}

/// A type of numbers and its byte order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    kind: DtypeKind,
    is_big_endian: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DtypeKind {
    U8,
    U16,
    I16,
    I32,
    U32,
    I64,
    F16,
    F32,
    F64,
}

impl Layout {
    /// The maximum number of bytes before the data, which suffice for [`Layout::parse`].
    pub const MAX_DATA_OFFSET: usize = 12 + header::MAX_HEADER;

    /// Parses the start of a file.
    ///
    /// # Errors
    /// Returns an error if it is not an array of integers of at most 64 bits or floats; `int8` and `uint64` are not supported.
    pub fn parse(beginning: &[u8]) -> Result<Self, CodecError> {
        let header = header::decode(beginning)?;
        let number = Number::parse(&header.descr).ok_or_else(|| {
            CodecError::new(
                FORMAT,
                "descr",
                format!(
                    "'{}' is not one of uint8, uint16, uint32, int16, int32, int64, float16, float32 and float64",
                    header.descr
                ),
                "convert it with a.astype(numpy.float32)",
            )
        })?;
        Ok(Self {
            // With one axis, both orders are the same.
            is_fortran: header.is_fortran && header.shape.len() > 1,
            shape: header.shape,
            number,
            data_offset: header.end,
        })
    }

    /// Returns the error for data of another length, bytes.
    #[must_use]
    pub fn wrong_length(&self, bytes: u64) -> CodecError {
        let expected = self.data_bytes();
        CodecError::new(
            FORMAT,
            "data",
            format!(
                "{bytes} bytes, {:?} of {} bytes each needs {}",
                self.shape,
                self.number.bytes(),
                expected.map_or_else(|| "more than fits in memory".into(), |n| n.to_string()),
            ),
            "the file is truncated or damaged; copy it again",
        )
    }

    /// Returns the length of the data, bytes, or `None` on overflow.
    #[must_use]
    pub fn data_bytes(&self) -> Option<usize> {
        header::elements(&self.shape)?.checked_mul(self.number.bytes())
    }
}

impl Number {
    fn parse(descr: &str) -> Option<Self> {
        let (order, name) = descr.split_at_checked(1)?;
        let kind = match name {
            "u1" => DtypeKind::U8,
            "u2" => DtypeKind::U16,
            "i2" => DtypeKind::I16,
            "i4" => DtypeKind::I32,
            "u4" => DtypeKind::U32,
            "i8" => DtypeKind::I64,
            "f2" => DtypeKind::F16,
            "f4" => DtypeKind::F32,
            "f8" => DtypeKind::F64,
            _ => return None,
        };
        let is_big_endian = match order {
            "<" => false,
            ">" => true,
            "|" if kind == DtypeKind::U8 => false,
            _ => return None,
        };
        Some(Self { kind, is_big_endian })
    }

    /// Returns the size of a number, bytes.
    #[must_use]
    pub const fn bytes(self) -> usize {
        match self.kind {
            DtypeKind::U8 => 1,
            DtypeKind::U16 | DtypeKind::I16 | DtypeKind::F16 => 2,
            DtypeKind::I32 | DtypeKind::U32 | DtypeKind::F32 => 4,
            DtypeKind::I64 | DtypeKind::F64 => 8,
        }
    }

    /// Reads all complete numbers in `bytes`. `float16` becomes `float32`, `int16` `int32`, and `uint32` `int64`, which represent all of their values.
    #[must_use]
    pub fn values(self, bytes: &[u8]) -> Values {
        fn get<T: Scalar>(bytes: &[u8], is_big_endian: bool) -> Vec<T> {
            if is_big_endian {
                T::get_be(bytes)
            } else {
                T::get_le(bytes)
            }
        }
        match self.kind {
            DtypeKind::U8 => Values::U8(bytes.to_vec()),
            DtypeKind::U16 => Values::U16(get(bytes, self.is_big_endian)),
            DtypeKind::I16 => {
                let shorts: Vec<u16> = get(bytes, self.is_big_endian);
                Values::I32(shorts.into_iter().map(|bits| bits.cast_signed().into()).collect())
            }
            DtypeKind::I32 => Values::I32(get(bytes, self.is_big_endian)),
            DtypeKind::U32 => {
                let words: Vec<u32> = get(bytes, self.is_big_endian);
                Values::I64(words.into_iter().map(i64::from).collect())
            }
            DtypeKind::I64 => Values::I64(get(bytes, self.is_big_endian)),
            DtypeKind::F16 => {
                let halves: Vec<u16> = get(bytes, self.is_big_endian);
                Values::F32(
                    halves
                        .into_iter()
                        .map(|bits| f16::from_bits(bits).to_f32())
                        .collect(),
                )
            }
            DtypeKind::F32 => Values::F32(get(bytes, self.is_big_endian)),
            DtypeKind::F64 => Values::F64(get(bytes, self.is_big_endian)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parses_types() {
        for (descr, bytes) in [
            ("|u1", 1),
            ("<u2", 2),
            ("<i2", 2),
            (">i4", 4),
            ("<u4", 4),
            (">i8", 8),
            (">f2", 2),
            ("<f4", 4),
            (">f8", 8),
        ] {
            assert_eq!(Number::parse(descr).unwrap().bytes(), bytes);
        }
        for descr in ["", "f4", "=f4", "|f4", "<u8", "<f16", "é", "<c8"] {
            assert_eq!(Number::parse(descr), None, "{descr}");
        }
    }
}
