//! Lost factors and terms, and literals, by solving instead of guessing.
//!
//! Where the value that a subexpression must have is known modulo the prime, the quotient of it by
//! the printed value and the difference from it are compared with a table of small monomials: a
//! small rational number times few letters with small exponents. What is in the table is proposed
//! at a cost that grows with its size. A monomial as large as what it stands beside is none: that
//! would be the true value in place of the printed one.

use super::Candidate;
use super::needed::Walk;
use super::residue::Residue;
use super::sites::Trial;
use crate::check::edit::build::{factors, number, power, product, quotient, rational, sum, terms};
use crate::check::edit::{Address, Change, Context, Kind, Replacement, cost_of, sites};
use crate::domain::{Domain, PrimeField};
use crate::evaluate::Value;
use crate::expr::walk::visit;
use crate::expr::{Expr, ExprKind, Name, QuotientStyle, Sign};
use crate::model::names::literal_integer;
use crate::span::Span;
use crate::verdict::EditClass;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};
use std::collections::HashMap;

/// The largest size of a monomial: its exponents' sizes, and one for a number.
const LARGEST: i64 = 4;
/// The most monomials without their numbers.
const MONOMIALS: usize = 20_000;
/// The most letters.
const LETTERS: usize = 20;
/// What each unit of size costs.
const PER_SIZE: u32 = 6;

/// Letters with exponents.
type Exponents = Vec<(usize, i64)>;

/// The small monomials and numbers by their values.
struct Table {
    letters: Vec<Name>,
    monomials: HashMap<u64, Exponents>,
    /// Numbers, and their inverses modulo the prime.
    numbers: Vec<(BigRational, u64)>,
}

/// A number times letters with exponents.
#[derive(Clone, Debug)]
struct Monomial {
    number: BigRational,
    letters: Vec<(Name, i64)>,
}

impl Monomial {
    fn size(&self) -> i64 {
        let letters: i64 = self.letters.iter().map(|(_, e)| e.abs()).sum();
        letters + i64::from(!self.number.abs().is_one())
    }

    fn is_number(&self) -> bool {
        self.letters.is_empty()
    }
}

impl Trial<'_, '_> {
    /// The candidates with one factor, term or literal solved for.
    pub fn solved(&mut self, context: &Context) -> Vec<Candidate> {
        if !self.fast {
            return Vec::new();
        }
        let table = self.monomials(context);
        let mut found = Vec::new();
        let places = [self.link.left, self.link.right];
        let values = self.sides().map(|id| self.store.value(id, self.env));
        let display = self.display;
        for (side, place) in places.into_iter().enumerate() {
            let (Some(needed @ Value::Scalar(_)), Some(expr)) =
                (values[1 - side].value(), place.find(display))
            else {
                continue;
            };
            let all = Walk::needs(self, expr, place, needed.clone());
            for site in sites(display, place) {
                let Some(needed) = all.get(&site.address) else {
                    continue;
                };
                let Some(printed) = self.printed(&site.address) else {
                    continue;
                };
                for needed in needed {
                    self.spent.tried += 1;
                    self.all += 1;
                    let proposals = table.proposals(site.expr, printed, *needed);
                    for (class, cost, to) in proposals {
                        let term = class == EditClass::Term && matches!(to.1, Added::Term);
                        let whole = class == EditClass::Letter && site.parent.is_none();
                        if whole || term && !site.takes_terms() || !term && site.is_count() {
                            continue;
                        }
                        let replacement = Replacement {
                            address: site.address.clone(),
                            class,
                            change: Change::between(site.expr, to.0),
                            cost,
                        };
                        found.push(Candidate::single(&replacement));
                    }
                }
            }
        }
        found.sort_by_key(|c| c.cost);
        self.sifted(&found)
    }

    fn printed(&mut self, address: &Address) -> Option<u64> {
        let spot = *self.spot_at.get(address)?;
        match self.store.value(self.spots[spot].id, self.env) {
            Residue::Is(Value::Scalar(s)) => Some(s),
            Residue::Is(Value::Matrix(_) | Value::Zero) | Residue::Absent | Residue::Unknown => {
                None
            }
        }
    }

    /// The letters of the equation, then those of the document, and their small monomials.
    fn monomials(&mut self, context: &Context) -> Table {
        let mut names: Vec<Name> = Vec::new();
        for place in [self.link.left, self.link.right] {
            if let Some(expr) = place.find(self.display) {
                visit(expr, &mut |e| {
                    if let ExprKind::Name(name) = &e.kind
                        && context.kind_of(name) != Kind::Matrix
                        && !names.contains(name)
                    {
                        names.push(name.clone());
                    }
                });
            }
        }
        for known in &context.letters {
            if known.kind == Kind::Scalar && !names.contains(&known.name) {
                names.push(known.name.clone());
            }
        }
        let mut letters = Vec::new();
        let mut values = Vec::new();
        for name in names {
            let expr = Expr::new(ExprKind::Name(name.clone()), Span::default());
            let id = self.store.node(&expr);
            if let Residue::Is(Value::Scalar(s)) = self.store.value(id, self.env)
                && s != 0
                && letters.len() < LETTERS
            {
                letters.push(name);
                values.push(s);
            }
        }
        Table {
            monomials: monomials(&values),
            letters,
            numbers: numbers(),
        }
    }
}

/// All products of powers of these values, by size, up to a number of them.
fn monomials(values: &[u64]) -> HashMap<u64, Exponents> {
    let field = PrimeField;
    let inverses: Vec<u64> = values
        .iter()
        .map(|v| field.divide(&1, v).unwrap_or_default())
        .collect();
    let mut found: HashMap<u64, Exponents> = HashMap::from([(1, Vec::new())]);
    let mut layer: Vec<(u64, Exponents)> = vec![(1, Vec::new())];
    for _ in 0..LARGEST {
        let mut next = Vec::new();
        for (value, exponents) in &layer {
            // Each monomial once: its letters in order, each with one sign.
            let from = exponents.last().map_or(0, |(l, _)| *l);
            for l in from..values.len() {
                for (step, factor) in [(1, values[l]), (-1, inverses[l])] {
                    let mut longer = exponents.clone();
                    match longer.last_mut() {
                        Some((last, e)) if *last == l => {
                            if e.signum() != step {
                                continue;
                            }
                            *e += step;
                        }
                        _ => longer.push((l, step)),
                    }
                    if found.len() + next.len() >= MONOMIALS {
                        return found;
                    }
                    next.push((field.multiply(value, &factor), longer));
                }
            }
        }
        for (value, exponents) in &next {
            found.entry(*value).or_insert_with(|| exponents.clone());
        }
        layer = next;
    }
    found
}

/// Small rational numbers, 1 first, with their inverses modulo the prime.
fn numbers() -> Vec<(BigRational, u64)> {
    let large = [
        15, 16, 18, 20, 24, 30, 32, 36, 40, 45, 48, 60, 64, 72, 90, 96, 100, 120, 128, 144, 180,
        192, 240, 256, 360, 384, 720,
    ];
    let mut pairs: Vec<(i64, i64)> = (1..=12).map(|n| (n, 1)).collect();
    pairs.extend((2..=12).map(|n| (1, n)));
    pairs.extend(large.iter().flat_map(|n| [(*n, 1), (1, *n)]));
    for above in 2..=9 {
        pairs.extend((2..=9).map(|below| (above, below)));
    }
    let mut found: Vec<(BigRational, u64)> = Vec::new();
    for (above, below) in pairs {
        let number = BigRational::new(BigInt::from(above), BigInt::from(below));
        if found.iter().any(|(n, _)| *n == number) {
            continue;
        }
        let inverse = PrimeField.rational(&number.recip()).unwrap_or_default();
        found.push((number.clone(), inverse));
        found.push((-number, PrimeField.negate(&inverse)));
    }
    found
}

/// What a proposal adds.
enum Added {
    Factor,
    Term,
}

impl Table {
    /// The smallest monomial of this value.
    fn monomial(&self, value: u64) -> Option<Monomial> {
        let mut found: Vec<Monomial> = Vec::new();
        for (number, inverse) in &self.numbers {
            let value = PrimeField.multiply(&value, inverse);
            if let Some(exponents) = self.monomials.get(&value) {
                let letters = exponents.iter();
                found.push(Monomial {
                    number: number.clone(),
                    letters: letters
                        .map(|(l, e)| (self.letters[*l].clone(), *e))
                        .collect(),
                });
            }
        }
        found.into_iter().min_by_key(Monomial::size)
    }

    /// What would give an expression the needed value.
    fn proposals(
        &self,
        expr: &Expr,
        printed: u64,
        needed: u64,
    ) -> Vec<(EditClass, u32, (Expr, Added))> {
        let field = PrimeField;
        let mut found = Vec::new();
        if printed == needed || needed == 0 {
            return found;
        }
        let own = leaves(expr);
        let cost = |class, size: i64| cost_of(class) + PER_SIZE * u32::try_from(size).unwrap_or(9);
        if let ExprKind::Number(_) = expr.kind {
            // Another number in its place.
            if let Some(monomial) = self.monomial(needed)
                && monomial.is_number()
            {
                let to = rational(monomial.number, expr.span);
                let cost = cost_of(EditClass::Factor) + 6;
                found.push((EditClass::Factor, cost, (to, Added::Factor)));
            }
            return found;
        }
        // A letter where a number belongs; small ones are among the edits.
        if let ExprKind::Name(_) = expr.kind
            && let Some(monomial) = self.monomial(needed)
            && monomial.is_number()
        {
            let to = rational(monomial.number, expr.span);
            let cost = cost_of(EditClass::Letter) + 3 * PER_SIZE;
            found.push((EditClass::Letter, cost, (to, Added::Factor)));
        }
        if let Some(ratio) = field.divide(&needed, &printed)
            && let Some(monomial) = self.monomial(ratio)
            && !matches!(
                expr.kind,
                ExprKind::Sum(_) | ExprKind::Group { .. } | ExprKind::Power { .. }
            )
            && (monomial.size() <= 1 || 2 * monomial.size() <= own)
            && !(monomial.is_number() && monomial.number.abs().is_one())
        {
            let class = if monomial.is_number() {
                EditClass::Factor
            } else {
                EditClass::Term
            };
            let cost = cost(class, monomial.size());
            let to = with_factor(expr, &monomial);
            found.push((class, cost, (to, Added::Factor)));
        }
        let difference = field.subtract(&needed, &printed);
        if let Some(monomial) = self.monomial(difference)
            && (monomial.size() <= 1 || monomial.size() < own)
        {
            let cost = cost(EditClass::Term, monomial.size());
            let to = with_term(expr, &monomial);
            found.push((EditClass::Term, cost, (to, Added::Term)));
        }
        found
    }
}

/// How many letters and numbers an expression has.
fn leaves(expr: &Expr) -> i64 {
    let mut count = 0;
    visit(expr, &mut |e| {
        count += i64::from(matches!(
            e.kind,
            ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Apply { .. }
        ));
    });
    count
}

/// A product with the factors of a monomial, each joined to the power of its letter that is there.
fn with_factor(expr: &Expr, monomial: &Monomial) -> Expr {
    let span = expr.span;
    let (mut above, mut below, style) = match &expr.kind {
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => (factors(numerator), factors(denominator), *style),
        _ => (factors(expr), Vec::new(), QuotientStyle::Bar),
    };
    for (name, exponent) in &monomial.letters {
        let letter = Expr::new(ExprKind::Name(name.clone()), span);
        let rest = joined(&mut above, &letter, *exponent);
        let rest = -joined(&mut below, &letter, -rest);
        match rest {
            0 => {}
            1.. => above.push(power(letter, rest)),
            _ => below.push(power(letter, -rest)),
        }
    }
    let mut number_above = BigRational::from_integer(monomial.number.numer().clone());
    let mut number_below = BigRational::from_integer(monomial.number.denom().clone());
    take_number(&mut above, &mut number_above);
    take_number(&mut below, &mut number_below);
    let reduced = &number_above / &number_below;
    let integers = number_above.is_integer() && number_below.is_integer();
    let (top, bottom) = match integers {
        true => (reduced.numer().clone(), reduced.denom().clone()),
        false => (number_above.to_integer(), BigInt::one()),
    };
    let front = |items: &mut Vec<Expr>, value: BigInt| {
        if !value.is_one() || items.is_empty() {
            items.insert(0, rational(BigRational::from_integer(value), span));
        }
    };
    front(&mut above, top);
    if !below.is_empty() || !bottom.is_one() {
        front(&mut below, bottom);
        return quotient(product(above, span), product(below, span), style, span);
    }
    product(above, span)
}

/// Joins an exponent to the power of a letter among some factors, as far as it stays positive; what
/// is left of it.
fn joined(items: &mut Vec<Expr>, letter: &Expr, exponent: i64) -> i64 {
    let found = items.iter().position(|item| match &item.kind {
        ExprKind::Power { base, exponent } => {
            **base == *letter && literal_integer(exponent).is_some_and(|n| n > 0)
        }
        _ => item == letter,
    });
    let Some(at) = found else {
        return exponent;
    };
    let own = match &items[at].kind {
        ExprKind::Power { exponent, .. } => literal_integer(exponent).unwrap_or(1),
        _ => 1,
    };
    let total = own + exponent;
    if total > 0 {
        items[at] = power(letter.clone(), total);
        return 0;
    }
    items.remove(at);
    total
}

/// Takes the number at the front of some factors into another.
fn take_number(items: &mut Vec<Expr>, number: &mut BigRational) {
    if let Some(ExprKind::Number(n)) = items.first().map(|e| &e.kind)
        && n.is_integer()
    {
        *number *= n;
        items.remove(0);
    }
}

/// A sum with a monomial as its last term.
fn with_term(expr: &Expr, monomial: &Monomial) -> Expr {
    let span = expr.span;
    let sign = if monomial.number.is_negative() {
        Sign::Minus
    } else {
        Sign::Plus
    };
    let absolute = Monomial {
        number: monomial.number.abs(),
        letters: monomial.letters.clone(),
    };
    let mut all = terms(expr);
    all.push((sign, with_factor(&number(1, span), &absolute)));
    sum(all, span)
}
