//! What every crate of oaktwin shares: [findings and messages as values](diagnostic), and [parameters and
//! enumerations that are declared once](parameter).

pub mod diagnostic;
pub mod parameter;
