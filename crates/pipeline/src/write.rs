//! The loop that all commands share: frames are written while the next ones are made.

use std::ops::ControlFlow;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use oaktwin_dataset::{Shot, WriteError, Writer};
use oaktwin_files::OutputFiles;

use crate::progress::{Progress, Watch};

/// The result of a [`write_while`].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Written {
    /// The number of frames that were written.
    pub(crate) frames: u64,
    /// The number of frames whose files are complete.
    pub(crate) complete: u64,
    pub(crate) is_interrupted: bool,
}

enum Message {
    Shot(Box<Shot>),
    Finish,
}

/// Passes frames to the writers, and progress to the caller.
pub(crate) struct Producer<'a> {
    sender: SyncSender<Message>,
    watch: &'a Watch<'a>,
    progress: Progress,
    is_interrupted: bool,
}

impl Producer<'_> {
    /// Adds to the number of expected frames.
    pub(crate) fn expect_more(&mut self, frames: u64) {
        self.progress.total += frames;
    }

    /// Whether to make the next frame.
    pub(crate) fn proceed(&mut self) -> ControlFlow<()> {
        let flow = (self.watch)(self.progress);
        self.is_interrupted |= flow.is_break();
        flow
    }

    /// Passes a frame on, unless the task was interrupted in the meantime. Breaks then, and if a writer has failed.
    pub(crate) fn write(&mut self, shot: Shot) -> ControlFlow<()> {
        self.progress.done += 1;
        if (self.watch)(self.progress).is_break() && self.progress.done < self.progress.total {
            self.is_interrupted = true;
            return ControlFlow::Break(());
        }
        self.send(Message::Shot(Box::new(shot)))
    }

    /// Completes the files of the frames so far.
    pub(crate) fn finish(&mut self) -> ControlFlow<()> {
        self.send(Message::Finish)
    }

    fn send(&self, message: Message) -> ControlFlow<()> {
        match self.sender.send(message) {
            Ok(()) => ControlFlow::Continue(()),
            // The writers have failed, and their error is returned by `write_while`.
            Err(_) => ControlFlow::Break(()),
        }
    }
}

/// Writes the frames that `produce` passes on, of which `total` are expected. A frame is written while the next one is made;
/// there are never more than three.
///
/// # Errors
/// Returns the error of a writer, else the error of `produce`.
pub(crate) fn write_while<E: From<WriteError>>(
    writers: &mut [&mut dyn Writer],
    output: &mut OutputFiles,
    total: u64,
    watch: &Watch<'_>,
    produce: impl FnOnce(&mut Producer<'_>) -> Result<ControlFlow<()>, E>,
) -> Result<Written, E> {
    let (sender, receiver) = sync_channel(1);
    thread::scope(|scope| {
        let writing = scope.spawn(|| write_all(writers, output, receiver));
        let mut producer = Producer {
            sender,
            watch,
            progress: Progress { done: 0, total },
            is_interrupted: false,
        };
        let produced = produce(&mut producer);
        let is_interrupted = producer.is_interrupted;
        drop(producer);
        let written = writing
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        let (frames, complete) = written?;
        let _: ControlFlow<()> = produced?;
        Ok(Written {
            frames,
            complete,
            is_interrupted,
        })
    })
}

fn write_all(
    writers: &mut [&mut dyn Writer],
    output: &mut OutputFiles,
    messages: Receiver<Message>,
) -> Result<(u64, u64), WriteError> {
    let (mut frames, mut complete) = (0, 0);
    for message in messages {
        match message {
            Message::Shot(shot) => {
                for writer in writers.iter_mut() {
                    writer.write(&shot, output)?;
                }
                frames += 1;
            }
            Message::Finish => {
                for writer in writers.iter_mut() {
                    writer.finish(output)?;
                }
                complete = frames;
            }
        }
    }
    Ok((frames, complete))
}
