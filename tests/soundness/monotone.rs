//! Orders of values of monotone functions: f(x) > f(y) and x > y say the same where f increases, the opposite
//! where it decreases, and nothing of each other where it does neither.

use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord;

/// What a function does where its argument is real, or where it is positive.
#[derive(Clone, Copy, PartialEq)]
enum Monotone {
    Increasing,
    Decreasing,
    Neither,
}

use Monotone::{Decreasing, Increasing, Neither};

/// The function of `X`, whether its argument has to be positive, and what it does.
const FUNCTIONS: [(&str, bool, Monotone); 18] = [
    (r"\sinh X", false, Increasing),
    (r"\tanh X", false, Increasing),
    (r"e^{X}", false, Increasing),
    (r"X^3", false, Increasing),
    (r"X^5 + X", false, Increasing),
    (r"2^{X}", false, Increasing),
    (r"\ln X", true, Increasing),
    (r"\sqrt{X}", true, Increasing),
    (r"X^2", true, Increasing),
    (r"\cosh X", true, Increasing),
    (r"X + \ln X", true, Increasing),
    (r"e^{-X}", false, Decreasing),
    (r"-\sinh X", false, Decreasing),
    (r"\frac{1}{X}", true, Decreasing),
    (r"-\ln X", true, Decreasing),
    (r"\cosh X", false, Neither),
    (r"X^2", false, Neither),
    (r"X^4 - X", false, Neither),
];

const ORDERS: [(&str, &str); 4] = [("<", ">"), (">", "<"), (r"\le", r"\ge"), (r"\ge", r"\le")];

const LETTERS: &str = "```toml symbols
x = {}
y = {}
a = { positive = true }
b = { positive = true }
```
```toml notation
e = { constant = \"e\" }
```
";

struct Claim {
    claimed: String,
    assumed: String,
    truth: bool,
}

/// Claims that follow from a hypothesis, and such that do not.
fn claims() -> Vec<Claim> {
    let mut claims = Vec::new();
    for (f, positive, kind) in FUNCTIONS {
        let [p, q] = if positive { ["a", "b"] } else { ["x", "y"] }.map(String::from);
        let values = [f.replace('X', &p), f.replace('X', &q)];
        let arguments = [p, q];
        for (order, opposite) in ORDERS {
            for (of, from) in [(&arguments, &values), (&values, &arguments)] {
                for (claimed, follows) in [(order, Increasing), (opposite, Decreasing)] {
                    claims.push(Claim {
                        claimed: format!("{} {claimed} {}", of[0], of[1]),
                        assumed: format!("{} {order} {}", from[0], from[1]),
                        truth: kind == follows,
                    });
                }
            }
        }
    }
    claims
}

#[test]
fn orders_of_values_are_those_of_arguments() {
    let claims = claims();
    assert!(claims.len() >= 200);
    let (mut decided, mut all) = ([0_usize; 2], [0_usize; 2]);
    let (mut wrong, mut open) = (Vec::new(), Vec::new());
    // Letters of functions are shared in a document.
    for part in claims.chunks(16) {
        let mut text = String::from(LETTERS);
        for (k, claim) in part.iter().enumerate() {
            let (claimed, assumed) = (&claim.claimed, &claim.assumed);
            text += &format!(
                "\n```math {k} claim\n{claimed}\n```\n```toml {k}\nassume = ['{assumed}']\n```\n"
            );
        }
        let options = Options {
            repair: false,
            ..Options::default()
        };
        let audit = audit(&text, options).unwrap_or_else(|r| panic!("{r}"));
        for (claim, outcome) in part.iter().zip(&audit.outcomes) {
            let said = match outcome.verdict.word() {
                VerdictWord::Holds => Some(true),
                VerdictWord::Refuted | VerdictWord::Misprint => Some(false),
                _ => None,
            };
            let words = format!("{}, given {}: {said:?}", claim.claimed, claim.assumed);
            all[usize::from(claim.truth)] += 1;
            match said {
                Some(said) if said == claim.truth => decided[usize::from(claim.truth)] += 1,
                Some(_) => wrong.push(words),
                None => open.push(words),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    println!("decided {decided:?} of {all:?}; open:\n{}", open.join("\n"));
    assert!(5 * decided[0] >= 4 * all[0] && 5 * decided[1] >= 4 * all[1]);
}
