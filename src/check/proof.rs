//! Certificates of what the checker found, bound to the print, and the proofs that come of verifying them.

use super::Checker;
use super::identity::Insertion;
use crate::expr::reading;
use crate::functions::FunctionLetter;
use crate::latex;
use crate::model::Letter;
use crate::model::links::Link;
use crate::model::range::{End, Numbers, Range};
use crate::verdict::certificate::{
    DeclaredLetter, Entry, Membership, Print, Steps, Subject, Terms,
};
use crate::verdict::{Certificate, Contradiction, Given, Proof, ResidualEntry};
use std::collections::BTreeSet;
use std::sync::Arc;

impl Checker<'_> {
    /// The proof that entries are equal after an insertion, or follow from relations; none where the
    /// certificate does not verify, which is noted as a contradiction.
    pub(crate) fn proved(
        &mut self,
        equation: usize,
        link: &Link,
        entries: &[ResidualEntry],
        by: &Insertion,
        given: Option<&Given>,
    ) -> Option<Proof> {
        let membership = self.membership(entries, by, given);
        self.verified(equation, link, Steps::Membership(membership))
    }

    /// The proof by these steps; none where they do not verify, which is noted.
    pub(crate) fn verified(&mut self, equation: usize, link: &Link, steps: Steps) -> Option<Proof> {
        let subject = self.subject(equation, link, &steps);
        match (Certificate { subject, steps }).verify() {
            Ok(proof) => Some(proof),
            Err(_) => {
                self.contradiction = Some(Contradiction::Certificate);
                None
            }
        }
    }

    fn membership(
        &self,
        entries: &[ResidualEntry],
        by: &Insertion,
        given: Option<&Given>,
    ) -> Membership {
        let residual = given.into_iter().flat_map(|g| g.cofactors.iter());
        let pairs: Vec<(&ResidualEntry, &[ratpoly::RationalFunction])> = entries
            .iter()
            .map(|e| (e, &[][..]))
            .chain(residual.map(|g| (&g.entry, &g.cofactors[..])))
            .collect();
        let functions = self.functions();
        let mut inserted = by.letters.clone();
        if let Some(table) = functions {
            let needed = pairs
                .iter()
                .flat_map(|(e, _)| [&e.left, &e.right])
                .flat_map(|side| table.letters_behind(side))
                .collect();
            if let Ok(all) = table.extended(&inserted, &needed) {
                inserted = all;
            }
        }
        let quadratics = functions.map_or_else(Vec::new, |table| table.quadratics().to_vec());
        Membership {
            entries: pairs
                .into_iter()
                .map(|(entry, cofactors)| Entry {
                    indices: entry.indices.clone(),
                    place: entry.place,
                    left: (&entry.left).into(),
                    right: (&entry.right).into(),
                    cofactors: cofactors.iter().map(Into::into).collect(),
                })
                .collect(),
            inserted: inserted.iter().map(|(l, f)| (*l, f.into())).collect(),
            relations: given
                .map_or_else(Vec::new, |g| g.relations.iter().map(Into::into).collect()),
            squares: quadratics
                .iter()
                .map(|q| (q.letter, (&q.square).into()))
                .collect(),
        }
    }

    fn subject(&mut self, equation: usize, link: &Link, steps: &Steps) -> Subject {
        let model = self.model;
        let printed = &model.equations[equation];
        let display = self.display(equation);
        let text = |place: crate::model::links::Place| {
            place.find(&display).map_or_else(String::new, reading::expr)
        };
        let letters = letters_in(steps);
        let definitions: BTreeSet<usize> = letters
            .iter()
            .filter_map(|letter| match model.letters.get(*letter)? {
                Letter::Abbreviation { definition } => {
                    Some(model.definitions[*definition].equation)
                }
                Letter::Symbol { .. } | Letter::Function { .. } => None,
            })
            .collect();
        let corrected = self.exact.world().correction(equation);
        Subject {
            document: model.document.name.clone(),
            print: match corrected {
                Some(display) => {
                    Arc::new(Print::new(&printed.label, &latex::write_display(display)))
                }
                None => self.print(equation),
            },
            member: link.member,
            reading: [text(link.left), text(link.right)],
            relation: reading::relation(link.relation).into(),
            letters: letters.into_iter().map(|l| self.declared(l)).collect(),
            definitions: definitions.into_iter().map(|e| self.print(e)).collect(),
            hypotheses: printed
                .settings
                .assume
                .iter()
                .chain(&printed.settings.given)
                .map(|text| Print::new(&printed.label, &text.text))
                .collect(),
        }
    }

    /// An equation as printed.
    fn print(&self, equation: usize) -> Arc<Print> {
        let printed = &self.model.equations[equation];
        let new = || Arc::new(Print::new(&printed.label, &printed.source));
        Arc::clone(self.prints[equation].get_or_init(new))
    }

    fn declared(&self, letter: usize) -> DeclaredLetter {
        let model = self.model;
        let meaning = match model.letters.get(letter) {
            Some(Letter::Symbol { symbol, order: 0 }) => range_text(&model.symbols[*symbol].range),
            Some(Letter::Symbol { order, .. }) => format!("time derivative of order {order}"),
            Some(Letter::Abbreviation { definition }) => {
                let equation = model.definitions[*definition].equation;
                format!("defined by ({})", model.equations[equation].label)
            }
            Some(Letter::Function { .. }) | None => {
                let table = model.functions.as_ref();
                table.and_then(|t| t.meaning(letter)).map_or_else(
                    || "a letter of a function".into(),
                    |function| function_text(&function),
                )
            }
        };
        DeclaredLetter {
            letter,
            name: latex::canonical(&model.letter_name(letter)),
            meaning,
        }
    }
}

/// The letters that the steps name, in increasing order.
fn letters_in(steps: &Steps) -> BTreeSet<usize> {
    let of = |terms: &Terms| -> Vec<usize> {
        let powers = terms.0.iter().flat_map(|(_, powers)| powers);
        powers.map(|(letter, _)| *letter).collect()
    };
    let fraction = |f: &crate::verdict::certificate::Fraction| {
        let mut letters = of(&f.numerator);
        letters.extend(of(&f.denominator));
        letters
    };
    match steps {
        Steps::Membership(m) => {
            let sides = m.entries.iter().flat_map(|e| [&e.left, &e.right]);
            let cofactors = m.entries.iter().flat_map(|e| &e.cofactors);
            let values = m.inserted.iter().map(|(_, f)| f);
            let fractions = sides.chain(cofactors).chain(values).flat_map(fraction);
            let relations = m.relations.iter().flat_map(of);
            let inserted = m.inserted.iter().map(|(l, _)| *l);
            fractions.chain(relations).chain(inserted).collect()
        }
        Steps::Ordered(ordered) => ordered.positive.iter().flat_map(fraction).collect(),
        Steps::Cases(cases) => {
            let own = cases.cases.iter().flat_map(|case| {
                let values = case.inserted.iter().map(|(_, f)| f);
                let letters = case.inserted.iter().map(|(l, _)| *l);
                let fractions = values.chain([&case.of, &case.is]).flat_map(fraction);
                fractions.chain(letters).collect::<Vec<_>>()
            });
            own.collect()
        }
        Steps::Leading(leading) => fraction(&leading.quotient).into_iter().collect(),
        Steps::Scope => BTreeSet::new(),
        Steps::Sizes(all) => all.iter().flat_map(letters_in).collect(),
    }
}

/// `real`, `real > 0`, `integer, 0 < .. <= 2`.
fn range_text(range: &Range) -> String {
    let numbers = match range.numbers {
        Numbers::Real => "real",
        Numbers::Complex => "complex",
        Numbers::Integer => "integer",
    };
    let end = |end: &Option<End>, signs: [&str; 2]| {
        end.as_ref().map(|end| {
            let sign = signs[usize::from(end.included)];
            format!("{sign} {}", end.value)
        })
    };
    let ends = [end(&range.low, [">", ">="]), end(&range.high, ["<", "<="])];
    let ends: Vec<String> = ends.into_iter().flatten().collect();
    match ends.is_empty() {
        true => numbers.into(),
        false => format!("{numbers} {}", ends.join(" and ")),
    }
}

fn function_text(function: &FunctionLetter) -> String {
    match function {
        FunctionLetter::Pi => "pi".into(),
        FunctionLetter::ImaginaryUnit => "i".into(),
        FunctionLetter::Exponential(u) => format!("exp({u})"),
        FunctionLetter::Cosine(u) => format!("cos({u})"),
        FunctionLetter::Sine(u, _) => format!("sin({u})"),
        FunctionLetter::Root(p) => format!("sqrt({p})"),
        FunctionLetter::Power(base, exponent) => format!("({base})^({exponent})"),
        FunctionLetter::Logarithm(p) => format!("ln({p})"),
        FunctionLetter::Dirac(u) => format!("delta({u})"),
        FunctionLetter::Bound { depth, .. } if *depth >= super::cartesian::FIRST => {
            "real, a part of a complex letter".into()
        }
        FunctionLetter::Bound { depth, .. } if *depth >= super::by_cases::FIRST => {
            "positive, of a case".into()
        }
        FunctionLetter::Bound { depth, .. } => format!("variable of integration {depth}"),
    }
}
