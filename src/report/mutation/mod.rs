//! The figures of `rederive mutate`: a table by class, then what needs a reader's eye.

pub mod json;

use crate::mutation::tally::{Kepts, Tally, kepts, tally};
use crate::mutation::{Fate, Kept, Mutation, Said, Tried};
use comfy_table::{CellAlignment, Table, presets};
use std::collections::BTreeMap;

/// How many examples of a kind are shown.
const EXAMPLES: usize = 3;

/// One document: its table, and what is equivalent, undecided, a false alarm or let pass.
pub fn plain(mutation: &Mutation) -> String {
    let (total, _) = tally([mutation]);
    let mut out = format!("{}\n{}\n", mutation.title, mutation.document);
    out += &headline(mutation, &total);
    if total.mutants == 0 {
        out += &left_out(mutation);
        return out;
    }
    out += &format!("\n{}", table(&[mutation]));
    out += &meaningless(mutation);
    out += &equivalent(mutation);
    out += &undecided(mutation);
    out += &left_out(mutation);
    out += &faults(mutation);
    out += &rewritings(mutation);
    out
}

/// The rewritings that are not accepted any more.
fn rewritings(mutation: &Mutation) -> String {
    let Mutation {
        rewritten,
        possible_rewritings,
        ..
    } = mutation;
    let (total, _) = kepts([mutation]);
    let mut out = format!(
        "\n true rewritings: {} of {possible_rewritings} tried, {} accepted as before\n",
        total.rewritings, total.accepted
    );
    let example = |said: &Said| {
        let (label, member) = (&said.label, said.member);
        format!(
            "({label}.{member}) {}: {}",
            said.rewriting.as_str(),
            one_line(&said.rewritten)
        )
    };
    let mut undecided: BTreeMap<&str, Vec<&Said>> = BTreeMap::new();
    for said in rewritten {
        if let Kept::Undecided(reason) = &said.kept {
            undecided.entry(reason).or_default().push(said);
        }
    }
    for (reason, members) in undecided {
        out += &format!("  {:>5}  {reason}\n", members.len());
        for said in members.iter().take(EXAMPLES) {
            out += &format!("           {}\n", example(said));
        }
    }
    let rejected = rewritten.iter().filter_map(|said| match &said.kept {
        Kept::Rejected(why) => Some((said, why)),
        Kept::Accepted | Kept::Undecided(_) => None,
    });
    let rejected: Vec<(&Said, &String)> = rejected.collect();
    if rejected.is_empty() {
        return out + "\n wrongly rejected: none\n";
    }
    out += &format!(
        "\n wrongly rejected: {}; each is a fault of the program\n",
        rejected.len()
    );
    for (said, why) in rejected {
        out += &format!("  {}\n    {why}\n", example(said));
    }
    out
}

/// All documents together.
pub fn summary(mutations: &[Mutation]) -> String {
    let all: Vec<&Mutation> = mutations.iter().collect();
    let (total, _) = tally(all.iter().copied());
    format!(
        "{} documents, {} mutants, {} rewritings\n\n{}",
        all.len(),
        total.mutants,
        kepts(all.iter().copied()).0.rewritings,
        table(&all)
    )
}

fn headline(mutation: &Mutation, total: &Tally) -> String {
    let Mutation { possible, seed, .. } = mutation;
    let mut line = match (total.mutants, *possible) {
        (_, 0) => return "no claim and no definition to damage\n".into(),
        (tried, possible) if tried < possible => {
            format!("{tried} of {possible} mutants tried, drawn with seed {seed}")
        }
        (tried, _) => format!("{tried} mutants: every single edit of every claim and definition"),
    };
    let refuted = mutation.tried.iter().filter(|t| t.is_refuted_claim());
    line += &match (total.repairs_tried, refuted.count()) {
        (0, _) => "; the search for corrections was not tried".to_string(),
        (tried, all) if tried < all => format!(
            "; the search for corrections tried on {tried} of {all} refuted claims, drawn with \
             seed {seed}"
        ),
        (tried, _) => format!("; the search for corrections tried on all {tried} refuted claims"),
    };
    line + "\n"
}

fn table(mutations: &[&Mutation]) -> String {
    let (total, by_class) = tally(mutations.iter().copied());
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table.force_no_tty();
    table.set_header([
        "class",
        "tried",
        "refuted",
        "no meaning",
        "equivalent",
        "undecided",
        "survived",
        "wrongly rejected",
        "repaired first",
        "repaired any",
    ]);
    let row = |name: &str, tally: &Tally| {
        let of_tried = |n: usize| match tally.repairs_tried {
            0 => "-".to_string(),
            tried => format!("{n} of {tried}"),
        };
        vec![
            name.to_string(),
            tally.mutants.to_string(),
            tally.refuted.to_string(),
            tally.meaningless.to_string(),
            tally.equivalent.to_string(),
            tally.undecided.to_string(),
            tally.survived.to_string(),
            tally.false_alarms.to_string(),
            of_tried(tally.repaired_first),
            of_tried(tally.repaired_any),
        ]
    };
    for (class, tally) in &by_class {
        table.add_row(row(class.as_str(), tally));
    }
    table.add_row(row("false edits", &total));
    let (total, by_kind) = kepts(mutations.iter().copied());
    let row = |name: &str, kepts: &Kepts| {
        let none = || "-".to_string();
        vec![
            name.to_string(),
            kepts.rewritings.to_string(),
            none(),
            none(),
            kepts.accepted.to_string(),
            kepts.undecided.to_string(),
            none(),
            kepts.rejected.to_string(),
            none(),
            none(),
        ]
    };
    for (kind, kepts) in &by_kind {
        table.add_row(row(kind.as_str(), kepts));
    }
    table.add_row(row("true rewritings", &total));
    for column in 1..10 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    let lines: Vec<String> = table
        .to_string()
        .lines()
        .map(|line| line.trim_end().to_string())
        .collect();
    lines.join("\n") + "\n"
}

/// `(62.3) index: H_{31} -> H_{13}`.
fn example(tried: &Tried) -> String {
    let class = tried.class.as_str();
    let (label, member) = (&tried.label, tried.member);
    format!("({label}.{member}) {class}: {} -> {}", tried.from, tried.to)
}

/// Mutants by what is said of them: how many, and the first few.
fn grouped<'t>(
    mutation: &'t Mutation,
    say: impl Fn(&'t Tried) -> Option<String>,
) -> Vec<(String, Vec<&'t Tried>)> {
    let mut groups: BTreeMap<String, Vec<&Tried>> = BTreeMap::new();
    for tried in &mutation.tried {
        if let Some(said) = say(tried) {
            groups.entry(said).or_default().push(tried);
        }
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    groups.sort_by_key(|(_, members)| std::cmp::Reverse(members.len()));
    groups
}

fn group_lines(title: &str, groups: Vec<(String, Vec<&Tried>)>) -> String {
    if groups.is_empty() {
        return String::new();
    }
    let mut out = format!("\n {title}\n");
    for (said, members) in groups {
        out += &format!("  {:>5}  {said}\n", members.len());
        for tried in members.iter().take(EXAMPLES) {
            out += &format!("           {}\n", example(tried));
        }
    }
    out
}

fn meaningless(mutation: &Mutation) -> String {
    let groups = grouped(mutation, |tried| match &tried.fate {
        Fate::Meaningless { why, .. } => Some(why.to_string()),
        _ => None,
    });
    group_lines("refuted because it has no meaning:", groups)
}

fn equivalent(mutation: &Mutation) -> String {
    let groups = grouped(mutation, |tried| match &tried.fate {
        Fate::Equivalent(equivalence) => Some(equivalence.as_str().to_string()),
        _ => None,
    });
    group_lines("equivalent to the original:", groups)
}

fn undecided(mutation: &Mutation) -> String {
    let groups = grouped(mutation, |tried| match &tried.fate {
        Fate::Undecided(reason) => Some(reason.clone()),
        _ => None,
    });
    group_lines("undecided, and no pass:", groups)
}

fn left_out(mutation: &Mutation) -> String {
    if mutation.left_out.is_empty() {
        return String::new();
    }
    let mut out = "\n not damaged, for want of a true original:\n".to_string();
    for left in &mutation.left_out {
        out += &format!("  ({}.{}) {}\n", left.label, left.member, left.why);
    }
    out
}

fn faults(mutation: &Mutation) -> String {
    let mut out = String::new();
    for (what, wanted) in [("refuted although equivalent", true), ("survived", false)] {
        let found: Vec<&Tried> = mutation
            .tried
            .iter()
            .filter(|tried| match tried.fate {
                Fate::Refuted { false_alarm, .. } => wanted && false_alarm,
                Fate::Survived => !wanted,
                _ => false,
            })
            .collect();
        if found.is_empty() {
            out += &format!("\n {what}: none\n");
            continue;
        }
        out += &format!(
            "\n {what}: {}; each is a fault of the program\n",
            found.len()
        );
        for tried in found {
            out += &format!("  {}\n    {}\n", example(tried), one_line(&tried.mutant));
        }
    }
    out
}

fn one_line(latex: &str) -> String {
    latex.split_whitespace().collect::<Vec<_>>().join(" ")
}
