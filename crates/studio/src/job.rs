//! Computations for the page: how many run at once is limited, and how long a request waits for one.

use std::sync::Arc;
use std::time::Duration;

use oaktwin::diagnostic::{Opt, with_style};
use oaktwin::interrupt;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::protocol::Failure;
use crate::studio::Studio;
pub(crate) use crate::task::Job;

/// How long a request waits for its answer once it is computed, and what to do if that is not enough.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    pub(crate) time: Duration,
    pub(crate) remedy: &'static str,
}

/// Rendering and measuring a frame.
pub(crate) const FRAME: Budget = Budget {
    time: Duration::from_secs(120),
    remedy: "choose a smaller size or a faster engine",
};
/// Making the mesh of the 3D view.
pub(crate) const VIEW: Budget = Budget {
    time: Duration::from_secs(60),
    remedy: "drop a scene with fewer triangles",
};
/// Reading a dropped file, or making a file to be saved.
pub(crate) const FILE: Budget = Budget {
    time: Duration::from_secs(300),
    remedy: "use the command line, which has no limit of time",
};
/// Measuring an accuracy.
pub(crate) const ACCURACY: Budget = Budget {
    time: Duration::from_secs(600),
    remedy: "choose a faster engine, or use `oaktwin accuracy`, which has no limit of time",
};
/// Measuring coverages.
pub(crate) const COVERAGE: Budget = Budget {
    time: Duration::from_secs(1800),
    remedy: "choose fewer poses, or use `oaktwin coverage`, which has no limit of time",
};

/// Computes for a request as soon as fewer than a few others do, without blocking other requests. Options in messages are
/// spelled as on the command line.
pub(crate) async fn run<T: Send + 'static>(
    studio: &Arc<Studio>,
    budget: Budget,
    compute: impl FnOnce(&Studio, &Job) -> Result<T, Failure> + Send + 'static,
) -> Result<T, Failure> {
    run_in(studio, &studio.jobs, budget, compute).await
}

/// The same, counted by a semaphore.
pub(crate) async fn run_in<T: Send + 'static>(
    studio: &Arc<Studio>,
    counted: &Arc<Semaphore>,
    budget: Budget,
    compute: impl FnOnce(&Studio, &Job) -> Result<T, Failure> + Send + 'static,
) -> Result<T, Failure> {
    // Never closed.
    let permit: Option<OwnedSemaphorePermit> = Arc::clone(counted).acquire_owned().await.ok();
    let waiting = Arc::new(());
    let job = Job {
        waits: Arc::downgrade(&waiting),
        stop: studio.stopping(),
    };
    let studio = Arc::clone(studio);
    let task = tokio::task::spawn_blocking(move || {
        let result = with_style(flag, || job.check().and_then(|()| compute(&studio, &job)));
        // A computation that nobody waits for counts until it ends.
        drop(permit);
        result
    });
    let failed = || {
        Err(Failure::from(
            "the computation failed; please report this".to_owned(),
        ))
    };
    let ended = tokio::time::timeout(budget.time, task).await;
    drop(waiting);
    match ended {
        Ok(result) => result.unwrap_or_else(|_| failed()),
        Err(_) => Err(Failure::from(format!(
            "the answer takes longer than {} s; {}",
            budget.time.as_secs(),
            budget.remedy
        ))),
    }
}

impl Job {
    /// Computes [interruptibly](Self::interruptibly), and returns an error instead of what was interrupted.
    pub(crate) fn in_full<T: Send>(
        &self,
        compute: impl FnOnce() -> Result<T, Failure> + Send,
    ) -> Result<T, Failure> {
        let made = self.interruptibly(compute)?;
        self.check().map(|()| made)
    }

    /// Computes in threads of its own, whose loops end as soon as nobody waits for the result, which is arbitrary then. Previews, which have
    /// the threads of the process, do not wait for it.
    pub(crate) fn interruptibly<T: Send>(&self, compute: impl FnOnce() -> T + Send) -> T {
        let wanted = self.waits.clone();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(rayon::current_num_threads())
            .start_handler(move |_| interrupt::watch(wanted.clone()))
            .build();
        match pool {
            Ok(pool) => pool.install(|| with_style(flag, compute)),
            Err(_) => compute(),
        }
    }
}

fn flag(option: &Opt) -> String {
    match option.is_command() {
        true => format!("`oaktwin {}`", option.name()),
        false => format!("--{}", option.name()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::studio::tests::studio;

    const SHORT: Budget = Budget {
        time: Duration::from_millis(10),
        remedy: "ask for less",
    };

    fn wait<T>(future: impl Future<Output = T>) -> T {
        let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build();
        runtime.unwrap().block_on(future)
    }

    /// Computes until nobody waits, and then counts.
    fn endless(_: &Studio, job: &Job) -> Result<(), Failure> {
        while job.watch().is_continue() {
            std::thread::sleep(Duration::from_millis(1));
        }
        job.check()
    }

    #[test]
    fn a_job_that_exceeds_its_time_is_an_error_and_ends() {
        wait(async {
            let studio = studio();
            let before = studio.jobs.available_permits();
            let error = run(&studio, SHORT, endless).await.unwrap_err().error;
            assert_eq!(error, "the answer takes longer than 0 s; ask for less");
            // All of them are available again once the loop has ended.
            let all = u32::try_from(before).unwrap();
            drop(studio.jobs.acquire_many(all).await.unwrap());
            assert_eq!(run(&studio, FILE, |_, _| Ok(7)).await.unwrap(), 7);
        });
    }

    #[test]
    fn a_job_whose_client_leaves_or_whose_server_stops_ends() {
        wait(async {
            let studio = studio();
            let all = u32::try_from(studio.jobs.available_permits()).unwrap();
            let left = tokio::time::timeout(SHORT.time, run(&studio, FILE, endless));
            assert!(left.await.is_err());
            drop(studio.jobs.acquire_many(all).await.unwrap());
            studio.stop();
            assert!(run(&studio, FILE, endless).await.is_err());
        });
    }

    #[test]
    fn a_job_that_panics_is_an_error() {
        wait(async {
            let studio = studio();
            let panics = |_: &Studio, _: &Job| -> Result<(), Failure> { panic!("a bug") };
            let error = run(&studio, FILE, panics).await.unwrap_err().error;
            assert!(error.contains("please report this"), "{error}");
            assert_eq!(run(&studio, FILE, |_, _| Ok(7)).await.unwrap(), 7);
        });
    }
}
