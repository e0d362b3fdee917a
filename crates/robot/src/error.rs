use oaktwin_base::diagnostic::{message, opt};

/// The reason why a description cannot be written.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RobotError {
    /// A name that formats would not accept.
    #[error("{}: '{name}' {problem}", message![opt(option)])]
    Name {
        /// The option.
        option: &'static str,
        /// The name.
        name: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// A number of a pose that is not finite.
    #[error("{}: must be finite (got {value})", message![opt(name)])]
    NotFinite {
        /// The option.
        name: &'static str,
        /// The number.
        value: f64,
    },
}
