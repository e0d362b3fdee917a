//! Why pixels have no value.

use oaktwin::depth::{ReasonCodes, reason};
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotator, ReasonLabel};
use oaktwin::measure::ImageRegion;
use serde::Serialize;

use crate::station::Measurement;

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Reason {
    code: u8,
    /// Such as `too_near`.
    name: String,
    documentation: String,
}

/// Returns all reasons, sorted by their codes.
pub(crate) fn all() -> Vec<Reason> {
    let legend = reason::legend().into_iter();
    let reason = |(code, label): (u8, ReasonLabel)| Reason {
        code,
        name: label.name,
        documentation: label.documentation,
    };
    legend.map(reason).collect()
}

/// Returns the outcomes at points of a surface, sorted by their codes: the reasons of pixels, and others.
pub(crate) fn of_surfaces() -> Vec<Reason> {
    let outcomes = oaktwin::coverage::reasons().iter();
    let reason = |outcome: &oaktwin::coverage::OutcomeRow| Reason {
        code: outcome.code,
        name: outcome.name.clone(),
        documentation: outcome.doc.clone(),
    };
    outcomes.map(reason).collect()
}

/// Returns the codes of a measured image, which every engine provides.
pub(crate) fn codes(measurement: &Measurement) -> Option<&Image<u8>> {
    let codes: &ReasonCodes = measurement.capture.extra(Annotator::DepthSensorReason)?;
    Some(&codes.0)
}

/// Counts the pixels of each reason in a region, by code.
pub(crate) fn count(codes: &Image<u8>, region: &ImageRegion) -> Vec<u64> {
    let mut counts = vec![0; oaktwin::depth::Reason::CODES];
    let columns = region.columns.start as usize..region.columns.end as usize;
    let rows = codes.rows().skip(region.rows.start as usize);
    let rows = rows.take(region.rows.len());
    for code in rows.filter_map(|row| row.get(columns.clone())).flatten() {
        if let Some(count) = counts.get_mut(usize::from(*code)) {
            *count += 1;
        }
    }
    counts
}
