use std::borrow::Cow;

use serde::de::Error;
use serde::{Deserialize, Deserializer};

use crate::diagnostic::{fold_name, suggest};

use crate::parameter::ParameterError;

/// An enumeration whose variants have names that a user can write. [`choice!`](crate::choice!) implements it.
pub trait Choice: Copy + PartialEq + Send + Sync + 'static {
    /// All variants, in order.
    const VARIANTS: &'static [Self];
    /// The names of [`VARIANTS`](Self::VARIANTS), in the same order.
    const NAMES: &'static [&'static str];
    /// One line about each of [`VARIANTS`](Self::VARIANTS), in the same order.
    const ABOUT: &'static [&'static str];
    /// Other names that are accepted.
    const ALIASES: &'static [(&'static str, Self)] = &[];

    /// The name of the variant.
    #[must_use]
    fn text(self) -> &'static str {
        let found = Self::VARIANTS.iter().position(|variant| *variant == self);
        found.map_or("", |index| Self::NAMES[index])
    }

    /// The variant of this name; case, hyphens and underscores do not matter.
    #[must_use]
    fn find(name: &str) -> Option<Self> {
        let folded = fold_name(name);
        let names = Self::NAMES.iter().copied().zip(Self::VARIANTS.iter().copied());
        let mut names = names.chain(Self::ALIASES.iter().copied());
        let found = names.find(|(known, _)| fold_name(known) == folded);
        found.map(|(_, variant)| variant)
    }
}

/// The variant of this name as the value of `option`.
///
/// # Errors
/// Returns an error that suggests the nearest names if there is no such variant.
pub fn choose<C: Choice>(option: &str, name: &str) -> Result<C, ParameterError> {
    C::find(name).ok_or_else(|| {
        let remedy = suggest(name, C::NAMES.iter().copied());
        ParameterError::new(option, format!("invalid value '{name}'"), remedy)
    })
}

/// Reads the name of a variant; [`choice!`](crate::choice!) implements `Deserialize` by it.
///
/// # Errors
/// Returns an error that suggests the nearest names if there is no such variant.
pub fn deserialize_choice<'de, C: Choice, D: Deserializer<'de>>(deserializer: D) -> Result<C, D::Error> {
    let name = Cow::<'de, str>::deserialize(deserializer)?;
    choose("", &name)
        .map_err(|ParameterError { what, remedy, .. }| D::Error::custom(format_args!("{what}; {remedy}")))
}

/// Declares an enumeration whose variants have names; the first variant is the default. A name may be followed by others that
/// are also accepted: `Truncate = "truncate" | "floor"`.
///
/// ```
/// oaktwin_base::parameter::choice! {
///     /// The rounding of depth to whole millimetres.
///     Rounding {
///         /// To the nearest; halves up.
///         Nearest = "nearest",
///         /// Down.
///         Truncate = "truncate",
///     }
/// }
/// assert_eq!(Rounding::default().name(), "nearest");
/// assert_eq!(Rounding::from_name("TRUNCATE"), Some(Rounding::Truncate));
/// ```
#[macro_export]
macro_rules! choice {
    ($(#[$about:meta])* $name:ident { $($(#[doc = $doc:literal])+ $variant:ident = $text:literal $(| $alias:literal)*,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $(#[doc = concat!("`", $text, "`:")] $(#[doc = $doc])+ $variant,)+
        }

        impl $name {
            /// All variants, the default first.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// The name that a user writes.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $text,)+
                }
            }

            /// The variant of this name; case, hyphens and underscores do not matter.
            #[must_use]
            pub fn from_name(name: &str) -> Option<Self> {
                <Self as $crate::parameter::Choice>::find(name)
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self::ALL[0]
            }
        }

        impl ::std::fmt::Display for $name {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                f.pad(self.name())
            }
        }

        impl $crate::parameter::Choice for $name {
            const VARIANTS: &'static [Self] = Self::ALL;
            const NAMES: &'static [&'static str] = &[$($text),+];
            const ABOUT: &'static [&'static str] = &[$(concat!($($doc),+)),+];
            const ALIASES: &'static [(&'static str, Self)] = &[$($(($alias, Self::$variant),)*)+];
        }

        impl $crate::parameter::serde::Serialize for $name {
            fn serialize<S: $crate::parameter::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::std::result::Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }

        impl<'de> $crate::parameter::serde::Deserialize<'de> for $name {
            fn deserialize<D: $crate::parameter::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::std::result::Result<Self, D::Error> {
                $crate::parameter::deserialize_choice(deserializer)
            }
        }
    };
}
