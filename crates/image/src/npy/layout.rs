use super::read::Values;
use super::{FORMAT, header};
use crate::CodecError;
use crate::bytes::Scalar;
use crate::half::f32_from_half;

/// How an array lies in its file, so that it can be read in parts.
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
    /// The lengths of its axes.
    pub shape: Vec<usize>,
    /// What it consists of.
    pub number: Number,
    /// Whether the first axis is the fastest, as Fortran and MATLAB have it, instead of the last.
    pub is_fortran: bool,
    /// Where its numbers begin, bytes.
    pub data_offset: usize,
}

/// A kind of number, and its byte order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    kind: Kind,
    is_big_endian: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    U8,
    U16,
    F16,
    F32,
    F64,
}

impl Layout {
    /// The most bytes that come before the numbers: so many of a file are enough for [`Layout::parse`].
    pub const MOST_BYTES_BEFORE: usize = 12 + header::LONGEST_HEADER;

    /// Of the beginning of a file.
    ///
    /// # Errors
    /// Bytes that are no array of `uint8`, `uint16`, `float16`, `float32` or `float64`.
    pub fn parse(beginning: &[u8]) -> Result<Self, CodecError> {
        let header = header::decode(beginning)?;
        let number = Number::parse(&header.descr).ok_or_else(|| {
            CodecError::new(
                FORMAT,
                "descr",
                format!(
                    "'{}' is none of uint8, uint16, float16, float32 and float64",
                    header.descr
                ),
                "convert it with a.astype(numpy.float32)",
            )
        })?;
        Ok(Self {
            // Of one axis, both orders are the same.
            is_fortran: header.is_fortran && header.shape.len() > 1,
            shape: header.shape,
            number,
            data_offset: header.end,
        })
    }

    /// That a file's numbers are so many bytes instead.
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
                expected.map_or_else(|| "more than there is memory".into(), |n| n.to_string()),
            ),
            "the file is cut off or damaged: copy it again",
        )
    }

    /// The length of its numbers, bytes; `None` where no memory could hold them.
    #[must_use]
    pub fn data_bytes(&self) -> Option<usize> {
        header::elements(&self.shape)?.checked_mul(self.number.bytes())
    }
}

impl Number {
    fn parse(descr: &str) -> Option<Self> {
        let (order, name) = descr.split_at_checked(1)?;
        let kind = match name {
            "u1" => Kind::U8,
            "u2" => Kind::U16,
            "f2" => Kind::F16,
            "f4" => Kind::F32,
            "f8" => Kind::F64,
            _ => return None,
        };
        let is_big_endian = match order {
            "<" => false,
            ">" => true,
            "|" if kind == Kind::U8 => false,
            _ => return None,
        };
        Some(Self { kind, is_big_endian })
    }

    /// Bytes of one.
    #[must_use]
    pub const fn bytes(self) -> usize {
        match self.kind {
            Kind::U8 => 1,
            Kind::U16 | Kind::F16 => 2,
            Kind::F32 => 4,
            Kind::F64 => 8,
        }
    }

    /// As many as `bytes` hold whole. `float16` becomes `float32`, which holds all of its values.
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
            Kind::U8 => Values::U8(bytes.to_vec()),
            Kind::U16 => Values::U16(get(bytes, self.is_big_endian)),
            Kind::F16 => {
                let halves: Vec<u16> = get(bytes, self.is_big_endian);
                Values::F32(halves.into_iter().map(f32_from_half).collect())
            }
            Kind::F32 => Values::F32(get(bytes, self.is_big_endian)),
            Kind::F64 => Values::F64(get(bytes, self.is_big_endian)),
        }
    }
}

/// The values of a Fortran array in C order.
pub(super) fn to_c_order<T: Copy>(shape: &[usize], values: &[T]) -> Vec<T> {
    let mut index = vec![0usize; shape.len()];
    let mut strides = Vec::with_capacity(shape.len());
    let mut stride = 1usize;
    for axis in shape {
        strides.push(stride);
        stride *= axis;
    }
    let mut out = Vec::with_capacity(values.len());
    let mut at = 0usize;
    for _ in 0..values.len() {
        out.push(values[at]);
        // The next index in C order: the last axis is the fastest.
        for axis in (0..shape.len()).rev() {
            index[axis] += 1;
            at += strides[axis];
            if index[axis] < shape[axis] {
                break;
            }
            at -= strides[axis] * shape[axis];
            index[axis] = 0;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn fortran_order_is_another_place_for_the_same_values(a in 1usize..5, b in 1usize..5, c in 1usize..5) {
            let mut fortran = vec![0; a * b * c];
            let mut expected = Vec::new();
            for i in 0..a {
                for j in 0..b {
                    for k in 0..c {
                        fortran[i + a * (j + b * k)] = 100 * i + 10 * j + k;
                        expected.push(100 * i + 10 * j + k);
                    }
                }
            }
            prop_assert_eq!(to_c_order(&[a, b, c], &fortran), expected);
        }
    }

    #[test]
    fn names_of_numbers() {
        for (descr, bytes) in [("|u1", 1), ("<u2", 2), (">f2", 2), ("<f4", 4), (">f8", 8)] {
            assert_eq!(Number::parse(descr).unwrap().bytes(), bytes);
        }
        for descr in ["", "f4", "=f4", "|f4", "<i4", "<f16", "é", "<c8"] {
            assert_eq!(Number::parse(descr), None, "{descr}");
        }
    }
}
