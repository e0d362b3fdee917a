//! A bounding volume hierarchy with up to eight children a node, over boxes of anything.

mod bins;
mod bounds;
mod build;
mod node;

pub(crate) use bounds::{Bounds, Item};
pub(crate) use build::build;
pub(crate) use node::Node;

/// The most items in a leaf: as many as are looked at at once.
pub(crate) const LEAF: usize = 8;

#[cfg(test)]
#[allow(clippy::cast_precision_loss, reason = "places are made up")]
mod tests;
