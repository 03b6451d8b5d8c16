//! Defined functions at any argument, definitions by cases, and integrals by quadrature.
//!
//! A function's body is evaluated with its letters at the arguments' values and nothing kept from
//! before. An integral over the half axis with a cosine in it is summed between the zeros of the
//! cosine and the partial sums accelerated (I. M. Longman 1956; P. Wynn's epsilon algorithm, 1956);
//! every other goes by the adaptive rule as it is.

use super::NumericError;
use super::evaluate::Evaluator;
use super::quadrature::{Limits, integrate, integrate_half_axis};
use super::resolver::{Reference, Resolver};
use super::value::{Failure, FailureKind, Value};
use crate::expr::{Chain, Expr, ExprKind, Function, Name, Relation, Sign};
use crate::span::Span;
use std::f64::consts::PI;

/// Half waves of an oscillating integrand that are summed.
const HALF_WAVES: usize = 48;

/// An end of an interval.
#[derive(Clone, Copy, PartialEq)]
enum End {
    At(f64),
    Infinity,
    MinusInfinity,
}

impl<R: Resolver> Evaluator<'_, R> {
    /// A defined function at its arguments, by position or by name.
    pub(super) fn apply(
        &mut self,
        function: &Name,
        arguments: &[Expr],
        span: Span,
    ) -> Result<Value, Failure> {
        let parameters = self.resolver.parameters(function);
        let mut numbers = Vec::new();
        for (position, argument) in arguments.iter().enumerate() {
            let (node, value) = if let Some((name, value)) = argument.as_named_argument() {
                (self.letter(name, span)?, value)
            } else if let Some(node) = parameters.get(position) {
                (*node, argument)
            } else {
                return Err(Failure::unsupported("a function at another argument", span));
            };
            numbers.push((node, self.number(value)?));
        }
        self.with_numbers(numbers, |e| e.name(function, span))
    }

    fn letter(&self, name: &Name, span: Span) -> Result<R::Node, Failure> {
        match self.resolver.resolve(name, &|_| false) {
            Reference::Node(node) => Ok(node),
            Reference::Bound(_)
            | Reference::Indexed { .. }
            | Reference::Undeclared
            | Reference::WithoutValue => {
                Err(Failure::unsupported("an argument that is no letter", span))
            }
        }
    }

    fn number(&mut self, expr: &Expr) -> Result<f64, Failure> {
        self.expression(expr)?.into_number("argument", expr.span)
    }

    /// Runs `body` while letters have other values.
    fn with_numbers<T>(
        &mut self,
        numbers: Vec<(R::Node, f64)>,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = self.replaced.len();
        self.replaced.extend(numbers);
        let known = std::mem::take(&mut self.known);
        let solved = std::mem::take(&mut self.solved);
        let open = std::mem::take(&mut self.open);
        let result = body(self);
        (self.known, self.solved, self.open) = (known, solved, open);
        self.replaced.truncate(before);
        result
    }

    /// The value of the first case whose conditions are met.
    pub(super) fn by_cases(
        &mut self,
        cases: &[(Expr, Vec<Chain>)],
        span: Span,
    ) -> Result<Value, Failure> {
        for (value, conditions) in cases {
            let mut met = true;
            for condition in conditions {
                met = met && self.is_met(condition)?;
            }
            if met {
                return self.expression(value);
            }
        }
        Err(Failure::unsupported(
            "an argument outside of every case",
            span,
        ))
    }

    fn is_met(&mut self, condition: &Chain) -> Result<bool, Failure> {
        let mut values = Vec::with_capacity(condition.members.len());
        for member in &condition.members {
            values.push(match self.end(member)? {
                End::At(x) => x,
                End::Infinity => f64::INFINITY,
                End::MinusInfinity => f64::NEG_INFINITY,
            });
        }
        let mut met = true;
        for (pair, relation) in values.windows(2).zip(&condition.relations) {
            met &= match relation {
                Relation::Less => pair[0] < pair[1],
                Relation::LessEqual => pair[0] <= pair[1],
                Relation::Greater => pair[0] > pair[1],
                Relation::GreaterEqual => pair[0] >= pair[1],
                Relation::Equal => pair[0] == pair[1],
                Relation::NotEqual => pair[0] != pair[1],
                Relation::Distributed | Relation::Approximately | Relation::Tends => {
                    let what = "such a condition of a case";
                    return Err(Failure::unsupported(what, condition.span));
                }
            };
        }
        Ok(met)
    }

    fn end(&mut self, expr: &Expr) -> Result<End, Failure> {
        match expr.as_infinity() {
            Some(Sign::Plus) => Ok(End::Infinity),
            Some(Sign::Minus) => Ok(End::MinusInfinity),
            None => self.number(expr).map(End::At),
        }
    }

    /// An integral by quadrature.
    pub(super) fn integral(
        &mut self,
        limits: Option<(&Expr, &Expr)>,
        body: &Expr,
        variable: &Name,
        span: Span,
    ) -> Result<Value, Failure> {
        let Some((from, to)) = limits else {
            return Err(Failure::unsupported("an integral without limits", span));
        };
        let (from, to) = (self.end(from)?, self.end(to)?);
        let letter = self.letter(variable, span)?;
        let rate = self.angular_rate(body, letter)?;
        // The first failure of the integrand itself is what is reported.
        let mut failure = None;
        let mut at = |x: f64| {
            let value = self.with_numbers(vec![(letter, x)], |e| e.number(body));
            value.map_err(|f| {
                failure.get_or_insert(f);
                NumericError::NotFinite
            })
        };
        let result = match (from, to) {
            (End::At(a), End::At(b)) if a == b => Ok(0.0),
            (End::At(a), End::At(b)) if a < b => over(&mut at, a, b),
            (End::At(a), End::At(b)) => over(&mut at, b, a).map(|v| -v),
            (End::At(a), End::Infinity) => over_half_axis(&mut |x| at(a + x), rate),
            (End::MinusInfinity, End::Infinity) => {
                over_half_axis(&mut |x| Ok(at(x)? + at(-x)?), rate)
            }
            _ => Err(NumericError::Range),
        };
        match (result, failure) {
            (Ok(value), _) => Ok(Value::Scalar(value)),
            (Err(_), Some(failure)) => Err(failure),
            (Err(error), None) => Err(Failure::new(FailureKind::Numeric(error), span)),
        }
    }

    /// k where the integrand has a factor cos(k x + c); 0 where it has none.
    fn angular_rate(&mut self, body: &Expr, letter: R::Node) -> Result<f64, Failure> {
        let mut angle = None;
        crate::expr::walk::visit(body, &mut |e| {
            if let ExprKind::Call {
                function: Function::Cosine | Function::Sine,
                argument,
            } = &e.kind
            {
                angle.get_or_insert(argument);
            }
        });
        let Some(angle) = angle else {
            return Ok(0.0);
        };
        let mut at = |x: f64| self.with_numbers(vec![(letter, x)], |e| e.number(angle));
        let (zero, one, two) = (at(0.0)?, at(1.0)?, at(2.0)?);
        let rate = one - zero;
        let linear = (two - one - rate).abs() <= 1e-9 * rate.abs();
        Ok(if linear { rate.abs() } else { 0.0 })
    }
}

type Integrand<'f> = &'f mut dyn FnMut(f64) -> Result<f64, NumericError>;

fn over(f: Integrand<'_>, from: f64, to: f64) -> Result<f64, NumericError> {
    match integrate(&mut |x| f(x), &[from, to], Limits::default()) {
        Ok(found) => Ok(found.value),
        Err(error) => Err(error),
    }
}

fn over_half_axis(f: Integrand<'_>, rate: f64) -> Result<f64, NumericError> {
    if rate == 0.0 {
        return integrate_half_axis(&mut |x| f(x), 1.0, &[], Limits::default()).map(|q| q.value);
    }
    let half_wave = PI / rate;
    let limits = Limits {
        relative_tolerance: 1e-14,
        evaluations: 3_000,
    };
    let mut sums = Vec::with_capacity(HALF_WAVES);
    let mut sum = 0.0;
    let mut from = 0.0;
    for k in 0..HALF_WAVES {
        let to = (k as f64 + 0.5) * half_wave;
        sum += match integrate(&mut |x| f(x), &[from, to], limits) {
            Ok(found) => found.value,
            Err(NumericError::Tolerance { value, .. }) => value,
            Err(error) => return Err(error),
        };
        sums.push(sum);
        from = to;
    }
    Ok(accelerated(&sums))
}

/// The limit of a sequence by the epsilon algorithm: the last entry of the last even column.
fn accelerated(sums: &[f64]) -> f64 {
    let mut before = vec![0.0; sums.len() + 1];
    let mut column = sums.to_vec();
    let mut best = *sums.last().unwrap_or(&0.0);
    for k in 1..sums.len() {
        let mut next = Vec::with_capacity(column.len() - 1);
        for i in 0..column.len() - 1 {
            let difference = column[i + 1] - column[i];
            if difference == 0.0 {
                return best;
            }
            next.push(before[i + 1] + 1.0 / difference);
        }
        before = std::mem::replace(&mut column, next);
        if k % 2 == 0
            && let Some(last) = column.last()
        {
            if !last.is_finite() {
                break;
            }
            best = *last;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_alternating_series() {
        let mut sum = 0.0;
        let sums: Vec<f64> = (0..24)
            .map(|k| {
                sum += if k % 2 == 0 { 1.0 } else { -1.0 } / (k as f64 + 1.0);
                sum
            })
            .collect();
        assert!((accelerated(&sums) - 2f64.ln()).abs() < 1e-13);
    }

    /// The transform of 1/(1 + x^2) is pi/2 e^{-k}.
    #[test]
    fn a_cosine_transform() {
        for rate in [0.1, 1.0, 7.0] {
            let value =
                over_half_axis(&mut |x| Ok((rate * x).cos() / (1.0 + x * x)), rate).unwrap();
            let known = PI / 2.0 * (-rate).exp();
            assert!((value - known).abs() < 1e-11, "{rate}: {value} {known}");
        }
    }
}
