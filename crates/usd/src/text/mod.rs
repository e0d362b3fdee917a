//! OpenUSD's text format: a document model and an emitter that lays out text as OpenUSD does.
//!
//! The model covers what camera assets need: definitions and overrides, applied schemas, dictionaries, attributes,
//! relationships, connections, references and sublayers. [`Layer::text`] sorts properties and metadata as OpenUSD does
//! and prints the shortest numbers that parse back to the same bits, so that loading a file and exporting it with
//! OpenUSD reproduces it.

mod emit;
mod layer;
mod number;
mod order;
mod quote;
mod value;

pub use layer::{AttributeSpec, Layer, PrimSpec, Property, Reference, Relationship, Specifier, UpAxis};
pub use order::is_identifier;
pub use value::{Dictionary, SpecValue};
