//! The exact and the floating-point route at the very same points.
//!
//! The floating-point route starts from the printed expressions (corrected ones where a misprint
//! was mended) and never sees the exact engine; the exact value is computed at the doubles
//! themselves, so that an error is known and not estimated. The two meet here and nowhere else.

mod exact;

use crate::audit::Audit;
use crate::check;
use crate::domain::Symbolic;
use crate::evaluate;
use crate::expr::{Display, Relation};
use crate::latex::{self, Signature};
use crate::model::{Equation, Model, Role};
use crate::numeric::LyapunovMethod;
use crate::numeric::agreement::Agreement;
use crate::numeric::evaluate::Evaluator;
use crate::numeric::point::{NamedPoint, Point};
use crate::numeric::value::Value;
use crate::progress::{Unwatched, Watch};
use crate::stack::{in_parallel, with_deep_stack};
use crate::verdict::{Outcome, Verdict};
pub(crate) use exact::exact_point;
use exact::{AtPoint, Prepared, in_order, number};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use ratpoly::{Polynomial, RationalFunction};
use std::collections::BTreeMap;

/// Fewer digits than this at the reference point, by every method, are a contradiction and not
/// rounding.
const FEWEST_DIGITS: f64 = 3.0;

/// What is compared.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subject {
    /// A quantity that the document's numeric table names, in LaTeX.
    Quantity(String),
    /// The right side of a link, against the exact value of its left side.
    Link {
        /// The equation, as an index into the model.
        equation: usize,
        /// The link's number within it.
        member: usize,
    },
}

/// How one method does at one point.
#[derive(Clone, Debug)]
pub struct Computed {
    /// The smallest number of correct digits among the entries; none where the method gives no
    /// number.
    pub digits: Option<f64>,
    /// The computed value, for a scalar.
    pub value: Option<f64>,
    /// Why there is no number.
    pub failure: Option<String>,
}

/// One subject at one point by all methods.
#[derive(Clone, Debug)]
pub struct Row {
    /// Index into [`Comparison::points`].
    pub point: usize,
    /// Index into [`Comparison::subjects`].
    pub subject: usize,
    /// The exact value, for a scalar.
    pub exact: Option<BigRational>,
    /// One result for each of [`Comparison::methods`].
    pub computed: Vec<Computed>,
}

/// A point at which the routes are compared.
#[derive(Clone, Debug)]
pub struct ComparedPoint {
    /// Its name in the document, or `sample 7`.
    pub name: String,
    /// Whether the document names it; otherwise it was drawn at random.
    pub named: bool,
    /// The doubles of the declared symbols.
    pub values: Vec<Option<f64>>,
}

/// The two routes at all points of a document's numeric table.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The seed of the random points.
    pub seed: u64,
    /// The methods.
    pub methods: Vec<LyapunovMethod>,
    /// The points: the named ones in their order, then the random ones.
    pub points: Vec<ComparedPoint>,
    /// What is compared.
    pub subjects: Vec<Subject>,
    /// All results, by point and then by subject.
    pub rows: Vec<Row>,
}

/// Digits of one method on one subject over some points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// How many points have a number.
    pub count: usize,
    /// How many have none.
    pub failed: usize,
    /// The fewest digits and the point where that is.
    pub worst: (f64, usize),
    /// The lower median.
    pub median: f64,
}

impl Comparison {
    /// Compares the routes; `None` where the document has no numeric table or no point of it has
    /// doubles.
    pub fn of(audit: &Audit) -> Option<Comparison> {
        Comparison::watched(audit, &Unwatched)
    }

    /// The same, where each point is a unit of work; the points that were not reached are left out.
    pub fn watched(audit: &Audit, watch: &(dyn Watch + Sync)) -> Option<Comparison> {
        with_deep_stack(|| Comparison::compute(audit, watch))
    }

    fn compute(audit: &Audit, watch: &(dyn Watch + Sync)) -> Option<Comparison> {
        let model = &audit.model;
        let table = model.document.numeric.as_ref()?;
        let points = Point::of_table(model, table).ok()?;
        let mut exact = check::corrected(model, &audit.outcomes);
        let corrections = corrections(&exact);
        let mut subjects = Vec::new();
        let mut prepared = Vec::new();
        for quantity in &table.quantities {
            let expr = latex::parse_expr(&quantity.text, 0, &Signature::default()).ok();
            if let Some((expr, value)) =
                expr.and_then(|e| Some((e.clone(), number(&mut exact, &e)?)))
            {
                subjects.push(Subject::Quantity(quantity.text.clone()));
                prepared.push((expr, value));
            }
        }
        for outcome in &audit.outcomes {
            let equation = &model.equations[outcome.equation];
            let is_claim = matches!(
                outcome.verdict,
                Verdict::Holds { .. } | Verdict::HoldsGiven(..) | Verdict::Misprint { .. }
            );
            let Some(link) = equation.links.iter().find(|l| l.member == outcome.member) else {
                continue;
            };
            let display = exact.display(outcome.equation).clone();
            let ranged = !display.clauses[link.left.clause()].ranges.is_empty();
            // What is no equation has no error, and at a point at which a hypothesis does not hold there need be none.
            let equal = link.relation == Relation::Equal && is_unconditional(outcome, equation);
            if !is_claim || equation.role != Role::Claim || ranged || !equal {
                continue;
            }
            let sides = link.left.find(&display).zip(link.right.find(&display));
            if let Some((left, right)) = sides
                && let Some(value) = number(&mut exact, left)
            {
                subjects.push(Subject::Link {
                    equation: outcome.equation,
                    member: outcome.member,
                });
                prepared.push((right.clone(), value));
            }
        }
        let abbreviations = exact.abbreviations();
        let mut shared = BTreeMap::new();
        let prepared: Vec<_> = prepared
            .into_iter()
            .map(|(expr, value)| Prepared::new(model, expr, &value, &mut shared))
            .collect();
        let polynomials = in_order(shared);
        let methods = LyapunovMethod::ALL.to_vec();
        watch.begin(
            &format!("{}: in floating point", model.document.name),
            points.len(),
        );
        let numbered: Vec<_> = points.iter().enumerate().collect();
        let found = in_parallel(&numbered, |(p, named)| {
            if watch.stop() {
                return None;
            }
            let rows = rows_at(
                *p,
                named,
                model,
                &abbreviations,
                &corrections,
                &prepared,
                &polynomials,
            );
            watch.advance();
            Some(rows)
        });
        watch.end();
        // An interruption leaves out whatever comes after the first point that was not reached.
        let found: Vec<_> = found.into_iter().map_while(|rows| rows).collect();
        let reached = found.len();
        if reached == 0 {
            return None;
        }
        let rows = found.into_iter().flatten().collect();
        let named = table.points.len();
        let points = points
            .iter()
            .take(reached)
            .enumerate()
            .map(|(p, point)| ComparedPoint {
                name: point.name.clone(),
                named: p < named,
                values: point.point.values().to_vec(),
            })
            .collect();
        Some(Comparison {
            seed: table.seed,
            methods,
            points,
            subjects,
            rows,
        })
    }

    /// The digits of a method on a subject over the named or over the random points.
    pub fn summary(&self, subject: usize, method: usize, named: bool) -> Option<Summary> {
        let rows = self
            .rows
            .iter()
            .filter(|r| r.subject == subject && self.points[r.point].named == named);
        let mut digits = Vec::new();
        let mut failed = 0;
        for row in rows {
            match row.computed[method].digits {
                Some(d) => digits.push((d, row.point)),
                None => failed += 1,
            }
        }
        digits.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let worst = *digits.first()?;
        Some(Summary {
            count: digits.len(),
            failed,
            worst,
            median: digits[(digits.len() - 1) / 2].0,
        })
    }

    /// How the floating-point route agrees on a link: the digits of the best method at the first
    /// point, and the fewest that the best method keeps anywhere, with the point.
    pub fn agreement(&self, equation: usize, member: usize) -> Option<(f64, f64, usize)> {
        let link = Subject::Link { equation, member };
        let subject = self.subjects.iter().position(|s| *s == link)?;
        let best = |row: &Row| {
            let digits = row.computed.iter().filter_map(|c| c.digits);
            digits.max_by(f64::total_cmp)
        };
        let rows: Vec<&Row> = self.rows.iter().filter(|r| r.subject == subject).collect();
        let first = best(rows.first()?)?;
        let (worst, point) = rows
            .iter()
            .map(|r| (best(r).unwrap_or(0.0), r.point))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((first, worst, point))
    }

    /// The subjects on which every method contradicts the exact value at the first named point,
    /// where nothing is ill-conditioned by design: an error of this program.
    pub fn conflicts(&self) -> Vec<&Subject> {
        self.rows
            .iter()
            .filter(|r| r.point == 0)
            .filter(|r| {
                let mut numbers = r.computed.iter().filter_map(|c| c.digits).peekable();
                numbers.peek().is_some() && numbers.all(|d| d < FEWEST_DIGITS)
            })
            .map(|r| &self.subjects[r.subject])
            .collect()
    }
}

/// Whether a verdict rests on the definitions alone, and on no hypothesis.
fn is_unconditional(outcome: &Outcome, equation: &Equation) -> bool {
    let stated = match &outcome.verdict {
        Verdict::HoldsGiven(given, _) => given.implied_by.is_empty(),
        Verdict::Misprint { correction, .. } => {
            let given = correction.given.as_ref();
            given.is_some_and(|given| given.implied_by.is_empty())
        }
        Verdict::Holds { .. }
        | Verdict::Refuted(_)
        | Verdict::Undecided { .. }
        | Verdict::Definition { .. }
        | Verdict::Recalled { .. } => false,
    };
    equation.assume.is_empty() && !stated
}

/// The corrected displays in the place of the printed ones.
pub(crate) fn corrections(exact: &evaluate::Evaluator<'_, Symbolic>) -> BTreeMap<usize, Display> {
    let corrections = exact.world().corrections();
    corrections
        .map(|(equation, display)| (equation, display.clone()))
        .collect()
}

fn rows_at(
    p: usize,
    named: &NamedPoint<'_>,
    model: &Model,
    abbreviations: &[(usize, RationalFunction)],
    corrections: &BTreeMap<usize, Display>,
    prepared: &[Prepared],
    polynomials: &[Polynomial],
) -> Vec<Row> {
    let point = exact_point(model, &named.point, abbreviations);
    let mut values = AtPoint::new(model, point, polynomials);
    let mut resolver = named.point.clone();
    for (equation, display) in corrections {
        resolver = resolver.corrected(*equation, display.clone());
    }
    let mut evaluators: Vec<_> = LyapunovMethod::ALL
        .iter()
        .map(|method| Evaluator::new(&resolver, *method))
        .collect();
    let mut rows = Vec::new();
    for (subject, Prepared { expr, exact }) in prepared.iter().enumerate() {
        let Ok(found) = exact.try_map(|element| values.value(element).ok_or(())) else {
            continue;
        };
        let is_exact = found.entries().iter().all(|(_, exact)| *exact);
        let exact = found.map(|(value, _)| value.clone());
        let mut computed: Vec<Computed> = Vec::with_capacity(evaluators.len());
        let mut by_method = true;
        for evaluator in &mut evaluators {
            let known = computed.last().filter(|_| !by_method).cloned();
            computed.push(known.unwrap_or_else(|| {
                let (value, depends) = evaluator.value_and_dependence(expr);
                by_method = depends;
                match value {
                    Ok(value) => compared(&value, &exact),
                    Err(failure) => Computed {
                        digits: None,
                        value: None,
                        failure: Some(format!("{:?}", failure.kind)),
                    },
                }
            }));
        }
        rows.push(Row {
            point: p,
            subject,
            exact: match &exact {
                evaluate::Value::Scalar(e) if is_exact => Some(e.clone()),
                _ => None,
            },
            computed,
        });
    }
    rows
}

/// The fewest digits among the entries. The error of an entry whose exact value is zero is taken
/// relative to the largest entry.
fn compared(value: &Value, exact: &evaluate::Value<BigRational>) -> Computed {
    let entries = exact.entries();
    let scale = entries.iter().map(|e| e.abs()).max().unwrap_or_default();
    let shape = exact.shape().unwrap_or((1, 1));
    let matrix = value.clone().into_matrix(shape);
    if matrix.shape() != shape {
        return Computed {
            digits: None,
            value: None,
            failure: Some("another shape".into()),
        };
    }
    let digits = entries
        .iter()
        .enumerate()
        .map(|(k, exact)| {
            let computed = matrix[(k / shape.1, k % shape.1)];
            let agreement = if exact.is_zero() && shape != (1, 1) {
                Agreement::at_scale(computed, exact, &scale)
            } else {
                Agreement::of(computed, exact)
            };
            agreement.digits()
        })
        .min_by(f64::total_cmp);
    Computed {
        digits,
        value: (shape == (1, 1)).then(|| matrix[(0, 0)]),
        failure: None,
    }
}
