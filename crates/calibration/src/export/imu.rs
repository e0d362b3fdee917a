use std::fmt::Write as _;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_catalog::InertialPart;

use super::CalibrationFiles;

/// The rate in Hz where no source states one.
const DEFAULT_RATE_HZ: f64 = 400.0;

/// Creates Kalibr's `imu.yaml` of a part: the root mean square of the densities of its axes, in SI units. A number that no source states
/// is a comment, with a warning, because Kalibr requires all of them to be positive.
#[must_use]
pub fn kalibr_imu(part: &InertialPart) -> CalibrationFiles {
    let mut export = CalibrationFiles::default();
    let (Some(accelerometer), Some(gyroscope)) = (part.accelerometer_noise(), part.gyroscope_noise()) else {
        return export;
    };
    let mut text = format!("# {} of {}\n", part.id, part.manufacturer);
    let numbers = [
        (
            "accelerometer_noise_density",
            "m/s^2/sqrt(Hz)",
            accelerometer.mean_density(),
        ),
        (
            "accelerometer_random_walk",
            "m/s^3/sqrt(Hz)",
            accelerometer.mean_random_walk(),
        ),
        (
            "gyroscope_noise_density",
            "rad/s/sqrt(Hz)",
            gyroscope.mean_density(),
        ),
        (
            "gyroscope_random_walk",
            "rad/s^2/sqrt(Hz)",
            gyroscope.mean_random_walk(),
        ),
    ];
    for (key, unit, value) in numbers {
        if value > 0.0 {
            // Writing to a string cannot fail.
            _ = writeln!(text, "{key}: {value:.4e}  # {unit}");
        } else {
            _ = writeln!(text, "# {key}: no source states it  # {unit}");
            export.findings.push(Finding::new(
                "imu-noise",
                Level::Warning,
                format!("imu.yaml: {key}"),
                format!(
                    "no source states it for the {}, and Kalibr requires a value",
                    part.id
                ),
                "add one from an Allan deviation of your unit",
            ));
        }
    }
    let rate_hz = part.max_rate_hz().unwrap_or(DEFAULT_RATE_HZ);
    _ = write!(text, "rostopic: /imu/data_raw\nupdate_rate: {rate_hz:.1}  # Hz\n");
    export.files.push(("imu.yaml".to_owned(), text));
    export
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::Catalog;

    fn of(id: &str) -> CalibrationFiles {
        kalibr_imu(Catalog::builtin().inertial_part(id).unwrap())
    }

    #[test]
    fn numbers_are_in_si_units() {
        let CalibrationFiles { files, findings } = of("BNO086");
        assert!(findings.is_empty());
        let [(name, text)] = &files[..] else {
            panic!("one file")
        };
        assert_eq!(name, "imu.yaml");
        let number = |key: &str| -> f64 {
            let line = text.lines().find(|line| line.starts_with(key)).unwrap();
            let word = line.split_whitespace().nth(1).unwrap();
            word.parse().unwrap()
        };
        // (m/s)/√h and °/√h of the three axes, converted here.
        let rms = |axes: [f64; 3]| (axes.map(|x| x * x).iter().sum::<f64>() / 3.0).sqrt();
        let expected = rms([0.06924, 0.07421, 0.08520]) / 60.0;
        assert!((number("accelerometer_noise_density") / expected - 1.0).abs() < 1e-3);
        let expected = (rms([0.46521, 0.58602, 0.39069]) / 60.0).to_radians();
        assert!((number("gyroscope_noise_density") / expected - 1.0).abs() < 1e-3);
        let expected = rms([4.613e-5, 1.0065e-4, 3.604e-5]);
        assert!((number("accelerometer_random_walk") / expected - 1.0).abs() < 1e-3);
        let expected = (rms([0.04919, 0.09815, 0.06098]) / 3600.0).to_radians();
        assert!((number("gyroscope_random_walk") / expected - 1.0).abs() < 1e-3);
        assert_eq!(number("update_rate"), 400.0);
    }

    #[test]
    fn gaps_are_reported() {
        let CalibrationFiles { files, findings } = of("BMI270");
        let places: Vec<&str> = findings.iter().map(|one| one.place.as_str()).collect();
        assert_eq!(
            places,
            [
                "imu.yaml: accelerometer_random_walk",
                "imu.yaml: gyroscope_random_walk"
            ]
        );
        assert!(
            files[0]
                .1
                .contains("\n# gyroscope_random_walk: no source states it")
        );
        assert!(of("AK09919").files.is_empty());
    }
}
