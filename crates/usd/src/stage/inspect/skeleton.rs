use openusd::usda;

use super::outline::{self, Outline};

/// A text layer without the contents of its arrays, which are most of it, but with all prims and arcs.
pub(super) struct Skeleton<'a> {
    text: &'a str,
    kept: String,
    /// The offset after the last part that was kept or dropped.
    at: usize,
    /// The open brackets.
    open: Vec<u8>,
    /// The number of open brackets inside an array that is dropped.
    dropping: Option<usize>,
    metadata: usize,
    prims: u64,
}

impl<'a> Skeleton<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            kept: String::new(),
            at: 0,
            open: Vec::new(),
            dropping: None,
            metadata: 0,
            prims: 0,
        }
    }

    pub(super) fn bracket(&mut self, offset: usize, byte: u8) {
        match byte {
            b'{' | b'(' | b'[' => {
                // The lists of arcs are inside parentheses.
                if byte == b'[' && self.open.last() == Some(&b'{') && self.dropping.is_none() {
                    self.kept.push_str(&self.text[self.at..=offset]);
                    self.dropping = Some(self.open.len());
                }
                self.prims += u64::from(byte == b'{' && self.metadata == 0);
                self.metadata += usize::from(byte == b'(');
                self.open.push(byte);
            }
            b'}' | b')' | b']' => {
                let closed = self.open.pop();
                self.metadata -= usize::from(closed == Some(b'('));
                if self.dropping == Some(self.open.len()) {
                    self.dropping = None;
                    self.at = offset;
                }
            }
            _ => {}
        }
    }

    /// Returns the number of open brackets.
    pub(super) fn depth(&self) -> usize {
        self.open.len()
    }

    pub(super) fn outline(mut self) -> Outline {
        const ARCS: [&str; 7] = [
            "references",
            "payload",
            "inherits",
            "specializes",
            "variantSet",
            "subLayers",
            "clips",
        ];
        if self.dropping.is_none() {
            self.kept.push_str(&self.text[self.at..]);
        }
        if ARCS.iter().any(|arc| self.kept.contains(arc)) {
            // The library reports an invalid layer itself.
            let parsed = usda::parse(&self.kept).or_else(|_| usda::parse(self.text));
            if let Ok(layer) = parsed {
                return outline::outline(&layer, self.prims);
            }
        }
        Outline {
            prims: self.prims,
            ..Outline::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::structure::Structure;
    use super::*;

    #[test]
    fn drops_the_contents_of_arrays() {
        let text =
            "def \"W\" (references = [</A>])\n{\n float[] many = [1, 2] (customData = { int[] y = [3] })\n}";
        let mut skeleton = Skeleton::new(text);
        for (offset, byte) in Structure::new(text.as_bytes()) {
            skeleton.bracket(offset, byte);
        }
        skeleton.kept.push_str(&text[skeleton.at..]);
        let kept =
            "def \"W\" (references = [</A>])\n{\n float[] many = [] (customData = { int[] y = [] })\n}";
        assert_eq!(skeleton.kept, kept);
    }
}
