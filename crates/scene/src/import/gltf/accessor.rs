use ::gltf::json;
use json::accessor::{ComponentType, Type};
use json::validation::Checked;

use super::document::Document;

/// An accessor whose elements have been checked to lie inside its buffers.
pub(super) struct Accessor<'a> {
    pub(super) count: usize,
    /// Numbers per element.
    components: usize,
    kind: ComponentType,
    normalized: bool,
    /// The data and the stride in bytes; `None` if all elements are zero.
    bytes: Option<(&'a [u8], usize)>,
    /// The elements that the sparse part overrides, ordered by index.
    sparse: Vec<(usize, &'a [u8])>,
}

impl<'a> Accessor<'a> {
    pub(super) fn find(document: &'a Document, index: usize) -> Result<Self, String> {
        Self::checked(document, index).map_err(|message| format!("accessors[{index}]: {message}"))
    }

    fn checked(document: &'a Document, index: usize) -> Result<Self, String> {
        let declared = document.root.accessors.get(index).ok_or("does not exist")?;
        let (Checked::Valid(kind), Checked::Valid(shape)) = (declared.component_type, declared.type_) else {
            return Err("has an unknown type".into());
        };
        let count = usize::try_from(declared.count.0).map_err(|_| "is too long")?;
        let components = match shape {
            Type::Scalar => 1,
            Type::Vec2 => 2,
            Type::Vec3 => 3,
            Type::Vec4 | Type::Mat2 => 4,
            Type::Mat3 => 9,
            Type::Mat4 => 16,
        };
        let mut accessor = Self {
            count,
            components,
            kind: kind.0,
            normalized: declared.normalized,
            bytes: None,
            sparse: Vec::new(),
        };
        let size = accessor.size();
        if let Some(view) = declared.buffer_view {
            let (bytes, stride) = document.view(view.value())?;
            let start = usize::try_from(declared.byte_offset.unwrap_or_default().0).ok();
            let stride = stride.unwrap_or(size).max(1);
            let bytes = start
                .and_then(|start| bytes.get(start..))
                .ok_or("starts after the end of its bufferView")?;
            let needed = count
                .checked_sub(1)
                .map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size));
            if needed.is_none_or(|needed| needed > bytes.len()) {
                return Err(format!("its {count} elements exceed its bufferView"));
            }
            accessor.bytes = Some((bytes, stride));
        } else {
            // An accessor without a bufferView takes no bytes of the file.
            document.allow(count as u64)?;
        }
        if let Some(sparse) = &declared.sparse {
            accessor.sparse = sparse_elements(document, sparse, size, count)?;
        }
        Ok(accessor)
    }

    fn size(&self) -> usize {
        self.components * self.kind.size()
    }

    fn element(&self, at: usize) -> Option<&'a [u8]> {
        if let Ok(found) = self.sparse.binary_search_by_key(&at, |entry| entry.0) {
            return Some(self.sparse[found].1);
        }
        let (bytes, stride) = self.bytes?;
        bytes.get(at * stride..at * stride + self.size())
    }

    /// The first `N` numbers of an element; missing ones are zero.
    pub(super) fn floats<const N: usize>(&self, at: usize) -> [f32; N] {
        let mut numbers = [0.0; N];
        if let Some(element) = self.element(at) {
            for (slot, bytes) in numbers.iter_mut().zip(element.chunks_exact(self.kind.size())) {
                *slot = self.float(bytes);
            }
        }
        numbers
    }

    fn float(&self, bytes: &[u8]) -> f32 {
        let number = decoded(self.kind, bytes);
        // Normalized integers: glTF 2.0, section 3.6.2.3.
        let one = match self.kind {
            _ if !self.normalized => 1.0,
            ComponentType::I8 => 127.0,
            ComponentType::U8 => 255.0,
            ComponentType::I16 => 32767.0,
            ComponentType::U16 => 65535.0,
            ComponentType::U32 | ComponentType::F32 => 1.0,
        };
        #[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
        let float = (number / one) as f32;
        if self.normalized { float.max(-1.0) } else { float }
    }

    /// An element as a vertex index, or −1 if it is not a valid one.
    pub(super) fn index(&self, at: usize) -> i32 {
        if !matches!(
            self.kind,
            ComponentType::U8 | ComponentType::U16 | ComponentType::U32
        ) {
            return -1;
        }
        let number = self.element(at).map_or(0.0, |bytes| decoded(self.kind, bytes));
        #[allow(clippy::cast_possible_truncation, reason = "an integer; the range is checked")]
        let index = number as i32;
        if f64::from(index) == number { index } else { -1 }
    }

    pub(super) fn components(&self) -> usize {
        self.components
    }
}

fn sparse_elements<'a>(
    document: &'a Document,
    sparse: &json::accessor::sparse::Sparse,
    size: usize,
    count: usize,
) -> Result<Vec<(usize, &'a [u8])>, String> {
    let Checked::Valid(kind) = sparse.indices.component_type else {
        return Err("its sparse indices have an unknown type".into());
    };
    let changed = usize::try_from(sparse.count.0).map_err(|_| "its sparse part is too long")?;
    let part = |view: usize, offset: u64, size: usize| {
        let (bytes, _) = document.view(view)?;
        let start = usize::try_from(offset).ok();
        let range = start.and_then(|start| Some(start..start.checked_add(changed.checked_mul(size)?)?));
        range
            .and_then(|range| bytes.get(range))
            .ok_or_else(|| "its sparse part exceeds its bufferView".to_string())
    };
    let indices = part(
        sparse.indices.buffer_view.value(),
        sparse.indices.byte_offset.0,
        kind.0.size(),
    )?;
    let values = part(
        sparse.values.buffer_view.value(),
        sparse.values.byte_offset.0,
        size,
    )?;
    let mut elements: Vec<(usize, &[u8])> = indices
        .chunks_exact(kind.0.size())
        .zip(values.chunks_exact(size))
        .map(|(index, value)| {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "whole, 32 bits"
            )]
            let index = decoded(kind.0, index) as usize;
            (index, value)
        })
        .collect();
    elements.sort_by_key(|element| element.0);
    elements.dedup_by_key(|element| element.0);
    match elements.last() {
        Some((last, _)) if *last >= count => {
            Err(format!("its sparse part changes element {last} of {count}"))
        }
        _ => Ok(elements),
    }
}

/// Decodes a number of the given type from its bytes.
fn decoded(kind: ComponentType, bytes: &[u8]) -> f64 {
    let mut padded = [0; 4];
    for (slot, byte) in padded.iter_mut().zip(bytes) {
        *slot = *byte;
    }
    let [a, b, ..] = padded;
    match kind {
        ComponentType::I8 => f64::from(a.cast_signed()),
        ComponentType::U8 => f64::from(a),
        ComponentType::I16 => f64::from(i16::from_le_bytes([a, b])),
        ComponentType::U16 => f64::from(u16::from_le_bytes([a, b])),
        ComponentType::U32 => f64::from(u32::from_le_bytes(padded)),
        ComponentType::F32 => f64::from(f32::from_le_bytes(padded)),
    }
}
