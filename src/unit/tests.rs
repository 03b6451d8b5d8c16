//! The equations of the quarter car: those that are right give no finding, damage does.

use super::*;
use crate::document::Document;
use crate::latex;
use crate::model::Model;

const QUARTER_CAR: &str = include_str!("../../proofs/schiehlen-2006/quarter-car.md");

fn name(text: &str) -> Name {
    latex::parse_name(text, 0).unwrap()
}

/// What a document's units come to, and where they do not fit.
fn check(text: &str) -> (Units, Vec<UnitFinding>) {
    let shown = |report: Vec<_>| crate::diagnostic::render("test.md", text, &report, false);
    let document = Document::parse("test.md", text).unwrap_or_else(|r| panic!("{}", shown(r)));
    audit(&Model::build(&document).unwrap_or_else(|r| panic!("{}", shown(r))))
}

fn findings(text: &str) -> Vec<UnitFinding> {
    check(text).1
}

/// The quarter car with one piece replaced.
fn replaced(text: &str, from: &str, to: &str) -> String {
    assert_eq!(text.matches(from).count(), 1, "{from}");
    text.replace(from, to)
}

/// The labels of the equations with findings.
fn labels(findings: &[UnitFinding]) -> Vec<&str> {
    let mut labels: Vec<&str> = findings.iter().map(|f| &f.label[..]).collect();
    labels.dedup();
    labels
}

/// The quarter car with the dots of (48) and the indices of (55) as they must be.
fn mended() -> String {
    let text = replaced(
        QUARTER_CAR,
        r"\begin{bmatrix} \ddot{z}_A \\ \ddot{z}_R \\ \ddot{z}_A \\ \ddot{z}_R \end{bmatrix}}_{\dot{\mathbf{x}} =",
        r"\begin{bmatrix} \ddot{z}_A \\ \ddot{z}_R \\ \dddot{z}_A \\ \dddot{z}_R \end{bmatrix}}_{\ddot{\mathbf{x}} =",
    );
    let text = replaced(
        &text,
        r"\begin{bmatrix} \dot{z}_A \\ \dot{z}_R \\ \dot{z}_A \\ \dot{z}_R \end{bmatrix}",
        r"\begin{bmatrix} \dot{z}_A \\ \dot{z}_R \\ \ddot{z}_A \\ \ddot{z}_R \end{bmatrix}",
    );
    let text = replaced(&text, "H_{k,k+1}", "H_{k+1,1}");
    replaced(&text, "_{2m-k}^T", "_{2k-m}^T")
}

#[test]
fn the_mended_quarter_car_fits() {
    let (units, findings) = check(&mended());
    assert_eq!(findings, []);
    for (letter, unit) in [
        ("a", "1/s^2"),
        ("e", "1/s"),
        ("f", "kg m/s^2"),
        (r"\sigma_a", "m/s^2"),
        (r"\sigma_f", "kg m/s^2"),
    ] {
        assert_eq!(
            units.unit_of(&name(letter)).as_deref(),
            Some(unit),
            "{letter}"
        );
    }
    let covariance = units.units_of_matrix(&name(r"\mathbf{P}")).unwrap();
    let shown: Vec<Vec<&str>> = covariance
        .iter()
        .map(|row| row.iter().map(|unit| unit.as_deref().unwrap()).collect())
        .collect();
    let (v, va, a) = ("m^2/s^2", "m^2/s^3", "m^2/s^4");
    assert_eq!(
        shown,
        [
            [v, v, va, va],
            [v, v, va, va],
            [va, va, a, a],
            [va, va, a, a]
        ]
    );
}

#[test]
fn as_printed_the_lost_dots_and_the_indices_do_not_fit() {
    let (units, findings) = check(QUARTER_CAR);
    for finding in &findings {
        println!(
            "({}) {finding} at {}",
            finding.label,
            &QUARTER_CAR[finding.span.start..finding.span.end]
        );
    }
    assert_eq!(labels(&findings), ["48", "55"]);
    let places: Vec<&str> = findings
        .iter()
        .filter(|finding| finding.label == "48")
        .map(|finding| &QUARTER_CAR[finding.span.start..finding.span.end])
        .collect();
    assert!(
        places.contains(&r"\dot{z}_A") || places.contains(&"-a"),
        "{places:?}"
    );
    // The units of the state are found out from (49) and (50), not from the vector as printed.
    assert_eq!(units.unit_of(&name(r"\sigma_a")).as_deref(), Some("m/s^2"));
}

#[test]
fn damage_is_found_where_it_is() {
    let sound = mended();
    for (label, from, to) in [
        (
            "45",
            r"-d_A & d_A \end{bmatrix}",
            r"-d_A & c_A \end{bmatrix}",
        ),
        ("50", r"= m_A \ddot{z}_A + m_R", r"= m_A \dot{z}_A + m_R"),
        ("52", r"m_A^2 \mathbf{P}_{33}", r"m_A \mathbf{P}_{33}"),
        ("56", r"a_3 & a_2 & a_1 & 1 \\", r"a_2 & a_2 & a_1 & 1 \\"),
        ("58", r"+ a_m\mathbf{E}", r"+ a_m^2\mathbf{E}"),
        ("60", r"(d + e)\lambda^3", r"(d + e)\lambda^2"),
        ("61", "ac(c^2de)", "ac(cde)"),
        ("62", "= -ac^2d", "= -acd"),
        ("62", "ac(d + e)", "ac(d + b)"),
        ("63", r"c[d \ d \ a \ a]^T", r"c[d \ d \ a \ d]^T"),
        ("64", "P_{33} = (q/2de)[cd^3", "P_{33} = (q/2de)[cd^2"),
        (
            "65",
            "P_{34} = (q/2de)[cd(d^2 - a)",
            "P_{34} = (q/2de)[cd(d - a)",
        ),
        ("66", "(a - c)^2d", "(a - c)d"),
        ("67", r"\frac{c_R d_A}{m_A^2}", r"\frac{c_R d_A}{m_A^3}"),
        ("68", r"\frac{c_A^2 m_A}{d_A}", r"\frac{c_A^2 m_A}{d_A^2}"),
        (
            "68",
            r"\left(1 + \frac{m_R}{m_A} \right)^2 c_R d_A",
            r"\left(m_R + \frac{m_R}{m_A} \right)^2 c_R d_A",
        ),
    ] {
        let text = replaced(&sound, from, to);
        let found = findings(&text);
        assert_eq!(labels(&found), [label], "{to}: {found:#?}");
    }
}

#[test]
fn signs_and_numbers_are_not_the_business_of_units() {
    let text = replaced(
        &mended(),
        "P_{33} = (q/2de)[cd^3 +",
        "P_{33} = (q/7de)[cd^3 -",
    );
    assert_eq!(findings(&text), []);
}

#[test]
fn a_wrong_unit_in_the_table_is_found() {
    let text = replaced(
        &mended(),
        r#"c_A = { unit = "N/m","#,
        r#"c_A = { unit = "N","#,
    );
    assert!(labels(&findings(&text)).contains(&"45"));
}

#[test]
fn the_matrix_polynomial_has_consistent_unknown_units() {
    let text = include_str!("../../proofs/matrix-polynomial/lyapunov.md");
    assert_eq!(findings(text), []);
}

/// One claim about letters with these units.
fn claim(equation: &str) -> Vec<String> {
    let text = format!(
        "```toml symbols\n\
         x = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\nt = {{ unit = \"s\" }}\nv = {{ unit = \"m/s\" }}\n\
         k = {{ unit = \"1/m\" }}\nn = {{ unit = \"1\" }}\nz = {{ unit = \"m\", function_of = \"t\" }}\n\
         ```\n```math 1 claim\n{equation}\n```\n"
    );
    findings(&text).iter().map(ToString::to_string).collect()
}

#[test]
fn each_construction_has_its_units() {
    for equation in [
        r"x = y + vt",
        r"x = \frac{d}{dt} x \cdot t + \dot{z}(t) t",
        r"x = y \exp(-kx) + y \cos(kx)",
        r"v^2 = \int_0^x \frac{v^2}{y} \, d x",
        r"\sqrt{x^2 + y^2} = y",
        r"(x y)^{1/2} = x",
        r"n^{n} = 1",
        r"\det \begin{bmatrix} x & v \\ y^2 & vy \end{bmatrix} = x y v",
        r"\begin{bmatrix} x & v \\ y^2 & vy \end{bmatrix}^{-1} = \begin{bmatrix} k & k^2 \\ 1/v & k/v \end{bmatrix}",
        r"\sum_{i=1}^{3} x^i y^{3-i} = x^3",
        r"x + 0 = y",
        r"E\{x y\} = x^2",
        r"U = x y = y^2",
        r"|x| \le y",
    ] {
        assert_eq!(claim(equation), [] as [String; 0], "{equation}");
    }
}

#[test]
fn each_construction_is_refused_where_it_does_not_fit() {
    for (equation, finding) in [
        (r"x = y + v", "a term has m/s, its neighbours m"),
        (r"x = y = v t^2", "member 3 has m s, its neighbours m"),
        (r"x = \dot{z}(t)", "member 2 has m/s, its neighbours m"),
        (
            r"x = y \exp(-x)",
            "the argument of a function has m, but must have 1",
        ),
        (
            r"x = y \cos(\frac{k}{t} x)",
            "the argument of a function has 1/s, but must have 1",
        ),
        (
            r"x = z(x)",
            "the argument of a function has m, but must have s",
        ),
        (
            r"x = \int_0^x v \, d t",
            "the argument of a function has m, but must have s",
        ),
        (r"x^{y} = 1", "an exponent has m, but must have 1"),
        (r"\sqrt{x} = y", "member 2 has m, its neighbours m^(1/2)"),
        (
            r"\det \begin{bmatrix} x & v \\ y & y \end{bmatrix} = x y",
            "entry (2,2) of a matrix whose determinant is taken has m, its neighbours m/s",
        ),
        (
            r"\sum_{i=1}^{3} x^i = x^3",
            "a term has m^2, its neighbours m",
        ),
        (r"U = x y = y^3", "member 3 has m^3, its neighbours m^2"),
        (
            r"\begin{bmatrix} x \\ y \end{bmatrix} = \begin{bmatrix} y \\ v \end{bmatrix}",
            "entry (2,1) of member 2 has m/s, its neighbours m",
        ),
        (r"x \le v", "member 2 has m/s, its neighbours m"),
    ] {
        let found = claim(equation);
        assert!(found.contains(&finding.to_owned()), "{equation}: {found:?}");
    }
}

#[test]
fn too_large_an_expression_is_given_up() {
    let sums = r"\sum_{i=1}^{60} \sum_{j=1}^{60} \sum_{l=1}^{60} \sum_{m=1}^{60}";
    assert_eq!(
        claim(&format!("x = {sums} i j l m x")),
        ["an expression too large to check"]
    );
}
