//! Matrices of letters, instances, printed hypotheses and inequalities: the linear multibody system
//! of section 2, damaged in many places, and small documents.

mod common;

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::{DiagnosticKind, Rejection};
use rederive::document::VerdictWord;
use rederive::verdict::{EditClass, Verdict};
use std::collections::BTreeMap;
use std::path::Path;

fn multibody() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/schiehlen-2006/multibody.md");
    std::fs::read_to_string(path).expect("the document")
}

fn audit(text: &str, repair: bool) -> Result<Audit, Rejection> {
    let options = Options {
        repair,
        ..Options::default()
    };
    common::audit(text, options)
}

fn words(audit: &Audit) -> BTreeMap<String, VerdictWord> {
    let label = |o: &rederive::verdict::Outcome| {
        let label = &audit.model.equations[o.equation].label;
        (format!("{label}.{}", o.member), o.verdict.word())
    };
    audit.outcomes.iter().map(label).collect()
}

/// The text with one piece of one equation, or of its settings, replaced.
fn damaged(text: &str, fence: &str, from: &str, to: &str) -> String {
    let start = text.find(&format!("```{fence}")).expect("the fence");
    let end = start + text[start + 3..].find("\n```").expect("its end") + 3;
    let body = &text[start..end];
    assert_eq!(body.matches(from).count(), 1, "{from} in {fence}");
    [&text[..start], &body.replace(from, to), &text[end..]].concat()
}

/// Which equation, what is replaced by what, which links are then false, and the mistake.
const DAMAGES: &[(&str, &str, &str, &[&str], &str)] = &[
    (
        "math 6 ",
        r"\mathbf{D} \dot{\mathbf{y}}",
        r"\mathbf{G} \dot{\mathbf{y}}",
        &["6.1", "6.3"],
        "D and G exchanged",
    ),
    (
        "math 6 ",
        r"\underbrace{\dot{\mathbf{y}}^t \mathbf{G} \dot{\mathbf{y}}}_{0}",
        r"\underbrace{\dot{\mathbf{y}}^t \mathbf{G} \mathbf{y}}_{0}",
        &["6.1", "6.4"],
        "a dot lost over y beside G",
    ),
    ("math 6 ", "_{2R}", "_{R}", &["6.3"], "half the dissipation"),
    (
        "math 6 ",
        "_{2S}",
        "_{-2S}",
        &["6.6"],
        "a sign of the circulatory power",
    ),
    (
        "math 6 ",
        r"\mathbf{M} \ddot{\mathbf{y}}",
        r"\mathbf{M} \dot{\mathbf{y}}",
        &["6.1"],
        "a dot lost over the acceleration",
    ),
    (
        "math 7 ",
        "2R",
        "R",
        &["7.1"],
        "half the dissipation in the balance",
    ),
    ("math 7 ", "+ 2S", "- 2S", &["7.1"], "a sign in the balance"),
    (
        "math 7 ",
        r"\frac{d}{dt} U",
        "U",
        &["7.1"],
        "the potential energy for its rate",
    ),
    (
        "math 6-energies",
        r"T = \frac{1}{2} \dot",
        r"T = \dot",
        &["7.1", "7-gyroscopic.1", "8.1"],
        "one half lost in the kinetic energy",
    ),
    (
        "math 6-energies",
        r"\mathbf{y}^t \mathbf{K} \mathbf{y}",
        r"\dot{\mathbf{y}}^t \mathbf{K} \mathbf{y}",
        &["7.1", "8.1"],
        "a dot too much in the potential energy",
    ),
    (
        "math 4-parts",
        r"\mathbf{P} + \mathbf{P}^T",
        r"\mathbf{P} + \mathbf{P}",
        &["4-split.1", "5.3"],
        "a transposition lost in D",
    ),
    (
        "math 4-parts",
        r"\mathbf{Q} - \mathbf{Q}^T",
        r"\mathbf{Q}^T - \mathbf{Q}",
        &["4-split.2"],
        "the sign of N",
    ),
    (
        "math 5 ",
        r"-\mathbf{G}^t",
        r"\mathbf{G}^t",
        &["5.4"],
        "G symmetric",
    ),
    (
        "math 5 ",
        r"= \mathbf{K}^t",
        r"= -\mathbf{K}^t",
        &["5.5"],
        "K skew",
    ),
    (
        "math 5 ",
        r"\mathbf{N} = -\mathbf{N}^t",
        r"\mathbf{N} = -\mathbf{N}",
        &["5.6"],
        "a transposition lost beside N",
    ),
    (
        "math 5 ",
        "> ",
        "< ",
        &["5.2"],
        "a negative definite inertia",
    ),
    (
        "math 7-gyroscopic",
        "- 2S",
        "",
        &["7-gyroscopic.1"],
        "the circulatory forces forgotten",
    ),
    (
        "math 7-positive",
        "T > 0",
        "U > 0",
        &["7-positive.1"],
        "stiffness of any sign",
    ),
    (
        "math 7-positive",
        "T > 0",
        "T < 0",
        &["7-positive.1"],
        "the other relation",
    ),
    (
        "toml 8",
        r"'\mathbf{D} = \mathbf{0}', ",
        "",
        &["8.1"],
        "damping allowed: not conservative",
    ),
    (
        "toml 8",
        r"'\mathbf{N} = \mathbf{0}', ",
        "",
        &["8.1"],
        "circulatory forces allowed",
    ),
    (
        "toml 8",
        r", '\mathbf{h} = \mathbf{0}'",
        "",
        &["8.1"],
        "excitation allowed",
    ),
    (
        "math 8 ",
        "T + U",
        "T - U",
        &["8.1"],
        "the Lagrangian for the energy",
    ),
    (
        "math 14 ",
        r"\mathbf{K} + \mathbf{N}",
        r"\mathbf{K} - \mathbf{N}",
        &["13.1", "14-eigenvalues.1"],
        "the sign of N in the system matrix",
    ),
    (
        "math 14 ",
        r"-\mathbf{M}^{-1}(\mathbf{D}",
        r"\mathbf{M}^{-1}(\mathbf{D}",
        &["13.1", "14-eigenvalues.1"],
        "the sign of the damping in the system matrix",
    ),
    (
        "math 14-eigenvalues",
        r"\lambda(\mathbf{D}",
        r"(\mathbf{D}",
        &["14-eigenvalues.1"],
        "a lost factor",
    ),
    (
        "math 14-eigenvalues",
        r"{\det\mathbf{M}}",
        r"{2\det\mathbf{M}}",
        &["14-eigenvalues.1"],
        "a factor",
    ),
    (
        "math 10 ",
        r"\mathbf{y}(0) = \mathbf{y}_0, \dot{\mathbf{y}}(0) = \dot{\mathbf{y}}_0",
        r"\mathbf{y}(0) = \dot{\mathbf{y}}_0, \dot{\mathbf{y}}(0) = \mathbf{y}_0",
        &["15-order.1"],
        "initial values exchanged",
    ),
    (
        "math 15-order",
        "= 2f_0",
        "= f_0",
        &["15-order.2"],
        "not of twice the order",
    ),
    (
        "math 11-order",
        "= 2f",
        "= f + 2",
        &["11-order.1"],
        "true for f = 2 alone",
    ),
];

#[test]
fn every_damage_to_the_multibody_system_is_refuted_and_nothing_else() {
    let text = multibody();
    let sound = words(&audit(&text, false).unwrap_or_else(|r| panic!("{r}")));
    for (link, word) in &sound {
        // The labels T and U of (6), which only the search for corrections makes misprints.
        let slip = ["6.2", "6.5"].contains(&link.as_str());
        let refuted = *word == VerdictWord::Refuted;
        assert_eq!(refuted, slip, "({link}) is called {word}");
        assert_ne!(*word, VerdictWord::Undecided, "({link})");
    }
    // The determinants of (14) for f = 3 take the most time; where nothing is expected of them they
    // are left out.
    let start = text.find("```math 14-eigenvalues").expect("the equation");
    let end = start + text[start + 3..].find("\n```\n").expect("its end") + 8;
    let short = [&text[..start], &text[end..]].concat();
    for (fence, from, to, refutes, hunts) in DAMAGES {
        let needed = refutes
            .iter()
            .any(|link| link.starts_with("14-eigenvalues"));
        let text = damaged(if needed { &text } else { &short }, fence, from, to);
        let found = words(&audit(&text, false).unwrap_or_else(|r| panic!("{hunts}: {r}")));
        for link in *refutes {
            let word = found.get(*link);
            assert_eq!(word, Some(&VerdictWord::Refuted), "({link}) {hunts}");
        }
    }
}

#[test]
fn the_labels_of_the_energy_balance_are_mended_by_a_dot() {
    let audit = audit(&multibody(), true).unwrap_or_else(|r| panic!("{r}"));
    let six = audit.model.equation("6").expect("(6)");
    for (member, corrected) in [(2, r"\dot{T}"), (5, r"\dot{U}")] {
        let outcome = audit.outcomes_of(six).find(|o| o.member == member);
        let outcome = outcome.expect("the link");
        let Verdict::Misprint { correction, .. } = &outcome.verdict else {
            panic!("{member}: {}", outcome.verdict.word());
        };
        assert_eq!(correction.edits.len(), 1);
        assert_eq!(correction.edits[0].class, EditClass::Dot);
        assert_eq!(correction.edits[0].corrected, corrected);
        assert_eq!(correction.alternatives.len(), 0);
        assert_eq!(outcome.instances, [0, 1], "for f = 2 and for f = 3");
    }
    // The units say so too, though none is declared of any matrix.
    assert!(!audit.units.is_empty());
    assert!(audit.units.iter().all(|finding| finding.label == "6"));
}

#[test]
fn a_hypothesis_is_named_where_it_is_used() {
    let audit = audit(&multibody(), false).unwrap_or_else(|r| panic!("{r}"));
    for outcome in &audit.outcomes {
        let eight = audit.model.equations[outcome.equation].label == "8";
        assert_eq!(outcome.assumed.len(), if eight { 3 } else { 0 });
    }
}

fn small(symbols: &str, document: &str, fences: &str) -> String {
    format!(
        "```toml document\n{document}\n```\n```toml symbols\nt = {{ meaning = \"time\" }}\n{symbols}\n```\n\
         ```toml notation\n'\\mathbf{{0}}' = {{ zero = true }}\n```\n{fences}\n"
    )
}

fn verdict(symbols: &str, document: &str, fences: &str) -> VerdictWord {
    let text = small(symbols, document, fences);
    let audit = audit(&text, false).unwrap_or_else(|r| panic!("{r}"));
    audit.outcomes.last().expect("a link").verdict.word()
}

fn claim(latex: &str) -> String {
    format!("```math 1 claim\n{latex}\n```")
}

#[test]
fn a_verdict_is_the_worst_of_all_instances() {
    // The determinant of a skew matrix vanishes for odd orders only.
    let skew = "'\\mathbf{S}' = { shape = [\"n\", \"n\"], skew = true }";
    let det = claim(r"\det\mathbf{S} = 0");
    let word = |instances| verdict(skew, instances, &det);
    // One size proves nothing of the others.
    assert_eq!(word("instances = { n = [3] }"), VerdictWord::Undecided);
    assert_eq!(word("instances = { n = [3, 5] }"), VerdictWord::Undecided);
    assert_eq!(word("instances = { n = [2] }"), VerdictWord::Refuted);
    assert_eq!(word("instances = { n = [3, 4, 5] }"), VerdictWord::Refuted);
    let text = small(skew, "instances = { n = [3, 4, 5] }", &det);
    let outcomes = audit(&text, false)
        .unwrap_or_else(|r| panic!("{r}"))
        .outcomes;
    assert_eq!(outcomes[0].instances, [1], "false for n = 4");
}

#[test]
fn products_of_matrices_do_not_commute() {
    let two = "'\\mathbf{A}' = { shape = [2, 2] }\n'\\mathbf{B}' = { shape = [2, 2] }\n\
               '\\mathbf{R}' = { shape = [2, 3] }";
    let word = |latex: &str| verdict(two, "", &claim(latex));
    assert_eq!(
        word(r"\mathbf{A}\mathbf{B} = \mathbf{B}\mathbf{A}"),
        VerdictWord::Refuted
    );
    assert_eq!(
        word(r"(\mathbf{A}\mathbf{B})^T = \mathbf{B}^T\mathbf{A}^T"),
        VerdictWord::Holds
    );
    assert_eq!(
        word(r"(\mathbf{A}\mathbf{R})^T = \mathbf{R}^T\mathbf{A}^T"),
        VerdictWord::Holds
    );
    assert_eq!(
        word(r"\det(\mathbf{A}\mathbf{B}) = \det\mathbf{A}\det\mathbf{B}"),
        VerdictWord::Holds
    );
    // Entries are read by row and column.
    assert_eq!(
        word(r"\mathbf{A}_{12}\mathbf{B}_{21} = \mathbf{B}_{12}\mathbf{A}_{21}"),
        VerdictWord::Refuted
    );
}

#[test]
fn derivatives_of_matrices_follow_the_product_rule() {
    let processes = "'\\mathbf{A}' = { shape = [2, 2], function_of = \"t\" }\n\
                     '\\mathbf{z}' = { shape = [2, 1], function_of = [\"\\\\mathbf{w}\", \"t\"] }\n\
                     '\\mathbf{w}' = { shape = [2, 1], function_of = \"t\" }\n\
                     '\\mathbf{C}' = { shape = [2, 2] }";
    let word = |latex: &str| verdict(processes, "", &claim(latex));
    let rule = r"\frac{d}{dt}(\mathbf{A}\mathbf{z}) = \dot{\mathbf{A}}\mathbf{z} + \mathbf{A}\dot{\mathbf{z}}";
    assert_eq!(word(rule), VerdictWord::Holds);
    assert_eq!(
        word(r"\frac{d}{dt}(\mathbf{A}\mathbf{z}) = \mathbf{A}\dot{\mathbf{z}}"),
        VerdictWord::Refuted
    );
    assert_eq!(
        word(r"\frac{d}{dt}(\mathbf{C}\mathbf{z}(\mathbf{w}, t)) = \mathbf{C}\dot{\mathbf{z}}"),
        VerdictWord::Holds
    );
    assert_eq!(word(r"\dot{\mathbf{C}} = \mathbf{0}"), VerdictWord::Holds);
    assert_eq!(word(r"\det\mathbf{C} = \text{const.}"), VerdictWord::Holds);
    assert_eq!(
        word(r"\det\mathbf{A} = \text{const.}"),
        VerdictWord::Refuted
    );
}

#[test]
fn definiteness_and_stability_are_decided() {
    let letters = "a = { positive = true }\nb = { positive = true }\nc = { }\n\
                   '\\mathbf{M}' = { shape = [2, 2], symmetric = true, positive_definite = true }\n\
                   '\\mathbf{K}' = { shape = [2, 2], symmetric = true }\n\
                   '\\mathbf{G}' = { shape = [2, 2] }\n\
                   '\\lambda' = { function_of = '\\mathbf{F}' }";
    let matrix = |entries: &str| format!(r"\begin{{bmatrix}} {entries} \end{{bmatrix}}");
    let word = |latex: &str| verdict(letters, "", &claim(latex));
    let is = |latex: String, expected| assert_eq!(word(&latex), expected, "{latex}");
    is(
        matrix(r"a + b & -b \\ -b & b") + r" > \mathbf{0}",
        VerdictWord::Holds,
    );
    is(
        matrix(r"a & -b \\ -b & b") + r" > \mathbf{0}",
        VerdictWord::Refuted,
    );
    is(
        matrix(r"a + b & b \\ -b & b") + r" > \mathbf{0}",
        VerdictWord::Undecided,
    );
    is(r"\mathbf{M} > \mathbf{0}".into(), VerdictWord::Holds);
    is(
        r"\frac{a}{b}\mathbf{M} > \mathbf{0}".into(),
        VerdictWord::Holds,
    );
    is(r"\mathbf{0} < \mathbf{M}".into(), VerdictWord::Holds);
    is(r"c\mathbf{M} > \mathbf{0}".into(), VerdictWord::Refuted);
    is(r"\mathbf{K} > \mathbf{0}".into(), VerdictWord::Refuted);
    is(r"\mathbf{G} > \mathbf{0}".into(), VerdictWord::Refuted);
    is(r"a + c^2 > 0".into(), VerdictWord::Holds);
    is(r"a - b > 0".into(), VerdictWord::Refuted);
    is(r"c^2 > 0".into(), VerdictWord::Refuted);
    is(r"c^2 \ge 0".into(), VerdictWord::Holds);
    let stable = |entries| {
        let fences = format!(
            "```math 1 define\n\\mathbf{{F}} = {}\n```\n\
             ```math 2 claim\n\\mathrm{{Re}}\\,\\lambda(\\mathbf{{F}}) < 0\n```",
            matrix(entries)
        );
        verdict(letters, "", &fences)
    };
    for (entries, expected) in [
        (r"0 & 1 \\ -a & -b", VerdictWord::Holds),
        (r"0 & 1 \\ -a & b", VerdictWord::Refuted),
        (r"0 & 1 \\ -a & 0", VerdictWord::Refuted),
        (
            r"0 & 1 & 0 \\ 0 & 0 & 1 \\ -a & -b & -a",
            VerdictWord::Refuted,
        ),
    ] {
        assert_eq!(stable(entries), expected, "{entries}");
    }
}

#[test]
fn hypotheses_reach_what_is_solved_and_differentiated() {
    let letters = "x = { function_of = \"t\" }\nu = { function_of = \"t\" }\nk = { positive = true }\nd = { }";
    let with = |assume: &str| {
        format!(
            "```math 1 solve \\ddot{{x}}\n\\ddot{{x}} + d\\dot{{x}} + kx = u\n```\n\
             ```math 2 claim\n\\dot{{x}}^2 + kx^2 = \\text{{const.}}\n```\n\
             ```toml 2\nassume = [{assume}]\n```"
        )
    };
    let word = |assume: &str| verdict(letters, "", &with(assume));
    assert_eq!(word("\"d = 0\", \"u = 0\""), VerdictWord::Holds);
    assert_eq!(word("\"d = 0\""), VerdictWord::Refuted);
    assert_eq!(word("\"u = d\\\\dot{x}\""), VerdictWord::Holds);
    assert_eq!(word("\"u = -d\\\\dot{x}\""), VerdictWord::Refuted);
    // Of a real number, that its square vanishes says that it does.
    assert_eq!(word("\"d^2 = 0\", \"u^2 = 0\""), VerdictWord::Holds);
}

#[test]
fn sides_of_other_shapes_are_false() {
    let two = "'\\mathbf{A}' = { shape = [2, 2] }\n'\\mathbf{z}' = { shape = [2, 1] }";
    let wrong = claim(r"\mathbf{A}\mathbf{z} = \mathbf{A}");
    let audit = audit(&small(two, "", &wrong), false).unwrap_or_else(|r| panic!("{r}"));
    let Verdict::Refuted(refutation) = &audit.outcomes[0].verdict else {
        panic!("{}", audit.outcomes[0].verdict.word());
    };
    let misfit = refutation.misfit().expect("a misfit");
    assert_eq!((&misfit.left[..], &misfit.right[..]), ("2x1", "2x2"));
}

#[test]
fn too_many_letters_are_refused() {
    let large = "'\\mathbf{A}' = { shape = [64, 64] }";
    let text = small(large, "", &claim("t = t"));
    let rejection = audit(&text, false).expect_err("an error");
    assert!(matches!(
        rejection.diagnostics[0].kind,
        DiagnosticKind::TooManyLetters { .. }
    ));
}
