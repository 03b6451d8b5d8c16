//! Threads with deep stacks for what recurses as deep as a document's definitions.
//!
//! Definitions may need each other in long chains, and expressions nest; a test or a caller's
//! thread may have two megabytes. The memory is only reserved, not used, unless it is needed.
//!
//! Units of work are shared out among such threads by a [`Queue`].

use std::cell::Cell;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
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

/// Units of work that threads take one after the other, and what came of them.
pub(crate) struct Queue<T> {
    next: AtomicUsize,
    results: Vec<Mutex<Option<T>>>,
}

impl<T: Send> Queue<T> {
    /// The number of the next unit; none when all are taken.
    pub fn take(&self) -> Option<usize> {
        let unit = self.next.fetch_add(1, Ordering::Relaxed);
        (unit < self.results.len()).then_some(unit)
    }

    /// Keeps what came of a unit.
    pub fn put(&self, unit: usize, result: T) {
        if let Ok(mut slot) = self.results[unit].lock() {
            *slot = Some(result);
        }
    }

    /// The results in the order of the units, none for those that were left undone. As many threads as
    /// are asked for, but no more than there are units, run `worker`; a single one is the caller's own.
    pub fn run(units: usize, threads: usize, worker: impl Fn(&Queue<T>) + Sync) -> Vec<Option<T>> {
        let queue = Queue {
            next: AtomicUsize::new(0),
            results: (0..units).map(|_| Mutex::new(None)).collect(),
        };
        match threads.min(units) {
            0 | 1 => with_deep_stack(|| worker(&queue)),
            threads => thread::scope(|scope| {
                for _ in 0..threads {
                    scope.spawn(|| with_deep_stack(|| worker(&queue)));
                }
            }),
        }
        let results = queue.results.into_iter();
        results.map(|slot| slot.into_inner().ok()?).collect()
    }
}

/// How many threads there are processors for.
pub(crate) fn processors() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// The results of independent work in the order of the items, done by as many threads as there are
/// processors; none for an item whose work was left undone.
pub(crate) fn in_parallel<I: Sync, T: Send>(
    items: &[I],
    work: impl Fn(&I) -> Option<T> + Sync,
) -> Vec<Option<T>> {
    Queue::run(items.len(), processors(), |queue| {
        while let Some(unit) = queue.take() {
            if let Some(result) = work(&items[unit]) {
                queue.put(unit, result);
            }
        }
    })
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
        let upto = |n: u32| (0..n).collect::<Vec<u32>>();
        let squares = |n: u32| in_parallel(&upto(n), |k| Some(depth(10_000) + k * k));
        let nested = in_parallel(&upto(40), |n| Some(with_deep_stack(|| squares(*n))));
        for (n, found) in nested.iter().enumerate() {
            let expected = (0..n as u32).map(|k| Some(10_000 + k * k));
            assert_eq!(*found, Some(expected.collect()));
        }
    }

    #[test]
    fn recursion_that_no_ordinary_thread_survives() {
        assert_eq!(with_deep_stack(|| depth(100_000)), 100_000);
    }
}
