//! Files that are dropped onto the page. They are read and not kept on the disk.

use std::path::Path;
use std::time::Duration;

use axum::body::Body;
use futures_util::StreamExt;
use oaktwin::render::OpenOptions;
use sha2::{Digest, Sha256};
use tempfile::TempDir;
use tokio::io::AsyncWriteExt;

use crate::protocol::Failure;

/// The maximum size of a dropped file, bytes. A larger one is opened faster from the command line, without a copy.
pub(crate) const MAX_BYTES: u64 = 256 << 20;

/// Returns the name of a dropped file without its folders. The extension determines the format.
pub(crate) fn file_name(name: &str) -> Result<String, Failure> {
    let name = name.rsplit(['/', '\\']).next().unwrap_or_default();
    let is_valid = !name.is_empty()
        && name.len() <= 255
        && !name.chars().any(char::is_control)
        && !name.starts_with('.');
    match is_valid {
        true => Ok(name.to_owned()),
        false => Err(Failure::of(
            "name",
            "a dropped file requires a name with an extension; rename it",
        )),
    }
}

/// Returns the id of a dropped file, which depends on its name, how it is read, and its content only, so that a link finds the same
/// scene again after a restart of the server, or none.
pub(crate) fn content_id(name: &str, options: &OpenOptions, path: &Path) -> Result<String, Failure> {
    let failed = |error: std::io::Error| {
        Failure::from(format!("the dropped file cannot be read: {error}; drop it again"))
    };
    let mut hash = Sha256::new();
    hash.update(name);
    hash.update([0]);
    let up = options.up.map_or("", |up| up.name());
    hash.update(format!("{up} {:?}", options.scale.unwrap_or(1.0)));
    hash.update([0]);
    let mut file = std::fs::File::open(path).map_err(failed)?;
    std::io::copy(&mut file, &mut hash).map_err(failed)?;
    Ok(format!("dropped-{}", digits(hash)))
}

/// Returns the part of an id that depends on the name and the content of a file only.
pub(crate) fn bytes_id(name: &str, bytes: &[u8]) -> String {
    digits(
        Sha256::new()
            .chain_update(name)
            .chain_update([0])
            .chain_update(bytes),
    )
}

fn digits(hash: Sha256) -> String {
    let bytes = hash.finalize();
    bytes.iter().take(12).map(|byte| format!("{byte:02x}")).collect()
}

/// Makes a folder for a file that is received.
pub(crate) fn folder(uploads: &Path) -> Result<TempDir, Failure> {
    tempfile::tempdir_in(uploads).map_err(|error| {
        // The whole error names the folder.
        let kind = error.kind();
        Failure::from(format!(
            "no temporary folder can be created ({kind}); free space on the disk"
        ))
    })
}

/// How long a dropped file may take to arrive.
const TIME: Duration = Duration::from_secs(600);

/// Writes the body of a request to a file that is not longer than `limit`.
pub(crate) async fn receive(body: Body, path: &Path, limit: u64) -> Result<(), Failure> {
    let received = tokio::time::timeout(TIME, write(body, path, limit)).await;
    let late =
        "the dropped file did not arrive within 10 minutes; name it on the command line: oaktwin studio FILE";
    received.unwrap_or_else(|_| Err(Failure::from(late.to_owned())))
}

async fn write(body: Body, path: &Path, limit: u64) -> Result<(), Failure> {
    // The disk is full, or files may not be as large.
    let failed = |error: std::io::Error| {
        Failure::from(format!(
            "the dropped file cannot be kept: {error}; free some space for temporary files (TMPDIR), or name it on the command line: oaktwin studio FILE"
        ))
    };
    let mut file = tokio::fs::File::create_new(path).await.map_err(failed)?;
    let mut stream = body.into_data_stream();
    let mut received = 0u64;
    while let Some(part) = stream.next().await {
        let part = part.map_err(|error| {
            Failure::from(format!("the dropped file did not arrive: {error}; drop it again"))
        })?;
        received += part.len() as u64;
        if received > limit {
            return Err(too_large(limit));
        }
        file.write_all(&part).await.map_err(failed)?;
    }
    file.flush().await.map_err(failed)
}

/// The error about a file that is too large.
pub(crate) fn too_large(limit: u64) -> Failure {
    let limit = oaktwin::memory::size(limit);
    Failure::from(format!(
        "the dropped file is larger than {limit}; name it on the command line: oaktwin studio FILE"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_no_folders() {
        assert_eq!(file_name("room.glb").unwrap(), "room.glb");
        assert_eq!(file_name("../../etc/room.glb").unwrap(), "room.glb");
        assert_eq!(file_name("C:\\rooms\\room.glb").unwrap(), "room.glb");
        for wrong in ["", "/", "..", ".hidden", "a\nb.glb", &"x".repeat(300)] {
            assert!(file_name(wrong).is_err(), "{wrong:?}");
        }
    }
}
