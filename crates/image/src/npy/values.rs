/// The values of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// `uint8`
    U8(Vec<u8>),
    /// `uint16`
    U16(Vec<u16>),
    /// `int32`, or `int16`
    I32(Vec<i32>),
    /// `int64`, or `uint32`
    I64(Vec<i64>),
    /// `float32`, or `float16`
    F32(Vec<f32>),
    /// `float64`
    F64(Vec<f64>),
}

impl Values {
    /// Converts the values of an array in Fortran order to C order.
    pub(super) fn to_c_order(&self, shape: &[usize]) -> Self {
        match self {
            Self::U8(values) => Self::U8(to_c_order(shape, values)),
            Self::U16(values) => Self::U16(to_c_order(shape, values)),
            Self::I32(values) => Self::I32(to_c_order(shape, values)),
            Self::I64(values) => Self::I64(to_c_order(shape, values)),
            Self::F32(values) => Self::F32(to_c_order(shape, values)),
            Self::F64(values) => Self::F64(to_c_order(shape, values)),
        }
    }
}

/// Converts values in Fortran order to C order.
fn to_c_order<T: Copy>(shape: &[usize], values: &[T]) -> Vec<T> {
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
        // Advance to the next index in C order, in which the last axis is contiguous.
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
        fn converts_from_fortran_order(a in 1usize..5, b in 1usize..5, c in 1usize..5) {
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
}
