//! A verdict in one line.

use crate::audit::Audit;
use crate::expr::{Display, ExprKind, Relation};
use crate::latex;
use crate::model::links::{Link, Place};
use crate::report::formula::{Formulas, Script};
use crate::report::prose::Prose;
use crate::theory::limit::Limit;
use crate::verdict::{
    Correction, CounterProof, Edit, Ended, Given, GivenEntry, Misfit, Outcome, Part, PointValue,
    PositiveBy, Positivity, Preferred, Refutation, ResidualEntry, Searched, Shown, SignCondition,
    Structure, Verdict, Witness,
};
use num_rational::BigRational;
use ratpoly::RationalFunction;

/// Formulas of more characters than this are left to the longer explanation.
const LONG: usize = 90;

/// Why the verdict is what it is, in one line, with the hypotheses printed around the equation
/// and the instances that it was found for.
pub fn reason(audit: &Audit, formulas: &Formulas, outcome: &Outcome) -> Prose {
    let mut line = bare_reason(audit, formulas, outcome);
    if matches!(
        outcome.verdict,
        Verdict::Definition { .. } | Verdict::Recalled { .. }
    ) {
        return line;
    }
    if !outcome.assumed.is_empty() {
        let hypotheses = outcome.assumed.iter().map(|h| Prose::new().math(h.clone()));
        line = line
            .words(", given ")
            .then(Prose::joined(hypotheses, ", "))
            .words(" as assumed");
    }
    line = line.then(with_corrections(audit, outcome));
    if let Verdict::Refuted(refutation) | Verdict::Misprint { refutation, .. } = &outcome.verdict
        && let Some(contradicted) = &refutation.contradicted
    {
        line = line.words(format!("; {contradicted}"));
    }
    let instances = instances(audit, outcome);
    // What holds for any size says no sizes.
    let holds = matches!(
        outcome.verdict,
        Verdict::Holds { .. } | Verdict::HoldsGiven(..)
    );
    if instances.is_empty() || holds && outcome.sizes.is_none() {
        line
    } else {
        line.words(format!(", for {instances}"))
    }
}

/// `f = 2, 3`; empty where sizes depend on no letter.
pub fn instances(audit: &Audit, outcome: &Outcome) -> String {
    let of = |letter: &str| -> Vec<usize> {
        let mut values: Vec<usize> = outcome
            .instances
            .iter()
            .filter_map(|i| audit.model.instances.get(*i)?.get(letter).copied())
            .collect();
        values.sort_unstable();
        values.dedup();
        values
    };
    let mut all = audit
        .model
        .instances
        .iter()
        .flat_map(|i| i.keys())
        .collect::<Vec<_>>();
    all.sort_unstable();
    all.dedup();
    let shown: Vec<String> = all
        .into_iter()
        .map(|letter| {
            let values: Vec<String> = of(letter).iter().map(ToString::to_string).collect();
            format!("{letter} = {}", values.join(", "))
        })
        .collect();
    shown.join(" and ")
}

/// What a link says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Two things are the same.
    Equality,
    /// Something tends to something.
    Limit,
    /// Something is constant.
    Constant,
    /// An order, or something else.
    Other,
}

/// What the link of an outcome says.
pub fn kind_of(audit: &Audit, outcome: &Outcome) -> Kind {
    let equation = &audit.model.equations[outcome.equation];
    let link = &equation.links[outcome.member - 1];
    let is_constant = |place: Place| {
        let side = place.find(&equation.display).map(|e| &e.kind);
        matches!(side, Some(ExprKind::Constant))
    };
    match link.relation {
        Relation::Tends => Kind::Limit,
        Relation::Equal if is_constant(link.left) || is_constant(link.right) => Kind::Constant,
        Relation::Equal => Kind::Equality,
        _ => Kind::Other,
    }
}

/// Why something is positive.
fn positive(positivity: &Positivity) -> Prose {
    let line = match &positivity.by {
        PositiveBy::Declared(name) => Prose::of("positive definite as ")
            .math(name.clone())
            .words(" is declared to be"),
        PositiveBy::Minors(n) => Prose::of(format!("its {n} leading minors are positive")),
        PositiveBy::PrincipalMinors(n) => Prose::of(format!(
            "no principal minor is negative, of any order to {n}"
        )),
        PositiveBy::Structure => Prose::of(
            "made of definite matrices by sums, positive multiples, congruences and inverses",
        ),
        PositiveBy::Hurwitz(n) => Prose::of(format!("its {n} Hurwitz determinants are positive")),
        PositiveBy::Sign => Prose::of("positive for all values of the letters"),
    };
    if positivity.form {
        Prose::of("a quadratic form, zero only where all its arguments vanish; its matrix is ")
            .then(line)
    } else {
        line
    }
}

/// The same without hypotheses and instances.
pub fn bare_reason(audit: &Audit, formulas: &Formulas, outcome: &Outcome) -> Prose {
    let formulas = &*formulas.here(&audit.model, outcome);
    if let Some(positivity) = &outcome.positivity {
        return positive(positivity);
    }
    match &outcome.verdict {
        Verdict::Holds { by, .. } if by.is_empty() => Prose::of(match kind_of(audit, outcome) {
            Kind::Limit => "the limit is this one",
            Kind::Constant => "its derivative by the time vanishes",
            Kind::Equality => "identity in the printed letters",
            Kind::Other => "true for all values of the letters",
        }),
        Verdict::Holds { by, .. } => Prose::of(format!("identity with {} inserted", labels(by))),
        Verdict::HoldsGiven(given, _) => {
            let mut line = hypothesis(formulas, given);
            if let Some(entry) = given.cofactors.first() {
                line = line.words("; ").then(place(&entry.entry));
                line = line.then(short(combination(formulas, given, entry), &entry.entry));
                if given.cofactors.len() > 1 {
                    line = line.words(format!("; {} such entries", given.cofactors.len()));
                }
            }
            line
        }
        Verdict::Misprint {
            refutation: _,
            correction,
        } => {
            let class = classes(&correction.edits);
            let class = match &correction.definition {
                Some((definition, _)) => {
                    let label = &audit.model.equations[*definition].label;
                    format!("definition ({label}), {class}: ")
                }
                None => format!("{class}: "),
            };
            after(audit, outcome)
                .words(class)
                .then(edits(&correction.edits))
                .words("; ")
                .words(uniqueness(correction))
                .then(match &correction.given {
                    Some(given) => {
                        Prose::of("; then it holds given ").then(relations(formulas, given))
                    }
                    None => Prose::new(),
                })
        }
        Verdict::Refuted(refutation) => {
            let line = false_because(audit, formulas, outcome, refutation, usize::MAX);
            match refutation.searched {
                Some(Searched { budget: 0, .. }) => {
                    line.words("; no correction: the budget is empty")
                }
                Some(searched) => line.words(format!("; no correction{}", in_vain(&searched))),
                None => line,
            }
        }
        Verdict::Undecided { reason } => Prose::of(reason.clone()),
        Verdict::Definition { what } => {
            let is_solved = audit
                .model
                .systems
                .iter()
                .any(|s| s.equation == outcome.equation);
            let line = Prose::of(if is_solved { "determines " } else { "defines " });
            match is_words(what) {
                true => defined(what),
                false => line.then(defined(what)),
            }
        }
        Verdict::Recalled { reason } => Prose::text(reason),
    }
}

/// Why a link is false, with the point that shows it where that has at most so many letters.
pub fn false_because(
    audit: &Audit,
    formulas: &Formulas,
    outcome: &Outcome,
    refutation: &Refutation,
    most_letters: usize,
) -> Prose {
    let mut line = after(audit, outcome).then(missing(refutation));
    if let Some(entry) = refutation.residual.first() {
        if !missing(refutation).is_empty() {
            line = line.words("; read as zero, ");
        }
        line = line.then(place(entry));
        line = line.then(short(difference(formulas, &entry.difference()), entry));
    }
    let witness = refutation.witness();
    if let Some(witness) = witness.filter(|w| w.point.len() <= most_letters) {
        if !line.is_empty() {
            line = line.words("; ");
        }
        line = line.then(values(formulas, witness));
    }
    if let Some(part) = &refutation.part {
        line = line
            .words("; it holds ")
            .then(where_it_holds(formulas, part));
    }
    line
}

/// How far a search went that found nothing.
pub fn in_vain(searched: &Searched) -> String {
    let Searched {
        tried, of, empty, ..
    } = searched;
    let far = match searched.ended {
        None => format!(" among {tried} tried"),
        Some(Ended::Candidates | Ended::Work) if *tried == 0 => {
            ": it is too dear to search for one".into()
        }
        Some(Ended::Interrupted) if *tried == 0 => ": the search was interrupted".into(),
        Some(Ended::Candidates | Ended::Work) => {
            format!(": the budget was reached after {tried} of {of} candidates")
        }
        Some(Ended::Interrupted) => format!(": interrupted after {tried} of {of} candidates"),
    };
    match empty {
        0 => far,
        1 => format!("{far}; one makes it true and says nothing any more"),
        _ => format!("{far}; {empty} make it true and say nothing any more"),
    }
}

/// What a definition defines: a name, or in words what else it says.
pub fn defined(what: &str) -> Prose {
    match is_words(what) {
        true => Prose::of(what),
        false => Prose::new().math(what),
    }
}

/// Whether this is no formula but words.
fn is_words(what: &str) -> bool {
    what.contains(' ') && !what.contains(['\\', '_', '^', '(', ','])
}

/// `true as printed, but (30.1) is not, and its correction changes a side; with that `: of a link that an
/// earlier one's correction makes false; else nothing.
pub fn after(audit: &Audit, outcome: &Outcome) -> Prose {
    let Some(after) = &outcome.after else {
        return Prose::new();
    };
    let label = &audit.model.equations[outcome.equation].label;
    let earlier = format!("({label}.{})", after.member);
    Prose::of(match after.true_as_printed {
        true => format!("true as printed, but {earlier} corrects a side of it; with that, "),
        false => format!("with the side that {earlier} corrects, "),
    })
}

/// `, with (8) as corrected`: what was judged so and does not hold as printed.
fn with_corrections(audit: &Audit, outcome: &Outcome) -> Prose {
    let label = |equation: usize| audit.model.equations[equation].label.clone();
    let mut all: Vec<String> = outcome.corrected.iter().map(|e| label(*e)).collect();
    let holds = matches!(
        outcome.verdict,
        Verdict::Holds { .. } | Verdict::HoldsGiven(..)
    );
    if let Some(after) = outcome.after.as_ref().filter(|_| holds) {
        all.push(format!("{}.{}", label(outcome.equation), after.member));
    }
    match all.is_empty() {
        true => Prose::new(),
        false => Prose::of(format!(", with {} as corrected", labels(&all))),
    }
}

/// `(47)`, `(47) and (49)`.
pub fn labels(labels: &[String]) -> String {
    let numbers: Vec<String> = labels.iter().map(|l| format!("({l})")).collect();
    match numbers.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// `bd = ae, implied by (47)`.
pub fn hypothesis(formulas: &Formulas, given: &Given) -> Prose {
    let line = relations(formulas, given);
    if !given.stated.is_empty() {
        line.words(", as the document states")
    } else if given.implied_by.is_empty() {
        line.words(", which nothing in the document implies")
    } else {
        line.words(format!(", implied by {}", labels(&given.implied_by)))
    }
}

/// `bd = ae`, several with commas.
pub fn relations(formulas: &Formulas, given: &Given) -> Prose {
    let relations = given.relations.iter().map(|r| {
        Prose::new().formula(
            formulas.relation(r, Script::Latex),
            formulas.relation(r, Script::Plain),
        )
    });
    let stated = given.stated.iter().map(|h| Prose::new().math(h.clone()));
    Prose::joined(relations.chain(stated), ", ")
}

/// `lhs - rhs = cofactor (relation)`: equal to the residual by the certificate.
pub fn combination(formulas: &Formulas, given: &Given, entry: &GivenEntry) -> [String; 2] {
    [Script::Latex, Script::Plain].map(|script| {
        let terms: Vec<String> = given
            .relations
            .iter()
            .zip(&entry.cofactors)
            .filter(|(_, cofactor)| !cofactor.is_zero())
            .map(|(relation, cofactor)| formulas.multiple(cofactor, relation, script))
            .collect();
        if terms.is_empty() {
            "0".into()
        } else {
            terms.join(" + ").replace("+ -", "- ")
        }
    })
}

/// A rational function for both media.
pub fn difference(formulas: &Formulas, f: &RationalFunction) -> [String; 2] {
    [Script::Latex, Script::Plain].map(|script| formulas.rational(f, script))
}

/// `where x >= 0`, `at x = 3`: where an equation is true that is false elsewhere.
pub fn where_it_holds(formulas: &Formulas, part: &Part) -> Prose {
    let point = |(letter, value): &(usize, BigRational)| {
        let [latex, plain] = [Script::Latex, Script::Plain]
            .map(|s| format!("{} = {}", formulas.letter(*letter, s), inline(value)));
        Prose::new().formula(latex, plain)
    };
    let sign = |condition: &SignCondition| {
        let f = RationalFunction::from(condition.function.clone());
        let [latex, plain] = difference(formulas, &f);
        match condition.negative {
            false => Prose::new().formula(format!("{latex} \\ge 0"), format!("{plain} >= 0")),
            true => Prose::new().formula(format!("{latex} \\le 0"), format!("{plain} <= 0")),
        }
    };
    match part {
        Part::Around(at) => Prose::of("at ").then(Prose::joined(at.iter().map(point), ", ")),
        Part::Signs(choices) => {
            let all = choices
                .iter()
                .map(|conditions| Prose::joined(conditions.iter().map(sign), " and "));
            Prose::of("where ").then(Prose::joined(all, ", or where "))
        }
    }
}

/// Whether the difference of the sides of an entry is too long for a line.
pub fn is_long(formulas: &Formulas, entry: &ResidualEntry) -> bool {
    let [_, plain] = difference(formulas, &entry.difference());
    plain.chars().count() > LONG
}

/// `lhs - rhs = ...`, or how long it would be.
fn short([latex, plain]: [String; 2], entry: &ResidualEntry) -> Prose {
    if plain.chars().count() > LONG {
        let terms = entry.difference().numerator().len();
        return residual_name().words(format!(" has {terms} terms"));
    }
    residual_name()
        .words(" ")
        .formula(format!("= {latex}"), format!("= {plain}"))
}

fn residual_name() -> Prose {
    Prose::new().formula("\\mathrm{lhs}-\\mathrm{rhs}", "lhs - rhs")
}

/// `entry (1,2): `, `p = 4: `, or nothing.
pub fn place(entry: &ResidualEntry) -> Prose {
    place_of(entry.place, &entry.indices)
}

/// The same for a place and indices.
pub fn place_of(place: Option<(usize, usize)>, indices: &[(String, i64)]) -> Prose {
    let mut parts: Vec<Prose> = indices
        .iter()
        .map(|(name, value)| Prose::new().math(format!("{name} = {value}")))
        .collect();
    if let Some((row, column)) = place {
        parts.push(Prose::of(format!("entry ({row},{column})")));
    }
    if parts.is_empty() {
        return Prose::new();
    }
    Prose::joined(parts, ", ").words(": ")
}

/// The sides' values at a witness, `lhs = 3, rhs = 4 at a = 1, b = 2`.
pub fn values(formulas: &Formulas, witness: &Witness) -> Prose {
    let point = Prose::joined(
        witness.point.iter().map(|(letter, value)| {
            let [latex, plain] = [Script::Latex, Script::Plain]
                .map(|s| format!("{} = ", formulas.letter(*letter, s)));
            Prose::new().formula(latex, plain).then(point_value(value))
        }),
        ", ",
    );
    let side = |name: &str, value| {
        let name = Prose::new().formula(format!("\\mathrm{{{name}}}"), name);
        name.words(" = ").then(point_value(value))
    };
    let line = place_of(witness.place, &witness.indices)
        .then(side("lhs", &witness.left))
        .words(", ")
        .then(side("rhs", &witness.right));
    if witness.point.is_empty() {
        line
    } else {
        line.words(" at ").then(point)
    }
}

/// A value at a point: a fraction, or the digits that are certain.
fn point_value(value: &PointValue) -> Prose {
    match value {
        PointValue::Exact(number) => exact(number),
        PointValue::Between(low, high) => {
            let text = PointValue::digits(low, high, 12);
            Prose::new().formula(text.replace("...", "\\ldots"), text)
        }
        PointValue::Complex(parts) => point_value(&parts[0])
            .words(" + ")
            .then(point_value(&parts[1]))
            .formula("\\,\\mathrm{i}", " i"),
    }
}

/// A rational number inside a line.
fn inline(value: &num_rational::BigRational) -> String {
    crate::report::formula::number(value, Script::Plain)
}

/// A rational number inside a line; a very long one by its size.
pub fn exact(value: &num_rational::BigRational) -> Prose {
    // What is longer than that in binary is so in decimal digits.
    let bits = value.numer().bits() + value.denom().bits();
    if bits <= 128 {
        let text = inline(value);
        if text.len() <= 36 {
            return Prose::new().formula(text.clone(), text);
        }
    }
    match crate::numeric::agreement::nearest(value) {
        Some(double) => {
            let text = format!("{double:e}");
            let latex = match text.split_once('e') {
                Some((mantissa, exponent)) => format!("{mantissa}\\cdot 10^{{{exponent}}}"),
                None => text.clone(),
            };
            Prose::new().formula(format!("{latex}\\ldots"), format!("{text}..."))
        }
        None => {
            // 30103/100000 is log10 2.
            let digits = |n: &num_bigint::BigInt| 1 + n.bits() * 30_103 / 100_000;
            let long = digits(value.numer()).max(digits(value.denom()));
            Prose::of(format!("a number of about {long} digits"))
        }
    }
}

/// `H_{0,1} does not exist`, `3x2 * 1x1: these shapes do not fit`, or nothing.
pub fn missing(refutation: &Refutation) -> Prose {
    match refutation.shown() {
        Shown::Point(_) | Shown::CounterProof(CounterProof::Distribution { .. }) => Prose::new(),
        Shown::Structure(structure) => misfitting(structure),
        Shown::CounterProof(proof) => excluded(proof),
    }
}

/// Why there is nothing to compare: a name without a meaning, shapes that do not fit, or neither.
pub fn absent(missing: Option<&str>, misfit: Option<&Misfit>) -> Prose {
    match (missing, misfit) {
        (Some(name), _) => Prose::new().math(name).words(" does not exist"),
        (None, Some(misfit)) => shapes(misfit),
        (None, None) => Prose::new(),
    }
}

/// `shapes do not fit: 4x1 = 1x4`.
fn shapes(misfit: &Misfit) -> Prose {
    let Misfit {
        operation,
        left,
        right,
        ..
    } = misfit;
    Prose::of(match operation.as_str() {
        "times" | "+" | "-" | "=" => format!("shapes do not fit: {left} {operation} {right}"),
        _ => format!("shapes do not fit ({operation}): {left} and {right}"),
    })
}

/// What does not fit, whatever the values are.
fn misfitting(structure: &Structure) -> Prose {
    match structure {
        Structure::Missing { name, .. } => absent(Some(name), None),
        Structure::Misfit(misfit) => shapes(misfit),
        Structure::Elsewhere => Prose::of("the printed argument is not where the limit is taken"),
        Structure::Scope {
            argument,
            bound,
            free,
        } => {
            let line = Prose::new().math(argument.clone()).words(if *bound {
                " is bound by the integral"
            } else {
                " does not occur in what it is an argument of"
            });
            let names = free.iter().map(|name| Prose::new().math(name.clone()));
            line.words(", and ")
                .then(Prose::joined(names, ", "))
                .words(if free.len() == 1 {
                    " is free"
                } else {
                    " are free"
                })
        }
    }
}

/// What was proved instead.
fn excluded(proof: &CounterProof) -> Prose {
    match proof {
        CounterProof::Limit(Limit::Infinite) => Prose::of("it grows beyond every bound"),
        CounterProof::Limit(Limit::MinusInfinite) => Prose::of("it falls below every bound"),
        CounterProof::Limit(Limit::To(value)) if value.is_zero() => Prose::of("it tends to zero"),
        CounterProof::Limit(Limit::To(_)) => Prose::of("it tends to something else"),
        CounterProof::TwoLimits(one, other) => Prose::of(format!(
            "it has no limit: on one way it {}, on another it {}",
            tends(one),
            tends(other)
        )),
        CounterProof::Distribution { .. } => Prose::new(),
        CounterProof::Divergent { reason } => {
            Prose::of(format!("the integral has no value: {reason}"))
        }
        CounterProof::Unstable { order, determinant } => Prose::of(
            "no stationary covariance: the system is not stable, its Hurwitz determinant ",
        )
        .math(format!("H_{order}"))
        .words(format!(" is {determinant}")),
        CounterProof::NoCovariance { minor } => Prose::of(format!(
            "no stationary covariance: it has the negative principal minor {minor}"
        )),
    }
}

/// `tends to zero`, `grows beyond every bound`.
fn tends(limit: &Limit) -> &'static str {
    match limit {
        Limit::Infinite => "grows beyond every bound",
        Limit::MinusInfinite => "falls below every bound",
        Limit::To(value) if value.is_zero() => "tends to zero",
        Limit::To(_) => "tends to another number",
    }
}

/// `H_{k,k+1} -> H_{k+1,1}`, several with commas.
pub fn edits(edits: &[Edit]) -> Prose {
    Prose::joined(
        edits.iter().map(|e| {
            Prose::new()
                .math(e.printed.clone())
                .formula("\\to ", " -> ")
                .math(e.corrected.clone())
        }),
        ", ",
    )
}

/// What kinds of slips some edits mend: `dot and exponent`.
pub fn classes(edits: &[Edit]) -> String {
    let mut words: Vec<&str> = Vec::new();
    for edit in edits {
        if !words.contains(&edit.class.as_str()) {
            words.push(edit.class.as_str());
        }
    }
    words.join(" and ")
}

/// How the correction compares with others.
pub fn uniqueness(correction: &Correction) -> String {
    let tried = correction.tried;
    let because = correction.preferred.map_or_else(String::new, |preferred| {
        format!(", and the one {}", preferred_as(preferred))
    });
    match correction.alternatives.len() {
        0 if correction.unjudged > 0 => format!(
            "a correction at this cost{because} among {tried} tried, {} of which could not be judged",
            correction.unjudged
        ),
        0 => format!("the only correction at this cost{because} among {tried} tried"),
        n => format!(
            "one of {} corrections at this cost{because} among {tried} tried",
            n + 1,
        ),
    }
}

/// What tells the preferred one of several corrections: `whose units fit`.
pub fn preferred_as(preferred: Preferred) -> &'static str {
    match preferred {
        Preferred::Units => "whose units fit",
        Preferred::Symmetry => "with which the matrix is symmetric",
        Preferred::OtherLinks(_) => "with which more of the chain holds",
        Preferred::LaterClaims(_) => "with which more of the later claims hold",
    }
}

/// One side of a link in LaTeX; what stands above or below a brace without the brace.
pub fn side(display: &Display, place: Place) -> String {
    place
        .find(display)
        .map_or_else(String::new, latex::write_expr)
}

/// The link as an equation: `a_4H_3 = ac(c^2de)`.
pub fn equation_of(display: &Display, link: &Link) -> String {
    let left = side(display, link.left);
    if link.left == link.right {
        return left;
    }
    format!(
        "{left} {} {}",
        latex::write_relation(link.relation),
        side(display, link.right)
    )
}

/// `61.2`; the bare label for an equation with one link.
pub fn number_of(audit: &Audit, outcome: &Outcome) -> String {
    audit.model.equations[outcome.equation].number_of(outcome.member)
}
