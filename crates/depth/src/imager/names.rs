//! Parameters by name.

use super::parameters::Parameters;
use crate::choice;
use crate::named::{self, Named, field, flag, one_of};

const TABLE: [Named<Parameters>; 11] = [
    flag!("autoExposure", auto_exposure),
    field!("exposureTarget", exposure_target, "give a number"),
    field!("exposure", exposure, "give a number"),
    field!("maxExposureTime", max_exposure_time, "give a number"),
    field!("maxGain", max_gain, "give a number"),
    field!("fullWell", full_well_e, "give a number"),
    field!("readNoise", read_noise_e, "give a number"),
    flag!("noise", noise),
    field!("lensBlur", lens_blur_px, "give a number"),
    field!("vignetting", vignetting, "give a number"),
    one_of!("bits", bits, "give 8 or 10"),
];

named::by_name!(Parameters, TABLE, |name| {
    choice::unknown(name, "parameter of an imager", &NAMES)
});
