use std::collections::BTreeMap;

use oaktwin_camera::math::DVec3;
use oaktwin_imu::ChannelNoise;
use serde::{Deserialize, Serialize};

use super::{Evidence, Note};
use crate::{Source, Sources};

/// Standard gravity in m/s², by which datasheets define g.
const STANDARD_GRAVITY: f64 = 9.806_65;

/// A µg in m/s².
const M_S2_PER_UG: f64 = STANDARD_GRAVITY * 1e-6;

/// A millidegree per second in rad/s.
const RAD_S_PER_MDPS: f64 = 1e-3 * std::f64::consts::PI / 180.0;

/// A chip with an accelerometer, a gyroscope or a magnetometer: `data/imus/*.toml`.
///
/// Units are as in datasheets (g, °/s, µT); [`accelerometer_noise`](Self::accelerometer_noise) and
/// [`gyroscope_noise`](Self::gyroscope_noise) convert them to SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct InertialPart {
    /// The name by which devices refer to it, such as `BMI270`.
    pub id: String,
    /// The manufacturer, such as `Bosch Sensortec`.
    pub manufacturer: String,
    /// The kind in words, such as `accelerometer and gyroscope`.
    pub kind: String,
    /// The accelerometer, if the part has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accelerometer: Option<Accelerometer>,
    /// The gyroscope, if the part has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gyroscope: Option<Gyroscope>,
    /// The magnetometer, if the part has one and a source states its numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub magnetometer: Option<Magnetometer>,
    /// Further evidence about the values above.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<Evidence>,
    /// Notes for readers of the numbers, including what no source states.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Note>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The accelerometer of an [`InertialPart`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Accelerometer {
    /// The ranges that can be selected, ± g.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ranges_g: Vec<f64>,
    /// The range that is simulated, ± g.
    pub range_g: f64,
    /// The difference of successive values in this range, µg.
    pub step_ug: f64,
    /// The density of the white noise by axis, µg/√Hz; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise_density_ug: Option<[f64; 3]>,
    /// The random walk of the bias by axis, µg/s/√Hz; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub random_walk_ug: Option<[f64; 3]>,
    /// The rates at which devices report samples, Hz; empty if no source states them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rates_hz: Vec<f64>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The gyroscope of an [`InertialPart`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Gyroscope {
    /// The ranges that can be selected, ± °/s.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ranges_dps: Vec<f64>,
    /// The range that is simulated, ± °/s.
    pub range_dps: f64,
    /// The difference of successive values in this range, m°/s.
    pub step_mdps: f64,
    /// The density of the white noise by axis, m°/s/√Hz; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise_density_mdps: Option<[f64; 3]>,
    /// The random walk of the bias by axis, m°/s²/√Hz; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub random_walk_mdps: Option<[f64; 3]>,
    /// The rates at which devices report samples, Hz; empty if no source states them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rates_hz: Vec<f64>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The magnetometer of an [`InertialPart`], which is not simulated.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Magnetometer {
    /// The range, ± µT; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range_ut: Option<f64>,
    /// The difference of successive values, µT; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step_ut: Option<f64>,
    /// The rates of samples, Hz.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rates_hz: Vec<f64>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

impl InertialPart {
    /// Whether the part has both an accelerometer and a gyroscope.
    #[must_use]
    pub const fn is_inertial(&self) -> bool {
        self.accelerometer.is_some() && self.gyroscope.is_some()
    }

    /// Returns the errors of the accelerometer in m/s², if the part has one. Errors that no source states are 0.
    #[must_use]
    pub fn accelerometer_noise(&self) -> Option<ChannelNoise> {
        let spec = self.accelerometer.as_ref()?;
        let axes = |values: Option<[f64; 3]>| DVec3::from(values.unwrap_or_default()) * M_S2_PER_UG;
        Some(ChannelNoise {
            density: axes(spec.noise_density_ug),
            random_walk: axes(spec.random_walk_ug),
            turn_on_bias: DVec3::ZERO,
            range: spec.range_g * STANDARD_GRAVITY,
            step: spec.step_ug * M_S2_PER_UG,
        })
    }

    /// Returns the errors of the gyroscope in rad/s, if the part has one. Errors that no source states are 0.
    #[must_use]
    pub fn gyroscope_noise(&self) -> Option<ChannelNoise> {
        let spec = self.gyroscope.as_ref()?;
        let axes = |values: Option<[f64; 3]>| DVec3::from(values.unwrap_or_default()) * RAD_S_PER_MDPS;
        Some(ChannelNoise {
            density: axes(spec.noise_density_mdps),
            random_walk: axes(spec.random_walk_mdps),
            turn_on_bias: DVec3::ZERO,
            range: spec.range_dps.to_radians(),
            step: spec.step_mdps * RAD_S_PER_MDPS,
        })
    }

    /// Returns the highest rate at which both sensors report samples, Hz, if a source states it.
    #[must_use]
    pub fn max_rate_hz(&self) -> Option<f64> {
        let highest = |rates: &[f64]| rates.iter().copied().reduce(f64::max);
        let accelerometer = highest(&self.accelerometer.as_ref()?.rates_hz)?;
        let gyroscope = highest(&self.gyroscope.as_ref()?.rates_hz)?;
        Some(accelerometer.min(gyroscope))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalog;

    /// The figures of the datasheets in SI, computed independently.
    #[test]
    fn noise_is_converted_to_si() {
        let catalog = Catalog::builtin();
        let part = |id| catalog.inertial_part(id).unwrap();
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 5e-3, "{a} {b}");
        for (id, acceleration, rate) in [
            ("BMI270", 1.57e-3, 1.22e-4),
            ("LSM6DSV", 4.43e-4, 4.934e-5),
            ("ICM-42688-P", 6.86e-4, 4.89e-5),
        ] {
            near(part(id).accelerometer_noise().unwrap().density.x, acceleration);
            near(part(id).gyroscope_noise().unwrap().density.x, rate);
        }
        let accelerometer = part("BMI270").accelerometer_noise().unwrap();
        near(accelerometer.range, 156.9);
        near(accelerometer.step, 9.806_65 / 2048.0);
        let gyroscope = part("BMI270").gyroscope_noise().unwrap();
        near(gyroscope.range, 34.907);
        near(gyroscope.step, (1.0f64 / 16.384).to_radians());
        assert_eq!(gyroscope.random_walk, DVec3::ZERO, "no source states it");
    }

    /// 16-bit codes cover the range.
    #[test]
    fn steps_fit_the_ranges() {
        for part in Catalog::builtin().inertial_parts() {
            let channels = [part.accelerometer_noise(), part.gyroscope_noise()];
            for noise in channels.into_iter().flatten() {
                let codes = noise.range / noise.step;
                assert!((2000.0..33_000.0).contains(&codes), "{}: {codes}", part.id);
            }
        }
    }

    #[test]
    fn all_named_parts_of_devices_are_simulated() {
        let catalog = Catalog::builtin();
        for device in catalog.devices() {
            let Some(imu) = device.imu.as_ref().filter(|imu| !imu.parts.is_empty()) else {
                continue;
            };
            let part = catalog.inertial_part_of(device).unwrap();
            assert!(imu.parts.contains(&part.id), "{}", device.id);
        }
        let oak4 = catalog.device("OAK4-D").unwrap();
        assert_eq!(catalog.inertial_part_of(oak4).unwrap().id, "LSM6DSV");
        assert_eq!(part_rate("BNO086"), Some(400.0));
        assert_eq!(part_rate("LSM6DSV"), None);
    }

    fn part_rate(id: &str) -> Option<f64> {
        Catalog::builtin().inertial_part(id).unwrap().max_rate_hz()
    }
}
