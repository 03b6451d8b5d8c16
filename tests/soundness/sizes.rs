//! Any size: what is seen at one size proves nothing of the others. The truth of each claim for each
//! size is known from linear algebra.

use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord;

/// For which sizes a claim is true.
#[derive(Clone, Copy, PartialEq)]
enum True {
    Always,
    Even,
    Odd,
    Only(usize),
    TwoOrThree,
    Never,
}

impl True {
    fn at(self, f: usize) -> bool {
        match self {
            True::Always => true,
            True::Even => f.is_multiple_of(2),
            True::Odd => !f.is_multiple_of(2),
            True::Only(n) => f == n,
            True::TwoOrThree => f == 2 || f == 3,
            True::Never => false,
        }
    }
}

const CLAIMS: &[(&str, True)] = &[
    (r"\det(-\mathbf M) = \det\mathbf M", True::Even),
    (r"\det(-\mathbf M) = -\det\mathbf M", True::Odd),
    (r"\det(-\mathbf M^T) = \det\mathbf M", True::Even),
    (r"\det(2\mathbf M) = 4\det\mathbf M", True::Only(2)),
    (r"\det(a\mathbf M) = a^3\det\mathbf M", True::Only(3)),
    (
        r"\det(\mathbf M\mathbf K) = \det\mathbf M\det\mathbf K",
        True::Always,
    ),
    (r"\det\mathbf M^T = \det\mathbf M", True::Always),
    (r"\det\mathbf G = 0", True::Odd),
    (r"\operatorname{tr}\mathbf E = 2", True::Only(2)),
    (r"\operatorname{tr}\mathbf E = f", True::Always),
    (r"\operatorname{tr}\mathbf E = 4", True::Only(4)),
    (
        r"\operatorname{tr}(\mathbf M\mathbf K) = \operatorname{tr}(\mathbf K\mathbf M)",
        True::Always,
    ),
    (r"\operatorname{tr}\mathbf G = 0", True::Always),
    (
        r"\mathbf M^2 - (\operatorname{tr}\mathbf M)\mathbf M + (\det\mathbf M)\mathbf E = \mathbf 0",
        True::Only(2),
    ),
    (
        r"(\mathbf M\mathbf K)^T = \mathbf K^T\mathbf M^T",
        True::Always,
    ),
    (
        r"(\mathbf M\mathbf K)^T = \mathbf M^T\mathbf K^T",
        True::Never,
    ),
    (r"\mathbf M\mathbf K = \mathbf K\mathbf M", True::Never),
    (
        r"\mathbf S^T\mathbf M = (\mathbf M^T\mathbf S)^T",
        True::Always,
    ),
    (r"\mathbf x^T\mathbf G\mathbf x = 0", True::Always),
    (
        r"\mathbf x^T\mathbf M\mathbf x = \mathbf x^T\mathbf M^T\mathbf x",
        True::Always,
    ),
    (
        r"\mathbf x^T\mathbf M\mathbf x = \frac{1}{2}\mathbf x^T(\mathbf M + \mathbf M^T)\mathbf x",
        True::Always,
    ),
    (
        r"\mathbf x^T\mathbf M\mathbf x = \mathbf x^T(\mathbf M + \mathbf M^T)\mathbf x",
        True::Never,
    ),
    (
        r"(\mathbf M + \mathbf K)^2 = \mathbf M^2 + \mathbf M\mathbf K + \mathbf K\mathbf M + \mathbf K^2",
        True::Always,
    ),
    (
        r"(\mathbf M + \mathbf K)^2 = \mathbf M^2 + 2\mathbf M\mathbf K + \mathbf K^2",
        True::Never,
    ),
    (r"\mathbf M\mathbf E = \mathbf M", True::Always),
    (r"f = 2", True::Only(2)),
    (r"f^2 - 5f + 6 = 0", True::TwoOrThree),
    (r"(f - 2)(f - 4) = 0", True::Even),
    (r"\sum_{k=1}^{f} k = \frac{f(f+1)}{2}", True::Always),
    (r"\sum_{k=1}^{f} k = f + 1", True::Only(2)),
    (
        r"\det(\mathbf E + \mathbf M) = 1 + \operatorname{tr}\mathbf M + \det\mathbf M",
        True::Only(2),
    ),
];

/// What a verdict says of all sizes, and of the sizes that it names.
fn judge(claim: &str, truth: True, sizes: &[usize], wrong: &mut Vec<String>) -> usize {
    let list: Vec<String> = sizes.iter().map(ToString::to_string).collect();
    let text = format!(
        r#"```toml document
instances = {{ f = [{}] }}
```
```toml symbols
a = {{ }}
b = {{ positive = true }}
'\mathbf{{M}}' = {{ shape = ["f", "f"] }}
'\mathbf{{K}}' = {{ shape = ["f", "f"] }}
'\mathbf{{S}}' = {{ shape = ["f", "f"], symmetric = true }}
'\mathbf{{G}}' = {{ shape = ["f", "f"], skew = true }}
'\mathbf{{x}}' = {{ shape = ["f", 1] }}
```
```toml notation
'\mathbf{{E}}' = {{ identity = "f" }}
'\mathbf{{0}}' = {{ zero = true }}
```
```math 1 claim
{claim}
```
"#,
        list.join(", ")
    );
    let options = Options {
        repair: false,
        ..Options::default()
    };
    let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
    let outcome = &audit.outcomes[0];
    let word = outcome.verdict.word();
    let said: Vec<usize> = match &outcome.sizes {
        Some(only) => only
            .iter()
            .map(|i| audit.model.instances[*i]["f"])
            .collect(),
        None => Vec::new(),
    };
    let right = match word {
        VerdictWord::Undecided => return 0,
        VerdictWord::Holds | VerdictWord::HoldsGiven if outcome.sizes.is_none() => {
            truth == True::Always
        }
        // What is seen at some sizes names them, an odd and an even one among them.
        VerdictWord::Holds | VerdictWord::HoldsGiven => {
            said.iter().all(|f| truth.at(*f))
                && said.iter().any(|f| f.is_multiple_of(2))
                && said.iter().any(|f| !f.is_multiple_of(2))
        }
        VerdictWord::Refuted | VerdictWord::Misprint => !sizes.iter().all(|f| truth.at(*f)),
        VerdictWord::Definition | VerdictWord::Recalled | VerdictWord::Loose => false,
    };
    if !right {
        wrong.push(format!("{claim}, f in {sizes:?}: {word} for {said:?}"));
    }
    1
}

#[test]
fn one_size_proves_nothing_of_the_others() {
    let mut wrong = Vec::new();
    let (mut all, mut decided) = (0, 0);
    for sizes in [&[2][..], &[3], &[2, 3], &[1, 2], &[1, 3], &[2, 3, 4]] {
        for (claim, truth) in CLAIMS {
            all += 1;
            decided += judge(claim, *truth, sizes, &mut wrong);
        }
    }
    // The same behind factors and on both sides.
    for (claim, truth) in CLAIMS {
        let (left, right) = claim.split_once(" = ").expect("an equation");
        all += 1;
        decided += judge(&format!("b({left}) = b({right})"), *truth, &[2], &mut wrong);
    }
    assert!(wrong.is_empty(), "{} of {all}: {wrong:#?}", wrong.len());
    assert!(all >= 200 && 2 * decided >= all, "{decided} of {all}");
}
