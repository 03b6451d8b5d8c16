//! Threads with deep stacks for what recurses as deep as a document's definitions.
//!
//! Definitions may need each other in long chains, and expressions nest; a test or a caller's
//! thread may have two megabytes. The memory is only reserved, not used, unless it is needed.
//!
//! The threads of the pool behind [`in_parallel`] never wait for others outside of it: what runs on them may use the pool
//! again.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::cell::Cell;
use std::sync::OnceLock;
use std::thread;

/// Bytes of stack: a hundred times what the deepest admitted nesting was seen to take.
const STACK: usize = 512 << 20;

thread_local! {
    /// Whether this thread was given a deep stack.
    static DEEP: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work` on a thread with a deep stack; on the caller's own if it is one, or where none can be had.
pub(crate) fn with_deep_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if DEEP.get() {
        return work();
    }
    let mut slot = Some(work);
    let done = thread::scope(|scope| {
        let run = || {
            DEEP.set(true);
            slot.take().map(|work| work())
        };
        match thread::Builder::new()
            .stack_size(STACK)
            .spawn_scoped(scope, run)
        {
            Ok(handle) => match handle.join() {
                Ok(done) => done,
                Err(panic) => std::panic::resume_unwind(panic),
            },
            Err(_) => None,
        }
    });
    match (done, slot) {
        (Some(done), _) => done,
        (None, Some(work)) => work(),
        (None, None) => unreachable!("the work was taken, so it was done"),
    }
}

/// The results of independent work in the order of the items, done by as many threads as there are
/// processors. Where no thread can be had, the caller's own does it.
pub(crate) fn in_parallel<I: Send, T: Send>(
    items: Vec<I>,
    work: impl Fn(I) -> T + Send + Sync,
) -> Vec<T> {
    use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
    match pool() {
        Some(pool) => pool.install(|| {
            // One item at a time: some take a thousand times as long as others.
            items.into_par_iter().with_max_len(1).map(work).collect()
        }),
        None => items.into_iter().map(work).collect(),
    }
}

/// The threads for independent work, with deep stacks.
fn pool() -> Option<&'static ThreadPool> {
    static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();
    let build = || {
        let builder = ThreadPoolBuilder::new().stack_size(STACK);
        builder.start_handler(|_| DEEP.set(true)).build().ok()
    };
    POOL.get_or_init(build).as_ref()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depth(n: u32) -> u32 {
        // The array keeps the frames large and the call from being a loop.
        let frame = [n; 64];
        if n == 0 {
            frame[0]
        } else {
            1 + depth(n - 1) + frame[63].saturating_sub(n)
        }
    }

    #[test]
    fn work_in_parallel_keeps_its_order_and_may_be_nested() {
        let squares = |n: u32| in_parallel((0..n).collect(), |k| depth(10_000) + k * k);
        let nested = in_parallel((0..40).collect(), |n| with_deep_stack(|| squares(n)));
        for (n, found) in nested.iter().enumerate() {
            let expected: Vec<u32> = (0..n as u32).map(|k| 10_000 + k * k).collect();
            assert_eq!(*found, expected);
        }
    }

    #[test]
    fn recursion_that_no_ordinary_thread_survives() {
        assert_eq!(with_deep_stack(|| depth(100_000)), 100_000);
    }
}
