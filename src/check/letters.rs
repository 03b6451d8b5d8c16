//! Letters for functions are lent to one equation after the other.
//!
//! A document has one reserve of them, and its definitions keep theirs. What an equation was settled with,
//! the hypotheses around it and candidates for its correction among them, is no business of the next one: once half of the
//! reserve is gone, or an equation finds none left, all letters go back, and it is settled (again) with
//! the whole reserve. Outcomes from before keep what their letters stood for. So what an equation is found
//! to be does not depend on how many functions stand before it.

use super::Checker;
use crate::functions::FunctionTable;
use crate::verdict::Outcome;
use std::sync::Arc;

impl Checker<'_> {
    /// The table whose letters are lent. Where there are several instances, what is found in each is put
    /// together in the letters of one table: they are not lent then.
    pub(super) fn lent(&self) -> Option<FunctionTable> {
        let alone = self.model.instances.len() <= 1;
        self.functions().filter(|_| alone).cloned()
    }

    /// Settles an equation with enough letters for its functions; `kept` many are nobody's to give back.
    pub(super) fn settle_with_letters(
        &mut self,
        equation: usize,
        kept: usize,
        outcomes: &mut Vec<Outcome>,
    ) {
        let Some(table) = self.lent() else {
            outcomes.extend(self.settle(equation));
            return;
        };
        self.make_room(&table, kept, outcomes);
        let (given_out, refused) = (table.given_out(), table.refused());
        let world = self.exact.world().clone();
        let inserted = Arc::clone(&self.inserted);
        let (pool, noted) = (self.pool, self.diagnostics.len());
        let settled = self.settle(equation);
        if table.refused() == refused || given_out == kept {
            outcomes.extend(settled);
            return;
        }
        self.exact = self.exact.in_world(world);
        self.inserted = inserted;
        self.pool = pool;
        self.diagnostics.truncate(noted);
        self.give_back(&table, kept, outcomes);
        outcomes.extend(self.settle(equation));
    }

    /// Gives the letters back once half of those that can be are gone.
    pub(super) fn make_room(
        &mut self,
        table: &FunctionTable,
        kept: usize,
        outcomes: &mut [Outcome],
    ) {
        if 2 * table.remaining() < table.reserve().saturating_sub(kept) {
            self.give_back(table, kept, outcomes);
        }
    }

    /// Gives all letters back but for the first ones; what was computed with them is computed anew.
    fn give_back(&mut self, table: &FunctionTable, kept: usize, outcomes: &mut [Outcome]) {
        let letters = table.forked();
        for outcome in outcomes.iter_mut().filter(|o| o.letters.is_none()) {
            outcome.letters = Some(letters.clone());
        }
        let used = |f: &ratpoly::RationalFunction| {
            let parts = [f.numerator(), f.denominator()];
            let mut letters = parts.iter().flat_map(|p| p.variables_occurring());
            letters.any(|l| table.meaning(l).is_some())
        };
        let stale = self.inserted.values().any(used);
        table.take_back(kept);
        self.exact = self.exact.anew();
        if stale {
            self.insert_abbreviations();
        }
    }
}
