//! Why pixels have no value.

use oaktwin::depth::{ReasonCodes, reason};
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotator, ReasonLabel};
use oaktwin::measure::Region;
use serde::Serialize;

use crate::station::Measurement;

#[derive(Debug, Serialize)]
pub(crate) struct Reason {
    code: u8,
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

/// Returns the codes of a measured image, which every engine provides.
pub(crate) fn codes(measurement: &Measurement) -> Option<&Image<u8>> {
    let codes: &ReasonCodes = measurement.capture.extra(Annotator::DepthSensorReason)?;
    Some(&codes.0)
}

/// Counts the pixels of each reason in a region, in the order of [`all`].
pub(crate) fn count(codes: &Image<u8>, region: &Region) -> Vec<u64> {
    let mut counts = [0u64; 256];
    let columns = region.columns.start as usize..region.columns.end as usize;
    let rows = codes
        .rows()
        .skip(region.rows.start as usize)
        .take(region.rows.len());
    for code in rows.filter_map(|row| row.get(columns.clone())).flatten() {
        counts[usize::from(*code)] += 1;
    }
    reason::legend()
        .keys()
        .map(|code| counts[usize::from(*code)])
        .collect()
}
