//! What every crate of oaktwin shares: [findings and messages as values](diagnostic), [parameters and enumerations that are declared
//! once](parameter), [panics of other libraries as values](panics), and [work that nobody wants any more](interrupt).

pub mod diagnostic;
pub mod interrupt;
pub mod panics;
pub mod parameter;
