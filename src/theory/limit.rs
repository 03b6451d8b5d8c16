//! Limits for a positive letter that goes to zero or grows beyond all bounds, by leading orders.
//!
//! Numerator and denominator are sums of terms c e^{u(x)} x^e (ln x)^k with c, e free of x and u a
//! polynomial in x; the scale of these orders is linear (Hardy, *Orders of Infinity*, 1910), and the
//! term of the highest order decides. Cosines and sines of what grows are bounded and have no
//! limit. What is analytic at zero in x, or in 1/x, is expanded there: the first derivative that does
//! not vanish is the leading one.
//!
//! Invariants: a limit that is found is the limit wherever what is listed beside it does not vanish;
//! two limits are limits along two ways to the same end. Nothing is concluded from values at points.

use crate::functions::{FunctionLetter, FunctionTable, Impossible, Possible, TermList};
use num_rational::BigRational;
use num_traits::{One, Zero};
use ratpoly::{Polynomial, RationalFunction, RegionSign};
use std::cmp::Ordering;

/// So many derivatives are looked at for one that does not vanish.
const DERIVATIVES: usize = 8;

/// Where a positive letter goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Towards {
    /// Zero, from above.
    Zero,
    /// Infinity.
    Infinity,
}

/// What becomes of an element there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Limit {
    /// It tends to an element.
    To(RationalFunction),
    /// It grows beyond every bound, to plus infinity.
    Infinite,
    /// It falls below every bound.
    MinusInfinite,
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Behaviour {
    /// The limit, wherever these polynomials do not vanish.
    Tends(Limit, Vec<Polynomial>),
    /// It leaves every bound, with a sign that depends on the letters, wherever these do not vanish.
    Unbounded(Vec<Polynomial>),
    /// Two limits on two ways.
    Two(Limit, Limit),
}

/// What is known of the letters that do not move.
pub trait Known {
    /// The sign for all admissible values.
    fn sign(&self, f: &RationalFunction) -> RegionSign;
    /// Whether a function certainly is not zero for some admissible values.
    fn differs_from_zero(&self, f: &RationalFunction) -> bool;
}

/// The limit of an element as a positive letter goes to zero or infinity.
pub struct Search<'a> {
    /// What the letters of functions stand for.
    pub table: &'a FunctionTable,
    /// What is known of the other letters.
    pub known: &'a dyn Known,
    /// The letter that moves; it is positive.
    pub letter: usize,
    /// Where it goes.
    pub towards: Towards,
    /// Whether it takes all real numbers on its way.
    pub continuous: bool,
}

/// The order of a term: `e^exponential x^power (ln x)^logarithms`.
#[derive(Clone, PartialEq)]
struct Order {
    exponential: RationalFunction,
    power: RationalFunction,
    logarithms: i64,
}

/// The terms of the highest order, without it.
struct Leading {
    coefficient: RationalFunction,
    order: Order,
}

/// What a letter that depends on the moving one contributes to the order of a term.
enum Growth {
    Power(RationalFunction),
    Exponential(RationalFunction),
    Logarithm,
    /// Bounded, without a limit: the cosine or sine of an angle that grows.
    Oscillates,
}

fn unsupported(what: &str) -> Impossible {
    Impossible::unsupported(what)
}

impl Search<'_> {
    /// What becomes of an element.
    ///
    /// # Errors
    /// Where other functions of the letter occur, or a sign is not known.
    pub fn behaviour(&self, f: &RationalFunction) -> Possible<Behaviour> {
        if f.is_zero() {
            return Ok(Behaviour::Tends(Limit::To(f.clone()), Vec::new()));
        }
        match self.by_orders(f) {
            Ok(found) => Ok(found),
            Err(by_orders) => match self.moving_functions(f).is_empty() {
                true => Err(by_orders),
                false => self.by_derivatives(f).map_err(|by_derivatives| {
                    match by_derivatives == Impossible::NoLetter {
                        true => by_derivatives,
                        false => by_orders,
                    }
                }),
            },
        }
    }

    fn variable(&self) -> RationalFunction {
        RationalFunction::variable(self.table.ring(), self.letter)
    }

    fn number(&self, n: i64) -> RationalFunction {
        RationalFunction::constant(self.table.ring(), BigRational::from_integer(n.into()))
    }

    fn moves(&self, f: &RationalFunction) -> bool {
        self.table.letters_behind(f).contains(&self.letter)
    }

    /// The letters of functions of the moving one.
    fn moving_functions(&self, f: &RationalFunction) -> Vec<usize> {
        let mut occurring = f.numerator().variables_occurring();
        occurring.extend(f.denominator().variables_occurring());
        occurring.sort_unstable();
        occurring.dedup();
        occurring.retain(|l| {
            *l != self.letter
                && self.table.meaning(*l).is_some()
                && self.moves(&RationalFunction::variable(self.table.ring(), *l))
        });
        occurring
    }

    fn by_orders(&self, f: &RationalFunction) -> Possible<Behaviour> {
        let growths = self
            .moving_functions(f)
            .into_iter()
            .map(|letter| Ok((letter, self.growth(letter)?)))
            .collect::<Possible<Vec<_>>>()?;
        let above = self.leading(f.numerator(), &growths)?;
        let below = self.leading(f.denominator(), &growths)?;
        let oscillating: Vec<usize> = growths
            .iter()
            .filter(|(_, g)| matches!(g, Growth::Oscillates))
            .map(|(letter, _)| *letter)
            .collect();
        let oscillates = |f: &RationalFunction| {
            let occurring = f.numerator().variables_occurring();
            occurring.iter().any(|l| oscillating.contains(l))
        };
        if oscillates(&below.coefficient) {
            return Err(unsupported("a limit of a quotient by what oscillates"));
        }
        let order = self.compare(&above.order, &below.order)?;
        if oscillates(&above.coefficient) && order != Ordering::Less {
            return self.oscillation(&above.coefficient, &below.coefficient, order);
        }
        let mut logarithms = above.order.logarithms - below.order.logarithms;
        if self.towards == Towards::Infinity {
            logarithms = 0;
        }
        self.of_orders(
            order,
            &above.coefficient,
            &below.coefficient,
            logarithms % 2 != 0,
        )
    }

    /// The behaviour of a quotient whose leading terms have this order to each other.
    fn of_orders(
        &self,
        order: Ordering,
        above: &RationalFunction,
        below: &RationalFunction,
        negated: bool,
    ) -> Possible<Behaviour> {
        let mut conditions = Vec::new();
        self.nonzero(below, &mut conditions)?;
        if order == Ordering::Less {
            let zero = RationalFunction::zero(self.table.ring());
            return Ok(Behaviour::Tends(Limit::To(zero), conditions));
        }
        let mut quotient = self.table.reduce(above.checked_div(below)?);
        if order == Ordering::Equal && !negated {
            return Ok(Behaviour::Tends(Limit::To(quotient), conditions));
        }
        if negated {
            quotient = -&quotient;
        }
        let limit = match self.known.sign(&quotient) {
            RegionSign::Positive => Some(Limit::Infinite),
            RegionSign::Negative => Some(Limit::MinusInfinite),
            RegionSign::NonNegative => {
                self.nonzero(above, &mut conditions)?;
                Some(Limit::Infinite)
            }
            RegionSign::NonPositive => {
                self.nonzero(above, &mut conditions)?;
                Some(Limit::MinusInfinite)
            }
            RegionSign::Zero | RegionSign::Changes { .. } | RegionSign::Undecided => {
                self.nonzero(above, &mut conditions)?;
                None
            }
        };
        Ok(match limit {
            Some(limit) => Behaviour::Tends(limit, conditions),
            None => Behaviour::Unbounded(conditions),
        })
    }

    /// Adds to the conditions that a coefficient does not vanish, unless it never does.
    fn nonzero(&self, f: &RationalFunction, conditions: &mut Vec<Polynomial>) -> Possible<()> {
        match self.known.sign(f) {
            RegionSign::Positive | RegionSign::Negative => Ok(()),
            RegionSign::Zero => Err(unsupported("a limit whose leading term vanishes")),
            RegionSign::NonNegative
            | RegionSign::NonPositive
            | RegionSign::Changes { .. }
            | RegionSign::Undecided => {
                if !self.known.differs_from_zero(f) {
                    return Err(unsupported("a limit whose leading term may vanish"));
                }
                conditions.push(f.numerator().clone());
                Ok(())
            }
        }
    }

    fn growth(&self, letter: usize) -> Possible<Growth> {
        let other =
            || unsupported("a limit of other functions than powers, exponentials and logarithms");
        let polynomial = |u: &RationalFunction| {
            let free = !self.moves(&RationalFunction::from(u.denominator().clone()));
            free && self.moving_functions(u).is_empty() && self.towards == Towards::Infinity
        };
        let itself = Polynomial::variable(self.table.ring(), self.letter);
        match self.table.meaning(letter) {
            Some(FunctionLetter::Power(base, exponent))
                if base == itself && !self.moves(&exponent) =>
            {
                Ok(Growth::Power(exponent))
            }
            Some(FunctionLetter::Root(radicand)) if radicand == itself => Ok(Growth::Power(
                RationalFunction::constant(self.table.ring(), BigRational::new(1.into(), 2.into())),
            )),
            Some(FunctionLetter::Exponential(u)) if polynomial(&u) => Ok(Growth::Exponential(u)),
            Some(FunctionLetter::Logarithm(p)) if p == itself => Ok(Growth::Logarithm),
            Some(FunctionLetter::Cosine(u) | FunctionLetter::Sine(u, _)) if polynomial(&u) => {
                // The angle must leave every bound.
                let parts = u.numerator().coefficients_in(self.letter);
                let leading = parts.last().cloned().ok_or(Impossible::DivisionByZero)?;
                match self.known.sign(&leading.into()) {
                    RegionSign::Positive | RegionSign::Negative => Ok(Growth::Oscillates),
                    RegionSign::Zero
                    | RegionSign::NonNegative
                    | RegionSign::NonPositive
                    | RegionSign::Changes { .. }
                    | RegionSign::Undecided => Err(other()),
                }
            }
            Some(
                FunctionLetter::Power(..)
                | FunctionLetter::Exponential(_)
                | FunctionLetter::Logarithm(_)
                | FunctionLetter::Cosine(_)
                | FunctionLetter::Sine(..)
                | FunctionLetter::Root(_)
                | FunctionLetter::Pi
                | FunctionLetter::ImaginaryUnit
                | FunctionLetter::Dirac(_)
                | FunctionLetter::Bound { .. },
            )
            | None => Err(other()),
        }
    }

    /// The terms of the highest order of a polynomial.
    fn leading(&self, p: &Polynomial, growths: &[(usize, Growth)]) -> Possible<Leading> {
        let mut groups: Vec<(Order, TermList)> = Vec::new();
        for (monomial, c) in p.terms() {
            let mut rest = monomial.exponents().to_vec();
            let mut order = Order {
                exponential: RationalFunction::zero(self.table.ring()),
                power: self.number(std::mem::take(&mut rest[self.letter]).into()),
                logarithms: 0,
            };
            for (letter, growth) in growths {
                let times = i64::from(rest[*letter]);
                match growth {
                    Growth::Power(e) => order.power = &order.power + &(&self.number(times) * e),
                    Growth::Exponential(u) => {
                        order.exponential = &order.exponential + &(&self.number(times) * u);
                    }
                    Growth::Logarithm => order.logarithms += times,
                    Growth::Oscillates => continue,
                }
                rest[*letter] = 0;
            }
            match groups.iter_mut().find(|(known, _)| *known == order) {
                Some((_, terms)) => terms.push((rest, c)),
                None => groups.push((order, vec![(rest, c)])),
            }
        }
        let mut best: Option<(Order, TermList)> = None;
        for (order, terms) in groups {
            let higher = match &best {
                None => true,
                Some((known, _)) => match self.compare(&order, known)? {
                    Ordering::Greater => true,
                    Ordering::Less => false,
                    Ordering::Equal => {
                        return Err(unsupported("a limit of terms of one order"));
                    }
                },
            };
            if higher {
                best = Some((order, terms));
            }
        }
        let (order, terms) = best.ok_or(Impossible::DivisionByZero)?;
        let coefficient = Polynomial::from_terms(self.table.ring(), terms)?;
        Ok(Leading {
            coefficient: coefficient.into(),
            order,
        })
    }

    /// Which of two orders is the higher one where the letter goes.
    fn compare(&self, a: &Order, b: &Order) -> Possible<Ordering> {
        let exponent = &a.exponential - &b.exponential;
        if !exponent.is_zero() {
            // Exponentials count for a letter that grows only.
            let below = self.definite(&exponent.denominator().clone().into())?;
            for part in exponent
                .numerator()
                .coefficients_in(self.letter)
                .iter()
                .skip(1)
                .rev()
            {
                if part.is_zero() {
                    continue;
                }
                let above = self.definite(&part.clone().into())?;
                return Ok(if below == Ordering::Less {
                    above.reverse()
                } else {
                    above
                });
            }
            return Err(unsupported("a limit that depends on an exponent"));
        }
        let power = &a.power - &b.power;
        if !power.is_zero() {
            let sign = self.definite(&power)?;
            return Ok(match self.towards {
                Towards::Infinity => sign,
                Towards::Zero => sign.reverse(),
            });
        }
        Ok(a.logarithms.cmp(&b.logarithms))
    }

    /// A sign that is the same for all values, and not zero.
    fn definite(&self, f: &RationalFunction) -> Possible<Ordering> {
        match self.known.sign(f) {
            RegionSign::Positive => Ok(Ordering::Greater),
            RegionSign::Negative => Ok(Ordering::Less),
            RegionSign::Zero
            | RegionSign::NonNegative
            | RegionSign::NonPositive
            | RegionSign::Changes { .. }
            | RegionSign::Undecided => Err(unsupported(
                "a limit that depends on the sign of an exponent",
            )),
        }
    }

    /// What oscillates with one angle that grows: the values at some angles, each of which is taken
    /// again and again.
    fn oscillation(
        &self,
        above: &RationalFunction,
        below: &RationalFunction,
        order: Ordering,
    ) -> Possible<Behaviour> {
        let several = || unsupported("a limit of what oscillates");
        if !self.continuous {
            return Err(several());
        }
        let mut angle: Option<RationalFunction> = None;
        let (mut cosine, mut sine) = (None, None);
        for letter in self.moving_functions(above) {
            let own = match self.table.meaning(letter) {
                Some(FunctionLetter::Cosine(u)) => {
                    cosine = Some(letter);
                    u
                }
                Some(FunctionLetter::Sine(u, of)) => {
                    (sine, cosine) = (Some(letter), Some(of));
                    u
                }
                _ => return Err(several()),
            };
            if angle.get_or_insert_with(|| own.clone()) != &own {
                return Err(several());
            }
        }
        let fraction = |n: i64, d: i64| BigRational::new(n.into(), d.into());
        let one = BigRational::one;
        let zero = BigRational::zero;
        let mut values = Vec::new();
        for (c, s) in [
            (one(), zero()),
            (-one(), zero()),
            (zero(), one()),
            (zero(), -one()),
            (fraction(3, 5), fraction(4, 5)),
        ] {
            let image = |letter: Option<usize>, value: BigRational| {
                letter.map(|l| (l, RationalFunction::constant(self.table.ring(), value)))
            };
            let images: Vec<_> = image(cosine, c).into_iter().chain(image(sine, s)).collect();
            let top = above.substitute(&images)?;
            let value = self.table.reduce(top.checked_div(below)?);
            values.push(value);
        }
        let mut conditions = Vec::new();
        self.nonzero(below, &mut conditions)?;
        if order == Ordering::Greater {
            let signed = |wanted: &RegionSign| values.iter().any(|v| self.known.sign(v) == *wanted);
            if signed(&RegionSign::Positive) && signed(&RegionSign::Negative) {
                return Ok(Behaviour::Two(Limit::Infinite, Limit::MinusInfinite));
            }
            return Err(several());
        }
        let (first, rest) = values.split_first().ok_or_else(several)?;
        let other = rest
            .iter()
            .find(|v| self.known.differs_from_zero(&(*v - first)));
        match other {
            Some(other) => Ok(Behaviour::Two(
                Limit::To(first.clone()),
                Limit::To(other.clone()),
            )),
            None => Err(several()),
        }
    }

    /// By the first derivatives that do not vanish at zero, for x or 1/x.
    fn by_derivatives(&self, f: &RationalFunction) -> Possible<Behaviour> {
        let f = match self.towards {
            Towards::Zero => f.clone(),
            Towards::Infinity => self
                .table
                .substitute(f, &[(self.letter, self.variable().inverse()?)])?,
        };
        let mut conditions = Vec::new();
        for letter in self.moving_functions(&f) {
            self.analytic(letter, &mut conditions)?;
        }
        let (n, above) = self.first_derivative(f.numerator())?;
        let (d, below) = self.first_derivative(f.denominator())?;
        match self.of_orders(d.cmp(&n), &above, &below, false)? {
            Behaviour::Tends(limit, more) => {
                conditions.extend(more);
                Ok(Behaviour::Tends(limit, conditions))
            }
            Behaviour::Unbounded(more) => {
                conditions.extend(more);
                Ok(Behaviour::Unbounded(conditions))
            }
            two @ Behaviour::Two(..) => Ok(two),
        }
    }

    /// Sees to it that a function is analytic where the letter is zero.
    fn analytic(&self, letter: usize, conditions: &mut Vec<Polynomial>) -> Possible<()> {
        let positive = |p: &Polynomial| {
            let there = self.at_zero(&p.clone().into())?;
            match self.known.sign(&there) {
                RegionSign::Positive => Ok(()),
                RegionSign::Zero
                | RegionSign::Negative
                | RegionSign::NonNegative
                | RegionSign::NonPositive
                | RegionSign::Changes { .. }
                | RegionSign::Undecided => Err(unsupported("a limit at a branch point")),
            }
        };
        let arguments: Vec<RationalFunction> = match self.table.meaning(letter) {
            Some(
                FunctionLetter::Exponential(u)
                | FunctionLetter::Cosine(u)
                | FunctionLetter::Sine(u, _),
            ) => vec![u],
            Some(FunctionLetter::Root(p) | FunctionLetter::Logarithm(p)) => {
                positive(&p)?;
                vec![p.into()]
            }
            Some(FunctionLetter::Power(base, exponent)) => {
                positive(&base)?;
                vec![base.into(), exponent]
            }
            Some(
                FunctionLetter::Pi
                | FunctionLetter::ImaginaryUnit
                | FunctionLetter::Dirac(_)
                | FunctionLetter::Bound { .. },
            )
            | None => return Err(unsupported("a limit of a distribution")),
        };
        for argument in arguments {
            let below = self.at_zero(&argument.denominator().clone().into())?;
            if below.is_zero() {
                return Err(unsupported("a limit at an essential singularity"));
            }
            self.nonzero(&below, conditions)?;
            for inner in self.moving_functions(&argument) {
                self.analytic(inner, conditions)?;
            }
        }
        Ok(())
    }

    fn at_zero(&self, f: &RationalFunction) -> Possible<RationalFunction> {
        let zero = RationalFunction::zero(self.table.ring());
        self.table.substitute(f, &[(self.letter, zero)])
    }

    /// The order of the first derivative at zero that is not zero, and the Taylor coefficient.
    fn first_derivative(&self, p: &Polynomial) -> Possible<(usize, RationalFunction)> {
        let mut derivative = RationalFunction::from(p.clone());
        let mut factorial = self.number(1);
        for k in 0..=DERIVATIVES {
            let there = self.at_zero(&derivative)?;
            if !there.is_zero() {
                return Ok((k, there.checked_div(&factorial)?));
            }
            derivative = self.table.derivative(&derivative, self.letter)?;
            factorial = &factorial * &self.number(k as i64 + 1);
        }
        Err(unsupported("a limit whose leading order is not reached"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratpoly::{Budget, Order, Region, Ring, sign_of_quotient_on};

    /// All letters are positive.
    struct Positive;

    impl Known for Positive {
        fn sign(&self, f: &RationalFunction) -> RegionSign {
            let region = Region::positive_orthant(f.ring().len());
            sign_of_quotient_on(f, &region, &Budget::default()).unwrap_or(RegionSign::Undecided)
        }
        fn differs_from_zero(&self, f: &RationalFunction) -> bool {
            !f.is_zero()
        }
    }

    #[test]
    fn powers_with_letters_in_the_exponent() {
        let ring = Ring::new(["x", "w", "c", "r0", "r1"], Order::Grevlex).unwrap();
        let table = FunctionTable::new(ring, vec![crate::model::range::Range::positive(); 3]);
        let [x, w, c] = [0, 1, 2].map(|l| RationalFunction::variable(ring, l));
        let fall = c.checked_div(&table.power(&x, &w).unwrap()).unwrap();
        let behaviour = |f: &RationalFunction, towards| {
            let search = Search {
                table: &table,
                known: &Positive,
                letter: 0,
                towards,
                continuous: true,
            };
            search.behaviour(f)
        };
        let at = |f: &RationalFunction, towards| match behaviour(f, towards) {
            Ok(Behaviour::Tends(limit, conditions)) if conditions.is_empty() => limit,
            other => panic!("{other:?}"),
        };
        assert_eq!(at(&fall, Towards::Zero), Limit::Infinite);
        assert_eq!(
            at(&fall, Towards::Infinity),
            Limit::To(RationalFunction::zero(ring))
        );
        // Whether x^(1 - w) grows depends on w.
        assert!(behaviour(&(&fall * &x), Towards::Infinity).is_err());
        let spectrum = RationalFunction::parse(ring, "c/(c^2 + x^2)").unwrap();
        assert_eq!(
            at(&(&(&x * &x) * &spectrum), Towards::Infinity),
            Limit::To(c.clone())
        );
        assert_eq!(
            at(&spectrum, Towards::Zero),
            Limit::To(c.inverse().unwrap())
        );
        assert_eq!(at(&-&(&x * &c), Towards::Infinity), Limit::MinusInfinite);
        // At w = c it tends to one.
        let f = RationalFunction::parse(ring, "1/((w - c)*x + 1)").unwrap();
        let found = behaviour(&f, Towards::Infinity).unwrap();
        assert!(
            matches!(found, Behaviour::Tends(Limit::To(_), conditions) if conditions.len() == 1)
        );
    }
}
