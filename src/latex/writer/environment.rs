//! Matrices, derivatives and cases.

use super::Writer;
use super::symbol::{canonical, push};
use crate::expr::{Bracket, Chain, Expr, ExprKind, Name};
use crate::latex::parser::begins_with_bracket;

impl Writer {
    pub(super) fn matrix(self, rows: &[Vec<Expr>], bracket: Bracket) -> String {
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

    pub(super) fn derivative(self, order: u8, variable: Option<&Name>, body: &Expr) -> String {
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
        let body = match begins_with_bracket(body) {
            true => self.group(body),
            false => self.term(body),
        };
        push(&mut text, &body);
        text
    }

    pub(super) fn cases(self, cases: &[(Expr, Vec<Chain>)]) -> String {
        let lines: Vec<String> = cases
            .iter()
            .map(|(value, conditions)| {
                let conditions: Vec<String> = conditions
                    .iter()
                    .map(|condition| self.chain(condition, false))
                    .collect();
                let conditions = match conditions.is_empty() {
                    true => "\\text{otherwise}".to_owned(),
                    false => conditions.join(", "),
                };
                format!("{} & {conditions}", self.expression(value))
            })
            .collect();
        format!("\\begin{{cases}} {} \\end{{cases}}", lines.join(" \\\\ "))
    }
}
