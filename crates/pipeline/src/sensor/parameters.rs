use oaktwin_camera::{Intrinsics, StereoGeometry, Usd};
use oaktwin_catalog::{Role, Twin, TwinDepthSensor};
use oaktwin_depth::preset::Platform;
use oaktwin_depth::{single_view, stereo_matching, stereo_noise, time_of_flight};
use oaktwin_usd::asset::IsaacVersion;

/// The parameters that a render product of this sensor has, in an asset for that Isaac Sim.
#[must_use]
pub fn single_view_parameters(
    sensor: &TwinDepthSensor,
    extended_disparity: bool,
    isaac: IsaacVersion,
) -> single_view::Parameters {
    let mut parameters = sensor.attributes(extended_disparity);
    if isaac == IsaacVersion::V6 {
        // A switch there.
        parameters.outlier_removal_range_px = parameters.outlier_removal_range_px.min(1);
    }
    parameters
}

/// The parameters of the stereo pair of a twin, in the mode of its cameras' used resolution; `None` where it has no
/// pair.
#[must_use]
pub fn stereo_noise_parameters(twin: &Twin) -> Option<stereo_noise::Parameters> {
    let (left, right) = (twin.camera(Role::Left)?, twin.camera(Role::Right)?);
    let baseline = left.body_from_camera.translation - right.body_from_camera.translation;
    let stereo = StereoGeometry {
        focal_length_px: left.intrinsics.fx,
        baseline_m: baseline.length(),
    };
    Some(stereo_noise::Parameters::new(stereo, left.intrinsics.size.width))
}

/// The parameters of a time-of-flight camera of these intrinsics.
#[must_use]
pub fn time_of_flight_parameters(intrinsics: Intrinsics) -> time_of_flight::Parameters {
    let centre = intrinsics.principal_point::<Usd>();
    time_of_flight::Parameters {
        principal_point_px: Some([centre.x, centre.y]),
        ..time_of_flight::Parameters::new(intrinsics.fx, intrinsics.size.width)
    }
}

/// The parameters of the matcher of a twin, on this processor, in the mode of its cameras' used resolution; `None` where it
/// has no pair.
#[must_use]
pub fn stereo_matching_parameters(twin: &Twin, platform: Platform) -> Option<stereo_matching::Parameters> {
    let pair = stereo_noise_parameters(twin)?;
    Some(stereo_matching::Parameters::new(
        platform,
        pair.stereo,
        pair.width_px,
    ))
}
