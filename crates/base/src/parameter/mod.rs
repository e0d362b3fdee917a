//! Parameters and enumerations that are declared once.
//!
//! [`parameters!`] declares a struct of parameters: each has a name, a type, a unit, a range, a default, a line of
//! documentation and the source of its default. From this one declaration come the struct, its defaults, parsing, the check
//! of ranges, access by name and the [`Listing`] that help texts, schemas and manual pages are made of. [`choice!`] does
//! the same for an enumeration.

mod about;
pub mod by_name;
mod choice;
mod declare;
mod error;
mod group;
pub mod nvidia;
mod platform;
mod scalar;
mod table;
mod value;

pub use crate::{choice, parameters};
pub use about::{About, DefaultSource, Kind};
pub use choice::{Choice, choose, deserialize_choice};
pub use error::ParameterError;
pub use group::{COMMON, Group, Listing};
pub use platform::Platform;
pub use scalar::Scalar;
#[doc(hidden)]
pub use serde;
pub use table::{ParameterRow, Table, settings};
pub use value::{FieldText, Hexadecimal, Numbered, Plain, Value};
