//! `NumPy` arrays in `.npy` files, format version 1.0.
//!
//! Written files equal the files of `numpy.save` (NumPy 1.23 and later, which reserve space in the header for the first axis to
//! grow): little endian, C order. Source: NumPy's documentation of `numpy.lib.format`.

mod header;
mod layout;
mod npz;
mod read;
mod values;
mod write;

pub use layout::{Layout, Number};
pub use npz::only_array;
pub use read::{Array, decode};
pub use values::Values;
pub use write::{Field, NpyElement, begin, encode, encode_records, write};

const FORMAT: &str = "NPY";

/// The first bytes of a file.
pub const MAGIC: &[u8] = b"\x93NUMPY";
