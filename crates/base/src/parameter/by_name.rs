//! Structs of parameters in JSON and TOML, as a table from names to values: `#[serde(with = "oaktwin_base::parameter::by_name")]`.
//! A parameter that is left out has its default on the first platform.

use std::collections::BTreeMap;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

use super::{Platform, Scalar, Table};

/// Writes all parameters.
///
/// # Errors
/// Returns the errors of the serializer.
pub fn serialize<P: Table, S: Serializer>(parameters: &P, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(P::rows().map(|row| (row.about.name, Scalar::of(&(row.get)(parameters)))))
}

/// Parameters that may be absent.
pub mod optional {
    use serde::{Deserializer, Serializer};

    use super::Table;

    /// Writes all parameters, if there are any.
    ///
    /// # Errors
    /// Returns the errors of the serializer.
    pub fn serialize<P: Table, S: Serializer>(
        parameters: &Option<P>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        match parameters {
            Some(parameters) => super::serialize(parameters, serializer),
            None => serializer.serialize_none(),
        }
    }

    /// Reads parameters, as [`super::deserialize`].
    ///
    /// # Errors
    /// Returns the errors of [`super::deserialize`].
    pub fn deserialize<'de, P: Table, D: Deserializer<'de>>(deserializer: D) -> Result<Option<P>, D::Error> {
        super::deserialize(deserializer).map(Some)
    }
}

/// Reads the given parameters; the others have their defaults.
///
/// # Errors
/// Returns an error that names the parameter for an unknown name, an invalid value or a contradiction.
pub fn deserialize<'de, P: Table, D: Deserializer<'de>>(deserializer: D) -> Result<P, D::Error> {
    let mut parameters = P::defaults(Platform::default());
    for (name, value) in BTreeMap::<String, Scalar>::deserialize(deserializer)? {
        parameters.set_by_name(&name, value).map_err(D::Error::custom)?;
    }
    parameters.check_relations().map_err(D::Error::custom)?;
    Ok(parameters)
}
