//! Divisors that vanish identically, in the printed letters or once definitions are inserted: what
//! divides by them has no value and nothing of it holds; the rest of the document is as it was. Beside
//! them the same claims with divisors that do not vanish.

use super::dots::{Draw, Tally, verdicts};
use rederive::document::VerdictWord;

const PREAMBLE: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
'P_{34}' = { }
```
```math 1 define
h = x - x, \quad c = b, \quad d = a + b, \quad g = d - a, \quad k = 2x, \quad l = (x + y)^2 - x^2 - y^2
```
```math 2 define
f(x) = \frac{1}{x}
```
";

/// Divisors that are zero, and beside each a similar one that is not, with its value.
const DIVISORS: &[(&str, &str)] = &[
    ("h", "(a + b)"),
    ("(x - x)", "(x^2 + 1)"),
    ("(b - c)", "(b + c)"),
    ("(d - a - b)", "(d - a + b)"),
    ("(g - b)", "(g + b)"),
    ("(k - 2x)", "(k^2 + 1)"),
    ("(l - 2xy)", "(l - 2xy + 1)"),
    ("(b^2 - c^2)", "(b^2 + c^2)"),
    ("(h^2)", "(2a + b)"),
    ("(ah + b - g)", "(ah + b + g)"),
];

#[test]
fn what_divides_by_zero_does_not_hold() {
    let mut draw = Draw::new(77);
    let (mut claims, mut truths) = (Vec::new(), Vec::new());
    let forms: &[(&str, &str, &str)] = &[
        (r"\frac{Z}{Z}", "1", "2"),
        (r"\frac{Nx}{Z}", r"x\frac{N}{Z}", r"x\frac{2N + 1}{Z}"),
        (r"\frac{Z^2}{Z}", "Z", "Z + 1"),
        (r"\frac{1}{Z}", r"\frac{1}{Z}", r"\frac{2}{Z}"),
        (r"a + \frac{N}{Z} - \frac{N}{Z}", "a", "b"),
        (r"Z^{-1}Z", "1", "x"),
        (
            r"\frac{(N)^2 - (Z)^2}{Z}",
            r"\frac{(N)^2}{Z} - Z",
            r"\frac{(N)^2}{Z} + Z",
        ),
        (r"f(x = Z)Z", "1", "3"),
        (r"\frac{0}{Z}", "0", "1"),
    ];
    for _ in 0..240 {
        let (zero, other) = DIVISORS[draw.below(DIVISORS.len())];
        let (left, same, different) = forms[draw.below(forms.len())];
        let vanishes = draw.coin();
        let truth = draw.coin();
        let z = if vanishes { zero } else { other };
        let n = ["a", "(a + b)", "d"][draw.below(3)];
        let right = if truth { same } else { different };
        let claim = format!("{left} = {right}");
        claims.push(claim.replace('Z', z).replace('N', n));
        truths.push((vanishes, truth));
    }
    let mut tally = Tally::default();
    for ((claim, (vanishes, truth)), word) in
        claims.iter().zip(&truths).zip(verdicts(PREAMBLE, &claims))
    {
        match (vanishes, word) {
            (false, word) => tally.count(claim, *truth, word),
            (true, VerdictWord::Undecided) => tally.right += 1,
            (true, word) => tally.wrong.push(format!("{claim} has no value: {word}")),
        }
    }
    assert!(
        tally.wrong.is_empty(),
        "{} of {}: {:#?}",
        tally.wrong.len(),
        tally.all(),
        tally.wrong
    );
    assert_eq!(tally.open, 0, "all are decided");
}

#[test]
fn nothing_without_a_value_has_a_sign() {
    let claims: Vec<String> = [
        "h > 0",
        r"\frac{a}{h} > 0",
        r"\frac{h}{h} > 0",
        r"\frac{a}{b - c} \ge 0",
        r"\frac{b - c}{b - c} > 0",
        r"a + \frac{0}{g - b} > 0",
        r"\frac{b^2 - c^2}{b - c} > 0",
        "h < 0",
        "h \\ne 0",
    ]
    .iter()
    .map(|c| (*c).to_string())
    .collect();
    for (claim, word) in claims.iter().zip(verdicts(PREAMBLE, &claims)) {
        assert!(
            matches!(word, VerdictWord::Undecided | VerdictWord::Refuted),
            "{claim}: {word}"
        );
    }
}

/// A definition without a value spoils what uses it, and nothing else.
#[test]
fn one_bad_place_costs_its_own_links_only() {
    let preamble = format!(
        "{PREAMBLE}```math 3 define\nu = \\frac{{a}}{{x - x}}, \\quad w = u + 1, \\quad z = \\frac{{a}}{{b - c}}\n```\n"
    );
    let claims: Vec<String> = [
        "u = u",
        "w = u + 1",
        "w - u = 1",
        "z = z",
        "zh = 0",
        r"\frac{u}{w} = \frac{u}{w}",
        "0u = 0",
        "a + b = b + a",
        "d = a + b",
        "d = a - b",
        r"\frac{1}{x - x} = 1",
    ]
    .iter()
    .map(|c| (*c).to_string())
    .collect();
    let words = verdicts(&preamble, &claims);
    use VerdictWord::{Holds, Refuted, Undecided};
    let expected = [
        Undecided, Undecided, Undecided, Undecided, Undecided, Undecided, Undecided, Holds, Holds,
        Refuted, Undecided,
    ];
    for ((claim, word), expected) in claims.iter().zip(words).zip(expected) {
        assert_eq!(word, expected, "{claim}");
    }
}

/// What does not exist is shown as if it were zero, and makes nothing true.
#[test]
fn what_does_not_exist_makes_nothing_true() {
    let preamble = r"```toml symbols
a = { positive = true }
b = { }
```
```toml notation
'P_{i,j}' = { entry_of = '\mathbf{P}' }
'a_i' = { characteristic_coefficient_of = '\mathbf{P}' }
'H_{i,j}' = { cofactor_of = '\mathbf{P}' }
```
```math 1 define
\mathbf{P} = \begin{bmatrix} a & b \\ b & a \end{bmatrix}
```
```math 2 define
c_m = m a, \quad m = 0(1)3
```
";
    let mut claims = Vec::new();
    for missing in [
        "P_{3,4}", "P_{0,1}", "P_{3,1}", "H_{0,1}", "H_{3,3}", "c_4", "c_{-1}", "a_{-1}",
    ] {
        for claim in [
            "X = 0",
            "X + a = a",
            "bX = 0",
            "X = X",
            "a - X = a",
            "2X = X",
            "P_{1,1} + X = a",
        ] {
            claims.push(claim.replace('X', missing));
        }
    }
    let wrong: Vec<String> = claims
        .iter()
        .zip(verdicts(preamble, &claims))
        .filter(|(_, word)| !matches!(word, VerdictWord::Undecided | VerdictWord::Refuted))
        .map(|(claim, word)| format!("{claim}: {word}"))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
