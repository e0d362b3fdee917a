//! OpenUSD's text format: a document model and its text, laid out as OpenUSD itself writes it.
//!
//! The model holds what camera assets need and no more: definitions and overrides, applied schemas, dictionaries,
//! attributes, relationships, connections, references and sublayers. [`Layer::text`] sorts properties and metadata
//! as OpenUSD does and prints the shortest numbers that read back to the same bits, so that a file loaded and
//! exported by OpenUSD comes out as it went in.

mod emit;
mod layer;
mod number;
mod order;
mod quote;
mod value;

pub use layer::{Attribute, Layer, Prim, Property, Reference, Relationship, Specifier, UpAxis};
pub use order::is_identifier;
pub use value::{Dictionary, Value};
