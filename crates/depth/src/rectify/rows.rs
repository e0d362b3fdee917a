//! Bilinear interpolation.

/// A grey value: 8 or 16 bits.
pub trait Grey: Copy + Default + Send + Sync + Sealed {
    /// Returns the value of 8 bits.
    fn from_u8(value: u8) -> Self;
}

use oaktwin_simd::Kernel;

mod sealed {
    pub trait Sealed: Sized {
        fn number(self) -> u32;
        fn of(number: u32) -> Self;
    }
}

use sealed::Sealed;

macro_rules! grey {
    ($type:ty) => {
        impl Grey for $type {
            fn from_u8(value: u8) -> Self {
                value.into()
            }
        }

        impl Sealed for $type {
            #[inline(always)]
            fn number(self) -> u32 {
                self.into()
            }

            #[inline(always)]
            #[expect(clippy::cast_possible_truncation, reason = "a mean of such numbers")]
            fn of(number: u32) -> Self {
                number as Self
            }
        }
    };
}

grey!(u8);
grey!(u16);

/// A band of rows.
pub(super) struct Remap<'a, P> {
    pub(super) raw: &'a [P],
    pub(super) stride: usize,
    pub(super) places: &'a [u32],
    pub(super) parts: &'a [[u8; 2]],
    pub(super) out: &'a mut [P],
}

/// The number of pixels that are gathered before they are interpolated.
const LANES: usize = 256;

impl<P: Grey> Kernel for Remap<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let [mut upper, mut lower] = [[[P::default(); 2]; LANES]; 2];
        let chunks =
            (self.out.chunks_mut(LANES)).zip(self.places.chunks(LANES).zip(self.parts.chunks(LANES)));
        for (out, (places, parts)) in chunks {
            for ((upper, lower), &place) in upper.iter_mut().zip(&mut lower).zip(places) {
                let place = place as usize;
                // Indices are valid by construction.
                if let Some(rows) = self.raw.get(place..place + self.stride + 2) {
                    (*upper, *lower) = ([rows[0], rows[1]], [rows[self.stride], rows[self.stride + 1]]);
                }
            }
            for (((out, &[x, y]), &[a, b]), &[c, d]) in out.iter_mut().zip(parts).zip(&upper).zip(&lower) {
                let [x, y] = [u32::from(x), u32::from(y)];
                let top = a.number() * (32 - x) + b.number() * x;
                let bottom = c.number() * (32 - x) + d.number() * x;
                *out = P::of((top * (32 - y) + bottom * y + 512) >> 10);
            }
        }
    }
}
