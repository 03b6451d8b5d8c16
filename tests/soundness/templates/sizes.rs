//! Matrices of any size: what is true for all sizes, and what is true for some of them only.

use crate::generated::generator::{Claim, Kind, Template, Truth};
use crate::generated::random::Random;

pub const TEMPLATES: &[Template] = &[
    Template {
        name: "sizes/algebra",
        kind: Kind::Other,
        header: "",
        make: algebra,
    },
    Template {
        name: "sizes/of some sizes only",
        kind: Kind::Other,
        header: "",
        make: some_sizes,
    },
    Template {
        name: "sizes/definite",
        kind: Kind::Other,
        header: "",
        make: definite,
    },
];

fn header(instances: &str) -> String {
    format!(
        r#"```toml document
title = "t"
instances = {{ f = {instances} }}
```
```toml symbols
a = {{ positive = true }}
'\mathbf{{M}}' = {{ shape = ["f", "f"], symmetric = true, positive_definite = true }}
'\mathbf{{K}}' = {{ shape = ["f", "f"], symmetric = true, positive_definite = true }}
'\mathbf{{D}}' = {{ shape = ["f", "f"] }}
'\mathbf{{G}}' = {{ shape = ["f", "f"], skew = true }}
'\mathbf{{x}}' = {{ shape = ["f", 1] }}
```
```toml notation
'\mathbf{{E}}' = {{ identity = "f" }}
'\mathbf{{0}}' = {{ zero = true }}
```
"#
    )
}

/// `D` for the matrix in bold.
fn bold(text: &str) -> String {
    let mut out = text.to_string();
    for letter in ["M", "K", "D", "G", "E", "x"] {
        out = out.replace(&format!("!{letter}"), &format!("\\mathbf{{{letter}}}"));
    }
    out.replace("!0", "\\mathbf{0}")
}

fn algebra(r: &mut Random, label: &str) -> Claim {
    let (latex, truth) = r.pick(&[
        ("(!M + !D)^2 = !M^2 + !M!D + !D!M + !D^2", Truth::True),
        ("(!M + !D)^2 = !M^2 + 2!M!D + !D^2", Truth::False),
        ("(!M!D)^T = !D^T!M", Truth::True),
        ("(!M!D)^T = !M!D^T", Truth::False),
        ("!x^T!G!x = 0", Truth::True),
        ("!x^T!D!x = !x^T!D^T!x", Truth::True),
        ("!M!K = !K!M", Truth::False),
        ("!x^T!M!K!x = !x^T!K!M!x", Truth::True),
        (
            "\\operatorname{tr}(!M!D) = \\operatorname{tr}(!D!M)",
            Truth::True,
        ),
        ("\\operatorname{tr}(!G) = 0", Truth::True),
        ("\\operatorname{tr}(!M!G) = 0", Truth::True),
        ("\\operatorname{tr}(!D!D) = 0", Truth::False),
        ("!E!D = !D", Truth::True),
        ("!M^{-1}!M = !E", Truth::True),
        ("(!D + !D^T)^T = !D + !D^T", Truth::True),
        ("\\det(!M!D) = \\det !M \\cdot \\det !D", Truth::True),
        ("\\det !D^T = \\det !D", Truth::True),
        ("\\det(!M + !K) = \\det !M + \\det !K", Truth::False),
        ("!G^T = -!G", Truth::True),
        ("!D^T = !D", Truth::False),
    ]);
    let sizes = r.pick(&["[1, 2]", "[2, 3]", "[2]"]);
    // With one row much is true that is not true of more; with one and two rows both are said.
    Claim::of(label, &bold(latex), truth).alone(&header(sizes))
}

fn some_sizes(r: &mut Random, label: &str) -> Claim {
    let (latex, truth) = r.pick(&[
        ("\\det(-!D) = \\det !D", Truth::False),
        ("\\det(-!M) = \\det !M", Truth::False),
        ("\\operatorname{tr}(!E) = 2", Truth::False),
        ("\\det(2!M) = 4\\det !M", Truth::False),
        ("\\det(a!D) = a^2\\det !D", Truth::False),
        (
            "!D^2 - \\operatorname{tr}(!D)!D + \\det !D \\cdot !E = !0",
            Truth::False,
        ),
        ("\\det !G = 0", Truth::False),
    ]);
    let sizes = r.pick(&["[2, 3]", "[2, 4]", "[2]"]);
    // Of the odd sizes only the determinant of a skew matrix vanishes.
    Claim::of(label, &bold(latex), truth).alone(&header(sizes))
}

fn definite(r: &mut Random, label: &str) -> Claim {
    let (latex, truth) = r.pick(&[
        ("!M_{11} > 0", Truth::True),
        ("\\det !M > 0", Truth::True),
        ("!M + !K > !0", Truth::True),
        ("a!M > !0", Truth::True),
        ("!M - !K > !0", Truth::False),
        ("!D + !D^T > !0", Truth::False),
        ("-!M > !0", Truth::False),
        ("!M_{12} > 0", Truth::False),
        ("\\operatorname{tr}(!M) > 0", Truth::True),
        ("!x^T!M!x \\ge 0", Truth::True),
        ("!x^T!D!x \\ge 0", Truth::False),
        ("\\det !D > 0", Truth::False),
    ]);
    Claim::of(label, &bold(latex), truth).alone(&header("[2, 3]"))
}
