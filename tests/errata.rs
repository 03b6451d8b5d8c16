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
    let [effect] = &one.effects[..] else {
        panic!("{one:?}");
    };
    let effect = effect.to_plain();
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
    assert!(!one.mended && one.corrected.is_none() && one.effects.is_empty());
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

#[test]
fn a_link_that_an_earlier_correction_makes_false_is_not_called_false_as_printed() {
    // Once (30.1) has the power of v, the second equality needs it too, which as printed is true.
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/schiehlen-2006/roads.md");
    let audit = Audit::of(
        &Document::read(&path).expect("a document"),
        Options::default(),
    );
    let audit = audit.expect("an audit");
    let sheets = sheets(&[&audit]);
    let of_30 = sheets[0].errata.iter().filter(|e| e.location == "(30)");
    let [one] = &of_30.collect::<Vec<_>>()[..] else {
        panic!("one equation is one entry: {sheets:?}");
    };
    assert_eq!(
        one.corrected.as_deref().expect("a correction"),
        r"\underline{\ddot{\Phi}_{\ddot{\zeta}}(\omega)} = \omega^4 \underline{v^3} \ddot{\Phi}_0 \left(\frac{\Omega_0}{\omega} \right)^4 = \underline{v^3} \ddot{\Phi}_0 \Omega_0^4 = \text{const},",
        "one display has both corrections, and all else is verbatim"
    );
    let why: Vec<String> = one.why.iter().map(|w| w.to_plain()).collect();
    assert!(
        why[1].starts_with("(30.2): true as printed, but (30.1) corrects a side of it; with that"),
        "{why:?}"
    );
    let explained = rederive::report::explain::explain(&audit, "30", 100).expect("an equation");
    assert!(
        explained.matches("False as printed").count() == 1
            && explained.contains("True as printed, but (30.1) corrects a side of it"),
        "{explained}"
    );
}

#[test]
fn words_with_a_formula_are_a_sentence_and_read_as_the_document_says() {
    let text = cantilever(
        "```math 2-text claim\nw(L) = \\frac{F L^2}{3B}\n```\n```toml 2-text\nexpect = \"misprint\"\n\
         quote = 'The deflection at the end is $FL^2/3B$.'\nplace = \"after (1)\"\n\
         reads = 'The deflection at the end is $FL^3/3B$.'\n```\n",
    );
    let sheet = sheet(&text);
    assert!(sheet.errata.is_empty());
    let [one] = &sheet.sentences[..] else {
        panic!("{sheet:?}");
    };
    assert_eq!(one.text.to_plain(), "The deflection at the end is FL^2/3B.");
    let reads = one.reads.as_ref().expect("what it should be").to_plain();
    assert_eq!(reads, "The deflection at the end is FL^3/3B.");
    let shown = markdown(std::slice::from_ref(&sheet));
    assert!(
        shown.contains("one false sentence") && shown.contains("(after (1))"),
        "{shown}"
    );
}

const INSTEAD: &str = "```math 2 claim\nw(L) = \\frac{17F^5 + L}{x^7 B^3 + 13}\n```\n\
    ```toml 2\nexpect = \"refuted\"\ninstead = \"3\"\n```\n```math 3 claim\nw(L) = \\frac{F L^N}{3B}\n```\n";

#[test]
fn what_is_meant_instead_is_what_it_should_read() {
    let sheet = sheet(&cantilever(&INSTEAD.replace('N', "3")));
    let [one] = &sheet.errata[..] else {
        panic!("{sheet:?}");
    };
    assert!(one.mended);
    assert_eq!(one.corrected.as_deref(), Some(r"w(L) = \frac{F L^3}{3B}"));
    assert_eq!(one.corrections[0].to_plain(), "what holds is (3)");
}

#[test]
fn what_is_meant_instead_must_hold_and_exist() {
    let false_one = cantilever(&INSTEAD.replace('N', "2"));
    let document = Document::parse("test.md", &false_one).expect("a document");
    let error = Audit::of(&document, Options::default()).expect_err("(3) is false");
    let words = format!("{:?}", error.diagnostics[0].kind);
    assert!(words.contains("misprint"), "{words}");
    let nowhere = cantilever(&INSTEAD.replace("instead = \"3\"", "instead = \"4\""));
    assert!(Document::parse("test.md", &nowhere).is_err());
}

#[test]
fn one_of_two_equations_is_one_entry() {
    let text = cantilever(
        "```math 2 claim\nw(L) = \\frac{F L^2}{3B}\n```\n```toml 2\nexpect = \"misprint\"\nor = [\"1\"]\n```\n",
    );
    assert_eq!(sheet(&text).errata[0].location, "(2) or (1)");
}

#[test]
fn what_the_paper_does_not_write_is_listed_with_what_needs_it() {
    let text = cantilever(
        "```toml document\nremarks = ['The letter $B$ is not defined.']\n```\n\
         ```math 2-convention claim\nw(0) = 0\n```\n```toml 2-convention\nunwritten = [\"1\"]\n```\n",
    );
    let sheet = sheet(&text);
    let [one] = &sheet.unwritten[..] else {
        panic!("{sheet:?}");
    };
    assert_eq!(one.equations, ["(1)"]);
    assert_eq!(one.relations.to_plain(), "w(0) = 0");
    assert_eq!(sheet.remarks[0].to_plain(), "The letter B is not defined.");
    assert!(latex(&[sheet]).contains("The letter $B$ is not defined."));
}

#[test]
fn sentences_are_sorted_by_how_they_fall_short() {
    let statement = |label: &str, sentence: &str, meaning: &str| {
        format!("```statement {label}\n{sentence}\n```\n```toml {label}\n{meaning}\n```\n")
    };
    let text = cantilever("")
        + &statement(
            "own",
            "It falls with the force.",
            "of = 'w(L)'\npredicate = \"decreasing in\"\nin = \"F\"\nown = true",
        )
        + &statement(
            "false",
            "It rises with the stiffness.",
            "of = 'w(L)'\npredicate = \"increasing in\"\nin = \"B\"",
        )
        + &statement(
            "nearly",
            "It is that of a beam of 1.9 m.",
            "of = 'w(L)/w(L)\\frac{L}{2}'\npredicate = \"close to\"\nto = '1.9/1.9'",
        )
        + &statement(
            "partly",
            "It rises along the beam.",
            "of = 'w(x)'\npredicate = \"increasing in\"\nin = \"x\"",
        )
        + &statement(
            "readings",
            "It is proportional to the length or its cube.",
            "of = ['w(L)', 'w(L)']\npredicate = \"proportional to\"\nto = ['L', 'L^3']\nalternatives = true",
        );
    let sheet = sheet(&text);
    let labels = |group: &[rederive::report::errata::Sentence]| -> Vec<String> {
        group.iter().map(|s| s.label.clone()).collect()
    };
    assert_eq!(labels(&sheet.sentences), ["false"]);
    assert_eq!(labels(&sheet.partly), ["partly"]);
    assert_eq!(labels(&sheet.nearly), ["readings"]);
}

/// One slip in a definition makes two claims false: the sheet mends the definition, once.
#[test]
fn a_slip_in_a_definition_stands_with_the_definition() {
    let text = r"
```toml symbols
a = { value = '1', meaning = 'a number' }
b = { value = '2', meaning = 'a number' }
d = { value = '3', meaning = 'a number' }
```
```math 1 define
\mathbf{M} = \begin{bmatrix} a & 2b \\ b & d \end{bmatrix}
```
```math 2 claim
\det \mathbf{M} = ad - (b + b)(b + b)
```
```math 3 claim
(\det\mathbf{M} - ad)^2 = (b + b)^2(b + b)^2
```
";
    let sheet = sheet(text);
    let [one] = &sheet.errata[..] else {
        panic!("{sheet:?}");
    };
    assert_eq!(one.location, "(1)");
    let corrected = one.corrected.as_deref().expect("a correction");
    assert_eq!(corrected.matches("2").count(), 2, "{corrected}");
    let why: Vec<String> = one.why.iter().map(|why| why.to_plain()).collect();
    assert!(
        why[0].starts_with("(2): ") && why[1].starts_with("(3): "),
        "{why:?}"
    );
    // ad - 2b^2 = -5 instead of ad - 4b^2 = -13.
    let effect = one.effects[0].to_plain();
    assert!(
        effect.starts_with("(2): printed/correct") && effect.contains("-8/13"),
        "{effect}"
    );
}
