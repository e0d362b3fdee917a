use super::FORMAT;
use super::layout::Layout;
use super::values::Values;
use crate::{CodecError, Image};

/// A decoded array.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// The lengths of the axes: optionally the number of images, then rows, columns and channels.
    pub shape: Vec<usize>,
    /// The values in C order.
    pub values: Values,
}

/// Decodes an array of any type of [`Values`] with two to four axes, in any byte order and either order of axes.
///
/// # Errors
/// Returns an error if the bytes are not such an array, or their length does not match its shape.
pub fn decode(bytes: &[u8]) -> Result<Array, CodecError> {
    let layout = Layout::parse(bytes)?;
    let data = bytes.get(layout.data_offset..).unwrap_or_default();
    if !matches!(layout.shape.len(), 2..=4) {
        return Err(CodecError::new(
            FORMAT,
            "shape",
            format!("{} axes; images have 2 or 3, batches up to 4", layout.shape.len()),
            "save rows × columns, or rows × columns × channels",
        ));
    }
    if layout.data_bytes() != Some(data.len()) {
        return Err(layout.wrong_length(data.len() as u64));
    }
    let mut values = layout.number.values(data);
    if layout.is_fortran {
        values = values.to_c_order(&layout.shape);
    }
    Ok(Array {
        shape: layout.shape,
        values,
    })
}

impl Array {
    /// Converts `float32` or `float64` (rounded) to an image of one channel.
    ///
    /// # Errors
    /// Returns an error for integers, whose unit is unknown, for several channels, and for an axis above 2³² − 1.
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
            Values::U8(_) | Values::U16(_) | Values::I32(_) | Values::I64(_) => {
                return Err(CodecError::new(
                    FORMAT,
                    "descr",
                    "integers are not metres",
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
    use crate::npy::{encode, header};
    use proptest::prelude::*;

    #[test]
    fn errors_state_a_remedy() {
        let mut file = encode(&[2, 2], &[1f32, 2.0, 3.0, 4.0]).unwrap();
        file.pop();
        assert_eq!(
            decode(&file).unwrap_err().to_string(),
            "NPY: data: 15 bytes, [2, 2] of 4 bytes each needs 16; the file is truncated or damaged; copy it again"
        );
        let says = |bytes: Vec<u8>| decode(&bytes).unwrap_err().to_string();
        let complex = header::encode("'<c8'", &[2, 2]);
        assert!(says(complex).contains("'<c8' is not one of"));
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
    fn reads_both_byte_orders() {
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

    /// `numpy.save` of `asfortranarray([[1, 2, 3], [4, 5, 6]])` in `float16`.
    #[test]
    fn reads_float16_and_fortran_order() {
        let mut file = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
        let dict = "{'descr': '<f2', 'fortran_order': True, 'shape': (2, 3), }";
        file.extend(format!("{dict:<117}\n").bytes());
        for half in [0x3C00u16, 0x4400, 0x4000, 0x4500, 0x4200, 0x4600] {
            file.extend(half.to_le_bytes());
        }
        let image = decode(&file).unwrap().into_f32_image().unwrap();
        assert_eq!((image.width(), image.height()), (3, 2));
        assert_eq!(image.pixels(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    }

    proptest! {
        #[test]
        fn round_trip_is_lossless(bits in prop::collection::vec(any::<u32>(), 0..60)) {
            let values: Vec<f32> = bits.iter().map(|&bits| f32::from_bits(bits)).collect();
            let Array { shape, values } = decode(&encode(&[values.len(), 1], &values).unwrap()).unwrap();
            prop_assert_eq!(shape, [bits.len(), 1]);
            let Values::F32(values) = values else { return Err(TestCaseError::fail("not float32")) };
            prop_assert_eq!(values.iter().map(|v| v.to_bits()).collect::<Vec<_>>(), bits);
        }

        #[test]
        fn never_panics_on_damaged_files(at in 0usize..152, value: u8, cut in 0usize..153) {
            let mut file = encode(&[2, 3], &[0f32; 6]).unwrap();
            file[at] = value;
            file.truncate(cut);
            if let Ok(array) = decode(&file) {
                prop_assert!(header::elements(&array.shape).is_some_and(|n| n <= file.len()));
            }
        }

        #[test]
        fn rejects_random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            prop_assert!(decode(&bytes).is_err());
            let file = [super::super::MAGIC, &[1, 0, 100, 0], &bytes].concat();
            prop_assert!(decode(&file).is_err());
        }
    }
}
