use oaktwin_camera::Intrinsics;
use oaktwin_image::{Image, ImageView};
use oaktwin_simd::Level;

use super::temporal::Memory;
use super::{Decimation, DecimationMode, Filter, Pixel, Sample};
use crate::reason::{self, ReasonCodes};

/// A sequence of filters with their memory of earlier frames, for one camera and one type of pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain<P = u16> {
    filters: Vec<Filter>,
    /// The memory of each filter; only temporal filters use it.
    memories: Vec<Memory<P>>,
}

// Not derived, which would require `P: Default`.
impl<P: Pixel> Default for Chain<P> {
    fn default() -> Self {
        Self::new(Vec::new())
    }
}

impl<P: Pixel> Chain<P> {
    /// Creates a chain from filters in their order, whose settings [`Filter::check`] accepts.
    #[must_use]
    pub fn new(filters: Vec<Filter>) -> Self {
        let memories = filters.iter().map(|_| Memory::default()).collect();
        Self { filters, memories }
    }

    /// The filters.
    #[must_use]
    pub fn filters(&self) -> &[Filter] {
        &self.filters
    }

    /// Whether there are no filters.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.filters.is_empty()
    }

    /// The size of a filtered image, which [decimation](super::Decimation) changes.
    #[must_use]
    pub fn size(&self, width: u32, height: u32) -> (u32, u32) {
        self.decimations()
            .fold((width, height), |(width, height), decimation| {
                decimation.size(width, height)
            })
    }

    /// The intrinsics of a filtered image, which [decimation](super::Decimation) changes.
    #[must_use]
    pub fn intrinsics(&self, intrinsics: &Intrinsics) -> Intrinsics {
        self.decimations().fold(*intrinsics, |intrinsics, decimation| {
            decimation.intrinsics(&intrinsics)
        })
    }

    /// Reduces an image that belongs to the unfiltered one, such as its colours, to the size of the filtered one.
    #[must_use]
    pub fn companion<T: Sample>(&self, image: Image<T>) -> Image<T> {
        self.decimations()
            .fold(image, |image, decimation| decimation.companion(&image))
    }

    /// The decimations that change the size.
    fn decimations(&self) -> impl Iterator<Item = &Decimation> {
        self.filters.iter().filter_map(|filter| match filter {
            Filter::Decimation(decimation) if decimation.factor > 1 => Some(decimation),
            _ => None,
        })
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        self.memories.fill(Memory::default());
    }

    /// Filters the next image of a sequence. A change of size resets the memory. Filters that need a colour image do nothing.
    #[must_use]
    pub fn run(&mut self, image: Image<P>) -> Image<P> {
        self.run_seeing(image, None)
    }

    /// Filters the next image of a sequence, with its colour image if there is one.
    #[must_use]
    pub fn run_seeing(&mut self, image: Image<P>, rgb: Option<ImageView<'_, [u8; 4]>>) -> Image<P> {
        self.run_some(image, rgb, 1.0, |_| true, None)
    }

    /// Runs some of the filters, as [`Chain::run_seeing`]. `integer_level` is the pixel value of one pixel of disparity, the
    /// unit of [`Speckle::difference_threshold`](super::Speckle). The reasons follow the image.
    pub(crate) fn run_some(
        &mut self,
        mut image: Image<P>,
        rgb: Option<ImageView<'_, [u8; 4]>>,
        integer_level: f64,
        wanted: impl Fn(&Filter) -> bool,
        mut reasons: Option<&mut ReasonCodes>,
    ) -> Image<P> {
        let level = Level::detect();
        for (filter, memory) in self.filters.iter().zip(&mut self.memories) {
            if !wanted(filter) {
                continue;
            }
            match filter {
                Filter::Median(median) => median.run(level, &mut image),
                Filter::Spatial(spatial) => spatial.run(level, &mut image),
                Filter::Temporal(temporal) => temporal.run(level, &mut image, memory),
                Filter::Speckle(speckle) => speckle.of_levels(integer_level).run(level, &mut image),
                Filter::Decimation(decimation) => image = decimation.run(level, &image),
                Filter::Threshold(threshold) => threshold.run(&mut image),
                Filter::Brightness(brightness) => {
                    if let Some(rgb) = rgb {
                        brightness.run(&mut image, rgb);
                    }
                }
            }
            if let Some(reasons) = &mut reasons {
                if let Filter::Decimation(decimation) = filter {
                    // Codes have no mean. Where a block has no value, its first pixel has none either.
                    let first = Decimation {
                        mode: DecimationMode::PixelSkipping,
                        ..*decimation
                    };
                    reasons.0 = first.companion(&reasons.0);
                }
                let code = reason::of_filter(filter);
                reasons.after(image.pixels(), |value| value != P::default(), |_| code);
            }
        }
        image
    }
}
