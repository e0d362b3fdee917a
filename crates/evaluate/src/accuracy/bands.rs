//! The vendor's accuracy at a distance.

use serde::Serialize;

use oaktwin_catalog::{Accuracy, AccuracyBand, DepthKind, Device, Source};

/// The published accuracy that a sensor is held against.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bands {
    /// Where the figures come from: the vendor's page, or else what there is.
    pub source: Source,
    /// What they are of.
    pub measure: String,
    /// Near to far; of several at one distance, each with its condition.
    pub bands: Vec<Band>,
}

/// The error that is allowed in a range of distances.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Band {
    /// From here.
    pub from_m: f64,
    /// To before here; the farthest band includes its end.
    pub to_m: f64,
    /// The error stays below this.
    pub error_percent: f64,
    /// `indoors`, say.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub condition: Option<String>,
}

impl Bands {
    /// The vendor's page on this kind of sensor; where it says nothing, the first of what other sources say. `None` where
    /// nobody says anything.
    #[must_use]
    pub fn of(device: &Device, kind: DepthKind) -> Option<Self> {
        let about = || device.accuracy.iter().filter(|table| table.sensor == kind);
        let table: &Accuracy = about()
            .find(|table| table.source == Source::VendorPage)
            .or_else(|| about().next())?;
        Some(Self {
            source: table.source,
            measure: table.measure.clone(),
            bands: table.bands.iter().filter_map(band).collect(),
        })
    }

    /// The farthest distance that has a band, m.
    #[must_use]
    pub fn end_m(&self) -> Option<f64> {
        self.bands.iter().map(|band| band.to_m).reduce(f64::max)
    }

    /// The bands at a distance, the strictest first.
    #[must_use]
    pub fn at(&self, distance_m: f64) -> Vec<&Band> {
        let end = self.end_m();
        let mut found: Vec<&Band> = self
            .bands
            .iter()
            .filter(|band| {
                let is_before_end =
                    distance_m < band.to_m || (distance_m <= band.to_m && end == Some(band.to_m));
                distance_m >= band.from_m && is_before_end
            })
            .collect();
        found.sort_by(|a, b| a.error_percent.total_cmp(&b.error_percent));
        found
    }
}

fn band(band: &AccuracyBand) -> Option<Band> {
    Some(Band {
        from_m: band.from_m,
        to_m: band.to_m,
        error_percent: band.error_percent?,
        condition: band.condition.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::Catalog;

    fn bands(model: &str, kind: DepthKind) -> Option<Bands> {
        Bands::of(Catalog::builtin().device(model).unwrap(), kind)
    }

    fn percents(bands: &Bands, distance_m: f64) -> Vec<f64> {
        bands
            .at(distance_m)
            .iter()
            .map(|band| band.error_percent)
            .collect()
    }

    #[test]
    fn the_vendors_page_comes_first() {
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
    fn conditions_are_bands_of_their_own() {
        let tof = bands("oak-d-tof", DepthKind::Tof).unwrap();
        assert_eq!(percents(&tof, 5.0), [1.0, 2.0]);
        assert!(percents(&tof, 0.1).is_empty());
        assert_eq!(bands("oak-d-tof", DepthKind::Stereo), None);
    }
}
