//! Generation of a data set: frames in parallel, in any order, and the files that span them.

mod preview;
mod store;

use std::collections::BTreeSet;
use std::ops::{ControlFlow, Range};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use oaktwin_catalog::Catalog;
use oaktwin_dataset::{Format, Options as FormatOptions, WriteError};
use oaktwin_diagnostic::Finding;
use oaktwin_files::{AtomicFile, FileError, OutputFiles};
use oaktwin_memory as memory;
use oaktwin_pipeline::progress::{Progress, Watch};
use serde_json::{Value, json};

use crate::GenerateError;
use crate::context::Context;
use crate::frame::FrameMaker;
use crate::recipe::RecipeFile;
use store::{FrameRecord, Store, pretty};

/// The maximum number of consecutive frames that a worker makes at a time.
const MAX_BATCH: u64 = 16;

/// Options of the generation of a data set.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GenerateOptions {
    /// The frames to make; by default all.
    pub frames: Option<Range<u64>>,
    /// Whether an existing data set is completed.
    pub resume: bool,
    /// The number of frames that are made at the same time; by default that of the processors, if there is enough memory.
    pub workers: Option<usize>,
    /// Whether only frames are made: another process has the lock, and completes the data set.
    pub only_frames: bool,
}

/// The result of a generation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Generated {
    /// The number of frames that were made.
    pub made: u64,
    /// The number of frames that were complete already.
    pub skipped: u64,
    /// The number of frames of the recipe that are missing.
    pub missing: u64,
    /// The number of files of the data set.
    pub files: u64,
    /// Their size in bytes.
    pub bytes: u64,
    /// Findings, without duplicates.
    pub findings: Vec<Finding>,
    /// Whether the task was interrupted.
    pub is_interrupted: bool,
}

/// A recipe whose files are open.
#[derive(Debug)]
pub struct Generator {
    context: Context,
}

impl Generator {
    /// Opens the base scenes of a recipe and lists its objects.
    ///
    /// # Errors
    /// Returns an error if a file cannot be read, or if a value does not fit the model or the scene.
    pub fn open(file: RecipeFile, catalog: &Catalog) -> Result<Self, GenerateError> {
        Ok(Self {
            context: Context::open(file, catalog)?,
        })
    }

    /// Returns everything that is drawn at random for a frame.
    ///
    /// # Errors
    /// Returns an error if an object or the camera has no place.
    pub fn explain(&self, frame: u64) -> Result<Value, GenerateError> {
        FrameMaker::new(&self.context).explain(frame)
    }

    /// Generates the data set, or a part of it, in a folder.
    ///
    /// # Errors
    /// Returns an error if a frame cannot be made or a file cannot be written. What is complete remains, and can be resumed.
    pub fn generate(
        &self,
        root: &Path,
        options: &GenerateOptions,
        watch: &Watch<'_>,
    ) -> Result<Generated, GenerateError> {
        let total = self.context.file.recipe.frames;
        let wanted = options.frames.clone().unwrap_or(0..total);
        if wanted.is_empty() || wanted.end > total {
            return Err(self.context.unfit(
                "frames",
                format!("there are no frames {}..{} of {total}", wanted.start, wanted.end),
                "choose frames of the recipe, or raise its number of frames",
            ));
        }
        let store = Store::open(root, &self.context.file, options.resume, options.only_frames)?;
        let mut present = store.frames()?;
        present.retain(|frame| !wanted.contains(frame) || store.is_intact(*frame));
        let missing: Vec<u64> = wanted.clone().filter(|frame| !present.contains(frame)).collect();
        let job = Job {
            context: &self.context,
            store: &store,
            formats: formats(&self.context, root),
            batches: batches(&missing, self.context.file.recipe.frames_per_scene),
            next: AtomicUsize::new(0),
            done: AtomicU64::new(0),
            total: missing.len() as u64,
            is_stopped: AtomicBool::new(false),
            is_interrupted: AtomicBool::new(false),
            findings: Mutex::new(self.context.findings.clone()),
            watch,
        };
        let workers = options
            .workers
            .unwrap_or_else(|| self.workers())
            .clamp(1, job.batches.len().max(1));
        job.run(workers)?;
        let made = job.done.load(Ordering::Relaxed);
        let mut generated = Generated {
            made,
            skipped: wanted.end - wanted.start - missing.len() as u64,
            is_interrupted: job.is_interrupted.load(Ordering::Relaxed),
            ..Generated::default()
        };
        generated.findings = job.findings.into_inner().unwrap_or_else(PoisonError::into_inner);
        if generated.is_interrupted || options.only_frames {
            return Ok(generated);
        }
        finish(&self.context, &store, &job.formats, &mut generated)?;
        Ok(generated)
    }

    /// Returns the number of workers for which there is enough memory, at most that of the processors.
    fn workers(&self) -> usize {
        let threads = rayon::current_num_threads();
        // A worker has a copy of a base scene with its search structures, which are about as large.
        let bytes = self
            .context
            .bases
            .iter()
            .map(|base| base.scene.bytes())
            .max()
            .unwrap_or(0);
        let each = 2 * bytes + (256 << 20);
        let affordable = memory::available().map_or(usize::MAX, |free| {
            usize::try_from(free / 2 / each).unwrap_or(usize::MAX)
        });
        threads.min(affordable).max(1)
    }
}

/// A format with its folder in the data set.
type Placed = (Box<dyn Format>, PathBuf);

fn formats(context: &Context, root: &Path) -> Vec<Placed> {
    let alone = context.formats.len() == 1;
    let options = FormatOptions {
        seed: context.file.recipe.seed,
        ..FormatOptions::default()
    };
    let place = |name: &str| if alone { root.to_owned() } else { root.join(name) };
    let formats = context.formats.iter();
    formats
        .map(|kind| ((kind.create)(options), place(kind.name)))
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

/// The work that is shared by the workers.
struct Job<'a> {
    context: &'a Context,
    store: &'a Store,
    formats: Vec<Placed>,
    batches: Vec<Range<u64>>,
    next: AtomicUsize,
    done: AtomicU64,
    total: u64,
    is_stopped: AtomicBool,
    is_interrupted: AtomicBool,
    findings: Mutex<Vec<Finding>>,
    watch: &'a Watch<'a>,
}

impl Job<'_> {
    fn run(&self, workers: usize) -> Result<(), GenerateError> {
        let threads = (rayon::current_num_threads() / workers).max(1);
        let results: Vec<Result<(), GenerateError>> = thread::scope(|scope| {
            let workers: Vec<_> = (0..workers)
                .map(|_| {
                    scope.spawn(move || {
                        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
                        let result = match pool {
                            Ok(pool) => pool.install(|| self.work()),
                            Err(_) => self.work(),
                        };
                        self.is_stopped.fetch_or(result.is_err(), Ordering::Relaxed);
                        result
                    })
                })
                .collect();
            let join = |worker: thread::ScopedJoinHandle<'_, _>| {
                worker
                    .join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            };
            workers.into_iter().map(join).collect()
        });
        results.into_iter().collect()
    }

    fn work(&self) -> Result<(), GenerateError> {
        let mut maker = FrameMaker::new(self.context);
        let folders = self
            .formats
            .iter()
            .map(|(_, folder)| OutputFiles::in_folder(folder));
        let mut outputs = folders.collect::<Result<Vec<_>, _>>()?;
        while let Some(batch) = self.batches.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            for frame in batch.clone() {
                if self.proceed().is_break() {
                    return Ok(());
                }
                self.make(&mut maker, frame, &mut outputs)?;
                self.done.fetch_add(1, Ordering::Relaxed);
            }
        }
        // Shows the last frame.
        let _ = self.proceed();
        Ok(())
    }

    fn proceed(&self) -> ControlFlow<()> {
        if self.is_stopped.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        let done = self.done.load(Ordering::Relaxed);
        let flow = (self.watch)(Progress {
            done,
            total: self.total,
        });
        if flow.is_break() && done < self.total {
            self.is_interrupted.store(true, Ordering::Relaxed);
            self.is_stopped.store(true, Ordering::Relaxed);
        }
        flow
    }

    fn make(
        &self,
        maker: &mut FrameMaker<'_>,
        frame: u64,
        outputs: &mut [OutputFiles],
    ) -> Result<(), GenerateError> {
        let made = maker.make(frame)?;
        let mut record = FrameRecord {
            frame,
            files: Vec::new(),
            formats: Vec::new(),
        };
        for ((format, _), output) in self.formats.iter().zip(outputs) {
            let records = made.shots.iter().map(|shot| format.frame(shot, output));
            let records = records.collect::<Result<Vec<_>, _>>()?;
            record.formats.push(records);
            record.files.extend(self.store.describe(&output.take_files())?);
        }
        self.store.add(&record)?;
        let mut findings = self.findings.lock().unwrap_or_else(PoisonError::into_inner);
        for finding in made.findings {
            if !findings.contains(&finding) {
                findings.push(finding);
            }
        }
        Ok(())
    }
}

/// Writes the files that span frames, and the manifest.
fn finish(
    context: &Context,
    store: &Store,
    formats: &[Placed],
    generated: &mut Generated,
) -> Result<(), GenerateError> {
    let frames = store.frames()?;
    generated.missing = context.file.recipe.frames.saturating_sub(frames.len() as u64);
    let mut shared = Vec::new();
    for (index, (format, folder)) in formats.iter().enumerate() {
        let mut output = OutputFiles::in_folder(folder)?;
        let mut records = frames.iter().flat_map(|frame| match store.frame(*frame) {
            Ok(mut record) => {
                let records = record
                    .formats
                    .get_mut(index)
                    .map(std::mem::take)
                    .unwrap_or_default();
                records.into_iter().map(Ok).collect()
            }
            Err(error) => vec![Err(WriteError::from(error))],
        });
        generated
            .findings
            .extend(format.finish(&mut records, &mut output)?);
        shared.extend(store.describe(output.files())?);
    }
    write_manifest(context, store, &frames, &shared, generated)
}

/// Writes the manifest, line by line, so that it does not have to fit into memory.
fn write_manifest(
    context: &Context,
    store: &Store,
    frames: &BTreeSet<u64>,
    shared: &[store::FileRecord],
    generated: &mut Generated,
) -> Result<(), GenerateError> {
    let mut file = AtomicFile::create(&store.root.join("manifest.json"))?;
    let mut recipe = serde_json::to_value(&context.file.recipe).unwrap_or_default();
    recipe["frames"] = json!(frames.len());
    let head = String::from_utf8(pretty(&recipe)).unwrap_or_default();
    file.append(format!("{{\"recipe\": {},\n\"files\": [\n", head.trim_end()).as_bytes())?;
    let mut is_first = true;
    let mut add = |record: &store::FileRecord, file: &mut AtomicFile| -> Result<(), FileError> {
        let line = serde_json::to_string(record).unwrap_or_default();
        let separator = if std::mem::replace(&mut is_first, false) {
            ""
        } else {
            ",\n"
        };
        generated.files += 1;
        generated.bytes += record.bytes;
        file.append(format!("{separator}{line}").as_bytes())
    };
    for frame in frames {
        for record in &store.frame(*frame)?.files {
            add(record, &mut file)?;
        }
    }
    for record in shared {
        add(record, &mut file)?;
    }
    file.append(b"\n]}\n")?;
    file.finish()?;
    Ok(())
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
