use std::ffi::OsStr;
use std::marker::PhantomData;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Command, Error};
use oaktwin::depth::parameters::Choice;

/// Returns a parser of the names of an enumeration, in any case.
pub(crate) fn parser<C: Choice>() -> impl TypedValueParser<Value = C> {
    let values = C::VARIANTS.iter().zip(C::NAMES).zip(C::ABOUT);
    let values = values.map(|((variant, name), about)| {
        let others = C::ALIASES.iter().filter(|(_, own)| own == variant);
        possible(name, about).aliases(others.map(|(alias, _)| *alias))
    });
    ChoiceParser {
        names: PossibleValuesParser::new(values),
        of: PhantomData::<C>,
    }
}

#[derive(Clone)]
struct ChoiceParser<C> {
    names: PossibleValuesParser,
    of: PhantomData<C>,
}

impl<C: Choice> TypedValueParser for ChoiceParser<C> {
    type Value = C;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<C, Error> {
        if let Some(found) = value.to_str().and_then(C::find) {
            return Ok(found);
        }
        // Its error lists the names and suggests the nearest one.
        self.names.parse_ref(command, arg, value)?;
        Err(Error::new(ErrorKind::InvalidValue).with_cmd(command))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        self.names.possible_values()
    }
}

/// Returns a valid name with its description in the style of help texts.
pub(super) fn possible(name: &'static str, about: &str) -> PossibleValue {
    PossibleValue::new(name).help(about.trim().trim_end_matches('.').replace('`', ""))
}
