//! Statements in words, decided exactly.
//!
//! The rule: a statement *holds* if it is proved to be true wherever it says (for all admissible values
//! of the letters unless it names a box); it is *loose* if it is true at the reference point and shown to
//! be false elsewhere, or true up to its tolerance, or in another reading of the sentence; it is *refuted*
//! if it is false at the reference point. What is neither proved nor shown to be false is undecided.
//! Every verdict carries numbers that show how near it is to another one.

mod closeness;
mod dependence;
mod elasticity;
mod existence;
mod extremum;
mod limit;
mod line;
mod loss;
mod optimum;
mod place;
mod range;
mod sign;
mod value;

use super::Checker;
use super::admissible::Admissible;
use super::stationary::PartialCovariance;
use crate::document::{Predicate, VerdictWord};
use crate::evaluate::{Failure, Origin, Value};
use crate::expr::walk::visit;
use crate::expr::{Expr, ExprKind, Name};
use crate::functions::{FunctionLetter, FunctionTable};
use crate::model::statement::Proposition;
use crate::model::{Letter, Model};
use crate::unit::{self, Units};
use crate::verdict::statement::{Fact, Loose, Scope, SignCertificate, StatementOutcome, Subject};
use num_rational::BigRational;
use num_traits::Zero;
use ratpoly::{RationalFunction, Ring};

/// The letters, their reference values, and which are positive.
pub(super) struct Ground {
    ring: Ring,
    /// By letter of the ring.
    reference: Vec<Option<BigRational>>,
    positive: Vec<usize>,
    /// The letter of each symbol.
    letters: Vec<Option<usize>>,
    /// Where the letters may be.
    admissible: Admissible,
    table: FunctionTable,
}

/// A verdict with its facts.
pub(super) struct Found {
    word: VerdictWord,
    /// How it falls short where it is loose; partly unless told.
    loose: Loose,
    reason: Option<String>,
    facts: Vec<Fact>,
    signs: Vec<SignCertificate>,
}

impl Default for Found {
    fn default() -> Self {
        Found {
            word: VerdictWord::Undecided,
            loose: Loose::Partly,
            reason: None,
            facts: Vec::new(),
            signs: Vec::new(),
        }
    }
}

impl Found {
    fn of(word: VerdictWord, facts: Vec<Fact>) -> Self {
        Found {
            word,
            facts,
            ..Found::default()
        }
    }

    /// Loose by what its number misses.
    fn nearly(mut self) -> Self {
        self.loose = Loose::Nearly;
        self
    }

    fn undecided(reason: impl Into<String>) -> Self {
        Found {
            reason: Some(reason.into()),
            ..Found::default()
        }
    }

    /// The same, but for what holds or is loose: that is open.
    fn unless_it_holds(mut self) -> Self {
        if matches!(self.word, VerdictWord::Holds | VerdictWord::Loose) {
            self.word = VerdictWord::Undecided;
            self.reason = Some("there are no reference values".into());
        }
        self
    }

    /// What is left of it where it is said of a box: not everything is decided there, and what is so for all values
    /// may be otherwise in a part of them.
    fn over_a_box(self, predicate: Predicate) -> Self {
        let at_reference = self.facts.contains(&Fact::About(Scope::Reference));
        let stands = match predicate {
            Predicate::Positive
            | Predicate::IncreasingIn
            | Predicate::DecreasingIn
            | Predicate::NotMonotoneIn
            | Predicate::ConvexIn
            | Predicate::CloseTo
            | Predicate::SmallComparedWith
            | Predicate::MeasuredLike
            | Predicate::Explicit => true,
            Predicate::IndependentOf
            | Predicate::SeparatesInto
            | Predicate::ProportionalTo
            | Predicate::Equals => self.word == VerdictWord::Holds && !at_reference,
            Predicate::HasAMinimumIn
            | Predicate::HasAMaximumIn
            | Predicate::MinimalAt
            | Predicate::MaximalAt
            | Predicate::NearlyMinimalAt
            | Predicate::LeastAtTheLowerBoundOf
            | Predicate::WorseAtTheMinimumOf
            | Predicate::DependsOnlyOn
            | Predicate::DependsEssentiallyOn
            | Predicate::TendsTo => false,
        };
        match stands || self.word == VerdictWord::Undecided {
            true => self,
            false => Found::undecided("over a box this is not decided"),
        }
    }

    /// What is said where it was found with equations as corrected, and something else as they are printed: what
    /// holds as printed holds, and what is judged as corrected only says so.
    fn or_as_printed(self, printed: Found, corrected: Vec<usize>) -> Self {
        use VerdictWord as Word;
        match (printed.word, self.word) {
            (printed, own) if printed == own => self,
            (Word::Holds, _) => printed,
            (Word::Loose, Word::Refuted) => printed,
            (_, Word::Undecided) => self,
            _ => self.and([Fact::Corrected(corrected)]),
        }
    }

    fn and(mut self, facts: impl IntoIterator<Item = Fact>) -> Self {
        for fact in facts {
            if !self.facts.contains(&fact) {
                self.facts.push(fact);
            }
        }
        self
    }
}

impl Checker<'_> {
    /// Settles all statements, in the order of the document.
    pub(super) fn statements(&mut self) -> Vec<StatementOutcome> {
        let model = self.model;
        if model.statements.is_empty() {
            return Vec::new();
        }
        let ground = Ground::of(model, self.instance);
        let (mut units, _) = unit::audit(model);
        let partial = self.bounded_in_all(Checker::partial_covariances);
        let partial = partial.unwrap_or_default();
        let mut outcomes = Vec::new();
        for (index, statement) in model.statements.iter().enumerate() {
            if statement.propositions.is_empty() {
                outcomes.push(StatementOutcome {
                    statement: index,
                    member: 1,
                    word: VerdictWord::Recalled,
                    loose: None,
                    reason: statement.settings.reason.as_ref().map(|r| r.text.clone()),
                    facts: Vec::new(),
                    signs: Vec::new(),
                });
            }
            for (k, proposition) in statement.propositions.iter().enumerate() {
                let mut found = self.found(proposition, &ground, &mut units, &partial);
                let corrected = self.corrected_behind(proposition.expressions(), None);
                if !corrected.is_empty() {
                    let mut there = self.as_printed(&corrected);
                    let printed = there.found(proposition, &ground, &mut units, &partial);
                    self.pool = there.pool;
                    found = found.or_as_printed(printed, corrected);
                }
                debug_assert!(found.signs.iter().all(SignCertificate::verify));
                outcomes.push(StatementOutcome {
                    statement: index,
                    member: k + 1,
                    word: found.word,
                    loose: (found.word == VerdictWord::Loose).then_some(found.loose),
                    reason: found.reason,
                    facts: found.facts,
                    signs: found.signs,
                });
            }
            if statement.alternatives {
                read_otherwise(&mut outcomes, index);
            }
        }
        outcomes
    }

    /// What is found of a proposition in this world.
    fn found(
        &mut self,
        proposition: &Proposition,
        ground: &Ground,
        units: &mut Units,
        partial: &[PartialCovariance],
    ) -> Found {
        let found = self.bounded_in_all(|checker| checker.proposition(proposition, ground, units));
        match found {
            Ok(Ok(found)) => self.where_it_exists(found, proposition, ground, partial),
            Ok(Err(failure)) => Found::undecided(self.reason_of(&failure)),
            Err(exhausted) => Found::undecided(self.words_of_exhaustion(exhausted).to_string()),
        }
    }

    /// Whether a letter is the value of a function of others; the circle's constant is a number.
    fn stands_for_a_function(&self, letter: usize) -> bool {
        let functions = self.model.functions.as_ref();
        let meaning = functions.and_then(|table| table.meaning(letter));
        meaning.is_some_and(|meaning| meaning != FunctionLetter::Pi)
    }

    /// A scalar quantity in the declared symbols, with the letters inserted that the proposition
    /// fixes.
    fn quantity(
        &mut self,
        expr: &Expr,
        proposition: &Proposition,
        ground: &Ground,
    ) -> Result<RationalFunction, Failure> {
        let span = expr.span;
        let before = std::mem::take(&mut self.exact.conditions);
        let value = self.exact.expression_without_cases(expr);
        let vanishing = self.vanishing_divisor();
        let cancelled =
            value.is_ok() && self.divides_by_what_is_gone(expr, proposition.predicate, ground);
        self.exact.conditions = before;
        if cancelled {
            let what = "a statement about what has no value somewhere";
            return Err(Failure::unsupported(what, span));
        }
        if let Some(failure) = vanishing {
            return Err(failure);
        }
        let value = match value? {
            Value::Scalar(value) => value,
            Value::Zero => RationalFunction::zero(ground.ring),
            Value::Matrix(_) => {
                return Err(Failure::unsupported("a statement about a matrix", span));
            }
        };
        // Predicates ask for derivatives and signs of rational functions: a letter that stands for
        // a function of other letters is none of their variables.
        if (super::identity::letters_of([&value]).into_iter())
            .any(|l| self.stands_for_a_function(l))
        {
            return Err(Failure::unsupported(
                "a statement about exp, cos or roots",
                span,
            ));
        }
        let all = self.insertion(&self.inserted.keys().copied().collect::<Vec<_>>());
        let mut images = all.letters;
        for symbol in &proposition.fixed {
            if let Some(letter) = ground.letters[*symbol]
                && let Some(own) = &ground.reference[letter]
            {
                images.push((letter, RationalFunction::constant(ground.ring, own.clone())));
            }
        }
        // The definitions first: their values have letters that are fixed.
        let (fixed, defined): (Vec<_>, Vec<_>) = images
            .into_iter()
            .partition(|(letter, _)| !self.inserted.contains_key(letter));
        let pole = |_| Failure::new(crate::evaluate::FailureKind::DivisionByZero, span);
        value
            .substitute(&defined)
            .map_err(pole)?
            .substitute(&fixed)
            .map_err(pole)
    }

    /// Whether something that may vanish is divided by, in an expression or behind it, and no longer seen
    /// in its value.
    fn divides_by_what_is_gone(
        &mut self,
        expr: &Expr,
        predicate: Predicate,
        ground: &Ground,
    ) -> bool {
        // Elsewhere it is about the values that there are.
        let anywhere = matches!(
            predicate,
            Predicate::HasAMinimumIn
                | Predicate::HasAMaximumIn
                | Predicate::MinimalAt
                | Predicate::MaximalAt
                | Predicate::NearlyMinimalAt
                | Predicate::LeastAtTheLowerBoundOf
                | Predicate::WorseAtTheMinimumOf
        );
        let world = self.exact.world().clone().inserting();
        let mut expanding = self.exact.in_world(world);
        let Ok(value) = expanding.expression_without_cases(expr) else {
            return false;
        };
        self.exact.conditions = expanding.conditions;
        let open = self.conditions().into_iter();
        let mut open = open.filter(|c| c.because.is_none() && !is_about_existence(&c.origin));
        open.any(|condition| {
            let there = ground.at(&condition.factor.clone().into());
            if !anywhere && !there.is_some_and(|value| value.is_zero()) {
                return false;
            }
            let mut entries = value.entries().into_iter();
            entries.all(|entry| entry.denominator().div_exact(&condition.factor).is_none())
        })
    }

    fn proposition(
        &mut self,
        p: &Proposition,
        ground: &Ground,
        units: &mut Units,
    ) -> Result<Found, Failure> {
        if p.predicate == Predicate::MeasuredLike {
            return Ok(closeness::measured_like(p, units));
        }
        if p.predicate == Predicate::Explicit {
            let value = self.exact.expression_without_cases(&p.of)?;
            return Ok(self.explicit(&value));
        }
        let mut letters: Vec<Name> = Vec::new();
        letters.extend(
            p.letters
                .iter()
                .map(|s| self.model.symbols[*s].name.clone()),
        );
        if let (Predicate::ProportionalTo, Some(to)) = (p.predicate, &p.to) {
            visit(to, &mut |e| {
                if let ExprKind::Name(name) = &e.kind {
                    letters.push(name.clone());
                }
            });
        }
        let mut letters = letters.iter();
        let moves = letters.any(|name| p.expressions().any(|e| self.moves_with(e, name)));
        if moves {
            return Ok(Found::undecided(
                "how a process depends on the letter is not written",
            ));
        }
        let f = self.quantity(&p.of, p, ground)?;
        let mut optional = |expr: &Option<Expr>| match expr {
            Some(expr) => self.quantity(expr, p, ground).map(Some),
            None => Ok(None),
        };
        let to = optional(&p.to)?;
        let at = optional(&p.at)?;
        let other = optional(&p.minimum_of)?;
        let letter = p.letters.first().and_then(|s| ground.letters[*s]);
        let found = match (p.predicate, letter) {
            (Predicate::Positive, _) => ground.strict(&f, true, Subject::Quantity, None, p),
            (Predicate::IncreasingIn, Some(x)) => ground.monotone(&f, x, true, p),
            (Predicate::DecreasingIn, Some(x)) => ground.monotone(&f, x, false, p),
            (Predicate::NotMonotoneIn, Some(x)) => ground.not_monotone(&f, x, p),
            (Predicate::ConvexIn, Some(x)) => ground.convex(&f, x, p),
            (Predicate::HasAMinimumIn, Some(x)) => ground.has_extremum(&f, x, true),
            (Predicate::HasAMaximumIn, Some(x)) => ground.has_extremum(&f, x, false),
            (Predicate::MinimalAt, Some(x)) => ground.extremal_at(&f, x, true, at, p),
            (Predicate::MaximalAt, Some(x)) => ground.extremal_at(&f, x, false, at, p),
            (Predicate::NearlyMinimalAt, Some(x)) => ground.nearly_minimal(&f, x, at, p),
            (Predicate::LeastAtTheLowerBoundOf, Some(x)) => ground.least_at_bound(&f, x),
            (Predicate::WorseAtTheMinimumOf, Some(x)) => match other {
                Some(other) => ground.worse_at_minimum_of(&f, &other, x, p),
                None => Found::undecided("nothing says whose minimum"),
            },
            (Predicate::IndependentOf, Some(x)) => ground.independent(&f, x, p),
            (Predicate::DependsEssentiallyOn, Some(x)) => ground.essential(&f, x, p),
            (Predicate::DependsOnlyOn, _) => ground.depends_only(&f, p),
            (Predicate::SeparatesInto, _) => ground.separates(&f, p),
            (Predicate::ProportionalTo, _) => match to {
                Some(to) => ground.proportional(&f, &to, p),
                None => Found::undecided("nothing says to what"),
            },
            (Predicate::TendsTo, Some(x)) => ground.tends(&f, x, p.to_infinity, to.as_ref()),
            (Predicate::Equals, _) => ground.equals(&f, to.as_ref()),
            (Predicate::CloseTo, _) => ground.close(&f, to.as_ref(), p),
            (Predicate::SmallComparedWith, _) => ground.small(&f, to.as_ref(), p),
            _ => Found::undecided("nothing says for which letter"),
        };
        Ok(match p.only_in_box {
            true => found.over_a_box(p.predicate),
            false => found,
        })
    }
}

/// Whether a condition asks for a sign, and for no value that is divided by.
fn is_about_existence(origin: &Origin) -> bool {
    match origin {
        Origin::Stability(_) | Origin::Range { .. } => true,
        Origin::Divisor(_) | Origin::Determinant(_) => false,
    }
}

/// Of several readings of one sentence one may be false while another is true: then the sentence is
/// loose and not false.
fn read_otherwise(outcomes: &mut [StatementOutcome], statement: usize) {
    let of_it = |o: &&mut StatementOutcome| o.statement == statement;
    let is_true = |o: &StatementOutcome| {
        o.statement == statement && matches!(o.word, VerdictWord::Holds | VerdictWord::Loose)
    };
    if !outcomes.iter().any(is_true) {
        return;
    }
    for outcome in outcomes.iter_mut().filter(of_it) {
        if outcome.word == VerdictWord::Refuted {
            outcome.word = VerdictWord::Loose;
            outcome.loose = Some(Loose::Otherwise);
        }
    }
}

impl Ground {
    /// The reference value of a letter.
    pub(super) fn reference(&self, letter: usize) -> Option<&BigRational> {
        self.reference[letter].as_ref()
    }

    /// The ground that a model's symbols give.
    pub(super) fn of(model: &Model, instance: usize) -> Ground {
        let letters = (0..model.symbols.len())
            .map(|symbol| model.letter_of_symbol(symbol, 0))
            .collect();
        let reference = model
            .letters
            .iter()
            .map(|letter| match letter {
                Letter::Symbol { symbol, order: 0 } => model.symbols[*symbol].value.clone(),
                _ => None,
            })
            .collect();
        Ground {
            ring: model.ring,
            reference,
            positive: (0..model.letters.len())
                .filter(|l| model.is_positive(*l))
                .collect(),
            letters,
            admissible: Admissible::of(model, instance),
            table: match &model.functions {
                Some(table) => table.clone(),
                None => {
                    let ranges = (0..model.letters.len()).map(|l| model.range_of(l));
                    FunctionTable::new(model.ring, ranges.collect())
                }
            },
        }
    }

    /// The letters that occur in a function.
    fn letters_in(&self, f: &RationalFunction) -> Vec<usize> {
        super::identity::letters_of([f]).into_iter().collect()
    }

    /// The value at a point; none where a letter has no value or the function a pole.
    fn at_point(&self, f: &RationalFunction, point: &[Option<BigRational>]) -> Option<BigRational> {
        if self.letters_in(f).iter().any(|l| point[*l].is_none()) {
            return None;
        }
        let point: Vec<BigRational> = point
            .iter()
            .map(|v| v.clone().unwrap_or_else(BigRational::zero))
            .collect();
        f.evaluate(&point).ok()
    }

    /// The value at the reference point.
    fn at(&self, f: &RationalFunction) -> Option<BigRational> {
        self.at_point(f, &self.reference)
    }

    /// The reference values of the letters that occur.
    fn point_of(&self, f: &RationalFunction) -> Vec<(usize, BigRational)> {
        let letters = self.letters_in(f);
        letters
            .into_iter()
            .filter_map(|l| Some((l, self.reference[l].clone()?)))
            .collect()
    }

    /// The function with the reference values of all letters but these; none where one of them
    /// has none.
    fn restricted(&self, f: &RationalFunction, kept: &[usize]) -> Option<RationalFunction> {
        let others = self.letters_in(f).into_iter().filter(|l| !kept.contains(l));
        let images = others
            .map(|l| {
                Some((
                    l,
                    RationalFunction::constant(self.ring, self.reference[l].clone()?),
                ))
            })
            .collect::<Option<Vec<_>>>()?;
        f.substitute(&images).ok()
    }

    /// The sides of the proposition's box, by letter.
    fn sides(&self, p: &Proposition) -> Vec<(usize, BigRational, BigRational)> {
        let side = |symbol: &usize| {
            let letter = self.letters[*symbol]?;
            let own = self.reference[letter].clone()?;
            Some((letter, &own * &p.times.0, &own * &p.times.1))
        };
        p.around.iter().filter_map(side).collect()
    }

    /// The scope of the proposition's box, if it has one.
    fn box_of(&self, p: &Proposition) -> Option<Scope> {
        let sides = self.sides(p);
        (!sides.is_empty()).then_some(Scope::Box(sides))
    }
}
