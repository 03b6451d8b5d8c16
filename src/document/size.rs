//! Numbers of rows and columns that may depend on a letter, and the values that it takes.
//!
//! A paper speaks of f degrees of freedom; a proof by computation is one for each f that the
//! document names. Sizes are integers or multiples of such a letter: `3`, `f`, `2f`.

use super::Text;
use super::table::{Entries, Value, ValueKind};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use num_traits::ToPrimitive;
use std::collections::BTreeMap;
use std::fmt;

/// Largest number of rows or columns that a document may name.
pub const SIZE_LIMIT: u64 = 64;
/// Largest value of an instance letter.
pub const INSTANCE_LIMIT: u64 = 12;
/// Most instances of one document.
pub const INSTANCES_LIMIT: usize = 16;

/// A value for each letter that sizes depend on.
pub type Instance = BTreeMap<String, usize>;

/// A number of rows or columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// The number, or how often the letter is taken.
    pub factor: usize,
    /// The letter, if the size depends on one.
    pub letter: Option<String>,
}

impl Size {
    /// A size that depends on nothing.
    pub fn fixed(number: usize) -> Self {
        Size {
            factor: number,
            letter: None,
        }
    }

    /// `3`, `f` or `2f`.
    fn parse(text: &str) -> Option<Size> {
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        let (number, letter) = text.split_at(digits);
        let letter = letter.trim();
        let factor = match number {
            "" => 1,
            digits => digits
                .parse::<u64>()
                .ok()
                .filter(|n| (1..=SIZE_LIMIT).contains(n))?
                .to_usize()?,
        };
        if letter.is_empty() && number.is_empty() || !is_letter(letter) && !letter.is_empty() {
            return None;
        }
        Some(Size {
            factor,
            letter: (!letter.is_empty()).then(|| letter.into()),
        })
    }

    /// Decodes a size.
    pub(super) fn decode(value: &Value, report: &mut Vec<Diagnostic>) -> Option<Size> {
        let size = match &value.kind {
            ValueKind::Number(digits) => Size::parse(digits),
            // What is a number is written as one.
            ValueKind::String(text) => Size::parse(&text.text).filter(|s| s.letter.is_some()),
            _ => None,
        };
        if size.is_none() {
            let what = format!("a size, 1 to {SIZE_LIMIT} or such as \"f\" and \"2f\"");
            report.push(value.expected(&what));
        }
        size
    }

    /// The number in an instance; a letter that the instance does not have counts as one.
    pub fn at(&self, instance: &Instance) -> usize {
        let letter = self.letter.as_ref().and_then(|l| instance.get(l));
        self.factor * letter.copied().unwrap_or(1)
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.letter {
            None => write!(f, "{}", self.factor),
            Some(letter) if self.factor == 1 => f.write_str(letter),
            Some(letter) => write!(f, "{}{letter}", self.factor),
        }
    }
}

/// Whether a word can stand for a number of rows: a plain letter as printed in italics.
fn is_letter(word: &str) -> bool {
    word.len() == 1 && word.chars().all(|c| c.is_ascii_alphabetic())
}

/// Letters with their values.
type Letters = Vec<(Text, Vec<usize>)>;

/// Decodes `{ f = [2, 3] }`, every combination of the letters' values, or `[{ n = 2, r = 3 }, { n = 3, r = 4 }]`,
/// these and no others.
pub(super) fn named(
    value: Option<Value>,
    report: &mut Vec<Diagnostic>,
) -> (Letters, Vec<Instance>) {
    let Some(value) = value else {
        return (Letters::new(), vec![Instance::new()]);
    };
    let what = "a table such as { f = [2, 3] }, or a list of such as [{ f = 2 }, { f = 3 }]";
    match value.kind {
        ValueKind::Table(entries) => {
            let letters = instances(entries, report);
            let values = combinations(&letters);
            (letters, values)
        }
        ValueKind::Array(ref items) if !items.is_empty() => {
            match listed(items).filter(|(_, list)| list.len() <= INSTANCES_LIMIT) {
                Some(named) => named,
                None => {
                    report.push(value.expected(&format!(
                        "up to {INSTANCES_LIMIT} tables with the same letters, each with a number from 1 to {INSTANCE_LIMIT}"
                    )));
                    (Letters::new(), vec![Instance::new()])
                }
            }
        }
        ValueKind::String(_)
        | ValueKind::Number(_)
        | ValueKind::Boolean(_)
        | ValueKind::Array(_)
        | ValueKind::Date => {
            report.push(value.expected(what));
            (Letters::new(), vec![Instance::new()])
        }
    }
}

/// Instances that are listed, all with the same letters, none twice.
fn listed(items: &[Value]) -> Option<(Letters, Vec<Instance>)> {
    let mut letters = Letters::new();
    let mut list: Vec<Instance> = Vec::new();
    for item in items {
        let ValueKind::Table(entries) = &item.kind else {
            return None;
        };
        let mut instance = Instance::new();
        for (letter, value) in entries {
            let value = number(&value.kind).filter(|_| is_letter(&letter.text))?;
            instance.insert(letter.text.clone(), value);
            match letters
                .iter_mut()
                .find(|(known, _)| known.text == letter.text)
            {
                Some((_, values)) => values.push(value),
                None if list.is_empty() => letters.push((letter.clone(), vec![value])),
                None => return None,
            }
        }
        if instance.len() != letters.len() || list.contains(&instance) {
            return None;
        }
        list.push(instance);
    }
    for (_, values) in &mut letters {
        values.sort_unstable();
        values.dedup();
    }
    (!letters.is_empty()).then_some((letters, list))
}

/// Decodes `{ f = [2, 3] }`.
fn instances(entries: Entries, report: &mut Vec<Diagnostic>) -> Vec<(Text, Vec<usize>)> {
    let mut found = Vec::new();
    for (letter, value) in entries {
        if !is_letter(&letter.text) {
            report.push(Diagnostic::new(
                DiagnosticKind::Unexpected {
                    found: format!("`{}`", letter.text),
                    expected: "a letter such as f".into(),
                },
                letter.span,
            ));
            continue;
        }
        let what = format!("different whole numbers from 1 to {INSTANCE_LIMIT}, such as [2, 3]");
        let numbers: Option<Vec<usize>> = match &value.kind {
            ValueKind::Array(items) => items.iter().map(|item| number(&item.kind)).collect(),
            _ => None,
        };
        match numbers {
            Some(numbers) if !numbers.is_empty() && numbers.is_sorted_by(|a, b| a < b) => {
                found.push((letter, numbers));
            }
            _ => report.push(value.expected(&what)),
        }
    }
    let count = found.iter().map(|(_, n)| n.len()).product::<usize>();
    if count > INSTANCES_LIMIT {
        report.push(Diagnostic::new(
            DiagnosticKind::Unexpected {
                found: format!("{count} instances"),
                expected: format!("at most {INSTANCES_LIMIT}"),
            },
            found[0].0.span,
        ));
    }
    found
}

fn number(kind: &ValueKind) -> Option<usize> {
    match kind {
        ValueKind::Number(digits) => digits
            .parse::<u64>()
            .ok()
            .filter(|n| (1..=INSTANCE_LIMIT).contains(n))?
            .to_usize(),
        _ => None,
    }
}

/// Every combination of the letters' values, the last letter running fastest; one without letters
/// where there are none.
fn combinations(letters: &[(Text, Vec<usize>)]) -> Vec<Instance> {
    letters
        .iter()
        .fold(vec![Instance::new()], |shorter, (letter, values)| {
            shorter
                .iter()
                .flat_map(|instance| {
                    values.iter().map(move |value| {
                        let mut longer = instance.clone();
                        longer.insert(letter.text.clone(), *value);
                        longer
                    })
                })
                .collect()
        })
}

/// `f = 2`, for messages.
pub fn instance_text(instance: &Instance) -> String {
    let values: Vec<String> = instance.iter().map(|(l, v)| format!("{l} = {v}")).collect();
    values.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        let shown = |text: &str| Size::parse(text).map(|size| size.to_string());
        for text in ["1", "64", "f", "2f", "12n"] {
            assert_eq!(shown(text).as_deref(), Some(text));
        }
        assert_eq!(shown("1f").as_deref(), Some("f"));
        for text in [
            "", "0", "0f", "65", "ff", "f2", "-1", "2 f g", "\\zeta", "2.5",
        ] {
            assert_eq!(shown(text), None, "{text}");
        }
        let instance = Instance::from([("f".into(), 3)]);
        assert_eq!(Size::parse("2f").map(|s| s.at(&instance)), Some(6));
        assert_eq!(Size::fixed(4).at(&instance), 4);
    }

    #[test]
    fn instances_are_all_combinations() {
        let text = |word: &str| Text {
            text: word.into(),
            span: crate::span::Span::default(),
        };
        let letters = [(text("f"), vec![2, 3]), (text("r"), vec![1, 4])];
        let all: Vec<String> = combinations(&letters).iter().map(instance_text).collect();
        assert_eq!(
            all,
            [
                "f = 2, r = 1",
                "f = 2, r = 4",
                "f = 3, r = 1",
                "f = 3, r = 4"
            ]
        );
        assert_eq!(combinations(&[]), [Instance::new()]);
    }
}
