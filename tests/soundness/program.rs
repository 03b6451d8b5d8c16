//! The verdicts of a program that prints them with `check --json`: another version of this one.

use super::generator::Claim;
use super::judge::Said;
use rederive::document::VerdictWord;
use std::path::Path;
use std::process::Command;

/// What is said of each link of some claims, or why there is nothing.
pub fn by_program(
    text: &str,
    program: &Path,
    folder: &Path,
    claims: &[&Claim],
) -> Result<Vec<Vec<Said>>, Said> {
    let label = claims.first().map_or("none", |c| c.label.as_str());
    let thread = format!("{:?}", std::thread::current().id()).replace(['(', ')'], "");
    let path = folder.join(format!("{label}-{thread}.md"));
    std::fs::create_dir_all(folder).expect("a folder");
    std::fs::write(&path, text).expect("a file");
    // A limit of work and not of time: the machine may be busy.
    let seconds = if claims.len() > 1 { 8 } else { 3 };
    let output = Command::new("sh")
        .args([
            "-c",
            &format!("ulimit -t {seconds}; exec \"$0\" check --json \"$1\""),
        ])
        .arg(program)
        .arg(&path)
        .output()
        .expect("the program runs");
    // What takes long is its search for a correction of what it has refuted.
    if output.status.code().is_none() && claims.len() == 1 {
        let refuted = Said::Word(VerdictWord::Refuted);
        return Ok(vec![vec![refuted; claims[0].truth.len()]]);
    }
    let Ok(found) = serde_json::from_slice::<serde_json::Value>(&output.stdout) else {
        return Err(Said::Refused);
    };
    let list = |key: &str| found[key].as_array().cloned().unwrap_or_default();
    let equations = list("claims");
    let statements = list("statements");
    if equations.is_empty() && statements.is_empty() {
        return Err(Said::Refused);
    }
    let word = |value: &serde_json::Value| {
        let word = value["verdict"].as_str().unwrap_or_default();
        let all = VerdictWord::ALL.iter();
        let found = all.copied().find(|w| w.to_string() == word);
        match found {
            Some(VerdictWord::HoldsGiven) => Said::HoldsGiven(None),
            Some(word) => Said::Word(word),
            None => Said::Refused,
        }
    };
    Ok(claims
        .iter()
        .map(|claim| {
            let links = equations
                .iter()
                .filter(|c| c["equation"] == claim.label.as_str());
            let skipped = if claim.last {
                links.count().saturating_sub(1)
            } else {
                0
            };
            (1 + skipped..=claim.truth.len() + skipped)
                .map(|member| {
                    let of_equation = equations
                        .iter()
                        .find(|c| c["equation"] == claim.label.as_str() && c["member"] == member);
                    let of_statement = statements
                        .iter()
                        .find(|c| c["statement"] == claim.label.as_str() && c["member"] == member);
                    of_equation.or(of_statement).map_or(Said::Refused, word)
                })
                .collect()
        })
        .collect())
}
