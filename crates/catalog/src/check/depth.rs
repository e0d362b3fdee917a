//! Checks of depth sensors and their accuracy.

use oaktwin_base::parameter::Table;
use oaktwin_base::parameter::nvidia::Attributes;

use super::values::{ascending, positive};
use super::{Checked, sources};
use crate::document::Document;
use crate::{Accuracy, DepthSensor, Device};

pub(super) fn depth_sensor(doc: &Document<'_>, at: &str, spec: &DepthSensor, device: &Device) -> Checked {
    let place = |key: &str| format!("{at}.{key}");
    if device.camera(spec.camera).is_none() {
        return Err(doc.error(
            &place("camera"),
            format!("the device has no camera with the role '{}'", spec.camera),
            "name the role of one of its cameras",
        ));
    }
    pair(doc, at, spec, device)?;
    positive(doc, &place("focus_distance"), spec.focus_distance)?;
    for (key, value) in [
        ("extended_max_disparity_px", spec.extended_max_disparity_px),
        ("extended_min_distance_m", spec.extended_min_distance_m),
    ] {
        if let Some(value) = value {
            positive(doc, &place(key), value)?;
        }
    }
    let attributes = spec.attributes(false);
    for row in Attributes::rows() {
        let numbers = (row.numbers)(&attributes);
        if let Some(value) = numbers.into_iter().find(|&number| !row.about.accepts(number)) {
            let what = format!("{value} is out of range");
            return Err(doc.error(&place(row.about.field), what, row.about.expectation()));
        }
    }
    positive(doc, &place("baseline_mm"), spec.baseline_mm)?;
    ascending(doc, &place("clipping_range_m"), spec.clipping_range_m)?;
    ascending(doc, &place("ideal_range_m"), spec.ideal_range_m)?;
    ascending(
        doc,
        &place("max_distance_m"),
        (spec.min_distance_m, spec.max_distance_m),
    )?;
    sources(doc, &place(""), &spec.sources)
}

/// A stereo sensor has two cameras side by side.
fn pair(doc: &Document<'_>, at: &str, spec: &DepthSensor, device: &Device) -> Checked {
    let Some((left, right)) = spec.pair() else {
        return match spec.right_camera {
            Some(role) => Err(doc.error(
                &format!("{at}.right_camera"),
                format!("a second camera '{role}' of a time-of-flight sensor"),
                "remove it",
            )),
            None => Ok(()),
        };
    };
    let y = |role| device.camera(role).map(|camera| camera.position_mm[1]);
    match (y(left), y(right)) {
        (Some(left_y), Some(right_y)) if left_y > right_y => Ok(()),
        (_, None) => Err(doc.error(
            &format!("{at}.right_camera"),
            format!("the device has no camera with the role '{right}'"),
            "name the right camera of the pair",
        )),
        _ => Err(doc.error(
            &format!("{at}.camera"),
            format!("the camera '{left}' is not to the left of '{right}'"),
            "name the left camera of the pair as 'camera', and the right one as 'right_camera'",
        )),
    }
}

pub(super) fn accuracy(doc: &Document<'_>, at: &str, table: &Accuracy) -> Checked {
    let mut nearest_from_m = 0.0;
    for (i, band) in table.bands.iter().enumerate() {
        let place = format!("{at}.bands.{i}");
        if !(band.from_m >= nearest_from_m && band.to_m > band.from_m) {
            return Err(doc.error(
                &place,
                format!("a band from {} m to {} m", band.from_m, band.to_m),
                "list the bands near to far, each from less to more",
            ));
        }
        nearest_from_m = band.from_m;
        for error in [band.error_percent, band.error_mm].into_iter().flatten() {
            positive(doc, &place, error)?;
        }
    }
    Ok(())
}
