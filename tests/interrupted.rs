//! What is finished when somebody asks to stop keeps its verdict. This test has a process of its own: nothing takes
//! the wish back.

use ratpoly::allowance;
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::{Document, VerdictWord};
use rederive::verdict::{Ended, Verdict};

#[test]
fn what_was_found_before_stays_found() {
    let text = "```toml symbols\na = {}\nb = {}\n```\n\
        ```math 1 claim\n(a + b)^2 = a^2 + 2ab + b^2\n```\n\
        ```math 2 claim\n(a + b)^2 = a^2 + 3ab + b^2\n```\n\
        ```math 3 claim\n(a - b)^2 = a^2 - 2ab + b^2\n```\n";
    let document = Document::parse("test.md", text).expect("a document");
    // False as printed: the search for a correction would be next.
    let tell = |_: &_, _: rederive::check::Told<'_>| allowance::interrupt();
    let audit = Audit::telling(&document, Options::default(), &tell).expect("an audit");
    let verdicts: Vec<&Verdict> = audit.outcomes.iter().map(|o| &o.verdict).collect();
    assert_eq!(verdicts[0].word(), VerdictWord::Holds);
    match verdicts[1] {
        Verdict::Refuted(refutation) => {
            let searched = refutation.searched.expect("what was searched");
            assert_eq!(searched.ended, Some(Ended::Interrupted));
        }
        other => panic!("{:?}", other.word()),
    }
    match verdicts[2] {
        Verdict::Undecided { reason } => assert_eq!(reason, "interrupted"),
        other => panic!("{:?}", other.word()),
    }
}
