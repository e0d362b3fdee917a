//! Options that are one of a few named values.

use crate::ParameterError;

/// An enumeration whose variants have names in files and on command lines; the first is the default.
macro_rules! choice {
    ($(#[$about:meta])* $name:ident { $($(#[$what:meta])* $variant:ident = $text:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $(#[doc = concat!("`", $text, "`: ")] $(#[$what])* $variant,)+
        }

        impl $name {
            /// All, the default first.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Its name.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $text,)+
                }
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self::ALL[0]
            }
        }

        impl $crate::choice::Choice for $name {
            const CHOICES: &[Self] = Self::ALL;
            fn text(self) -> &'static str {
                self.name()
            }
        }
    };
}
pub(crate) use choice;

/// What `choice!` makes.
pub(crate) trait Choice: Copy + 'static {
    const CHOICES: &[Self];
    fn text(self) -> &'static str;
}

/// The value of an option by its name.
pub(crate) fn parse<C: Choice>(option: &str, value: &str) -> Result<C, ParameterError> {
    let found = C::CHOICES.iter().find(|choice| choice.text() == value);
    found.copied().ok_or_else(|| {
        let names: Vec<&str> = C::CHOICES.iter().map(|choice| choice.text()).collect();
        ParameterError::new(
            option,
            format!("'{value}' is none of its values"),
            format!("give one of {}", names.join(", ")),
        )
    })
}

/// A number by what it is written as.
pub(crate) fn number(option: &str, value: &str) -> Result<f64, ParameterError> {
    value.trim().parse().map_err(|_| {
        ParameterError::new(
            option,
            format!("'{value}' is no number"),
            "give a number, 0.25 for one",
        )
    })
}

/// The error for a name that is none of `names`, which are of `what`.
pub(crate) fn unknown(name: &str, what: &str, names: &[&str]) -> ParameterError {
    let near = oaktwin_diagnostic::nearest(name, names.iter().copied());
    let remedy = match near.first() {
        Some(near) => format!("did you mean {near}?"),
        None => format!("give one of {}", names.join(", ")),
    };
    ParameterError::new(name, format!("no such {what}"), remedy)
}
