//! What animations move, as files store it.

use oaktwin_camera::math::{DQuat, DVec3};
use serde_json::{Map, Value, json};

use super::json::objects;

/// What an animation moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Property {
    Translation,
    Rotation,
    Scale,
    Weights,
}

/// How values between keyframes are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Interpolation {
    Step,
    Linear,
    CubicSpline,
}

/// A property of a node over time, with its accessors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Channel {
    pub(super) node: usize,
    pub(super) property: Property,
    pub(super) interpolation: Interpolation,
    pub(super) input: usize,
    pub(super) output: usize,
}

/// A value of a node's property.
pub(super) enum Change {
    Translation(DVec3),
    Rotation(DQuat),
    Scale(DVec3),
    Weights(Vec<f64>),
}

impl Channel {
    /// Takes the animations out of the JSON, because only this module checks them. Channels of properties that extensions define are left
    /// out.
    pub(super) fn take_all(root: &mut Value) -> Vec<Self> {
        let take = |animation: &mut Map<String, Value>| {
            let list = |name: &str| {
                animation
                    .get(name)
                    .and_then(Value::as_array)
                    .map_or(&[][..], |all| all)
            };
            let channels: Vec<Self> = (list("channels").iter())
                .filter_map(|channel| Self::of(channel, list("samplers")))
                .collect();
            *animation = Map::from_iter([("channels".into(), json!([])), ("samplers".into(), json!([]))]);
            channels
        };
        objects(root, "animations").flat_map(take).collect()
    }

    fn of(channel: &Value, samplers: &[Value]) -> Option<Self> {
        let index = |value: &Value, name: &str| {
            let index = value.get(name)?.as_u64()?;
            usize::try_from(index).ok()
        };
        let target = channel.get("target")?;
        let sampler = samplers.get(index(channel, "sampler")?)?;
        Some(Self {
            node: index(target, "node")?,
            property: match target.get("path")?.as_str()? {
                "translation" => Property::Translation,
                "rotation" => Property::Rotation,
                "scale" => Property::Scale,
                "weights" => Property::Weights,
                _ => return None,
            },
            interpolation: match sampler.get("interpolation").and_then(Value::as_str) {
                Some("STEP") => Interpolation::Step,
                Some("CUBICSPLINE") => Interpolation::CubicSpline,
                _ => Interpolation::Linear,
            },
            input: index(sampler, "input")?,
            output: index(sampler, "output")?,
        })
    }
}
