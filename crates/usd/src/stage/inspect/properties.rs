/// The maximum sum of the squared numbers of properties of prims with many: the library's parser compares each property
/// with those before it.
const MAX_COMPARISONS: usize = 30_000 * 30_000;
/// The number of properties from which a prim counts.
const MANY: usize = 1000;

/// Counts the properties of each prim in a text layer.
pub(super) struct Properties<'a> {
    text: &'a str,
    /// The open brackets; with the number of properties for the body of a prim or a variant.
    open: Vec<Option<usize>>,
    /// The offset after the last bracket or end of a statement.
    at: usize,
    /// The beginning of the current statement of the innermost prim.
    statement: Option<&'a str>,
    comparisons: usize,
}

impl<'a> Properties<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            // The layer itself.
            open: vec![Some(0)],
            at: 0,
            statement: None,
            comparisons: 0,
        }
    }

    /// Continues with a bracket or the end of a statement. Returns whether the properties so far are few enough.
    pub(super) fn fit(&mut self, offset: usize, byte: u8) -> bool {
        let before = self.text[self.at..offset].trim_ascii();
        self.at = offset + 1;
        let in_prim = matches!(self.open.last(), Some(Some(_)));
        if in_prim && self.statement.is_none() && !before.is_empty() {
            self.statement = Some(before);
        }
        match byte {
            b'{' => {
                let begins_prim = in_prim && self.statement.is_none_or(begins_prim);
                // Its name may be followed by metadata.
                let is_variant = before.is_empty() || before.ends_with(['"', '\'']);
                let in_variant_set = self.open.last() == Some(&None) && is_variant;
                if begins_prim {
                    self.statement = None;
                }
                self.open.push((begins_prim || in_variant_set).then_some(0));
            }
            b'(' | b'[' => self.open.push(None),
            b'}' | b')' | b']' => {
                self.end_statement();
                if self.open.len() > 1
                    && let Some(Some(count)) = self.open.pop()
                    && count > MANY
                {
                    self.comparisons = self.comparisons.saturating_add(count.saturating_mul(count));
                }
            }
            _ => self.end_statement(),
        }
        self.comparisons <= MAX_COMPARISONS
    }

    /// Counts the current statement if it is in a prim and not inside parentheses or a list.
    fn end_statement(&mut self) {
        if let Some(Some(count)) = self.open.last_mut()
            && let Some(statement) = self.statement.take()
        {
            *count += usize::from(!begins_prim(statement));
        }
    }
}

/// Whether a statement is the definition of a prim.
fn begins_prim(statement: &str) -> bool {
    let mut words = statement.split_ascii_whitespace();
    matches!(words.next(), Some("def" | "over" | "class"))
}

#[cfg(test)]
mod tests {
    use super::super::structure::Structure;
    use super::*;

    fn fit(text: &str) -> bool {
        let mut properties = Properties::new(text);
        Structure::new(text.as_bytes()).all(|(offset, byte)| properties.fit(offset, byte))
    }

    fn many(count: usize, statement: &str) -> String {
        statement.repeat(count)
    }

    #[test]
    fn limits_the_properties_of_a_prim_or_a_variant() {
        const COUNT: usize = 40_000;
        let declared = many(COUNT, "float a\n");
        let valued = many(COUNT, "float a.timeSamples = { 0: 1 } (doc = \"x\"); ");
        for properties in [declared, valued] {
            assert!(!fit(&format!("def \"W\"\n{{\n{properties}}}\n")));
            assert!(!fit(&format!(
                "def \"W\" (\n  kind = \"x\"\n)\n{{\n{properties}}}\n"
            )));
            let variant = format!("variantSet \"v\" = {{\n\"a\" (kind = \"x\") {{\n{properties}}}\n}}\n");
            assert!(!fit(&format!("def \"W\"\n{{\n{variant}}}\n")));
        }
    }

    #[test]
    fn does_not_limit_prims_samples_and_values() {
        const COUNT: usize = 40_000;
        let prims = many(COUNT, "def Xform \"a\" (\n kind = \"x\"\n)\n{\n float a = 1\n}\n");
        assert!(fit(&format!("def \"W\"\n{{\n{prims}}}\n")));
        assert!(fit(&prims));
        let samples = format!("float a.timeSamples = {{\n{}}}\n", many(COUNT, "0: 1,\n"));
        let array = format!("float[] b = [\n{}]\n", many(COUNT, "1,\n"));
        assert!(fit(&format!("def \"W\"\n{{\n{samples}{array}}}\n")));
        let few = many(500, "float a = 1\n");
        assert!(fit(&many(200, &format!("def \"W\"\n{{\n{few}}}\n"))));
    }
}
