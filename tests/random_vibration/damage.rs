//! Damage done by hand to the documents of section 4: each must be seen, and what is sound before
//! must be what the documents say.

use super::{audit, outcome, word};
use rederive::document::VerdictWord;
use rederive::verdict::{EditClass, Verdict};
use std::path::Path;

fn read(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("proofs/schiehlen-2006")
        .join(name);
    std::fs::read_to_string(path).expect("a document")
}

/// The document with the first occurrence of a piece after a label replaced.
fn damaged(document: &str, label: &str, from: &str, to: &str) -> String {
    let start = document
        .find(&format!("```math {label} "))
        .expect("the equation");
    let at = start + document[start..].find(from).expect("the piece");
    [&document[..at], to, &document[at + from.len()..]].concat()
}

fn class(text: &str, link: &str) -> Option<EditClass> {
    match &outcome(&audit(text), link).verdict {
        Verdict::Misprint { correction, .. } => correction.edits.first().map(|e| e.class),
        Verdict::Refuted(_) => None,
        other => panic!("({link}): {other:?}"),
    }
}

#[test]
fn the_shapes_of_44_are_mended_in_either_reading() {
    let transposes = |edits: &[rederive::verdict::Edit]| {
        let class = |e: &&rederive::verdict::Edit| e.class == EditClass::Transpose;
        edits.iter().filter(class).count()
    };
    // u = H^T v, as (32) writes its output: (38) lacks one transposition.
    let printed = audit(&read("extended-system.md"));
    assert_eq!(word(&printed, "44.1"), VerdictWord::Holds);
    let Verdict::Misprint { correction, .. } = &outcome(&printed, "38.1").verdict else {
        panic!("{:?}", outcome(&printed, "38.1").verdict);
    };
    assert_eq!(transposes(&correction.edits), 1);
    // u = H v: (44) lacks one and has two too many.
    let other = audit(&read("extended-system-transposed.md"));
    assert_eq!(word(&other, "vehicle-38.1"), VerdictWord::Holds);
    let Verdict::Misprint {
        refutation,
        correction,
    } = &outcome(&other, "vehicle-44.1").verdict
    else {
        panic!("{:?}", outcome(&other, "vehicle-44.1").verdict);
    };
    assert!(refutation.misfit().is_some());
    assert_eq!(correction.edits.len(), 3);
    assert_eq!(transposes(&correction.edits), 3);
}

#[test]
fn damage_to_44_is_refuted() {
    let text = read("extended-system.md");
    for (from, to, hunts) in [
        (r"2\mathbf{c}^T", r"\mathbf{c}^T", "a lost factor 2"),
        (r"+ 2\mathbf{c}", r"- 2\mathbf{c}", "a sign"),
        (r"\mathbf{P}_v", r"\mathbf{P}_x", "another covariance"),
        (
            r"\mathbf{P}_{xv} \mathbf{H}",
            r"\mathbf{P}_{xv} \mathbf{H}^T",
            "a transposition too many",
        ),
    ] {
        let damaged = damaged(&text, "44", from, to);
        let found = word(&audit(&damaged), "44.1");
        assert!(
            matches!(found, VerdictWord::Refuted | VerdictWord::Misprint),
            "{hunts}: {found}"
        );
    }
}

#[test]
fn a_spectrum_with_another_factor_or_frequency_is_refuted() {
    let text = read("variance-integral.md");
    let factor = r"\frac{1}{2\pi}(\mathbf{c}";
    for (from, to, expected, hunts) in [
        (
            factor,
            r"\frac{1}{\pi}(\mathbf{c}",
            Some(EditClass::Factor),
            "one-sided for two-sided",
        ),
        (
            factor,
            r"(\mathbf{c}",
            Some(EditClass::Factor),
            "the factor of (39)",
        ),
    ] {
        let damaged = damaged(&text, "40-corrected", from, to);
        assert_eq!(class(&damaged, "41.1"), expected, "{hunts}");
    }
    // The sign of the frequency: the spectrum becomes complex, and its integral another number.
    let spectra = read("spectra.md");
    let sign = damaged(
        &spectra,
        "39",
        r"(-i\omega\mathbf{E} - \mathbf{A})^{-T}",
        r"(i\omega\mathbf{E} - \mathbf{A})^{-T}",
    );
    assert!(matches!(
        word(&audit(&sign), "39.1"),
        VerdictWord::Refuted | VerdictWord::Misprint
    ));
    let half = damaged(
        &text,
        "41",
        r"\int_0^{\infty} \Phi_a",
        r"\int_0^{\infty} S_a",
    );
    assert!(matches!(
        word(&audit(&half), "41.2"),
        VerdictWord::Refuted | VerdictWord::Misprint
    ));
}

#[test]
fn damage_behind_a_shape_filter_is_refuted() {
    let text = read("quarter-car-filter-1.md");
    for (label, from, to, link, hunts) in [
        (
            "filter",
            r"q_w = 2\alpha v",
            r"q_w = \alpha v",
            "road.2",
            "half the intensity",
        ),
        (
            "safety",
            r"2\mathbf{e}^T",
            r"\mathbf{e}^T",
            "safety.2",
            "a lost 2 of the mixed term",
        ),
        (
            "variances",
            r"\zeta - z_R",
            r"\zeta - z_A",
            "safety.3",
            "another letter",
        ),
        (
            "orthogonal",
            r"-\tilde{P}_{1,4}",
            r"\tilde{P}_{1,4}",
            "orthogonal.3",
            "a sign",
        ),
        (
            "eigenvalues",
            r"\lambda + p",
            r"\lambda - p",
            "eigenvalues.1",
            "a pole in the wrong half plane",
        ),
    ] {
        let damaged = damaged(&text, label, from, to);
        let found = word(&audit(&damaged), link);
        // Half the intensity contradicts the stated hypothesis: nothing follows from the two, and it is no
        // pass either.
        let undecided = hunts == "half the intensity" && found == VerdictWord::Undecided;
        assert!(
            undecided || matches!(found, VerdictWord::Refuted | VerdictWord::Misprint),
            "{hunts}: {found}"
        );
    }
}
