//! Where a corrected equation differs from the printed one, underlined in both.
//!
//! The two trees are compared, not the texts: what is marked is the smallest subexpression that
//! changed, and in sums and products the terms and factors that came or went. How the correction was
//! found does not matter. All that did not change stands as the document has it, verbatim: the changes
//! are put into the printed LaTeX, and what comes out is read back and compared with the corrected
//! tree; where it is another one, the whole is written anew.

use crate::expr::walk::{children, children_mut};
use crate::expr::{Chain, Display, Expr, ExprKind, Font, Letter, Name, QuotientStyle};
use crate::latex::{
    Signature, canonical, parse_display, write_display, write_expr, write_relation,
};
use crate::span::Span;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// The way to a subexpression by the numbers of the children.
type Path = Vec<usize>;

/// Both in LaTeX, with what differs underlined.
pub(super) fn marked(printed: &Expr, corrected: &Expr) -> [String; 2] {
    let mut found = [Vec::new(), Vec::new()];
    compare([printed, corrected], [Vec::new(), Vec::new()], &mut found);
    let [old, new] = found;
    [underlined(printed, &old), underlined(corrected, &new)]
}

/// One place of a display with what should stand there.
struct Replaced {
    span: Span,
    /// As printed and as corrected, with marks.
    marked: [String; 2],
    /// As corrected, as it is read back.
    plain: String,
}

/// A whole display, whose LaTeX as printed begins at `offset` of the document, and the corrected one,
/// with what differs underlined.
pub(super) fn displays(
    source: &str,
    offset: usize,
    pair: [&Display; 2],
    signature: &Signature,
) -> [String; 2] {
    let [printed, corrected] = pair;
    let reader = Source {
        text: source,
        offset,
    };
    let verbatim = || {
        let mut found = Vec::new();
        reader.display(printed, corrected, &mut found)?;
        let plain = reader.spliced(&found, |r| &r.plain)?;
        let read = parse_display(&plain, 0, signature).ok()?;
        (read.clauses == corrected.clauses).then_some(())?;
        Some([
            reader.spliced(&found, |r| &r.marked[0])?,
            reader.spliced(&found, |r| &r.marked[1])?,
        ])
    };
    verbatim().unwrap_or_else(|| anew(source, printed, corrected))
}

/// Both displays written anew, each member with its marks.
fn anew(source: &str, printed: &Display, corrected: &Display) -> [String; 2] {
    let chains =
        |d: &Display| -> Vec<Chain> { d.clauses.iter().map(|c| c.chain.clone()).collect() };
    let (old, new) = (chains(printed), chains(corrected));
    let same = |(a, b): (&Chain, &Chain)| a.relations == b.relations;
    if old.len() != new.len() || !old.iter().zip(&new).all(same) {
        return [source.trim().to_string(), write_display(corrected)];
    }
    let mut texts = [String::new(), String::new()];
    for (k, (old, new)) in old.iter().zip(&new).enumerate() {
        for (i, (a, b)) in old.members.iter().zip(&new.members).enumerate() {
            let between = match (i, k) {
                (0, 0) => String::new(),
                (0, _) => ", \\quad ".to_string(),
                _ => format!(" {} ", write_relation(old.relations[i - 1])),
            };
            for (text, one) in texts.iter_mut().zip(marked(a, b)) {
                *text += &between;
                *text += &one;
            }
        }
    }
    texts
}

/// Printed LaTeX that begins at a place of its document.
struct Source<'s> {
    text: &'s str,
    offset: usize,
}

impl Source<'_> {
    fn of(&self, span: Span) -> Option<&str> {
        let start = span.start.checked_sub(self.offset)?;
        self.text.get(start..span.end.checked_sub(self.offset)?)
    }

    /// The places where two displays of the same structure differ; none for another structure.
    fn display(
        &self,
        printed: &Display,
        corrected: &Display,
        found: &mut Vec<Replaced>,
    ) -> Option<()> {
        if printed.clauses.len() != corrected.clauses.len() {
            return None;
        }
        for (old, new) in printed.clauses.iter().zip(&corrected.clauses) {
            let same = old.heading == new.heading && old.remark == new.remark;
            if !same || old.ranges != new.ranges {
                return None;
            }
            self.chain(&old.chain, &new.chain, found)?;
        }
        Some(())
    }

    fn chain(&self, old: &Chain, new: &Chain, found: &mut Vec<Replaced>) -> Option<()> {
        if old.relations != new.relations || old.members.len() != new.members.len() {
            return None;
        }
        for (old, new) in old.members.iter().zip(&new.members) {
            self.expression(old, new, found)?;
        }
        Some(())
    }

    fn expression(&self, old: &Expr, new: &Expr, found: &mut Vec<Replaced>) -> Option<()> {
        if old == new {
            return Some(());
        }
        let (inner, new_inner) = (children(old), children(new));
        match (&old.kind, &new.kind) {
            (
                ExprKind::Underbrace { body, label },
                ExprKind::Underbrace {
                    body: new_body,
                    label: new_label,
                },
            ) => {
                self.expression(body, new_body, found)?;
                return self.chain(label, new_label, found);
            }
            // The measure of an integral.
            (
                ExprKind::Integral { variable, .. },
                ExprKind::Integral {
                    variable: other, ..
                },
            ) if inner == new_inner => {
                let name = canonical(variable);
                let at = self.of(old.span)?.trim_end().strip_suffix(&name)?.len();
                let start = old.span.start + at;
                found.push(Replaced {
                    span: Span::new(start, start + name.len()),
                    marked: [underline(&name), underline(&canonical(other))],
                    plain: canonical(other),
                });
                return Some(());
            }
            // Divided as a whole: a factor in front.
            (
                _,
                ExprKind::Quotient {
                    numerator,
                    denominator,
                    ..
                },
            ) if **numerator == *old && !matches!(old.kind, ExprKind::Sum(_)) => {
                let text = self.of(old.span)?.to_string();
                let below = write_expr(denominator);
                found.push(Replaced {
                    span: old.span,
                    plain: format!("\\frac{{{text}}}{{{below}}}"),
                    marked: [
                        text.clone(),
                        format!("{} {text}", underline(&format!("\\frac{{1}}{{{below}}}"))),
                    ],
                });
                return Some(());
            }
            _ => {}
        }
        if inner.is_empty() || inner.len() != new_inner.len() || shell(old) != shell(new) {
            found.push(Replaced {
                span: self.without_script(old)?,
                marked: marked(old, new),
                plain: write_expr(new),
            });
            return Some(());
        }
        let is_product = matches!(old.kind, ExprKind::Product(_));
        for (old, new) in inner.into_iter().zip(new_inner) {
            let before = found.len();
            self.expression(old, new, found)?;
            // A factor that becomes one is left out.
            let one = ExprKind::Number(BigRational::one());
            if let [only] = &mut found[before..]
                && is_product
                && new.kind == one
            {
                only.marked[1].clear();
            }
        }
        Some(())
    }

    /// The place of an expression; that of a name reaches over the T of its transpose.
    fn without_script(&self, expr: &Expr) -> Option<Span> {
        let text = self.of(expr.span)?;
        let cut = ["^T", "^t", "^{T}", "^{t}"]
            .iter()
            .find(|t| text.ends_with(**t));
        Some(match (cut, &expr.kind) {
            (Some(cut), ExprKind::Name(_)) => Span::new(expr.span.start, expr.span.end - cut.len()),
            _ => expr.span,
        })
    }

    /// The LaTeX with other texts in these places.
    fn spliced<'r>(
        &self,
        places: &'r [Replaced],
        text: impl Fn(&'r Replaced) -> &'r String,
    ) -> Option<String> {
        let mut all: Vec<(usize, usize, &str)> = Vec::new();
        for place in places {
            let start = place.span.start.checked_sub(self.offset)?;
            all.push((start, place.span.end.checked_sub(self.offset)?, text(place)));
        }
        all.sort_by_key(|(start, ..)| *start);
        let letter = |c: Option<char>| c.is_some_and(|c| c.is_ascii_alphabetic());
        let mut out = String::new();
        let mut at = 0;
        for (start, end, text) in all {
            out += self.text.get(at..start)?;
            if out.trim_end().ends_with(['^', '_']) {
                out += &format!("{{{text}}}");
            } else {
                // A control word must not swallow a letter.
                if letter(out.chars().last()) && letter(text.chars().next()) {
                    out.push(' ');
                }
                out += text;
                if letter(text.chars().last()) && letter(self.text.get(end..)?.chars().next()) {
                    out.push(' ');
                }
            }
            at = end;
        }
        out += self.text.get(at..)?;
        Some(out.trim().to_string())
    }
}

fn underline(text: &str) -> String {
    format!("\\underline{{{text}}}")
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
