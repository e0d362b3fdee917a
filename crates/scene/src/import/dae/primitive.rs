//! Primitives: which numbers belong to which corners of which faces.

use std::collections::HashMap;

use oaktwin_files::xml::{Element, XmlError};

use super::super::error::DAMAGED;
use super::source::{indices, whole};

/// The elements of a mesh by their kind and id. Never iterated.
pub(super) struct Ids<'a>(HashMap<(&'a str, &'a str), &'a Element>);

impl<'a> Ids<'a> {
    pub(super) fn new(mesh: &'a Element) -> Self {
        let children = mesh.children.iter();
        let named = children.filter_map(|child| Some(((child.tag.as_str(), child.get("id")?), child)));
        Self(named.collect())
    }

    /// Returns the element to which another one refers.
    pub(super) fn find(&self, tag: &str, id: &str, from: &Element) -> Result<&'a Element, XmlError> {
        let found = self.0.get(&(tag, id)).copied();
        found.ok_or_else(|| from.wrong(format!("the mesh has no <{tag} id=\"{id}\">"), DAMAGED))
    }
}

/// An `<input>` of a primitive.
pub(super) struct Input<'a> {
    semantic: &'a str,
    set: Option<usize>,
    /// The place of its index among the numbers of a corner.
    pub(super) offset: usize,
    /// The id of the source.
    pub(super) source: &'a str,
}

/// A primitive: `<triangles>`, `<polylist>` and others.
pub(super) struct Primitive<'a> {
    pub(super) element: &'a Element,
    /// The inputs, with the inputs of its `<vertices>`.
    inputs: Vec<Input<'a>>,
    /// The numbers of a corner.
    pub(super) stride: usize,
}

/// The faces of a primitive.
#[derive(Default)]
pub(super) struct Faces {
    pub(super) numbers: Vec<i32>,
    /// The corners of all faces, which are places among the numbers, divided by the stride.
    pub(super) corners: Vec<usize>,
    /// The number of corners of each face.
    pub(super) counts: Vec<i32>,
}

impl<'a> Primitive<'a> {
    pub(super) fn new(element: &'a Element, ids: &Ids<'a>) -> Result<Self, XmlError> {
        let mut inputs = Vec::new();
        let mut stride = 1;
        for input in element.all("input") {
            let (semantic, source) = (input.required("semantic")?, local(input)?);
            let offset = whole(input, "offset")?.unwrap_or(0);
            stride = stride.max(offset + 1);
            if semantic != "VERTEX" {
                let set = whole(input, "set")?;
                inputs.push(Input {
                    semantic,
                    set,
                    offset,
                    source,
                });
                continue;
            }
            for input in ids.find("vertices", source, input)?.all("input") {
                inputs.push(Input {
                    semantic: input.required("semantic")?,
                    set: None,
                    offset,
                    source: local(input)?,
                });
            }
        }
        Ok(Self {
            element,
            inputs,
            stride,
        })
    }

    /// Returns the input with a meaning, of a set if there is one, otherwise of the first set.
    pub(super) fn input(&self, semantic: &str, set: Option<usize>) -> Option<&Input<'a>> {
        let mut all = self.inputs.iter().filter(|input| input.semantic == semantic);
        let of_set = all.clone().find(|input| set.is_some() && input.set == set);
        let first = all.next();
        let lowest = all.fold(first, |best, input| match best {
            Some(best) if best.set <= input.set => Some(best),
            _ => Some(input),
        });
        of_set.or(lowest)
    }

    /// Reads the faces.
    pub(super) fn faces(&self) -> Result<Faces, XmlError> {
        let element = self.element;
        let mut faces = Faces::default();
        // Polygons with holes are filled.
        let outlines = element
            .children
            .iter()
            .filter_map(|child| match child.tag.as_str() {
                "p" => Some(child),
                "ph" => child.child("p"),
                _ => None,
            });
        for p in outlines {
            let first = faces.numbers.len() / self.stride;
            faces.numbers.extend(indices(p)?);
            if faces.numbers.len() % self.stride != 0 {
                let message = format!(
                    "the numbers are no multiple of {}, as its inputs require",
                    self.stride
                );
                return Err(p.wrong(message, DAMAGED));
            }
            let end = faces.numbers.len() / self.stride;
            match element.tag.as_str() {
                "polygons" => faces.push(first..end),
                "tristrips" => {
                    for at in first..end.saturating_sub(2) {
                        // Every other triangle of a strip runs the other way.
                        let odd = (at - first) % 2;
                        faces.push([at, at + 1 + odd, at + 2 - odd]);
                    }
                }
                "trifans" => {
                    for at in first + 1..end.saturating_sub(1) {
                        faces.push([first, at, at + 1]);
                    }
                }
                "polylist" => self.polylist(&mut faces, first..end)?,
                _ => {
                    if !(end - first).is_multiple_of(3) {
                        let message = format!("{} corners are no whole number of triangles", end - first);
                        return Err(p.wrong(message, DAMAGED));
                    }
                    for at in (first..end).step_by(3) {
                        faces.push(at..at + 3);
                    }
                }
            }
        }
        let declared = whole(element, "count")?;
        let made = match element.tag.as_str() {
            "tristrips" | "trifans" => element.all("p").count(),
            _ => faces.counts.len(),
        };
        if declared.is_some_and(|declared| declared != made) {
            let message = format!(
                "the count is {}, but there are {made}",
                element.get("count").unwrap_or_default()
            );
            return Err(element.wrong(message, DAMAGED));
        }
        Ok(faces)
    }

    /// Divides corners into the polygons whose numbers of corners `<vcount>` lists.
    fn polylist(&self, faces: &mut Faces, corners: std::ops::Range<usize>) -> Result<(), XmlError> {
        let counts = self
            .element
            .child("vcount")
            .ok_or_else(|| self.element.wrong("<vcount> is missing", DAMAGED))?;
        let mut at = corners.start;
        for count in indices(counts)? {
            let next = usize::try_from(count)
                .ok()
                .and_then(|count| at.checked_add(count));
            let next = next.filter(|next| *next <= corners.end).ok_or_else(|| {
                let message = format!("the polygons need more than the {} corners", corners.len());
                counts.wrong(message, DAMAGED)
            })?;
            faces.push(at..next);
            at = next;
        }
        if at < corners.end {
            let message = format!(
                "the polygons use {} of {} corners",
                at - corners.start,
                corners.len()
            );
            return Err(counts.wrong(message, DAMAGED));
        }
        Ok(())
    }
}

impl Faces {
    fn push(&mut self, corners: impl IntoIterator<Item = usize>) {
        let before = self.corners.len();
        self.corners.extend(corners);
        let count = self.corners.len() - before;
        self.counts.push(i32::try_from(count).unwrap_or(i32::MAX));
    }
}

/// The id of an input's source, which is in the same mesh.
fn local(input: &Element) -> Result<&str, XmlError> {
    let source = input.required("source")?;
    source.strip_prefix('#').ok_or_else(|| {
        let message = format!("source: '{source}' is in another file");
        input.wrong(message, "export the scene to one file")
    })
}
