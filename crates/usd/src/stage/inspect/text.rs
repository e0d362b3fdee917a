use std::io::Cursor;

use openusd::usdc::CrateWriter;

use super::super::usda;
use super::outline::{self, Outline};
use super::{Problem, USE_ANOTHER_COPY, unreadable};

/// Reads a text layer and writes it in the binary format, because the USD library reads fewer texts than OpenUSD, and
/// more slowly.
pub(super) fn to_binary(bytes: Vec<u8>) -> Result<(Vec<u8>, Outline), Problem> {
    let parsed = usda::parse(encoding(&bytes)?)?;
    drop(bytes);
    let outline = outline::outline(&parsed.data, parsed.prims)?;
    let mut binary = Cursor::new(Vec::new());
    CrateWriter::write(&parsed.data, &mut binary).map_err(|error| unreadable(&error))?;
    Ok((binary.into_inner(), outline))
}

/// Validates the encoding of a text layer: UTF-8 without zero bytes.
fn encoding(bytes: &[u8]) -> Result<&str, Problem> {
    let line_at = |offset: usize| 1 + bytes.iter().take(offset).filter(|byte| **byte == b'\n').count();
    if let Some(offset) = bytes.iter().position(|byte| *byte == 0) {
        return Err(Problem::new(
            format!("line {}", line_at(offset)),
            "contains a zero byte",
            USE_ANOTHER_COPY,
        ));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        Problem::new(
            format!("line {}", line_at(error.valid_up_to())),
            "is not valid UTF-8",
            "save the file as UTF-8",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::ancestry::MAX_DEPTH;
    use super::*;

    fn outline(text: &[u8]) -> Result<Outline, Problem> {
        to_binary(text.to_vec()).map(|(_, outline)| outline)
    }

    #[test]
    fn reports_the_line_of_deep_nesting_and_invalid_utf8() {
        let deep = format!("#usda 1.0\n{}", "def \"A\" { ".repeat(MAX_DEPTH + 1));
        let problem = outline(deep.as_bytes()).unwrap_err();
        assert!(
            problem.place == "line 2" && problem.what.contains("deep"),
            "{problem}"
        );
        assert_eq!(outline(b"#usda 1.0\n\n\xff").unwrap_err().place, "line 3");
        assert_eq!(outline(b"#usda 1.0\n").map(|outline| outline.prims), Ok(0));
    }

    #[test]
    fn outlines_prims_and_arcs() {
        let text = r#"#usda 1.0
(defaultPrim = "W"
 customLayerData = { int[] x = [1, 2] })
def "W" (prepend references = [</A>, @b.usda@</B>] payload = </C> variants = { string v = "a" } prepend variantSets = "v")
{
    float[] many = [1, 2, 3] (customData = { int[] y = [3] })
    rel to = [</A>, </B>]
    point3f[] points.timeSamples = { 0: [(1, 2, 3)], 1: [(4, 5, 6)] }
    variantSet "v" = { "a" { def "K" (inherits = [</A>, </D>]) {} } }
}
"#;
        let outline = outline(text.as_bytes()).unwrap();
        let arcs: Vec<String> = outline
            .arcs
            .iter()
            .map(|arc| format!("{} {:?} {}", arc.prim, arc.kind, arc.target))
            .collect();
        assert_eq!(
            arcs,
            [
                "/W Reference /A",
                "/W Reference /C",
                "/W VariantSet v",
                "/W/K Class /A",
                "/W/K Class /D"
            ]
        );
        assert_eq!(outline.prims, 2);
    }
}
