use oaktwin_catalog::{Connection, Latency, MatchingMode, Twin, TwinDepthSensor};
use oaktwin_depth::Engine;

/// Returns the latency of a twin's depth sensor in the mode of its engine, by default over the device's own connection; `None` where no
/// source states it.
#[must_use]
pub fn latency(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    engine: &dyn Engine,
    connection: Option<Connection>,
) -> Option<Latency> {
    let parameters = engine.parameters();
    let value = |name: &str| {
        let found = parameters.iter().find(|(own, _)| *own == name);
        found.map(|(_, value)| value.as_str())
    };
    let flag = |name: &str, default: bool| value(name).map_or(default, |value| value == "true");
    let default = MatchingMode::default();
    let mode = MatchingMode {
        is_extended: flag("extendedDisparity", default.is_extended),
        has_subpixels: flag("subpixel", default.has_subpixels),
        checks_left_right: flag("leftRightCheck", default.checks_left_right),
    };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a width in pixels"
    )]
    let own_px = sensor.spec.sensor_size_px as u32;
    let width_px = value("width")
        .and_then(|width| width.parse().ok())
        .unwrap_or(own_px);
    twin.device.latency(sensor.spec.kind, mode, width_px, connection)
}
