use oaktwin_base::diagnostic::{fold_name, suggest};
use oaktwin_base::parameter::choice;
use thiserror::Error;

use crate::{Catalog, DepthKind, Device};

choice! {
    /// The depth sensors of models.
    DepthFilter {
        /// A stereo pair.
        Stereo = "stereo",
        /// Time of flight.
        Tof = "tof",
        /// No depth sensor.
        None = "none",
    }
}

impl DepthFilter {
    fn accepts(self, device: &Device) -> bool {
        let has = |kind| device.depth_sensors.iter().any(|sensor| sensor.kind == kind);
        match self {
            Self::Stereo => has(DepthKind::Stereo),
            Self::Tof => has(DepthKind::Tof),
            Self::None => device.depth_sensors.is_empty(),
        }
    }
}

/// An unknown manufacturer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("unknown maker '{maker}'; {remedy}")]
pub struct UnknownMaker {
    /// The requested name.
    pub maker: String,
    /// The nearest names or all of them.
    pub remedy: String,
}

impl Catalog {
    /// Returns the names of the manufacturers.
    #[must_use]
    pub fn makers(&self) -> Vec<&str> {
        let mut makers: Vec<&str> = Vec::new();
        for device in self.devices() {
            if !makers.contains(&device.manufacturer.as_str()) {
                makers.push(&device.manufacturer);
            }
        }
        makers
    }

    /// Returns the devices of a manufacturer and with a kind of depth sensor, if given.
    ///
    /// # Errors
    /// Returns an error with the nearest names if no device is of this manufacturer.
    pub fn chosen(
        &self,
        maker: Option<&str>,
        depth: Option<DepthFilter>,
    ) -> Result<Vec<&Device>, UnknownMaker> {
        let wanted = maker.map(fold_name);
        let makers = self.makers();
        if let (Some(maker), Some(wanted)) = (maker, &wanted)
            && !makers.iter().any(|own| fold_name(own) == *wanted)
        {
            return Err(UnknownMaker {
                maker: maker.to_owned(),
                remedy: suggest(maker, makers),
            });
        }
        let is_wanted = |device: &&Device| {
            wanted
                .as_ref()
                .is_none_or(|maker| fold_name(&device.manufacturer) == *maker)
                && depth.is_none_or(|depth| depth.accepts(device))
        };
        Ok(self.devices().iter().filter(is_wanted).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_by_maker_and_depth() {
        let catalog = Catalog::builtin();
        let names = |maker, depth| -> Vec<&str> {
            let chosen = catalog.chosen(maker, depth).unwrap();
            chosen.iter().map(|device| device.name.as_str()).collect()
        };
        assert_eq!(names(None, None).len(), catalog.devices().len());
        assert_eq!(names(Some("stereo labs"), None), ["ZED 2i", "ZED Mini", "ZED X"]);
        assert_eq!(
            names(None, Some(DepthFilter::None)),
            [
                "OAK4-CS",
                "OAK4-S",
                "OAK-1",
                "OAK-1 Lite",
                "OAK-1 MAX",
                "OAK-1 W",
                "OAK Thermal"
            ]
        );
        assert_eq!(
            names(None, Some(DepthFilter::Tof)),
            ["OAK-D ToF", "Azure Kinect", "Femto Bolt"]
        );
        assert_eq!(names(Some("Orbbec"), Some(DepthFilter::Stereo)), ["Gemini 335"]);
        assert_eq!(
            catalog.chosen(Some("Luxsonis"), None).unwrap_err().to_string(),
            "unknown maker 'Luxsonis'; did you mean 'Luxonis'?"
        );
    }
}
