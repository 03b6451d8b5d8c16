//! The way to a subexpression of a display, and what stands around it.

use crate::expr::walk::{children, children_mut};
use crate::expr::{Display, Expr, ExprKind};
use crate::model::links::Place;

/// The way to a subexpression: a place of the display and the numbers of the children.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The side it is in.
    pub place: Place,
    /// From there down.
    pub path: Vec<usize>,
}

impl Address {
    /// A whole side.
    pub fn of_side(place: Place) -> Self {
        Address {
            place,
            path: Vec::new(),
        }
    }

    /// Whether one of the two subexpressions holds the other.
    pub fn is_nested_with(&self, other: &Address) -> bool {
        self.place == other.place
            && (self.path.starts_with(&other.path) || other.path.starts_with(&self.path))
    }

    /// The subexpression.
    pub fn find<'a>(&self, display: &'a Display) -> Option<&'a Expr> {
        let mut expr = self.place.find(display)?;
        for step in &self.path {
            expr = children(expr).into_iter().nth(*step)?;
        }
        Some(expr)
    }

    pub(super) fn find_mut<'a>(&self, display: &'a mut Display) -> Option<&'a mut Expr> {
        self.below(self.place.find_mut(display)?)
    }

    /// The subexpression, given its side.
    pub fn below<'a>(&self, side: &'a mut Expr) -> Option<&'a mut Expr> {
        let mut expr = side;
        for step in &self.path {
            expr = children_mut(expr).into_iter().nth(*step)?;
        }
        Some(expr)
    }
}

/// A subexpression where it stands.
#[derive(Clone, Debug)]
pub struct Site<'a> {
    /// The way to it.
    pub address: Address,
    /// The subexpression.
    pub expr: &'a Expr,
    /// What it is a direct part of; none for a whole side.
    pub parent: Option<&'a Expr>,
}

impl Site<'_> {
    /// Which child of its parent it is.
    pub fn step(&self) -> usize {
        self.address.path.last().copied().unwrap_or_default()
    }

    /// Whether it is an exponent or a limit of a sum.
    pub fn is_count(&self) -> bool {
        match self.parent.map(|p| &p.kind) {
            Some(ExprKind::Power { .. }) => self.step() == 1,
            Some(ExprKind::BigSum { .. }) => self.step() < 2,
            _ => false,
        }
    }

    /// Whether it is a whole monomial: no factor of a product, no base and no exponent.
    pub fn is_monomial(&self) -> bool {
        !matches!(self.expr.kind, ExprKind::Sum(_))
            && match self.parent.map(|p| &p.kind) {
                None
                | Some(
                    ExprKind::Sum(_)
                    | ExprKind::Quotient { .. }
                    | ExprKind::Group { .. }
                    | ExprKind::Matrix { .. }
                    | ExprKind::Underbrace { .. }
                    | ExprKind::Expectation(_)
                    | ExprKind::Integral { .. }
                    | ExprKind::Call { .. },
                ) => true,
                Some(ExprKind::BigSum { .. }) => self.step() == 2,
                _ => false,
            }
    }

    /// Whether a term may be added here: to a sum, or to what fills a side, a bracket or a bar.
    pub fn takes_terms(&self) -> bool {
        match (&self.expr.kind, self.parent.map(|p| &p.kind)) {
            (ExprKind::Sum(_), _) => !self.is_count(),
            (
                _,
                None
                | Some(
                    ExprKind::Quotient { .. }
                    | ExprKind::Group { .. }
                    | ExprKind::Matrix { .. }
                    | ExprKind::Call { .. },
                ),
            ) => !matches!(
                self.expr.kind,
                ExprKind::Matrix { .. } | ExprKind::Group { .. }
            ),
            _ => false,
        }
    }
}

/// Every subexpression of a side with its address, parents first.
pub fn sites(display: &Display, place: Place) -> Vec<Site<'_>> {
    fn descend<'a>(
        expr: &'a Expr,
        parent: Option<&'a Expr>,
        address: &mut Address,
        found: &mut Vec<Site<'a>>,
    ) {
        found.push(Site {
            address: address.clone(),
            expr,
            parent,
        });
        for (step, child) in children(expr).into_iter().enumerate() {
            address.path.push(step);
            descend(child, Some(expr), address, found);
            address.path.pop();
        }
    }
    let mut found = Vec::new();
    if let Some(expr) = place.find(display) {
        descend(expr, None, &mut Address::of_side(place), &mut found);
    }
    found
}
