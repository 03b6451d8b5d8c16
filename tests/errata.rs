//! The errata sheet: every slip that the verdicts name stands in it once, nothing else does, and its
//! LaTeX compiles.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::Document;
use rederive::report::errata::{Sheet, latex, markdown, sheets};
use std::path::Path;

fn audit(text: &str) -> Audit {
    let document = Document::parse("test.md", text).expect("a document");
    Audit::of(&document, Options::default()).expect("an audit")
}

/// A cantilever under a load at its end: deflection and slope by Euler and Bernoulli.
fn cantilever(claims: &str) -> String {
    format!(
        r"```toml symbols
F = {{ unit = 'N', positive = true, value = '100' }}
L = {{ unit = 'm', positive = true, value = '2' }}
B = {{ unit = 'N m^2', positive = true, value = '5000', meaning = 'bending stiffness' }}
x = {{ unit = 'm', positive = true, value = '1' }}
```

```math 1 define
w(x) = \frac{{F x^2 (3L - x)}}{{6B}}
```

{claims}"
    )
}

fn sheet(text: &str) -> Sheet {
    let audit = audit(text);
    let mut all = sheets(&[&audit]);
    assert_eq!(all.len(), 1);
    all.remove(0)
}

#[test]
fn a_sound_document_gives_an_empty_sheet() {
    let text = cantilever("```math 2 claim\nw(L) = \\frac{F L^3}{3B}\n```\n");
    let sheet = sheet(&text);
    assert!(sheet.is_empty(), "{sheet:?}");
    assert_eq!(markdown(&[sheet]), "Nothing to mend.\n");
}

#[test]
fn a_misprint_stands_with_its_correction_marked_and_its_effect() {
    let text = cantilever("```math 2 claim\nw(L) = \\frac{F L^2}{3B}\n```\n");
    let sheet = sheet(&text);
    let [one] = &sheet.errata[..] else {
        panic!("{sheet:?}");
    };
    assert_eq!(one.location, "(2)");
    assert!(one.printed.contains("\\underline{2}"), "{}", one.printed);
    let corrected = one.corrected.as_deref().expect("a correction");
    assert!(corrected.contains("\\underline{3}"), "{corrected}");
    // printed/correct = 1/L: 1/2 at L = 2, between 1 and 1/3 for L from 1 to 3.
    let effect = one.effect.as_ref().expect("an effect").to_plain();
    for number in ["-1/2", "-2/3", "between", " 0 "] {
        assert!(effect.contains(number), "{effect}");
    }
}

#[test]
fn what_has_no_correction_is_said_to_have_none() {
    let text = cantilever("```math 2 claim\nw(L) = \\frac{17F^5 + L}{x^7 B^3 + 13}\n```\n");
    let sheet = sheet(&text);
    let [one] = &sheet.errata[..] else {
        panic!("{sheet:?}");
    };
    assert!(!one.mended && one.corrected.is_none() && one.effect.is_none());
    assert!(markdown(std::slice::from_ref(&sheet)).contains("no correction was found"));
}

#[test]
fn the_sheet_of_the_paper_names_each_slip_once() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/schiehlen-2006/roads.md");
    let audit = Audit::of(
        &Document::read(&path).expect("a document"),
        Options::default(),
    )
    .expect("an audit");
    // Twice the same document: what stands in both is one slip.
    let once = sheets(&[&audit]);
    let twice = sheets(&[&audit, &audit]);
    assert_eq!(
        markdown(&once).matches("### ").count(),
        once[0].errata.len()
    );
    assert_eq!(once[0].errata.len(), twice[0].errata.len());
    assert_eq!(latex(&once), latex(&sheets(&[&audit])), "deterministic");
    let numbers: Vec<&str> = once[0].errata.iter().map(|e| e.location.as_str()).collect();
    let mut sorted = numbers.clone();
    sorted.sort_by_key(|l| {
        let digits: String = l[1..].chars().take_while(char::is_ascii_digit).collect();
        digits.parse::<u32>().expect("a number")
    });
    assert_eq!(numbers, sorted, "in the order of the numbers");
}

#[test]
fn free_text_cannot_act_in_either_language() {
    let text = cantilever(
        "```math 2 claim\nw(L) = \\frac{F L^2}{3B}\n```\n```toml 2\nexpect = \"misprint\"\nnote = \"<b> \\\\input{x} *a* [b](c) $ & %\"\n```\n",
    );
    let sheet = sheet(&text);
    let shown = markdown(std::slice::from_ref(&sheet));
    assert!(
        shown.contains("\\<b\\>") && shown.contains("\\*a\\*"),
        "{shown}"
    );
    let tex = latex(&[sheet]);
    assert!(!tex.contains("\\input{x}"), "{tex}");
}
