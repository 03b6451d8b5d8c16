//! The syntax tree as a compact S-expression: how something printed was read, as text that a
//! certificate can carry and a test can compare.

use super::{Bracket, Chain, Display, Expr, ExprKind, Function, QuotientStyle, Relation, Sign};
use crate::latex::canonical;

/// One line for each clause, and the equation number on a line of its own.
pub fn display(display: &Display) -> String {
    let mut lines = Vec::new();
    for clause in &display.clauses {
        let mut line = String::new();
        if let Some(heading) = &clause.heading {
            line += &format!("<{heading}> ");
        }
        line += &chain(&clause.chain);
        for range in &clause.ranges {
            line += &format!(
                " | {} from {} by {} to {}",
                canonical(&range.index),
                expr(&range.from),
                expr(&range.step),
                expr(&range.to)
            );
        }
        if let Some(remark) = &clause.remark {
            line += &format!(" | \"{remark}\"");
        }
        lines.push(line);
    }
    lines.extend(display.tag.as_ref().map(|tag| format!("#{tag}")));
    lines.join("\n")
}

/// Members with their relations between them.
pub fn chain(chain: &Chain) -> String {
    let mut text = expr(&chain.members[0]);
    for (relation, member) in chain.relations.iter().zip(&chain.members[1..]) {
        text += &format!(" {} {}", self::relation(*relation), expr(member));
    }
    text
}

/// The sign of a relation.
pub fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "!=",
        Relation::Less => "<",
        Relation::LessEqual => "<=",
        Relation::Greater => ">",
        Relation::GreaterEqual => ">=",
        Relation::Distributed => "~",
        Relation::Approximately => "~=",
        Relation::Tends => "->",
    }
}

fn list(head: &str, items: &[&Expr]) -> String {
    let mut text = format!("({head}");
    for item in items {
        text += " ";
        text += &expr(item);
    }
    text + ")"
}

/// An expression.
pub fn expr(tree: &Expr) -> String {
    match &tree.kind {
        ExprKind::Number(value) => value.to_string(),
        ExprKind::Name(name) => canonical(name),
        ExprKind::Apply {
            function,
            arguments,
        } => {
            let arguments: Vec<&Expr> = arguments.iter().collect();
            list(&format!("@ {}", canonical(function)), &arguments)
        }
        ExprKind::Named { name, value } => list(&format!(":= {}", canonical(name)), &[value]),
        ExprKind::Call { function, argument } => {
            let head = match function {
                Function::Determinant => "det",
                Function::Trace => "tr",
                Function::RealPart => "Re",
                Function::ImaginaryPart => "Im",
                Function::Cosine => "cos",
                Function::Sine => "sin",
                Function::Tangent => "tan",
                Function::Cotangent => "cot",
                Function::HyperbolicCosine => "cosh",
                Function::HyperbolicSine => "sinh",
                Function::HyperbolicTangent => "tanh",
                Function::Exponential => "exp",
                Function::Logarithm => "ln",
                Function::SquareRoot => "sqrt",
                Function::Absolute => "abs",
            };
            list(head, &[argument])
        }
        ExprKind::Sum(terms) => {
            let terms: Vec<String> = terms
                .iter()
                .map(|(sign, term)| match sign {
                    Sign::Plus => format!("+{}", expr(term)),
                    Sign::Minus => format!("-{}", expr(term)),
                })
                .collect();
            format!("({})", terms.join(" "))
        }
        ExprKind::Product(factors) => {
            let factors: Vec<&Expr> = factors.iter().collect();
            list("*", &factors)
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => {
            let head = match style {
                QuotientStyle::Bar => "frac",
                QuotientStyle::Slash => "/",
            };
            list(head, &[numerator, denominator])
        }
        ExprKind::Power { base, exponent } => list("^", &[base, exponent]),
        ExprKind::Transpose(base) => list("T", &[base]),
        ExprKind::Group { bracket, inner } => list(shape(*bracket), &[inner]),
        ExprKind::Matrix { rows, bracket } => {
            let rows: Vec<String> = rows
                .iter()
                .map(|row| row.iter().map(expr).collect::<Vec<_>>().join(", "))
                .collect();
            let rows = rows.join("; ");
            match bracket {
                Bracket::Square => format!("[{rows}]"),
                other => format!("({} [{rows}])", shape(*other)),
            }
        }
        ExprKind::Tuple(items) => {
            let items: Vec<&Expr> = items.iter().collect();
            list("tuple", &items)
        }
        ExprKind::BigSum {
            index,
            from,
            to,
            body,
        } => list(&format!("sum {}", canonical(index)), &[from, to, body]),
        ExprKind::Integral {
            limits,
            body,
            variable,
        } => {
            let head = format!("int {}", canonical(variable));
            match limits {
                Some((lower, upper)) => list(&head, &[lower, upper, body]),
                None => list(&head, &[body]),
            }
        }
        ExprKind::Derivative {
            order,
            variable,
            body,
        } => {
            let variable = variable.as_ref().map_or(".".to_owned(), canonical);
            list(&format!("d{order} {variable}"), &[body])
        }
        ExprKind::Expectation(inner) => list("E", &[inner]),
        ExprKind::Underbrace { body, label } => {
            format!("(under {} : {})", expr(body), chain(label))
        }
        ExprKind::Cases(cases) => {
            let cases: Vec<String> = cases
                .iter()
                .map(|(value, conditions)| {
                    let conditions: Vec<String> = conditions.iter().map(chain).collect();
                    format!("{} if {}", expr(value), conditions.join(", "))
                })
                .collect();
            format!("(cases {})", cases.join("; "))
        }
        ExprKind::Infinity => "inf".to_owned(),
        ExprKind::Constant => "const".to_owned(),
    }
}

fn shape(bracket: Bracket) -> &'static str {
    match bracket {
        Bracket::Round => "round",
        Bracket::Square => "square",
        Bracket::Curly => "curly",
        Bracket::Bar => "bar",
        Bracket::None => "bare",
    }
}
