//! `<include>`: other files whose contents take its place.

use std::path::Path;

use super::super::document::{self, Element, XmlError};

/// The maximum number of files, and the maximum depth of elements in all of them together.
const MAX_FILES: usize = 64;
const MAX_DEPTH: usize = 256;

/// Replaces each `<include>` by the contents of its file, whose path is relative to the folder of the outermost file.
pub(super) fn expanded(mut root: Element, folder: &Path) -> Result<Element, XmlError> {
    let mut left = MAX_FILES;
    expand(&mut root, folder, &mut left, 0)?;
    Ok(root)
}

fn expand(element: &mut Element, folder: &Path, left: &mut usize, depth: usize) -> Result<(), XmlError> {
    if depth > MAX_DEPTH {
        let what = format!("elements nest more than {MAX_DEPTH} deep");
        return Err(element.wrong(what, "remove the <include> of a file in itself"));
    }
    let mut children = Vec::with_capacity(element.children.len());
    for mut child in std::mem::take(&mut element.children) {
        if child.tag == "include" {
            // A file that includes itself ends here, too.
            *left = left.checked_sub(1).ok_or_else(|| {
                let what = format!("more than {MAX_FILES} files are included");
                child.wrong(what, "remove the <include> of a file in itself")
            })?;
            let path = folder.join(child.required("file")?);
            if !path.is_file() {
                let what = format!("there is no file {}", path.display());
                return Err(child.wrong(what, "copy it there, or correct the name"));
            }
            let mut included = document::open(&path)?;
            expand(&mut included, folder, left, depth + 1)?;
            children.append(&mut included.children);
        } else {
            expand(&mut child, folder, left, depth + 1)?;
            children.push(child);
        }
    }
    element.children = children;
    Ok(())
}
