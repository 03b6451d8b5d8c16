//! The table that `rederive check` prints: coverage first, then a line for each link.

use crate::audit::Audit;
use crate::diagnostic;
use crate::document::VerdictWord;
use crate::inspection::Inspection;
use crate::report::formula::Formulas;
use crate::report::reason::number_of;
use crate::report::rows::rows;
use crate::standing::Standing;
use crate::unit::UnitFinding;
use crate::verdict::{Contradiction, Outcome};
use comfy_table::{Cell, Color, ColumnConstraint, ContentArrangement, Table, Width, presets};

/// How the table looks.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// Whether the verdicts are coloured.
    pub colour: bool,
    /// The number of columns; none where lines may be as long as they are.
    pub width: Option<u16>,
}

/// One document: its title, its coverage, its verdicts.
pub fn table(inspection: &Inspection, style: Style) -> String {
    let audit = &inspection.audit;
    let formulas = Formulas::of(&audit.model);
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table.set_content_arrangement(ContentArrangement::Dynamic);
    if let Some(width) = style.width {
        table.set_width(width);
    }
    if style.colour {
        table.enforce_styling();
    } else {
        table.force_no_tty();
    }
    for row in rows(audit, &formulas) {
        let mut word = row.word.as_str().to_string();
        if row.standing == Standing::Differs {
            word += " (unexpected)";
        }
        let colour = match row.standing {
            Standing::AsExpected => colour(row.word),
            Standing::Differs => Color::Red,
            Standing::Undecided => Color::Magenta,
        };
        table.add_row(vec![
            Cell::new(row.number),
            Cell::new(word).fg(colour),
            Cell::new(shortened(row.reason.to_plain())),
        ]);
    }
    if let Some(column) = table.column_mut(2) {
        column.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(30)));
    }
    let lines: Vec<String> = table
        .to_string()
        .lines()
        .map(|line| line.trim_end().to_string())
        .collect();
    let document = &audit.model.document;
    // A document without a title is called by its file.
    let heading = match document.title == document.name {
        true => String::new(),
        false => format!("{}\n", document.title),
    };
    let mut out = format!(
        "{heading}{}\n{}\n\n{}\n",
        document.name,
        coverage(audit),
        lines.join("\n")
    );
    let lines = units(audit).into_iter().chain(floating_point(inspection));
    let lines = readings(audit)
        .into_iter()
        .chain(recalled(audit))
        .chain(lines);
    for line in lines.chain(undrawn(audit)).chain(contradictions(audit)) {
        out += &format!("\n {line}");
    }
    if out.ends_with('\n') { out } else { out + "\n" }
}

/// The most characters of a reason: a table has no wider columns.
const WIDEST: usize = 4_000;

/// A text that is too long for a table, such as one with a number of thousands of digits, cut where nobody
/// reads on; JSON has it whole.
fn shortened(text: String) -> String {
    match text.char_indices().nth(WIDEST) {
        Some((end, _)) => format!("{} ... ({} bytes)", &text[..end], text.len()),
        None => text,
    }
}

fn colour(word: VerdictWord) -> Color {
    match word {
        VerdictWord::Holds => Color::Green,
        VerdictWord::HoldsGiven | VerdictWord::Loose => Color::Yellow,
        VerdictWord::Misprint | VerdictWord::Refuted => Color::Red,
        VerdictWord::Undecided => Color::Magenta,
        VerdictWord::Definition | VerdictWord::Recalled => Color::Reset,
    }
}

/// `links: 30 checked, 9 defined, 2 recalled, 0 undecided, 0 not read`.
fn counted(audit: &Audit) -> String {
    let counts = audit.counts();
    format!(
        "links: {} checked, {} defined, {} recalled, {} undecided, {} not read",
        counts.checked, counts.defined, counts.recalled, counts.undecided, counts.not_read
    )
}

/// `24 of 24 numbered equations have a verdict`, or which have none.
pub fn coverage(audit: &Audit) -> String {
    let coverage = audit.coverage();
    let links = counted(audit);
    let statements = statements(audit);
    let figures = figure_coverage(audit);
    let of_sizes = audit.outcomes.iter().filter(|o| o.sizes.is_some()).count();
    let statements = match of_sizes {
        0 => statements,
        n => format!(", {n} of them for the named sizes only{statements}"),
    };
    if coverage.announced.is_empty() {
        return format!("{links}{statements}; the document announces no equation numbers{figures}");
    }
    let mut line = format!(
        "{} of {} numbered equations have a verdict",
        coverage.covered(),
        coverage.announced.len()
    );
    let list = |numbers: &[u32]| {
        let numbers: Vec<String> = numbers.iter().map(|n| format!("({n})")).collect();
        numbers.join(", ")
    };
    if !coverage.absent.is_empty() {
        line += &format!("; not in the document: {}", list(&coverage.absent));
    }
    if !coverage.undecided.is_empty() {
        line += &format!("; undecided: {}", list(&coverage.undecided));
    }
    line + &format!("; {links}{statements}{figures}")
}

/// `; 20 of 21 statements decided`, or nothing where the document has none.
fn statements(audit: &Audit) -> String {
    let of = |wanted: &dyn Fn(VerdictWord) -> bool| {
        audit.statements.iter().filter(|o| wanted(o.word)).count()
    };
    let recalled = of(&|w| w == VerdictWord::Recalled);
    let all = audit.statements.len() - recalled;
    if all == 0 {
        return String::new();
    }
    let decided = all - of(&|w| w == VerdictWord::Undecided);
    format!("; {decided} of {all} propositions of statements decided")
}

/// `; 5 of 5 figures`, or which are not drawn; nothing where the document announces none.
fn figure_coverage(audit: &Audit) -> String {
    let coverage = audit.figure_coverage();
    if coverage.announced.is_empty() {
        return String::new();
    }
    let mut line = format!(
        "; {} of {} figures",
        coverage.covered(),
        coverage.announced.len()
    );
    if !coverage.absent.is_empty() {
        let absent: Vec<String> = coverage.absent.iter().map(u32::to_string).collect();
        line += &format!(", not drawn: {}", absent.join(", "));
    }
    line
}

/// Whether the document says anything about units.
pub fn has_units(audit: &Audit) -> bool {
    audit.model.symbols.iter().any(|s| s.unit.is_some())
}

/// The findings on units by equation: the first and how many more.
pub fn units_by_equation(audit: &Audit) -> Vec<(&UnitFinding, usize)> {
    let mut found: Vec<(&UnitFinding, usize)> = Vec::new();
    for finding in &audit.units {
        match found
            .iter_mut()
            .find(|(first, _)| first.label == finding.label)
        {
            Some((_, more)) => *more += 1,
            None => found.push((finding, 0)),
        }
    }
    found
}

fn units(audit: &Audit) -> Vec<String> {
    if audit.units.is_empty() && has_units(audit) {
        return vec!["units: every equation is homogeneous".into()];
    }
    units_by_equation(audit)
        .into_iter()
        .map(|(first, more)| match more {
            0 => format!("units, ({}): {first}", first.label),
            n => format!("units, ({}): {first}; {n} more such places", first.label),
        })
        .collect()
}

/// How equations were read where the print leaves a choice.
fn readings(audit: &Audit) -> Vec<String> {
    audit
        .readings()
        .map(|(label, printed, read)| {
            let printed = diagnostic::printable_line(printed);
            format!("({label}): {printed} is read as {read}")
        })
        .collect()
}

/// What is only recalled and false as an identity.
fn recalled(audit: &Audit) -> Vec<String> {
    let found = audit.recalled_and_false.iter();
    found
        .map(|(equation, member)| {
            let printed = &audit.model.equations[*equation];
            let number = printed.number_of(*member);
            format!("({number}) is only recalled, and as an identity in its letters it is false")
        })
        .collect()
}

/// What the floating-point route says, in a line or two.
fn floating_point(inspection: &Inspection) -> Vec<String> {
    let Some(comparison) = &inspection.comparison else {
        return Vec::new();
    };
    let mut lines = Vec::new();
    for (named, points) in [(false, "random points"), (true, "named points")] {
        let count = comparison
            .points
            .iter()
            .filter(|p| p.named == named)
            .count();
        if let Some((digits, point)) = inspection.fewest_digits(named) {
            let place = &comparison.points[point].name;
            lines.push(format!(
                "floating point: at {count} {points} the best method keeps {digits:.1} digits or \
                 more (fewest at {place})"
            ));
        }
    }
    for subject in comparison.conflicts() {
        lines.push(format!(
            "floating point: {} is not confirmed: rounding leaves no digit of it at the first point \
             (inconclusive; no verdict rests on it)",
            inspection.subject(subject)
        ));
    }
    lines
}

/// The figures that are not drawn, and why.
fn undrawn(audit: &Audit) -> Vec<String> {
    let figures = audit.figures.iter();
    let why = figures.filter_map(|f| Some((&f.label, f.content.as_ref().err()?)));
    why.map(|(label, why)| format!("figure {label} is not drawn: {why}"))
        .collect()
}

/// Where the program contradicts itself.
fn contradictions(audit: &Audit) -> Vec<String> {
    audit
        .outcomes
        .iter()
        .filter_map(|outcome| {
            let what = match outcome.contradiction.as_ref()? {
                Contradiction::Certificate => "a certificate does not verify",
                Contradiction::Challenge(_) => {
                    "what was proved equal is apart at a point, by certified enclosures"
                }
            };
            Some(format!(
                "CONTRADICTION in ({}): {what}; this is a fault of the program, please report it",
                number_of(audit, outcome)
            ))
        })
        .collect()
}

/// How many links have which verdict: `41 hold, ...`, in the order of the table of verdicts.
pub fn tally(outcomes: &[Outcome]) -> Vec<(VerdictWord, usize)> {
    VerdictWord::ALL
        .into_iter()
        .map(|word| {
            let count = outcomes.iter().filter(|o| o.verdict.word() == word).count();
            (word, count)
        })
        .filter(|(_, count)| *count > 0)
        .collect()
}
