//! Replaces the optics of a twin by a measured unit's.

use std::ops::RangeInclusive;

use super::AccuracyError;
use oaktwin_camera::{ImageSize, Intrinsics, PixelPoint, Usd};
use oaktwin_catalog::{Twin, TwinDepthSensor};

/// The focal lengths of any camera, px.
const FOCAL_LENGTHS_PX: RangeInclusive<f64> = 1.0..=1e6;
/// The maximum image width in pixels.
const MAX_WIDTH_PX: u32 = 16_384;

/// The optics with which a unit was measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeasuredOptics {
    /// The focal length at [`MeasuredOptics::width_px`], px.
    pub focal_length_px: Option<f64>,
    /// The width of the mode's images, px: 1280 at 800P, 640 at 480P and 400P.
    pub width_px: Option<u32>,
}

impl MeasuredOptics {
    /// Applies the optics to the cameras of a depth sensor and to the sensor. The principal point keeps its relative position and
    /// the image its aspect ratio; a width alone scales the focal length.
    ///
    /// # Errors
    /// Returns an error if the focal length or the width is out of range.
    pub fn apply(&self, twin: &mut Twin, sensor: &TwinDepthSensor) -> Result<TwinDepthSensor, AccuracyError> {
        let mut sensor = sensor.clone();
        if *self == Self::default() {
            return Ok(sensor);
        }
        let wrong = |option: &str, value: &dyn std::fmt::Display| {
            Err(AccuracyError::Optics {
                option: option.to_owned(),
                value: value.to_string(),
            })
        };
        match (self.focal_length_px, self.width_px) {
            (Some(f), _) if !FOCAL_LENGTHS_PX.contains(&f) => return wrong("focal length", &f),
            (_, Some(width)) if !(16..=MAX_WIDTH_PX).contains(&width) => return wrong("width", &width),
            _ => {}
        }
        let Some(own) = twin.depth_camera(&sensor).map(|camera| camera.intrinsics) else {
            return Ok(sensor);
        };
        let changed = self.changed(own);
        for camera in &mut twin.cameras {
            if camera.intrinsics.size == own.size {
                camera.intrinsics = self.changed(camera.intrinsics);
            }
        }
        sensor.focal_length_px = changed.fx;
        sensor.spec.sensor_size_px = f64::from(changed.size.width);
        Ok(sensor)
    }

    fn changed(&self, own: Intrinsics) -> Intrinsics {
        let width = self.width_px.unwrap_or(own.size.width);
        let size = own.size.scaled_to_width(width).unwrap_or(own.size);
        let size = ImageSize::new(size.width, size.height.max(1));
        let scale = f64::from(size.width) / f64::from(own.size.width);
        let fx = self.focal_length_px.unwrap_or(own.fx * scale);
        let centre = own.principal_point::<Usd>();
        let down = f64::from(size.height) / f64::from(own.size.height);
        let centre = PixelPoint::<Usd>::new(centre.x * scale, centre.y * down);
        Intrinsics::new(size, fx, own.fy / own.fx * fx, centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::{Catalog, Role};
    use oaktwin_pipeline::sensor::stereo_noise_parameters;

    #[test]
    fn applies_the_optics_of_a_unit() {
        let catalog = Catalog::builtin();
        let mut twin = catalog.nominal(catalog.device("oak-d-pro-poe").unwrap());
        let sensor = twin.depth_sensors[0].clone();
        let optics = MeasuredOptics {
            focal_length_px: Some(454.0),
            width_px: Some(640),
        };
        let sensor = optics.apply(&mut twin, &sensor).unwrap();
        assert_eq!(
            (sensor.focal_length_px, sensor.spec.sensor_size_px),
            (454.0, 640.0)
        );
        let left = twin.camera(Role::Left).unwrap().intrinsics;
        assert_eq!(
            (left.size, left.fx, left.fy),
            (ImageSize::new(640, 400), 454.0, 454.0)
        );
        assert_eq!(left.principal_point::<Usd>(), PixelPoint::new(320.0, 200.0));
        let noise = stereo_noise_parameters(&twin).unwrap();
        assert_eq!((noise.stereo.focal_length_px, noise.width_px), (454.0, 640));
        // A width alone keeps the lens.
        let optics = MeasuredOptics {
            focal_length_px: None,
            width_px: Some(1280),
        };
        optics.apply(&mut twin, &sensor).unwrap();
        assert_eq!(twin.camera(Role::Left).unwrap().intrinsics.fx, 908.0);
    }

    #[test]
    fn rejects_impossible_optics() {
        let catalog = Catalog::builtin();
        let mut twin = catalog.nominal(catalog.device("oak4-d").unwrap());
        let sensor = twin.depth_sensors[0].clone();
        for (focal_length_px, width_px) in [
            (Some(0.0), None),
            (Some(f64::NAN), None),
            (Some(-3.0), Some(640)),
            (Some(1e300), Some(640)),
            (Some(f64::INFINITY), None),
            (None, Some(0)),
            (None, Some(u32::MAX)),
        ] {
            let optics = MeasuredOptics {
                focal_length_px,
                width_px,
            };
            assert!(optics.apply(&mut twin, &sensor).is_err());
        }
    }
}
