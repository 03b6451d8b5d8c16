//! Dots and crosses between columns: the scalar product and the vector product.
//!
//! `\mathbf u\cdot\mathbf v` of two columns is their scalar product and is read as
//! `\mathbf u^T\mathbf v`, which is named; the product of matrices would have no shape. Of the vector
//! product, of the square of a column, and of bold letters whose shapes are not printed, both readings are
//! given back. Elsewhere dots and crosses are those of an ordinary product.

use super::slash::bracketed;
use super::{Parse, Parser, product};
use crate::expr::{Accent, Expr, ExprKind, Font, Name};
use crate::latex::signature::Shape;
use crate::span::Span;

/// The sign between two factors.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Dot {
    /// `\cdot`
    Scalar,
    /// `\times`
    Cross,
}

/// What a factor is to the shape of a product.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A number, which leaves the shape as it is.
    Number,
    /// A matrix that is neither row nor column.
    Matrix,
    /// A column.
    Column,
    /// A row.
    Row,
    /// A bold letter, or a product with one, whose shape is not printed.
    Unknown,
}

impl Parser<'_> {
    /// The factors of `left \cdot right` or `left \times right`.
    pub(super) fn multiplied(
        &mut self,
        mut left: Vec<Expr>,
        dot: Dot,
        right: Vec<Expr>,
        start: Span,
    ) -> Parse<Vec<Expr>> {
        let kinds = (self.kind_of_all(&left), self.kind_of_all(&right));
        let doubtful = match kinds {
            (Kind::Column | Kind::Unknown, Kind::Column | Kind::Unknown) => true,
            // As a contraction it would be a row.
            (Kind::Column, Kind::Matrix) => true,
            (Kind::Matrix, Kind::Column | Kind::Unknown) | (Kind::Unknown, Kind::Matrix) => {
                dot == Dot::Cross
            }
            (Kind::Matrix, Kind::Number | Kind::Matrix | Kind::Row)
            | (Kind::Number | Kind::Row, _)
            | (Kind::Column | Kind::Unknown, Kind::Number | Kind::Row) => false,
        };
        if !doubtful {
            left.extend(right);
            return Ok(left);
        }
        let span = self.since(start);
        if dot == Dot::Cross {
            let readings = [
                "the vector product, written with its components",
                "a product of matrices, written without a cross",
            ];
            return Err(self.ambiguous(readings, span));
        }
        // (\mathbf w \mathbf u)^T \mathbf v has no meaning, \mathbf w (\mathbf u^T \mathbf v) has one.
        let several = |factors: &[Expr]| {
            self.several_shapes(factors) && !factors.iter().any(|f| self.kind_of(f) == Kind::Matrix)
        };
        if kinds != (Kind::Column, Kind::Column) || several(&left) || several(&right) {
            let readings = [
                "the scalar product, written \\mathbf{u}^T\\mathbf{v}",
                "a product of matrices, written without a dot",
            ];
            return Err(self.ambiguous(readings, span));
        }
        let mut column = product(left, start);
        if !matches!(
            column.kind,
            ExprKind::Name(_) | ExprKind::Apply { .. } | ExprKind::Group { .. }
        ) {
            column = bracketed(column);
        }
        let row = Expr::new(ExprKind::Transpose(Box::new(column)), start);
        let mut factors = vec![row];
        factors.extend(right);
        let scalar = product(factors, span);
        self.note_reading(&scalar);
        Ok(vec![bracketed(scalar)])
    }

    /// Whether a base is a column, whose powers are none of a matrix.
    pub(super) fn is_column(&self, base: &Expr) -> bool {
        self.kind_of(base) == Kind::Column
    }

    /// Whether two factors in square brackets may be meant as their commutator: both are matrices, or
    /// may be.
    pub(super) fn may_commute(&self, items: &[Expr]) -> bool {
        let mut kinds = items.iter().map(|item| self.kind_of(item));
        items.len() == 2 && kinds.all(|kind| matches!(kind, Kind::Matrix | Kind::Unknown))
    }

    /// Whether more than one factor has a shape: what a dot contracts is then in doubt.
    fn several_shapes(&self, factors: &[Expr]) -> bool {
        let shaped = factors.iter().filter(|f| self.kind_of(f) != Kind::Number);
        shaped.count() > 1
    }

    /// What a product of these is.
    fn kind_of_all(&self, factors: &[Expr]) -> Kind {
        let mut kind = Kind::Number;
        for factor in factors {
            kind = match (kind, self.kind_of(factor)) {
                (kind, Kind::Number) | (Kind::Number, kind) => kind,
                (Kind::Row, Kind::Column) => Kind::Number,
                (Kind::Column | Kind::Unknown, Kind::Row) => Kind::Matrix,
                // What has no shape is asked for where a dot or cross stands beside it.
                (Kind::Matrix, kind) | (kind @ (Kind::Column | Kind::Unknown), Kind::Matrix) => {
                    kind
                }
                (Kind::Column | Kind::Unknown, kind @ (Kind::Column | Kind::Unknown)) => kind,
                (Kind::Row, Kind::Row | Kind::Matrix | Kind::Unknown) => Kind::Row,
            };
        }
        kind
    }

    fn kind_of(&self, factor: &Expr) -> Kind {
        match &factor.kind {
            ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
                self.kind_of_name(name)
            }
            ExprKind::Transpose(inner) => match self.kind_of(inner) {
                Kind::Column | Kind::Unknown => Kind::Row,
                Kind::Row => Kind::Column,
                kind @ (Kind::Number | Kind::Matrix) => kind,
            },
            ExprKind::Group { inner, .. } | ExprKind::Expectation(inner) => self.kind_of(inner),
            ExprKind::Derivative { body: inner, .. }
            | ExprKind::Underbrace { body: inner, .. }
            | ExprKind::Integral { body: inner, .. }
            | ExprKind::BigSum { body: inner, .. }
            | ExprKind::Quotient {
                numerator: inner, ..
            } => self.kind_of(inner),
            ExprKind::Sum(terms) => {
                let mut kinds = terms.iter().map(|(_, term)| self.kind_of(term));
                kinds
                    .find(|kind| *kind != Kind::Number)
                    .unwrap_or(Kind::Number)
            }
            ExprKind::Product(factors) => self.kind_of_all(factors),
            ExprKind::Matrix { rows, .. } => match (rows.len(), rows.first().map(Vec::len)) {
                (2.., Some(1)) => Kind::Column,
                (1, Some(2..)) => Kind::Row,
                _ => Kind::Matrix,
            },
            ExprKind::Power { base, .. } => match self.kind_of(base) {
                Kind::Number => Kind::Number,
                Kind::Matrix | Kind::Column | Kind::Row | Kind::Unknown => Kind::Matrix,
            },
            ExprKind::Number(_)
            | ExprKind::Named { .. }
            | ExprKind::Call { .. }
            | ExprKind::Tuple(_)
            | ExprKind::Cases(_)
            | ExprKind::Infinity
            | ExprKind::Constant => Kind::Number,
        }
    }

    fn kind_of_name(&self, name: &Name) -> Kind {
        let vector = name.letter.font == Font::Bold || name.letter.accent == Some(Accent::Vector);
        match self.signature.shape(name) {
            Some(Shape::Column) => Kind::Column,
            Some(Shape::Matrix) => Kind::Matrix,
            None if vector && self.signature.is_defined(name) => Kind::Unknown,
            None if vector => Kind::Matrix,
            None => Kind::Number,
        }
    }
}
