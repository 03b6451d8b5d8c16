//! The rows: one test each.

use super::identities::{ANGLES, EXPONENTIAL, ROOTS, Sides, random_identity, random_turn};
use super::tally;
use super::tree::{Random, agree, differ};

fn equation((left, right): &Sides) -> String {
    format!("{} = {}", left.latex(), right.latex())
}

/// So many true claims and as many damaged ones.
fn generated(seed: u64, count: usize, make: impl Fn(&mut Random) -> Sides) -> Vec<(String, bool)> {
    let mut random = Random(seed);
    let mut claims = Vec::new();
    let mut held = 0;
    while held < count {
        let sides = make(&mut random);
        if agree(&sides.0, &sides.1, &mut random) {
            held += 1;
            claims.push((equation(&sides), true));
        }
    }
    let mut damaged = 0;
    while damaged < count {
        let (left, right) = make(&mut random);
        let sides = match random.below(2) {
            0 => (left.damaged(&mut random), right),
            _ => (left, right.damaged(&mut random)),
        };
        if differ(&sides.0, &sides.1, &mut random) {
            damaged += 1;
            claims.push((equation(&sides), false));
        }
    }
    claims
}

#[test]
fn exponentials_and_logarithms() {
    let claims = generated(1, 100, |r| random_identity(EXPONENTIAL, r));
    tally("", &claims).expect("exponentials", 90);
}

#[test]
fn roots_and_moduli() {
    let claims = generated(2, 100, |r| random_identity(ROOTS, r));
    tally("", &claims).expect("roots", 90);
}

#[test]
fn angles() {
    let claims = generated(3, 100, |r| random_identity(ANGLES, r));
    tally("", &claims).expect("angles", 90);
}

#[test]
fn turns() {
    let claims = generated(4, 100, random_turn);
    tally("", &claims).expect("turns", 90);
}
