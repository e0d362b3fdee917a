use super::escapes::Decoded;
use super::outline::Outline;
use super::properties::Properties;
use super::skeleton::Skeleton;
use super::structure::Structure;
use super::{MAX_DEPTH, Problem, USE_ANOTHER_COPY};

/// Validates the encoding of a text layer: UTF-8 without zero bytes.
pub(super) fn encoding(bytes: &[u8]) -> Result<&str, Problem> {
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

/// Validates a text layer: a bounded depth, so that a recursive reader does not overflow. Returns its outline.
pub(super) fn inspect(layer: &Decoded) -> Result<Outline, Problem> {
    let bytes = layer.bytes.as_slice();
    let line_at = |offset: usize| {
        let before = bytes.iter().take(offset).filter(|byte| **byte == b'\n');
        layer.line_in_file(1 + before.count())
    };
    let text = std::str::from_utf8(bytes).unwrap_or_default();
    let mut skeleton = Skeleton::new(text);
    let mut properties = Properties::new(text);
    for (offset, byte) in Structure::new(bytes) {
        if !properties.fit(offset, byte) {
            return Err(Problem::new(
                format!("line {}", line_at(offset)),
                "the prim that ends here has too many properties for a text layer",
                "convert the layer to binary: `usdcat --out NEW.usdc OLD.usda`",
            ));
        }
        skeleton.bracket(offset, byte);
        if skeleton.depth() > MAX_DEPTH {
            return Err(Problem::new(
                format!("line {}", line_at(offset)),
                format!("brackets nest more than {MAX_DEPTH} deep"),
                "flatten the stage",
            ));
        }
    }
    Ok(skeleton.outline())
}

#[cfg(test)]
mod tests {
    use super::super::escapes;
    use super::*;

    fn inspect(bytes: &[u8]) -> Result<Outline, Problem> {
        encoding(bytes)?;
        super::inspect(&escapes::decode(bytes.to_vec())?)
    }

    #[test]
    fn reports_the_line_of_deep_nesting_and_invalid_utf8() {
        let deep = format!("#usda 1.0\n{}", "{".repeat(MAX_DEPTH + 1));
        assert_eq!(inspect(deep.as_bytes()).unwrap_err().place, "line 2");
        assert_eq!(inspect(b"#usda 1.0\n\n\xff").unwrap_err().place, "line 3");
        assert_eq!(inspect(b"#usda 1.0\n").map(|outline| outline.prims), Ok(0));
    }

    #[test]
    fn outlines_prims_and_arcs_without_arrays() {
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
        let outline = inspect(text.as_bytes()).unwrap();
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
        assert!(outline.prims >= 2);
    }
}
