//! Expressions that are printed in LaTeX and valued in floating point, by a route of their own.

use std::collections::BTreeMap;

/// Random numbers, the same every time: SplitMix64 (Steele, Lea & Flood 2014).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    pub fn pick<T: Clone>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())].clone()
    }

    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// An expression.
#[derive(Clone, Debug)]
pub enum T {
    Number(i64, i64),
    Letter(char),
    Pi,
    Euler,
    Sum(Vec<T>),
    Product(Vec<T>),
    Quotient(Box<T>, Box<T>),
    Power(Box<T>, Box<T>),
    Call(&'static str, Box<T>),
}

pub use T::{Euler, Pi};

pub fn n(value: i64) -> T {
    T::Number(value, 1)
}
pub fn r(above: i64, below: i64) -> T {
    T::Number(above, below)
}
pub fn l(letter: char) -> T {
    T::Letter(letter)
}
pub fn sum(terms: &[T]) -> T {
    T::Sum(terms.to_vec())
}
pub fn prod(factors: &[T]) -> T {
    T::Product(factors.to_vec())
}
pub fn minus(t: &T) -> T {
    prod(&[n(-1), t.clone()])
}
pub fn diff(a: &T, b: &T) -> T {
    sum(&[a.clone(), minus(b)])
}
pub fn quot(a: &T, b: &T) -> T {
    T::Quotient(Box::new(a.clone()), Box::new(b.clone()))
}
pub fn pow(a: &T, b: &T) -> T {
    T::Power(Box::new(a.clone()), Box::new(b.clone()))
}
pub fn call(function: &'static str, a: &T) -> T {
    T::Call(function, Box::new(a.clone()))
}
pub fn exp(a: &T) -> T {
    pow(&Euler, a)
}
pub fn sqrt(a: &T) -> T {
    call("sqrt", a)
}
pub fn square(a: &T) -> T {
    pow(a, &n(2))
}

impl T {
    /// The value; not a number where it is not real.
    pub fn value(&self, at: &BTreeMap<char, f64>) -> f64 {
        match self {
            T::Number(a, b) => *a as f64 / *b as f64,
            T::Letter(l) => at[l],
            T::Pi => std::f64::consts::PI,
            T::Euler => std::f64::consts::E,
            T::Sum(terms) => terms.iter().map(|t| t.value(at)).sum(),
            T::Product(factors) => factors.iter().map(|t| t.value(at)).product(),
            T::Quotient(a, b) => a.value(at) / b.value(at),
            T::Power(a, b) => {
                let (a, b) = (a.value(at), b.value(at));
                a.powf(b)
            }
            T::Call(f, a) => {
                let a = a.value(at);
                match *f {
                    "sqrt" => a.sqrt(),
                    "ln" => a.ln(),
                    "abs" => a.abs(),
                    "cos" => a.cos(),
                    "sin" => a.sin(),
                    "tan" => a.tan(),
                    "cot" => 1.0 / a.tan(),
                    "cosh" => a.cosh(),
                    "sinh" => a.sinh(),
                    "tanh" => a.tanh(),
                    other => panic!("{other}"),
                }
            }
        }
    }

    pub fn latex(&self) -> String {
        match self {
            T::Number(a, 1) if *a < 0 => format!("({a})"),
            T::Number(a, 1) => a.to_string(),
            T::Number(a, b) if *a < 0 => format!(r"(-\frac{{{}}}{{{b}}})", -a),
            T::Number(a, b) => format!(r"\frac{{{a}}}{{{b}}}"),
            T::Letter(l) => l.to_string(),
            T::Pi => r"\pi".into(),
            T::Euler => "e".into(),
            T::Sum(terms) => {
                let mut text = String::new();
                for (k, term) in terms.iter().enumerate() {
                    // A leading number -1 is printed as the sign.
                    let (sign, body) = match term {
                        T::Product(f) if f.len() > 1 && matches!(f[0], T::Number(-1, 1)) => {
                            ("-", T::Product(f[1..].to_vec()).factor())
                        }
                        T::Number(a, b) if *a < 0 => ("-", T::Number(-a, *b).latex()),
                        other => (if k > 0 { "+" } else { "" }, other.factor_or_term()),
                    };
                    text += sign;
                    text += &format!(" {body} ");
                }
                text.trim().to_string()
            }
            T::Product(factors) => {
                if let [T::Number(-1, 1), rest @ ..] = factors.as_slice()
                    && !rest.is_empty()
                {
                    return format!("-{}", T::Product(rest.to_vec()).factor());
                }
                let parts: Vec<String> = factors.iter().map(T::factor).collect();
                parts.join(r" \cdot ")
            }
            T::Quotient(a, b) => format!(r"\frac{{{}}}{{{}}}", a.latex(), b.latex()),
            T::Power(a, b) => format!("{}^{{{}}}", a.base(), b.latex()),
            T::Call("sqrt", a) => format!(r"\sqrt{{{}}}", a.latex()),
            T::Call("abs", a) => format!(r"\left|{}\right|", a.latex()),
            T::Call(f, a) => format!(r"\{f}\left({}\right)", a.latex()),
        }
    }

    fn factor_or_term(&self) -> String {
        match self {
            T::Sum(_) => format!(r"\left({}\right)", self.latex()),
            _ => self.latex(),
        }
    }

    fn factor(&self) -> String {
        match self {
            T::Sum(_) => format!(r"\left({}\right)", self.latex()),
            T::Product(f) if matches!(f.first(), Some(T::Number(-1, 1))) => {
                format!(r"\left({}\right)", self.latex())
            }
            T::Call(f, _) if !matches!(*f, "sqrt" | "abs") => {
                format!(r"\left({}\right)", self.latex())
            }
            _ => self.latex(),
        }
    }

    fn base(&self) -> String {
        match self {
            T::Letter(_) | T::Pi | T::Euler => self.latex(),
            T::Number(a, 1) if *a >= 0 => self.latex(),
            _ => format!(r"\left({}\right)", self.latex()),
        }
    }

    fn children(&mut self) -> Vec<&mut T> {
        match self {
            T::Number(..) | T::Letter(_) | T::Pi | T::Euler => Vec::new(),
            T::Sum(all) | T::Product(all) => all.iter_mut().collect(),
            T::Quotient(a, b) | T::Power(a, b) => vec![a, b],
            T::Call(_, a) => vec![a],
        }
    }

    fn size(&self) -> usize {
        let mut copy = self.clone();
        1 + copy.children().into_iter().map(|c| c.size()).sum::<usize>()
    }

    /// Damages the place with this number: a number off by one, a sign, another letter, a lost or
    /// another function.
    fn damage(&mut self, place: &mut usize, random: &mut Random) {
        if *place == 0 {
            *self = match self.clone() {
                T::Number(a, b) => T::Number(a + random.pick(&[-1, 1, 2]), b),
                T::Letter(letter) => {
                    let other = random.pick(&['a', 'b', 'c']);
                    match letter == other {
                        true => prod(&[n(2), T::Letter(letter)]),
                        false => T::Letter(other),
                    }
                }
                T::Call("cos", a) => T::Call("sin", a),
                T::Call("sin", a) => T::Call("cos", a),
                T::Call("abs" | "sqrt" | "ln", a) => *a,
                T::Call("cosh", a) => T::Call("sinh", a),
                T::Call("sinh", a) => T::Call("cosh", a),
                T::Quotient(a, b) => T::Quotient(b, a),
                other => minus(&other),
            };
        }
        let here = *place == 0;
        *place = place.wrapping_sub(1);
        if here {
            return;
        }
        for child in self.children() {
            child.damage(place, random);
            if *place == usize::MAX {
                return;
            }
        }
    }

    pub fn damaged(&self, random: &mut Random) -> T {
        let mut copy = self.clone();
        let mut place = random.below(copy.size());
        copy.damage(&mut place, random);
        copy
    }
}

/// Admitted values of the letters.
pub fn point(random: &mut Random) -> BTreeMap<char, f64> {
    let mut at = BTreeMap::new();
    for letter in ['a', 'b', 'c'] {
        at.insert(letter, 0.2 + 3.0 * random.unit());
    }
    for letter in ['x', 'y', 'z', 'p'] {
        at.insert(letter, 4.0 * random.unit() - 2.0);
    }
    at.insert('h', random.unit());
    at
}

/// Whether two expressions differ by a wide margin at an admitted point where both are real.
pub fn differ(left: &T, right: &T, random: &mut Random) -> bool {
    (0..40).any(|_| {
        let at = point(random);
        let (l, r) = (left.value(&at), right.value(&at));
        l.is_finite() && r.is_finite() && (l - r).abs() > 1e-3 * (1.0 + l.abs().max(r.abs()))
    })
}

/// Whether they agree at all admitted points where both are real, of which there are some.
pub fn agree(left: &T, right: &T, random: &mut Random) -> bool {
    let mut seen = 0;
    for _ in 0..40 {
        let at = point(random);
        let (l, r) = (left.value(&at), right.value(&at));
        if !l.is_finite() || !r.is_finite() {
            continue;
        }
        if (l - r).abs() > 1e-6 * (1.0 + l.abs().max(r.abs())) {
            return false;
        }
        seen += 1;
    }
    seen > 0
}
