//! What a correction does to the rest of a document: nothing that holds as printed falls, and nothing that
//! is judged with a correction goes without its name.
//!
//! Chains and definitions with one slip, and claims, inequalities and statements that rest on them: the truth as
//! printed and the truth of what was meant are known by construction.

use super::unwritten::{Claim, Truth, undecided};
use crate::common::audit;
use Truth::{False, Open, True};
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::VerdictWord;
use rederive::report::formula::Formulas;
use rederive::report::reason::reason;

const LETTERS: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
t = { }
p = { function_of = 't' }
q = { function_of = 't' }
X = { }
```
";

/// The value that is printed, one that it is printed to be equal to, and a slip of the second.
const CHAINS: [(&str, &str, &str); 6] = [
    ("(x + y)^2", "x^2 + 2xy + y^2", "x^2 - 2xy + y^2"),
    ("4xy", "2xy + 2xy", "2x + 2xy"),
    ("a^2 + x^2", "x^2 + a^2", "(a - x)(a + x)"),
    ("a(x + y)", "ax + ay", "ax + y"),
    (r"\frac12ax^2", r"\frac{ax^2}{2}", "ax^2"),
    ("x^2 + 1", "1 + x^2", "(x - 1)(x + 1)"),
];

#[test]
fn what_holds_as_printed_holds_after_a_correction() {
    for role in ["claim", "define"] {
        for (value, _, slip) in CHAINS {
            let mut claims: Vec<(String, bool)> = Vec::new();
            for k in 1..=3 {
                claims.push((format!("{k}V = {k}({value})"), true));
                claims.push((format!("V^{k} = ({value})^{k}"), true));
                claims.push((format!("V + {k} = {value} + {k}"), true));
                claims.push((format!("V + {k} = {value}"), false));
                claims.push((format!("V = {value} - {k}x"), false));
            }
            claims.push((format!(r"\frac{{\mathrm{{d}}V}}{{\mathrm{{d}}x}} = \frac{{\mathrm{{d}}}}{{\mathrm{{d}}x}}({value})"), true));
            claims.push((format!("V \\ge {value}"), true));
            let mut text = format!("{LETTERS}```math 0 {role}\nV = {value} = {slip}\n```\n");
            for (k, (claim, _)) in claims.iter().enumerate() {
                text += &format!("```math c{k} claim\n{claim}\n```\n");
            }
            let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
            for (k, (claim, truth)) in claims.iter().enumerate() {
                let equation = audit.model.equation(&format!("c{k}")).expect("a claim");
                let outcome = audit.outcomes_of(equation).last().expect("a link");
                let word = outcome.verdict.word();
                let holds = matches!(word, VerdictWord::Holds | VerdictWord::HoldsGiven);
                match truth {
                    true => assert!(holds, "{role} V = {value} = {slip}: {claim}: {word}"),
                    // With what was corrected it may hold, and then it says so.
                    false if holds => assert!(named(&audit, &format!("c{k}")), "{claim}"),
                    false => {}
                }
            }
        }
    }
}

/// Whether the reason of an equation's verdict names a correction.
fn named(audit: &Audit, label: &str) -> bool {
    let equation = audit.model.equation(label).expect("an equation");
    let outcome = audit.outcomes_of(equation).last().expect("a link");
    let formulas = Formulas::of(&audit.model);
    reason(audit, &formulas, outcome)
        .to_plain()
        .contains("as corrected")
}

#[test]
fn links_of_a_chain_beside_a_correction() {
    for (value, same, slip) in CHAINS {
        // The slip in the middle, behind, and twice the same.
        let chains = [
            (format!("{value} = {slip} = {same}"), [false, false]),
            (format!("{value} = {same} = {slip}"), [true, false]),
            (format!("{slip} = {value} = {same}"), [false, true]),
        ];
        for (chain, truths) in chains {
            let text = format!("{LETTERS}```math 1 claim\n{chain}\n```\n");
            let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
            let formulas = Formulas::of(&audit.model);
            for (outcome, truth) in audit.outcomes.iter().zip(truths) {
                let word = outcome.verdict.word();
                let words = reason(&audit, &formulas, outcome).to_plain();
                match (truth, word) {
                    (true, VerdictWord::Refuted) => panic!("{chain}: {words}"),
                    (true, VerdictWord::Misprint) => {
                        assert!(words.contains("true as printed"), "{chain}: {words}");
                    }
                    (false, VerdictWord::Holds) => {
                        assert!(words.contains("as corrected"), "{chain}: {words}");
                    }
                    _ => {}
                }
            }
            // A correction leaves true what stands before it.
            if let [first, ..] = audit.outcomes.as_slice()
                && truths[0]
            {
                assert_eq!(first.verdict.word(), VerdictWord::Holds, "{chain}");
            }
        }
    }
}

#[test]
fn a_definition_is_not_corrected_against_what_rests_on_it() {
    for (definition, slip, true_of_it) in [
        ("x^2 + 1", "(x - 1)(x + 1)", "D > 0"),
        ("y^2 + 2", "y^2 - 2", r"D \ge 1"),
        ("2x", "3x", r"x \to \infty, \quad \frac{D}{x} \to 2"),
        ("x^2 + 1", "x^2 - 1", r"D \ne 0"),
    ] {
        let text = format!(
            "{LETTERS}```math 0 define\nD = {definition}\n```\n```math 1 claim\nD = {slip}\n```\n\
             ```math 2 claim\nD + 1 = {slip} + 1\n```\n```math 3 claim\n{true_of_it}\n```\n\
             ```statement 4\nD is what it is.\n```\n```toml 4\nof = ['D']\npredicate = \"positive\"\n```\n"
        );
        let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
        for outcome in &audit.outcomes {
            if let rederive::verdict::Verdict::Misprint { correction, .. } = &outcome.verdict {
                assert!(correction.definition.is_none(), "{definition} -> {slip}");
            }
        }
        let equation = audit.model.equation("3").expect("a claim");
        let outcome = audit.outcomes_of(equation).last().expect("a link");
        assert_eq!(outcome.verdict.word(), VerdictWord::Holds, "{true_of_it}");
    }
}

/// What a hypothesis divides by does not vanish where it holds.
#[test]
fn reciprocals_do_not_vanish() {
    let mut claims = Vec::new();
    for (hypothesis, divisor) in [
        ("xy = 1", "y"),
        (r"\frac1x = y", "y"),
        ("x(y - 1) = 2", "(y - 1)"),
        ("x(y - a) = 1", "(y - a)"),
        ("x(y + a) = b", "(y + a)"),
        (r"\frac{x - 1}{x} = y", "(y - 1)"),
        ("2xy = -3", "y"),
        ("xy^2 = 1", "y"),
        ("x(y^2 - 4) = 1", "(y - 2)"),
    ] {
        for (claim, truth) in [
            (format!("{divisor} \\ne 0"), True),
            (format!("{divisor}^2 > 0"), True),
            (format!("{divisor}^4 > 0"), True),
            (format!("{divisor}^2 \\ge 0"), True),
            (format!("{divisor} = 0"), False),
            (format!("{divisor} > 0"), False),
            (format!("{divisor}^2 > 1"), False),
        ] {
            claims.extend(Claim::assumed_and_given(&claim, &[hypothesis], truth));
        }
    }
    let open = undecided(LETTERS, &claims);
    assert!(5 * open.len() <= claims.len(), "{open:#?}");
}

/// A form in rates is positive beside zero only, and unless all rates vanish.
#[test]
fn forms_in_rates_beside_what_is_no_zero() {
    let mut claims = Vec::new();
    for form in [
        r"\dot p^2",
        r"\dot p^2 + \dot q^2",
        r"2\dot p^2",
        r"\dot p^2 - \dot p\dot q + \dot q^2",
        r"a\dot p^2",
    ] {
        for beside in ["1", "a", "p^2", r"\dot q^2", "x", "2b"] {
            claims.push(Claim::plain(format!("{beside} + {form} > {beside}"), False));
            claims.push(Claim::plain(format!("{beside} < {form} + {beside}"), False));
            claims.push(Claim::plain(
                format!("{beside} + {form} \\ge {beside}"),
                True,
            ));
        }
        claims.push(Claim::plain(format!("{form} > 0"), True));
        claims.push(Claim::plain(format!("{form} < 0"), False));
    }
    let open = undecided(LETTERS, &claims);
    assert!(10 * open.len() <= claims.len(), "{open:#?}");
}

/// A covariance has the shape of its quantities and is symmetric, or nothing is said of it.
#[test]
fn covariances_of_an_impossible_form() {
    let forms = [
        ("'p'", r"\begin{bmatrix} a & b \\ b & a \end{bmatrix}"),
        (
            "['p', 'q']",
            r"\begin{bmatrix} a & b \\ b & a \end{bmatrix}",
        ),
        (r"'\begin{bmatrix} p \\ q \end{bmatrix}'", "a"),
        (
            r"'\begin{bmatrix} p \\ q \end{bmatrix}'",
            r"\begin{bmatrix} a & 1 \\ 2 & b \end{bmatrix}",
        ),
        (
            r"'\begin{bmatrix} p \\ q \end{bmatrix}'",
            r"\begin{bmatrix} a & b \\ -b & a \end{bmatrix}",
        ),
        (
            r"'\begin{bmatrix} p \\ q \end{bmatrix}'",
            r"\begin{bmatrix} a & 0 & 0 \\ 0 & a & 0 \\ 0 & 0 & a \end{bmatrix}",
        ),
    ];
    for (of, value) in forms {
        let preamble = format!(
            "{LETTERS}```toml notation\n'\\mathbf{{V}}' = {{ covariance_of = {of} }}\n```\n\
             ```math 0 define\n\\mathbf{{V}} = {value}\n```\n"
        );
        let mut claims = Vec::new();
        for moment in ["p^2", "q^2", "pq", "qp", "(p + q)^2"] {
            for value in ["a", "b", "0", "1", "2", "-b", "a + b", "2a + 2b"] {
                for k in 1..=3 {
                    claims.push(Claim::plain(
                        format!("{k}E\\{{{moment}\\}} = {k}({value})"),
                        Open,
                    ));
                }
            }
        }
        undecided(&preamble, &claims);
    }
}

/// Edits of one candidate may change where another one stands.
#[test]
fn edits_that_move_each_other_are_told_by_the_whole() {
    for (one, other, slip) in [
        ("(x + 1)^2", "(x - 1)^2", "(x - 1)^3"),
        ("(x + 2)^2", "(x - 2)^2", "(x - 2)^3"),
        ("(x + y)^2", "(x - y)^2", "(x - y)^3"),
    ] {
        let text = format!(
            "{LETTERS}```math 1 claim\nV = {one} - {slip} = 4x\n```\n\
             ```math 2 claim\nV + V = {one} - {other} - ({one} - {slip})\n```\n"
        );
        let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
        let word = audit.outcomes.last().expect("a link").verdict.word();
        assert!(matches!(
            word,
            VerdictWord::Misprint | VerdictWord::Refuted | VerdictWord::Undecided
        ));
    }
}
