use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use oaktwin_dataset::WriterOptions;
use oaktwin_files::FileError;
use oaktwin_pipeline::progress::Watch;

use super::store::Store;
use super::verify::Verifier;
use super::workers::Job;
use super::{GenerateOptions, Generated, PlacedFormat, finish};
use crate::GenerateError;
use crate::context::Context;

/// The maximum number of consecutive frames that a worker makes at a time.
const MAX_BATCH: u64 = 16;

/// A data set in a folder, whose missing frames are made by this process or by others.
#[expect(missing_debug_implementations, reason = "formats have none")]
pub struct Generation {
    context: Arc<Context>,
    store: Store,
    formats: Vec<PlacedFormat>,
    batches: Vec<Range<u64>>,
    total: u64,
    only_frames: bool,
    generated: Generated,
}

impl Generation {
    pub(super) fn start(
        context: Arc<Context>,
        root: &Path,
        options: &GenerateOptions,
    ) -> Result<Self, GenerateError> {
        let total = context.file.recipe.frames;
        let wanted = options.frames.clone().unwrap_or(0..total);
        if wanted.is_empty() || wanted.end > total {
            return Err(context.unfit(
                "frames",
                format!(
                    "frames {}..{} are beyond the {total} frames of the recipe",
                    wanted.start, wanted.end
                ),
                "choose frames of the recipe, or raise its number of frames",
            ));
        }
        let store = Store::open(
            root,
            &context.file,
            &context.inputs(),
            options.resume,
            options.only_frames,
        )?;
        // A worker of another process makes few frames of many: it does not list all.
        let known = match options.only_frames {
            true => wanted.clone().collect(),
            false => store.frames()?,
        };
        let verifier = options.verify.then(|| Verifier::new(&store));
        let is_changed = |frame: u64| verifier.as_ref().is_some_and(|files| !files.is_unchanged(frame));
        let is_missing =
            |frame: &u64| !known.contains(frame) || !store.is_intact(*frame) || is_changed(*frame);
        let missing: Vec<u64> = wanted.clone().filter(is_missing).collect();
        drop(verifier);
        let generated = Generated {
            skipped: wanted.end - wanted.start - missing.len() as u64,
            findings: context.findings.clone(),
            ..Generated::default()
        };
        Ok(Self {
            formats: formats(&context, root),
            batches: batches(&missing, context.file.recipe.frames_per_scene),
            total: missing.len() as u64,
            only_frames: options.only_frames,
            context,
            store,
            generated,
        })
    }

    /// The missing frames, in batches of consecutive ones that have much in common.
    #[must_use]
    pub fn batches(&self) -> &[Range<u64>] {
        &self.batches
    }

    /// The number of missing frames.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.total
    }

    /// Makes the missing frames, several at the same time; by default one for each processor, if there is enough memory.
    ///
    /// # Errors
    /// Returns an error if a frame cannot be made or a file cannot be written.
    pub fn make(&mut self, workers: Option<usize>, watch: &Watch<'_>) -> Result<(), GenerateError> {
        let job = Job::new(
            &self.context,
            &self.store,
            &self.formats,
            &self.batches,
            self.total,
            watch,
        );
        job.run(workers, &mut self.generated)
    }

    /// Adds a batch of frames that another process made.
    ///
    /// # Errors
    /// Returns an error if they are not in the folder.
    pub fn add(&mut self, batch: &Range<u64>) -> Result<(), GenerateError> {
        if let Some(frame) = batch.clone().find(|frame| !self.store.is_intact(*frame)) {
            return Err(FileError::new(
                &self.store.root,
                format!("frame {frame} was made on another machine, but is not here"),
                "choose a folder that all machines have in common, under the same path",
            )
            .into());
        }
        self.generated.made += batch.end - batch.start;
        Ok(())
    }

    /// Ends the generation before all frames are made.
    pub const fn interrupt(&mut self) {
        self.generated.is_interrupted = true;
    }

    /// Writes the files that span frames and the manifest, unless only frames are made or the generation was interrupted.
    ///
    /// # Errors
    /// Returns an error if a file cannot be read or written.
    pub fn finish(mut self) -> Result<Generated, GenerateError> {
        if !self.generated.is_interrupted && !self.only_frames {
            finish::finish(&self.context, &self.store, &self.formats, &mut self.generated)?;
        }
        Ok(self.generated)
    }
}

fn formats(context: &Context, root: &Path) -> Vec<PlacedFormat> {
    let alone = context.formats.len() == 1;
    let options = WriterOptions {
        seed: context.file.recipe.seed,
        shard_frames: context.file.recipe.output.shard_frames,
        ..WriterOptions::default()
    };
    let place = |name: &str| if alone { root.to_owned() } else { root.join(name) };
    let labels = context.object_files.labels();
    let formats = context.formats.iter();
    formats
        .map(|kind| ((kind.create)(options, &labels), place(kind.name)))
        .collect()
}

/// Divides frames into batches of consecutive frames that see the same arrangement.
fn batches(frames: &[u64], per_scene: u64) -> Vec<Range<u64>> {
    let mut batches: Vec<Range<u64>> = Vec::new();
    for &frame in frames {
        match batches.last_mut() {
            Some(batch)
                if batch.end == frame
                    && batch.start / per_scene == frame / per_scene
                    && frame - batch.start < MAX_BATCH =>
            {
                batch.end += 1;
            }
            _ => batches.push(frame..frame + 1),
        }
    }
    batches
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_share_an_arrangement() {
        assert_eq!(batches(&[0, 1, 2, 3, 5, 6], 3), [0..3, 3..4, 5..6, 6..7]);
        assert_eq!(batches(&[4, 5], 1), [4..5, 5..6]);
        let long: Vec<u64> = (0..40).collect();
        assert_eq!(batches(&long, 1000), [0..16, 16..32, 32..40]);
        assert!(batches(&[], 3).is_empty());
    }
}
