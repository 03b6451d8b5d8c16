//! Formulas of tables with elementary functions: integrals of exponential polynomials, hyperbolic and
//! circular functions, moduli, mixed derivatives. Each true one holds; each damaged one is refuted, and
//! where a single slip was planted, the search finds it.

mod common;

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::verdict::Verdict;

const LETTERS: &str = r#"```toml symbols
a = { positive = true, value = "2" }
b = { positive = true, value = "3" }
c = { positive = true, value = "5" }
L = { positive = true, value = "7" }
t = { positive = true, value = "1" }
'\omega' = { positive = true, value = "11" }
x = { value = "1/2" }
y = { value = "1/3" }
p = { value = "-2" }
```

```toml notation
e = { constant = "e" }
j = { constant = "i" }
'\pi' = { constant = "pi" }
```

"#;

fn audit(claims: &[&str]) -> Audit {
    let mut text = LETTERS.to_string();
    for (k, claim) in claims.iter().enumerate() {
        text += &format!("```math {} claim\n{claim}\n```\n\n", k + 1);
    }
    common::audit(&text, Options::default()).unwrap_or_else(|r| panic!("{r}"))
}

/// Gradshteyn and Ryzhik, Table of Integrals, Series, and Products (2007), sections 1.31-1.32, 2.5,
/// 2.66, 3.3, 3.893; Abramowitz and Stegun (1964), 4.3 and 4.5.
const TRUE: &[&str] = &[
    r"\int_0^\infty e^{-at}\cos\omega t\, dt = \frac{a}{a^2+\omega^2}",
    r"\int_0^\infty e^{-at}\sin\omega t\, dt = \frac{\omega}{a^2+\omega^2}",
    r"\int_0^\infty t^3 e^{-at}\, dt = \frac{6}{a^4}",
    r"\int_0^L x\sin ax\, dx = \frac{\sin aL - aL\cos aL}{a^2}",
    r"\int_0^\pi \sin^2 x\, dx = \frac{\pi}{2}",
    r"\int_0^{2\pi} \cos^4 x\, dx = \frac{3\pi}{4}",
    r"\int_0^\infty e^{-ax}\cos bx\sin cx\, dx = \frac{c(a^2-b^2+c^2)}{(a^2+(b+c)^2)(a^2+(b-c)^2)}",
    r"\int_0^t e^{-a(t-x)}\cos\omega x\, dx = \frac{a\cos\omega t+\omega\sin\omega t-ae^{-at}}{a^2+\omega^2}",
    r"\int_{-\infty}^0 x e^{bx}\, dx = -\frac{1}{b^2}",
    r"\int_{-\infty}^\infty e^{-a|x|}\cos\omega x\, dx = \frac{2a}{a^2+\omega^2}",
    r"\int_{-\infty}^\infty |x|e^{-a|x|}\, dx = \frac{2}{a^2}",
    r"\int_0^L \sinh ax\, dx = \frac{\cosh aL - 1}{a}",
    r"\int_0^L \left(\frac{d^2 x^3}{dx^2}\right)^2 dx = 12L^3",
    r"\cosh^2 x - \sinh^2 x = 1",
    r"\tanh(x+y) = \frac{\tanh x+\tanh y}{1+\tanh x\tanh y}",
    r"\tan 2x = \frac{2\tan x}{1-\tan^2 x}",
    r"\tan x\cot x = 1",
    r"\frac{d}{dx}\tanh x = 1-\tanh^2 x = \frac{1}{\cosh^2 x}",
    r"\frac{\partial^2(x^2\sin y)}{\partial x\partial y} = 2x\cos y",
    r"\frac{\partial^3}{\partial x^2\partial y}(x^3y^2) = 12xy",
    r"\left|a+jb\right|^2 = a^2+b^2",
    r"\left|\frac{1}{a+jb}\right| = \frac{1}{\sqrt{a^2+b^2}}",
];

#[test]
fn formulas_of_tables_hold() {
    let audit = audit(TRUE);
    for outcome in &audit.outcomes {
        let claim = TRUE[outcome.equation];
        assert!(
            matches!(outcome.verdict, Verdict::Holds { .. }),
            "{claim}: {:?}",
            outcome.verdict
        );
    }
}

#[test]
fn a_slip_in_a_formula_is_found_and_mended() {
    for (damaged, class) in [
        (
            r"\int_0^\infty e^{-at}\cos\omega t\, dt = \frac{a}{a^2-\omega^2}",
            "sign",
        ),
        (
            r"\int_0^\infty t^3 e^{-at}\, dt = \frac{6}{a^3}",
            "exponent",
        ),
        (r"\int_0^L \sinh ax\, dx = \frac{\cosh aL + 1}{a}", "sign"),
        (
            r"\int_{-\infty}^\infty e^{-a|x|}\cos\omega x\, dx = \frac{a}{a^2+\omega^2}",
            "factor",
        ),
        (
            r"\frac{d}{dx}(e^{-ax}\sin bx) = e^{-ax}(a\cos bx - a\sin bx)",
            "letter",
        ),
        (r"\frac{d}{dx}(x e^{ax}) = (1+bx)e^{ax}", "letter"),
        (r"\cosh^2 x + \sinh^2 x = 1", "sign"),
        (r"\tan 2x = \frac{2\tan x}{1+\tan^2 x}", "sign"),
        (r"\left|a+jb\right|^2 = a^2-b^2", "sign"),
    ] {
        let audit = audit(&[damaged]);
        match &audit.outcomes[0].verdict {
            Verdict::Misprint { correction, .. } => {
                let found = format!("{:?}", correction.edits[0].class).to_lowercase();
                assert_eq!(found, class, "{damaged}");
            }
            other => panic!("{damaged}: {other:?}"),
        }
    }
}

#[test]
fn what_has_no_value_or_is_not_known_is_no_pass() {
    for (claim, why) in [
        (r"\int_0^\infty e^{ax}\, dx = \frac{1}{a}", "it diverges"),
        (
            r"\int_0^\infty e^{px}\, dx = -\frac{1}{p}",
            "p may be positive",
        ),
        (r"\int_0^\infty x\sin bx\, dx = 0", "it does not converge"),
    ] {
        let audit = audit(&[claim]);
        let verdict = &audit.outcomes[0].verdict;
        assert!(
            !matches!(verdict, Verdict::Holds { .. } | Verdict::HoldsGiven(..)),
            "{claim} ({why}): {verdict:?}"
        );
    }
}

/// A square that is negative has no root: such an angle once ended the program.
#[test]
fn a_negative_square_in_an_angle() {
    let audit = audit(&[
        r"\cos\sqrt{x^2} = \cos x",
        r"\cos(-(x-y)^2) = \cos((x-y)^2)",
    ]);
    assert!(
        audit
            .outcomes
            .iter()
            .all(|o| matches!(o.verdict, Verdict::Holds { .. })),
        "{:?}",
        audit.outcomes
    );
}
