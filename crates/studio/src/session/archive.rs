//! The archive of a session, which may be anything.

use std::fs::File as DiskFile;
use std::io::Read;
use std::path::Path;

use serde_json::Value;
use zip::ZipArchive;
use zip::result::ZipError;

use super::{STATE, State, VERSION};
use crate::protocol::Failure;

/// The maximum length of the file with the state, bytes.
const MAX_STATE_BYTES: u64 = 4 << 20;

/// The archive of a session.
pub(super) struct Archive<'a> {
    name: &'a str,
    zip: ZipArchive<DiskFile>,
}

impl<'a> Archive<'a> {
    pub(super) fn open(path: &Path, name: &'a str) -> Result<Self, Failure> {
        let failed = |error: &dyn ToString| {
            Failure::from(format!(
                "{name}: is not a session of Studio, or not all of it ({}); open a file that Studio saved",
                error.to_string()
            ))
        };
        let file = DiskFile::open(path).map_err(|error| failed(&error))?;
        let zip = ZipArchive::new(file).map_err(|error| failed(&error))?;
        Ok(Self { name, zip })
    }

    pub(super) fn state(&mut self) -> Result<State, Failure> {
        if self.zip.index_for_name(STATE).is_none() {
            return Err(self.wrong(&format!("has no {STATE}, so it is not a session of Studio")));
        }
        let bytes = self.file(STATE, MAX_STATE_BYTES)?;
        let invalid = |error: serde_json::Error| format!("{STATE}: {error}");
        let json: Value = serde_json::from_slice(&bytes).map_err(|error| self.wrong(&invalid(error)))?;
        match json.get("oaktwinSession").and_then(Value::as_u64) {
            // Numbers of the page's state keep their last digit.
            Some(VERSION) => serde_json::from_slice(&bytes).map_err(|error| self.wrong(&invalid(error))),
            Some(version) => Err(Failure::from(format!(
                "{}: has version {version} of the format, but this program reads version {VERSION}; update oaktwin",
                self.name
            ))),
            None => Err(self.wrong(&format!(
                "{STATE} has no version, so it is not a session of Studio"
            ))),
        }
    }

    /// Reads a file, which must not be longer than `limit`.
    pub(super) fn file(&mut self, place: &str, limit: u64) -> Result<Vec<u8>, Failure> {
        let name = self.name;
        let damaged = |what: &dyn ToString| {
            Failure::from(format!(
                "{name}: {place}: {}; the file is damaged, save it again",
                what.to_string()
            ))
        };
        let entry = match self.zip.by_name(place) {
            Ok(entry) => entry,
            Err(ZipError::FileNotFound) => return Err(damaged(&"is missing")),
            Err(error) => return Err(damaged(&error)),
        };
        let mut bytes = Vec::new();
        let read = entry.take(limit + 1).read_to_end(&mut bytes);
        read.map_err(|error| damaged(&error))?;
        match bytes.len() as u64 > limit {
            true => Err(damaged(&format!(
                "is larger than {}",
                oaktwin::memory::size(limit)
            ))),
            false => Ok(bytes),
        }
    }

    /// The state refers to files by what they contain.
    pub(super) fn check_id(&self, expected: &str, found: &str, name: &str) -> Result<(), Failure> {
        match expected == found {
            true => Ok(()),
            false => Err(self.wrong(&format!("{name} is not the file that was saved"))),
        }
    }

    pub(super) fn wrong(&self, what: &str) -> Failure {
        Failure::from(format!("{}: {what}; open a file that Studio saved", self.name))
    }
}
