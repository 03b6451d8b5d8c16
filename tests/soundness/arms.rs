//! What an evaluator must decide for every kind of value and of printed node, and once decided by default:
//! powers of a matrix that is defined by a power, entries and powers of a zero without a shape, constants of
//! which nothing says in what, roots of matrices measured. Truth is plain by construction; `Open` is what has
//! no value or is not written.

use super::dots::Draw;
use super::unwritten::{Claim, Truth, undecided};
use crate::common::audit;
use Truth::{False, Open, True};
use rederive::check::Options;
use rederive::document::VerdictWord;

/// The integer matrix `[[p, q], [0, r]]` to a power, by multiplication.
fn power([p, q, r]: [i64; 3], n: u32) -> [i64; 3] {
    (1..n).fold([p, q, r], |[a, b, c], _| [a * p, a * q + b * r, c * r])
}

fn printed([p, q, r]: [i64; 3]) -> String {
    format!(r"\begin{{bmatrix}} {p} & {q} \\ 0 & {r} \end{{bmatrix}}")
}

/// A matrix of which only a power is defined: its other powers are powers of that matrix.
#[test]
fn powers_of_a_defined_power_of_a_matrix() {
    let mut draw = Draw::new(71);
    let mut text =
        String::from("```toml symbols\na = { positive = true }\nb = { positive = true }\n```\n");
    let names = ["S", "T", "U", "V", "W", "X"];
    let mut defined = Vec::new();
    for (k, name) in names.iter().enumerate() {
        let mut entry = || 1 + draw.below(3) as i64;
        let matrix = [entry(), entry(), entry() + 3];
        let exponent = 2 + k as u32 % 2;
        text += &format!(
            "```math {} define\n\\mathbf{{{name}}}^{exponent} = {}\n```\n",
            k + 1,
            printed(matrix)
        );
        defined.push((name, matrix, exponent));
    }
    let mut claims = Vec::new();
    for _ in 0..240 {
        let (name, matrix, exponent) = defined[draw.below(defined.len())];
        let n = 1 + draw.below(4) as u32;
        let mut right = power(matrix, n);
        let truth = match draw.below(3) {
            0 => True,
            1 => {
                right[draw.below(3)] += 1;
                False
            }
            // The power that is defined, in place of another one.
            _ => {
                right = matrix;
                if n == 1 { True } else { False }
            }
        };
        let factor = ["", "a", "(a + b)"][draw.below(3)];
        claims.push(Claim::plain(
            format!(
                r"{factor} {} = {factor} \mathbf{{{name}}}^{{{}}}",
                printed(right),
                exponent * n
            ),
            truth,
        ));
    }
    let open = undecided(&text, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

const ZEROS: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
'\mathbf{M}' = { shape = [2, 2] }
```
```toml notation
'\mathbf{0}' = { zero = true }
'\mathbf{E}' = { identity = 2 }
'Z_{i,j}' = { entry_of = '\mathbf{Z}' }
'Y_{i,j}' = { entry_of = '\mathbf{Y}' }
'X_{i,j}' = { entry_of = '\mathbf{X}' }
'H_i' = { leading_minor_of = '\mathbf{Y}' }
'a_i' = { characteristic_coefficient_of = '\mathbf{Y}' }
'r' = { rows_of = '\mathbf{Y}' }
```
```math 1 define
\mathbf{Z} = \mathbf{0}, \quad \mathbf{Y} = \mathbf{M}\mathbf{0}, \quad \mathbf{X} = \mathbf{M} - \mathbf{M}
```
";

/// Which entries a zero without a shape has is not known, and so is none refuted; it has no inverse.
#[test]
fn a_zero_without_a_shape_has_no_entries_and_no_inverse() {
    let mut claims = Vec::new();
    for i in 1..=2 {
        for j in 1..=2 {
            for name in ["Z", "Y"] {
                let entry = format!("{name}_{{{i},{j}}}");
                for factor in ["", "a", "-b", "2"] {
                    for right in ["0", "a", "1"] {
                        claims.push(Claim::plain(format!("{factor} {entry} = {right}"), Open));
                    }
                }
                claims.push(Claim::plain(format!("a + {entry} = a"), Open));
                claims.push(Claim::plain(format!("a = b + {entry}"), Open));
            }
            // A zero with a shape.
            claims.push(Claim::plain(format!("X_{{{i},{j}}} = 0"), True));
            claims.push(Claim::plain(format!("X_{{{i},{j}}} = a"), False));
        }
    }
    for n in 1..=12 {
        for left in [
            format!(r"\mathbf{{0}}^{{-{n}}}"),
            format!(r"\mathbf{{M}}\mathbf{{0}}^{{-{n}}}"),
            format!(r"{n}\mathbf{{M}}\mathbf{{0}}^0"),
            format!(r"\mathbf{{M}}\mathbf{{X}}^{{-{n}}}"),
        ] {
            claims.push(Claim::plain(format!(r"{left} = \mathbf{{0}}"), Open));
            claims.push(Claim::plain(
                format!(r"\mathbf{{M}} + {left} = \mathbf{{M}}"),
                Open,
            ));
        }
        claims.push(Claim::plain(
            format!(r"\mathbf{{M}}\mathbf{{0}}^{{{n}}} = \mathbf{{0}}"),
            True,
        ));
        claims.push(Claim::plain(
            format!(r"{n}\mathbf{{X}}^0 = {n}\mathbf{{E}}"),
            True,
        ));
    }
    for right in ["2", "0", "a"] {
        for left in ["r", "H_1", "H_2", "a_1", "a_2"] {
            claims.push(Claim::plain(format!("{left} = {right}"), Open));
        }
    }
    let open = undecided(ZEROS, &claims);
    assert!(open.is_empty(), "{open:#?}");
}

const FUNCTIONS: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
t = { }
x = { }
y = { }
p = { function_of = 't' }
'\xi' = { }
'\eta' = { }
```
```math 1 define
f(\xi, \eta) = \xi + 2\eta
```
```math 2 define
g(\xi) = \xi^2 + a
```
```math 3 define
c(\xi) = a + b
```
";

/// That a function is constant is said of its letter; where it is not plain of which, it is not said of the
/// time, in which letters do not change.
#[test]
fn constants_are_not_constant_in_the_time_by_default() {
    let mut claims = Vec::new();
    for k in 1..=15 {
        for left in [
            format!("{k}f(x, y)"),
            format!("f({k}x, y)"),
            format!("f(x, {k}x)"),
            format!("g({k}x + y)"),
            format!("g(x) + {k}"),
            format!("{k}(g(x))"),
            format!("a^{{{k}}}g(x)"),
            format!(r"\frac{{g(x)}}{{{k}}}"),
            format!("g(g(x)) - {k}"),
        ] {
            claims.push(Claim::plain(format!(r"{left} = \text{{const.}}"), False));
        }
        for left in [format!("{k}c(x)"), format!("c({k}x)"), format!("g({k})")] {
            claims.push(Claim::plain(format!(r"{left} = \text{{const.}}"), True));
        }
        for (left, truth) in [
            (format!("{k}a + x"), True),
            (format!("{k}p - p - {}p", k - 1), True),
            (format!("{k}p + a"), False),
        ] {
            claims.push(Claim::plain(format!(r"{left} = \text{{const.}}"), truth));
        }
    }
    for left in ["g(x)", "(g(x))", "f(x, y)"] {
        claims.push(Claim::plain(format!(r"{left} = \text{{const.}}"), False));
    }
    for left in ["c(x)", "(c(y))"] {
        claims.push(Claim::plain(format!(r"{left} = \text{{const.}}"), True));
    }
    let open = undecided(FUNCTIONS, &claims);
    // What is not said of one letter is left open; nothing else is.
    assert!(open.len() + 60 <= claims.len(), "{open:#?}");
}

/// The entries of the root of a matrix do not measure what the entries of the matrix do.
#[test]
fn roots_of_matrices_are_not_measured_by_entries() {
    let mut text = String::from(
        r"```toml symbols
a = { positive = true, unit = 'kg' }
b = { positive = true, unit = 'kg' }
c = { positive = true, unit = 'm' }
'\mathbf{M}' = { shape = [2, 2], unit = 'kg' }
```
```math 1 define
\mathbf{S} = \begin{bmatrix} a & b \\ b & 2a \end{bmatrix}
```
",
    );
    let mut holding = Vec::new();
    for (k, matrix) in [r"\mathbf{M}", r"\mathbf{S}"].into_iter().enumerate() {
        for n in 1..=25 {
            for (at, (of, to, holds)) in [
                (
                    format!(r"{n}\operatorname{{tr}}\sqrt{{{matrix}}}"),
                    "a",
                    false,
                ),
                (format!(r"\det({n}\sqrt{{{matrix}}})"), "a^2", false),
                (format!(r"{n}\operatorname{{tr}}{matrix}"), "a", true),
                (format!(r"{n}\sqrt{{\det{matrix}}}"), "b", true),
                (format!(r"{n}\operatorname{{tr}}{matrix}"), "c", false),
            ]
            .into_iter()
            .enumerate()
            {
                let label = format!("s{k}x{n}x{at}");
                text += &format!(
                    "```statement {label}\nWords.\n```\n```toml {label}\nof = ['{of}']\n\
                     predicate = \"measured like\"\nto = '{to}'\n```\n"
                );
                holding.push((of, holds));
            }
        }
    }
    let audit = audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    assert_eq!(audit.statements.len(), holding.len());
    for (statement, (of, holds)) in audit.statements.iter().zip(&holding) {
        let found = statement.word == VerdictWord::Holds;
        assert_eq!(found, *holds, "{of}: {}", statement.word);
    }
}
