use serde_json::Value;

use super::Recipe;

/// Returns the JSON schema of a recipe.
#[must_use]
pub fn schema() -> Value {
    let mut schema: Value = schemars::schema_for!(Recipe).into();
    schema["title"] = "A recipe of oaktwin generate".into();
    schema
}
