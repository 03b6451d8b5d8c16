//! What a printed name measures, its index included.

use super::dimension::{Base, Dimension};
use super::finding::UnitSite;
use super::infer::{Checker, DEPTH_LIMIT};
use super::measure::{Entry, Measure};
use super::names::{Origin, family_key, key, whole, with_arity};
use crate::expr::{Expr, Name, Subscript};
use crate::latex::write_expr;
use crate::model::NotationKind;
use crate::span::Span;

impl Checker<'_> {
    /// What a name measures where it stands.
    pub fn name(&mut self, name: &Name, span: Span) -> Measure {
        let undotted = self.undotted(name, span).at(span);
        let second = Dimension::base(Base::Second);
        undotted.times_power(&second, &whole(-i64::from(name.dots)))
    }

    fn undotted(&mut self, name: &Name, span: Span) -> Measure {
        let known_as = key(name);
        if self.indices.contains_key(&known_as) {
            return Measure::scalar(Dimension::one(), span);
        }
        if let Some(found) = self.complete(&known_as, span) {
            return found;
        }
        let Some(subscript) = &name.subscript else {
            return Measure::Opaque;
        };
        let indices: Option<Vec<i64>> = subscript.indices.iter().map(|e| self.integer(e)).collect();
        match indices {
            Some(indices) if !indices.is_empty() => self.element(name, &indices, span),
            _ => Measure::Opaque,
        }
    }

    /// A name by its complete canonical form.
    fn complete(&mut self, known_as: &str, span: Span) -> Option<Measure> {
        if let Some(binding) = self.names.bindings.get(known_as) {
            if binding.origin == Origin::Suspect && binding.label.as_deref() != Some(self.label) {
                self.suspects.insert(known_as.into());
            }
            return Some(binding.measure.clone());
        }
        let convention = self.names.conventions.get(known_as).cloned()?;
        Some(self.nested(|checker| match convention {
            NotationKind::Identity(order) => {
                let order = order.at(&checker.names.instance);
                let entries = (0..order * order).map(|at| Entry {
                    dimension: (at % (order + 1) == 0).then(Dimension::one),
                    span,
                });
                Measure::matrix(order, entries.collect())
            }
            NotationKind::Zero => Measure::Zero,
            NotationKind::Rows(_) => Measure::scalar(Dimension::one(), span),
            NotationKind::Constant(_) => Measure::scalar(Dimension::one(), span),
            NotationKind::Means(expr) => checker.measure(&expr),
            NotationKind::Covariance(covariance) => checker.measure(&covariance.product),
            NotationKind::HurwitzMatrix(of) => checker.hurwitz(&of, span),
            NotationKind::Dirac
            | NotationKind::CharacteristicCoefficient(_)
            | NotationKind::Cofactor(_)
            | NotationKind::LeadingMinor(_)
            | NotationKind::Entry(_) => Measure::Opaque,
        }))
    }

    /// A member of a family, or an entry of a matrix.
    fn element(&mut self, name: &Name, indices: &[i64], span: Span) -> Measure {
        let family = family_key(name);
        if let Some(found) = self.names.members.get(&(family.clone(), indices.to_vec())) {
            return found.clone();
        }
        let shown: Vec<String> = indices.iter().map(ToString::to_string).collect();
        let exact = Name {
            subscript: Some(Subscript {
                indices: Vec::new(),
                label: shown.join(","),
            }),
            ..name.undotted()
        };
        if let Some(found) = self.complete(&key(&exact), span) {
            return found;
        }
        for arity in [indices.len(), 2] {
            let Some(indices) = with_arity(indices, arity) else {
                continue;
            };
            let place = (family.clone(), arity);
            if let Some(found) = self.names.families.get(&place).cloned() {
                let inside = found
                    .ranges
                    .iter()
                    .zip(&indices)
                    .all(|((from, to), index)| (from..=to).contains(&index));
                let suspect = found.suspect && found.label != self.label;
                return if inside && !suspect {
                    self.member(&family, &found, &indices)
                } else {
                    Measure::Opaque
                };
            }
            if let Some(pattern) = self.names.patterns.get(&place).cloned() {
                return self.nested(|checker| checker.pattern(&pattern, &indices, span));
            }
        }
        match (self.complete(&family, span), with_arity(indices, 2)) {
            (Some(matrix), Some(place)) => entry(&matrix, &place),
            _ => Measure::Opaque,
        }
    }

    /// A member of a family by its definition, measured once.
    fn member(&mut self, family: &str, found: &super::names::Family, indices: &[i64]) -> Measure {
        let place = (family.to_owned(), indices.to_vec());
        // While it is being measured nothing is known of it: a recursion that needs itself.
        self.names.members.insert(place.clone(), Measure::Opaque);
        let bound = found.indices.iter().cloned();
        let inner = bound.zip(indices.iter().copied().map(Some)).collect();
        let outer = std::mem::replace(&mut self.indices, inner);
        let before = self.findings.len();
        let measure = self.nested(|checker| checker.measure(&found.body));
        // What is wrong in the definition is reported where it stands.
        if found.label != self.label {
            self.findings.truncate(before);
        }
        self.indices = outer;
        self.names.members.insert(place, measure.clone());
        measure
    }

    fn pattern(&mut self, pattern: &NotationKind, indices: &[i64], span: Span) -> Measure {
        match (pattern, indices) {
            (NotationKind::CharacteristicCoefficient(of), [order]) => {
                self.coefficient(of, *order, span)
            }
            (NotationKind::Entry(of), place) => {
                let matrix = self.measure(of);
                entry(&matrix, place)
            }
            (NotationKind::Cofactor(of), [row, column]) => {
                let matrix = self.measure(of);
                let Some((rows, columns)) = self.separate(&matrix) else {
                    return Measure::Opaque;
                };
                let n = rows.len() as i64;
                if !(1..=n).contains(row) || !(1..=n).contains(column) {
                    return Measure::Opaque;
                }
                let all = product(rows.iter().chain(&columns));
                let own = rows[(row - 1) as usize].times(&columns[(column - 1) as usize]);
                Measure::scalar(all.over(&own), span)
            }
            (NotationKind::LeadingMinor(of), [order]) => {
                let matrix = self.measure(of);
                match self.separate(&matrix) {
                    Some((rows, columns)) if (1..=rows.len() as i64).contains(order) => {
                        let order = *order as usize;
                        let first = rows.iter().take(order).chain(columns.iter().take(order));
                        Measure::scalar(product(first), span)
                    }
                    _ => Measure::Opaque,
                }
            }
            (
                NotationKind::CharacteristicCoefficient(_)
                | NotationKind::Cofactor(_)
                | NotationKind::LeadingMinor(_),
                _,
            ) => Measure::Opaque,
            // These take no indices.
            (
                NotationKind::Identity(_)
                | NotationKind::Zero
                | NotationKind::Rows(_)
                | NotationKind::Constant(_)
                | NotationKind::Means(_)
                | NotationKind::Covariance(_)
                | NotationKind::HurwitzMatrix(_)
                | NotationKind::Dirac,
                _,
            ) => Measure::Opaque,
        }
    }

    /// The coefficient a_i of a characteristic polynomial has the dimension of lambda^i.
    fn coefficient(&mut self, of: &Expr, order: i64, span: Span) -> Measure {
        let matrix = self.measure(of);
        let Some((n, _)) = matrix.shape() else {
            return Measure::Opaque;
        };
        match order {
            0 => Measure::scalar(Dimension::one(), span),
            _ if order > n as i64 => Measure::Zero,
            1.. => match self.eigenvalue(of, &matrix) {
                Some(eigenvalue) => Measure::scalar(eigenvalue.power(&whole(order)), span),
                None => Measure::Opaque,
            },
            _ => Measure::Opaque,
        }
    }

    /// Entry (i, j) is a_{2i-j}.
    fn hurwitz(&mut self, of: &Expr, span: Span) -> Measure {
        let Some((n, _)) = self.measure(of).shape() else {
            return Measure::Opaque;
        };
        let mut entries = Vec::new();
        for i in 1..=n as i64 {
            for j in 1..=n as i64 {
                let coefficient = self.coefficient(of, 2 * i - j, span);
                let dimension = coefficient.dimension().cloned();
                entries.push(Entry { dimension, span });
            }
        }
        Measure::matrix(n, entries)
    }

    /// The dimension of the eigenvalues of a matrix: entry (i, j) measures r_i lambda / r_j.
    fn eigenvalue(&mut self, of: &Expr, matrix: &Measure) -> Option<Dimension> {
        let known_as = write_expr(of);
        if let Some(found) = self.names.eigenvalues.get(&known_as) {
            return Some(found.clone());
        }
        let (n, columns) = matrix.shape()?;
        if n != columns {
            return None;
        }
        let eigenvalue = self
            .names
            .unification
            .unknown(format!("eigenvalue of {known_as}"));
        let scales = self.unknowns(n, "state");
        let expected = |i: usize, j: usize| eigenvalue.times(&scales[i]).over(&scales[j]);
        self.fit(matrix, columns, &expected);
        self.names.eigenvalues.insert(known_as, eigenvalue.clone());
        Some(eigenvalue)
    }

    /// A square matrix that has a determinant: entry (i, j) measures r_i c_j.
    fn separate(&mut self, matrix: &Measure) -> Option<(Vec<Dimension>, Vec<Dimension>)> {
        let (n, columns) = matrix.shape()?;
        if n != columns {
            return None;
        }
        let rows = self.unknowns(n, "row");
        let columns = self.unknowns(n, "column");
        self.fit(matrix, n, &|i, j| rows[i].times(&columns[j]));
        Some((rows, columns))
    }

    /// Makes every entry of a matrix measure what it must.
    fn fit(
        &mut self,
        matrix: &Measure,
        columns: usize,
        expected: &dyn Fn(usize, usize) -> Dimension,
    ) {
        for (at, entry) in matrix.entries().iter().enumerate() {
            let (i, j) = (at / columns, at % columns);
            let expected = expected(i, j);
            if let Some(found) = &entry.dimension
                && !self.names.unification.unify(found, &expected)
            {
                let site = UnitSite::DeterminantEntry {
                    row: i + 1,
                    column: j + 1,
                };
                self.find(site, entry.span, found, &expected);
            }
        }
    }

    fn unknowns(&mut self, count: usize, what: &str) -> Vec<Dimension> {
        (1..=count)
            .map(|i| self.names.unification.unknown(format!("{what} {i}")))
            .collect()
    }

    pub(super) fn determinant(&mut self, matrix: &Measure, span: Span) -> Measure {
        match matrix {
            Measure::Scalar(_) => matrix.clone().at(span),
            Measure::Matrix { .. } | Measure::Zero | Measure::Opaque => match self.separate(matrix)
            {
                Some((rows, columns)) => {
                    Measure::scalar(product(rows.iter().chain(&columns)), span)
                }
                None => Measure::Opaque,
            },
        }
    }

    /// If entry (i, j) measures r_i c_j, that of the inverse measures 1/(c_i r_j).
    pub(super) fn inverse(&mut self, matrix: &Measure) -> Measure {
        let span = matrix
            .entries()
            .first()
            .map_or(Span::default(), |entry| entry.span);
        let Some((rows, columns)) = self.separate(matrix) else {
            return Measure::Opaque;
        };
        let entries = columns
            .iter()
            .flat_map(|c| rows.iter().map(move |r| c.times(r)))
            .map(|product| Entry {
                dimension: Some(Dimension::one().over(&product)),
                span,
            })
            .collect();
        Measure::matrix(rows.len(), entries)
    }

    /// Follows a definition unless too many are being followed already.
    fn nested(&mut self, follow: impl FnOnce(&mut Self) -> Measure) -> Measure {
        if self.depth >= DEPTH_LIMIT {
            return Measure::Opaque;
        }
        self.depth += 1;
        let measure = follow(self);
        self.depth -= 1;
        measure
    }
}

fn product<'d>(factors: impl Iterator<Item = &'d Dimension>) -> Dimension {
    factors.fold(Dimension::one(), |product, factor| product.times(factor))
}

/// Row i, column j, from 1.
fn entry(matrix: &Measure, place: &[i64]) -> Measure {
    match (matrix.shape(), place) {
        (Some((rows, columns)), [row, column])
            if (1..=rows as i64).contains(row) && (1..=columns as i64).contains(column) =>
        {
            let at = (row - 1) as usize * columns + (column - 1) as usize;
            Measure::Scalar(matrix.entries()[at].clone())
        }
        _ => Measure::Opaque,
    }
}
