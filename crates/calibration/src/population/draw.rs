use crate::{Raw, calibration_of};
use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{
    Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint, RigidTransform,
};
use oaktwin_catalog::{Origin, Role, Twin, TwinCamera};
use oaktwin_depth::random::{NoiseStage, Numbers, Stream};

use crate::population::{Basis, Spread};

/// Numbers are cut at this many standard deviations.
const LIMIT: f64 = 3.0;

/// The units of a model.
#[derive(Clone, Debug)]
pub struct Population {
    nominal: Twin,
    spread: Spread,
    basis: Basis,
    random: Stream,
}

/// One unit of a [`Population`].
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// Its number.
    pub number: u64,
    /// The twin. Unlike the twin of a calibration file, its body frame is the housing's: the pair's viewing direction differs
    /// from it by the unit's boresight error.
    pub twin: Twin,
}

impl Population {
    /// Creates the population of a model from its nominal twin.
    #[must_use]
    pub fn new(nominal: &Twin, seed: u64) -> Self {
        let (spread, basis) = Spread::of(nominal);
        Self {
            random: Stream::new(seed, &nominal.device.name),
            nominal: nominal.clone(),
            spread,
            basis,
        }
    }

    /// The nominal twin of the model.
    #[must_use]
    pub const fn nominal(&self) -> &Twin {
        &self.nominal
    }

    /// The spread, and whether it was measured on the model's family.
    #[must_use]
    pub fn spread(&self) -> (&Spread, Basis) {
        (&self.spread, self.basis)
    }

    /// Returns a note about the origin of the spread.
    #[must_use]
    pub fn finding(&self) -> Finding {
        let Spread {
            about, units, models, ..
        } = &self.spread;
        let device = &self.nominal.device.name;
        let message = match self.basis {
            Basis::Measured => {
                format!("units vary like {units} factory calibrations of {models} models ({about})")
            }
            Basis::Estimate => {
                format!("the spread is an estimate from {units} factory calibrations of {about}")
            }
        };
        Finding::new("spread", Level::Note, device, message, "")
    }

    /// Returns the calibration of a unit, whose design is the nominal twin's.
    #[must_use]
    pub fn calibration(&self, unit: &Unit) -> Raw {
        calibration_of(&unit.twin, &self.nominal)
    }

    /// Draws a unit.
    #[must_use]
    pub fn unit(&self, number: u64) -> Unit {
        let mut twin = self.nominal.clone();
        let mut numbers = Numbers::new(self.random.plane(NoiseStage::Population, number, 0));
        let pair = numbers.normal_within(LIMIT) * self.spread.focal_length_pair;
        for camera in &mut twin.cameras {
            self.vary(camera, pair, &mut numbers);
        }
        twin.design_baselines_m = self.nominal.baselines_m();
        twin.origin = Origin::Calibration {
            product_name: twin.device.name.clone(),
            file_name: format!("unit {number}"),
        };
        let focal_lengths: Vec<Option<f64>> = (twin.depth_sensors.iter())
            .map(|depth| Some(twin.depth_camera(depth)?.intrinsics.fx.round()))
            .collect();
        for (depth, focal_length) in twin.depth_sensors.iter_mut().zip(focal_lengths) {
            depth.focal_length_px = focal_length.unwrap_or(depth.focal_length_px);
        }
        Unit { number, twin }
    }

    /// Moves a camera away from its nominal values. Each camera takes the same count of numbers.
    fn vary(&self, camera: &mut TwinCamera, pair: f64, numbers: &mut Numbers) {
        let spread = &self.spread;
        let mut normal = || numbers.normal_within(LIMIT);
        let own = normal();
        let focal_length = match camera.spec.role {
            Role::Left | Role::Right => pair + own * spread.focal_length,
            Role::Rgb | Role::Tof => own * spread.focal_length_color,
        };
        let old = camera.intrinsics;
        let centre = old.principal_point::<OpenCv>();
        let width = f64::from(old.size.width);
        let [right, down] = spread.principal_point.map(|share| share * normal() * width);
        camera.intrinsics = Intrinsics::new(
            old.size,
            old.fx * (1.0 + focal_length),
            old.fy * (1.0 + focal_length),
            PixelPoint::<OpenCv>::new(centre.x + right, centre.y + down),
        );
        camera.lens = distorted(
            camera.lens,
            spread.k1 * normal(),
            [spread.p * normal(), spread.p * normal()],
        );
        let rotation = DVec3::from(spread.rotation_mrad.map(|angle| angle * 1e-3 * normal()));
        let position = DVec3::from(spread.position_mm.map(|length| length * 1e-3 * normal()));
        let turned = match rotation.try_normalize() {
            Some(axis) => DMat3::from_axis_angle(axis, rotation.length()),
            None => DMat3::IDENTITY,
        };
        camera.body_from_camera = camera.body_from_camera * RigidTransform::new(turned, position);
    }
}

/// Returns a lens with additional distortion.
fn distorted(lens: LensModel, k1: f64, [p1, p2]: [f64; 2]) -> LensModel {
    match lens {
        LensModel::Pinhole => distorted(
            LensModel::OpenCvPinhole(OpenCvPinhole::new([0.0; 14])),
            k1,
            [p1, p2],
        ),
        LensModel::OpenCvPinhole(lens) => {
            let mut coefficients = *lens.coefficients();
            for (coefficient, more) in coefficients.iter_mut().zip([k1, 0.0, p1, p2]) {
                *coefficient += more;
            }
            LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients))
        }
        LensModel::OpenCvFisheye(OpenCvFisheye { mut k }) => {
            k[0] += k1;
            LensModel::OpenCvFisheye(OpenCvFisheye { k })
        }
        // No catalog has another lens.
        LensModel::FTheta(_) => lens,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::population::Statistics;
    use crate::{Calibration, check_against, twin};
    use oaktwin_catalog::Catalog;

    fn nominal(model: &str) -> Twin {
        let catalog = Catalog::builtin();
        catalog.nominal(catalog.device(model).unwrap())
    }

    #[test]
    fn a_unit_depends_on_its_number_and_the_seed_only() {
        let twin = nominal("OAK-D Pro PoE");
        let population = Population::new(&twin, 3);
        let unit = population.unit(7);
        assert_eq!(unit, population.unit(7));
        assert_ne!(unit.twin.cameras, population.unit(8).twin.cameras);
        assert_ne!(unit.twin.cameras, Population::new(&twin, 4).unit(7).twin.cameras);
    }

    #[test]
    fn many_units_have_the_spread() {
        let twin = nominal("OAK-D Pro PoE");
        let population = Population::new(&twin, 0);
        let (spread, basis) = population.spread();
        assert_eq!(basis, Basis::Measured);
        let units: Vec<Unit> = (0..2000).map(|number| population.unit(number)).collect();
        let of = |value: &dyn Fn(&Twin) -> f64| {
            let all: Vec<f64> = units.iter().map(|unit| value(&unit.twin)).collect();
            let Statistics { mean, deviation, .. } = Statistics::of(&all).unwrap();
            (mean, deviation)
        };
        let left = |twin: &Twin| twin.camera(Role::Left).unwrap().clone();
        let right = |twin: &Twin| twin.camera(Role::Right).unwrap().clone();
        let own = left(&twin);
        // Cutting at 3 standard deviations leaves 98.7 %; the rest is chance.
        let near = |(mean, deviation): (f64, f64), expected: (f64, f64), what: &str| {
            assert!(
                (deviation / expected.1 - 0.987).abs() < 0.06,
                "{what}: {deviation}"
            );
            assert!((mean - expected.0).abs() < 0.1 * expected.1, "{what}: {mean}");
        };
        let focal = spread.focal_length_pair.hypot(spread.focal_length);
        near(
            of(&|twin| left(twin).intrinsics.fx / own.intrinsics.fx),
            (1.0, focal),
            "f",
        );
        let between = spread.focal_length * 2f64.sqrt();
        near(
            of(&|twin| left(twin).intrinsics.fx / right(twin).intrinsics.fx),
            (1.0, between),
            "f of the pair",
        );
        near(
            of(&|twin| left(twin).intrinsics.principal_point::<OpenCv>().x),
            (639.5, spread.principal_point[0] * 1280.0),
            "cx",
        );
        // The optical axes of the pair in the plane of the baseline.
        let yaw = |twin: &Twin| {
            let right_from_left = right(twin).body_from_camera.inverse() * left(twin).body_from_camera;
            right_from_left.rotation.z_axis.x * 1e3
        };
        near(of(&yaw), (0.0, spread.rotation_mrad[1] * 2f64.sqrt()), "yaw");
        let baseline = |twin: &Twin| 1e3 * twin.baseline_m((Role::Left, Role::Right)).unwrap();
        near(
            of(&baseline),
            (75.0, spread.position_mm[0] * 2f64.sqrt()),
            "baseline",
        );
    }

    #[test]
    fn calibrations_fit_their_model_and_give_the_same_cameras() {
        let catalog = Catalog::builtin();
        for device in catalog.devices() {
            let nominal = catalog.nominal(device);
            let population = Population::new(&nominal, 1);
            for number in 0..3 {
                let unit = population.unit(number);
                let text = population.calibration(&unit).to_text();
                let raw = Raw::parse(text.as_bytes(), "unit.json").unwrap();
                let (calibration, findings) = Calibration::from_raw(&raw).unwrap();
                let findings: Vec<_> = (findings.into_iter())
                    .chain(check_against(&calibration, &nominal, catalog))
                    .filter(|finding| finding.level == Level::Error)
                    .collect();
                assert!(findings.is_empty(), "{}: {findings:?}", device.name);
                let (again, _) = twin(&calibration, &nominal, "unit.json").unwrap();
                let from_left = |twin: &Twin, camera: &TwinCamera| {
                    let root = twin.camera(Role::Left).unwrap_or(&twin.cameras[0]);
                    root.body_from_camera.inverse() * camera.body_from_camera
                };
                let has_pair = nominal.camera(Role::Left).is_some();
                for (own, other) in unit.twin.cameras.iter().zip(&again.cameras) {
                    assert!((own.intrinsics.fx / other.intrinsics.fx - 1.0).abs() < 1e-9);
                    assert_eq!(own.lens, other.lens);
                    let [a, b] = [from_left(&unit.twin, own), from_left(&again, other)];
                    assert!(
                        !has_pair || (a.translation - b.translation).length() < 1e-9,
                        "{}",
                        device.name
                    );
                }
            }
        }
    }
}
