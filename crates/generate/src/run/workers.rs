//! Workers of this process, each of which makes one frame after the other.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use oaktwin_base::diagnostic::{Finding, add_new};
use oaktwin_files::OutputFiles;
use oaktwin_files::memory;
use oaktwin_pipeline::progress::{Progress, Watch};

use super::store::{FrameRecord, Store};
use super::{Generated, PlacedFormat};
use crate::GenerateError;
use crate::context::Context;
use crate::frame::FrameMaker;

/// The work that is shared by the workers.
pub(super) struct Job<'a> {
    context: &'a Context,
    store: &'a Store,
    formats: &'a [PlacedFormat],
    batches: &'a [Range<u64>],
    next: AtomicUsize,
    done: AtomicU64,
    total: u64,
    is_stopped: AtomicBool,
    is_interrupted: AtomicBool,
    findings: Mutex<Vec<Finding>>,
    watch: &'a Watch<'a>,
}

impl<'a> Job<'a> {
    pub(super) fn new(
        context: &'a Context,
        store: &'a Store,
        formats: &'a [PlacedFormat],
        batches: &'a [Range<u64>],
        total: u64,
        watch: &'a Watch<'a>,
    ) -> Self {
        Self {
            context,
            store,
            formats,
            batches,
            next: AtomicUsize::new(0),
            done: AtomicU64::new(0),
            total,
            is_stopped: AtomicBool::new(false),
            is_interrupted: AtomicBool::new(false),
            findings: Mutex::new(Vec::new()),
            watch,
        }
    }

    /// Makes all frames, and adds what was made to `generated`.
    pub(super) fn run(self, workers: Option<usize>, generated: &mut Generated) -> Result<(), GenerateError> {
        let workers = workers.unwrap_or_else(|| affordable(self.context));
        self.run_with(workers.clamp(1, self.batches.len().max(1)))?;
        generated.made += self.done.load(Ordering::Relaxed);
        generated.is_interrupted |= self.is_interrupted.load(Ordering::Relaxed);
        let findings = self.findings.into_inner().unwrap_or_else(PoisonError::into_inner);
        add_new(&mut generated.findings, findings);
        Ok(())
    }

    fn run_with(&self, workers: usize) -> Result<(), GenerateError> {
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
            unit: made.unit,
            findings: made.findings,
            files: Vec::new(),
            formats: Vec::new(),
        };
        for (((format, _), kind), output) in self.formats.iter().zip(&self.context.formats).zip(outputs) {
            // A stereo format describes the pair, which the frames of other cameras do not have.
            let shots = made
                .shots
                .iter()
                .filter(|shot| !kind.needs.stereo || shot.stereo.is_some());
            let records = shots.map(|shot| format.frame(shot, output));
            let records = records.collect::<Result<Vec<_>, _>>()?;
            record.formats.push(records);
            record.files.extend(self.store.describe(&output.take_files())?);
        }
        let mut scenes = OutputFiles::in_folder(&self.store.root)?;
        for (path, bytes) in maker.scene_files(frame)? {
            scenes.write(&path, &bytes)?;
        }
        record.files.extend(self.store.describe(scenes.files())?);
        self.store.add(&record)?;
        let mut findings = self.findings.lock().unwrap_or_else(PoisonError::into_inner);
        add_new(&mut findings, record.findings);
        Ok(())
    }
}

/// Returns the number of workers for which there is enough memory, at most one per processor.
fn affordable(context: &Context) -> usize {
    let threads = rayon::current_num_threads();
    // A worker has a copy of a base scene with its search structures, which are about as large.
    let bytes = context.bases.iter().map(|base| base.scene.bytes()).max();
    let each = 2 * bytes.unwrap_or(0) + (256 << 20);
    let affordable = memory::available().map_or(usize::MAX, |free| {
        usize::try_from(free / 2 / each).unwrap_or(usize::MAX)
    });
    threads.min(affordable).max(1)
}
