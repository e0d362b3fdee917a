//! What every crate of oaktwin shares: [findings and messages as values](diagnostic), [parameters and enumerations that are declared
//! once](parameter), and [panics of other libraries as values](panics).

pub mod diagnostic;
pub mod panics;
pub mod parameter;
