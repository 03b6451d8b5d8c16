//! Dots that are accents and no derivatives.
//!
//! A table that declares `\ddot{\Phi}_0` says that two dots over this letter make another letter, as
//! a tilde would. Such names are known by the dotted letter here, so that nothing is divided by
//! seconds on their account.

use crate::expr::walk::{children_mut, own_name_mut};
use crate::expr::{Chain, Display, Expr, ExprKind, Letter, Name};
use crate::latex::canonical;
use std::collections::BTreeSet;
use std::sync::Arc;

/// The letters with dots that are letters of their own.
#[derive(Clone, Debug, Default)]
pub(super) struct Accents {
    dotted: BTreeSet<(Letter, u8)>,
}

impl Accents {
    /// Takes the dots of a declared name for an accent.
    pub fn declare(&mut self, name: &Name) {
        self.dotted.insert((name.letter.clone(), name.dots));
    }

    /// The name as it is known here.
    pub fn named(&self, name: &Name) -> Name {
        let mut name = name.clone();
        self.settle(&mut name);
        name
    }

    /// The name with dots that are an accent made a part of its letter.
    fn settle(&self, name: &mut Name) {
        if self.dotted.contains(&(name.letter.clone(), name.dots)) {
            let bare = Name {
                subscript: None,
                ..name.clone()
            };
            name.letter = Letter {
                base: canonical(&bare),
                font: Default::default(),
                accent: None,
                primes: 0,
            };
            name.dots = 0;
        }
    }

    /// A display with all such names settled; none where no dots are accents.
    pub fn settled(&self, display: &Display) -> Option<Display> {
        if self.dotted.is_empty() {
            return None;
        }
        let mut display = display.clone();
        for clause in display.clauses.iter_mut().map(Arc::make_mut) {
            self.chain(&mut clause.chain);
        }
        Some(display)
    }

    fn chain(&self, chain: &mut Chain) {
        for member in &mut chain.members {
            self.expression(member);
        }
    }

    fn expression(&self, expr: &mut Expr) {
        if let Some(name) = own_name_mut(expr) {
            self.settle(name);
        }
        if let ExprKind::Underbrace { label, .. } = &mut expr.kind {
            self.chain(label);
        }
        for child in children_mut(expr) {
            self.expression(child);
        }
    }
}
