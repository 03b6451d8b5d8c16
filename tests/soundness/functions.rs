//! Functions: relations between exp, ln, powers, roots and angles; signs; distributions; cases and ranges;
//! integrals. True claims are made by putting random expressions into identities of tables and random
//! contexts around both sides; false ones by damage that shows in floating point at admitted points.

#[path = "functions/identities.rs"]
mod identities;
#[path = "functions/rows.rs"]
mod rows;
#[path = "functions/tree.rs"]
mod tree;

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::VerdictWord;

/// a, b, c are positive, x, y, z and p real; p has a negative reference value.
const LETTERS: &str = r#"```toml symbols
a = { positive = true, value = "2" }
b = { positive = true, value = "3" }
c = { positive = true, value = "5" }
x = { value = "1/2" }
y = { value = "-1/3" }
z = { value = "7/5" }
p = { value = "-2" }
q = { domain = "complex" }
h = { range = '0 < h < 1', value = "1/3" }
```

```toml notation
e = { constant = "e" }
j = { constant = "i" }
'\pi' = { constant = "pi" }
'\delta' = { dirac = true }
```

"#;

/// The verdicts on claims that stand in one document each of so many.
const TOGETHER: usize = 8;

fn verdicts(definitions: &str, claims: &[String]) -> Vec<VerdictWord> {
    let mut words = Vec::new();
    for part in claims.chunks(TOGETHER) {
        let mut text = format!("{LETTERS}{definitions}");
        for (k, claim) in part.iter().enumerate() {
            text += &format!("```math {} claim\n{claim}\n```\n\n", k + 1000);
        }
        let options = Options {
            repair: false,
            ..Options::default()
        };
        if std::env::var("SHOW_CLAIMS").is_ok() {
            println!("{}", part.join("\n"));
        }
        let audit: Audit =
            crate::common::audit(&text, options).unwrap_or_else(|r| panic!("{r}: {text}"));
        for k in 0..part.len() {
            let equation = audit
                .model
                .equation(&(k + 1000).to_string())
                .expect("the claim");
            let outcome = audit.outcomes_of(equation).last().expect("a link");
            words.push(outcome.verdict.word());
        }
    }
    words
}

/// What became of claims of known truth.
struct Tally {
    total: usize,
    decided: usize,
    wrong: Vec<String>,
    open: Vec<String>,
}

fn tally(definitions: &str, claims: &[(String, bool)]) -> Tally {
    let texts: Vec<String> = claims.iter().map(|(c, _)| c.clone()).collect();
    let words = verdicts(definitions, &texts);
    let mut tally = Tally {
        total: claims.len(),
        decided: 0,
        wrong: Vec::new(),
        open: Vec::new(),
    };
    for ((claim, truth), word) in claims.iter().zip(words) {
        let right = match word {
            VerdictWord::Holds => *truth,
            VerdictWord::Refuted | VerdictWord::Misprint => !*truth,
            VerdictWord::Undecided => {
                tally.open.push(claim.clone());
                continue;
            }
            other => {
                tally.wrong.push(format!("{claim}: {other:?}"));
                continue;
            }
        };
        if right {
            tally.decided += 1;
        } else {
            tally.wrong.push(format!("{claim}: {word:?}"));
        }
    }
    tally
}

impl Tally {
    /// Nothing is wrong, and at least so many of a hundred are decided.
    fn expect(&self, row: &str, share: usize) {
        println!(
            "{row}: {} claims, {} decided, {} wrong",
            self.total,
            self.decided,
            self.wrong.len()
        );
        for open in &self.open {
            println!("  open: {open}");
        }
        assert!(
            self.wrong.is_empty(),
            "{row}: {} wrong\n{}",
            self.wrong.len(),
            self.wrong.join("\n")
        );
        assert!(
            100 * self.decided >= share * self.total,
            "{row}: only {} of {} decided",
            self.decided,
            self.total
        );
    }
}
