//! From an expression to what it measures, with a finding wherever neighbours differ.

use super::dimension::{Base, Dimension};
use super::finding::{UnitFinding, UnitSite};
use super::measure::{Entry, Measure};
use super::names::{Names, Origin, key, whole};
use crate::expr::{Chain, Expr, ExprKind, Function, Name};
use crate::model::NotationKind;
use crate::span::Span;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// Most dimensions that a check may compute before it gives up.
const WORK_LIMIT: usize = 200_000;

/// Most values of an index that are written out; a longer sum is checked for one general index.
pub(super) const RANGE_LIMIT: i64 = 64;

/// Largest power of a matrix that is multiplied out.
const MATRIX_POWER_LIMIT: i64 = 16;

/// The largest exponent within an exponent.
const LARGEST_EXPONENT: i32 = 64;

/// Deepest nesting of definitions inside definitions.
pub(super) const DEPTH_LIMIT: usize = 40;

/// The check of one equation.
pub(super) struct Checker<'n> {
    pub names: &'n mut Names,
    pub label: &'n str,
    pub findings: Vec<UnitFinding>,
    /// Indices with their values; none for an index that stands for any number.
    pub indices: BTreeMap<String, Option<i64>>,
    /// Names used that come from equations with findings.
    pub suspects: BTreeSet<String>,
    /// Equations under braces, checked once all names are bound.
    pub deferred: Vec<Chain>,
    /// Definitions being followed.
    pub depth: usize,
    work: usize,
}

impl<'n> Checker<'n> {
    pub fn new(names: &'n mut Names, label: &'n str) -> Self {
        Checker {
            names,
            label,
            findings: Vec::new(),
            indices: BTreeMap::new(),
            suspects: BTreeSet::new(),
            deferred: Vec::new(),
            depth: 0,
            work: 0,
        }
    }

    /// Counts work; false once it is too much, which is a finding of its own.
    pub fn spend(&mut self, work: usize, span: Span) -> bool {
        if self.work > WORK_LIMIT {
            return false;
        }
        self.work += work;
        if self.work > WORK_LIMIT {
            self.find(
                UnitSite::TooLarge,
                span,
                &Dimension::one(),
                &Dimension::one(),
            );
            return false;
        }
        true
    }

    /// What an expression measures.
    pub fn measure(&mut self, expr: &Expr) -> Measure {
        let span = expr.span;
        if !self.spend(1, span) {
            return Measure::Opaque;
        }
        match &expr.kind {
            ExprKind::Number(number) if number.is_zero() => Measure::Zero,
            ExprKind::Number(_) => Measure::scalar(Dimension::one(), span),
            ExprKind::Name(name) => self.name(name, span),
            ExprKind::Apply {
                function,
                arguments,
            } => {
                if matches!(
                    self.names.conventions.get(&key(function)),
                    Some(NotationKind::Dirac)
                ) {
                    return self.dirac(arguments, span);
                }
                self.arguments(function, arguments);
                self.name(function, span)
            }
            ExprKind::Call { function, argument } => self.call(*function, argument, span),
            ExprKind::Sum(terms) => {
                let measures: Vec<Measure> = terms.iter().map(|(_, t)| self.measure(t)).collect();
                self.sum(&measures)
            }
            ExprKind::Product(factors) => {
                let mut product: Option<Measure> = None;
                for factor in factors {
                    let factor = self.measure(factor);
                    product = Some(match product {
                        None => factor,
                        Some(left) => self.product(left, factor, span),
                    });
                }
                product.unwrap_or(Measure::Opaque)
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let numerator = self.measure(numerator);
                let denominator = self.measure(denominator);
                denominator.dimension().map_or(Measure::Opaque, |below| {
                    numerator.times_power(below, &whole(-1))
                })
            }
            ExprKind::Power { base, exponent } => self.power(base, exponent, span),
            ExprKind::Transpose(inner) => self.measure(inner).transposed(),
            ExprKind::Group { inner, .. }
            | ExprKind::Expectation(inner)
            | ExprKind::Named { value: inner, .. } => self.measure(inner),
            ExprKind::Matrix { rows, .. } => self.matrix(rows),
            ExprKind::BigSum {
                index,
                from,
                to,
                body,
            } => self.big_sum(index, from, to, body),
            ExprKind::Integral {
                limits,
                body,
                variable,
            } => {
                let variable = self.name(variable, span);
                for limit in limits.iter().flat_map(|(from, to)| [&**from, &**to]) {
                    let limit = self.measure(limit);
                    self.argument(&limit, &variable);
                }
                let body = self.measure(body);
                self.product(body, variable, span)
            }
            ExprKind::Derivative {
                order,
                variable,
                body,
            } => {
                let by = match variable {
                    None => Measure::scalar(Dimension::base(Base::Second), span),
                    Some(variable) => self.name(variable, span),
                };
                let body = self.measure(body);
                by.dimension().map_or(Measure::Opaque, |by| {
                    body.times_power(by, &whole(-i64::from(*order)))
                })
            }
            ExprKind::Underbrace { body, label } => self.underbrace(body, label),
            ExprKind::Cases(cases) => {
                let measures: Vec<Measure> = cases.iter().map(|(e, _)| self.measure(e)).collect();
                self.sum(&measures)
            }
            ExprKind::Tuple(_) | ExprKind::Infinity | ExprKind::Constant => Measure::Opaque,
        }
    }

    /// The Dirac distribution measures the reciprocal of its argument.
    fn dirac(&mut self, arguments: &[Expr], span: Span) -> Measure {
        let [argument] = arguments else {
            return Measure::Opaque;
        };
        let measure = self.measure(argument);
        measure.dimension().map_or(Measure::Opaque, |dimension| {
            Measure::scalar(Dimension::one().over(dimension), span)
        })
    }

    pub fn sum(&mut self, measures: &[Measure]) -> Measure {
        self.agree_measures(measures, &|_, place| match place {
            None => UnitSite::Term,
            Some((row, column)) => UnitSite::TermEntry { row, column },
        })
    }

    pub fn product(&mut self, left: Measure, right: Measure, span: Span) -> Measure {
        match (left, right) {
            (Measure::Zero, _) | (_, Measure::Zero) => Measure::Zero,
            (Measure::Opaque, _) | (_, Measure::Opaque) => Measure::Opaque,
            (Measure::Scalar(scalar), other) => match scalar.dimension {
                None => Measure::Zero,
                // In a product of scalars the first factor is pointed at.
                Some(dimension) => {
                    other
                        .times_power(&dimension, &BigRational::one())
                        .map(|_, entry| match entry.span {
                            _ if span.start <= scalar.span.start => Entry {
                                span: scalar.span.to(entry.span),
                                ..entry
                            },
                            _ => entry,
                        })
                }
            },
            (matrix, Measure::Scalar(scalar)) => match scalar.dimension {
                None => Measure::Zero,
                Some(dimension) => matrix.times_power(&dimension, &BigRational::one()),
            },
            (
                Measure::Matrix {
                    columns: inner,
                    entries: left,
                },
                Measure::Matrix {
                    columns,
                    entries: right,
                },
            ) => {
                if right.len() / columns != inner || !self.spend(left.len() * columns, span) {
                    return Measure::Opaque;
                }
                let rows = left.len() / inner;
                let mut entries = Vec::with_capacity(rows * columns);
                for row in 0..rows {
                    for column in 0..columns {
                        let terms: Vec<(usize, Entry)> = (0..inner)
                            .filter_map(|k| {
                                let l = &left[row * inner + k];
                                let r = &right[k * columns + column];
                                let dimension = l.dimension.as_ref()?.times(r.dimension.as_ref()?);
                                let dimension = Some(dimension);
                                Some((
                                    k + 1,
                                    Entry {
                                        dimension,
                                        span: l.span,
                                    },
                                ))
                            })
                            .collect();
                        let these: Vec<&Entry> = terms.iter().map(|(_, term)| term).collect();
                        let mut sum = self.agree(&these, &|which| UnitSite::ProductTerm {
                            row: row + 1,
                            column: column + 1,
                            term: terms[which].0,
                        });
                        if these.is_empty() {
                            sum.span = left[row * inner].span;
                        }
                        entries.push(sum);
                    }
                }
                Measure::matrix(columns, entries)
            }
        }
    }

    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Measure {
        let measure = self.measure(base);
        let number = self.rational(exponent);
        match (measure, number) {
            (Measure::Scalar(entry), Some(exponent)) => match entry.dimension {
                None => Measure::Zero,
                Some(dimension) => Measure::scalar(dimension.power(&exponent), span),
            },
            (Measure::Scalar(entry), None) => {
                let exponent = self.measure(exponent);
                let one = Measure::scalar(Dimension::one(), span);
                self.expect(&exponent, &one, UnitSite::Exponent);
                self.expect(&Measure::Scalar(entry), &one, UnitSite::Exponent);
                one
            }
            (matrix @ Measure::Matrix { .. }, Some(exponent)) if exponent.is_integer() => {
                match exponent.to_integer().to_i64() {
                    Some(-1) => self.inverse(&matrix),
                    Some(n @ 1..=MATRIX_POWER_LIMIT) => (1..n).fold(matrix.clone(), |power, _| {
                        self.product(power, matrix.clone(), span)
                    }),
                    _ => Measure::Opaque,
                }
            }
            (Measure::Zero, Some(exponent)) if exponent.is_positive() => Measure::Zero,
            (Measure::Matrix { .. } | Measure::Zero | Measure::Opaque, _) => Measure::Opaque,
        }
    }

    fn call(&mut self, function: Function, argument: &Expr, span: Span) -> Measure {
        let measure = self.measure(argument);
        match function {
            Function::Determinant => self.determinant(&measure, span),
            Function::Trace => match measure.shape() {
                Some((rows, columns)) if rows == columns => {
                    let diagonal: Vec<&Entry> =
                        measure.entries().iter().step_by(columns + 1).collect();
                    let sum = self.agree(&diagonal, &|at| UnitSite::TermEntry {
                        row: at + 1,
                        column: at + 1,
                    });
                    Measure::Scalar(Entry { span, ..sum })
                }
                _ => Measure::Opaque,
            },
            Function::Absolute if matches!(measure, Measure::Matrix { .. }) => {
                self.determinant(&measure, span)
            }
            Function::RealPart | Function::ImaginaryPart | Function::Absolute => measure,
            Function::SquareRoot => match measure {
                Measure::Scalar(_) => {
                    let half = BigRational::new(1.into(), 2.into());
                    measure.map(|_, entry| Entry {
                        dimension: entry.dimension.map(|d| d.power(&half)),
                        span,
                    })
                }
                // The root of a matrix is none of its entries' roots.
                Measure::Matrix { .. } | Measure::Opaque => Measure::Opaque,
                Measure::Zero => Measure::Zero,
            },
            Function::Cosine
            | Function::Sine
            | Function::Tangent
            | Function::Cotangent
            | Function::HyperbolicCosine
            | Function::HyperbolicSine
            | Function::HyperbolicTangent
            | Function::Exponential
            | Function::Logarithm => {
                let one = Measure::scalar(Dimension::one(), argument.span);
                self.argument(&measure, &one);
                match measure {
                    Measure::Matrix { .. } => Measure::Opaque,
                    Measure::Scalar(_) | Measure::Zero | Measure::Opaque => one.at(span),
                }
            }
        }
    }

    /// Matrices by entries, or by blocks.
    fn matrix(&mut self, rows: &[Vec<Expr>]) -> Measure {
        let blocks: Vec<Vec<Measure>> = rows
            .iter()
            .map(|row| {
                row.iter()
                    .map(|entry| {
                        let measure = self.measure(entry);
                        match measure {
                            Measure::Scalar(e) => Measure::Scalar(Entry {
                                span: entry.span,
                                ..e
                            }),
                            Measure::Matrix { .. } | Measure::Zero | Measure::Opaque => measure,
                        }
                    })
                    .collect()
            })
            .collect();
        // A row is as high as its highest block, a column as wide as its widest; a block is square
        // where its neighbours leave a side open.
        let columns = blocks.first().map_or(0, Vec::len);
        let known_heights: Vec<Option<usize>> = blocks
            .iter()
            .map(|row| row.iter().filter_map(Measure::shape).map(|s| s.0).max())
            .collect();
        let known_widths: Vec<Option<usize>> = (0..columns)
            .map(|j| {
                blocks
                    .iter()
                    .filter_map(|row| row[j].shape())
                    .map(|s| s.1)
                    .max()
            })
            .collect();
        let square = [&known_widths, &known_heights]
            .map(|known| known.iter().flatten().next().copied().unwrap_or(1));
        let heights: Vec<usize> = known_heights
            .iter()
            .map(|h| h.unwrap_or(square[0]))
            .collect();
        let widths: Vec<usize> = known_widths
            .iter()
            .map(|w| w.unwrap_or(square[1]))
            .collect();
        let mut entries = Vec::new();
        for (i, row) in blocks.iter().enumerate() {
            for k in 0..heights[i] {
                for (j, block) in row.iter().enumerate() {
                    let span = rows[i][j].span;
                    for l in 0..widths[j] {
                        entries.push(match block {
                            Measure::Zero => Entry {
                                dimension: None,
                                span,
                            },
                            Measure::Opaque => Entry {
                                dimension: Some(self.names.unification.unknown("?".into())),
                                span,
                            },
                            Measure::Scalar(_) | Measure::Matrix { .. } => {
                                if block.shape() != Some((heights[i], widths[j])) {
                                    return Measure::Opaque;
                                }
                                block.entries()[k * widths[j] + l].clone()
                            }
                        });
                    }
                }
            }
        }
        Measure::matrix(widths.iter().sum(), entries)
    }

    fn big_sum(&mut self, index: &Name, from: &Expr, to: &Expr, body: &Expr) -> Measure {
        let known_as = key(index);
        let outer = self.indices.get(&known_as).copied();
        let bounds = (self.integer(from), self.integer(to));
        let values: Vec<Option<i64>> = match bounds {
            (Some(from), Some(to)) if to - from < RANGE_LIMIT => (from..=to).map(Some).collect(),
            _ => vec![None],
        };
        let mut terms = Vec::new();
        for value in values {
            self.indices.insert(known_as.clone(), value);
            terms.push(self.measure(body));
        }
        match outer {
            Some(value) => self.indices.insert(known_as, value),
            None => self.indices.remove(&known_as),
        };
        if terms.is_empty() {
            return Measure::Zero;
        }
        self.sum(&terms)
    }

    fn underbrace(&mut self, body: &Expr, label: &Chain) -> Measure {
        let measure = self.measure(body);
        match (label.members.as_slice(), label.relations.as_slice()) {
            ([member], []) => {
                if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } = &member.kind
                    && !self.is_settled(name)
                {
                    self.bind(name, measure.clone());
                } else {
                    let below = self.measure(member);
                    self.expect(&measure, &below, UnitSite::Term);
                }
            }
            _ => self.deferred.push(label.clone()),
        }
        measure
    }

    /// Whether a name has its units from more than its uses.
    pub fn is_settled(&self, name: &Name) -> bool {
        match self.names.bindings.get(&key(name)) {
            Some(binding) => binding.origin != Origin::Inferred,
            None => self.names.knows(name),
        }
    }

    /// Gives a name its units; what its uses have shown must fit.
    pub fn bind(&mut self, name: &Name, measure: Measure) {
        match measure {
            Measure::Scalar(_) | Measure::Matrix { .. } => {}
            Measure::Opaque | Measure::Zero => return,
        }
        if self.names.bindings.contains_key(&key(name)) {
            let inferred = self.name(name, Span::default());
            self.expect(&measure, &inferred, UnitSite::Term);
        }
        self.names
            .bind(name, measure, Origin::Sound, Some(self.label));
    }

    fn argument(&mut self, found: &Measure, expected: &Measure) {
        self.expect(found, expected, UnitSite::Argument);
    }

    /// The arguments of a function must measure what it is declared a function of.
    fn arguments(&mut self, function: &Name, arguments: &[Expr]) {
        let letter = self.names.arguments.get(&key(function)).cloned();
        let named = |a: &&Expr| matches!(a.kind, ExprKind::Named { .. });
        let alone = arguments.len() - arguments.iter().filter(named).count() == 1;
        for argument in arguments {
            let measure = self.measure(argument);
            let declared = if let Some((name, _)) = argument.as_named_argument() {
                Some(self.name(name, argument.span))
            } else if alone {
                letter
                    .as_ref()
                    .and_then(|letter| self.names.bindings.get(letter))
                    .map(|binding| binding.measure.clone())
            } else {
                None
            };
            if let Some(declared) = declared {
                self.argument(&measure, &declared);
            }
        }
    }

    /// The number that an expression of numbers and indices stands for.
    pub fn rational(&self, expr: &Expr) -> Option<BigRational> {
        match &expr.kind {
            ExprKind::Number(number) => Some(number.clone()),
            ExprKind::Name(name) if name.dots == 0 => {
                self.indices.get(&key(name)).copied().flatten().map(whole)
            }
            ExprKind::Group { inner, .. } => self.rational(inner),
            ExprKind::Sum(terms) => terms
                .iter()
                .try_fold(BigRational::zero(), |sum, (sign, e)| {
                    let term = self.rational(e)?;
                    Some(match sign {
                        crate::expr::Sign::Plus => sum + term,
                        crate::expr::Sign::Minus => sum - term,
                    })
                }),
            ExprKind::Product(factors) => {
                factors.iter().try_fold(BigRational::one(), |product, e| {
                    Some(product * self.rational(e)?)
                })
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                let below = self.rational(denominator)?;
                (!below.is_zero()).then_some(self.rational(numerator)? / below)
            }
            ExprKind::Power { base, exponent } => {
                let base = self.rational(base)?;
                let exponent = self.rational(exponent).filter(BigRational::is_integer)?;
                let exponent = exponent.to_integer().to_i32()?;
                let small = exponent.abs() <= LARGEST_EXPONENT;
                (small && !base.is_zero()).then(|| base.pow(exponent))
            }
            ExprKind::Underbrace { body, .. } => self.rational(body),
            ExprKind::Name(_)
            | ExprKind::Apply { .. }
            | ExprKind::Named { .. }
            | ExprKind::Call { .. }
            | ExprKind::Transpose(_)
            | ExprKind::Matrix { .. }
            | ExprKind::Tuple(_)
            | ExprKind::BigSum { .. }
            | ExprKind::Integral { .. }
            | ExprKind::Derivative { .. }
            | ExprKind::Expectation(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => None,
        }
    }

    pub fn integer(&self, expr: &Expr) -> Option<i64> {
        let number = self.rational(expr)?;
        number.is_integer().then(|| number.to_integer().to_i64())?
    }
}
