//! Laws: what is written reads back, whatever the tree; and no text makes the reader panic.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rederive::expr::{
    Accent, Bracket, Chain, Clause, Display, Expr, ExprKind, Font, Function, IndexRange, Letter,
    Name, QuotientStyle, Relation, Separation, Sign, Subscript,
};
use rederive::latex::{
    Signature, canonical, parse_display, parse_expr, parse_name, write_display, write_expr,
};
use rederive::span::Span;
use std::sync::Arc;

fn at(kind: ExprKind) -> Expr {
    Expr::new(kind, Span::default())
}

fn integer(value: i64) -> Expr {
    let value = num_bigint::BigInt::from(value);
    at(ExprKind::Number(num_rational::BigRational::from_integer(
        value,
    )))
}

/// Zero, one, integers and decimals.
fn number() -> impl Strategy<Value = Expr> {
    (0i64..30, 0u32..3).prop_map(|(digits, places)| {
        let scale = num_bigint::BigInt::from(10i64.pow(places));
        let value = num_rational::BigRational::new(digits.into(), scale);
        at(ExprKind::Number(value))
    })
}

fn letter() -> impl Strategy<Value = Letter> {
    let base = prop::sample::select(vec![
        "a", "b", "m", "d", "e", "E", "P", "\\zeta", "\\Phi", "0",
    ]);
    let font = prop::sample::select(vec![
        Font::Italic,
        Font::Bold,
        Font::Roman,
        Font::Calligraphic,
        Font::Blackboard,
    ]);
    let accent = prop::option::weighted(
        0.2,
        prop::sample::select(vec![
            Accent::Tilde,
            Accent::Hat,
            Accent::Bar,
            Accent::Vector,
        ]),
    );
    let primes = prop_oneof![4 => Just(0u8), 1 => 1u8..3];
    (base, font, accent, primes).prop_map(|(base, font, accent, primes)| {
        // Only bold digits are names, and only bold type has Greek.
        let font = match (base, font) {
            ("0", _) => Font::Bold,
            (base, Font::Bold) if base.starts_with('\\') => Font::Bold,
            (base, _) if base.starts_with('\\') => Font::Italic,
            (_, font) => font,
        };
        Letter {
            base: base.to_owned(),
            font,
            accent,
            primes,
        }
    })
}

fn subscript() -> impl Strategy<Value = Subscript> {
    let label = prop::sample::select(vec![
        "A",
        "4",
        "33",
        "i,j",
        "k+1,1",
        "2m-k",
        "xv",
        "\\zeta",
        "\\dot{\\zeta}",
        "\\mathbf{x}",
        "a\\mathrm{ref}",
        "i1",
    ]);
    label.prop_map(|label| Subscript {
        indices: Vec::new(),
        label: label.to_owned(),
    })
}

fn name() -> impl Strategy<Value = Name> {
    let dots = prop_oneof![4 => Just(0u8), 1 => 1u8..6];
    (letter(), dots, prop::option::of(subscript())).prop_map(|(letter, dots, subscript)| Name {
        letter,
        dots,
        subscript,
    })
}

/// A function that the signature of these tests declares.
fn function_name() -> impl Strategy<Value = Name> {
    (prop::sample::select(vec!["f", "\\xi"]), 0u8..3).prop_map(|(base, dots)| Name {
        dots,
        ..Name::italic(base)
    })
}

fn signature() -> Signature {
    let mut signature = Signature::default();
    for base in ["f", "\\xi"] {
        signature.declare_function(&Name::italic(base), &[]);
    }
    signature
}

fn leaf() -> impl Strategy<Value = Expr> {
    prop_oneof![
        3 => number(),
        6 => name().prop_map(|name| at(ExprKind::Name(name))),
        1 => Just(at(ExprKind::Infinity)),
        1 => Just(at(ExprKind::Constant)),
    ]
}

fn relation() -> impl Strategy<Value = Relation> {
    prop::sample::select(vec![
        Relation::Equal,
        Relation::NotEqual,
        Relation::Less,
        Relation::LessEqual,
        Relation::Greater,
        Relation::GreaterEqual,
        Relation::Distributed,
        Relation::Approximately,
        Relation::Tends,
    ])
}

fn chain_of(member: impl Strategy<Value = Expr> + Clone) -> impl Strategy<Value = Chain> {
    (
        member.clone(),
        prop::collection::vec((relation(), member), 0..3),
    )
        .prop_map(|(first, rest)| {
            let mut members = vec![first];
            let mut relations = Vec::new();
            for (relation, member) in rest {
                relations.push(relation);
                members.push(member);
            }
            Chain {
                members,
                relations,
                span: Span::default(),
            }
        })
}

fn boxed(expr: Expr) -> Box<Expr> {
    Box::new(expr)
}

/// Any tree of the fragment, sensible or not.
fn tree() -> impl Strategy<Value = Expr> + Clone {
    leaf()
        .prop_recursive(4, 30, 4, |inner| {
            let many = prop::collection::vec(inner.clone(), 2..4);
            let sign = prop::sample::select(vec![Sign::Plus, Sign::Minus]);
            let bracket =
                prop::sample::select(vec![Bracket::Round, Bracket::Square, Bracket::Curly]);
            let function = prop::sample::select(vec![
                Function::Determinant,
                Function::Trace,
                Function::RealPart,
                Function::ImaginaryPart,
                Function::Cosine,
                Function::Sine,
                Function::Exponential,
                Function::Logarithm,
                Function::SquareRoot,
                Function::Absolute,
            ]);
            let style = prop::sample::select(vec![QuotientStyle::Bar, QuotientStyle::Slash]);
            prop_oneof![
                3 => prop::collection::vec((sign, inner.clone()), 1..4)
                    .prop_map(|terms| at(ExprKind::Sum(terms))),
                4 => many.clone().prop_map(|factors| at(ExprKind::Product(factors))),
                3 => (inner.clone(), inner.clone(), style).prop_map(|(a, b, style)| {
                    at(ExprKind::Quotient {
                        numerator: boxed(a),
                        denominator: boxed(b),
                        style,
                    })
                }),
                3 => (inner.clone(), inner.clone()).prop_map(|(a, b)| at(ExprKind::Power {
                    base: boxed(a),
                    exponent: boxed(b),
                })),
                1 => inner.clone().prop_map(|a| at(ExprKind::Power {
                    base: boxed(a),
                    exponent: boxed(at(ExprKind::Sum(vec![(Sign::Minus, integer(1))]))),
                })),
                2 => inner.clone().prop_map(|a| at(ExprKind::Transpose(boxed(a)))),
                2 => (bracket.clone(), inner.clone()).prop_map(|(bracket, a)| {
                    at(ExprKind::Group {
                        bracket,
                        inner: boxed(a),
                    })
                }),
                2 => (function, inner.clone()).prop_map(|(function, a)| at(ExprKind::Call {
                    function,
                    argument: boxed(a),
                })),
                2 => (function_name(), prop::collection::vec(inner.clone(), 1..3)).prop_map(
                    |(function, arguments)| at(ExprKind::Apply {
                        function,
                        arguments,
                    })
                ),
                1 => (bracket, prop::collection::vec(inner.clone(), 4)).prop_map(
                    |(bracket, entries)| at(ExprKind::Matrix {
                        rows: entries.chunks(2).map(<[Expr]>::to_vec).collect(),
                        bracket,
                    })
                ),
                1 => many.prop_map(|items| at(ExprKind::Tuple(items))),
                2 => (name(), inner.clone(), inner.clone(), inner.clone()).prop_map(
                    |(index, from, to, body)| at(ExprKind::BigSum {
                        index,
                        from: boxed(from),
                        to: boxed(to),
                        body: boxed(body),
                    })
                ),
                2 => (prop::option::of((inner.clone(), inner.clone())), inner.clone(), name())
                    .prop_map(|(limits, body, variable)| at(ExprKind::Integral {
                        limits: limits.map(|(a, b)| (boxed(a), boxed(b))),
                        body: boxed(body),
                        variable,
                    })),
                2 => (1u8..4, prop::option::of(name()), inner.clone()).prop_map(
                    |(order, variable, body)| at(ExprKind::Derivative {
                        order,
                        variable,
                        body: boxed(body),
                    })
                ),
                1 => inner.clone().prop_map(|a| at(ExprKind::Expectation(boxed(a)))),
                1 => (inner.clone(), chain_of(inner.clone())).prop_map(|(body, label)| {
                    at(ExprKind::Underbrace {
                        body: boxed(body),
                        label: Box::new(label),
                    })
                }),
                1 => (inner.clone(), chain_of(inner)).prop_map(|(value, mut condition)| {
                    if condition.relations.is_empty() {
                        condition.members.push(value.clone());
                        condition.relations.push(Relation::Less);
                    }
                    at(ExprKind::Cases(vec![(value.clone(), vec![condition]), (value, vec![])]))
                }),
            ]
        })
        .boxed()
}

/// The tree without the brackets that only group: the writer may add some.
fn bare(expr: &Expr) -> Expr {
    let one = |inner: &Expr| Box::new(bare(inner));
    let all = |items: &[Expr]| items.iter().map(bare).collect::<Vec<_>>();
    let kind = match &expr.kind {
        ExprKind::Group { inner, .. } => return bare(inner),
        // +x is x once its brackets are gone.
        ExprKind::Sum(terms) => ExprKind::Sum(
            terms
                .iter()
                .map(|(sign, term)| (*sign, bare(term)))
                .collect(),
        ),
        ExprKind::Product(factors) => ExprKind::Product(all(factors)),
        ExprKind::Quotient {
            numerator,
            denominator,
            style,
        } => ExprKind::Quotient {
            numerator: one(numerator),
            denominator: one(denominator),
            style: *style,
        },
        ExprKind::Power { base, exponent } => ExprKind::Power {
            base: one(base),
            exponent: one(exponent),
        },
        ExprKind::Transpose(inner) => ExprKind::Transpose(one(inner)),
        ExprKind::Call { function, argument } => ExprKind::Call {
            function: *function,
            argument: one(argument),
        },
        ExprKind::Apply {
            function,
            arguments,
        } => ExprKind::Apply {
            function: function.clone(),
            arguments: all(arguments),
        },
        ExprKind::Matrix { rows, bracket } => ExprKind::Matrix {
            rows: rows.iter().map(|row| all(row)).collect(),
            bracket: *bracket,
        },
        ExprKind::Tuple(items) => ExprKind::Tuple(all(items)),
        ExprKind::BigSum {
            index,
            from,
            to,
            body,
        } => ExprKind::BigSum {
            index: index.clone(),
            from: one(from),
            to: one(to),
            body: one(body),
        },
        ExprKind::Integral {
            limits,
            body,
            variable,
        } => ExprKind::Integral {
            limits: limits.as_ref().map(|(a, b)| (one(a), one(b))),
            body: one(body),
            variable: variable.clone(),
        },
        ExprKind::Derivative {
            order,
            variable,
            body,
        } => ExprKind::Derivative {
            order: *order,
            variable: variable.clone(),
            body: one(body),
        },
        ExprKind::Expectation(inner) => ExprKind::Expectation(one(inner)),
        ExprKind::Underbrace { body, label } => ExprKind::Underbrace {
            body: one(body),
            label: Box::new(bare_chain(label)),
        },
        ExprKind::Cases(cases) => ExprKind::Cases(
            cases
                .iter()
                .map(|(value, conditions)| {
                    (bare(value), conditions.iter().map(bare_chain).collect())
                })
                .collect(),
        ),
        ExprKind::Named { .. }
        | ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Infinity
        | ExprKind::Constant => expr.kind.clone(),
    };
    at(kind)
}

fn bare_chain(chain: &Chain) -> Chain {
    Chain {
        members: chain.members.iter().map(bare).collect(),
        relations: chain.relations.clone(),
        span: chain.span,
    }
}

fn bare_display(display: &Display) -> Display {
    let mut display = display.clone();
    for clause in display.clauses.iter_mut().map(Arc::make_mut) {
        clause.chain = bare_chain(&clause.chain);
    }
    display
}

fn range() -> impl Strategy<Value = IndexRange> {
    let to = prop_oneof![
        (0i64..9).prop_map(integer),
        Just(at(ExprKind::Name(Name::italic("n"))))
    ];
    (0i64..5, 1i64..3, to).prop_map(|(from, step, to)| IndexRange {
        index: Name::italic("k"),
        from: integer(from),
        step: integer(step),
        to,
    })
}

fn display() -> impl Strategy<Value = Display> {
    let clause = (
        prop::option::weighted(0.2, Just("II".to_owned())),
        chain_of(tree()),
        prop::collection::vec(range(), 0..2),
        prop::option::weighted(0.2, Just("by symmetry".to_owned())),
    )
        .prop_map(|(heading, chain, ranges, remark)| Clause {
            heading,
            joined: None,
            separation: Separation::None,
            bracketed: false,
            chain,
            ranges,
            remark,
        });
    let tag = prop::option::of(Just("12a".to_owned()));
    (prop::collection::vec(clause, 1..4), tag).prop_map(|(clauses, tag)| Display {
        clauses: clauses.into_iter().map(Arc::new).collect(),
        tag,
    })
}

/// The same draws in every run, others where `PROPTEST_RNG_SEED` is set: what a test says must not
/// change from run to run.
fn config() -> ProptestConfig {
    let told = ProptestConfig::default();
    let rng_seed = match told.rng_seed {
        RngSeed::Random => RngSeed::Fixed(14),
        fixed @ RngSeed::Fixed(_) => fixed,
    };
    ProptestConfig {
        cases: 400,
        failure_persistence: None,
        rng_seed,
        ..told
    }
}

proptest! {
    #![proptest_config(config())]

    /// The canonical form of a name reads as the name.
    #[test]
    fn a_name_reads_back(name in name()) {
        let text = canonical(&name);
        let again = parse_name(&text, 0).map_err(|wrong| TestCaseError::fail(format!("{text}: {wrong:?}")))?;
        prop_assert_eq!(&canonical(&again), &text);
        prop_assert_eq!(again, name);
    }

    /// A tree reads back, up to brackets; and what has been read reads back exactly.
    #[test]
    fn a_tree_reads_back(tree in tree()) {
        let signature = signature();
        let text = write_expr(&tree);
        let again = parse_expr(&text, 0, &signature)
            .map_err(|wrong| TestCaseError::fail(format!("{text}: {wrong:?}")))?;
        prop_assert_eq!(bare(&again), bare(&tree), "{}", text);
        let rewritten = write_expr(&again);
        let thrice = parse_expr(&rewritten, 0, &signature)
            .map_err(|wrong| TestCaseError::fail(format!("{rewritten}: {wrong:?}")))?;
        prop_assert_eq!(thrice, again, "{}", rewritten);
    }

    /// So does a display with its headings, ranges, remarks and number.
    #[test]
    fn a_display_reads_back(display in display()) {
        let signature = signature();
        let text = write_display(&display);
        let again = parse_display(&text, 0, &signature)
            .map_err(|wrong| TestCaseError::fail(format!("{text}: {wrong:?}")))?;
        prop_assert_eq!(bare_display(&again), bare_display(&display), "{}", text);
    }

    /// Nothing that anyone can type makes the reader panic, and complaints point into the text.
    #[test]
    fn any_text_is_read_or_refused(text in "[-+*/=<>a-eTt0-9.,;:!'&_^|(){}\\[\\]\\\\ %α~$]{0,40}") {
        if let Err(diagnostics) = parse_display(&text, 3, &signature()) {
            prop_assert!(!diagnostics.is_empty());
            for d in diagnostics {
                prop_assert!(3 <= d.span.start && d.span.start <= d.span.end && d.span.end <= 3 + text.len());
            }
        }
    }

    /// The same for texts of LaTeX's own pieces.
    #[test]
    fn any_pieces_are_read_or_refused(pieces in prop::collection::vec(prop::sample::select(vec![
        "a", "d", "E", "f", "2", "{", "}", "(", ")", "[", "]", "\\{", "\\}", "\\left(", "\\right)", "\\left.",
        "\\right.", "\\right\\}", "\\begin{bmatrix}", "\\end{bmatrix}", "\\begin{aligned}",
        "\\end{aligned}", "\\begin{array}{cc}", "\\end{array}", "\\begin{cases}", "\\end{cases}", "&", "\\\\",
        "\\quad", "\\ ", ",", ".", "=", "<", "+", "-", "/", "\\cdot", "^", "_", "'", "|", "\\frac", "\\sum",
        "\\int", "\\underbrace", "\\det", "\\cos", "\\sqrt", "\\dot", "\\tilde", "\\mathbf", "\\mathrm{d}",
        "\\text{and}", "\\text{const}", "\\infty", "\\partial", "\\ldots", "\\prime", "\\tag{1}", "(1)", "T",
    ]), 0..14)) {
        let text = pieces.join(" ");
        if let Err(diagnostics) = parse_display(&text, 0, &signature()) {
            prop_assert!(!diagnostics.is_empty());
        }
    }
}
