//! Whether an equation between two terms is true: the independent evaluator. Rational ones are
//! evaluated exactly, all others in floating point with a wide margin between "equal" and "apart",
//! and what lies within the margin is not used.

use super::complex::Complex;
use super::random::Random;
use super::term::Term;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// What a letter may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    Positive,
    Real,
    Integer,
    Complex,
}

/// The letters that templates share. In every header that declares them they mean this.
pub const LETTERS: &[(&str, Domain)] = &[
    ("a", Domain::Positive),
    ("b", Domain::Positive),
    ("c", Domain::Positive),
    ("g", Domain::Positive),
    (r"\alpha", Domain::Positive),
    (r"\beta", Domain::Positive),
    ("x", Domain::Real),
    ("y", Domain::Real),
    ("z", Domain::Real),
    ("s", Domain::Real),
    (r"\xi", Domain::Real),
    ("p", Domain::Real),
    ("n", Domain::Integer),
    ("m", Domain::Integer),
    ("u", Domain::Complex),
    ("w", Domain::Complex),
];

pub fn domain(letter: &str) -> Domain {
    let found = LETTERS.iter().find(|(name, _)| *name == letter);
    found.unwrap_or_else(|| panic!("{letter} has no domain")).1
}

/// An admissible value of a letter: both signs, zero now and then, where it may have them.
pub fn draw(letter: &str, random: &mut Random) -> Complex {
    match domain(letter) {
        Domain::Positive => Complex::real(0.2 + 2.6 * random.unit()),
        Domain::Real => Complex::real(5.0 * random.unit() - 2.5),
        Domain::Integer => Complex::real(random.between(-4, 4) as f64),
        Domain::Complex => Complex {
            re: 4.0 * random.unit() - 2.0,
            im: 4.0 * random.unit() - 2.0,
        },
    }
}

/// The same exactly; none for what may be complex.
pub fn draw_exact(letter: &str, random: &mut Random) -> Option<BigRational> {
    let quotient = |a: i64, b: i64| BigRational::new(a.into(), b.into());
    match domain(letter) {
        Domain::Positive => Some(quotient(random.between(1, 40), random.between(1, 12))),
        Domain::Real => Some(quotient(random.between(-40, 40), random.between(1, 12))),
        Domain::Integer => Some(quotient(random.between(-9, 9), 1)),
        Domain::Complex => None,
    }
}

fn letters_of(sides: &[&Term]) -> Vec<&'static str> {
    let mut letters = Vec::new();
    for letter in sides.iter().flat_map(|t| t.letters()) {
        if !letters.contains(&letter) {
            letters.push(letter);
        }
    }
    letters
}

fn is_rational(t: &Term) -> bool {
    let rational = !matches!(t, Term::Call(..) | Term::Pi | Term::E | Term::I);
    let integer = |e: &Term| matches!(e, Term::Number(x) if x.is_integer());
    let power = match t {
        Term::Power(_, exponent) => integer(exponent),
        _ => true,
    };
    rational && power && t.children().into_iter().all(is_rational)
}

/// Whether two sides are equal wherever both have a value; none where that is not clear.
pub fn equal(left: &Term, right: &Term, random: &mut Random) -> Option<bool> {
    let letters = letters_of(&[left, right]);
    let complex = letters.iter().any(|l| domain(l) == Domain::Complex);
    if is_rational(left) && is_rational(right) && !complex {
        return equal_exactly(left, right, &letters, random);
    }
    let mut agree = 0;
    let mut unclear = 0;
    for _ in 0..60 {
        let point: Vec<Complex> = letters.iter().map(|l| draw(l, random)).collect();
        let of = |name: &str| letters.iter().position(|l| *l == name).map(|k| point[k]);
        let (Some(a), Some(b)) = (left.value(&of), right.value(&of)) else {
            continue;
        };
        let scale = 1e-3 + a.modulus() + b.modulus();
        let apart = (a - b).modulus() / scale;
        match apart {
            d if d > 1e-3 => return Some(false),
            d if d < 1e-9 => agree += 1,
            _ => unclear += 1,
        }
        if agree >= 16 {
            break;
        }
    }
    let enough = if letters.is_empty() { 1 } else { 10 };
    (agree >= enough && unclear == 0).then_some(true)
}

fn equal_exactly(
    left: &Term,
    right: &Term,
    letters: &[&'static str],
    random: &mut Random,
) -> Option<bool> {
    let mut agree = 0;
    for _ in 0..40 {
        let mut point = Vec::new();
        for letter in letters {
            point.push(draw_exact(letter, random)?);
        }
        let of = |name: &str| {
            let at = letters.iter().position(|l| *l == name)?;
            Some(point[at].clone())
        };
        let (Some(a), Some(b)) = (left.exact(&of), right.exact(&of)) else {
            continue;
        };
        if a != b {
            return Some(false);
        }
        agree += 1;
        if agree >= 14 {
            break;
        }
    }
    (agree >= 8 || letters.is_empty() && agree > 0).then_some(true)
}

/// Whether an equation is true wherever a relation `f = 0` is, and false where it is not; the
/// relation is given by its values. None where no zero of it is found.
pub fn true_given(
    sides: (&Term, &Term),
    relation: &dyn Fn(&[(&'static str, f64)]) -> Option<f64>,
    letters: &[&'static str],
    random: &mut Random,
) -> Option<bool> {
    let mut zeros = 0;
    for _ in 0..40 {
        let mut point: Vec<(&'static str, f64)> =
            letters.iter().map(|l| (*l, draw(l, random).re)).collect();
        let at = random.below(letters.len().max(1));
        if letters.is_empty() {
            return None;
        }
        let (low, high) = match domain(letters[at]) {
            Domain::Positive => (0.01, 12.0),
            Domain::Real => (-12.0, 12.0),
            Domain::Integer | Domain::Complex => continue,
        };
        let mut value = |x: f64| {
            point[at].1 = x;
            relation(&point)
        };
        const STEPS: u32 = 97;
        let step = (high - low) / f64::from(STEPS);
        let mut before: Option<(f64, f64)> = None;
        let mut zero = None;
        for k in 0..=STEPS {
            let x = low + step * f64::from(k);
            let Some(f) = value(x) else { continue };
            if f == 0.0 {
                zero = Some(x);
                break;
            }
            if let Some((x0, f0)) = before
                && f0 * f < 0.0
            {
                let (mut lo, mut hi) = (x0, x);
                for _ in 0..200 {
                    let mid = f64::midpoint(lo, hi);
                    match value(mid) {
                        Some(g) if g * f0 > 0.0 => lo = mid,
                        Some(_) => hi = mid,
                        None => break,
                    }
                }
                zero = Some(f64::midpoint(lo, hi));
                break;
            }
            before = Some((x, f));
        }
        let Some(zero) = zero else { continue };
        point[at].1 = zero;
        let of = |name: &str| {
            let found = point.iter().find(|(l, _)| *l == name);
            found.map(|(_, x)| Complex::real(*x))
        };
        let (Some(a), Some(b)) = (sides.0.value(&of), sides.1.value(&of)) else {
            continue;
        };
        if (a - b).modulus() > 1e-5 * (1.0 + a.modulus() + b.modulus()) {
            return Some(false);
        }
        zeros += 1;
        if zeros >= 4 {
            return Some(true);
        }
    }
    if zeros > 0 {
        return Some(true);
    }
    // A zero may lie where a coarse walk along one letter does not come. The admissible values are a
    // convex set: between two points with different signs there is one. Without an admissible zero it is
    // no relation under which anything is true.
    let real = |l: &&&str| matches!(domain(l), Domain::Positive | Domain::Real);
    if letters.iter().any(|l| !real(&l)) {
        return None;
    }
    let mut ends: [Option<Vec<(&'static str, f64)>>; 2] = [None, None];
    for k in 0..6_000 {
        let scale = [1.0, 0.3, 0.1, 0.03, 3.0][k % 5];
        let draw = |l: &&'static str, random: &mut Random| (*l, scale * draw(l, random).re);
        let point: Vec<_> = letters.iter().map(|l| draw(l, random)).collect();
        let Some(f) = relation(&point).filter(|f| *f != 0.0) else {
            continue;
        };
        ends[usize::from(f > 0.0)] = Some(point);
        if let [Some(low), Some(high)] = &ends {
            return true_between(sides, relation, low, high);
        }
    }
    Some(false)
}

/// Whether an equation is true at a zero of a relation between two points at which it has different signs.
fn true_between(
    sides: (&Term, &Term),
    relation: &dyn Fn(&[(&'static str, f64)]) -> Option<f64>,
    low: &[(&'static str, f64)],
    high: &[(&'static str, f64)],
) -> Option<bool> {
    let at = |t: f64| -> Vec<(&'static str, f64)> {
        let pairs = low.iter().zip(high);
        pairs
            .map(|((l, x), (_, y))| (*l, x + t * (y - x)))
            .collect()
    };
    let (mut lo, mut hi) = (0.0, 1.0);
    for _ in 0..200 {
        let mid = f64::midpoint(lo, hi);
        match relation(&at(mid))? {
            f if f > 0.0 => hi = mid,
            _ => lo = mid,
        }
    }
    let point = at(f64::midpoint(lo, hi));
    let of = |name: &str| {
        let found = point.iter().find(|(l, _)| *l == name);
        found.map(|(_, x)| Complex::real(*x))
    };
    let (a, b) = (sides.0.value(&of)?, sides.1.value(&of)?);
    Some((a - b).modulus() <= 1e-5 * (1.0 + a.modulus() + b.modulus()))
}

/// A rational as a float.
pub fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// A relation whose zeros lie in a narrow part of the admissible values, and one that has none.
#[test]
fn zeros_of_a_relation_are_found_where_they_are_few() {
    use super::term::{n, v};
    let relation = |point: &[(&'static str, f64)]| {
        let of = |name: &str| point.iter().find(|(l, _)| *l == name).map(|(_, x)| *x);
        let (x, c, s) = (of("x")?, of("c")?, of("s")?);
        Some(x - 3.0 * x * x - c * s * s)
    };
    let none = |point: &[(&'static str, f64)]| {
        let of = |name: &str| point.iter().find(|(l, _)| *l == name).map(|(_, x)| *x);
        let (x, s) = (of("x")?, of("s")?);
        Some(x * x + s * s + 1.0)
    };
    let off = v("x") - n(3) * v("x").pow(2) - v("c") * v("s").pow(2);
    for seed in 0..40 {
        let mut random = Random::new(seed, "zeros");
        let (left, right) = (v("x") + off.clone() * v("s"), v("x"));
        let letters = ["x", "c", "s"];
        let found = true_given((&left, &right), &relation, &letters, &mut random);
        assert_eq!(found, Some(true), "seed {seed}");
        let wrong = v("x") + off.clone() * v("s") + n(1);
        let found = true_given((&wrong, &right), &relation, &letters, &mut random);
        assert_eq!(found, Some(false), "seed {seed}");
        let found = true_given((&left, &right), &none, &letters, &mut random);
        assert_eq!(found, Some(false), "seed {seed}");
    }
}
