//! The published accuracy of a depth sensor.

use serde::Serialize;

use oaktwin_catalog::{Accuracy, AccuracyBand, DepthSensor, Device, Source};

/// The published accuracy with which a sensor is compared.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bands {
    /// The source of the figures: the vendor's page if it states any, otherwise another source.
    pub source: Source,
    /// The quantity that is limited.
    pub measure: String,
    /// The bands in order of distance. Bands at the same distance differ in their condition.
    pub bands: Vec<Band>,
}

/// The maximum error in a range of distances.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Band {
    /// The start of the range.
    pub from_m: f64,
    /// The end of the range, exclusive except for the last band.
    pub to_m: f64,
    /// The upper limit of the error in percent of the distance.
    pub error_percent: f64,
    /// What adds to it at every distance, mm.
    #[serde(skip_serializing_if = "is_zero")]
    pub error_mm: f64,
    /// The condition, such as `indoors`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub condition: Option<String>,
}

impl Bands {
    /// Returns the bands of the vendor's page for a depth sensor, or the bands of the first other source that has any; `None` if
    /// there are none.
    #[must_use]
    pub fn of(device: &Device, sensor: &DepthSensor) -> Option<Self> {
        let applies = |table: &&Accuracy| {
            let own = table.depth_sensor.as_ref();
            table.sensor == sensor.kind && own.is_none_or(|prim| *prim == sensor.prim)
        };
        let about = || device.accuracy.iter().filter(applies);
        let table: &Accuracy = about()
            .find(|table| table.source == Source::VendorPage)
            .or_else(|| about().next())?;
        Some(Self {
            source: table.source,
            measure: table.measure.clone(),
            bands: table.bands.iter().filter_map(band).collect(),
        })
    }

    /// Returns the maximum distance of all bands in metres.
    #[must_use]
    pub fn end_m(&self) -> Option<f64> {
        self.bands.iter().map(|band| band.to_m).reduce(f64::max)
    }

    /// Returns the bands at a distance, the strictest first, with their whole limit there in percent.
    #[must_use]
    pub fn at(&self, distance_m: f64) -> Vec<Band> {
        let end = self.end_m();
        let mut found: Vec<Band> = self
            .bands
            .iter()
            .filter(|band| {
                let is_before_end =
                    distance_m < band.to_m || (distance_m <= band.to_m && end == Some(band.to_m));
                distance_m >= band.from_m && is_before_end
            })
            .map(|band| band.at(distance_m))
            .collect();
        found.sort_by(|a, b| a.error_percent.total_cmp(&b.error_percent));
        found
    }
}

/// The number of parts into which a range is split if its limit is not a constant percentage.
const STEPS: u32 = 50;

impl Band {
    /// Returns the band with its whole limit at a distance in percent.
    fn at(&self, distance_m: f64) -> Self {
        // 1 mm is 0.1 % of 1 m.
        let fixed = match self.error_mm > 0.0 {
            true => 0.1 * self.error_mm / distance_m,
            false => 0.0,
        };
        Self {
            error_percent: self.error_percent + fixed,
            error_mm: 0.0,
            ..self.clone()
        }
    }

    /// Returns the band as bands whose limits are percentages: itself, or narrow ones with the limits at their middles.
    #[must_use]
    pub fn steps(&self) -> Vec<Self> {
        if is_zero(&self.error_mm) {
            return vec![self.clone()];
        }
        let width = (self.to_m - self.from_m) / f64::from(STEPS);
        let step = |number: u32| {
            let from_m = self.from_m + width * f64::from(number);
            Self {
                from_m,
                to_m: from_m + width,
                ..self.at(from_m + 0.5 * width)
            }
        };
        (0..STEPS).map(step).collect()
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde requires")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

fn band(band: &AccuracyBand) -> Option<Band> {
    band.error_percent.or(band.error_mm)?;
    Some(Band {
        from_m: band.from_m,
        to_m: band.to_m,
        error_percent: band.error_percent.unwrap_or(0.0),
        error_mm: band.error_mm.unwrap_or(0.0),
        condition: band.condition.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::{Catalog, DepthKind};

    fn bands(model: &str, kind: DepthKind) -> Option<Bands> {
        let device = Catalog::builtin().device(model).unwrap();
        let sensor = device.depth_sensors.iter().find(|sensor| sensor.kind == kind);
        Bands::of(device, sensor.unwrap())
    }

    fn percents(bands: &Bands, distance_m: f64) -> Vec<f64> {
        bands
            .at(distance_m)
            .iter()
            .map(|band| band.error_percent)
            .collect()
    }

    #[test]
    fn prefers_the_vendors_page() {
        let pro = bands("oak-d-pro-poe", DepthKind::Stereo).unwrap();
        assert_eq!(pro.source, Source::VendorPage);
        assert_eq!(percents(&pro, 3.99), [2.0]);
        assert_eq!(percents(&pro, 4.0), [4.0]);
        assert_eq!(percents(&pro, 10.5), [6.0]);
        assert!(percents(&pro, 10.6).is_empty());
        let wide = bands("oak4-d-wide", DepthKind::Stereo).unwrap();
        assert_eq!((wide.source, wide.end_m()), (Source::Estimate, Some(9.0)));
    }

    #[test]
    fn each_condition_has_its_own_bands() {
        let tof = bands("oak-d-tof", DepthKind::Tof).unwrap();
        assert_eq!(percents(&tof, 5.0), [1.0, 2.0]);
        assert!(percents(&tof, 0.1).is_empty());
        assert_eq!(bands("oak-d-tof", DepthKind::Stereo), None);
    }

    #[test]
    fn a_limit_can_have_a_part_that_does_not_grow() {
        let kinect = bands("azure-kinect", DepthKind::Tof).unwrap();
        let limit = |distance_m: f64| percents(&kinect, distance_m)[0];
        // 11 mm + 0.1 % of the distance.
        assert!((limit(1.0) - 1.2).abs() < 1e-12 && (limit(2.0) - 0.65).abs() < 1e-12);
        assert!(percents(&kinect, 0.4).is_empty());
        let steps = kinect.bands[0].steps();
        assert_eq!((steps[0].from_m, steps.len()), (0.5, 50));
        assert!((steps[49].to_m - 3.86).abs() < 1e-9);
        for step in &steps {
            assert!(limit(step.from_m) > step.error_percent && step.error_percent > limit(step.to_m - 1e-9));
        }
        let pro = bands("oak-d-pro-poe", DepthKind::Stereo).unwrap();
        assert_eq!(pro.bands[0].steps(), [pro.bands[0].clone()]);
    }

    #[test]
    fn a_table_can_apply_to_one_of_several_pairs() {
        let device = Catalog::builtin().device("oak-d-lr").unwrap();
        let has: Vec<bool> = (device.depth_sensors.iter())
            .map(|sensor| Bands::of(device, sensor).is_some())
            .collect();
        assert_eq!(has, [true, false, false]);
    }
}
