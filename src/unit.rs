//! Units: SI unit strings, and the dimensional homogeneity of equations, apart from the algebra.
//!
//! Every declared letter has a dimension; every other name gets one from its definition or, with
//! unknown exponents, from its uses (in the spirit of A. Kennedy, Programming Languages and
//! Dimensions, 1996). A matrix has a dimension for each entry: the entries of a state matrix
//! differ, and what fits is that each sum adds like to like. A literal zero has every dimension.
//!
//! The units of an equation say nothing about its truth, and never decide a verdict.
//! Invariant: an equation whose units do not fit teaches nothing about unknown dimensions, and
//! the names it defines are suspects: where a later equation does not fit because of one, the
//! suspect is given up and its units are found out anew from its other uses.

#![warn(clippy::wildcard_enum_match_arm)]

mod accent;
mod agreement;
mod audit;
mod dimension;
mod finding;
mod infer;
mod lookup;
mod measure;
mod names;
mod parse;
mod shape;
#[cfg(test)]
mod tests;
mod unification;

pub use audit::audit;
pub use dimension::{Base, Dimension};
pub use finding::{UnitFinding, UnitSite};
pub use parse::Unit;

use crate::expr::walk::{own_name, visit};
use crate::expr::{Chain, Clause, Display, Expr, ExprKind, IndexRange, Name, Relation};
use crate::model::NotationKind;
use crate::span::Span;
use accent::Accents;
use infer::{Checker, RANGE_LIMIT};
use measure::Measure;
use names::{Family, Names, Origin, family_key, key};
use shape::Shapes;
use std::collections::BTreeSet;

/// The units of a document's names, growing from equation to equation.
#[derive(Clone, Debug, Default)]
pub struct Units {
    names: Names,
    accents: Accents,
}

impl Units {
    /// Nothing is declared.
    pub fn new() -> Self {
        Units::default()
    }

    /// A letter with its unit.
    pub fn declare(&mut self, name: &Name, dimension: &Dimension) {
        let measure = Measure::scalar(dimension.clone(), Span::default());
        let name = self.accents.named(name);
        self.names.bind(&name, measure, Origin::Sound, None);
    }

    /// A scalar without a declared unit: found out from its uses.
    pub fn declare_unknown(&mut self, name: &Name) {
        let name = self.accents.named(name);
        self.names.bind_unknown(&name, 1, 1);
    }

    /// A matrix or vector without declared units: found out from its uses.
    pub fn declare_matrix(&mut self, name: &Name, rows: usize, columns: usize) {
        self.names.bind_unknown(name, rows, columns);
    }

    /// A matrix or vector all of whose entries have one unit.
    pub fn declare_uniform(
        &mut self,
        name: &Name,
        rows: usize,
        columns: usize,
        dimension: &Dimension,
    ) {
        let entry = measure::Entry {
            dimension: Some(dimension.clone()),
            span: Span::default(),
        };
        let measure = Measure::matrix(columns, vec![entry; rows * columns]);
        self.names.bind(name, measure, Origin::Sound, None);
    }

    /// A function of a letter; an argument must have that letter's unit.
    pub fn declare_function(&mut self, function: &Name, letter: &Name) {
        let function = self.accents.named(function);
        self.names.arguments.insert(key(&function), key(letter));
    }

    /// A name with a meaning by convention; the indices of a pattern stand for any.
    pub fn declare_notation(&mut self, name: &Name, convention: NotationKind) {
        let arity = match convention {
            NotationKind::CharacteristicCoefficient(_) | NotationKind::LeadingMinor(_) => 1,
            NotationKind::Cofactor(_) | NotationKind::Entry(_) => 2,
            NotationKind::Identity(_)
            | NotationKind::Zero
            | NotationKind::Rows(_)
            | NotationKind::Constant(_)
            | NotationKind::Dirac
            | NotationKind::Means(_)
            | NotationKind::Covariance(_)
            | NotationKind::HurwitzMatrix(_) => {
                self.names.conventions.insert(key(name), convention);
                return;
            }
        };
        let pattern = (family_key(name), arity);
        self.names.patterns.insert(pattern, convention);
    }

    /// The unit of a scalar name as far as it is known, in SI base units; none for a matrix, an
    /// unknown name, or a dimension that is still undetermined.
    pub fn unit_of(&self, name: &Name) -> Option<String> {
        let binding = self.names.bindings.get(&key(name))?;
        let Measure::Scalar(entry) = &binding.measure else {
            return None;
        };
        self.shown(entry)
    }

    /// The units of the entries of a matrix by rows, in SI base units; none for one that is zero
    /// or still undetermined.
    pub fn units_of_matrix(&self, name: &Name) -> Option<Vec<Vec<Option<String>>>> {
        let binding = self.names.bindings.get(&key(name))?;
        let (_, columns) = binding.measure.shape()?;
        let entries = binding.measure.entries();
        let rows = entries.chunks(columns);
        Some(
            rows.map(|row| row.iter().map(|entry| self.shown(entry)).collect())
                .collect(),
        )
    }

    /// The unit of a scalar expression in these names, in SI base units, as far as it is known.
    pub fn unit_of_expression(&mut self, expr: &Expr) -> Option<String> {
        let mut checker = infer::Checker::new(&mut self.names, "");
        let measure = checker.measure(expr);
        // A sum of terms with different units has none.
        if !checker.findings.is_empty() || !checker.suspects.is_empty() {
            return None;
        }
        self.shown_dimension(measure.dimension()?)
    }

    fn shown(&self, entry: &measure::Entry) -> Option<String> {
        self.shown_dimension(entry.dimension.as_ref()?)
    }

    fn shown_dimension(&self, dimension: &Dimension) -> Option<String> {
        let dimension = self.names.unification.resolve(dimension);
        dimension.is_known().then(|| dimension.to_string())
    }

    /// Checks equations in any order: what the later ones define is known to the earlier ones.
    pub fn check_all<'d>(
        &mut self,
        equations: impl Iterator<Item = (&'d str, &'d Display)> + Clone,
    ) -> Vec<UnitFinding> {
        for (label, display) in equations.clone() {
            self.check(label, display);
        }
        equations
            .flat_map(|(label, display)| self.check(label, display))
            .collect()
    }

    /// What [`Units::check_all`] finds in one of some equations, where those `before` it were checked once
    /// already.
    pub fn check_one_of<'d>(
        &mut self,
        before: impl Iterator<Item = (&'d str, &'d Display)>,
        one: (&str, &Display),
        after: impl Iterator<Item = (&'d str, &'d Display)>,
    ) -> Vec<UnitFinding> {
        self.check(one.0, one.1);
        for (label, display) in after.chain(before) {
            self.check(label, display);
        }
        self.check(one.0, one.1)
    }

    /// Checks an equation, and learns from it what the names in it measure. A chain that begins
    /// with a name without units gives it some; so do names under braces.
    pub fn check(&mut self, label: &str, display: &Display) -> Vec<UnitFinding> {
        let settled = self.accents.settled(display);
        let display = settled.as_ref().unwrap_or(display);
        let before = self.names.clone();
        let (mut findings, suspects) = self.run(label, display);
        if !findings.is_empty() && !suspects.is_empty() {
            let kept = std::mem::replace(&mut self.names, before.clone());
            for suspect in &suspects {
                self.names.release(suspect);
            }
            let (fewer, _) = self.run(label, display);
            if fewer.len() < findings.len() {
                findings = fewer;
            } else {
                self.names = kept;
            }
        }
        if !findings.is_empty() {
            self.names.unification.forget_since(&before.unification);
            self.names.members = before.members;
            self.names.eigenvalues = before.eigenvalues;
            for (known_as, binding) in &mut self.names.bindings {
                let new = !before.bindings.contains_key(known_as);
                if (new || binding.origin == Origin::Sound)
                    && binding.label.as_deref() == Some(label)
                {
                    binding.origin = Origin::Suspect;
                }
            }
            for family in self.names.families.values_mut() {
                family.suspect |= family.label == label;
            }
            let names: Vec<Name> = suspects
                .iter()
                .filter_map(|known_as| Some(self.names.bindings.get(known_as)?.name.clone()))
                .collect();
            for finding in &mut findings {
                finding.suspects.clone_from(&names);
            }
            findings.sort_by_key(|finding| finding.span);
        }
        findings
    }

    fn run(&mut self, label: &str, display: &Display) -> (Vec<UnitFinding>, BTreeSet<String>) {
        self.learn_shapes(display);
        let mut checker = Checker::new(&mut self.names, label);
        for clause in &display.clauses {
            checker.clause(clause);
        }
        // Equations under braces say the same once more: they are asked only if nothing is wrong.
        while checker.findings.is_empty()
            && let Some(chain) = checker.deferred.pop()
        {
            checker.chain(&chain);
        }
        (checker.findings, checker.suspects)
    }

    /// Binds the names of a display that nothing is known of to unknown dimensions.
    fn learn_shapes(&mut self, display: &Display) {
        let mut chains: Vec<&Chain> = Vec::new();
        let mut unknown: Vec<&Name> = Vec::new();
        let mut defined: BTreeSet<String> = BTreeSet::new();
        let mut bound: BTreeSet<String> = BTreeSet::new();
        for clause in &display.clauses {
            bound.extend(clause.ranges.iter().map(|range| key(&range.index)));
            let mut open = vec![&clause.chain];
            while let Some(chain) = open.pop() {
                chains.push(chain);
                if let (Some(name), Some(Relation::Equal)) =
                    (defining_name(chain), chain.relations.first())
                {
                    defined.insert(key(name));
                }
                for member in &chain.members {
                    visit(member, &mut |expr| {
                        if let ExprKind::BigSum { index, .. } = &expr.kind {
                            bound.insert(key(index));
                        } else {
                            unknown.extend(own_name(expr));
                        }
                        if let ExprKind::Underbrace { label, .. } = &expr.kind {
                            match (defining_name(label), label.relations.is_empty()) {
                                (Some(name), true) => {
                                    defined.insert(key(name));
                                }
                                (None, true) | (_, false) => open.push(label),
                            }
                        }
                    });
                }
            }
        }
        let is_bound = |name: &Name| {
            let indices = name.subscript.iter().flat_map(|s| &s.indices);
            bound.contains(&key(name))
                || indices.into_iter().any(|index| {
                    let mut found = false;
                    visit(index, &mut |expr| {
                        found |= matches!(&expr.kind, ExprKind::Name(n) if bound.contains(&key(n)));
                    });
                    found
                })
        };
        unknown.retain(|name| {
            !self.names.knows(name) && !defined.contains(&key(name)) && !is_bound(name)
        });
        let mut shapes = Shapes::new(&self.names);
        shapes.learn(&chains);
        let learned: Vec<(&Name, (usize, usize))> = unknown
            .into_iter()
            .filter_map(|name| Some((name, shapes.learned(name)?)))
            .collect();
        for (name, (rows, columns)) in learned {
            if !self.names.knows(name) {
                self.names.bind_unknown(name, rows, columns);
            }
        }
    }
}

/// The name at the beginning of a chain.
fn defining_name(chain: &Chain) -> Option<&Name> {
    if let ExprKind::Name(name) | ExprKind::Apply { function: name, .. } =
        &chain.members.first()?.kind
    {
        Some(name)
    } else {
        None
    }
}

impl Checker<'_> {
    /// A chain for every value of its indices.
    fn clause(&mut self, clause: &Clause) {
        if let Some(name) = defining_name(&clause.chain) {
            self.define_family(name, clause);
        }
        self.for_each_value(&clause.ranges, &mut |checker| checker.chain(&clause.chain));
    }

    fn for_each_value(&mut self, ranges: &[IndexRange], visit: &mut dyn FnMut(&mut Self)) {
        let Some((range, rest)) = ranges.split_first() else {
            visit(self);
            return;
        };
        let known_as = key(&range.index);
        let values = match self.bounds(range) {
            Some((from, to)) if to - from < RANGE_LIMIT => (from..=to).map(Some).collect(),
            _ => vec![None],
        };
        for value in values {
            self.indices.insert(known_as.clone(), value);
            self.for_each_value(rest, visit);
        }
        self.indices.remove(&known_as);
    }

    fn bounds(&self, range: &IndexRange) -> Option<(i64, i64)> {
        (self.integer(&range.step) == Some(1))
            .then_some((self.integer(&range.from)?, self.integer(&range.to)?))
    }

    /// Notes `A_m = ..., m = 0(1)6` as a family.
    fn define_family(&mut self, name: &Name, clause: &Clause) {
        let (Some(subscript), Some(body)) = (&name.subscript, clause.chain.members.get(1)) else {
            return;
        };
        let mut indices = Vec::new();
        let mut ranges = Vec::new();
        for index in &subscript.indices {
            let ExprKind::Name(running) = &index.kind else {
                return;
            };
            let Some(range) = clause.ranges.iter().find(|range| range.index == *running) else {
                return;
            };
            let Some(bounds) = self.bounds(range) else {
                return;
            };
            indices.push(key(running));
            ranges.push(bounds);
        }
        if !indices.is_empty() {
            let family = Family {
                indices,
                ranges,
                body: body.clone(),
                label: self.label.into(),
                suspect: false,
            };
            let place = (family_key(name), family.indices.len());
            if !self.names.patterns.contains_key(&place) {
                self.names.families.entry(place).or_insert(family);
            }
        }
    }

    /// The members of a chain agree; a name without units at its beginning gets theirs.
    fn chain(&mut self, chain: &Chain) {
        let related =
            |relation: &Relation| !matches!(relation, Relation::Distributed | Relation::Tends);
        let comparable = chain.relations.iter().all(related);
        let mut first = None;
        if let (Some(name), Some(Relation::Equal), true) =
            (defining_name(chain), chain.relations.first(), comparable)
            && !self.is_settled(name)
        {
            first = Some(name);
        }
        let mut measures: Vec<Measure> = Vec::new();
        for (at, member) in chain.members.iter().enumerate() {
            measures.push(match (at, first) {
                (0, Some(_)) => Measure::Opaque,
                _ => self.measure(member),
            });
        }
        if !comparable {
            return;
        }
        if let Some(name) = first {
            let defining = measures
                .iter()
                .find(|measure| measure.shape().is_some())
                .cloned();
            if let Some(defining) = defining {
                self.bind(name, defining);
            }
            measures[0] = self.name(name, chain.members[0].span);
        }
        self.agree_measures(&measures, &|member, place| match place {
            None => UnitSite::Member(member + 1),
            Some((row, column)) => UnitSite::MemberEntry {
                member: member + 1,
                row,
                column,
            },
        });
    }
}
