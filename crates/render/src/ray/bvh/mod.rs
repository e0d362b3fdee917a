//! A bounding volume hierarchy with up to eight children per node, over arbitrary boxes.

mod bins;
mod bounds;
mod build;
mod node;

pub(crate) use bounds::{Bounds, Item};
pub(crate) use build::build;
pub(crate) use node::Node;

/// The maximum number of items in a leaf, which are tested at once.
pub(crate) const LEAF: usize = 8;

#[cfg(test)]
#[allow(clippy::cast_precision_loss, reason = "test coordinates")]
mod tests;
