//! An allowance: what all computations of a thread may use together, whether or not they were given a [`Budget`](crate::Budget).
//!
//! Operators such as `+` have no budget and no error to return. Where an allowance is in force they end at
//! its limit nevertheless: the computation unwinds, without the panic hook, to the [`within`] that granted it,
//! as queries that are cancelled do in salsa. No result that was cut short is ever seen. Steps are those of
//! [`Budget`](crate::Budget); bytes are those of one polynomial or of one list of products, and a few times as
//! many those of all polynomials that the work holds at a time. Without an allowance nothing changes.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};

/// What ended a computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exhausted {
    /// The steps were spent.
    Steps,
    /// One object would have taken more memory than allowed.
    Memory,
    /// Somebody asked all computations to [stop](interrupt).
    Interrupted,
}

/// How much is allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Allowance {
    /// Steps in all.
    pub steps: u64,
    /// Bytes of one polynomial or list of products.
    pub bytes: usize,
}

#[derive(Clone, Copy)]
struct Left {
    in_force: bool,
    /// Whether the work goes on where somebody asks all to stop: it puts together what its parts have found.
    patient: bool,
    steps: u64,
    bytes: usize,
    /// What the polynomials of the thread take together when the work begins.
    held: usize,
}

/// All polynomials that work makes may take so many times what one may, and together with those that
/// there were before it so many times.
const MADE: usize = 2;
const ALL: usize = 3;

/// The steps of whoever puts together what is finished once somebody asked to stop.
const LAST: u64 = 2_000_000;

impl Left {
    /// What is left once a part has ended.
    fn after<T>(self, part: &Result<T, Exhausted>) -> Self {
        match part {
            Err(Exhausted::Interrupted) if self.in_force => Left {
                patient: true,
                steps: self.steps.min(LAST),
                ..self
            },
            Err(Exhausted::Interrupted | Exhausted::Steps | Exhausted::Memory) | Ok(_) => self,
        }
    }
}

thread_local! {
    static LEFT: Cell<Left> = const {
        Cell::new(Left { in_force: false, patient: false, steps: u64::MAX, bytes: usize::MAX, held: 0 })
    };
    static HELD: Cell<usize> = const { Cell::new(0) };
}

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Asks whatever runs under an allowance, on any thread, to end: the innermost work on each thread ends at once;
/// what this was a part of has some steps left to put together what is finished, and no other work begins.
pub fn interrupt() {
    INTERRUPTED.store(true, Ordering::Relaxed);
}

/// Runs `work` under an allowance of its own; what it spends counts for an outer one too.
///
/// # Errors
/// What ran out. What `work` was changing is then in the middle of it: the caller puts it right.
pub fn within<T>(allowed: Allowance, work: impl FnOnce() -> T) -> Result<T, Exhausted> {
    run(allowed, false, work)
}

/// The same for work that puts together what its parts find, each [`within`] an allowance of its own: where
/// somebody asks all to stop, these end, and it does not.
///
/// # Errors
/// As [`within`].
pub fn patiently<T>(allowed: Allowance, work: impl FnOnce() -> T) -> Result<T, Exhausted> {
    run(allowed, true, work)
}

fn run<T>(allowed: Allowance, patient: bool, work: impl FnOnce() -> T) -> Result<T, Exhausted> {
    let outer = LEFT.replace(Left {
        in_force: true,
        patient,
        steps: allowed.steps,
        bytes: allowed.bytes,
        held: HELD.get(),
    });
    let result = catch_unwind(AssertUnwindSafe(work));
    let spent = allowed.steps - LEFT.get().steps;
    let outer = Left {
        steps: outer.steps.saturating_sub(spent),
        ..outer
    };
    LEFT.set(outer);
    let result = result.map_err(|payload| match payload.downcast::<Exhausted>() {
        Ok(exhausted) => *exhausted,
        Err(panic) => resume_unwind(panic),
    });
    LEFT.set(outer.after(&result));
    result
}

/// The same, but what is spent counts for no other: the caller counts it in another way.
///
/// # Errors
/// As [`within`].
pub fn apart<T>(allowed: Allowance, work: impl FnOnce() -> T) -> Result<T, Exhausted> {
    let outer = LEFT.get();
    let result = within(allowed, work);
    LEFT.set(outer.after(&result));
    result
}

/// What is left of the allowance that is in force, if one is.
pub fn left() -> Option<Allowance> {
    let left = LEFT.get();
    left.in_force.then_some(Allowance {
        steps: left.steps,
        bytes: left.bytes,
    })
}

/// The steps that are left; all there are where no allowance is in force.
pub fn steps_left() -> u64 {
    LEFT.get().steps
}

/// Counts steps, and ends the computation where they are more than are left.
pub fn spend(steps: u64) {
    let left = LEFT.get();
    if !left.in_force {
        return;
    }
    if INTERRUPTED.load(Ordering::Relaxed) && !left.patient {
        stop(Exhausted::Interrupted);
    }
    match left.steps.checked_sub(steps) {
        Some(steps) => LEFT.set(Left { steps, ..left }),
        None => {
            LEFT.set(Left { steps: 0, ..left });
            stop(match INTERRUPTED.load(Ordering::Relaxed) {
                true => Exhausted::Interrupted,
                false => Exhausted::Steps,
            })
        }
    }
}

/// Ends the computation where so many bytes are more than one object may take.
pub fn reserve(bytes: usize) {
    let left = LEFT.get();
    if left.in_force && bytes > left.bytes {
        stop(Exhausted::Memory);
    }
}

/// The memory of one polynomial in the account of its thread. It says nothing of the polynomial: any two
/// are equal.
pub(crate) struct Held(usize);

impl Held {
    /// Takes so many bytes, and ends the computation where that is too many.
    #[inline]
    pub fn new(bytes: usize) -> Self {
        let held = HELD.get().saturating_add(bytes);
        let left = LEFT.get();
        if left.in_force {
            let made = held.saturating_sub(left.held);
            let most = left.bytes.saturating_mul(ALL);
            if made > left.bytes.saturating_mul(MADE) || bytes > 0 && held > most {
                stop(Exhausted::Memory);
            }
        }
        HELD.set(held);
        Held(bytes)
    }
}

impl Clone for Held {
    fn clone(&self) -> Self {
        Held::new(self.0)
    }
}

impl Drop for Held {
    #[inline]
    fn drop(&mut self) {
        // It may have been taken on another thread.
        HELD.set(HELD.get().saturating_sub(self.0));
    }
}

impl PartialEq for Held {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Held {}

impl std::hash::Hash for Held {
    fn hash<H: std::hash::Hasher>(&self, _: &mut H) {}
}

fn stop(why: Exhausted) -> ! {
    resume_unwind(Box::new(why))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Order, Polynomial, Ring};

    #[test]
    fn operators_end_at_the_allowance_and_the_next_one_is_whole() {
        let ring = Ring::new(["a", "b", "c", "d"], Order::Grevlex).unwrap();
        let f = Polynomial::parse(ring, "a + b + c + d").unwrap();
        let allowed = |steps, bytes| Allowance { steps, bytes };
        let power = |n| f.pow(n).len();
        assert_eq!(
            within(allowed(1_000, 1 << 20), || power(60)),
            Err(Exhausted::Steps)
        );
        assert_eq!(
            within(allowed(u64::MAX, 10_000), || power(60)),
            Err(Exhausted::Memory)
        );
        assert_eq!(within(allowed(1_000_000, 1 << 20), || power(3)), Ok(20));
        let nested = within(allowed(1_000_000, 1 << 20), || {
            let inner = within(allowed(10, 1 << 20), || power(60));
            (inner, steps_left() < 1_000_000, power(3))
        });
        assert_eq!(nested, Ok((Err(Exhausted::Steps), true, 20)));
        let counted_elsewhere = within(allowed(1_000_000, 1 << 20), || {
            let all = left().unwrap();
            let inner = apart(all, || power(10));
            (inner, left() == Some(all))
        });
        assert_eq!(counted_elsewhere, Ok((Ok(286), true)));
        assert_eq!(left(), None);
        assert_eq!(power(10), 286, "nothing is in force afterwards");
        // Each is small, and all of them are not.
        let g = f.pow(10);
        let many = |n: usize| (0..n).map(|_| g.clone()).collect::<Vec<_>>().len();
        let all = allowed(u64::MAX, 1 << 20);
        assert_eq!(within(all, || many(10)), Ok(10));
        assert_eq!(within(all, || many(1_000)), Err(Exhausted::Memory));
        assert_eq!(within(all, || (0..1_000).map(|_| many(1)).sum()), Ok(1_000));
    }
}
