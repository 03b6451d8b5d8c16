//! Who asks to stop ends what is under way, and not what puts together what was finished. This test has a process
//! of its own: nothing takes the wish back.

use ratpoly::allowance::{Allowance, Exhausted, apart, interrupt, patiently, within};
use ratpoly::{Order, Polynomial, Ring};

#[test]
fn the_innermost_work_ends_and_what_is_around_it_goes_on() {
    let ring = Ring::new(["a", "b", "c", "d"], Order::Grevlex).expect("a ring");
    let f = Polynomial::parse(ring, "a + b + c + d").expect("a polynomial");
    let power = |n| f.pow(n).len();
    let allowed = Allowance {
        steps: 1_000_000_000,
        bytes: 1 << 24,
    };
    let found = within(allowed, || {
        let finished = within(allowed, || power(3));
        interrupt();
        let cut = within(allowed, || power(3));
        // What was finished is put together; nothing else is begun.
        let together = power(4);
        let next = apart(allowed, || power(3));
        (finished, cut, together, next, power(4))
    });
    let interrupted = Err(Exhausted::Interrupted);
    assert_eq!(found, Ok((Ok(20), interrupted, 35, interrupted, 35)));
    assert_eq!(within(allowed, || power(3)), interrupted);
    // It has some steps for that, and not all.
    let on_and_on = within(allowed, || {
        let _ = within(allowed, || power(3));
        (0..1_000_000).map(|_| power(10)).sum()
    });
    assert_eq!(on_and_on, interrupted);
    assert_eq!(patiently(allowed, || power(10)), Ok(286));
}
