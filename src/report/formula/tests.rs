use super::*;
use ratpoly::{Order, Ring};

fn formulas(names: &[&str]) -> (Ring, Formulas) {
    let code: Vec<String> = names
        .iter()
        .map(|n| n.replace('\\', "").replace(['{', '}'], ""))
        .collect();
    let ring = Ring::new(code.clone(), Order::Grevlex).unwrap();
    let formulas = Formulas {
        latex: names.iter().map(|n| n.to_string()).collect(),
        plain: names.iter().map(|n| plain_name(n)).collect(),
        code,
    };
    (ring, formulas)
}

fn write(names: &[&str], text: &str, script: Script) -> String {
    let (ring, formulas) = formulas(names);
    formulas.rational(&RationalFunction::parse(ring, text).unwrap(), script)
}

const ABC: [&str; 5] = ["a", "b", "c", "d", "e"];

#[test]
fn letters_are_juxtaposed_as_in_print() {
    assert_eq!(
        write(&ABC, "a*c^2*d + a*c^2*e", Script::Plain),
        "ac^2(d + e)"
    );
    assert_eq!(
        write(&ABC, "a*c^2*d + a*c^2*e", Script::Latex),
        "ac^2(d + e)"
    );
    assert_eq!(
        write(&ABC, "a*c^2*d + a*c^2*e", Script::Code),
        "a*c^2*(d + e)"
    );
    assert_eq!(
        write(&["m_A", "m_R"], "2*m_A*m_R", Script::Plain),
        "2 m_A m_R"
    );
    assert_eq!(
        write(&["\\alpha", "b"], "alpha*b", Script::Latex),
        "\\alpha b"
    );
}

#[test]
fn signs_zeros_and_constants() {
    assert_eq!(write(&ABC, "0", Script::Plain), "0");
    assert_eq!(write(&ABC, "-1", Script::Plain), "-1");
    assert_eq!(write(&ABC, "-a", Script::Latex), "-a");
    assert_eq!(write(&ABC, "b - a", Script::Plain), "-a + b");
    assert_eq!(write(&ABC, "1/2", Script::Latex), "\\frac{1}{2}");
    assert_eq!(write(&ABC, "-7/3", Script::Plain), "-7/3");
}

#[test]
fn quotients_have_the_brackets_that_they_need() {
    assert_eq!(write(&ABC, "a/(2*d)", Script::Plain), "a/(2d)");
    assert_eq!(
        write(&ABC, "(a + b)/(d + e)", Script::Plain),
        "(a + b)/(d + e)"
    );
    assert_eq!(
        write(&ABC, "(a + b)/(d + e)", Script::Code),
        "(a + b)/(d + e)"
    );
    assert_eq!(
        write(&ABC, "(a + b)/(d + e)", Script::Latex),
        "\\frac{a + b}{d + e}"
    );
    assert_eq!(write(&ABC, "a/d", Script::Plain), "a/d");
}

#[test]
fn a_relation_has_its_negative_terms_on_the_right() {
    let (ring, formulas) = formulas(&ABC);
    let p = Polynomial::parse(ring, "2*a*e - 2*b*d").unwrap();
    assert_eq!(formulas.relation(&p, Script::Plain), "bd = ae");
    let p = Polynomial::parse(ring, "a - 1").unwrap();
    assert_eq!(formulas.relation(&p, Script::Plain), "a = 1");
    let p = Polynomial::parse(ring, "a + b").unwrap();
    assert_eq!(formulas.relation(&p, Script::Plain), "a + b = 0");
}

#[test]
fn what_is_written_for_programs_reads_back() {
    let (ring, formulas) = formulas(&ABC);
    for text in [
        "0",
        "-3*a*b",
        "(a^2 - b^2)/(2*c*d)",
        "(-a - b)/(c - d)",
        "-a/(b + c)",
        "1/(2*a*b^2*c - 2*a*b)",
    ] {
        let f = RationalFunction::parse(ring, text).unwrap();
        let written = formulas.rational(&f, Script::Code);
        assert_eq!(
            RationalFunction::parse(ring, &written).unwrap(),
            f,
            "{written}"
        );
    }
}

#[test]
fn a_long_sum_is_broken_between_its_terms() {
    let (ring, formulas) = formulas(&ABC);
    let p = Polynomial::parse(ring, "(a + b + c + d + e + 1)^3 + 7*a*b").unwrap();
    let text = formulas.display("P", &RationalFunction::from(p));
    assert!(text.starts_with("\\begin{aligned}"), "{text}");
    for line in text.lines() {
        assert!(width(line) <= LINE + 25, "{line}");
    }
}
