//! The floating-point evaluator on expressions built by hand, with a small table of meanings in
//! place of a document.

use approx::assert_relative_eq;
use nalgebra::DMatrix;
use rederive::expr::{
    Bracket, Expr, ExprKind, Font, Function, Name, QuotientStyle, Sign, Subscript,
};
use rederive::numeric::evaluate::Evaluator;
use rederive::numeric::resolver::{Element, Meaning, Reference, Resolver, System};
use rederive::numeric::value::{Failure, FailureKind, Value};
use rederive::numeric::{LyapunovMethod, NumericError};
use rederive::span::Span;
use std::collections::BTreeMap;

// Expressions, as short as the language allows. A letter beginning with `!` is bold.

fn e(kind: ExprKind) -> Expr {
    Expr::new(kind, Span::default())
}

fn name(base: &str) -> Name {
    let mut name = Name::italic(base.trim_start_matches('!'));
    if base.starts_with('!') {
        name.letter.font = Font::Bold;
    }
    name
}

fn n(base: &str) -> Expr {
    e(ExprKind::Name(name(base)))
}

fn indexed(base: &str, indices: Vec<Expr>) -> Expr {
    let mut name = name(base);
    name.subscript = Some(Subscript {
        label: format!("{indices:?}"),
        indices,
    });
    e(ExprKind::Name(name))
}

fn number(value: i64) -> Expr {
    e(ExprKind::Number(num_rational::BigRational::from_integer(
        value.into(),
    )))
}

fn times<const N: usize>(factors: [Expr; N]) -> Expr {
    e(ExprKind::Product(factors.to_vec()))
}

fn plus<const N: usize>(terms: [Expr; N]) -> Expr {
    e(ExprKind::Sum(terms.map(|term| (Sign::Plus, term)).to_vec()))
}

fn minus(left: Expr, right: Expr) -> Expr {
    e(ExprKind::Sum(vec![
        (Sign::Plus, left),
        (Sign::Minus, right),
    ]))
}

fn over(numerator: Expr, denominator: Expr) -> Expr {
    e(ExprKind::Quotient {
        numerator: Box::new(numerator),
        denominator: Box::new(denominator),
        style: QuotientStyle::Bar,
    })
}

fn power(base: Expr, exponent: Expr) -> Expr {
    e(ExprKind::Power {
        base: Box::new(base),
        exponent: Box::new(exponent),
    })
}

fn transposed(inner: Expr) -> Expr {
    e(ExprKind::Transpose(Box::new(inner)))
}

fn group(inner: Expr) -> Expr {
    e(ExprKind::Group {
        bracket: Bracket::Round,
        inner: Box::new(inner),
    })
}

fn call(function: Function, argument: Expr) -> Expr {
    e(ExprKind::Call {
        function,
        argument: Box::new(argument),
    })
}

fn matrix<const N: usize>(rows: [&[i64]; N]) -> Expr {
    let row = |row: &[i64]| row.iter().map(|v| number(*v)).collect();
    e(ExprKind::Matrix {
        rows: rows.map(row).to_vec(),
        bracket: Bracket::Square,
    })
}

fn sum_over(index: &str, from: Expr, to: Expr, body: Expr) -> Expr {
    e(ExprKind::BigSum {
        index: name(index),
        from: Box::new(from),
        to: Box::new(to),
        body: Box::new(body),
    })
}

/// What a name of the table means.
enum Entry {
    Number(Option<f64>),
    Means(Expr),
    /// Members of a family: the canonical index and the expression in it.
    Family(&'static str, Expr),
    Power(u32, Expr),
    Unknown(usize, usize),
    Identity(usize),
    Zero,
    Coefficient(Expr),
    Cofactor(Expr),
    Minor(Expr),
    Hurwitz(Expr),
    Process,
}

#[derive(Default)]
struct Table {
    entries: Vec<Entry>,
    names: BTreeMap<String, usize>,
    systems: Vec<(Expr, Expr, bool)>,
}

impl Table {
    fn with(mut self, key: &str, entry: Entry) -> Self {
        self.names.insert(key.into(), self.entries.len());
        self.entries.push(entry);
        self
    }

    /// A system for one unknown; bold unknowns may be matrices.
    fn solve(mut self, unknown: &str, left: Expr, right: Expr) -> Self {
        let system = self.systems.len();
        self.systems.push((left, right, unknown.starts_with('!')));
        self.with(unknown, Entry::Unknown(system, 0))
    }
}

impl Resolver for Table {
    type Node = usize;

    fn canonical(&self, name: &Name) -> String {
        let bold = if name.letter.font == Font::Bold {
            "!"
        } else {
            ""
        };
        format!("{bold}{}", name.letter.base)
    }

    fn resolve<'n>(&'n self, name: &'n Name, bound: &dyn Fn(&str) -> bool) -> Reference<'n, usize> {
        let key = self.canonical(name);
        if bound(&key) {
            return Reference::Bound(key);
        }
        match (self.names.get(&key), &name.subscript) {
            (None, _) => Reference::Undeclared,
            (Some(node), _) if matches!(self.entries[*node], Entry::Process) => {
                Reference::WithoutValue
            }
            (Some(node), None) => Reference::Node(*node),
            (Some(_), Some(subscript)) => Reference::Indexed {
                family: key,
                indices: subscript.indices.iter().collect(),
            },
        }
    }

    fn elements(&self, family: &str, indices: &[i64]) -> Vec<Element<usize>> {
        let of = |node: &usize| match self.entries[*node] {
            Entry::Family(..) | Entry::Coefficient(_) | Entry::Cofactor(_) | Entry::Minor(_) => {
                Element::Member(*node, indices.to_vec())
            }
            _ => Element::Entry(*node, indices.to_vec()),
        };
        // A second family of the same letter.
        let second = format!("{family}'");
        [family, second.as_str()]
            .iter()
            .filter_map(|name| self.names.get(*name).map(of))
            .collect()
    }

    fn power(&self, base: &Name, exponent: u32) -> Option<(usize, u32)> {
        let node = *self.names.get(&self.canonical(base))?;
        match &self.entries[node] {
            Entry::Power(n, _) if exponent.is_multiple_of(*n) => Some((node, exponent / n)),
            _ => None,
        }
    }

    fn is_plain_application(&self, _: &Name, arguments: &[Expr]) -> bool {
        arguments == [n("t")]
    }

    fn meaning(&self, node: usize, indices: &[i64]) -> Option<Meaning<'_>> {
        Some(match self.entries.get(node)? {
            Entry::Number(value) => Meaning::Number(*value),
            Entry::Means(expr) | Entry::Power(_, expr) => Meaning::Expression {
                expr,
                bound: Vec::new(),
            },
            Entry::Family(index, expr) => Meaning::Expression {
                expr,
                bound: vec![(index.to_string(), *indices.first()?)],
            },
            Entry::Unknown(system, position) => Meaning::Unknown {
                system: *system,
                position: *position,
            },
            Entry::Identity(n) => Meaning::Identity(*n),
            Entry::Zero => Meaning::Zero,
            Entry::Coefficient(of) => Meaning::CharacteristicCoefficient(of),
            Entry::Cofactor(of) => Meaning::Cofactor(of),
            Entry::Minor(of) => Meaning::LeadingMinor(of),
            Entry::Hurwitz(of) => Meaning::HurwitzMatrix(of),
            Entry::Process => return None,
        })
    }

    fn system(&self, system: usize) -> Option<System<'_>> {
        let (left, right, bold) = self.systems.get(system)?;
        Some(System {
            equations: vec![(left, right)],
            matrices: vec![*bold],
        })
    }
}

fn scalar(table: &Table, expr: &Expr) -> f64 {
    match Evaluator::new(table, LyapunovMethod::BartelsStewart).value(expr) {
        Ok(Value::Scalar(s)) => s,
        other => panic!("no scalar: {other:?}"),
    }
}

fn failure(table: &Table, expr: &Expr) -> FailureKind {
    let result = Evaluator::new(table, LyapunovMethod::BartelsStewart).value(expr);
    result.expect_err("has a value").kind
}

/// The auxiliary system of the tests: `det(lambda E - A) = lambda^3 + 2 lambda^2 + 3 lambda + 4`.
fn companion() -> Table {
    Table::default()
        .with("q", Entry::Number(Some(0.5)))
        .with("!E", Entry::Identity(3))
        .with("!0", Entry::Zero)
        .with(
            "!A",
            Entry::Means(matrix([&[0, 1, 0], &[0, 0, 1], &[-4, -3, -2]])),
        )
        .with("!B", Entry::Means(matrix([&[0], &[0], &[2]])))
        .with("a", Entry::Coefficient(n("!A")))
        .with("!H", Entry::Hurwitz(n("!A")))
        .with("H", Entry::Cofactor(n("!H")))
        .with("D", Entry::Minor(n("!H")))
}

/// `A X + X A^T + B q B^T`
fn lyapunov() -> Expr {
    plus([
        times([n("!A"), n("!X")]),
        times([n("!X"), transposed(n("!A"))]),
        times([n("!B"), n("q"), transposed(n("!B"))]),
    ])
}

#[test]
fn arithmetic_functions_and_powers() {
    let table = Table::default()
        .with("x", Entry::Number(Some(3.0)))
        .with("s", Entry::Power(2, times([n("x"), n("x"), n("x")])));
    assert_eq!(
        scalar(&table, &minus(over(n("x"), number(2)), number(1))),
        0.5
    );
    assert_eq!(scalar(&table, &power(n("x"), number(-2))), 1.0 / 9.0);
    assert_eq!(scalar(&table, &power(n("x"), number(0))), 1.0);
    // s^2 is defined as x^3 = 27; s^4 is its square.
    assert_eq!(scalar(&table, &power(n("s"), number(2))), 27.0);
    assert_eq!(scalar(&table, &power(n("s"), number(4))), 729.0);
    assert_eq!(
        scalar(&table, &power(number(4), over(number(1), number(2)))),
        2.0
    );
    assert_eq!(scalar(&table, &call(Function::SquareRoot, number(9))), 3.0);
    assert_eq!(scalar(&table, &call(Function::Exponential, number(0))), 1.0);
    assert_eq!(
        scalar(&table, &call(Function::Absolute, minus(number(1), n("x")))),
        2.0
    );
    // sum_{k=1}^{4} k^2 = 30, an empty sum is zero
    let squares = |to| sum_over("k", number(1), number(to), power(n("k"), number(2)));
    assert_eq!(scalar(&table, &squares(4)), 30.0);
    assert_eq!(scalar(&table, &squares(0)), 0.0);
}

#[test]
fn notation_of_the_hurwitz_theory() {
    let table = companion();
    for (i, expected) in [1.0, 2.0, 3.0, 4.0, 0.0].into_iter().enumerate() {
        assert_eq!(
            scalar(&table, &indexed("a", vec![number(i as i64)])),
            expected
        );
    }
    // H = [2 1 0; 4 3 2; 0 0 4]: minors 2, 2, 8
    for (k, expected) in [(1, 2.0), (2, 2.0), (3, 8.0)] {
        assert_relative_eq!(scalar(&table, &indexed("D", vec![number(k)])), expected);
    }
    assert_relative_eq!(scalar(&table, &call(Function::Determinant, n("!H"))), 8.0);
    // cofactor of the entry in row 2, column 1: -det[1 0; 0 4]
    assert_relative_eq!(
        scalar(&table, &indexed("H", vec![number(2), number(1)])),
        -4.0
    );
    assert_eq!(scalar(&table, &call(Function::Trace, n("!A"))), -2.0);
    let outside = indexed("H", vec![number(4), number(1)]);
    assert_eq!(
        failure(&table, &outside),
        FailureKind::Outside {
            indices: vec![4, 1]
        }
    );
    let outside = indexed("a", vec![number(-1)]);
    assert_eq!(
        failure(&table, &outside),
        FailureKind::Outside { indices: vec![-1] }
    );
}

/// The characteristic polynomial of `A`, taken at `A`, is zero (Cayley and Hamilton), and so is the
/// third auxiliary matrix.
#[test]
fn sums_and_families_with_running_indices() {
    let coefficient = || indexed("a", vec![n("k")]);
    let polynomial = sum_over(
        "k",
        number(0),
        number(3),
        times([coefficient(), power(n("!A"), minus(number(3), n("k")))]),
    );
    // A_m = sum_{k=0}^{m} a_k A^(m-k)
    let auxiliary = sum_over(
        "k",
        number(0),
        n("m"),
        times([coefficient(), power(n("!A"), minus(n("m"), n("k")))]),
    );
    let table = companion().with("!M", Entry::Family("m", auxiliary));
    for expr in [polynomial, indexed("!M", vec![number(3)])] {
        match Evaluator::new(&table, LyapunovMethod::Smith).value(&expr) {
            Ok(Value::Matrix(m)) => assert_eq!(m, DMatrix::zeros(3, 3)),
            other => panic!("{other:?}"),
        }
    }
}

/// `A_m = A A_{m-1}` without a start never ends.
#[test]
fn a_recursion_without_a_start_is_cut_off() {
    let before = indexed("!M", vec![minus(n("m"), number(1))]);
    let recursion = times([n("!A"), before]);
    let table = companion().with("!M", Entry::Family("m", recursion));
    let member = indexed("!M", vec![number(2)]);
    assert_eq!(failure(&table, &member), FailureKind::Budget);
    let nested = (0..100_000).fold(n("q"), |inner, _| group(inner));
    assert_eq!(failure(&table, &nested), FailureKind::Budget);
    // Dropping so deep a tree would itself overflow the stack; a parser never builds one.
    std::mem::forget(nested);
}

#[test]
fn of_two_readings_of_an_index_the_one_that_exists_is_taken() {
    let table = companion()
        .with("S", Entry::Minor(n("!H")))
        .with("S'", Entry::Cofactor(n("!H")));
    let one = indexed("S", vec![number(3)]);
    assert_relative_eq!(scalar(&table, &one), 8.0);
    let two = indexed("S", vec![number(2), number(1)]);
    let ambiguous = FailureKind::Unsupported("an index with two readings");
    assert_eq!(failure(&table, &two), ambiguous);
    let none = indexed("S", vec![number(7)]);
    assert_eq!(
        failure(&table, &none),
        FailureKind::Outside { indices: vec![7] }
    );
}

#[test]
fn every_method_solves_the_printed_lyapunov_equation() {
    let table = companion().solve("!X", lyapunov(), n("!0"));
    let mut solutions = Vec::new();
    for method in LyapunovMethod::ALL {
        let mut evaluator = Evaluator::new(&table, method);
        let value = evaluator.value(&n("!X")).unwrap();
        assert_eq!(evaluator.solved(0).map(|s| s.method), Some(method));
        let residual = evaluator.value(&lyapunov()).unwrap();
        match (value, residual) {
            (Value::Matrix(x), Value::Matrix(r)) => {
                assert!(r.amax() < 1e-14 * x.amax().max(1.0));
                solutions.push(x);
            }
            other => panic!("{other:?}"),
        }
        // an entry of the unknown
        let entry = evaluator
            .value(&indexed("!X", vec![number(3), number(3)]))
            .unwrap();
        assert_eq!(entry, Value::Scalar(solutions.last().unwrap()[(2, 2)]));
    }
    for other in &solutions[1..] {
        assert_relative_eq!(solutions[0], *other, max_relative = 1e-12, epsilon = 1e-14);
    }
}

#[test]
fn the_form_is_recognised_however_it_is_written() {
    let signs = e(ExprKind::Sum(vec![(
        Sign::Minus,
        group(plus([
            times([n("!A"), n("!X")]),
            times([n("!B"), transposed(n("!B"))]),
        ])),
    )]));
    for (left, right) in [
        (signs, times([n("!X"), transposed(n("!A"))])),
        (n("!0"), lyapunov()),
        (
            plus([
                times([number(2), n("!A"), n("!X")]),
                times([n("!X"), transposed(group(times([number(2), n("!A")])))]),
            ]),
            e(ExprKind::Sum(vec![(Sign::Minus, n("!E"))])),
        ),
    ] {
        let table = companion().solve("!X", left.clone(), right.clone());
        let mut evaluator = Evaluator::new(&table, LyapunovMethod::Smith);
        evaluator.value(&n("!X")).unwrap();
        assert_eq!(
            evaluator.solved(0).map(|s| s.method),
            Some(LyapunovMethod::Smith)
        );
        let residual = evaluator.value(&minus(left, right)).unwrap();
        assert!(residual.into_matrix((3, 3)).amax() < 1e-13);
    }
}

#[test]
fn other_linear_equations_go_other_ways() {
    let sylvester = plus([
        times([n("!A"), n("!X")]),
        times([n("!X"), group(minus(n("!A"), n("!E")))]),
        n("!E"),
    ]);
    let stein = plus([
        minus(n("!X"), times([n("!A"), n("!X"), transposed(n("!A"))])),
        n("!E"),
    ]);
    let three_terms = plus([lyapunov(), n("!X")]);
    let column = minus(times([n("!A"), n("!X")]), n("!B"));
    for (left, asked, used) in [
        (
            sylvester.clone(),
            LyapunovMethod::BartelsStewart,
            LyapunovMethod::BartelsStewart,
        ),
        (sylvester, LyapunovMethod::Smith, LyapunovMethod::Kronecker),
        (
            stein,
            LyapunovMethod::BartelsStewart,
            LyapunovMethod::Kronecker,
        ),
        (
            three_terms,
            LyapunovMethod::BartelsStewart,
            LyapunovMethod::Kronecker,
        ),
        (
            column,
            LyapunovMethod::BartelsStewart,
            LyapunovMethod::Kronecker,
        ),
    ] {
        let table = companion().solve("!X", left.clone(), n("!0"));
        let mut evaluator = Evaluator::new(&table, asked);
        let solution = evaluator.value(&n("!X")).unwrap();
        assert_eq!(evaluator.solved(0).map(|s| s.method), Some(used));
        let residual = evaluator.value(&left).unwrap();
        let size = solution.into_matrix((3, 3)).amax();
        assert!(residual.into_matrix((3, 3)).amax() < 1e-13 * size.max(1.0));
    }
}

/// Hunts a recogniser that takes `X A` for `X A^T`, or drops a sign.
#[test]
fn a_misprinted_lyapunov_equation_is_solved_as_printed() {
    let misprinted = plus([
        times([n("!A"), n("!X")]),
        times([n("!X"), n("!A")]),
        n("!E"),
    ]);
    let table = companion().solve("!X", misprinted.clone(), n("!0"));
    for method in LyapunovMethod::ALL {
        let mut evaluator = Evaluator::new(&table, method);
        evaluator.value(&n("!X")).unwrap();
        let residual = evaluator.value(&misprinted).unwrap();
        assert!(residual.into_matrix((3, 3)).amax() < 1e-13);
    }
}

#[test]
fn unknowns_may_need_the_solution_of_another_system() {
    // X from the Lyapunov equation, then 2 y = tr X
    let table = companion().solve("!X", lyapunov(), n("!0")).solve(
        "y",
        times([number(2), n("y")]),
        call(Function::Trace, n("!X")),
    );
    let trace = scalar(&table, &call(Function::Trace, n("!X")));
    assert_relative_eq!(scalar(&table, &n("y")), trace / 2.0, max_relative = 1e-15);
    // Two systems in a circle
    let circle = Table::default()
        .solve("x", n("x"), n("y"))
        .solve("y", n("y"), n("x"));
    assert_eq!(failure(&circle, &n("x")), FailureKind::Cyclic);
}

#[test]
fn equations_that_determine_nothing() {
    let numeric = |error| FailureKind::Numeric(error);
    let square = times([n("x"), n("x")]);
    for (left, right, expected) in [
        (square, number(2), numeric(NumericError::NotLinear)),
        (n("x"), n("x"), numeric(NumericError::Singular)),
        (
            times([number(0), n("x")]),
            number(1),
            numeric(NumericError::Singular),
        ),
        (
            over(number(1), n("x")),
            number(1),
            FailureKind::DivisionByZero,
        ),
    ] {
        let table = Table::default().solve("x", left, right);
        assert_eq!(failure(&table, &n("x")), expected);
    }
    // diag(1, -1): eigenvalues with the sum zero
    let both = matrix([&[1, 0], &[0, -1]]);
    let equation = plus([
        times([both.clone(), n("!X")]),
        times([n("!X"), both.clone()]),
        both,
    ]);
    let table = Table::default().solve("!X", equation, number(0));
    assert_eq!(failure(&table, &n("!X")), numeric(NumericError::Singular));
}

#[test]
fn blocks_take_the_shape_of_their_neighbours() {
    let table = companion();
    let blocks = e(ExprKind::Matrix {
        rows: vec![vec![n("!A"), n("!B")], vec![n("!0"), number(7)]],
        bracket: Bracket::Square,
    });
    let value = Evaluator::new(&table, LyapunovMethod::Kronecker)
        .value(&blocks)
        .unwrap();
    let matrix = value.into_matrix((0, 0));
    assert_eq!(matrix.shape(), (4, 4));
    assert_eq!(
        (matrix[(2, 3)], matrix[(3, 3)], matrix[(3, 0)]),
        (2.0, 7.0, 0.0)
    );
}

#[test]
fn what_has_no_value_says_why() {
    let table = companion()
        .with("u", Entry::Number(None))
        .with("z", Entry::Process)
        .with("c", Entry::Means(plus([n("c"), number(1)])));
    let shape = |kind: FailureKind| matches!(kind, FailureKind::Shape { .. });
    assert!(shape(failure(&table, &plus([n("!A"), n("!B")]))));
    assert!(shape(failure(&table, &plus([n("!A"), number(1)]))));
    assert!(shape(failure(&table, &times([n("!B"), n("!A")]))));
    assert!(shape(failure(
        &table,
        &call(Function::Determinant, n("!B"))
    )));
    assert!(shape(failure(&table, &power(n("!B"), number(2)))));
    assert!(shape(failure(&table, &over(number(1), n("!A")))));
    assert_eq!(
        failure(&table, &over(number(1), number(0))),
        FailureKind::DivisionByZero
    );
    assert_eq!(
        failure(&table, &power(number(0), number(-1))),
        FailureKind::DivisionByZero
    );
    assert_eq!(
        failure(&table, &power(n("q"), number(1_000_000_000))),
        FailureKind::Exponent
    );
    assert_eq!(failure(&table, &n("c")), FailureKind::Cyclic);
    assert_eq!(
        failure(&table, &n("w")),
        FailureKind::Undeclared { name: "w".into() }
    );
    assert_eq!(
        failure(&table, &n("u")),
        FailureKind::WithoutValue { name: "u".into() }
    );
    assert_eq!(
        failure(&table, &n("z")),
        FailureKind::WithoutValue { name: "z".into() }
    );
    let long = sum_over("k", number(0), number(1_000_000), n("k"));
    assert_eq!(failure(&table, &long), FailureKind::Budget);
    let huge = power(number(10), number(400));
    assert_eq!(
        failure(&table, &huge),
        FailureKind::Numeric(NumericError::NotFinite)
    );
    let log = call(Function::Logarithm, number(-1));
    assert_eq!(
        failure(&table, &log),
        FailureKind::Numeric(NumericError::NotFinite)
    );
    assert_eq!(
        failure(&table, &e(ExprKind::Infinity)),
        FailureKind::Unsupported("infinity")
    );
}

#[test]
fn a_failure_points_at_its_place() {
    let mut bottom = number(0);
    bottom.span = Span::new(7, 8);
    let result = Evaluator::new(&Table::default(), LyapunovMethod::Kronecker)
        .value(&over(number(1), bottom));
    assert_eq!(
        result,
        Err(Failure::new(FailureKind::DivisionByZero, Span::new(7, 8)))
    );
}
