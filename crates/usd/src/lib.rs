//! .
pub mod body;
