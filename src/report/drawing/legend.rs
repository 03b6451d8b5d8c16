//! What is marked in a figure, in words.

use crate::document::figure::Extremum;
use crate::figure::{Agreement, Curves, Mark, MarkKind, Sketch, Surface};
use crate::report::decimal::decimal;
use crate::report::prose::Prose;
use crate::theory::extremum::{Coordinate, Unknown};
use num_rational::BigRational;

/// Digits of a place and of a value.
const DIGITS: usize = 4;

/// `30000 N/m`; large and small numbers by their power of ten.
pub fn with_unit(value: &BigRational, unit: Option<&str>) -> String {
    let number = decimal(value, 5);
    let digits = number.trim_start_matches('-').len();
    let (mantissa, power) = match number.split_once('e') {
        Some((mantissa, power)) => (mantissa.to_string(), power.to_string()),
        None if digits > 7 && !number.contains('.') => {
            let figures = number.trim_end_matches('0');
            let (first, rest) = figures.split_at(number.len() - digits + 1);
            let point = if rest.is_empty() { "" } else { "." };
            (format!("{first}{point}{rest}"), (digits - 1).to_string())
        }
        None => (number, String::new()),
    };
    let number = match (power.is_empty(), mantissa.as_str()) {
        (true, _) => mantissa,
        (false, "1") => format!("10{}", raised(&power)),
        (false, _) => format!("{mantissa}·10{}", raised(&power)),
    };
    match unit {
        None | Some("1") => number,
        Some(unit) => format!("{number} {}", unit_words(unit)),
    }
}

/// Digits as exponents.
fn raised(digits: &str) -> String {
    let high = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => match c.to_digit(10) {
            Some(d) => char::from_u32(0x2070 + d).unwrap_or(c),
            None => c,
        },
    };
    digits.chars().map(high).collect()
}

/// A unit with raised powers: `m²/s⁴` for `m^2/s^4`.
pub fn unit_words(unit: &str) -> String {
    let mut out = String::new();
    let mut rest = unit;
    while let Some(at) = rest.find('^') {
        out.push_str(&rest[..at]);
        let power = &rest[at + 1..];
        let digits = |c: char| c.is_ascii_digit() || c == '-';
        let end = power.find(|c| !digits(c)).unwrap_or(power.len());
        if end == 0 {
            out.push('^');
        } else {
            out.push_str(&raised(&power[..end]));
        }
        rest = &power[end..];
    }
    out + rest
}

/// A coordinate with its mark for rounding.
fn coordinate(at: &Coordinate, scale: &BigRational, unit: Option<&str>) -> (&'static str, String) {
    match at.exact() {
        Some(exact) => {
            let value = exact * scale;
            let shown = decimal(&value, 5);
            let sign = match crate::document::exact_number(&shown) {
                Ok(read) if read == value => " = ",
                _ => " ≈ ",
            };
            (sign, with_unit(&value, unit))
        }
        None => {
            let (low, high) = at.interval();
            let middle = (low + high) / BigRational::from_integer(2.into());
            (" ≈ ", with_unit(&(middle * scale), unit))
        }
    }
}

/// The value of a mark, rounded.
pub fn value(mark: &Mark) -> Option<String> {
    let (low, high) = &mark.place.as_ref().ok()?.value;
    let middle = (low + high) / BigRational::from_integer(2.into());
    Some(decimal(&middle, DIGITS))
}

fn smallest(kind: Extremum) -> &'static str {
    match kind {
        Extremum::Minimum => "smallest",
        Extremum::Maximum => "largest",
    }
}

fn unknown(why: Unknown) -> &'static str {
    match why {
        Unknown::Pole => "the quantity has a pole there",
        Unknown::NotIsolated => "it is taken along a curve",
        Unknown::Tie => "it is taken at more than one place",
        Unknown::None => "there is none",
        Unknown::Limit => "a limit of size was hit",
    }
}

/// The reference point in words.
pub fn reference(surface: &Surface) -> Prose {
    let [x, y] = &surface.axes;
    Prose::of("reference: ")
        .math(x.name.clone())
        .words(format!(
            " = {}, ",
            with_unit(&x.reference, x.unit.as_deref())
        ))
        .math(y.name.clone())
        .words(format!(" = {}", with_unit(&y.reference, y.unit.as_deref())))
}

/// A mark in words.
pub fn mark(surface: &Surface, mark: &Mark) -> Option<Prose> {
    let axis = |k: usize| &surface.axes[k];
    match (&mark.kind, &mark.place) {
        (MarkKind::Optimum(kind), Err(why)) => Some(Prose::of(format!(
            "the {} value in the drawn range is not marked: {}",
            smallest(*kind),
            unknown(*why)
        ))),
        (MarkKind::Optimum(kind), Ok(place)) => {
            let mut words = Prose::of(format!(
                "{} in the drawn range: {} at ",
                smallest(*kind),
                value(mark)?
            ));
            for (k, at) in place.coordinates.iter().enumerate() {
                let axis = axis(k);
                let (sign, shown) = coordinate(at, &axis.reference, axis.unit.as_deref());
                if k > 0 {
                    words = words.words(", ");
                }
                words = words
                    .math(axis.name.clone())
                    .words(format!("{sign}{shown}"));
            }
            let at_edge = match place.inside.as_slice() {
                [true, true] => "",
                [false, false] => " (a corner)",
                _ => " (on the edge)",
            };
            Some(words.words(at_edge))
        }
        // Where there is none along an axis nothing needs to be said.
        (MarkKind::Section(..), Err(_)) => None,
        (MarkKind::Section(k, kind), Ok(place)) => {
            let along = axis(*k);
            let other = axis(1 - *k);
            let (sign, shown) = coordinate(
                &place.coordinates[0],
                &along.reference,
                along.unit.as_deref(),
            );
            let words = Prose::of(format!("{} along ", smallest(*kind)))
                .math(along.name.clone())
                .words(" at the reference ")
                .math(other.name.clone())
                .words(format!(": {} at ", value(mark)?))
                .math(along.name.clone())
                .words(format!("{sign}{shown}"));
            Some(match is_drawn(surface, *k, &place.coordinates[0]) {
                true => words,
                false => words.words(" (not in the drawn range)"),
            })
        }
    }
}

/// Whether a coordinate lies in the drawn range.
pub fn is_drawn(surface: &Surface, axis: usize, at: &Coordinate) -> bool {
    let (low, high) = at.interval();
    let range = surface.axes[axis].range();
    range.0 <= &low && &high <= range.1
}

/// The caption of a surface; the marks are explained in the picture.
pub fn remarks(surface: &Surface) -> Vec<Prose> {
    let [x, y] = &surface.axes;
    vec![
        Prose::new()
            .math(surface.quantity.clone())
            .words(" over ")
            .math(x.name.clone())
            .words(" and ")
            .math(y.name.clone())
            .words(", as multiples of the values at the reference point, where ")
            .math(surface.quantity.clone())
            .words(format!(
                " is {}",
                with_unit(&surface.reference, surface.unit.as_deref())
            )),
    ]
}

/// The caption of curves; the family is explained in the picture.
pub fn curve_remarks(curves: &Curves) -> Vec<Prose> {
    let mut remarks = Vec::new();
    if !curves.at.is_empty() {
        let at = curves.at.iter().map(|(name, value, unit)| {
            Prose::new()
                .math(name.clone())
                .words(format!(" = {}", with_unit(value, unit.as_deref())))
        });
        remarks.push(Prose::joined(at, ", "));
    }
    remarks
}

/// The caption of a sketch.
pub fn sketch_remarks(sketch: &Sketch) -> Vec<Prose> {
    let list =
        |names: &[String]| Prose::joined(names.iter().map(|n| Prose::new().math(n.clone())), ", ");
    match &sketch.equations {
        None => Vec::new(),
        Some((label, Agreement::Agrees)) => vec![Prose::of(format!(
            "Newton's law for each mass of this sketch gives the equations of motion ({label})"
        ))],
        Some((label, Agreement::Differs(names))) => vec![
            Prose::of("Newton's law for this sketch contradicts the equations of motion ")
                .words(format!("({label}) for "))
                .then(list(names)),
        ],
        Some((label, Agreement::Unknown(names))) => vec![
            Prose::of(format!(
                "the equations ({label}) determine no acceleration of "
            ))
            .then(list(names)),
        ],
    }
}
