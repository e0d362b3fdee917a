//! The parameters of everything in this crate, as lists for help, schemas and manuals.

use oaktwin_base::diagnostic::suggest;
pub use oaktwin_base::parameter::{
    About, Choice, DefaultSource, Group, Kind, Listing, ParameterError, Platform, Scalar, choice, choose,
};

use crate::{filter, imager, single_view, stereo_matching, stereo_noise, time_of_flight};

/// All groups of parameters: the engines first.
pub const GROUPS: &[Group] = &[
    Group::new(
        "stereo-noise",
        "Parametric stereo error model",
        &[Group::list_of::<stereo_noise::Parameters>],
    ),
    Group::new(
        "stereo-matching",
        "Stereo matching of an image pair, as on the device",
        &[Group::list_of::<stereo_matching::Parameters>],
    ),
    Group::new(
        "time-of-flight",
        "Time-of-flight phase model",
        &[Group::list_of::<time_of_flight::Parameters>],
    ),
    Group::new(
        "single-view",
        "Isaac Sim's DepthSensorDistance: NVIDIA's attributes, and the choices that its documentation leaves open",
        &[
            Group::list_of::<single_view::Parameters>,
            Group::list_of::<single_view::Assumptions>,
        ],
    ),
    Group::new(
        "imager",
        "Image sensor of a stereo pair",
        &[Group::list_of::<imager::Parameters>],
    ),
    Group::new(
        "color-imager",
        "Image sensor of a colour camera",
        &[Group::list_of::<imager::ColorParameters>],
    ),
    Group::new(
        "filters",
        "DepthAI's post-processing filters",
        &[
            Group::list_of::<filter::MedianSettings>,
            Group::list_of::<filter::Spatial>,
            Group::list_of::<filter::Temporal>,
            Group::list_of::<filter::Speckle>,
            Group::list_of::<filter::Decimation>,
            Group::list_of::<filter::Threshold>,
            Group::list_of::<filter::Brightness>,
        ],
    ),
];

/// The number of [`GROUPS`] that are engines.
pub const ENGINES: usize = 4;

/// The group of this name; case, hyphens and underscores do not matter.
///
/// # Errors
/// Returns an error that suggests the nearest names if there is no such group.
pub fn group(name: &str) -> Result<&'static Group, ParameterError> {
    let folded = oaktwin_base::diagnostic::fold_name(name);
    let found = GROUPS
        .iter()
        .find(|group| oaktwin_base::diagnostic::fold_name(group.name) == folded);
    found.ok_or_else(|| {
        let remedy = suggest(name, GROUPS.iter().map(|group| group.name));
        ParameterError::new(name, "unknown group of parameters", remedy)
    })
}
