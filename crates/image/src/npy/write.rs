use std::io::{self, Write};

use super::{FORMAT, header};
use crate::CodecError;
use crate::bytes::Scalar;

/// The size of the blocks that are written, bytes.
const BLOCK: usize = 1 << 16;

/// An element type of arrays.
#[expect(
    private_bounds,
    reason = "the conversion to bytes is an implementation detail"
)]
pub trait NpyElement: Scalar {
    /// The name of the type in `NumPy`, with the byte order.
    const DESCR: &'static str;
}

macro_rules! elements {
    ($($number:ty => $descr:literal),+) => {$(
        impl NpyElement for $number {
            const DESCR: &'static str = $descr;
        }
    )+};
}

elements!(u8 => "|u1", u16 => "<u2", u32 => "<u4", i32 => "<i4", i64 => "<i8", f32 => "<f4", f64 => "<f8");

/// Encodes an array of `shape` from its values in C order (the last axis is contiguous).
///
/// ```
/// use oaktwin_image::npy;
///
/// let file = npy::encode(&[2, 3], &[0f32, 1.0, 2.0, 3.0, 4.0, f32::INFINITY])?;
/// assert_eq!(npy::decode(&file)?.shape, [2, 3]);
/// # Ok::<(), oaktwin_image::CodecError>(())
/// ```
///
/// # Errors
/// Returns an error if the number of values does not match `shape`.
pub fn encode<T: NpyElement>(shape: &[usize], values: &[T]) -> Result<Vec<u8>, CodecError> {
    if header::elements(shape) != Some(values.len()) {
        return Err(CodecError::new(
            FORMAT,
            "shape",
            format!("{shape:?} does not hold {} values", values.len()),
            "pass the shape of the values",
        ));
    }
    let mut out = begin::<T>(shape);
    out.reserve_exact(size_of_val(values));
    T::put_le(values, &mut out);
    Ok(out)
}

/// Returns the start of a file of `shape` that is written in parts; [`write()`] appends its numbers in C order.
#[must_use]
pub fn begin<T: NpyElement>(shape: &[usize]) -> Vec<u8> {
    header::encode(&format!("'{}'", T::DESCR), shape)
}

/// Writes numbers in the byte order of files, in blocks that stay in the processor's cache.
///
/// # Errors
/// Returns the errors of the writer.
pub fn write<T: NpyElement>(values: &[T], out: &mut (impl Write + ?Sized)) -> io::Result<()> {
    let mut block = Vec::new();
    for values in values.chunks(BLOCK / size_of::<T>()) {
        block.clear();
        T::put_le(values, &mut block);
        out.write_all(&block)?;
    }
    Ok(())
}

/// A field of a structured type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// The name.
    pub name: &'static str,
    /// The name of the type in `NumPy`: [`NpyElement::DESCR`].
    pub descr: &'static str,
}

impl Field {
    /// Creates a field of numbers `T`.
    #[must_use]
    pub const fn of<T: NpyElement>(name: &'static str) -> Self {
        Self {
            name,
            descr: T::DESCR,
        }
    }
}

/// Encodes a one-dimensional array of a structured type from `count` packed records, little endian.
///
/// # Errors
/// Returns an error if `bytes` are not `count` records.
pub fn encode_records(fields: &[Field], count: usize, bytes: &[u8]) -> Result<Vec<u8>, CodecError> {
    let size: usize = fields
        .iter()
        .filter_map(|field| header::item_size(field.descr))
        .sum();
    if count.checked_mul(size) != Some(bytes.len()) {
        return Err(CodecError::new(
            FORMAT,
            "records",
            format!("{} bytes are not {count} records of {size} bytes", bytes.len()),
            "pack every field of every record",
        ));
    }
    let fields: Vec<String> = fields
        .iter()
        .map(|Field { name, descr }| format!("('{name}', '{descr}')"))
        .collect();
    let mut out = header::encode(&format!("[{}]", fields.join(", ")), &[count]);
    out.extend_from_slice(bytes);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_the_bytes_of_numpy() {
        let file = encode(&[2, 3], &[0f32, 1.0, 2.0, 3.0, 4.0, f32::INFINITY]).unwrap();
        let dict = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }";
        assert_eq!(file[..10], *b"\x93NUMPY\x01\x00\x76\x00");
        assert_eq!(
            std::str::from_utf8(&file[10..128]).unwrap(),
            format!("{dict:<117}\n")
        );
        assert_eq!(file.len(), 128 + 24);
        assert_eq!(file[128..136], [0, 0, 0, 0, 0, 0, 0x80, 0x3F]);
        assert_eq!(file[148..], [0, 0, 0x80, 0x7F]);
    }

    #[test]
    fn writes_all_ranks() {
        let text = |file: Vec<u8>| String::from_utf8_lossy(&file[10..]).into_owned();
        assert!(
            text(encode(&[], &[7u8]).unwrap())
                .contains("'descr': '|u1', 'fortran_order': False, 'shape': (), }")
        );
        assert!(text(encode(&[2], &[7u16, 8]).unwrap()).contains("'shape': (2,), }"));
        assert!(text(encode::<u32>(&[0, 4], &[]).unwrap()).contains("'shape': (0, 4), }"));
        let error = encode(&[2, 2], &[1u8, 2, 3]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "NPY: shape: [2, 2] does not hold 3 values; pass the shape of the values"
        );
        assert!(encode::<u8>(&[usize::MAX, 2], &[]).is_err());
    }

    #[test]
    fn blocks_make_a_whole() {
        let values: Vec<u32> = (0..40_000).collect();
        let mut parts = begin::<u32>(&[200, 200]);
        write(&values, &mut parts).unwrap();
        assert!(parts == encode(&[200, 200], &values).unwrap());
    }

    #[test]
    fn writes_records() {
        let fields = [Field::of::<u32>("id"), Field::of::<f32>("ratio")];
        let file = encode_records(&fields, 1, &[1, 0, 0, 0, 0, 0, 0x80, 0x3F]).unwrap();
        let header = String::from_utf8_lossy(&file[10..]).into_owned();
        assert!(header.starts_with(
            "{'descr': [('id', '<u4'), ('ratio', '<f4')], 'fortran_order': False, 'shape': (1,), }"
        ));
        assert_eq!(file.len() % 64, 8);
        assert!(encode_records(&fields, 2, &[0; 8]).is_err());
    }
}
