//! What would cost too much ends by itself: the link is undecided or shown false by a point, the reason names
//! what was too large, and every other equation of the document keeps its verdict. Costs are counted in
//! steps, terms and bytes; nothing here looks at a clock.

mod common;

use common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord;
use rederive::verdict::Verdict;

/// A document with these letters, and a last claim that must hold whatever the others cost.
fn document(letters: &[String], fences: &[(&str, String)]) -> String {
    let mut text = String::from("```toml symbols\n");
    for letter in letters {
        text += &format!("'{letter}' = {{ meaning = \"\", positive = true }}\n");
    }
    text += "```\n";
    for (k, (role, latex)) in fences.iter().enumerate() {
        text += &format!("```math {k} {role}\n{latex}\n```\n");
    }
    let first = &letters[0];
    text + &format!("```math last claim\n{first} + 1 = 1 + {first}\n```\n")
}

fn letters(names: &str) -> Vec<String> {
    names.split(' ').map(String::from).collect()
}

fn numbered(name: &str, count: usize) -> Vec<String> {
    (0..count).map(|i| format!("{name}_{{{i}}}")).collect()
}

/// The verdicts, without a search for corrections; the last claim holds.
fn verdicts(text: &str) -> Vec<Verdict> {
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let audit = audit(text, options).unwrap_or_else(|r| panic!("{r}"));
    let mut verdicts: Vec<Verdict> = audit.outcomes.into_iter().map(|o| o.verdict).collect();
    let last = verdicts.pop().expect("the last claim");
    assert_eq!(last.word(), VerdictWord::Holds, "{text}");
    verdicts
}

/// The claim before the last is undecided for such a reason, or false at a point; it is never true.
fn ends(text: &str, reason: &str) {
    match verdicts(text).pop().expect("a claim") {
        Verdict::Undecided { reason: found } => {
            assert!(found.contains(reason), "{found}: {text}");
        }
        Verdict::Refuted(_) => {}
        other => panic!("{:?}: {text}", other.word()),
    }
}

/// A false claim about an expression that is too large.
fn claim(letters: &[String], latex: &str) -> String {
    document(letters, &[("claim", latex.to_string())])
}

fn matrix(n: usize, entry: impl Fn(usize, usize) -> String) -> String {
    let row = |i: usize| (0..n).map(|j| entry(i, j)).collect::<Vec<_>>().join(" & ");
    let rows: Vec<String> = (0..n).map(row).collect();
    format!(
        "\\begin{{bmatrix}} {} \\end{{bmatrix}}",
        rows.join(" \\\\ ")
    )
}

#[test]
fn sums_inside_of_sums_are_counted_before_they_are_added_up() {
    for body in ["ijk", "\\frac{1}{i + jk + a}", "a^2"] {
        let latex = format!(
            "\\sum_{{i=1}}^{{1000}} \\sum_{{j=1}}^{{1000}} \\sum_{{k=1}}^{{1000}} {body} = a"
        );
        let text = claim(&letters("a"), &latex);
        match verdicts(&text).pop().expect("a claim") {
            Verdict::Undecided { reason } => assert!(reason.contains("terms of a sum"), "{reason}"),
            other => panic!("{:?}", other.word()),
        }
    }
    let small = claim(
        &letters("a"),
        "\\sum_{i=1}^{20} \\sum_{j=1}^{20} ija = 44100 a",
    );
    assert_eq!(verdicts(&small)[0].word(), VerdictWord::Holds);
}

#[test]
fn powers_with_too_many_terms_end() {
    let six = letters("a b c x y z");
    for latex in [
        "(a + b + c + x + y + z)^{60} = 1",
        "(a + b + c + x)^{200} = 1",
        "\\left(\\frac{a}{b} + \\frac{b}{c} + \\frac{c}{x} + \\frac{x}{y}\\right)^{60} = 1",
    ] {
        ends(&claim(&six, latex), "too many");
    }
}

#[test]
fn determinants_and_powers_of_matrices_of_letters_end() {
    for n in [10, 12] {
        let entries: Vec<String> = (0..n * n).map(|k| format!("s_{{{k}}}")).collect();
        let m = matrix(n, |i, j| format!("s_{{{}}}", n * i + j));
        ends(&claim(&entries, &format!("\\det {m} = 1")), "too many");
    }
    let entries = numbered("s", 36);
    let m = matrix(6, |i, j| format!("s_{{{}}}", 6 * i + j));
    ends(
        &claim(&entries, &format!("\\det {m}^{{20}} = 1")),
        "too many",
    );
}

#[test]
fn fractions_with_many_denominators_end() {
    let letters = numbered("s", 40);
    let sum: Vec<String> = (1..40)
        .map(|k| format!("\\frac{{1}}{{s_{{{k}}} + s_{{0}}}}"))
        .collect();
    ends(
        &claim(&letters, &format!("s_{{0}} = {}", sum.join(" + "))),
        "too many",
    );
}

#[test]
fn definitions_that_double_what_they_need_are_each_looked_at_once() {
    let mut fences = vec![("define", "u_{0} = a + b".to_string())];
    for k in 1..200 {
        let before = format!("u_{{{}}}", k - 1);
        fences.push(("define", format!("u_{{{k}}} = {before} + {before}")));
    }
    fences.push(("claim", "u_{199} = a".to_string()));
    ends(&document(&letters("a b"), &fences), "too many");
}

#[test]
fn squarings_by_definition_end() {
    let mut fences = vec![("define", "u_{0} = a + b".to_string())];
    for k in 1..60 {
        fences.push(("define", format!("u_{{{k}}} = u_{{{}}}^2", k - 1)));
    }
    fences.push(("claim", "u_{59} = a".to_string()));
    ends(&document(&letters("a b"), &fences), "too");
}
