use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use oaktwin::depth::parameters::Choice;

/// Returns a parser of the names of an enumeration.
pub(crate) fn parser<C: Choice>() -> impl TypedValueParser<Value = C> {
    let values = C::VARIANTS.iter().zip(C::NAMES).zip(C::ABOUT);
    let values = values.map(|((variant, name), about)| {
        let others = C::ALIASES.iter().filter(|(_, own)| own == variant);
        possible(name, about).aliases(others.map(|(alias, _)| *alias))
    });
    PossibleValuesParser::new(values).try_map(|name| C::find(&name).ok_or("unknown name"))
}

/// Returns a valid name with its description in the style of help texts.
pub(super) fn possible(name: &'static str, about: &str) -> PossibleValue {
    PossibleValue::new(name).help(about.trim().trim_end_matches('.').replace('`', ""))
}
