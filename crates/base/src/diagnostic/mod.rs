//! Diagnostics shared by every crate: findings as values, messages that refer to options as data, and suggestions for
//! misspelt names.
//!
//! A library does not know whether a command line or Python calls it, so it never writes `--fx` or `fx=` into a text. It
//! puts an [`Opt`] into a [`Message`], and the front end prints the message [`with_style`], its own spelling of options.

mod finding;
mod group;
mod message;
pub mod stored;
mod suggest;

pub use crate::message;
pub use finding::{Finding, Level, add_new};
pub use group::{FindingGroup, group};
pub use message::{Message, Opt, OptionStyle, command, opt, with_style};
pub use suggest::{fold_name, nearest, suggest, suggestion};
