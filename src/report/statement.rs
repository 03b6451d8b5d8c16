//! Statements and what was found about them, in words.

use crate::audit::Audit;
use crate::document::{Predicate, VerdictWord};
use crate::expr::{Expr, ExprKind};
use crate::latex;
use crate::model::names::Resolved;
use crate::model::range::Range;
use crate::model::statement::Proposition;
use crate::report::algebraic::{equals, shown};
use crate::report::formula::{Formulas, Script, number, width};
use crate::report::prose::{Block, Prose};
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{
    ClosedForm, Fact, Limit, Loose, Measure, Scope, Sign, StatementOutcome, Subject,
};
use num_rational::BigRational;
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// A row of the table has no more characters than this, but for its first fact.
const LINE: usize = 150;
/// A radicand that is wider than this in LaTeX is written as a power.
const LONG_ROOT: usize = 40;

/// `4.1`; the bare label for a statement with one proposition.
pub fn number_of(audit: &Audit, outcome: &StatementOutcome) -> String {
    let statement = &audit.model.statements[outcome.statement];
    if statement.propositions.len() <= 1 {
        statement.label.clone()
    } else {
        format!("{}.{}", statement.label, outcome.member)
    }
}

/// The proposition, if the statement has any.
pub fn proposition_of<'a>(audit: &'a Audit, outcome: &StatementOutcome) -> Option<&'a Proposition> {
    let statement = &audit.model.statements[outcome.statement];
    statement.propositions.get(outcome.member - 1)
}

/// The verdict on a proposition in one line.
pub fn reason(audit: &Audit, formulas: &Formulas, outcome: &StatementOutcome) -> Prose {
    let why = Prose::text(outcome.reason.as_deref().unwrap_or_default());
    let Some(proposition) = proposition_of(audit, outcome) else {
        return why;
    };
    let writer = Writer {
        audit,
        formulas,
        proposition,
    };
    let mut line = writer.claim();
    if outcome.loose == Some(Loose::Otherwise) {
        line = line.words(" is false, while another reading is true");
    }
    if !why.is_empty() && outcome.reason.is_some() {
        line = line.words(": ").then(why);
    }
    for (k, fact) in outcome.facts.iter().enumerate() {
        let next = writer.fact(fact);
        let length = line.to_plain().chars().count() + next.to_plain().chars().count();
        if k > 0 && length > LINE {
            break;
        }
        line = line.words(if k == 0 { ": " } else { "; " }).then(next);
    }
    line
}

/// Everything that was found about a proposition.
pub fn reasoning(audit: &Audit, formulas: &Formulas, outcome: &StatementOutcome) -> Vec<Block> {
    let mut blocks = Vec::new();
    let Some(proposition) = proposition_of(audit, outcome) else {
        let reason = outcome.reason.clone().unwrap_or_default();
        return vec![Block::paragraph(
            Prose::text(&reason).capitalised().words("."),
        )];
    };
    let writer = Writer {
        audit,
        formulas,
        proposition,
    };
    if let Some(reason) = &outcome.reason {
        blocks.push(Block::paragraph(
            Prose::of(reason.clone()).capitalised().words("."),
        ));
    }
    for fact in &outcome.facts {
        blocks.push(Block::paragraph(writer.fact(fact).capitalised().words(".")));
    }
    if let Some(words) = certificate(outcome) {
        blocks.push(Block::paragraph(Prose::of(words)));
    }
    blocks
}

/// What proves the signs that a verdict rests on.
pub fn certificate(outcome: &StatementOutcome) -> Option<String> {
    if outcome.signs.is_empty() {
        return None;
    }
    let verified = outcome.signs.iter().all(|s| s.verify());
    let elementary = outcome.signs.iter().all(|s| s.is_elementary());
    Some(match (verified, elementary) {
        (false, _) => {
            "The certificate of a sign does not verify: this is a fault of the program.".into()
        }
        (true, true) => "The signs were checked by multiplying out their factors, each with \
                         coefficients of one sign or completed to a square."
            .into(),
        (true, false) => "The signs were checked by multiplying out their factors; the sign of at \
                          least one factor is what the polynomial engine found."
            .into(),
    })
}

/// The facts of an outcome, each a sentence.
pub fn facts(audit: &Audit, formulas: &Formulas, outcome: &StatementOutcome) -> Vec<Prose> {
    let Some(proposition) = proposition_of(audit, outcome) else {
        return Vec::new();
    };
    let writer = Writer {
        audit,
        formulas,
        proposition,
    };
    outcome.facts.iter().map(|f| writer.fact(f)).collect()
}

/// What a proposition says: `σ_f^2 increasing in m_R`.
pub fn claim(audit: &Audit, formulas: &Formulas, proposition: &Proposition) -> Prose {
    Writer {
        audit,
        formulas,
        proposition,
    }
    .claim()
}

/// What a number is, in words.
pub fn meaning(
    audit: &Audit,
    formulas: &Formulas,
    proposition: &Proposition,
    measure: &Measure,
) -> Prose {
    Writer {
        audit,
        formulas,
        proposition,
    }
    .measure(measure)
}

/// Whether a verdict needs the reader's attention.
pub fn is_strong(word: VerdictWord) -> bool {
    matches!(
        word,
        VerdictWord::HoldsGiven
            | VerdictWord::Misprint
            | VerdictWord::Refuted
            | VerdictWord::Loose
            | VerdictWord::Undecided
    )
}

struct Writer<'a> {
    audit: &'a Audit,
    formulas: &'a Formulas,
    proposition: &'a Proposition,
}

impl Writer<'_> {
    fn quantity(&self) -> Prose {
        expression(&self.proposition.of)
    }

    fn letter(&self, letter: usize) -> Prose {
        let [latex, plain] =
            [Script::Latex, Script::Plain].map(|s| self.formulas.letter(letter, s).to_string());
        Prose::new().formula(latex, plain)
    }

    fn letters(&self, letters: &[usize], between: &str) -> Prose {
        Prose::joined(letters.iter().map(|l| self.letter(*l)), between)
    }

    fn symbols(&self, symbols: &[usize], between: &str) -> Prose {
        let names = symbols
            .iter()
            .map(|s| Prose::new().math(latex::canonical(&self.audit.model.symbols[*s].name)));
        Prose::joined(names, between)
    }

    fn claim(&self) -> Prose {
        let p = self.proposition;
        let mut line = self.quantity();
        if p.normalised {
            line = Prose::of("normalised ").then(line);
        }
        line = line.words(format!(" {}", p.predicate.as_str()));
        let x = self.symbols(&p.letters, ", ");
        let to = || p.to.as_ref().map(expression);
        line = match p.predicate {
            Predicate::Positive | Predicate::Explicit => line,
            Predicate::MinimalAt | Predicate::MaximalAt | Predicate::NearlyMinimalAt => match &p.at
            {
                Some(at) => line
                    .words(" ")
                    .then(x)
                    .formula("\\;=\\;", " = ")
                    .then(expression(at)),
                None => line.words(" the reference value of ").then(x),
            },
            Predicate::WorseAtTheMinimumOf => {
                let other = p.minimum_of.as_ref().map(expression).unwrap_or_default();
                line.words(" ").then(other).words(" in ").then(x)
            }
            Predicate::SeparatesInto => {
                let groups = p.groups.iter().map(|g| self.symbols(g, ", "));
                line.words(" functions of ")
                    .then(Prose::joined(groups, " and of "))
            }
            Predicate::TendsTo => {
                let to = to().unwrap_or_else(|| Prose::new().formula("\\infty", "∞"));
                let end = if p.to_infinity {
                    ("\\infty", "∞")
                } else {
                    ("0", "0")
                };
                line.words(" ")
                    .then(to)
                    .words(" as ")
                    .then(x)
                    .formula("\\;\\to\\;", " → ")
                    .formula(end.0, end.1)
            }
            Predicate::ProportionalTo
            | Predicate::Equals
            | Predicate::CloseTo
            | Predicate::SmallComparedWith
            | Predicate::MeasuredLike => line.words(" ").then(to().unwrap_or_default()),
            _ => line.words(" ").then(x),
        };
        if p.only_in_box {
            line = line.words(" in the box");
        }
        line
    }

    fn fact(&self, fact: &Fact) -> Prose {
        match fact {
            Fact::Number(measure, value) => self.measured(measure, value),
            Fact::Range {
                measure,
                low,
                high,
                scope,
            } => self
                .measure(measure)
                .words(" from ")
                .then(shown(low))
                .words(" to ")
                .then(shown(high))
                .words(" ")
                .then(self.scope(scope)),
            Fact::Sign(subject, sign, scope) => {
                let line = self.subject(*subject);
                match sign {
                    Sign::Both => line.words(" has both signs "),
                    _ => {
                        let [latex, plain] = relation(*sign);
                        line.formula(latex, plain).words(" ")
                    }
                }
                .then(self.scope(scope))
            }
            Fact::Boundary(subject, polynomials) => {
                let places = polynomials.iter().map(|p| {
                    Prose::new().formula(
                        self.formulas.relation(p, Script::Latex),
                        self.formulas.relation(p, Script::Plain),
                    )
                });
                let line = match subject {
                    Subject::Difference => Prose::of("the two minima coincide where "),
                    _ => self.subject(*subject).words(" changes sign where "),
                };
                line.then(Prose::joined(places, " or "))
            }
            Fact::Witness {
                subject,
                point,
                value,
            } => {
                let at = point.iter().map(|(letter, value)| {
                    self.letter(*letter)
                        .formula("\\;=\\;", " = ")
                        .then(plain_number(value))
                });
                let line = self.subject(*subject).then(equals(&value.clone().into()));
                if point.is_empty() {
                    line
                } else {
                    line.words(" at ").then(Prose::joined(at, ", "))
                }
            }
            Fact::Extremum {
                letter,
                minimum,
                closed,
                scope,
                at_end,
                other,
            } => {
                let kind = if *minimum { "minimum" } else { "maximum" };
                let whose = match (other, &self.proposition.minimum_of) {
                    (true, Some(expr)) => expression(expr),
                    _ => self.quantity(),
                };
                let mut line = Prose::of(format!("the only {kind} of "))
                    .then(whose)
                    .words(" over ")
                    .then(self.letter(*letter));
                if let Some(closed) = closed {
                    line = line
                        .words(" is at ")
                        .then(self.letter(*letter))
                        .formula("\\;=\\;", " = ")
                        .then(self.closed(closed));
                } else {
                    line = line.words(match at_end {
                        true => " is at an end of its range",
                        false => " is an inner one",
                    });
                }
                match scope {
                    Scope::Everywhere => line,
                    _ => line.words(" ").then(self.scope(scope)),
                }
            }
            Fact::Best {
                letter,
                minimum,
                end,
            } => {
                let kind = if *minimum { "less" } else { "larger" };
                let place = if *end {
                    "at that end of the range"
                } else {
                    "there"
                };
                self.quantity()
                    .words(format!(" is {kind} {place} than at all other values of "))
                    .then(self.letter(*letter))
                    .words(", ")
                    .then(self.scope(&Scope::Everywhere))
            }
            Fact::NoExtremum(letter, scope) => Prose::of("there is no stationary point in ")
                .then(self.letter(*letter))
                .words(" ")
                .then(self.scope(scope)),
            Fact::NotOnce {
                letter,
                minimum,
                several,
                scope,
            } => {
                let kind = if *minimum { "least" } else { "largest" };
                let places = match several {
                    true => "several values of ",
                    false => "no value of ",
                };
                let line = Prose::of(format!("it is {kind} at {places}"));
                let line = line.then(self.letter(*letter));
                match scope {
                    Scope::Everywhere => line,
                    _ => line.words(", the others as in the reference"),
                }
            }
            Fact::Limit(_, limit) => Prose::of("the limit is ").then(match limit {
                Limit::Finite(value) => self.function(value),
                Limit::Infinity => Prose::new().formula("\\infty", "∞"),
                Limit::MinusInfinity => Prose::new().formula("-\\infty", "-∞"),
                Limit::Unbounded => Prose::of("infinite, with a sign that depends on the letters"),
            }),
            Fact::Pole(divisors) => {
                let places = divisors.iter().map(|p| {
                    Prose::new().formula(
                        self.formulas.relation(p, Script::Latex),
                        self.formulas.relation(p, Script::Plain),
                    )
                });
                Prose::of("it may have a pole where ").then(Prose::joined(places, " or "))
            }
            Fact::About(scope) => Prose::of("this is said ").then(self.scope(scope)),
            Fact::DependsOn(letters) if letters.is_empty() => Prose::of("it depends on no letter"),
            Fact::DependsOn(letters) => Prose::of("it depends on ")
                .then(self.letters(letters, ", "))
                .words(" and on no other letter"),
            Fact::Quotient(value) => Prose::of("the quotient is ").then(self.function(value)),
            Fact::Units(own, other) => {
                let unit = |unit: &str| match unit.contains('\\') {
                    true => Prose::of(unit),
                    false => Prose::new().formula(in_latex(unit), unit),
                };
                Prose::of("its unit is ")
                    .then(unit(own))
                    .words(", the other is ")
                    .then(unit(other))
            }
            Fact::Separates(sum) => Prose::of(if *sum {
                "it is a sum of such functions: every mixed derivative vanishes"
            } else {
                "it is a product of such functions: every mixed derivative of its logarithm \
                 vanishes"
            }),
            Fact::Functions(letters) => self
                .letters(letters, ", ")
                .words(" in it is no rational function of the letters"),
            Fact::Corrected(equations) => {
                let equations = equations
                    .iter()
                    .map(|e| &self.audit.model.equations[*e].label);
                let equations: Vec<String> = equations.cloned().collect();
                Prose::of(format!(
                    "this is said with {} as corrected",
                    crate::report::reason::labels(&equations)
                ))
            }
            Fact::Explicit(1, terms) => Prose::of(format!(
                "it is a rational function of the letters, with {terms} terms"
            )),
            Fact::Explicit(entries, terms) => Prose::of(format!(
                "its {entries} entries are rational functions of the letters, with {terms} terms \
                 in all"
            )),
        }
    }

    /// A number with its meaning.
    fn measured(&self, measure: &Measure, value: &Algebraic) -> Prose {
        let equal = equals(value);
        let value = shown(value);
        let q = self.quantity();
        match measure {
            Measure::Factor(x, times) => Prose::of("")
                .then(plain_number(times))
                .words(" times the reference value of ")
                .then(self.letter(*x))
                .words(" gives ")
                .then(value)
                .words(" times ")
                .then(q),
            Measure::Threshold(x) => Prose::of("the sign changes at ")
                .then(value)
                .words(" times the reference value of ")
                .then(self.letter(*x)),
            Measure::Stationary(x) => Prose::of("that is ")
                .then(self.letter(*x))
                .then(equal)
                .words(" for the reference values of the others"),
            Measure::SameAgain(x) => q
                .words(" is the same at ")
                .then(self.letter(*x))
                .then(equal),
            Measure::Worse(_) => q
                .words(" is there ")
                .then(value)
                .words(" (relative) above its own minimum"),
            Measure::AgainstReference(_) => q
                .words(" is there ")
                .then(value)
                .words(" times what it is at the reference"),
            _ => self.measure(measure).words(" ").then(value),
        }
    }

    /// What a number is.
    fn measure(&self, measure: &Measure) -> Prose {
        let of = |words: &str, x: &usize| Prose::of(words).then(self.letter(*x));
        match measure {
            Measure::Elasticity(x) => of("elasticity in ", x),
            Measure::QuotientElasticity(x) => of("elasticity of the quotient in ", x),
            Measure::MixedElasticity(x, y) => of("change of the elasticity in ", x)
                .words(" with the logarithm of ")
                .then(self.letter(*y)),
            Measure::Factor(x, times) => self
                .quantity()
                .words(format!(" over its reference value at {times} times "))
                .then(self.letter(*x)),
            Measure::Stationary(x) => of("extremal value of ", x),
            Measure::Distance(x) => of("relative distance of ", x).words(" from its best value"),
            Measure::Loss(_) => Prose::of("relative loss of ").then(self.quantity()),
            Measure::Ratio => Prose::of("ratio at the reference"),
            Measure::Deviation => Prose::of("relative deviation at the reference"),
            Measure::Threshold(x) => {
                of("multiple of the reference value of ", x).words(" at which the sign changes")
            }
            Measure::SameAgain(x) => of("another value of ", x).words(" with the same value"),
            Measure::Worse(_) => {
                Prose::of("relative excess over its own minimum, at the other's minimum")
            }
            Measure::AgainstReference(_) => {
                Prose::of("value at the other's minimum over the value at the reference")
            }
            Measure::Value => Prose::of("value at the reference"),
        }
    }

    fn subject(&self, subject: Subject) -> Prose {
        let of = latex::write_expr(&self.proposition.of);
        let plain = crate::report::plain::plain(&of);
        let derivative = |order: &str, x: usize| {
            let [l, p] = [Script::Latex, Script::Plain].map(|s| self.formulas.letter(x, s));
            let below = if order.is_empty() {
                l.to_string()
            } else {
                format!("{l}^{order}")
            };
            let shown = if order.is_empty() {
                p.to_string()
            } else {
                format!("{p}^{order}")
            };
            let top = if order.is_empty() {
                String::new()
            } else {
                format!("^{order}")
            };
            Prose::new().formula(
                format!("\\partial{top} {of}/\\partial {below}"),
                format!("∂{top}({plain})/∂{shown}"),
            )
        };
        match subject {
            Subject::Quantity => self.quantity(),
            Subject::Derivative(x) => derivative("", x),
            Subject::SecondDerivative(x) => derivative("2", x),
            Subject::Difference => Prose::of("the difference"),
            Subject::QuotientDerivative(x) => {
                Prose::of("the derivative of the quotient by ").then(self.letter(x))
            }
        }
    }

    fn scope(&self, scope: &Scope) -> Prose {
        match scope {
            Scope::Everywhere => Prose::of(self.all_values()).then(self.fixed()),
            Scope::Reference => Prose::of("at the reference values"),
            Scope::Line(x) => Prose::of("for every ")
                .then(self.letter(*x))
                .words(", the others as in the reference"),
            Scope::Above(x, value) => Prose::of(self.all_values())
                .words(" with ")
                .then(self.letter(*x))
                .formula("\\;>\\;", " > ")
                .then(plain_number(value))
                .then(self.fixed()),
            Scope::LineAbove(x, value) => Prose::of("for ")
                .then(self.letter(*x))
                .formula("\\;>\\;", " > ")
                .then(plain_number(value))
                .words(", the others as in the reference"),
            Scope::Box(sides) => {
                let sides = sides.iter().map(|(letter, low, high)| {
                    let [low, high] = [low, high].map(|v| number(v, Script::Plain));
                    self.letter(*letter).formula(
                        format!("\\;\\in[{low},\\,{high}]"),
                        format!(" in [{low}, {high}]"),
                    )
                });
                Prose::of("for ").then(Prose::joined(sides, ", "))
            }
        }
    }

    /// Of letters that are not all positive it is not said that they are.
    fn all_values(&self) -> &'static str {
        let model = &self.audit.model;
        let mut behind = BTreeSet::new();
        for expr in self.proposition.expressions() {
            let mut nodes = BTreeSet::new();
            model.collect(expr, &mut nodes);
            for node in nodes {
                behind.extend(model.symbols_behind(node, &|e| model.display(e)));
            }
            crate::expr::walk::visit(expr, &mut |e| {
                if let ExprKind::Name(name) = &e.kind
                    && let Ok(Resolved::Letter { symbol, .. }) = model.resolve(name, &|_| false)
                {
                    behind.insert(symbol);
                }
            });
        }
        let positive = |symbol: &usize| {
            let symbol = &model.symbols[*symbol];
            // Processes and what they are functions of are no letters of the statement.
            symbol.function_of.is_some()
                || model.arguments.contains(&latex::canonical(&symbol.name))
                || symbol.range == Range::positive()
        };
        match behind.iter().all(positive) {
            true => "for all positive values of the letters",
            false => "for all admitted values of the letters",
        }
    }

    /// Which letters are not free although the scope is all values of the letters.
    fn fixed(&self) -> Prose {
        match &self.proposition.fixed[..] {
            [] => Prose::new(),
            fixed => Prose::of(", ")
                .then(self.symbols(fixed, ", "))
                .words(" as in the reference"),
        }
    }

    fn function(&self, f: &RationalFunction) -> Prose {
        Prose::new().formula(
            self.formulas.rational(f, Script::Latex),
            self.formulas.rational(f, Script::Plain),
        )
    }

    fn closed(&self, closed: &ClosedForm) -> Prose {
        let [latex, plain] = [Script::Latex, Script::Plain].map(|script| {
            let inside = self.formulas.rational(&closed.inside, script);
            let root = match script {
                // A line can break in brackets, but under no root and in no fraction.
                Script::Latex if width(&inside) > LONG_ROOT => {
                    let f = &closed.inside;
                    let [above, below] = [f.numerator(), f.denominator()]
                        .map(|p| format!("({})", self.formulas.polynomial(p, script)));
                    match f.denominator().is_one() {
                        true => format!("{above}^{{1/2}}"),
                        false => format!("\\bigl[{above}/{below}\\bigr]^{{1/2}}"),
                    }
                }
                Script::Latex => format!("\\sqrt{{{inside}}}"),
                _ => format!("√({inside})"),
            };
            let has_root = !closed.outside.is_zero();
            let outside = if closed.outside.is_one() {
                String::new()
            } else {
                format!("{} ", self.formulas.rational(&closed.outside, script))
            };
            let rational = self.formulas.rational(&closed.rational, script);
            match (closed.rational.is_zero(), has_root) {
                (true, true) => format!("{outside}{root}"),
                (_, false) => rational,
                (false, true) => format!("{rational} + {outside}{root}"),
            }
        });
        Prose::new().formula(latex, plain)
    }
}

/// A unit in LaTeX: `\mathrm{N\,s/m^2}`.
pub fn in_latex(unit: &str) -> String {
    format!("\\mathrm{{{}}}", unit.replace(' ', "\\,"))
}

/// Relations between formulas have their own spaces in LaTeX: TeX adds none at a formula's end.
fn expression(expr: &Expr) -> Prose {
    Prose::new().math(latex::write_expr(expr))
}

fn relation(sign: Sign) -> [&'static str; 2] {
    match sign {
        Sign::Zero => ["\\;=0", " = 0"],
        Sign::Positive => ["\\;>0", " > 0"],
        Sign::Negative => ["\\;<0", " < 0"],
        Sign::NonNegative => ["\\;\\geq 0", " ≥ 0"],
        Sign::NonPositive | Sign::Both => ["\\;\\leq 0", " ≤ 0"],
    }
}

fn plain_number(value: &BigRational) -> Prose {
    Prose::new().formula(number(value, Script::Latex), number(value, Script::Plain))
}
