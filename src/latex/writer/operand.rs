//! Sums, products, quotients, powers and calls.

use super::Writer;
use super::guard::{
    ends_in_bare_argument, ends_in_bare_d, final_name, is_bare_d, is_open_ended, is_slash,
};
use super::symbol::{canonical, enclose, function, number, push};
use crate::expr::{Bracket, Expr, ExprKind, Font, Function, QuotientStyle, Sign};
use crate::latex::parser::{ends_divisor, ends_in_bare_letters, is_mark};
use num_traits::Signed;

impl Writer {
    pub(super) fn expression(self, expr: &Expr) -> String {
        match &expr.kind {
            ExprKind::Sum(terms) => self.sum(terms),
            ExprKind::Product(factors) => match self.product(factors, false) {
                Some(text) => text,
                None => self.group(expr),
            },
            ExprKind::Quotient {
                numerator,
                denominator,
                style: QuotientStyle::Slash,
            } => self.slash(numerator, denominator),
            _ => self.operand(expr),
        }
    }

    pub(super) fn sum(self, terms: &[(Sign, Expr)]) -> String {
        let mut text = String::new();
        for (position, (sign, term)) in terms.iter().enumerate() {
            let sign = match (sign, position) {
                (Sign::Plus, 0) if terms.len() > 1 => "",
                (Sign::Plus, 0) => "+",
                (Sign::Minus, 0) => "-",
                (Sign::Plus, _) if self.compact => "+",
                (Sign::Minus, _) if self.compact => "-",
                (Sign::Plus, _) => " + ",
                (Sign::Minus, _) => " - ",
            };
            text += sign;
            push(&mut text, &self.term(term));
        }
        text
    }

    /// What a sign may stand before.
    pub(super) fn term(self, expr: &Expr) -> String {
        match expr.kind {
            ExprKind::Sum(_) => self.group(expr),
            _ => self.expression(expr),
        }
    }

    pub(super) fn group(self, expr: &Expr) -> String {
        let bracket = Bracket::Round;
        // Brackets end what a differential reaches.
        let inside = Writer {
            differential: false,
            ..self
        };
        enclose(bracket, &inside.expression(expr))
    }

    /// Factors side by side; with `tight`, nothing if a dot would be needed between them.
    pub(super) fn product(self, factors: &[Expr], tight: bool) -> Option<String> {
        let mut text = String::new();
        for (position, factor) in factors.iter().enumerate() {
            let last = position + 1 == factors.len();
            let bracketed = match &factor.kind {
                ExprKind::Sum(_) | ExprKind::Product(_) => true,
                ExprKind::Quotient {
                    style: QuotientStyle::Slash,
                    ..
                } => tight || !last && is_open_ended(factor),
                _ => !last && is_open_ended(factor),
            };
            let piece = if bracketed {
                self.group(factor)
            } else {
                self.expression(factor)
            };
            if position > 0 {
                let before = &factors[position - 1];
                if self.needs_dot(before, factor, &piece, bracketed) {
                    if tight {
                        return None;
                    }
                    text += " \\cdot ";
                } else if ends_in_bare_argument(before) || piece.starts_with("\\sum") {
                    text += " ";
                }
            }
            push(&mut text, &piece);
        }
        Some(text)
    }

    pub(super) fn slash(self, numerator: &Expr, denominator: &Expr) -> String {
        let derivative = is_bare_d(numerator);
        let side = |expr: &Expr, below: bool| {
            let writer = Writer {
                differential: self.differential || below && derivative,
                ..self
            };
            match &expr.kind {
                ExprKind::Sum(_) => None,
                ExprKind::Quotient {
                    style: QuotientStyle::Slash,
                    ..
                } => None,
                // What is put into a bracket as a factor ends a divisor as well.
                ExprKind::Product(factors)
                    if below
                        && (ends_divisor(numerator, &factors[0])
                            || is_open_ended(&factors[0])
                            || is_slash(&factors[0])
                            || matches!(factors[0].kind, ExprKind::Product(_))) =>
                {
                    None
                }
                ExprKind::Product(factors) => writer.product(factors, true),
                _ => Some(writer.operand(expr)),
            }
        };
        let takes_slash = match &numerator.kind {
            ExprKind::Product(factors) => factors.last().is_some_and(ends_in_bare_letters),
            _ => ends_in_bare_letters(numerator),
        };
        let first = match &denominator.kind {
            ExprKind::Product(factors) => &factors[0],
            _ => denominator,
        };
        let guarded =
            is_open_ended(numerator) || takes_slash && !matches!(first.kind, ExprKind::Call { .. });
        let above = side(numerator, false).filter(|_| !guarded);
        let above = above.unwrap_or_else(|| self.group(numerator));
        let below = side(denominator, true).unwrap_or_else(|| self.group(denominator));
        format!("{above}/{below}")
    }

    /// Everything that is neither a sum, nor a product, nor a slash.
    pub(super) fn operand(self, expr: &Expr) -> String {
        match &expr.kind {
            ExprKind::Sum(_) | ExprKind::Product(_) => self.group(expr),
            ExprKind::Number(value) => number(value),
            ExprKind::Name(name) => canonical(name),
            ExprKind::Apply {
                function,
                arguments,
            } => canonical(function) + &enclose(Bracket::Round, &self.list(arguments)),
            ExprKind::Named { name, value } => {
                format!("{} = {}", canonical(name), self.inside().expression(value))
            }
            ExprKind::Call { function, argument } => self.call(*function, argument, None),
            ExprKind::Quotient {
                numerator,
                denominator,
                style,
            } => {
                if *style == QuotientStyle::Slash {
                    return self.group(expr);
                }
                let derivative = match &numerator.kind {
                    ExprKind::Product(factors) => factors.first().is_some_and(is_bare_d),
                    _ => is_bare_d(numerator),
                };
                let below = Writer {
                    differential: derivative,
                    ..self
                };
                format!(
                    "\\frac{{{}}}{{{}}}",
                    self.inside().expression(numerator),
                    below.expression(denominator)
                )
            }
            ExprKind::Power { base, exponent } => self.power(base, exponent),
            ExprKind::Transpose(base) => self.transpose(base),
            ExprKind::Group { bracket, inner } => {
                enclose(*bracket, &self.inside().expression(inner))
            }
            ExprKind::Matrix { rows, bracket } => self.inside().matrix(rows, *bracket),
            ExprKind::Tuple(items) => enclose(Bracket::Round, &self.list(items)),
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => {
                let script = self.inside().script();
                let mut text = format!(
                    "\\sum_{{{}={}}}^{{{}}} ",
                    canonical(index),
                    script.expression(from),
                    script.expression(to)
                );
                push(&mut text, &self.term(body));
                text
            }
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => {
                let mut text = "\\int".to_owned();
                if let Some((lower, upper)) = limits {
                    let script = self.inside().script();
                    text += &format!(
                        "_{{{}}}^{{{}}}",
                        script.expression(lower),
                        script.expression(upper)
                    );
                }
                let integrand = Writer {
                    differential: true,
                    ..self
                };
                text.push(' ');
                text += &if ends_in_bare_d(body) {
                    self.group(body)
                } else {
                    integrand.expression(body)
                };
                text + "\\, \\mathrm{d}" + &canonical(variable)
            }
            ExprKind::Derivative {
                order,
                variable,
                body,
            } => self.derivative(*order, variable.as_ref(), body),
            ExprKind::Expectation(inner) => {
                "E".to_owned() + &enclose(Bracket::Curly, &self.inside().expression(inner))
            }
            ExprKind::Underbrace { body, label } => format!(
                "\\underbrace{{{}}}_{{{}}}",
                self.inside().expression(body),
                self.inside().script().chain(label, false)
            ),
            ExprKind::Cases(cases) => self.inside().cases(cases),
            ExprKind::Infinity => "\\infty".to_owned(),
            ExprKind::Constant => "\\mathrm{const}".to_owned(),
        }
    }

    pub(super) fn inside(self) -> Self {
        Writer {
            differential: false,
            ..self
        }
    }

    pub(super) fn list(self, items: &[Expr]) -> String {
        let items: Vec<String> = items
            .iter()
            .map(|item| self.inside().expression(item))
            .collect();
        items.join(if self.compact { "," } else { ", " })
    }

    pub(super) fn call(self, which: Function, argument: &Expr, exponent: Option<&str>) -> String {
        let mut text = function(which).to_owned();
        if let Some(exponent) = exponent {
            text += &format!("^{{{exponent}}}");
        }
        match (which, &argument.kind) {
            (Function::Absolute, _) => {
                return enclose(Bracket::Bar, &self.inside().expression(argument));
            }
            (Function::SquareRoot, _) => {
                return format!("{text}{{{}}}", self.inside().expression(argument));
            }
            (
                Function::Determinant,
                ExprKind::Matrix {
                    rows,
                    bracket: Bracket::Bar,
                },
            ) => return self.inside().matrix(rows, Bracket::Bar),
            _ => {}
        }
        let letters = which.is_elementary();
        let bare = match &argument.kind {
            ExprKind::Group { bracket, .. } => *bracket != Bracket::None,
            ExprKind::Matrix { bracket, .. } => *bracket != Bracket::Bar,
            ExprKind::Name(_) | ExprKind::Apply { .. } | ExprKind::Number(_) => true,
            ExprKind::Power { base, .. } | ExprKind::Transpose(base) => {
                final_name(base).is_some() || matches!(base.kind, ExprKind::Number(_))
            }
            ExprKind::Product(factors) if letters => factors.iter().all(|factor| {
                matches!(factor.kind, ExprKind::Number(_) | ExprKind::Apply { .. })
                    || final_name(factor).is_some()
            }),
            ExprKind::Quotient { style, .. } => letters && *style == QuotientStyle::Bar,
            _ => false,
        };
        let written = match &argument.kind {
            ExprKind::Product(factors) if bare => self.product(factors, true),
            _ if bare => Some(self.operand(argument)),
            _ => None,
        };
        // A bracket that is only the beginning of the argument would end it.
        let whole = matches!(
            argument.kind,
            ExprKind::Group { .. } | ExprKind::Matrix { .. }
        );
        let argument = written
            .filter(|text| whole || !text.starts_with('('))
            .unwrap_or_else(|| self.group(argument));
        if argument.starts_with(|c: char| c.is_ascii_alphanumeric()) {
            text.push(' ');
        }
        text + &argument
    }

    /// Whether an exponent can be set at this base as it is.
    pub(super) fn is_atom(base: &Expr) -> bool {
        match &base.kind {
            ExprKind::Number(value) => !value.is_negative() && value.is_integer(),
            ExprKind::Name(_)
            | ExprKind::Apply { .. }
            | ExprKind::Matrix { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Call {
                function: Function::Absolute | Function::SquareRoot,
                ..
            } => true,
            ExprKind::Group { bracket, .. } => *bracket != Bracket::None,
            ExprKind::Call {
                function: Function::Determinant,
                argument,
            } => matches!(
                argument.kind,
                ExprKind::Matrix {
                    bracket: Bracket::Bar,
                    ..
                }
            ),
            _ => false,
        }
    }

    pub(super) fn power(self, base: &Expr, exponent: &Expr) -> String {
        let script = self.inside().script();
        // A bracket around a whole exponent looks like a mark.
        let mut above = match &exponent.kind {
            ExprKind::Group { inner, .. } if is_mark(base, exponent) => script.expression(inner),
            _ => script.expression(exponent),
        };
        if matches!(
            above.trim_start_matches('-'),
            "T" | "t" | "\\mathrm{T}" | "\\mathrm{t}"
        ) {
            above = format!("({above})");
        }
        if Self::is_atom(base) {
            return with_exponent(self.operand(base), &above);
        }
        if let ExprKind::Call { function, argument } = &base.kind
            && above != "-1"
        {
            return self.call(*function, argument, Some(&above));
        }
        with_exponent(self.group(base), &above)
    }

    pub(super) fn transpose(self, base: &Expr) -> String {
        let (base, above) = match &base.kind {
            ExprKind::Power {
                base: inverted,
                exponent,
            } if self.script().expression(exponent) == "-1" => (&**inverted, "-T"),
            _ => (base, "T"),
        };
        let scalar = match &base.kind {
            ExprKind::Number(_) => true,
            ExprKind::Name(name) => name.letter.base == "e" && name.letter.font != Font::Bold,
            _ => false,
        };
        let base = if Self::is_atom(base) && !scalar {
            self.operand(base)
        } else {
            self.group(base)
        };
        with_exponent(base, above)
    }
}

fn with_exponent(base: String, above: &str) -> String {
    let mut characters = above.chars();
    match (characters.next(), characters.next()) {
        (Some(c), None) if c.is_ascii_alphanumeric() => format!("{base}^{c}"),
        _ => format!("{base}^{{{above}}}"),
    }
}
