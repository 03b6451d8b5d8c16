//! How well the units of an equation fit in each of its readings.
//!
//! The units that the other equations teach are found out once: only what stands from the equation on
//! is asked anew for each reading, and no reading twice. An equation teaches another one something only through
//! letters without a declared unit, so that those which no chain of such letters joins to it are not asked.

use super::Checker;
use crate::expr::walk::{own_name, visit};
use crate::expr::{Display, ExprKind};
use crate::model::Model;
use crate::unit::Units;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// Where more equations than these teach each other units, each is judged by what is declared alone.
const TEACHERS: usize = 300;

/// What is known of the readings of one equation.
pub(crate) struct Readings {
    equation: usize,
    /// The corrections of the other equations.
    others: Vec<(usize, Display)>,
    /// What the equations before it teach.
    before: Units,
    misfits: Vec<(Display, usize)>,
}

/// The readings of the equation that was asked for last, and which equations teach each other units.
#[derive(Default)]
pub(crate) struct KnownReadings {
    last: RefCell<Option<Readings>>,
    classes: std::cell::OnceCell<Classes>,
}

/// The equations of a document in classes: letters without a declared unit join those of one class.
struct Classes {
    /// Whether anything has a declared unit: where nothing has, numbers without units fit everywhere.
    has_units: bool,
    declared: BTreeSet<String>,
    of_letter: BTreeMap<String, usize>,
    of_equation: Vec<BTreeSet<usize>>,
}

impl Classes {
    fn of(model: &Model) -> Self {
        let mut declared = BTreeSet::new();
        let mut open = BTreeSet::new();
        let symbols = model.symbols.iter().map(|s| (&s.name, s.unit.is_some()));
        let matrices = model.matrices.iter().map(|m| (&m.name, m.unit.is_some()));
        for (name, has_unit) in symbols.chain(matrices) {
            match has_unit {
                true => declared.insert(name.letter.base.clone()),
                false => open.insert(name.letter.base.clone()),
            };
        }
        let has_units = !declared.is_empty();
        declared.retain(|base| !open.contains(base));
        let mut classes = Classes {
            has_units,
            declared,
            of_letter: BTreeMap::new(),
            of_equation: Vec::new(),
        };
        let letters: Vec<BTreeSet<String>> = model
            .equations
            .iter()
            .map(|equation| classes.letters(model, &equation.display))
            .collect();
        // Union by the smallest number: each round joins what shares a letter with what came before.
        let mut parent: Vec<usize> = (0..letters.len()).collect();
        fn root(parent: &mut [usize], mut k: usize) -> usize {
            while parent[k] != k {
                parent[k] = parent[parent[k]];
                k = parent[k];
            }
            k
        }
        let mut first: BTreeMap<&String, usize> = BTreeMap::new();
        for (e, own) in letters.iter().enumerate() {
            for letter in own {
                let other = *first.entry(letter).or_insert(e);
                let (a, b) = (root(&mut parent, e), root(&mut parent, other));
                parent[a.max(b)] = a.min(b);
            }
        }
        for (letter, e) in first {
            let class = root(&mut parent, e);
            classes.of_letter.insert(letter.clone(), class);
        }
        classes.of_equation = letters
            .iter()
            .map(|own| own.iter().map(|l| classes.of_letter[l]).collect())
            .collect();
        classes
    }

    /// The bases of the letters of a display that have no declared unit, and the time where it has rates.
    fn letters(&self, model: &Model, display: &Display) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        let mut rates = false;
        for expr in display.clauses.iter().flat_map(|c| &c.chain.members) {
            visit(expr, &mut |e| {
                rates |= matches!(e.kind, ExprKind::Derivative { .. });
                if let Some(name) = own_name(e) {
                    rates |= name.dots > 0;
                    // Of a function the unit of its argument is learnt, too.
                    let applied = matches!(e.kind, ExprKind::Apply { .. });
                    if applied || !self.declared.contains(&name.letter.base) {
                        found.insert(name.letter.base.clone());
                    }
                }
            });
        }
        if rates {
            let times = model.symbols.iter().filter_map(|s| s.function_of.as_ref());
            let open = times.filter(|time| !self.declared.contains(&time.letter.base));
            found.extend(open.map(|time| time.letter.base.clone()));
        }
        found
    }
}

impl Checker<'_> {
    /// Those of some readings of an equation whose units fit in the most places, in their order.
    pub(super) fn fitting_units_best<T>(
        &self,
        equation: usize,
        mut readings: Vec<T>,
        display: impl Fn(&T) -> &Display,
    ) -> Vec<T> {
        if readings.len() > 1 {
            let misfits: Vec<usize> = readings
                .iter()
                .map(|reading| self.unit_misfits(equation, display(reading)))
                .collect();
            let fewest = misfits.iter().min().copied();
            let mut misfits = misfits.into_iter();
            readings.retain(|_| misfits.next() == fewest);
        }
        readings
    }

    /// In how many places of a corrected equation the units do not fit, and whether there are none or no
    /// more than in print.
    pub(super) fn fits_units(
        &self,
        equation: usize,
        printed: &Display,
        corrected: &Display,
    ) -> (usize, bool) {
        let left = self.unit_misfits(equation, corrected);
        (
            left,
            left == 0 || left <= self.unit_misfits(equation, printed),
        )
    }

    /// In how many places the units of an equation do not fit if it reads so.
    fn unit_misfits(&self, equation: usize, display: &Display) -> usize {
        let label = |e: usize| &self.model.equations[e].label[..];
        let classes = self
            .readings
            .classes
            .get_or_init(|| Classes::of(self.model));
        if !classes.has_units {
            return 0;
        }
        let mut asked: BTreeSet<usize> = classes.of_equation[equation].clone();
        let letters = classes.letters(self.model, display);
        // What no equation names teaches nothing.
        let more = letters.iter().filter_map(|l| classes.of_letter.get(l));
        let others: BTreeSet<usize> = more.copied().filter(|c| !asked.contains(c)).collect();
        let usual = others.is_empty();
        asked.extend(others);
        let joined = |e: &usize| !classes.of_equation[*e].is_disjoint(&asked);
        let teachers = (0..self.model.equations.len()).filter(joined);
        let many = teachers.take(TEACHERS + 1).count() > TEACHERS;
        let teaches = |e: &usize| !many && joined(e);
        let corrections = self.exact.world().corrections();
        let others: Vec<_> = corrections.filter(|(e, _)| *e != equation).collect();
        let mut known = self.readings.last.borrow_mut();
        let same = |r: &Readings| {
            r.equation == equation
                && r.others.len() == others.len()
                && r.others
                    .iter()
                    .zip(&others)
                    .all(|((e, d), other)| (*e, d) == *other)
        };
        if !known.as_ref().is_some_and(same) {
            let mut before = Units::of(self.model);
            let own = &classes.of_equation[equation];
            let joined = |e: &usize| !many && !classes.of_equation[*e].is_disjoint(own);
            for e in (0..equation).filter(joined) {
                before.check(label(e), self.exact.display(e));
            }
            *known = Some(Readings {
                equation,
                others: others.iter().map(|(e, d)| (*e, (*d).clone())).collect(),
                before,
                misfits: Vec::new(),
            });
        }
        let Some(readings) = known.as_mut() else {
            return 0;
        };
        if let Some((_, misfits)) = readings.misfits.iter().find(|(d, _)| d == display) {
            return *misfits;
        }
        let others = |e: usize| (label(e), self.exact.display(e));
        let before = (0..equation).filter(teaches).map(others);
        let after = (equation + 1..self.model.equations.len())
            .filter(teaches)
            .map(others);
        let one = (label(equation), display);
        let mut units = readings.before.clone();
        if !usual {
            // The reading has letters of other equations, which were not asked before.
            for (label, display) in before.clone() {
                units.check(label, display);
            }
        }
        let misfits = units.check_one_of(before, one, after);
        let misfits = misfits.len();
        readings.misfits.push((display.clone(), misfits));
        misfits
    }
}
