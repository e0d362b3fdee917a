use oaktwin_image::Image;

/// Drops what is nearer or farther than a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Threshold {
    /// `minRange`, mm.
    pub min_range: u16,
    /// `maxRange`, mm.
    pub max_range: u16,
}

impl Threshold {
    pub(super) fn run(&self, image: &mut Image<u16>) {
        for value in image.pixels_mut() {
            if *value < self.min_range || *value > self.max_range {
                *value = 0;
            }
        }
    }
}
