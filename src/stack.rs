//! A thread with a deep stack for what recurses as deep as a document's definitions.
//!
//! Definitions may need each other in long chains, and expressions nest; a test or a caller's
//! thread may have two megabytes. The memory is only reserved, not used, unless it is needed.

use std::thread;

/// Bytes of stack: a hundred times what the deepest admitted nesting was seen to take.
const STACK: usize = 512 << 20;

/// Runs `work` on a thread with a deep stack; on the caller's own where none can be had.
pub(crate) fn with_deep_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let mut slot = Some(work);
    let done = thread::scope(|scope| {
        let run = || slot.take().map(|work| work());
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
    fn recursion_that_no_ordinary_thread_survives() {
        assert_eq!(with_deep_stack(|| depth(100_000)), 100_000);
    }
}
