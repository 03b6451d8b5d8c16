//! Covariances by documents: Lyapunov equations in whatever way they are printed, and systems without
//! a stationary state.

use super::{audit, outcome, word};
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::DiagnosticKind;
use rederive::document::{Document, VerdictWord};
use rederive::verdict::{CounterProof, Verdict};

/// An oscillator with a damper of this value, its covariance by this equation, and claims.
fn document(damper: &str, equation: &str, claims: &str) -> String {
    format!(
        r"```toml symbols
m = {{ value = '2', positive = true }}
k = {{ value = '8', positive = true }}
d = {{ value = '{damper}' }}
q = {{ value = '1', positive = true }}
t = {{ }}
y = {{ function_of = 't' }}
```

```toml notation
'\mathbf{{0}}' = {{ zero = true }}
'\mathbf{{P}}' = {{ covariance_of = '\mathbf{{x}}' }}
'P_{{i,j}}' = {{ entry_of = '\mathbf{{P}}' }}
```

```math 1 define
\mathbf{{x}} = \begin{{bmatrix}} y \\ \dot{{y}} \end{{bmatrix}}, \quad
\mathbf{{A}} = \begin{{bmatrix}} 0 & 1 \\ -\frac{{k}}{{m}} & -\frac{{d}}{{m}} \end{{bmatrix}}, \quad
\mathbf{{B}} = \begin{{bmatrix}} 0 \\ \frac{{1}}{{m}} \end{{bmatrix}}
```

```math 2 solve \mathbf{{P}}
{equation}
```

{claims}
"
    )
}

const PLAIN: &str =
    r"\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T + q\mathbf{B}\mathbf{B}^T = \mathbf{0}";

#[test]
fn a_lyapunov_equation_is_recognised_however_it_is_printed() {
    let claim = "```math 3 claim\nP_{11} = \\frac{q}{2dk}, \\quad P_{22} = \\frac{q}{2dm}, \\quad P_{12} = 0\n```\n";
    for equation in [
        PLAIN,
        r"\mathbf{A}\mathbf{P} + q\mathbf{B}\mathbf{B}^T = -\mathbf{P}\mathbf{A}^T",
        r"\mathbf{A}\mathbf{P} + (\mathbf{A}\mathbf{P}^T)^T = -q\mathbf{B}\mathbf{B}^T",
        r"2m(\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T) = -2mq\mathbf{B}\mathbf{B}^T",
    ] {
        let audit = audit(&document("3", equation, claim));
        for link in ["3.1", "3.2", "3.3"] {
            assert_eq!(word(&audit, link), VerdictWord::Holds, "{equation} {link}");
        }
    }
}

#[test]
fn other_linear_and_nonlinear_equations_are_told_apart() {
    // Sylvester's equation, by elimination.
    let sylvester =
        r"\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A} + q\mathbf{B}\mathbf{B}^T = \mathbf{0}";
    let claim = "```math 3 claim\n\\mathbf{A}\\mathbf{P} = -\\mathbf{P}\\mathbf{A} - q\\mathbf{B}\\mathbf{B}^T\n```\n";
    // Its solution is no covariance.
    let plain =
        |text: String| text.replace("'\\mathbf{P}' = { covariance_of = '\\mathbf{x}' }\n", "");
    assert_eq!(
        word(&audit(&plain(document("3", sylvester, claim))), "3.1"),
        VerdictWord::Holds
    );
    // Riccati's is not linear.
    let riccati = r"\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T + \mathbf{P}^2 + q\mathbf{B}\mathbf{B}^T = \mathbf{0}";
    let audit = audit(&document("3", riccati, ""));
    let Verdict::Undecided { reason } = &outcome(&audit, "2.1").verdict else {
        panic!("{:?}", outcome(&audit, "2.1").verdict);
    };
    assert!(reason.contains("not linear"), "{reason}");
}

/// What a document is refused for.
fn refused(text: &str) -> Vec<DiagnosticKind> {
    let document = match Document::parse("test.md", text) {
        Ok(document) => document,
        Err(diagnostics) => return diagnostics.into_iter().map(|d| d.kind).collect(),
    };
    let rejection = Audit::of(&document, Options::default()).expect_err("it is refused");
    rejection.diagnostics.into_iter().map(|d| d.kind).collect()
}

/// Which Hurwitz determinant is not positive, and its value.
fn instability(text: &str) -> (usize, String) {
    let audit = audit(text);
    match &outcome(&audit, "2.1").verdict {
        Verdict::Refuted(refutation) => match refutation.counter_proof() {
            Some(CounterProof::Unstable { order, determinant }) => (*order, determinant.clone()),
            flaw => panic!("{flaw:?}"),
        },
        verdict => panic!("{verdict:?}"),
    }
}

#[test]
fn an_unstable_system_has_no_covariance() {
    // With a negative damper H_1 = d/m is negative; H_2 would be too.
    assert_eq!(
        instability(&document("-3", PLAIN, "")),
        (1, "-3/2".to_string())
    );
    // A system whose last Hurwitz determinant is the first that fails: a negative spring.
    let text = document("3", PLAIN, "").replace(
        r"-\frac{k}{m} & -\frac{d}{m}",
        r"\frac{k}{m} & -\frac{d}{m}",
    );
    assert_eq!(instability(&text), (2, "-6".to_string()));
    // Without a damper nothing is determined.
    let text = document("3", PLAIN, "").replace(r"-\frac{d}{m} \end", r"0 \end");
    assert_eq!(
        word(&audit(&text), "2.1"),
        VerdictWord::Undecided,
        "contradictory"
    );
}

/// A matrix equation that no covariance solves may have any solution.
#[test]
fn a_matrix_that_is_no_covariance_needs_no_stability() {
    let text = document("-3", PLAIN, "")
        .replace("'\\mathbf{P}' = { covariance_of = '\\mathbf{x}' }\n", "");
    assert_eq!(word(&audit(&text), "2.1"), VerdictWord::Definition);
}

#[test]
fn a_speed_that_is_not_positive_is_refused() {
    for value in ["0", "-20"] {
        let text = format!(
            "```toml symbols\nv = {{ unit = 'm/s', positive = true, value = '{value}' }}\n```\n\
             ```math 1 claim\nv = v\n```\n"
        );
        assert!(
            matches!(&refused(&text)[..], [DiagnosticKind::NotPositive { name, .. }] if name == "v")
        );
    }
}
