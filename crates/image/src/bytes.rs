//! Conversion of numbers to bytes and back, in loops that compile to copies or vector shuffles.

/// A number with a fixed width in files.
pub(crate) trait Scalar: Copy + Default {
    /// Appends `values`, least significant byte first.
    fn put_le(values: &[Self], out: &mut Vec<u8>);

    /// Appends `values`, most significant byte first.
    fn put_be(values: &[Self], out: &mut Vec<u8>);

    /// Reads all complete values in `bytes`, least significant byte first.
    fn get_le(bytes: &[u8]) -> Vec<Self>;

    /// Reads all complete values in `bytes`, most significant byte first.
    fn get_be(bytes: &[u8]) -> Vec<Self>;
}

macro_rules! scalar {
    ($($number:ty),+) => {$(
        impl Scalar for $number {
            fn put_le(values: &[Self], out: &mut Vec<u8>) {
                let start = out.len();
                out.resize(start + size_of_val(values), 0);
                let (places, _) = out[start..].as_chunks_mut::<{ size_of::<Self>() }>();
                for (place, value) in places.iter_mut().zip(values) {
                    *place = value.to_le_bytes();
                }
            }

            fn put_be(values: &[Self], out: &mut Vec<u8>) {
                let start = out.len();
                out.resize(start + size_of_val(values), 0);
                let (places, _) = out[start..].as_chunks_mut::<{ size_of::<Self>() }>();
                for (place, value) in places.iter_mut().zip(values) {
                    *place = value.to_be_bytes();
                }
            }

            fn get_le(bytes: &[u8]) -> Vec<Self> {
                let (places, _) = bytes.as_chunks::<{ size_of::<Self>() }>();
                places.iter().map(|place| Self::from_le_bytes(*place)).collect()
            }

            fn get_be(bytes: &[u8]) -> Vec<Self> {
                let (places, _) = bytes.as_chunks::<{ size_of::<Self>() }>();
                places.iter().map(|place| Self::from_be_bytes(*place)).collect()
            }
        }
    )+};
}

scalar!(u8, u16, u32, i32, i64, f32, f64);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_byte_orders_round_trip() {
        let values = [1.5f32, f32::INFINITY, -0.0, f32::from_bits(1)];
        let mut little = vec![9];
        f32::put_le(&values, &mut little);
        assert_eq!(little[..5], [9, 0, 0, 0xC0, 0x3F]);
        assert_eq!(f32::get_le(&little[1..]), values);
        let mut big = Vec::new();
        f32::put_be(&values, &mut big);
        assert_eq!(big[..4], [0x3F, 0xC0, 0, 0]);
        assert_eq!(f32::get_be(&big), values);
        assert_eq!(u16::get_be(&[1, 2, 3]), [0x0102]);
    }
}
