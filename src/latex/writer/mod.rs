//! From the tree back to LaTeX that a journal takes.
//!
//! What is written reads back as the tree it came from. Where the page would be misread without
//! a bracket or a dot (a sum as a factor, a number after a letter, `f(x)` meant as a product),
//! it is written with one. The canonical form of a name is what this module writes for it.

mod environment;
mod guard;
mod operand;
mod symbol;

pub use symbol::{canonical, relation as write_relation};

use super::lexer::{Lexeme, Token};
use crate::expr::{Chain, Clause, Display, Expr, ExprKind, IndexRange};
use num_traits::One;
use symbol::{number, push, upright};

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

    fn chain(self, chain: &Chain, aligned: bool) -> String {
        let mut text = String::new();
        for (position, member) in chain.members.iter().enumerate() {
            if position > 0 {
                let sign = write_relation(chain.relations[position - 1]);
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
        if let Some(word) = &clause.joined {
            text += &format!("\\text{{{word} }} ");
        }
        text += &match clause.chain.members.as_slice() {
            // Set apart, a number in plain brackets would be the number of the equation.
            [only] if matches!(only.kind, ExprKind::Group { .. }) => {
                let plain = self.expression(only);
                match plain.strip_prefix('(').and_then(|p| p.strip_suffix(')')) {
                    Some(inner) => format!("\\left({inner}\\right)"),
                    None => plain,
                }
            }
            _ => self.chain(&clause.chain, aligned),
        };
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
