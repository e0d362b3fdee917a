//! Why a pixel of a sensor's output has no value.

use std::collections::BTreeMap;

use oaktwin_image::Image;
use oaktwin_image::annotation::{ReasonLabel, Reasons};

use crate::filter::{self, Filter};

macro_rules! reasons {
    ($($doc:literal $variant:ident $name:literal;)+) => {
        /// Why a pixel has no value. The number is its code in images; the codes of filters follow ([`Reason::FILTERS`]).
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Reason {
            $(#[doc = $doc] $variant,)+
        }

        const REASONS: &[(Reason, &str, &str)] = &[$((Reason::$variant, $name, $doc),)+];
    };
}

reasons! {
    "The pixel has a value." Measured "measured";
    "The input has no surface in this pixel." NoSurface "no_surface";
    "The surface is nearer than the sensor can measure." TooNear "too_near";
    "The surface is farther than the sensor can measure." TooFar "too_far";
    "The surface is outside the view of the other camera." OutsideOtherView "outside_other_view";
    "Something nearer hides the surface from the other camera." Occluded "occluded";
    "The image has too little texture for a reliable match." NoTexture "no_texture";
    "The image is overexposed." Saturated "saturated";
    "The matches from left to right and from right to left differ." LeftRightCheck "left_right_check";
    "The sensor dropped the pixel at random." Dropout "dropout";
    "The pixel is in the invalid columns at the image's border." Border "border";
    "Qualcomm's hole filling found no reliable disparity around the pixel." HoleFilling "hole_filling";
    "None of the neighbours has a value." Outlier "outlier";
    "The phases of both frequencies do not agree on a distance." WrappedPhase "wrapped_phase";
    "Too little of the sensor's own light returns." LowAmplitude "low_amplitude";
}

impl Reason {
    /// The code of the first of [`filter::NAMES`]; the codes of the other filters follow.
    pub const FILTERS: u8 = 32;

    /// The number of codes, those without a meaning included: one more than the last.
    pub const CODES: usize = Self::FILTERS as usize + filter::NAMES.len();

    /// The code in images.
    #[must_use]
    pub const fn code(self) -> u8 {
        self as u8
    }
}

/// Returns the code of pixels that a filter removes.
pub(crate) fn of_filter(filter: &Filter) -> u8 {
    let place = filter::NAMES.iter().position(|name| *name == filter.name());
    (Reason::FILTERS..)
        .nth(place.unwrap_or(0))
        .unwrap_or(Reason::FILTERS)
}

/// Returns the name and a sentence for each code.
#[must_use]
pub fn legend() -> BTreeMap<u8, ReasonLabel> {
    let own = REASONS.iter().map(|(reason, name, documentation)| {
        let label = ReasonLabel {
            name: (*name).to_owned(),
            documentation: (*documentation).to_owned(),
        };
        (reason.code(), label)
    });
    let filters = (Reason::FILTERS..).zip(filter::NAMES).map(|(code, name)| {
        let label = ReasonLabel {
            name: format!("filter_{name}"),
            documentation: format!("The filter {name} removed the value."),
        };
        (code, label)
    });
    own.chain(filters).collect()
}

/// The codes of an output's pixels: 0 where the output has a value.
#[derive(Clone, Debug, PartialEq)]
pub struct ReasonCodes(pub Image<u8>);

impl From<ReasonCodes> for Reasons {
    fn from(codes: ReasonCodes) -> Self {
        Self {
            codes: codes.0,
            legend: legend(),
        }
    }
}

impl ReasonCodes {
    /// Updates the codes after a step: a pixel with a value needs no reason, and one that lost its value has this one.
    pub(crate) fn after<T: Copy>(
        &mut self,
        values: &[T],
        is_valid: impl Fn(T) -> bool,
        reason: impl Fn(usize) -> u8,
    ) {
        for (place, (code, value)) in self.0.pixels_mut().iter_mut().zip(values).enumerate() {
            *code = match (is_valid(*value), *code) {
                (true, _) => 0,
                (false, 0) => reason(place),
                (false, known) => known,
            };
        }
    }

    /// Updates the codes after distances were computed: what is beyond their range is too far.
    pub(crate) fn after_depth(&mut self, depth: &Image<f32>) {
        self.after(depth.pixels(), |metres| metres > 0.0, |_| Reason::TooFar.code());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_names_are_unique() {
        let legend = legend();
        assert_eq!(legend.len(), REASONS.len() + filter::NAMES.len());
        assert!(REASONS.len() < usize::from(Reason::FILTERS));
        let mut names: Vec<&str> = legend.values().map(|label| label.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), legend.len());
        assert_eq!(legend[&0].name, "measured");
        assert_eq!(
            legend.keys().last().map(|last| usize::from(*last) + 1),
            Some(Reason::CODES)
        );
    }

    #[test]
    fn every_filter_has_its_code() {
        for (code, name) in (Reason::FILTERS..).zip(filter::NAMES) {
            assert_eq!(of_filter(&filter::parse(name).unwrap()), code);
            assert_eq!(legend()[&code].name, format!("filter_{name}"));
        }
    }

    #[test]
    fn the_first_reason_counts() {
        let mut codes = ReasonCodes(Image::new(4, 1, vec![0, 0, 5, 5]).unwrap());
        codes.after(&[1, 0, 0, 1], |value| value > 0, |_| 7);
        assert_eq!(codes.0.pixels(), [0, 7, 5, 0]);
    }
}
