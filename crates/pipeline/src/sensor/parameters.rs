use oaktwin_camera::{Intrinsics, StereoGeometry, Usd};
use oaktwin_catalog::{Role, Twin, TwinDepthSensor};
use oaktwin_depth::preset::Platform;
use oaktwin_depth::{single_view, stereo_noise, time_of_flight};
use oaktwin_usd::asset::IsaacVersion;

/// Returns the attributes of this sensor's render product in an asset for an Isaac Sim version.
#[must_use]
pub fn single_view_parameters(
    sensor: &TwinDepthSensor,
    extended_disparity: bool,
    isaac: IsaacVersion,
) -> single_view::Parameters {
    let mut parameters = sensor.attributes(extended_disparity);
    if isaac == IsaacVersion::V6 {
        // The attribute is a switch in Isaac Sim 6.
        parameters.outlier_removal_range_px = parameters.outlier_removal_range_px.min(1);
    }
    parameters
}

/// Returns the geometry with which a twin's processor converts disparity to depth, and the image width, at its cameras' used
/// resolution, or `None` if it lacks one of the cameras.
pub(super) fn stereo_pair(twin: &Twin, pair: (Role, Role)) -> Option<(StereoGeometry, u32)> {
    let left = twin.rectified_left(pair)?;
    let stereo = StereoGeometry {
        focal_length_px: left.intrinsics.fx,
        baseline_m: twin.depth_baseline_m(pair)?,
    };
    Some((stereo, left.intrinsics.size.width))
}

/// Returns the platform of a twin. Devices with an unknown processor are treated as the most common one.
pub(super) fn platform_of(twin: &Twin) -> Platform {
    twin.platform().unwrap_or(Platform::Rvc2)
}

/// Returns the `stereo_noise` parameters of the stereo pair of a twin at its cameras' used resolution, or `None` if it has
/// no pair.
#[must_use]
pub fn stereo_noise_parameters(twin: &Twin) -> Option<stereo_noise::Parameters> {
    let (stereo, width_px) = stereo_pair(twin, (Role::Left, Role::Right))?;
    Some(stereo_noise::Parameters::new(platform_of(twin), stereo, width_px))
}

/// Returns the `time_of_flight` parameters of a camera.
#[must_use]
pub fn time_of_flight_parameters(intrinsics: Intrinsics) -> time_of_flight::Parameters {
    let centre = intrinsics.principal_point::<Usd>();
    time_of_flight::Parameters {
        principal_point_px: Some([centre.x, centre.y]),
        ..time_of_flight::Parameters::new(intrinsics.fx, intrinsics.size.width)
    }
}
