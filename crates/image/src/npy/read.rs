use super::{FORMAT, header};
use crate::bytes::Scalar;
use crate::{CodecError, Image};

/// An array as a file holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// The lengths of its axes: rows, columns and, where there are three, channels.
    pub shape: Vec<usize>,
    /// Its values in C order.
    pub values: Values,
}

/// The values of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// `uint8`
    U8(Vec<u8>),
    /// `uint16`
    U16(Vec<u16>),
    /// `float32`
    F32(Vec<f32>),
    /// `float64`
    F64(Vec<f64>),
}

/// Reads an array of two or three axes of `uint8`, `uint16`, `float32` or `float64`, of either byte order.
///
/// # Errors
/// Bytes that are not such an array, or are not exactly as long as its shape says.
pub fn decode(bytes: &[u8]) -> Result<Array, CodecError> {
    let header = header::decode(bytes)?;
    let data = &bytes[header.end..];
    let expected =
        header::item_size(&header.descr).and_then(|size| header::elements(&header.shape)?.checked_mul(size));
    let values = match header.descr.as_str() {
        "|u1" | "<u1" | ">u1" => Values::U8(data.to_vec()),
        "<u2" => Values::U16(u16::get_le(data)),
        ">u2" => Values::U16(u16::get_be(data)),
        "<f4" => Values::F32(f32::get_le(data)),
        ">f4" => Values::F32(f32::get_be(data)),
        "<f8" => Values::F64(f64::get_le(data)),
        ">f8" => Values::F64(f64::get_be(data)),
        other => {
            return Err(CodecError::new(
                FORMAT,
                "descr",
                format!("'{other}' is none of uint8, uint16, float32 and float64"),
                "convert it with a.astype(numpy.float32)",
            ));
        }
    };
    if !matches!(header.shape.len(), 2 | 3) {
        return Err(CodecError::new(
            FORMAT,
            "shape",
            format!("{} axes, an image has 2 or 3", header.shape.len()),
            "save rows × columns, or rows × columns × channels",
        ));
    }
    if expected != Some(data.len()) {
        return Err(CodecError::new(
            FORMAT,
            "data",
            format!(
                "{} bytes, {:?} of {} needs {}",
                data.len(),
                header.shape,
                header.descr,
                expected.map_or_else(|| "more than there is memory".into(), |n| n.to_string()),
            ),
            "the file is cut off or damaged: copy it again",
        ));
    }
    Ok(Array {
        shape: header.shape,
        values,
    })
}

impl Array {
    /// An image of one channel in `float32`, from `float32` or `float64` (rounded).
    ///
    /// # Errors
    /// Whole numbers, whose unit the file does not say; several channels; an axis over 2³² − 1.
    pub fn into_f32_image(self) -> Result<Image<f32>, CodecError> {
        let wrong = |problem: String, remedy| CodecError::new(FORMAT, "shape", problem, remedy);
        let (height, width) = match self.shape.as_slice() {
            [height, width] | [height, width, 1] => (*height, *width),
            shape => {
                return Err(wrong(
                    format!("{shape:?} is not an image of one channel"),
                    "save one channel: a[..., 0]",
                ));
            }
        };
        #[expect(clippy::cast_possible_truncation, reason = "rounded, as documented")]
        let pixels = match self.values {
            Values::F32(values) => values,
            Values::F64(values) => values.iter().map(|&value| value as f32).collect(),
            Values::U8(_) | Values::U16(_) => {
                return Err(CodecError::new(
                    FORMAT,
                    "descr",
                    "whole numbers are not metres",
                    "convert to metres: a.astype(numpy.float32) * scale",
                ));
            }
        };
        let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
        size.and_then(|(width, height)| Image::new(width, height, pixels))
            .ok_or_else(|| wrong(format!("{width} × {height} is too large"), "cut it into tiles"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npy::encode;
    use proptest::prelude::*;

    #[test]
    fn errors_say_what_and_what_to_do() {
        let mut file = encode(&[2, 2], &[1f32, 2.0, 3.0, 4.0]).unwrap();
        file.pop();
        assert_eq!(
            decode(&file).unwrap_err().to_string(),
            "NPY: data: 15 bytes, [2, 2] of <f4 needs 16; the file is cut off or damaged: copy it again"
        );
        let says = |bytes: Vec<u8>| decode(&bytes).unwrap_err().to_string();
        assert!(says(encode(&[2, 2], &[1i32, 2, 3, 4]).unwrap()).contains("'<i4' is none of"));
        assert!(says(encode(&[1], &[1f32]).unwrap()).contains("1 axes"));
        let image = |shape: &[usize]| {
            decode(&encode(shape, &[1u16, 2]).unwrap())
                .unwrap()
                .into_f32_image()
        };
        assert!(image(&[1, 2]).unwrap_err().to_string().contains("not metres"));
        assert!(image(&[1, 1, 2]).unwrap_err().to_string().contains("[1, 1, 2]"));
    }

    #[test]
    fn either_byte_order() {
        let little = encode(&[1, 2], &[1.5f64, -2.0]).unwrap();
        let mut big = little.clone();
        let at = big.iter().position(|&b| b == b'<').unwrap();
        big[at] = b'>';
        let data = big.len() - 16;
        big[data..data + 8].reverse();
        big[data + 8..].reverse();
        assert_eq!(decode(&little).unwrap(), decode(&big).unwrap());
        let image = decode(&big).unwrap().into_f32_image().unwrap();
        assert_eq!((image.width(), image.pixels()), (2, &[1.5f32, -2.0][..]));
    }

    proptest! {
        #[test]
        fn every_bit_comes_back(bits in prop::collection::vec(any::<u32>(), 0..60)) {
            let values: Vec<f32> = bits.iter().map(|&bits| f32::from_bits(bits)).collect();
            let Array { shape, values } = decode(&encode(&[values.len(), 1], &values).unwrap()).unwrap();
            prop_assert_eq!(shape, [bits.len(), 1]);
            let Values::F32(values) = values else { return Err(TestCaseError::fail("not float32")) };
            prop_assert_eq!(values.iter().map(|v| v.to_bits()).collect::<Vec<_>>(), bits);
        }

        #[test]
        fn damaged_bytes_are_an_error_or_an_array(at in 0usize..152, value: u8, cut in 0usize..153) {
            let mut file = encode(&[2, 3], &[0f32; 6]).unwrap();
            file[at] = value;
            file.truncate(cut);
            if let Ok(array) = decode(&file) {
                prop_assert!(header::elements(&array.shape).is_some_and(|n| n <= file.len()));
            }
        }

        #[test]
        fn noise_is_no_array(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            prop_assert!(decode(&bytes).is_err());
            let file = [super::super::MAGIC, &[1, 0, 100, 0], &bytes].concat();
            prop_assert!(decode(&file).is_err());
        }
    }
}
