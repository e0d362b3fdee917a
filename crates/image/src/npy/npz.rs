use std::io::{Cursor, Read};

use zip::ZipArchive;
use zip::result::ZipError;

use crate::CodecError;
use crate::limits::allowed_bytes;

const FORMAT: &str = "NPZ";
/// The array that is read if an archive has several.
const PREFERRED: &str = "depth";

/// Returns the `.npy` file of the only array of an archive of `numpy.savez`, or of the array `depth`.
///
/// # Errors
/// Returns an error if the bytes are not such an archive, or have several arrays of which none is called `depth`.
pub fn only_array(bytes: &[u8]) -> Result<Vec<u8>, CodecError> {
    let damaged = |error: &ZipError| {
        CodecError::new(
            FORMAT,
            "archive",
            error.to_string(),
            "save it again with numpy.savez or numpy.savez_compressed",
        )
    };
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| damaged(&error))?;
    let arrays: Vec<(usize, String)> = (0..archive.len())
        .filter_map(|at| {
            let name = archive.name_for_index(at)?.strip_suffix(".npy")?;
            Some((at, name.to_owned()))
        })
        .collect();
    let named = arrays.iter().find(|(_, name)| name == PREFERRED);
    let (at, name) = match (named, arrays.as_slice()) {
        (Some(found), _) | (None, [found]) => found,
        (None, []) => {
            return Err(CodecError::new(
                FORMAT,
                "archive",
                "there is no array",
                "save one with numpy.savez",
            ));
        }
        (None, several) => {
            let names: Vec<&str> = several.iter().map(|(_, name)| name.as_str()).collect();
            return Err(CodecError::new(
                FORMAT,
                "archive",
                format!(
                    "several arrays, none of them called {PREFERRED}: {}",
                    names.join(", ")
                ),
                "save the depth alone, or name it: numpy.savez(file, depth=z)",
            ));
        }
    };
    let entry = archive.by_index(*at).map_err(|error| damaged(&error))?;
    let limit = allowed_bytes(bytes.len());
    let mut array = Vec::new();
    entry
        .take(limit + 1)
        .read_to_end(&mut array)
        .map_err(|error| damaged(&error.into()))?;
    if array.len() as u64 > limit {
        return Err(CodecError::new(
            FORMAT,
            format!("{name}.npy"),
            format!("cannot be in {} bytes", bytes.len()),
            "the file is damaged; save it again",
        ));
    }
    Ok(array)
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use zip::write::{SimpleFileOptions, ZipWriter};

    use super::*;

    fn archive(arrays: &[(&str, &[u8])], method: zip::CompressionMethod) -> Vec<u8> {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        for (name, bytes) in arrays {
            let options = SimpleFileOptions::default().compression_method(method);
            writer.start_file(*name, options).unwrap();
            writer.write_all(bytes).unwrap();
        }
        writer.finish().unwrap().into_inner()
    }

    #[test]
    fn one_array_or_the_one_called_depth() {
        for method in [zip::CompressionMethod::Stored, zip::CompressionMethod::Deflated] {
            let one = archive(&[("arr_0.npy", b"first"), ("notes.txt", b"")], method);
            assert_eq!(only_array(&one).unwrap(), b"first");
            let named = archive(&[("K.npy", b"K"), ("depth.npy", b"z")], method);
            assert_eq!(only_array(&named).unwrap(), b"z");
        }
    }

    #[test]
    fn errors_state_a_remedy() {
        let says = |bytes: &[u8]| only_array(bytes).unwrap_err().to_string();
        let stored = zip::CompressionMethod::Stored;
        assert_eq!(
            says(&archive(&[("a.npy", b""), ("b.npy", b"")], stored)),
            "NPZ: archive: several arrays, none of them called depth: a, b; save the depth alone, or name it: numpy.savez(file, depth=z)"
        );
        assert!(says(&archive(&[("a.txt", b"")], stored)).contains("there is no array"));
        let whole = archive(&[("a.npy", b"some bytes")], stored);
        assert!(says(&whole[..whole.len() - 9]).contains("save it again"));
        assert!(says(b"PK\x03\x04").contains("save it again"));
    }
}
