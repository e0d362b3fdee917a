//! Values from the bytes of an input.

use arbitrary::Unstructured;
use oaktwin_image::Image;

/// Reads an input; when its bytes run out, everything is zero, the first, or empty.
pub(crate) struct Random<'a>(Unstructured<'a>);

impl<'a> Random<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(Unstructured::new(bytes))
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn byte(&mut self) -> u8 {
        self.0.arbitrary().unwrap_or(0)
    }

    /// Returns an integer up to and including `max`.
    pub(crate) fn up_to(&mut self, max: u32) -> u32 {
        self.0.int_in_range(0..=max).unwrap_or(0)
    }

    pub(crate) fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.up_to(u32::try_from(all.len() - 1).unwrap_or(0)) as usize]
    }

    /// Returns an ordinary, extreme or arbitrary number.
    pub(crate) fn number(&mut self) -> f64 {
        const SPECIAL: [f64; 16] = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            0.5,
            1e-9,
            1e9,
            1e-38,
            1e38,
            1e-300,
            1e300,
            4294967296.0,
            255.0,
            65535.0,
            f64::MAX,
            f64::MIN_POSITIVE,
        ];
        match self.up_to(3) {
            0 => self.pick(&SPECIAL),
            1 => f64::from(self.0.arbitrary::<i16>().unwrap_or(0)),
            2 => f64::from(self.0.arbitrary::<i16>().unwrap_or(0)) / 256.0,
            _ => f64::from_bits(self.0.arbitrary().unwrap_or(0)),
        }
    }

    /// Returns depth in metres: plausible, missing, or any bits.
    pub(crate) fn depth(&mut self) -> f32 {
        match self.byte() {
            0 => f32::INFINITY,
            1 => f32::NAN,
            2 => f32::from_bits(self.0.arbitrary().unwrap_or(0)),
            3 => 0.0,
            byte => f32::from(byte) / 32.0,
        }
    }

    /// Returns a text of up to 40 bytes.
    pub(crate) fn text(&mut self) -> String {
        let length = self.up_to(40) as usize;
        let length = length.min(self.0.len());
        String::from_utf8_lossy(self.0.bytes(length).unwrap_or_default()).into_owned()
    }

    /// Returns an image with a size that is drawn up to a maximum, whose pixels repeat a drawn pattern where bytes are few.
    pub(crate) fn image<T: Copy>(
        &mut self,
        width: u32,
        height: u32,
        mut pixel: impl FnMut(&mut Self) -> T,
    ) -> Image<T> {
        let count = (width * height) as usize;
        let mut pixels = vec![pixel(self)];
        while pixels.len() < count && !self.is_empty() {
            pixels.push(pixel(self));
        }
        let drawn = pixels.len();
        pixels.truncate(count);
        for at in pixels.len()..count {
            pixels.push(pixels[at % drawn]);
        }
        Image::new(width, height, pixels).unwrap_or_else(|| panic!("{width} × {height}"))
    }
}
