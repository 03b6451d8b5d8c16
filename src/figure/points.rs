//! The letters and quantities that figure tables name, and their values at points.

use super::{Obstacle, Source};
use crate::check;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::document::Text;
use crate::domain::{Rationals, Symbolic};
use crate::evaluate::{Condition, Evaluator, Failure, FailureKind, Origin, Value, World};
use crate::expr::Expr;
use crate::latex::{self, Signature};
use crate::model::{Letter, Model};
use crate::span::Span;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction};

/// LaTeX that can be read, at its place.
pub(super) fn readable(text: &Text) -> Result<Expr, Obstacle> {
    latex::parse_expr(&text.text, text.span.start, &Signature::default()).map_err(|errors| {
        Obstacle::Wrong(errors.into_iter().next().unwrap_or_else(|| unread(text)))
    })
}

fn unread(text: &Text) -> Diagnostic {
    Diagnostic::new(
        DiagnosticKind::Unexpected {
            found: text.text.clone(),
            expected: "a formula".into(),
        },
        text.span,
    )
}

/// The declared symbol that a table names.
pub(super) fn symbol(model: &Model, text: &Text) -> Result<usize, Obstacle> {
    let name = latex::parse_name(&text.text, text.span.start).map_err(|errors| {
        Obstacle::Wrong(errors.into_iter().next().unwrap_or_else(|| unread(text)))
    })?;
    let wanted = latex::canonical(&name);
    let found = model
        .symbols
        .iter()
        .position(|s| latex::canonical(&s.name) == wanted);
    found.ok_or_else(|| {
        Diagnostic::new(DiagnosticKind::UndeclaredName { name: wanted }, text.span).into()
    })
}

/// The reference value of a declared symbol.
pub(super) fn reference(model: &Model, symbol: usize, span: Span) -> Result<BigRational, Obstacle> {
    model.symbols[symbol].value.clone().ok_or_else(|| {
        let name = latex::canonical(&model.symbols[symbol].name);
        Diagnostic::new(DiagnosticKind::NoValue { name }, span).into()
    })
}

/// A failure at the place of a table.
fn obstacle(failure: Failure, span: Span) -> Obstacle {
    match failure.kind {
        FailureKind::Undeclared { name } => {
            Diagnostic::new(DiagnosticKind::UndeclaredName { name }, span).into()
        }
        kind => {
            let failure = Failure::new(kind, span);
            match failure.diagnostic() {
                Some(diagnostic) => diagnostic.into(),
                None => Obstacle::Beyond(check::words_of_failure(&failure.kind)),
            }
        }
    }
}

/// A scalar quantity.
pub(super) struct Quantity<'m> {
    model: &'m Model,
    expr: Expr,
    span: Span,
    /// As a function of the declared symbols' letters, where it is a rational one.
    pub symbolic: Option<RationalFunction>,
    /// What is divided by and is not seen in the function any more: where it vanishes there is no value.
    cancelled: Vec<Polynomial>,
}

impl<'m> Quantity<'m> {
    /// Reads a quantity and evaluates it where these symbols have these values, so that one of them may
    /// be an exponent.
    pub(super) fn of(
        source: &mut Source<'m>,
        text: &Text,
        at: &[(usize, BigRational)],
    ) -> Result<Self, Obstacle> {
        let expr = readable(text)?;
        let model = source.model;
        let mut letters: Vec<RationalFunction> = (0..model.letters.len())
            .map(|letter| RationalFunction::variable(model.ring, letter))
            .collect();
        for (symbol, value) in at {
            if let Some(letter) = model.letter_of_symbol(*symbol, 0) {
                letters[letter] = RationalFunction::constant(model.ring, value.clone());
            }
        }
        let world = World::new(model, letters).corrected_as(source.exact.world());
        let mut exact = world.inserting().evaluator(model.field());
        let value = exact.expression_without_cases(&expr);
        let symbolic = match value {
            Ok(Value::Scalar(f)) => Some(f),
            Ok(other) => {
                let diagnostic = Diagnostic::new(
                    DiagnosticKind::Unexpected {
                        found: other.shape_text(),
                        expected: "a scalar".into(),
                    },
                    text.span,
                );
                return Err(diagnostic.into());
            }
            Err(failure) if matches!(failure.kind, FailureKind::Undeclared { .. }) => {
                return Err(obstacle(failure, text.span));
            }
            Err(_) => None,
        };
        let cancelled = match &symbolic {
            Some(f) => cancelled(model, &exact.conditions, f),
            None => Vec::new(),
        };
        Ok(Quantity {
            model: source.model,
            expr,
            span: text.span,
            symbolic,
            cancelled,
        })
    }

    /// Whether something that was cancelled vanishes at a point of the declared symbols.
    fn is_hole(&self, values: &[Option<BigRational>]) -> bool {
        let point = self.letters(values, &BigRational::zero());
        self.cancelled.iter().any(|divisor| {
            self.lacking(&divisor.clone().into(), values).is_none()
                && divisor.evaluate(&point).is_ok_and(|v| v.is_zero())
        })
    }

    /// Refuses a point of the declared symbols at which it has no value.
    pub(super) fn refuse_hole(&self, values: &[Option<BigRational>]) -> Result<(), Obstacle> {
        match self.is_hole(values) {
            true => Err(Diagnostic::new(DiagnosticKind::DivisionByZero, self.span).into()),
            false => Ok(()),
        }
    }

    /// The value of each letter of the ring at a point of the declared symbols. Letters without one
    /// have `missing`: no value may depend on it.
    fn letters(&self, values: &[Option<BigRational>], missing: &BigRational) -> Vec<BigRational> {
        self.model
            .letters
            .iter()
            .map(|letter| match letter {
                Letter::Symbol { symbol, order: 0 } => values[*symbol].clone(),
                _ => None,
            })
            .map(|value| value.unwrap_or_else(|| missing.clone()))
            .collect()
    }

    /// The first letter that a rational function needs and that has no value at a point.
    pub(super) fn lacking(
        &self,
        f: &RationalFunction,
        values: &[Option<BigRational>],
    ) -> Option<String> {
        let mut occurring = f.numerator().variables_occurring();
        occurring.extend(f.denominator().variables_occurring());
        occurring.sort_unstable();
        let lacks = |l: &usize| match self.model.letters[*l] {
            Letter::Symbol { symbol, order: 0 } => values[symbol].is_none(),
            _ => true,
        };
        occurring
            .into_iter()
            .find(lacks)
            .map(|l| latex::canonical(&self.model.letter_name(l)))
    }

    /// The value at a point of the declared symbols.
    pub(super) fn at(
        &self,
        source: &Source<'_>,
        values: &[Option<BigRational>],
    ) -> Result<BigRational, Obstacle> {
        let no_value = |name: String| -> Obstacle {
            Diagnostic::new(DiagnosticKind::NoValue { name }, self.span).into()
        };
        if let Some(f) = &self.symbolic
            && self.lacking(f, values).is_none()
        {
            self.refuse_hole(values)?;
            let point = self.letters(values, &BigRational::zero());
            return f
                .evaluate(&point)
                .map_err(|_| Diagnostic::new(DiagnosticKind::DivisionByZero, self.span).into());
        }
        if let Some(f) = &self.symbolic
            && let Some(name) = self.lacking(f, values)
            && self
                .model
                .symbols
                .iter()
                .any(|s| latex::canonical(&s.name) == name)
        {
            return Err(no_value(name));
        }
        // Not a rational function of the letters, but perhaps rational at rational points, as a power
        // whose exponent is a letter. What has no value must not matter: two different values for it
        // give the same result.
        let [one, other] = [7919, 104_729].map(|prime: i64| {
            let missing = BigRational::new(prime.into(), 65_537.into());
            self.pointwise(source, self.letters(values, &missing))
        });
        let (one, other) = (one?, other?);
        if one == other {
            Ok(one)
        } else {
            Err(no_value(latex::write_expr(&self.expr)))
        }
    }

    fn pointwise(
        &self,
        source: &Source<'_>,
        letters: Vec<BigRational>,
    ) -> Result<BigRational, Obstacle> {
        let world = World::new(self.model, letters).corrected_as(source.exact.world());
        let mut evaluator = world.inserting().evaluator(Rationals);
        match evaluator.expression_without_cases(&self.expr) {
            Ok(Value::Scalar(value)) => Ok(value),
            Ok(_) => Err(Obstacle::Beyond("not a scalar".into())),
            Err(failure) => Err(obstacle(failure, self.span)),
        }
    }

    /// Its unit in SI base units.
    pub(super) fn unit(&self, source: &mut Source<'_>) -> Option<String> {
        source.units.unit_of_expression(&self.expr)
    }
}

/// The factors of what must not vanish that a function shows no longer and that may vanish.
fn cancelled(
    model: &Model,
    conditions: &[Condition<RationalFunction>],
    f: &RationalFunction,
) -> Vec<Polynomial> {
    let mut found: Vec<Polynomial> = Vec::new();
    for condition in conditions {
        match condition.origin {
            Origin::Divisor(_) | Origin::Determinant(_) => {}
            Origin::Stability(_) | Origin::Range { .. } => continue,
        }
        let divisor = condition.divisor.numerator();
        let factors = match divisor.factor_within(&Budget::default()) {
            Ok(product) => product.factors.into_iter().map(|(p, _)| p).collect(),
            Err(_) => vec![divisor.clone()],
        };
        for factor in factors {
            let signs: Vec<bool> = factor.terms().map(|(_, c)| c.is_positive()).collect();
            let never_zero = signs.windows(2).all(|pair| pair[0] == pair[1])
                && (factor.variables_occurring().iter()).all(|l| model.is_positive(*l));
            if !never_zero
                && !found.contains(&factor)
                && f.denominator().div_exact(&factor).is_none()
            {
                found.push(factor);
            }
        }
    }
    found
}

/// Whether an expression with dots and functions vanishes in the letters of the document, its `solve`
/// blocks and definitions inserted.
pub(super) fn vanishes(exact: &mut Evaluator<'_, Symbolic>, latex: &str) -> Option<bool> {
    let expr = latex::parse_expr(latex, 0, &Signature::default()).ok()?;
    match exact.expression(&expr) {
        Ok(Value::Scalar(f)) => Some(f.is_zero()),
        Ok(Value::Zero) => Some(true),
        _ => None,
    }
}
