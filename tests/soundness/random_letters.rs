//! Covariances of letters that are functions of nothing: whether such a letter is random or a number is not
//! said by its declaration, and at a point it is none of the two.

use super::dots::Draw;
use super::unwritten::{Claim, Truth, undecided};

const PREAMBLE: &str = r"# Random letters

```toml symbols
'\mathbf{x}' = { shape = [2, 1] }
X = {}
A = {}
B = {}
z = {}
g = { positive = true }
h = { positive = true }
q = { positive = true }
```

```toml notation
'\mathbf{P}' = { covariance_of = '\mathbf{x}' }
'S' = { covariance_of = 'X' }
'\mathbf{R}' = { covariance_of = '\mathbf{w}' }
'e' = { constant = 'e' }
```

```math covariances define
\mathbf{P} = \begin{bmatrix} g & 0 \\ 0 & h \end{bmatrix}, \quad S = q
```

```math pair define
\mathbf{w} = \begin{bmatrix} A \\ B \end{bmatrix}, \quad \mathbf{R} = \begin{bmatrix} 2 & 1 \\ 1 & 2 \end{bmatrix}
```

```math named define
s = 2A + 3, \quad r = X^2, \quad j = E\{X^2\}, \quad l = E\{s^2\}
```
";

fn linear(draw: &mut Draw) -> ([i64; 3], String) {
    let k = [(); 3].map(|()| draw.below(5) as i64 + 1);
    (k, format!("({}A + {}B + {})", k[0], k[1], k[2]))
}

#[test]
fn letters_that_are_functions_of_nothing_are_no_constants_at_points() {
    let mut draw = Draw::new(93);
    let mut claims = Vec::new();
    let mut add = |claim: String, truth| claims.push(Claim::plain(claim, truth));
    for _ in 0..90 {
        let (u, left) = linear(&mut draw);
        let (v, right) = linear(&mut draw);
        let product = 2 * u[0] * v[0] + u[0] * v[1] + u[1] * v[0] + 2 * u[1] * v[1] + u[2] * v[2];
        let off = draw.below(2) as i64;
        let truth = if off == 0 { Truth::True } else { Truth::False };
        add(format!(r"E\{{{left}{right}\}} = {}", product + off), truth);
        add(format!(r"E\{{{left}\}} = {}", u[2] + off), truth);
        let m = draw.below(6) as i64 + 1;
        add(format!(r"E\{{{m}X^2 + {}X\}} = {}q", u[0], m + off), truth);
    }
    for (claim, truth) in [
        (r"E\{\mathbf{x}\mathbf{x}^T\} = \mathbf{P}", Truth::True),
        (r"E\{\mathbf{x}\mathbf{x}^T\} = 2\mathbf{P}", Truth::False),
        (r"E\{\mathbf{x}^T\mathbf{x}\} = g + h", Truth::True),
        (r"E\{X\} = X", Truth::False),
        (r"E\{X^2\} = X^2", Truth::False),
        (r"E\{\mathbf{x}\} = \mathbf{x}", Truth::False),
        (r"E\{\mathbf{w}\mathbf{w}^T\} = \mathbf{R}", Truth::True),
        (r"E\{s\} = 3", Truth::True),
        (r"E\{s^2\} = 17", Truth::True),
        (r"E\{s\} = s", Truth::False),
        (r"E\{r\} = q", Truth::True),
        (r"E\{r\} = r", Truth::False),
        ("j = q", Truth::True),
        ("j = S", Truth::True),
        ("j = 2q", Truth::False),
        ("j = r", Truth::False),
        ("j > 0", Truth::True),
        ("l = 17", Truth::True),
        ("l > 16", Truth::True),
        (r"E\{X^2\} > 0", Truth::True),
        (r"E\{X\} > 0", Truth::False),
        (r"E\{X\} \ne 0", Truth::False),
        (r"E\{X^3\} = 0", Truth::Open),
        (r"E\{\cos A\} = \cos A", Truth::Open),
        (r"E\{|A|\} = |A|", Truth::Open),
        (r"E\{e^X\} = e^X", Truth::Open),
        (r"E\{AX\} = 0", Truth::Open),
        (r"E\{A\mathbf{x}\} = \mathbf{0}", Truth::Open),
    ] {
        if !claim.contains(r"\mathbf{0}") {
            add(claim.into(), truth);
        }
    }
    undecided(PREAMBLE, &claims);
}
