//! From the tree back to LaTeX that a journal takes.
//!
//! What is written reads back as the tree it came from. Where the page would be misread without
//! a bracket or a dot (a sum as a factor, a number after a letter, `f(x)` meant as a product),
//! it is written with one. The canonical form of a name is what this module writes for it.

use super::lexer::{Lexeme, Token};
use crate::expr::{
    Accent, Bracket, Chain, Clause, Display, Expr, ExprKind, Font, Function, IndexRange, Letter,
    Name, QuotientStyle, Relation, Sign,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The one spelling of a name: equal strings are equal names.
pub fn canonical(name: &Name) -> String {
    let mut text = letter(&name.letter);
    let mut dots = name.dots;
    while dots > 0 {
        let now = dots.min(4);
        dots -= now;
        let command = ["\\dot", "\\ddot", "\\dddot", "\\ddddot"][usize::from(now) - 1];
        text = format!("{command}{{{text}}}");
    }
    text += &"'".repeat(usize::from(name.letter.primes));
    if let Some(subscript) = &name.subscript {
        let label = &subscript.label;
        let mut characters = label.chars();
        match (characters.next(), characters.next()) {
            (Some(c), None) if c.is_ascii_alphanumeric() => text += &format!("_{c}"),
            _ => text += &format!("_{{{label}}}"),
        }
    }
    text
}

/// An expression.
pub fn write_expr(expr: &Expr) -> String {
    Writer::default().expression(expr)
}

/// A chain of relations.
pub fn write_chain(chain: &Chain) -> String {
    Writer::default().chain(chain, false)
}

/// A display: one equation as it is, several in `aligned`.
pub fn write_display(display: &Display) -> String {
    let writer = Writer::default();
    let mut text = match display.clauses.as_slice() {
        [only] => writer.clause(only, false),
        clauses => {
            let lines: Vec<String> = clauses
                .iter()
                .map(|clause| writer.clause(clause, true))
                .collect();
            format!(
                "\\begin{{aligned}}\n{}\n\\end{{aligned}}",
                lines.join(", \\\\\n")
            )
        }
    };
    if let Some(tag) = &display.tag {
        text += &format!(" \\tag{{{tag}}}");
    }
    text
}

/// The label of a subscript whose items are expressions.
pub(super) fn index_label(indices: &[Expr]) -> String {
    Writer::default().script().list(indices)
}

/// A subscript that is no expression, lexeme by lexeme.
pub(super) fn label(lexemes: &[Lexeme]) -> String {
    let mut text = String::new();
    for lexeme in lexemes {
        let piece = match &lexeme.token {
            Token::Text(word) => upright(word.trim()),
            token => token.spelling(),
        };
        let digits = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        if digits(text.chars().last()) && digits(piece.chars().next()) {
            text.push(' ');
        }
        push(&mut text, &piece);
    }
    text
}

/// Appends, with a blank where a control word would swallow the next letter.
fn push(text: &mut String, piece: &str) {
    let word = text
        .rfind('\\')
        .map(|start| &text[start + 1..])
        .is_some_and(|word| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphabetic()));
    if word && piece.starts_with(|c: char| c.is_ascii_alphabetic()) {
        text.push(' ');
    }
    text.push_str(piece);
}

fn upright(word: &str) -> String {
    if word.chars().all(|c| c.is_ascii_alphanumeric()) {
        format!("\\mathrm{{{word}}}")
    } else {
        format!("\\text{{{word}}}")
    }
}

fn letter(letter: &Letter) -> String {
    let base = &letter.base;
    let text = match letter.font {
        Font::Italic => base.clone(),
        Font::Bold if base.starts_with('\\') => format!("\\boldsymbol{{{base}}}"),
        Font::Bold => format!("\\mathbf{{{base}}}"),
        Font::Roman => upright(base),
        Font::Calligraphic => format!("\\mathcal{{{base}}}"),
        Font::Blackboard => format!("\\mathbb{{{base}}}"),
    };
    match letter.accent {
        None => text,
        Some(Accent::Tilde) => format!("\\tilde{{{text}}}"),
        Some(Accent::Hat) => format!("\\hat{{{text}}}"),
        Some(Accent::Bar) => format!("\\bar{{{text}}}"),
        Some(Accent::Vector) => format!("\\vec{{{text}}}"),
    }
}

fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "\\neq",
        Relation::Less => "<",
        Relation::LessEqual => "\\le",
        Relation::Greater => ">",
        Relation::GreaterEqual => "\\ge",
        Relation::Distributed => "\\sim",
        Relation::Approximately => "\\approx",
        Relation::Tends => "\\to",
    }
}

fn function(function: Function) -> &'static str {
    match function {
        Function::Determinant => "\\det",
        Function::Trace => "\\operatorname{tr}",
        Function::RealPart => "\\operatorname{Re}",
        Function::ImaginaryPart => "\\operatorname{Im}",
        Function::Cosine => "\\cos",
        Function::Sine => "\\sin",
        Function::Exponential => "\\exp",
        Function::Logarithm => "\\ln",
        Function::SquareRoot => "\\sqrt",
        Function::Absolute => "",
    }
}

/// A number; without a finite decimal form, a fraction.
fn number(value: &BigRational) -> String {
    if value.is_negative() {
        return format!("(-{})", number(&-value));
    }
    let (two, five, ten) = (BigInt::from(2), BigInt::from(5), BigInt::from(10));
    let mut rest = value.denom().clone();
    let mut places = 0;
    for prime in [&two, &five] {
        let mut count = 0usize;
        while (&rest % prime).is_zero() {
            rest /= prime;
            count += 1;
        }
        places = places.max(count);
    }
    if !rest.is_one() {
        return format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom());
    }
    if places == 0 {
        return value.numer().to_string();
    }
    let scaled = value * BigRational::from_integer(num_traits::pow(ten, places));
    let digits = format!("{:0>width$}", scaled.to_integer(), width = places + 1);
    let (whole, decimals) = digits.split_at(digits.len() - places);
    format!("{whole}.{decimals}")
}

/// Between the delimiters, which grow with what they hold.
fn enclose(bracket: Bracket, inner: &str) -> String {
    let (open, close) = match bracket {
        Bracket::Round => ("(", ")"),
        Bracket::Square => ("[", "]"),
        Bracket::Curly => ("\\{", "\\}"),
        Bracket::Bar => ("|", "|"),
        Bracket::None => return format!("\\underbrace{{{inner}}}"),
    };
    let tall = ["\\frac", "\\begin", "\\sum", "\\int", "\\underbrace"]
        .iter()
        .any(|command| inner.contains(command));
    if tall || bracket == Bracket::Bar {
        let mut text = format!("\\left{open}");
        push(&mut text, inner);
        text + "\\right" + close
    } else {
        format!("{open}{inner}{close}")
    }
}

/// Whether what is written after it would be taken into it.
fn is_open_ended(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::BigSum { .. }
        | ExprKind::Derivative {
            variable: Some(_), ..
        } => true,
        ExprKind::Product(factors) => factors.last().is_some_and(is_open_ended),
        ExprKind::Quotient {
            denominator,
            style: QuotientStyle::Slash,
            ..
        } => is_open_ended(denominator),
        _ => false,
    }
}

/// The name at the right end of a factor, before its exponent.
fn final_name(expr: &Expr) -> Option<&Name> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Power { base, .. } | ExprKind::Transpose(base) => final_name(base),
        _ => None,
    }
}

/// Whether a function stands at the right end whose argument has no bracket.
fn ends_in_bare_argument(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call { function, argument } => match function {
            Function::SquareRoot | Function::Absolute => false,
            _ => !matches!(
                argument.kind,
                ExprKind::Group { .. } | ExprKind::Matrix { .. } | ExprKind::Sum(_)
            ),
        },
        ExprKind::Power { base, .. } => ends_in_bare_argument(base),
        _ => false,
    }
}

/// Whether a bare argument of a function visibly ends before this factor.
fn ends_argument(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call { function, argument } => {
            *function != Function::Absolute
                && !matches!(
                    argument.kind,
                    ExprKind::Matrix {
                        bracket: Bracket::Bar,
                        ..
                    }
                )
        }
        ExprKind::BigSum { .. } | ExprKind::Integral { .. } => true,
        _ => false,
    }
}

fn is_slash(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        ExprKind::Quotient {
            style: QuotientStyle::Slash,
            ..
        }
    )
}

/// Whether the name is a bare `d`, which before a letter looks like a differential.
fn is_bare_d(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Name(name) => {
            matches!(name.letter.base.as_str(), "d" | "\\partial")
                && name.letter.accent.is_none()
                && name.letter.primes == 0
                && name.dots == 0
                && name.subscript.is_none()
        }
        ExprKind::Power { base, .. } => is_bare_d(base),
        _ => false,
    }
}

#[derive(Clone, Copy, Default)]
struct Writer {
    /// In a script, where signs have no space around them.
    compact: bool,
    /// Where a bare `d` before a letter would be read as a differential.
    differential: bool,
}

impl Writer {
    fn script(self) -> Self {
        Writer {
            compact: true,
            ..self
        }
    }

    fn expression(self, expr: &Expr) -> String {
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

    fn sum(self, terms: &[(Sign, Expr)]) -> String {
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
    fn term(self, expr: &Expr) -> String {
        match expr.kind {
            ExprKind::Sum(_) => self.group(expr),
            _ => self.expression(expr),
        }
    }

    fn group(self, expr: &Expr) -> String {
        let bracket = Bracket::Round;
        // Brackets end what a differential reaches.
        let inside = Writer {
            differential: false,
            ..self
        };
        enclose(bracket, &inside.expression(expr))
    }

    /// Factors side by side; with `tight`, nothing if a dot would be needed between them.
    fn product(self, factors: &[Expr], tight: bool) -> Option<String> {
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

    fn needs_dot(self, before: &Expr, factor: &Expr, piece: &str, bracketed: bool) -> bool {
        if piece.starts_with(|c: char| c.is_ascii_digit()) {
            return true;
        }
        if is_slash(before) || !bracketed && is_slash(factor) {
            return true;
        }
        if ends_in_bare_argument(before) && !ends_argument(factor) {
            return true;
        }
        if self.differential && is_bare_d(before) && final_or_first_name(factor) {
            return true;
        }
        let Some(name) = final_name(before) else {
            return false;
        };
        let opens = |bracket: &str| {
            piece.starts_with(bracket) || piece.starts_with(&format!("\\left{bracket}"))
        };
        if name.letter.base == "E" && (opens("\\{") || opens("(") || opens("[")) {
            return true;
        }
        opens("(") && looks_like_arguments(factor)
    }

    fn slash(self, numerator: &Expr, denominator: &Expr) -> String {
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
                ExprKind::Product(factors) => writer.product(factors, true),
                _ => Some(writer.operand(expr)),
            }
        };
        let above = side(numerator, false).filter(|_| !is_open_ended(numerator));
        let above = above.unwrap_or_else(|| self.group(numerator));
        let below = side(denominator, true).unwrap_or_else(|| self.group(denominator));
        format!("{above}/{below}")
    }

    /// Everything that is neither a sum, nor a product, nor a slash.
    fn operand(self, expr: &Expr) -> String {
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
                text += &integrand.expression(body);
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

    fn inside(self) -> Self {
        Writer {
            differential: false,
            ..self
        }
    }

    fn list(self, items: &[Expr]) -> String {
        let items: Vec<String> = items
            .iter()
            .map(|item| self.inside().expression(item))
            .collect();
        items.join(if self.compact { "," } else { ", " })
    }

    fn call(self, which: Function, argument: &Expr, exponent: Option<&str>) -> String {
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
        let letters = matches!(
            which,
            Function::Cosine | Function::Sine | Function::Exponential | Function::Logarithm
        );
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
        let argument = match &argument.kind {
            ExprKind::Product(factors) if bare => match self.product(factors, true) {
                Some(text) => text,
                None => self.group(argument),
            },
            _ if bare => self.operand(argument),
            _ => self.group(argument),
        };
        if argument.starts_with(|c: char| c.is_ascii_alphanumeric()) {
            text.push(' ');
        }
        text + &argument
    }

    /// Whether an exponent can be set at this base as it is.
    fn is_atom(base: &Expr) -> bool {
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

    fn power(self, base: &Expr, exponent: &Expr) -> String {
        let script = self.inside().script();
        let mut above = script.expression(exponent);
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

    fn transpose(self, base: &Expr) -> String {
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

    fn matrix(self, rows: &[Vec<Expr>], bracket: Bracket) -> String {
        let environment = match bracket {
            Bracket::Round => "pmatrix",
            Bracket::Square => "bmatrix",
            Bracket::Curly => "Bmatrix",
            Bracket::Bar => "vmatrix",
            Bracket::None => "matrix",
        };
        let rows: Vec<String> = rows
            .iter()
            .map(|row| {
                let entries: Vec<String> = row.iter().map(|entry| self.expression(entry)).collect();
                entries.join(" & ")
            })
            .collect();
        let rows = rows.join(" \\\\ ");
        format!("\\begin{{{environment}}} {rows} \\end{{{environment}}}")
    }

    fn derivative(self, order: u8, variable: Option<&Name>, body: &Expr) -> String {
        let Some(variable) = variable else {
            let inner = match body.kind {
                ExprKind::Name(_) => self.group(body),
                _ => self.inside().expression(body),
            };
            let mut text = inner;
            let mut left = order;
            while left > 0 {
                let now = left.min(4);
                left -= now;
                let command = ["\\dot", "\\ddot", "\\dddot", "\\ddddot"][usize::from(now) - 1];
                text = format!("{command}{{{text}}}");
            }
            return text;
        };
        let exponent = if order == 1 {
            String::new()
        } else {
            format!("^{{{order}}}")
        };
        let mut text = format!(
            "\\frac{{\\mathrm{{d}}{exponent}}}{{\\mathrm{{d}}{}{exponent}}} ",
            canonical(variable)
        );
        push(&mut text, &self.term(body));
        text
    }

    fn cases(self, cases: &[(Expr, Vec<Chain>)]) -> String {
        let lines: Vec<String> = cases
            .iter()
            .map(|(value, conditions)| {
                let conditions: Vec<String> = conditions
                    .iter()
                    .map(|condition| self.chain(condition, false))
                    .collect();
                format!("{} & {}", self.expression(value), conditions.join(", "))
            })
            .collect();
        format!("\\begin{{cases}} {} \\end{{cases}}", lines.join(" \\\\ "))
    }

    fn chain(self, chain: &Chain, aligned: bool) -> String {
        let mut text = String::new();
        for (position, member) in chain.members.iter().enumerate() {
            if position > 0 {
                let sign = relation(chain.relations[position - 1]);
                let mark = if aligned && position == 1 { "&" } else { "" };
                text += &format!(" {mark}{sign} ");
            }
            text += &self.expression(member);
        }
        text
    }

    fn clause(self, clause: &Clause, aligned: bool) -> String {
        let mut text = String::new();
        if let Some(heading) = &clause.heading {
            text += &format!("\\text{{{heading}:}} \\quad ");
        }
        text += &self.chain(&clause.chain, aligned);
        if let Some(remark) = &clause.remark {
            text += &format!(" \\text{{ {remark}}}");
        }
        for range in &clause.ranges {
            text += ", \\quad ";
            text += &self.range(range);
        }
        text
    }

    fn range(self, range: &IndexRange) -> String {
        let IndexRange {
            index,
            from,
            step,
            to,
        } = range;
        let index = canonical(index);
        let printed = |expr: &Expr| self.expression(expr);
        let numbers =
            matches!(from.kind, ExprKind::Number(_)) && matches!(step.kind, ExprKind::Number(_));
        let simple = matches!(to.kind, ExprKind::Number(_) | ExprKind::Name(_));
        if numbers && simple {
            return format!(
                "{index} = {}({}){}",
                printed(from),
                printed(step),
                printed(to)
            );
        }
        let second = match (&from.kind, &step.kind) {
            (ExprKind::Number(from), ExprKind::Number(step)) if !step.is_one() => {
                format!("{}, ", number(&(from + step)))
            }
            _ => String::new(),
        };
        format!(
            "{index} = {}, {second}\\ldots, {}",
            printed(from),
            printed(to)
        )
    }
}

fn with_exponent(base: String, above: &str) -> String {
    let mut characters = above.chars();
    match (characters.next(), characters.next()) {
        (Some(c), None) if c.is_ascii_alphanumeric() => format!("{base}^{c}"),
        _ => format!("{base}^{{{above}}}"),
    }
}

/// Whether the factor begins with a name.
fn final_or_first_name(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Apply { .. } => true,
        ExprKind::Derivative { variable: None, .. } => true,
        ExprKind::Power { base, .. } | ExprKind::Transpose(base) => final_or_first_name(base),
        _ => final_name(expr).is_some(),
    }
}

/// Whether the factor, written after a name, would be read as its arguments.
fn looks_like_arguments(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Tuple(_) => true,
        ExprKind::Group { inner, .. } => matches!(
            inner.kind,
            ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Infinity | ExprKind::Constant
        ),
        ExprKind::Power { base, .. } | ExprKind::Transpose(base) => looks_like_arguments(base),
        _ => false,
    }
}
