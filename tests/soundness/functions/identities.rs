//! Identities of tables (Abramowitz & Stegun 1964, ch. 3 and 4) with places for expressions.

use super::tree::*;

/// A positive expression and real ones.
pub struct Parts {
    pub a: T,
    pub b: T,
    pub x: T,
    pub y: T,
}

pub fn positive(random: &mut Random) -> T {
    match random.below(8) {
        0 => l('a'),
        1 => l('b'),
        2 => n(2),
        3 => n(3),
        4 => prod(&[n(2), l('c')]),
        5 => sum(&[l('a'), n(1)]),
        6 => prod(&[l('a'), l('b')]),
        _ => square(&l('b')),
    }
}

pub fn real(random: &mut Random) -> T {
    match random.below(9) {
        0 => l('x'),
        1 => l('y'),
        2 => prod(&[n(2), l('x')]),
        3 => quot(&l('x'), &n(2)),
        4 => diff(&l('x'), &l('y')),
        5 => prod(&[l('a'), l('x')]),
        6 => quot(&l('y'), &n(3)),
        7 => sum(&[l('x'), l('z')]),
        _ => minus(&l('z')),
    }
}

/// Both sides of an identity.
pub type Sides = (T, T);

type Identity = fn(&Parts) -> Sides;

/// Exponentials, logarithms, powers.
pub const EXPONENTIAL: &[Identity] = &[
    |p| (exp(&call("ln", &p.a)), p.a.clone()),
    |p| (call("ln", &exp(&p.x)), p.x.clone()),
    |p| (call("ln", &sqrt(&p.a)), prod(&[r(1, 2), call("ln", &p.a)])),
    |p| {
        (
            pow(&p.a, &p.x),
            exp(&prod(&[p.x.clone(), call("ln", &p.a)])),
        )
    },
    |p| {
        (
            pow(&exp(&p.x), &p.y),
            exp(&prod(&[p.x.clone(), p.y.clone()])),
        )
    },
    |p| {
        (
            pow(&pow(&p.a, &p.x), &p.y),
            pow(&p.a, &prod(&[p.x.clone(), p.y.clone()])),
        )
    },
    |p| {
        (
            call("ln", &prod(&[p.a.clone(), p.b.clone()])),
            sum(&[call("ln", &p.a), call("ln", &p.b)]),
        )
    },
    |p| {
        (
            call("ln", &quot(&p.a, &p.b)),
            diff(&call("ln", &p.a), &call("ln", &p.b)),
        )
    },
    |p| {
        (
            call("ln", &pow(&p.a, &p.x)),
            prod(&[p.x.clone(), call("ln", &p.a)]),
        )
    },
    |p| {
        (
            exp(&sum(&[p.x.clone(), p.y.clone()])),
            prod(&[exp(&p.x), exp(&p.y)]),
        )
    },
    |p| (exp(&minus(&p.x)), quot(&n(1), &exp(&p.x))),
    |p| (square(&exp(&quot(&p.x, &n(2)))), exp(&p.x)),
    |p| (pow(&p.a, &call("ln", &p.b)), pow(&p.b, &call("ln", &p.a))),
    |p| {
        (
            pow(&prod(&[p.a.clone(), p.b.clone()]), &p.x),
            prod(&[pow(&p.a, &p.x), pow(&p.b, &p.x)]),
        )
    },
    |p| {
        (
            pow(&p.a, &sum(&[p.x.clone(), n(1)])),
            prod(&[p.a.clone(), pow(&p.a, &p.x)]),
        )
    },
    |p| (pow(&pow(&p.a, &quot(&p.x, &n(3))), &n(3)), pow(&p.a, &p.x)),
    |p| (sqrt(&exp(&p.x)), exp(&quot(&p.x, &n(2)))),
    |p| (sqrt(&pow(&p.a, &p.x)), pow(&p.a, &quot(&p.x, &n(2)))),
    |p| {
        (
            diff(&square(&call("cosh", &p.x)), &square(&call("sinh", &p.x))),
            n(1),
        )
    },
    |p| {
        (
            call("cosh", &sum(&[p.x.clone(), p.y.clone()])),
            sum(&[
                prod(&[call("cosh", &p.x), call("cosh", &p.y)]),
                prod(&[call("sinh", &p.x), call("sinh", &p.y)]),
            ]),
        )
    },
    |p| {
        (
            square(&call("cosh", &quot(&p.x, &n(2)))),
            quot(&sum(&[call("cosh", &p.x), n(1)]), &n(2)),
        )
    },
    |p| {
        (
            call("tanh", &quot(&p.x, &n(2))),
            quot(&call("sinh", &p.x), &sum(&[call("cosh", &p.x), n(1)])),
        )
    },
];

/// Roots and moduli.
pub const ROOTS: &[Identity] = &[
    |p| {
        (
            prod(&[sqrt(&p.a), sqrt(&p.b)]),
            sqrt(&prod(&[p.a.clone(), p.b.clone()])),
        )
    },
    |p| (sqrt(&quot(&p.a, &p.b)), quot(&sqrt(&p.a), &sqrt(&p.b))),
    |p| (sqrt(&square(&p.x)), call("abs", &p.x)),
    |p| {
        (
            sqrt(&square(&call("sin", &p.x))),
            call("abs", &call("sin", &p.x)),
        )
    },
    |p| {
        (
            sqrt(&diff(&n(1), &square(&call("cos", &p.x)))),
            call("abs", &call("sin", &p.x)),
        )
    },
    |p| {
        (
            sqrt(&sum(&[
                p.a.clone(),
                p.b.clone(),
                prod(&[n(2), sqrt(&prod(&[p.a.clone(), p.b.clone()]))]),
            ])),
            sum(&[sqrt(&p.a), sqrt(&p.b)]),
        )
    },
    |p| (square(&call("abs", &p.x)), square(&p.x)),
    |p| {
        (
            call("abs", &prod(&[p.x.clone(), p.y.clone()])),
            prod(&[call("abs", &p.x), call("abs", &p.y)]),
        )
    },
    |p| {
        (
            quot(&n(1), &sum(&[sqrt(&p.a), n(1)])),
            quot(&diff(&sqrt(&p.a), &n(1)), &diff(&p.a, &n(1))),
        )
    },
    |p| {
        (
            sqrt(&sum(&[n(3), prod(&[n(2), sqrt(&n(2))])])),
            sum(&[n(1), minus(&prod(&[n(-1), sqrt(&n(2))]))]).scaled(&p.a, &p.a),
        )
    },
    |p| {
        (
            sqrt(&sum(&[
                square(&p.a),
                p.b.clone(),
                prod(&[n(2), p.a.clone(), sqrt(&p.b)]),
            ])),
            sum(&[p.a.clone(), sqrt(&p.b)]),
        )
    },
    |p| (pow(&p.a, &r(3, 2)), prod(&[p.a.clone(), sqrt(&p.a)])),
    |p| (sqrt(&sqrt(&p.a)), pow(&p.a, &r(1, 4))),
    |p| {
        (
            sqrt(&sum(&[n(5), prod(&[n(2), sqrt(&n(6))])])),
            prod(&[sum(&[sqrt(&n(2)), sqrt(&n(3))]), quot(&p.a, &p.a)]),
        )
    },
    |p| {
        (
            sqrt(&sum(&[n(3), sqrt(&n(5))])),
            prod(&[
                quot(&sum(&[sqrt(&n(10)), sqrt(&n(2))]), &n(2)),
                quot(&p.a, &p.a),
            ]),
        )
    },
    |p| {
        (
            square(&call("abs", &call("cos", &p.x))),
            square(&call("cos", &p.x)),
        )
    },
];

/// Angles.
pub const ANGLES: &[Identity] = &[
    |p| {
        (
            call("sin", &sum(&[p.x.clone(), p.y.clone()])),
            sum(&[
                prod(&[call("sin", &p.x), call("cos", &p.y)]),
                prod(&[call("cos", &p.x), call("sin", &p.y)]),
            ]),
        )
    },
    |p| {
        (
            square(&call("cos", &quot(&p.x, &n(2)))),
            quot(&sum(&[n(1), call("cos", &p.x)]), &n(2)),
        )
    },
    |p| {
        (
            call("tan", &quot(&p.x, &n(2))),
            quot(&call("sin", &p.x), &sum(&[n(1), call("cos", &p.x)])),
        )
    },
    |p| {
        (
            call("cos", &p.x),
            diff(
                &prod(&[n(4), pow(&call("cos", &quot(&p.x, &n(3))), &n(3))]),
                &prod(&[n(3), call("cos", &quot(&p.x, &n(3)))]),
            ),
        )
    },
    |p| {
        (
            call("cos", &sum(&[p.x.clone(), quot(&Pi, &n(3))])),
            diff(
                &prod(&[r(1, 2), call("cos", &p.x)]),
                &prod(&[quot(&sqrt(&n(3)), &n(2)), call("sin", &p.x)]),
            ),
        )
    },
    |p| (call("sin", &diff(&Pi, &p.x)), call("sin", &p.x)),
    |p| {
        (
            call("tan", &sum(&[p.x.clone(), quot(&Pi, &n(4))])),
            quot(
                &sum(&[n(1), call("tan", &p.x)]),
                &diff(&n(1), &call("tan", &p.x)),
            ),
        )
    },
    |p| (call("cot", &p.x), quot(&n(1), &call("tan", &p.x))),
    |p| {
        (
            sum(&[call("cos", &p.x), call("cos", &p.y)]),
            prod(&[
                n(2),
                call("cos", &quot(&sum(&[p.x.clone(), p.y.clone()]), &n(2))),
                call("cos", &quot(&diff(&p.x, &p.y), &n(2))),
            ]),
        )
    },
    |p| {
        (
            pow(&call("sin", &p.x), &n(3)),
            quot(
                &diff(
                    &prod(&[n(3), call("sin", &p.x)]),
                    &call("sin", &prod(&[n(3), p.x.clone()])),
                ),
                &n(4),
            ),
        )
    },
    |p| {
        (
            call("sin", &call("abs", &p.x)),
            prod(&[quot(&call("abs", &p.x), &p.x), call("sin", &p.x)]),
        )
    },
    |p| (call("cos", &call("abs", &p.x)), call("cos", &p.x)),
];

impl T {
    /// Times a and divided by b.
    fn scaled(&self, a: &T, b: &T) -> T {
        prod(&[self.clone(), quot(a, b)])
    }
}

/// Both sides of a random identity of a list in a random context.
pub fn random_identity(all: &[Identity], random: &mut Random) -> Sides {
    let parts = Parts {
        a: positive(random),
        b: positive(random),
        x: real(random),
        y: real(random),
    };
    let identity = random.pick(all);
    let (left, right) = identity(&parts);
    // In a context: the same on both sides, or moved across.
    let extra = match random.below(4) {
        0 => call("cos", &real(random)),
        1 => sqrt(&positive(random)),
        2 => exp(&real(random)),
        _ => real(random),
    };
    match random.below(5) {
        0 => (left, right),
        1 => (sum(&[left, extra.clone()]), sum(&[extra, right])),
        2 => (prod(&[extra.clone(), left]), prod(&[right, extra])),
        3 => (diff(&extra, &left), diff(&extra, &right)),
        _ => (square(&left), square(&right)),
    }
}

/// Products of cosines and sines of rational multiples of pi, and the sums that they are.
pub fn random_turn(random: &mut Random) -> Sides {
    let below = [1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 24];
    let mut turn = || {
        let d = random.pick(&below);
        (random.below(2 * d as usize + 1) as i64 - 1, d)
    };
    let ((m, d), (k, g)) = (turn(), turn());
    let angle = |above: i64, below: i64| quot(&prod(&[n(above), Pi]), &n(below));
    let (plus, less) = (angle(m * g + k * d, d * g), angle(m * g - k * d, d * g));
    let (u, v) = (angle(m, d), angle(k, g));
    match random.below(5) {
        0 => (
            prod(&[call("cos", &u), call("cos", &v)]),
            quot(&sum(&[call("cos", &plus), call("cos", &less)]), &n(2)),
        ),
        1 => (
            prod(&[call("sin", &u), call("sin", &v)]),
            quot(&diff(&call("cos", &less), &call("cos", &plus)), &n(2)),
        ),
        2 => (
            square(&call("sin", &u)),
            diff(&n(1), &square(&call("cos", &u))),
        ),
        3 => (
            call("cos", &quot(&u, &n(2))).squared(),
            quot(&sum(&[n(1), call("cos", &u)]), &n(2)),
        ),
        _ => (
            call("sin", &plus),
            sum(&[
                prod(&[call("sin", &u), call("cos", &v)]),
                prod(&[call("cos", &u), call("sin", &v)]),
            ]),
        ),
    }
}

impl T {
    fn squared(&self) -> T {
        square(self)
    }
}
