//! Filters of depth and disparity images, bit for bit as `DepthAI` runs them on a host. Images are 16-bit, 0 is no value.

mod threshold;

pub use threshold::Threshold;

use oaktwin_image::Image;

/// One filter and its settings, under `DepthAI`'s names.
#[derive(Clone, Debug, PartialEq)]
pub enum Filter {
    /// `thresholdFilter`
    Threshold(Threshold),
}

/// Filters in their order, with what they remember of earlier frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain {
    filters: Vec<Filter>,
}

impl Chain {
    /// Of filters, first to last; nothing is remembered yet.
    #[must_use]
    pub fn new(filters: Vec<Filter>) -> Self {
        Self { filters }
    }

    /// Its filters.
    #[must_use]
    pub fn filters(&self) -> &[Filter] {
        &self.filters
    }

    /// Whether it does nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.filters.is_empty()
    }

    /// Filters the next image of a sequence.
    #[must_use]
    pub fn run(&mut self, mut image: Image<u16>) -> Image<u16> {
        for filter in &mut self.filters {
            match filter {
                Filter::Threshold(threshold) => threshold.run(&mut image),
            }
        }
        image
    }
}
