//! Where a corrected equation differs from the printed one, underlined in both.
//!
//! The two trees are compared, not the texts: what is marked is the smallest subexpression that
//! changed, and in sums and products the terms and factors that came or went. How the correction was
//! found does not matter.

use crate::expr::{Chain, Expr, ExprKind, Font, Letter, Name, QuotientStyle};
use crate::latex::write_expr;
use crate::model::links::{children, children_mut};
use crate::span::Span;
use num_rational::BigRational;
use num_traits::Zero;

/// The way to a subexpression by the numbers of the children.
type Path = Vec<usize>;

/// Both in LaTeX, with what differs underlined.
pub(super) fn marked(printed: &Expr, corrected: &Expr) -> [String; 2] {
    let mut found = [Vec::new(), Vec::new()];
    compare([printed, corrected], [Vec::new(), Vec::new()], &mut found);
    let [old, new] = found;
    [underlined(printed, &old), underlined(corrected, &new)]
}

fn compare(pair: [&Expr; 2], paths: [Path; 2], found: &mut [Vec<Path>; 2]) {
    let [old, new] = pair;
    if old == new {
        return;
    }
    let inside = pair.map(children);
    if matches!(
        (&old.kind, &new.kind),
        (ExprKind::Sum(_), ExprKind::Sum(_)) | (ExprKind::Product(_), ExprKind::Product(_))
    ) || shell(old) == shell(new)
    {
        let items = [items(old), items(new)];
        let shorter = items[0].len().min(items[1].len());
        let same = |k: usize, l: usize| items[0][k] == items[1][l];
        let before = (0..shorter).take_while(|k| same(*k, *k)).count();
        let after = (0..shorter - before)
            .take_while(|k| same(items[0].len() - 1 - k, items[1].len() - 1 - k))
            .count();
        let ends = [items[0].len() - after, items[1].len() - after];
        if ends[0] == ends[1] {
            for k in before..ends[0] {
                let step = |side: usize| [paths[side].as_slice(), &[k]].concat();
                if items[0][k].0 == items[1][k].0 {
                    compare([inside[0][k], inside[1][k]], [step(0), step(1)], found);
                } else {
                    found[0].push(step(0));
                    found[1].push(step(1));
                }
            }
        } else {
            for side in 0..2 {
                for k in before..ends[side] {
                    found[side].push([paths[side].as_slice(), &[k]].concat());
                }
            }
        }
        return;
    }
    // A factor that came or went beside a single one.
    for (one, many) in [(0, 1), (1, 0)] {
        if let ExprKind::Product(factors) = &pair[many].kind
            && let Some(kept) = factors.iter().position(|f| f == pair[one])
        {
            let others = (0..factors.len()).filter(|k| *k != kept);
            found[many].extend(others.map(|k| [paths[many].as_slice(), &[k]].concat()));
            return;
        }
    }
    let [old, new] = paths;
    found[0].push(old);
    found[1].push(new);
}

/// The children of a sum with their signs, of anything else as they are.
fn items(expr: &Expr) -> Vec<(bool, &Expr)> {
    match &expr.kind {
        ExprKind::Sum(terms) => terms
            .iter()
            .map(|(sign, term)| (matches!(sign, crate::expr::Sign::Minus), term))
            .collect(),
        _ => children(expr).into_iter().map(|e| (false, e)).collect(),
    }
}

/// What an expression is but for its children.
fn shell(expr: &Expr) -> Expr {
    let mut empty = expr.clone();
    for child in children_mut(&mut empty) {
        child.kind = ExprKind::Number(BigRational::zero());
    }
    if children(expr).is_empty() {
        return expr.clone();
    }
    empty
}

/// The word under the braces that stand for underlines until the LaTeX is written.
const MARK: &str = "marked";

fn underlined(expr: &Expr, paths: &[Path]) -> String {
    let mut copy = expr.clone();
    // The deepest first: their addresses must not move.
    let mut paths = paths.to_vec();
    paths.sort_by_key(|p| std::cmp::Reverse(p.len()));
    for path in &paths {
        wrap(&mut copy, path, false);
    }
    let mut text = write_expr(&copy);
    let close = format!("}}_{{\\mathrm{{{MARK}}}}}");
    while let Some(end) = text.find(&close) {
        let mut depth = 1_usize;
        let mut start = end;
        for (at, byte) in text
            .bytes()
            .enumerate()
            .take(end)
            .collect::<Vec<_>>()
            .into_iter()
            .rev()
        {
            depth = match byte {
                b'}' => depth + 1,
                b'{' => depth - 1,
                _ => depth,
            };
            if depth == 0 {
                start = at;
                break;
            }
        }
        let head = text[..start].trim_end_matches("\\underbrace").to_string();
        text = format!(
            "{head}\\underline{}{}",
            &text[start..=end],
            &text[end + close.len()..]
        );
    }
    text
}

fn wrap(expr: &mut Expr, path: &[usize], bound: bool) {
    if let [step, rest @ ..] = path {
        let binds = match &expr.kind {
            ExprKind::Sum(_) | ExprKind::Product(_) | ExprKind::Power { .. } => true,
            ExprKind::Quotient { style, .. } => *style == QuotientStyle::Slash,
            ExprKind::Transpose(_) | ExprKind::Derivative { .. } => true,
            _ => false,
        };
        if let Some(child) = children_mut(expr).into_iter().nth(*step) {
            wrap(child, rest, binds);
        }
        return;
    }
    let span = expr.span;
    let mut body = std::mem::replace(expr, Expr::new(ExprKind::Infinity, span));
    if bound && matches!(body.kind, ExprKind::Sum(_)) {
        body = Expr::new(
            ExprKind::Group {
                bracket: crate::expr::Bracket::Round,
                inner: Box::new(body),
            },
            span,
        );
    }
    let name = Name {
        letter: Letter {
            base: MARK.into(),
            font: Font::Roman,
            accent: None,
            primes: 0,
        },
        dots: 0,
        subscript: None,
    };
    expr.kind = ExprKind::Underbrace {
        body: Box::new(body),
        label: Box::new(Chain {
            members: vec![Expr::new(ExprKind::Name(name), Span::default())],
            relations: Vec::new(),
            span,
        }),
    };
}

#[cfg(test)]
mod tests {
    use super::marked;
    use crate::latex::{Signature, parse_expr};

    #[test]
    fn the_smallest_change_is_marked_in_both() {
        let read = |text| parse_expr(text, 0, &Signature::default()).expect("LaTeX");
        for (printed, corrected, expected) in [
            (
                "a + b",
                "a - b",
                ["a + \\underline{b}", "a - \\underline{b}"],
            ),
            ("ab", "2ab", ["ab", "\\underline{2}ab"]),
            ("a", "\\pi a", ["a", "\\underline{\\pi}a"]),
            (
                "2(b + c)",
                "2(b + d)",
                [
                    "2\\left(b + \\underline{c}\\right)",
                    "2\\left(b + \\underline{d}\\right)",
                ],
            ),
            (
                "a^2 + c",
                "a^3 + c",
                ["a^{\\underline{2}} + c", "a^{\\underline{3}} + c"],
            ),
            ("a + b + c", "a + c", ["a + \\underline{b} + c", "a + c"]),
            (
                "\\frac{a}{b}",
                "\\frac{b}{a}",
                [
                    "\\frac{\\underline{a}}{\\underline{b}}",
                    "\\frac{\\underline{b}}{\\underline{a}}",
                ],
            ),
        ] {
            assert_eq!(marked(&read(printed), &read(corrected)), expected);
        }
    }
}
