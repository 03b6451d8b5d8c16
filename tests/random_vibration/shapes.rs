//! A claim whose shapes do not fit is false, and says so; a definition is no document.

use super::{audit, corrections, outcome, word};
use rederive::document::VerdictWord;
use rederive::verdict::{EditClass, Verdict};

/// Vectors and a matrix whose sides are all different, and one claim.
fn document(claim: &str) -> String {
    let table = r"```toml symbols
a = { value = '2' }
b = { value = '3' }
c = { value = '5' }
```

```math 1 define
\mathbf{H} = \begin{bmatrix} a & b & c \\ b & c & a \end{bmatrix}, \quad
\mathbf{d} = \begin{bmatrix} a \\ b \end{bmatrix}, \quad
\mathbf{v} = \begin{bmatrix} c \\ b \\ a \end{bmatrix}, \quad
\mathbf{S} = \begin{bmatrix} a & b \\ b & c \end{bmatrix}
```
";
    format!("{table}\n```math 2 claim\n{claim}\n```\n")
}

fn misfit(claim: &str) -> (String, String, String) {
    let audit = audit(&document(claim));
    match &outcome(&audit, "2.1").verdict {
        Verdict::Refuted(refutation) | Verdict::Misprint { refutation, .. } => {
            let misfit = refutation.misfit().cloned().expect("shapes do not fit");
            assert!(refutation.residual.is_empty() && refutation.witness().is_none());
            (misfit.operation, misfit.left, misfit.right)
        }
        other => panic!("{claim}: {other:?}"),
    }
}

#[test]
fn sides_of_different_shapes_are_refuted() {
    let fit = |o: &str, l: &str, r: &str| (o.to_string(), l.to_string(), r.to_string());
    assert_eq!(misfit(r"\mathbf{d} = \mathbf{v}"), fit("=", "2x1", "3x1"));
    assert_eq!(misfit(r"a = \mathbf{d}"), fit("=", "scalar", "2x1"));
    assert_eq!(
        misfit(r"\mathbf{H}\mathbf{d} = \mathbf{v}"),
        fit("times", "2x3", "2x1")
    );
    assert_eq!(
        misfit(r"\mathbf{d} + \mathbf{v} = \mathbf{d}"),
        fit("+", "2x1", "3x1")
    );
    assert_eq!(
        misfit(r"\mathbf{H}^2 = \mathbf{S}"),
        fit("power", "2x3", "2x3")
    );
}

#[test]
fn a_lost_transposition_is_put_back() {
    let printed = r"\mathbf{d}^T\mathbf{H}^T\mathbf{v} = \mathbf{v}^T\mathbf{H}^T\mathbf{d}";
    let audit = audit(&document(printed));
    assert_eq!(
        corrections(&audit, "2.1"),
        [[r"\mathbf{H}^T -> \mathbf{H}"]]
    );
    let Verdict::Misprint { correction, .. } = &outcome(&audit, "2.1").verdict else {
        unreachable!("a misprint");
    };
    assert_eq!(correction.edits[0].class, EditClass::Transpose);
}

/// The pattern of a variance with H and H^T exchanged: one slip at three places.
#[test]
fn exchanged_transpositions_are_mended_together() {
    let right = r"\mathbf{d}^T\mathbf{S}\mathbf{d} + 2\mathbf{d}^T\mathbf{H}\mathbf{v} + \mathbf{v}^T\mathbf{H}^T\mathbf{S}\mathbf{H}\mathbf{v}";
    let sound = format!(
        r"(\mathbf{{d}} + \mathbf{{H}}\mathbf{{v}})^T\mathbf{{S}}(\mathbf{{d}} + \mathbf{{H}}\mathbf{{v}}) = {}",
        right.replace(r"2\mathbf{d}^T", r"2\mathbf{d}^T\mathbf{S}")
    );
    assert_eq!(word(&audit(&document(&sound)), "2.1"), VerdictWord::Holds);
    let exchanged = sound
        .replace(
            r"2\mathbf{d}^T\mathbf{S}\mathbf{H}",
            r"2\mathbf{d}^T\mathbf{S}\mathbf{H}^T",
        )
        .replace(
            r"\mathbf{v}^T\mathbf{H}^T\mathbf{S}\mathbf{H}",
            r"\mathbf{v}^T\mathbf{H}\mathbf{S}\mathbf{H}^T",
        );
    assert_ne!(sound, exchanged);
    let audit = audit(&document(&exchanged));
    assert_eq!(
        corrections(&audit, "2.1")[0].len(),
        3,
        "{:?}",
        corrections(&audit, "2.1")
    );
}

/// Shapes that fit say nothing about the rest.
#[test]
fn a_transposition_that_fits_and_is_wrong_is_refuted_by_its_residual() {
    let audit = audit(&document(
        r"\begin{bmatrix} a & b \\ c & a \end{bmatrix}\mathbf{d} = \left(\mathbf{d}^T\begin{bmatrix} a & b \\ c & a \end{bmatrix}\right)^T",
    ));
    let Verdict::Misprint { refutation, .. } = &outcome(&audit, "2.1").verdict else {
        panic!("{:?}", outcome(&audit, "2.1").verdict);
    };
    assert!(refutation.misfit().is_none() && !refutation.residual.is_empty());
}

#[test]
fn a_scalar_is_its_own_transpose() {
    let audit = audit(&document(
        r"\mathbf{v}^T\mathbf{H}^T\mathbf{d} = \mathbf{d}^T\mathbf{H}\mathbf{v}",
    ));
    assert_eq!(word(&audit, "2.1"), VerdictWord::Holds);
}
