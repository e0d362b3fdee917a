//! Animations (glTF 2.0, section 3.11): transforms of nodes and weights of morph targets at a time.
//!
//! All animations of a file are shown together, as its exporters split one scene into an animation for each object; where two of them move the
//! same property, the first counts.

use std::collections::BTreeSet;

use oaktwin_camera::math::DVec3;

use super::accessor::Accessor;
use super::channel::{Change, Channel, Interpolation, Property};
use super::document::Document;
use super::placement::rotation;

/// Returns the first and the last keyframe of a file, s; `None` without animations.
pub(super) fn range(document: &Document) -> Option<(f64, f64)> {
    let times = document
        .channels
        .iter()
        .filter_map(|channel| times(document, channel).ok());
    let mut ends = times.filter_map(|times| Some((*times.first()?, *times.last()?)));
    let first = ends.next()?;
    Some(ends.fold(first, |all, own| (all.0.min(own.0), all.1.max(own.1))))
}

/// Returns what the animations of a file change at a time, s, by node, and why some of them are ignored.
pub(super) fn at(document: &Document, time_s: f64) -> (Vec<(usize, Change)>, Vec<String>) {
    let mut seen = BTreeSet::new();
    let (mut changes, mut faults) = (Vec::new(), Vec::new());
    for channel in &document.channels {
        if !seen.insert((channel.node, channel.property)) {
            continue;
        }
        match change(document, channel, time_s) {
            Ok(change) => changes.push((channel.node, change)),
            Err(why) => faults.push(format!("nodes[{}]: {why}", channel.node)),
        }
    }
    (changes, faults)
}

fn change(document: &Document, channel: &Channel, time_s: f64) -> Result<Change, String> {
    let numbers = |components| values(document, channel, time_s, components);
    let vector = |numbers: Vec<f64>| DVec3::new(numbers[0], numbers[1], numbers[2]);
    Ok(match channel.property {
        Property::Translation => Change::Translation(vector(numbers(3)?)),
        Property::Scale => Change::Scale(vector(numbers(3)?)),
        Property::Rotation => {
            let q = numbers(4)?;
            Change::Rotation(rotation([q[0], q[1], q[2], q[3]]))
        }
        Property::Weights => Change::Weights(numbers(0)?),
    })
}

/// The keyframes, which increase.
fn times(document: &Document, channel: &Channel) -> Result<Vec<f64>, String> {
    let input = Accessor::find(document, channel.input)?;
    if input.components() != 1 || input.count == 0 {
        return Err("its keyframes are not a list of numbers".into());
    }
    document.allow(input.count as u64)?;
    let times: Vec<f64> = (0..input.count)
        .map(|key| f64::from(input.floats::<1>(key)[0]))
        .collect();
    let is_sorted = times.is_sorted_by(|a, b| a < b);
    if !is_sorted || times.iter().any(|time| !time.is_finite()) {
        return Err("its keyframes do not increase".into());
    }
    Ok(times)
}

/// The numbers of a property at a time: so many, or of weights, as many as there are for each keyframe. Before the first keyframe and after the
/// last, their values hold.
fn values(
    document: &Document,
    channel: &Channel,
    time_s: f64,
    components: usize,
) -> Result<Vec<f64>, String> {
    let times = times(document, channel)?;
    let output = Accessor::find(document, channel.output)?;
    let parts = if channel.interpolation == Interpolation::CubicSpline {
        3
    } else {
        1
    };
    let (own, width) = match components {
        // Weights are a list of single numbers.
        0 => (1, output.count / (parts * times.len())),
        components => (components, 1),
    };
    if output.components() != own || width == 0 || output.count != parts * times.len() * width {
        return Err(format!(
            "its {} keyframes have {} values",
            times.len(),
            output.count
        ));
    }
    document.allow(4 * width as u64)?;
    // Part 1 of a spline is the value, 0 and 2 are its tangents.
    let read = |key: usize, part: usize| -> Vec<f64> {
        let first = (key * parts + part) * width;
        (first..first + width)
            .flat_map(|element| output.floats::<4>(element)[..own].to_vec())
            .map(f64::from)
            .collect()
    };
    let value = |key: usize| read(key, usize::from(parts == 3));
    let after = times.partition_point(|key| *key <= time_s);
    let (Some(before), true) = (after.checked_sub(1), after < times.len()) else {
        return Ok(value(after.saturating_sub(1)));
    };
    let interval_s = times[after] - times[before];
    let u = (time_s - times[before]) / interval_s;
    let (from, to) = (value(before), value(after));
    Ok(match channel.interpolation {
        Interpolation::Step => from,
        Interpolation::Linear if channel.property == Property::Rotation => {
            let quaternion = |q: &[f64]| rotation([q[0], q[1], q[2], q[3]]);
            quaternion(&from).slerp(quaternion(&to), u).to_array().to_vec()
        }
        Interpolation::Linear => mixed(&[(&from, 1.0 - u), (&to, u)]),
        Interpolation::CubicSpline => {
            let (out, into) = (read(before, 2), read(after, 0));
            let (u2, u3) = (u * u, u * u * u);
            mixed(&[
                (&from, 2.0 * u3 - 3.0 * u2 + 1.0),
                (&out, interval_s * (u3 - 2.0 * u2 + u)),
                (&to, 3.0 * u2 - 2.0 * u3),
                (&into, interval_s * (u3 - u2)),
            ])
        }
    })
}

/// The weighted sum of lists of one length.
fn mixed(parts: &[(&Vec<f64>, f64)]) -> Vec<f64> {
    let length = parts.iter().map(|(list, _)| list.len()).min().unwrap_or(0);
    (0..length)
        .map(|i| parts.iter().map(|(list, weight)| list[i] * weight).sum())
        .collect()
}
