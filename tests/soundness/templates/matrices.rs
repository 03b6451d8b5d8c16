//! Matrices of numbers and letters, and linear systems, by Cramer's rule and expansion.

use super::rational::rewrite;
use crate::generated::generator::{Claim, Kind, REALS, Template, Truth, damaged, define};
use crate::generated::random::Random;
use crate::generated::term::{Term, n, v};
use crate::generated::truth::equal;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "matrices/determinant",
        kind: Kind::Rational,
        header: REALS,
        make: determinant,
    },
    Template {
        name: "matrices/product",
        kind: Kind::Rational,
        header: REALS,
        make: product,
    },
    Template {
        name: "matrices/inverse",
        kind: Kind::Rational,
        header: REALS,
        make: inverse,
    },
    Template {
        name: "matrices/trace and transpose",
        kind: Kind::Rational,
        header: REALS,
        make: trace,
    },
    Template {
        name: "matrices/definite",
        kind: Kind::Other,
        header: REALS,
        make: definite,
    },
    Template {
        name: "matrices/eigenvalues",
        kind: Kind::Other,
        header: REALS,
        make: eigenvalues,
    },
    Template {
        name: "matrices/solve",
        kind: Kind::Rational,
        header: REALS,
        make: solve,
    },
    Template {
        name: "matrices/conventions",
        kind: Kind::Other,
        header: REALS,
        make: conventions,
    },
];

type Matrix = Vec<Vec<Term>>;

fn word(holds: bool) -> Truth {
    if holds { Truth::True } else { Truth::False }
}

fn entry(r: &mut Random) -> Term {
    match r.below(6) {
        0 => n(0),
        1 | 2 => n(r.nonzero(-4, 4)),
        3 => n(r.nonzero(-3, 3)) * v(r.pick(&["a", "x", "y"])),
        _ => v(r.pick(&["a", "b", "x", "y", "z"])),
    }
}

fn matrix(r: &mut Random, rows: usize, columns: usize) -> Matrix {
    (0..rows)
        .map(|_| (0..columns).map(|_| entry(r)).collect())
        .collect()
}

fn latex(m: &Matrix) -> String {
    let rows: Vec<String> = m
        .iter()
        .map(|row| row.iter().map(Term::latex).collect::<Vec<_>>().join(" & "))
        .collect();
    format!(
        "\\begin{{bmatrix}} {} \\end{{bmatrix}}",
        rows.join(" \\\\ ")
    )
}

fn det(m: &Matrix) -> Term {
    match m.len() {
        1 => m[0][0].clone(),
        _ => {
            let terms = (0..m.len()).map(|k| {
                let minor: Matrix = m[1..]
                    .iter()
                    .map(|row| {
                        row.iter()
                            .enumerate()
                            .filter(|(c, _)| *c != k)
                            .map(|(_, t)| t.clone())
                            .collect()
                    })
                    .collect();
                let term = m[0][k].clone() * det(&minor);
                if k % 2 == 0 { term } else { -term }
            });
            Term::Sum(terms.collect())
        }
    }
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter()
        .map(|row| {
            (0..b[0].len())
                .map(|c| {
                    Term::Sum(
                        row.iter()
                            .enumerate()
                            .map(|(k, t)| t.clone() * b[k][c].clone())
                            .collect(),
                    )
                })
                .collect()
        })
        .collect()
}

/// Shown with a name of its own or in full.
fn named(r: &mut Random, label: &str, letter: &str, m: &Matrix) -> (String, String) {
    if r.once_in(2) {
        return (latex(m), String::new());
    }
    let name = format!("\\mathbf{{{letter}}}_{{{}}}", label.trim_start_matches('c'));
    let fences = define(
        &format!("{label}{letter}"),
        &format!("{name} = {}", latex(m)),
    );
    (name, fences)
}

fn or_damaged(r: &mut Random, t: &Term) -> Option<(Term, bool)> {
    let other = rewrite(t, r);
    let other = if r.once_in(2) {
        damaged(&other, r)
    } else {
        other
    };
    let holds = equal(t, &other, r)?;
    Some((other, holds))
}

fn determinant(r: &mut Random, label: &str) -> Claim {
    loop {
        let size = 2 + r.below(2);
        let m = matrix(r, size, size);
        let Some((right, holds)) = or_damaged(r, &det(&m)) else {
            continue;
        };
        let (shown, fences) = named(r, label, "A", &m);
        return Claim::of(
            label,
            &format!("\\det {shown} = {}", right.latex()),
            word(holds),
        )
        .after(&fences);
    }
}

fn product(r: &mut Random, label: &str) -> Claim {
    loop {
        let (i, j, k) = (1 + r.below(3), 1 + r.below(3), 2 + r.below(2));
        let (a, b) = (matrix(r, i, j), matrix(r, j, k));
        let mut c = times(&a, &b);
        let mut holds = true;
        if r.once_in(2) {
            let (p, q) = (r.below(i), r.below(k));
            let other = damaged(&c[p][q], r);
            let Some(same) = equal(&c[p][q], &other, r) else {
                continue;
            };
            holds = same;
            c[p][q] = other;
        }
        let text = format!("{}{} = {}", latex(&a), latex(&b), latex(&c));
        return Claim::of(label, &text, word(holds));
    }
}

fn inverse(r: &mut Random, label: &str) -> Claim {
    loop {
        let m = matrix(r, 2, 2);
        let d = det(&m);
        if equal(&d, &n(0), r) != Some(false) {
            continue;
        }
        let holds = r.once_in(2);
        let sign = if holds {
            -m[0][1].clone()
        } else {
            m[0][1].clone()
        };
        if !holds && equal(&m[0][1], &n(0), r) != Some(false) {
            continue;
        }
        let adjoint = vec![
            vec![m[1][1].clone(), sign],
            vec![-m[1][0].clone(), m[0][0].clone()],
        ];
        let (shown, fences) = named(r, label, "B", &m);
        let text = format!(
            "{shown}^{{-1}} = \\frac{{1}}{{{}}}{}",
            d.latex(),
            latex(&adjoint)
        );
        return Claim::of(label, &text, word(holds)).after(&fences);
    }
}

fn trace(r: &mut Random, label: &str) -> Claim {
    let m = matrix(r, 2, 2);
    let b = matrix(r, 2, 2);
    let (m, b) = (latex(&m), latex(&b));
    let (text, truth) = match r.below(6) {
        0 => (
            format!(
                "\\operatorname{{tr}}\\left({m}{b}\\right) = \\operatorname{{tr}}\\left({b}{m}\\right)"
            ),
            Truth::True,
        ),
        1 => (format!("\\left({m}{b}\\right)^T = {b}^T{m}^T"), Truth::True),
        2 => (
            format!("\\det\\left({m}{b}\\right) = \\det {m} \\cdot \\det {b}"),
            Truth::True,
        ),
        3 => (format!("\\det {m} = \\det {m}^T"), Truth::True),
        4 => (
            format!(
                "\\operatorname{{tr}}\\left({m}\\right) = \\operatorname{{tr}}\\left({m}\\right) + 1"
            ),
            Truth::False,
        ),
        _ => (
            format!("\\det\\left(2{m}\\right) = 4\\det {m}"),
            Truth::True,
        ),
    };
    Claim::of(label, &text, truth)
}

fn definite(r: &mut Random, label: &str) -> Claim {
    let k = r.between(1, 4);
    let (m, holds) = match r.below(8) {
        0 => ("a & 0 \\\\ 0 & b".to_string(), true),
        1 => ("a & x \\\\ x & b".to_string(), false),
        2 => (format!("x^2 + {k} & x \\\\ x & 1"), true),
        3 => ("x^2 & x \\\\ x & 1".to_string(), false),
        4 => (format!("a + b & -b \\\\ -b & b + {k}"), true),
        5 => ("a & a \\\\ a & a".to_string(), false),
        6 => (format!("-{k} & 0 \\\\ 0 & a"), false),
        _ => (format!("{} & 1 \\\\ 1 & 1", k + 1), true),
    };
    let number = label.trim_start_matches('c');
    let name = format!("\\mathbf{{M}}_{{{number}}}");
    let fences = define(
        &format!("{label}d"),
        &format!("{name} = \\begin{{bmatrix}} {m} \\end{{bmatrix}}"),
    );
    let header =
        format!("{REALS}```toml notation\n'\\mathbf{{0}}' = {{ zero = true }}\n```\n{fences}");
    Claim::of(label, &format!("{name} > \\mathbf{{0}}"), word(holds)).alone(&header)
}

fn eigenvalues(r: &mut Random, label: &str) -> Claim {
    let (j, k) = (r.between(1, 5), r.between(1, 5));
    let (m, holds) = match r.below(7) {
        0 => (format!("0 & 1 \\\\ -{j}a & -{k}"), true),
        1 => (format!("0 & 1 \\\\ -{j}a & {k}"), false),
        2 => (format!("0 & 1 \\\\ {j} & -{k}a"), false),
        3 => (format!("-a & x \\\\ 0 & -{k}"), true),
        4 => (format!("0 & {j} \\\\ -{k} & 0"), false),
        5 => (format!("-{j} & b \\\\ -b & -{k}"), true),
        _ => ("x & 0 \\\\ 0 & -1".to_string(), false),
    };
    let header = format!(
        "{}```math d define\n\\mathbf{{A}} = \\begin{{bmatrix}} {m} \\end{{bmatrix}}\n```\n",
        REALS.replace(
            "a = {",
            "'\\lambda' = { function_of = '\\mathbf{A}' }\na = {"
        )
    );
    Claim::of(
        label,
        "\\operatorname{Re}\\lambda(\\mathbf{A}) < 0",
        word(holds),
    )
    .alone(&header)
}

fn solve(r: &mut Random, label: &str) -> Claim {
    loop {
        let m = matrix(r, 2, 2);
        let right = [entry(r), entry(r)];
        let d = det(&m);
        if equal(&d, &n(0), r) != Some(false) {
            continue;
        }
        let column = |k: usize| -> Matrix {
            (0..2)
                .map(|row| {
                    (0..2)
                        .map(|c| {
                            if c == k {
                                right[row].clone()
                            } else {
                                m[row][c].clone()
                            }
                        })
                        .collect()
                })
                .collect()
        };
        let which = r.below(2);
        let value = det(&column(which)) / d.clone();
        let Some((shown, holds)) = or_damaged(r, &value) else {
            continue;
        };
        let header = format!(
            "{REALS}```math d solve h, f\n{} \\begin{{bmatrix}} h \\\\ f \\end{{bmatrix}} = {}\n```\n",
            latex(&m),
            latex(&right.iter().map(|t| vec![t.clone()]).collect())
        );
        let name = ["h", "f"][which];
        return Claim::of(label, &format!("{name} = {}", shown.latex()), word(holds))
            .alone(&header);
    }
}

/// Entries, coefficients, minors, cofactors by the conventions of the notation.
fn conventions(r: &mut Random, label: &str) -> Claim {
    loop {
        let m = matrix(r, 3, 3);
        let header = format!(
            "{}```math d define\n\\mathbf{{A}} = {}\n```\n",
            REALS.replace(
                "j = {",
                "'A_{i,k}' = { entry_of = '\\mathbf{A}' }\n'h_i' = { characteristic_coefficient_of = '\\mathbf{A}' }\n\
                 'C_{i,k}' = { cofactor_of = '\\mathbf{A}' }\n'D_i' = { leading_minor_of = '\\mathbf{A}' }\n\
                 '\\mathbf{H}' = { hurwitz_matrix_of = '\\mathbf{A}' }\n'f' = { rows_of = '\\mathbf{A}' }\nj = {"
            ),
            latex(&m)
        );
        let minor = |i: usize, k: usize| -> Matrix {
            let rows = m.iter().enumerate().filter(|(row, _)| *row != i);
            rows.map(|(_, row)| {
                row.iter()
                    .enumerate()
                    .filter(|(c, _)| *c != k)
                    .map(|(_, t)| t.clone())
                    .collect()
            })
            .collect()
        };
        let (i, k) = (r.below(3), r.below(3));
        let trace = Term::Sum((0..3).map(|i| m[i][i].clone()).collect());
        let second = Term::Sum((0..3).map(|i| det(&minor(i, i))).collect());
        let (left, value) = match r.below(7) {
            0 => (format!("A_{{{},{}}}", i + 1, k + 1), m[i][k].clone()),
            1 => ("h_1".into(), -trace),
            2 => ("h_2".into(), second),
            3 => ("h_3".into(), -det(&m)),
            4 => {
                let d = det(&minor(i, k));
                (
                    format!("C_{{{},{}}}", i + 1, k + 1),
                    if (i + k) % 2 == 0 { d } else { -d },
                )
            }
            5 => {
                let size = 1 + r.below(3);
                let leading: Matrix = m[..size].iter().map(|row| row[..size].to_vec()).collect();
                (format!("D_{size}"), det(&leading))
            }
            _ => ("f".into(), n(3)),
        };
        let Some((shown, holds)) = or_damaged(r, &value) else {
            continue;
        };
        return Claim::of(label, &format!("{left} = {}", shown.latex()), word(holds))
            .alone(&header);
    }
}
