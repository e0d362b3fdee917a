use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use oaktwin::depth::parameters::Choice;

/// A parser of the names of any enumeration; case does not matter.
pub(crate) fn parser<C: Choice>() -> impl TypedValueParser<Value = C> {
    let values = C::NAMES
        .iter()
        .zip(C::ABOUT)
        .map(|(name, about)| PossibleValue::new(*name).help(about.trim().trim_end_matches('.')));
    PossibleValuesParser::new(values).try_map(|name| C::find(&name).ok_or("unknown name"))
}
