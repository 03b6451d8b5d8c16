//! What would cost too much ends by itself: the link is undecided or shown false by a point, the reason names
//! what was too large, and every other equation of the document keeps its verdict. Costs are counted in
//! steps, terms and bytes; nothing here looks at a clock.

mod common;

use common::audit;
use ratpoly::allowance::{self, Allowance};
use rederive::check::{self, Options};
use rederive::document::{Document, VerdictWord};
use rederive::model::Model;
use rederive::verdict::{Ended, Verdict};

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

/// A document whose constants are declared too.
fn with_constants(letters: &[String], fences: &[(&str, String)]) -> String {
    document(letters, fences)
        + "```toml notation\n'\\pi' = { constant = \"pi\" }\ne = { constant = \"e\" }\n```\n"
}

#[test]
fn definitions_behind_an_exponent_are_each_looked_at_once() {
    let mut fences = vec![("define", "u_{0} = a".to_string())];
    for k in 1..60 {
        let before = format!("u_{{{}}}", k - 1);
        fences.push(("define", format!("u_{{{k}}} = {before} + {before}")));
    }
    fences.push(("claim", "b^{u_{59}} = a".to_string()));
    let found = verdicts(&document(&letters("a b"), &fences));
    assert_ne!(found.last().expect("a claim").word(), VerdictWord::Holds);
}

#[test]
fn functions_of_functions_are_each_looked_at_once() {
    for step in ["e^{u} + u", "\\cos u + u", "\\sqrt{u + u^2}"] {
        let mut fences = vec![("define", "u_{0} = a".to_string())];
        for k in 1..18 {
            let before = format!("u_{{{}}}", k - 1);
            fences.push((
                "define",
                format!("u_{{{k}}} = {}", step.replace('u', &before)),
            ));
        }
        fences.push(("claim", "u_{17} = a".to_string()));
        let found = verdicts(&with_constants(&letters("a b"), &fences));
        assert_ne!(found.last().expect("a claim").word(), VerdictWord::Holds);
    }
}

#[test]
fn exponents_up_to_ten_thousand_are_used_and_others_cost_their_own_claim_only() {
    let one = |latex: &str| {
        let text = with_constants(&letters("a b x"), &[("claim", latex.to_string())]);
        verdicts(&text).pop().expect("a claim").word()
    };
    assert_eq!(
        one("\\int_0^a (x+1)^{1000}\\,dx = \\frac{(a+1)^{1001}-1}{1001}"),
        VerdictWord::Holds
    );
    for latex in ["9^{9^{9}} = 1", "a^{100000} = 1", "a^{-10^{30}} = 1"] {
        assert_eq!(one(latex), VerdictWord::Undecided, "{latex}");
    }
    // What nobody could write down shows nothing false, and takes no room.
    for latex in [
        "((2^{1000})^{1000})^{1000} = 1",
        "((a+1)^{1000})^{1000} = 1",
    ] {
        assert_ne!(one(latex), VerdictWord::Holds, "{latex}");
    }
}

/// The search counts what the exact engine spends on its candidates, ends by itself, and says how far it came.
#[test]
fn a_search_among_dear_candidates_ends_with_what_it_tried() {
    let latex =
        "\\sqrt{a^2+b^2} + \\sqrt{b^2+c^2} + \\sqrt{c^2+x^2} = a + \\int_0^a e^{y}\\cos y\\,dy";
    let text = with_constants(&letters("a b c x y"), &[("claim", latex.to_string())]);
    let searched = |threads| {
        let options = Options {
            work: 400_000,
            threads,
            ..Options::default()
        };
        let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
        match &audit.outcomes[0].verdict {
            Verdict::Refuted(refutation) => refutation.searched,
            other => panic!("{:?}", other.word()),
        }
    };
    let found = searched(1).expect("a search");
    assert_eq!(found.ended, Some(Ended::Work));
    assert!(found.tried > 0 && found.tried < found.of, "{found:?}");
    assert_eq!(searched(3), Some(found));
}

/// The steps that the check of a text takes, searches for corrections among them.
fn steps(text: &str) -> u64 {
    const ALL: u64 = u64::MAX / 2;
    let count = || {
        let document = Document::parse("test.md", text).expect("a document");
        let model = Model::build(&document).expect("a model");
        let allowed = Allowance {
            steps: ALL,
            bytes: usize::MAX,
        };
        let spent = allowance::within(allowed, || {
            let verdicts = check::check(&model, Options::default());
            assert!(verdicts.is_ok());
            ALL - allowance::steps_left()
        });
        spent.expect("the document has its own limits")
    };
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(256 << 20);
        let thread = thread.spawn_scoped(scope, count);
        thread.expect("a thread").join().expect("a count")
    })
}

#[test]
fn orders_of_functions_take_a_part_of_what_a_link_may() {
    for f in ["\\sinh", "\\tanh", "e^"] {
        let claim = format!("{f}{{a}} > {f}{{b}}");
        let text = with_constants(&letters("a b"), &[("claim", "a > b".into())])
            + &format!("```toml 0\nassume = ['{claim}']\n```\n");
        let spent = steps(&text);
        assert!(spent <= 100_000_000, "{claim}: {spent}");
    }
}
