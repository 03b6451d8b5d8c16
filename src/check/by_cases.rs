//! Claims by cases: a real expression is positive, negative or zero, and in each case the claim is seen.
//!
//! What is split by is linear in a declared real letter: where p = s x + r is positive, x is (t - r)/s with a
//! new letter t > 0, where it is negative (-t - r)/s, and where it is zero -r/s. This is put in everywhere, in
//! the arguments of functions too. A case is closed where what is claimed has the claimed sign, or a hypothesis a
//! sign that it excludes: from x^3 = y^3 and x > y a contradiction follows. The expressions that are tried are factors of
//! the claim, hypotheses, and what is squared under a root (|x|). Admitted values are only ever enlarged.

use super::Checker;
use super::hypotheses::admitted::Admitted;
use super::hypotheses::possible::Signs;
use super::sides::CASE;
use crate::functions::{FunctionLetter, FunctionTable, Sign, Supposed, square_root_of};
use crate::model::Letter;
use crate::model::links::Link;
use crate::model::range::{Numbers, Range};
use crate::verdict::certificate::{Case, Cases, Fraction, Steps, verify_steps};
use num_rational::BigRational;
use num_traits::Signed;
use ratpoly::{Budget, Polynomial, RationalFunction, Ring};
use std::collections::BTreeSet;

/// How many expressions are split by, one inside of the other.
const DEPTH: usize = 3;
/// How many cases are looked at for one claim.
const MOST: usize = 60;
/// How many expressions are tried in one place.
const WIDTH: usize = 6;
/// Terms of what is split by.
const LONG: usize = 12;
/// The number of the first new letter among variables of integration: no integral is as deep.
pub(super) const FIRST: usize = 1_000;

/// What is claimed to have a sign, and what is supposed beside the hypotheses.
pub(super) type Claimed = (RationalFunction, Vec<Supposed<RationalFunction>>);

/// Something with the signs that it may have.
#[derive(Clone)]
struct Fact {
    /// As it stands without any case.
    original: RationalFunction,
    /// In this case.
    here: RationalFunction,
    signs: Signs,
}

/// A value of what is split by.
#[derive(Clone, Copy)]
enum Value {
    Number(i64),
    /// Greater than this.
    Above(i64),
    /// Less than this.
    Below(i64),
}

/// One case of those that are looked at.
#[derive(Clone)]
struct Here {
    /// What is claimed to have one of these signs.
    claim: Fact,
    hypotheses: Vec<Fact>,
    /// What the letters are in this case.
    images: Vec<(usize, RationalFunction)>,
    /// The functions, where what holds in this case is supposed.
    table: Option<FunctionTable>,
    /// The ranges of the letters, where there are no functions.
    ranges: Vec<Range>,
    depth: usize,
}

/// What is needed beside the case.
struct Search {
    ring: Ring,
    /// The functions, where nothing is supposed of a case.
    table: Option<FunctionTable>,
    /// Declared real letters that may be replaced.
    symbols: BTreeSet<usize>,
    /// Those that stand for integers.
    integers: BTreeSet<usize>,
    closed: Vec<Case>,
    seen: usize,
}

impl Checker<'_> {
    /// Steps that show that each of these has one of these signs where what stands beside it is so, by cases.
    pub(super) fn by_cases(&mut self, claims: &[Claimed], wanted: Signs) -> Option<Steps> {
        let table = self.functions().cloned();
        let count = table.as_ref().map(FunctionTable::given_out);
        let found = self.cases_of(table.as_ref(), claims, wanted);
        if found.is_none()
            && let (Some(table), Some(count)) = (&table, count)
        {
            table.take_back(count);
        }
        found
    }

    /// What is supposed in a case of the definitions that a link meets; none where that is not known.
    pub(super) fn suppositions_of_case(
        &mut self,
        equation: usize,
        link: &Link,
        indices: &[(String, i64)],
    ) -> Option<Vec<Supposed<RationalFunction>>> {
        let number = match indices {
            [] => return Some(Vec::new()),
            [(name, number)] if name == CASE => usize::try_from(number - 1).ok()?,
            _ => {
                let case = indices.iter().any(|(name, _)| name == CASE);
                return (!case).then(Vec::new);
            }
        };
        self.suppositions_of(equation, link, number)
    }

    /// What is supposed in the case with this number, from 0; where no definition by cases is met, that arguments lie in
    /// the ranges of their functions.
    pub(super) fn suppositions_of(
        &mut self,
        equation: usize,
        link: &Link,
        number: usize,
    ) -> Option<Vec<Supposed<RationalFunction>>> {
        let display = self.exact.display(equation).clone();
        let (left, right) = (link.left.find(&display)?, link.right.find(&display)?);
        let clause = &display.clauses[link.left.clause()];
        let head = clause.chain.members.first();
        let (supposed, _) = self.exact.in_case(number, |exact| {
            let sides = exact.sides_of_chain(head, left, right);
            sides.map(|_| exact.supposed_here().to_vec())
        });
        let supposed = supposed.ok()?;
        supposed
            .into_iter()
            .map(|s| {
                let element = self.spelt_out(&s.element)?;
                Some(Supposed { element, ..s })
            })
            .collect()
    }

    fn cases_of(
        &self,
        table: Option<&FunctionTable>,
        claims: &[Claimed],
        wanted: Signs,
    ) -> Option<Steps> {
        let supposed = &self.supposed;
        let plain = |l: &usize| matches!(self.model.letters[*l], Letter::Symbol { .. });
        let ranges = &supposed.admitted.ranges;
        let symbols: BTreeSet<usize> = (0..ranges.len())
            .filter(plain)
            .filter(|l| ranges[*l].numbers != Numbers::Complex)
            .collect();
        let integer = |l: &usize| ranges[*l].numbers == Numbers::Integer;
        let mut search = Search {
            ring: self.model.ring,
            table: table.cloned(),
            integers: symbols.iter().copied().filter(integer).collect(),
            symbols,
            closed: Vec::new(),
            seen: 0,
        };
        let mut hypotheses = Vec::new();
        if supposed.in_force {
            let orders = supposed.admitted.signs.iter().map(|(p, s)| (p, *s));
            let relations = supposed.relations.iter().map(|p| (p, Signs::ZERO));
            for (p, signs) in relations.chain(orders) {
                let element = RationalFunction::from(p.clone());
                hypotheses.push(Fact {
                    original: element.clone(),
                    here: element,
                    signs,
                });
            }
        }
        for (claim, beside) in claims {
            let mut own = hypotheses.clone();
            for supposition in beside {
                own.push(Fact {
                    original: supposition.element.clone(),
                    here: supposition.element.clone(),
                    signs: match supposition.strict {
                        true => Signs::POSITIVE,
                        false => Signs::NOT_NEGATIVE,
                    },
                });
            }
            own.extend(self.facts_of_ranges(table, claim, &own, &search.symbols));
            let here = Here {
                claim: Fact {
                    original: claim.clone(),
                    here: claim.clone(),
                    signs: wanted,
                },
                hypotheses: own,
                images: Vec::new(),
                table: table.map(|t| t.supposing(beside)),
                ranges: supposed.admitted.ranges.clone(),
                depth: 0,
            };
            if !search.closes(&here) {
                return None;
            }
        }
        let squares = table.map_or_else(Vec::new, |t| t.quadratics().to_vec());
        let steps = Steps::Cases(Cases {
            cases: search.closed,
            squares: squares
                .iter()
                .map(|q| (q.letter, (&q.square).into()))
                .collect(),
        });
        verify_steps(&steps).then_some(steps)
    }

    /// The ends of the ranges of the letters behind a claim and its hypotheses.
    fn facts_of_ranges(
        &self,
        table: Option<&FunctionTable>,
        claim: &RationalFunction,
        hypotheses: &[Fact],
        symbols: &BTreeSet<usize>,
    ) -> Vec<Fact> {
        let ring = self.model.ring;
        let mut behind = BTreeSet::new();
        for f in hypotheses.iter().map(|h| &h.here).chain([claim]) {
            behind.extend(letters_behind(table, f));
        }
        let mut facts = Vec::new();
        for letter in behind.intersection(symbols) {
            let range = &self.supposed.admitted.ranges[*letter];
            for (end, within, beyond) in [
                (&range.low, Signs::NOT_NEGATIVE, Signs::POSITIVE),
                (&range.high, Signs::NOT_POSITIVE, Signs::NEGATIVE),
            ] {
                let Some(end) = end else { continue };
                let distance = &RationalFunction::variable(ring, *letter)
                    - &RationalFunction::constant(ring, end.value.clone());
                facts.push(Fact {
                    original: distance.clone(),
                    here: distance,
                    signs: if end.included { within } else { beyond },
                });
            }
        }
        facts
    }
}

impl Search {
    /// Whether a case is closed, itself or by cases of its own.
    fn closes(&mut self, here: &Here) -> bool {
        self.seen += 1;
        if self.seen > MOST {
            return false;
        }
        let hypotheses = here.hypotheses.iter().map(|h| (h, Signs::NONE));
        for (fact, within) in [(&here.claim, here.claim.signs)]
            .into_iter()
            .chain(hypotheses)
        {
            // What is supposed in this case hides that it is contradictory: both are asked.
            for table in [self.table.clone(), here.table.clone()] {
                let own = self.signs(here, table.as_ref(), &fact.here);
                let closed = match within {
                    Signs::NONE => own.and(fact.signs) == Signs::NONE,
                    wanted => own.within(wanted),
                };
                if closed && own != Signs::NONE {
                    return self.close(here, fact, own, within != Signs::NONE);
                }
            }
        }
        if here.depth == DEPTH {
            return false;
        }
        for pivot in self.pivots(here) {
            let kept = self.closed.len();
            let all: &[Value] = match self.has_integer_values(here, &pivot) {
                true => &[
                    Value::Number(0),
                    Value::Number(1),
                    Value::Number(-1),
                    Value::Above(1),
                    Value::Below(-1),
                ],
                false => &[Value::Number(0), Value::Above(0), Value::Below(0)],
            };
            if all.iter().all(|value| {
                self.case(here, &pivot, *value)
                    .is_some_and(|h| self.closes(&h))
            }) {
                return true;
            }
            self.closed.truncate(kept);
            if self.seen > MOST {
                return false;
            }
        }
        false
    }

    /// Notes what closes a case.
    fn close(&mut self, here: &Here, fact: &Fact, signs: Signs, claim: bool) -> bool {
        let inserted = match &here.table {
            Some(table) => {
                let needed = table.letters_behind(&fact.original);
                match table.extended(&here.images, &needed) {
                    Ok(all) => all,
                    Err(_) => return false,
                }
            }
            None => here.images.clone(),
        };
        self.closed.push(Case {
            inserted: inserted.iter().map(|(l, f)| (*l, f.into())).collect(),
            of: Fraction::from(&fact.original),
            is: Fraction::from(&fact.here),
            claim,
            sign: match signs {
                Signs::POSITIVE => "> 0",
                Signs::NEGATIVE => "< 0",
                Signs::ZERO => "= 0",
                Signs::NOT_NEGATIVE => ">= 0",
                _ => "<= 0",
            },
        });
        true
    }

    fn signs(&self, here: &Here, table: Option<&FunctionTable>, f: &RationalFunction) -> Signs {
        if f.is_zero() {
            return Signs::ZERO;
        }
        match table {
            Some(table) => match table.known_sign(f) {
                Some(Sign::Positive) => Signs::POSITIVE,
                Some(Sign::NotNegative) => Signs::NOT_NEGATIVE,
                Some(Sign::Zero) => Signs::ZERO,
                Some(Sign::NotPositive) => Signs::NOT_POSITIVE,
                Some(Sign::Negative) => Signs::NEGATIVE,
                None => Signs::ANY,
            },
            None => {
                let admitted = Admitted::within(here.ranges.clone());
                let others = |_: usize| Range {
                    numbers: Numbers::Complex,
                    ..Range::default()
                };
                let budget = Budget::new(20_000, 4_000, 5_000_000);
                let own = |p: &Polynomial| admitted.signs_of(p, &others, &budget);
                // Where there is a value the denominator is not zero.
                let below = own(f.denominator()).and(Signs::NOT_ZERO);
                own(f.numerator()).times(below)
            }
        }
    }

    /// Whether an expression has integer values only.
    fn has_integer_values(&self, here: &Here, p: &Polynomial) -> bool {
        let images: BTreeSet<usize> = here.images.iter().map(|(l, _)| *l).collect();
        let integer = |l: &usize| self.integers.contains(l) && !images.contains(l);
        p.variables_occurring().iter().all(integer)
    }

    /// The letter that an expression is solved for to have this value, and its image: one without a minus
    /// sign if there is one, so that positive letters stay so.
    fn solved(
        &self,
        here: &Here,
        pivot: &Polynomial,
        value: Value,
    ) -> Option<(usize, RationalFunction)> {
        let number =
            |n: i64| RationalFunction::constant(self.ring, BigRational::from_integer(n.into()));
        let mut best: Option<(usize, RationalFunction)> = None;
        for letter in self.linear_in(here, pivot) {
            let new = || match &here.table {
                Some(table) => table.bound(FIRST + here.depth, true).ok(),
                None => Some(RationalFunction::variable(self.ring, letter)),
            };
            let value = match value {
                Value::Number(n) => number(n),
                Value::Above(n) => &number(n) + &new()?,
                Value::Below(n) => &number(n) - &new()?,
            };
            let parts = pivot.coefficients_in(letter);
            let [rest, slope] = parts.as_slice() else {
                continue;
            };
            let image = (&value - &RationalFunction::from(rest.clone()))
                .checked_div(&RationalFunction::from(slope.clone()))
                .ok()?;
            let positive = image.numerator().terms().all(|(_, c)| c.is_positive());
            if positive {
                return Some((letter, image));
            }
            best = best.or(Some((letter, image)));
        }
        best
    }

    /// The case in which an expression that is linear in a letter has such a value.
    fn case(&self, here: &Here, pivot: &Polynomial, value: Value) -> Option<Here> {
        let (letter, image) = self.solved(here, pivot, value)?;
        let mut next = here.clone();
        next.depth += 1;
        next.ranges[letter] = Range::positive();
        let images = [(letter, image)];
        // What is supposed of polynomials tells which functions have values.
        let plain = |f: &RationalFunction| match &here.table {
            Some(table) => !table
                .letters_behind(f)
                .into_iter()
                .any(|l| !table.arguments(l).is_empty()),
            None => true,
        };
        let mut known = Vec::new();
        for fact in here.hypotheses.iter().filter(|h| plain(&h.here)) {
            let Ok(there) = fact.here.substitute(&images) else {
                continue;
            };
            let (element, strict) = match fact.signs {
                Signs::POSITIVE => (there, true),
                Signs::NOT_NEGATIVE => (there, false),
                Signs::NEGATIVE => (-&there, true),
                Signs::NOT_POSITIVE => (-&there, false),
                _ => continue,
            };
            if element.as_constant().is_none() {
                known.push(Supposed { element, strict });
            }
        }
        next.table = here.table.as_ref().map(|table| table.supposing(&known));
        let put = |f: &RationalFunction| match &next.table {
            Some(table) => table.substitute(f, &images).ok(),
            None => f.substitute(&images).ok(),
        };
        for (_, earlier) in &mut next.images {
            *earlier = put(earlier)?;
        }
        next.claim.here = put(&next.claim.here)?;
        // A hypothesis without a value in this case closes nothing.
        next.hypotheses.retain_mut(|h| match put(&h.here) {
            Some(there) => {
                h.here = there;
                true
            }
            None => false,
        });
        next.images.extend(images);
        Some(next)
    }

    /// What can be split by.
    fn pivots(&self, here: &Here) -> Vec<Polynomial> {
        let mut found: Vec<Polynomial> = Vec::new();
        let mut add = |f: &Polynomial| {
            if f.len() > 4 * LONG || f.is_zero() || found.len() >= WIDTH {
                return;
            }
            let Ok(product) = f.factor_within(&Budget::new(2_000, 2_000, 1_000_000)) else {
                return;
            };
            for (factor, _) in product.factors {
                let p = factor.primitive_part().unit_normal();
                if p.len() <= LONG
                    && found.len() < WIDTH
                    && !found.contains(&p)
                    && !self.linear_in(here, &p).is_empty()
                {
                    found.push(p);
                }
            }
        };
        // Where an equation is claimed, or something is supposed, these say most.
        let wanted = here.claim.signs == Signs::ZERO;
        for f in [&here.claim]
            .into_iter()
            .filter(|_| wanted)
            .chain(&here.hypotheses)
        {
            add(f.here.numerator());
        }
        let of_integers = |p: &Polynomial| {
            let letters = p.variables_occurring();
            letters.iter().all(|l| self.integers.contains(l))
        };
        if of_integers(here.claim.here.numerator()) {
            add(here.claim.here.numerator());
        }
        let all = [&here.claim].into_iter().chain(&here.hypotheses);
        let letters: BTreeSet<usize> = all
            .flat_map(|f| letters_behind(here.table.as_ref(), &f.here))
            .collect();
        if let Some(table) = &here.table {
            let mut exponents: Vec<RationalFunction> = Vec::new();
            for letter in &letters {
                match table.meaning(*letter) {
                    Some(FunctionLetter::Root(radicand)) if radicand.len() <= 4 * LONG => {
                        if let Some(root) = square_root_of(&radicand) {
                            add(&root);
                        }
                    }
                    Some(FunctionLetter::Cosine(u) | FunctionLetter::Sine(u, _)) => {
                        add(u.numerator())
                    }
                    Some(
                        FunctionLetter::Pi
                        | FunctionLetter::ImaginaryUnit
                        | FunctionLetter::Root(_)
                        | FunctionLetter::Exponential(_)
                        | FunctionLetter::Power(..)
                        | FunctionLetter::Logarithm(_)
                        | FunctionLetter::Dirac(_)
                        | FunctionLetter::Bound { .. },
                    )
                    | None => {}
                }
            }
            // Terms with one exponential each, one beside another.
            for f in [&here.claim].into_iter().chain(&here.hypotheses) {
                let start = exponents.len();
                for (monomial, _) in f.here.numerator().terms().take(LONG) {
                    let mut sum = RationalFunction::zero(self.ring);
                    for (letter, n) in monomial.exponents().iter().enumerate() {
                        if *n > 0
                            && let Some(FunctionLetter::Exponential(u)) = table.meaning(letter)
                        {
                            sum = &sum + &(&u * &number(self.ring, i64::from(*n)));
                        }
                    }
                    if !exponents[start..].contains(&sum) {
                        exponents.push(sum);
                    }
                }
                for (k, u) in exponents.iter().enumerate().skip(start) {
                    for v in &exponents[start..k] {
                        add((u - v).numerator());
                    }
                }
            }
        }
        // Letters one beside another, and integers beside zero.
        let symbols: Vec<usize> = letters.intersection(&self.symbols).copied().collect();
        for (k, letter) in symbols.iter().enumerate() {
            let x = Polynomial::variable(self.ring, *letter);
            if self.integers.contains(letter) {
                add(&x);
            }
            for other in &symbols[..k] {
                add(&(&x - &Polynomial::variable(self.ring, *other)));
            }
        }
        found
    }

    /// Declared letters with a number as their coefficient that stand in no function of the rest; where all is
    /// real.
    fn linear_in(&self, here: &Here, p: &Polynomial) -> Vec<usize> {
        let table = here.table.as_ref();
        let occurring = p.variables_occurring();
        let real = |l: &usize| match table {
            Some(table) => table.is_real_letter(*l),
            None => self.symbols.contains(l),
        };
        if !occurring.iter().all(real) {
            return Vec::new();
        }
        let linear = |l: &usize| {
            self.symbols.contains(l)
                && matches!(&p.coefficients_in(*l)[..], [_, slope] if slope.is_constant())
        };
        let free = |l: &usize| {
            occurring.iter().all(|other| {
                let element = RationalFunction::variable(self.ring, *other);
                other == l || !letters_behind(table, &element).contains(l)
            })
        };
        let all = occurring.iter().copied();
        all.filter(linear).filter(free).collect()
    }
}

fn number(ring: Ring, n: i64) -> RationalFunction {
    RationalFunction::constant(ring, BigRational::from_integer(n.into()))
}

fn letters_behind(table: Option<&FunctionTable>, f: &RationalFunction) -> BTreeSet<usize> {
    match table {
        Some(table) => table.letters_behind(f),
        None => super::identity::letters_of([f]),
    }
}
