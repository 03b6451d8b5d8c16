//! Brackets that end too early or too late, a term or factor on the wrong side of a bracket, a bar,
//! a slash or a root.

use super::build::{factors, group, product, quotient, sum, terms, times};
use super::{Change, Replacement, Scene};
use crate::expr::{Expr, ExprKind, Sign};
use crate::span::Span;
use crate::verdict::EditClass;

pub(super) fn edits(scene: &Scene<'_>) -> Vec<Replacement> {
    let mut found = Vec::new();
    for site in scene.sites_in_time() {
        if site.is_count() {
            continue;
        }
        let span = site.expr.span;
        let forms = match &site.expr.kind {
            ExprKind::Sum(terms) => {
                let edits = of_sum(terms, span).into_iter().map(|(change, rare)| {
                    Replacement::of(site, EditClass::Bracket, change).rarer(rare)
                });
                found.extend(edits);
                continue;
            }
            ExprKind::Product(items) => of_product(items, span),
            ExprKind::Quotient { .. } => of_quotient(site.expr),
            ExprKind::Call { .. } => of_call(site.expr),
            _ => Vec::new(),
        };
        let edits = forms
            .into_iter()
            .map(|(form, rare)| Replacement::new(site, EditClass::Bracket, form).rarer(rare));
        found.extend(edits);
    }
    found
}

type Terms = Vec<(Sign, Expr)>;
/// Other forms, and how much rarer each is.
type Forms = Vec<(Expr, u32)>;

/// How many neighbours of a term come into a bracket, or leave one, at most: a bracket around more of a
/// long sum is no slip of the hand.
const REACH: usize = 6;

fn of_sum(terms: &[(Sign, Expr)], span: Span) -> Vec<(Change, u32)> {
    let mut found = Vec::new();
    let spliced = |from, to, by| Change::of_terms(terms, from, to, by);
    for (k, (sign, term)) in terms.iter().enumerate() {
        // A term of which a part leaves its bracket, bar or root: a(b + c) for ab + c.
        for (opened, rare) in opened(term) {
            let by = with_first_sign(opened, *sign);
            found.push((spliced(k, k + 1, by), rare));
        }
        let last = terms.len().min(k + REACH);
        // The neighbour on the right comes into its last bracket, bar or root: ab + c for a(b + c).
        for to in k + 2..=last {
            for (closed, rare) in swallowed(term, &terms[k + 1..to]) {
                let rare = rare + u32::from(to < terms.len());
                found.push((spliced(k, to, vec![(*sign, closed)]), rare));
            }
        }
        // The neighbours on the left come into its first: a + bc for (a + b)c.
        for from in k.saturating_sub(REACH)..k {
            let before = terms[from].0;
            for (closed, rare) in swallowed_before(term, &terms[from..k], *sign) {
                let rare = rare + u32::from(from > 0);
                found.push((spliced(from, k + 1, vec![(before, closed)]), rare));
            }
        }
        // -(a - b) for -a - b: a bracket after a minus that ends too late or too early.
        if *sign == Sign::Minus {
            for to in k + 2..=last {
                let mut held = terms[k..to].to_vec();
                held[0].0 = Sign::Plus;
                let bracket = group(sum(held, span));
                let rare = u32::from(to < terms.len());
                found.push((spliced(k, to, vec![(Sign::Minus, bracket)]), rare));
            }
        }
    }
    found
}

/// The terms with the sign of what they were in front of the first.
fn with_first_sign(mut terms: Terms, sign: Sign) -> Terms {
    if let Some(first) = terms.first_mut() {
        first.0 = times(first.0, sign);
    }
    terms
}

/// A term with some terms of its last bracket, numerator, denominator or root outside of it.
fn opened(term: &Expr) -> Vec<(Terms, u32)> {
    let span = term.span;
    let mut found = Vec::new();
    let items = factors(term);
    // x(a + b)y: the product goes with the first terms, or with the last.
    for (k, item) in items.iter().enumerate() {
        let ExprKind::Group { inner, .. } = &item.kind else {
            continue;
        };
        let ExprKind::Sum(held) = &inner.kind else {
            continue;
        };
        for cut in 1..held.len() {
            let rare = u32::from(held.len() > 2 && cut + 1 != held.len() && cut != 1);
            if k + 1 == items.len() {
                let mut before = items[..k].to_vec();
                before.push(sum(held[..cut].to_vec(), span));
                let mut by = vec![(Sign::Plus, product(before, span))];
                by.extend(held[cut..].to_vec());
                found.push((by, rare));
            }
            if k == 0 && items.len() > 1 {
                let (sign, first) = held[cut].clone();
                let mut rest = held[cut..].to_vec();
                rest[0] = (Sign::Plus, first);
                let mut after = vec![sum(rest, span)];
                after.extend(items[1..].to_vec());
                let mut by = held[..cut].to_vec();
                by.push((sign, product(after, span)));
                found.push((by, rare));
            }
        }
    }
    if let Some((last, before)) = items.split_last() {
        let rest = |expr: Expr| {
            let mut all = before.to_vec();
            all.push(expr);
            product(all, span)
        };
        match &last.kind {
            ExprKind::Quotient {
                numerator,
                denominator,
                style,
            } => {
                for (place, part) in [(0, numerator), (1, denominator)] {
                    let held = terms(part.without_brackets());
                    for cut in 1..held.len() {
                        let kept = sum(held[..cut].to_vec(), span);
                        let (above, below) = match place {
                            0 => (kept, (**denominator).clone()),
                            _ => ((**numerator).clone(), kept),
                        };
                        let bar = quotient(above, below, *style, span);
                        let mut by = vec![(Sign::Plus, rest(bar))];
                        by.extend(held[cut..].to_vec());
                        found.push((by, 1));
                        // The last terms stay above the bar, the first stand before it.
                        if place == 0 && before.is_empty() {
                            let mut kept = held[cut..].to_vec();
                            let sign = kept[0].0;
                            kept[0].0 = Sign::Plus;
                            let above = sum(kept, span);
                            let bar = quotient(above, (**denominator).clone(), *style, span);
                            let mut by = held[..cut].to_vec();
                            by.push((sign, bar));
                            found.push((by, 1));
                        }
                    }
                }
            }
            ExprKind::Call { function, argument } => {
                let held = terms(argument.without_brackets());
                for cut in 1..held.len() {
                    let kind = ExprKind::Call {
                        function: *function,
                        argument: Box::new(sum(held[..cut].to_vec(), span)),
                    };
                    let mut by = vec![(Sign::Plus, rest(Expr::new(kind, span)))];
                    by.extend(held[cut..].to_vec());
                    found.push((by, 1));
                }
            }
            _ => {}
        }
    }
    found
}

/// A term whose last bracket, bar or root takes the neighbours on the right in.
fn swallowed(term: &Expr, neighbours: &[(Sign, Expr)]) -> Forms {
    let span = term.span;
    let items = factors(term);
    let Some((last, before)) = items.split_last() else {
        return Vec::new();
    };
    let with = |expr: &Expr| {
        let mut held = terms(expr.without_brackets());
        held.extend(neighbours.to_vec());
        sum(held, span)
    };
    let rest = |expr: Expr| {
        let mut all = before.to_vec();
        all.push(expr);
        product(all, span)
    };
    let mut found = Vec::new();
    match &last.kind {
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => {
            let above = quotient(with(numerator), (**denominator).clone(), *style, span);
            let below = quotient((**numerator).clone(), with(denominator), *style, span);
            found.extend([(rest(above), 1), (rest(below), 1)]);
        }
        ExprKind::Call { function, argument } => {
            let kind = ExprKind::Call {
                function: *function,
                argument: Box::new(with(argument)),
            };
            found.push((rest(Expr::new(kind, span)), 1));
        }
        _ => {}
    }
    // In front of a bracket only what multiplies it matters.
    for from in 1..items.len() {
        let tail = product(items[from..].to_vec(), span);
        let mut all = items[..from].to_vec();
        all.push(group(with(&tail)));
        let rare = u32::from(from + 1 < items.len()) * 2;
        found.push((product(all, span), rare));
    }
    found
}

/// A term whose first bracket or numerator takes the neighbours on the left in.
fn swallowed_before(term: &Expr, neighbours: &[(Sign, Expr)], sign: Sign) -> Forms {
    let span = term.span;
    let items = factors(term);
    let with = |expr: &Expr| {
        let mut held = neighbours.to_vec();
        held[0].0 = Sign::Plus;
        let mut inner = terms(expr.without_brackets());
        inner[0].0 = times(inner[0].0, sign);
        held.extend(inner);
        sum(held, span)
    };
    let mut found = Vec::new();
    if let ExprKind::Quotient {
        numerator,
        denominator,
        style,
    } = &term.kind
    {
        let bar = quotient(with(numerator), (**denominator).clone(), *style, span);
        found.push((bar, 1));
    }
    for to in 1..items.len() {
        let head = product(items[..to].to_vec(), span);
        let mut all = vec![group(with(&head))];
        all.extend(items[to..].to_vec());
        found.push((product(all, span), 2 * u32::from(to > 1)));
    }
    found
}

/// A product of which a part leaves its bracket, bar or root; where it is a term, its sum does so.
fn of_product(items: &[Expr], span: Span) -> Forms {
    let whole = Expr::new(ExprKind::Product(items.to_vec()), span);
    let mut found: Forms = opened(&whole)
        .into_iter()
        .map(|(terms, rare)| (sum(terms, span), rare))
        .collect();
    for k in 0..items.len() {
        let mut others = items.to_vec();
        let item = others.remove(k);
        // A factor beside a fraction belongs below its bar, or below its slash.
        for (j, other) in others.iter().enumerate() {
            match &other.kind {
                ExprKind::Quotient {
                    numerator,
                    denominator,
                    style,
                } => {
                    let mut below = factors(denominator);
                    below.push(item.clone());
                    let below = product(below, span);
                    let bar = quotient((**numerator).clone(), below, *style, span);
                    let mut all = others.clone();
                    all[j] = bar;
                    found.push((product(all, span), 0));
                }
                ExprKind::Call { function, argument } if item != *other => {
                    let mut inner = vec![item.clone()];
                    inner.extend(factors(argument.without_brackets()));
                    let kind = ExprKind::Call {
                        function: *function,
                        argument: Box::new(product(inner, span)),
                    };
                    let mut all = others.clone();
                    all[j] = Expr::new(kind, span);
                    found.push((product(all, span), 1));
                }
                _ => {}
            }
        }
    }
    // Two factors of matrices in another order.
    for k in 1..items.len() {
        if super::mark::may_be_matrix(&items[k - 1]) && super::mark::may_be_matrix(&items[k]) {
            let mut exchanged = items.to_vec();
            exchanged.swap(k - 1, k);
            found.push((product(exchanged, span), 5));
        }
    }
    found
}

/// A fraction with a factor on the other side of its bar, beside it, or with terms outside of it.
fn of_quotient(expr: &Expr) -> Forms {
    let ExprKind::Quotient {
        numerator,
        denominator,
        style,
    } = &expr.kind
    else {
        return Vec::new();
    };
    let span = expr.span;
    let mut found: Forms = opened(expr)
        .into_iter()
        .map(|(terms, rare)| (sum(terms, span), rare))
        .collect();
    let (above, below) = (factors(numerator), factors(denominator));
    for k in 0..below.len() {
        let mut rest = below.clone();
        let item = rest.remove(k);
        if rest.is_empty() {
            continue;
        }
        let rest = product(rest, span);
        let mut all = above.clone();
        all.push(item.clone());
        // Above the bar instead of below it; beside it is the same.
        found.push((quotient(product(all, span), rest, *style, span), 0));
    }
    if above.len() > 1 {
        for k in 0..above.len() {
            let mut rest = above.clone();
            let item = rest.remove(k);
            let mut all = below.clone();
            all.push(item);
            let all = product(all, span);
            found.push((quotient(product(rest, span), all, *style, span), 1));
        }
    }
    // \sqrt{a/b} for \sqrt{a}/b and for a/\sqrt{b}.
    for (above, below, part) in [(true, false, numerator), (false, true, denominator)] {
        if let ExprKind::Call { function, argument } = &part.without_brackets().kind {
            let top = if above { argument } else { numerator };
            let bottom = if below { argument } else { denominator };
            let bar = quotient((**top).clone(), (**bottom).clone(), *style, span);
            let kind = ExprKind::Call {
                function: *function,
                argument: Box::new(bar),
            };
            found.push((Expr::new(kind, span), 1));
        }
    }
    // a/(b + c) for a/b + c is in `opened`; (a + b)/c for a + b/c there too.
    found
}

/// A function whose argument ends too late: \sqrt{ab} for \sqrt{a} b, \sqrt{a + b} for \sqrt{a} + b.
fn of_call(expr: &Expr) -> Forms {
    let ExprKind::Call { function, argument } = &expr.kind else {
        return Vec::new();
    };
    let span = expr.span;
    let call = |argument: Expr| {
        let kind = ExprKind::Call {
            function: *function,
            argument: Box::new(argument),
        };
        Expr::new(kind, span)
    };
    let mut found: Forms = opened(expr)
        .into_iter()
        .map(|(terms, rare)| (group(sum(terms, span)), rare))
        .collect();
    match &argument.without_brackets().kind {
        ExprKind::Product(items) => {
            for k in 0..items.len() {
                let mut rest = items.clone();
                let item = rest.remove(k);
                found.push((product(vec![item, call(product(rest, span))], span), 1));
            }
        }
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => {
            let top = call((**numerator).clone());
            let bottom = call((**denominator).clone());
            let above = quotient(top, (**denominator).clone(), *style, span);
            let below = quotient((**numerator).clone(), bottom, *style, span);
            found.extend([(above, 1), (below, 1)]);
        }
        _ => {}
    }
    found
}
