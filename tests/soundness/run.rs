//! The run over all templates: so many claims, drawn with a printed seed; no false verdict, and not
//! fewer decided than there were.
//!
//! `REDERIVE_SOUNDNESS` is the number of claims and `REDERIVE_SOUNDNESS_SEED` the seed;
//! `REDERIVE_SOUNDNESS_ONLY` is a part of the names of the templates, `REDERIVE_SOUNDNESS_PROGRAM` a program
//! that is judged instead of this library, and `REDERIVE_SOUNDNESS_FINDINGS` a folder for a document of
//! each false verdict.

use super::generator::{Claim, Kind, Template, Truth};
use super::judge::{Judge, Said, fault, is_decided, said};
use super::random::Random;
use super::templates;
use rederive::document::VerdictWord;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How many claims without `REDERIVE_SOUNDNESS`.
const CLAIMS: usize = 2000;
/// The seed without `REDERIVE_SOUNDNESS_SEED`.
const SEED: u64 = 12;
/// How many claims stand in one document.
const TOGETHER: usize = 20;
/// The templates with a known fault, which must fail until they are mended.
const KNOWN: &str = include_str!("known_wrong.txt");
/// Which shares an earlier program decided, and rightly.
const SHARES: &str = include_str!("../golden/soundness.txt");

/// What became of the claims of a template.
#[derive(Default)]
pub struct Tally {
    pub claims: usize,
    /// Decided, and rightly.
    pub right: usize,
    pub faults: Vec<Fault>,
    /// Examples of what is left open.
    pub open: Vec<String>,
}

/// A false verdict.
pub struct Fault {
    pub what: &'static str,
    pub said: Said,
    pub truth: Truth,
    pub shown: String,
    /// A document that shows it.
    pub document: String,
}

impl Tally {
    fn share(&self) -> f64 {
        self.right as f64 / (self.claims.max(1)) as f64
    }
}

fn number(variable: &str, unless: u64) -> u64 {
    let told = std::env::var(variable).ok();
    told.map_or(unless, |n| {
        n.parse()
            .unwrap_or_else(|_| panic!("{variable} is a number"))
    })
}

/// Judges so many claims of the templates with a part of their name.
pub fn run(
    judge: Option<Judge>,
    claims: usize,
    seed: u64,
    only: &str,
) -> BTreeMap<&'static str, Tally> {
    let templates: Vec<&Template> = templates::all().filter(|t| t.name.contains(only)).collect();
    let each = claims.div_ceil(templates.len().max(1));
    struct Job {
        template: &'static Template,
        claims: Vec<Claim>,
        /// Every third document is searched for corrections too.
        repair: bool,
    }
    let mut jobs = Vec::new();
    for template in templates {
        let mut random = Random::new(seed, template.name);
        let mut made = 0;
        let mut documents = 0;
        while made < each {
            let mut together = Vec::new();
            for k in 0..TOGETHER.min(each - made) {
                together.push((template.make)(&mut random, &format!("c{}", made + k)));
            }
            made += together.len();
            let (alone, shared): (Vec<Claim>, Vec<Claim>) =
                together.into_iter().partition(|c| c.header.is_some());
            for claims in alone.into_iter().map(|c| vec![c]).chain([shared]) {
                if claims.is_empty() {
                    continue;
                }
                documents += 1;
                jobs.push(Job {
                    template,
                    claims,
                    repair: documents % 3 == 1,
                });
            }
        }
    }
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<Option<Vec<Vec<Said>>>>> = Mutex::new(vec![None; jobs.len()]);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let k = next.fetch_add(1, Ordering::SeqCst);
                    let Some(job) = jobs.get(k) else { return };
                    let judge = judge
                        .clone()
                        .unwrap_or(Judge::Library { repair: job.repair });
                    let of: Vec<&Claim> = job.claims.iter().collect();
                    let said = said(&judge, header(job.template, &job.claims[0]), &of);
                    found.lock().expect("no panic")[k] = Some(said);
                }
            });
        }
    });
    let mut tallies: BTreeMap<&'static str, Tally> = BTreeMap::new();
    let found = found.into_inner().expect("no panic");
    for (job, said) in jobs.iter().zip(found) {
        let tally = tallies.entry(job.template.name).or_default();
        for (claim, said) in job.claims.iter().zip(said.expect("judged")) {
            for (truth, said) in claim.truth.iter().zip(said) {
                let mended = said == Said::Word(VerdictWord::Misprint);
                tally.count(job.template, claim, *truth, said);
                // What comes after a misprint in a chain is judged with the correction.
                if mended {
                    break;
                }
            }
        }
    }
    tallies
}

fn header<'t>(template: &'t Template, claim: &'t Claim) -> &'t str {
    claim.header.as_deref().unwrap_or(template.header)
}

impl Tally {
    fn count(&mut self, template: &Template, claim: &Claim, truth: Truth, said: Said) {
        // What may be left open counts where it is decided only.
        let decided = is_decided(truth, &said);
        if let Some(what) = fault(truth, &said) {
            self.claims += 1;
            self.faults.push(Fault {
                what,
                said,
                truth,
                shown: claim.shown.clone(),
                document: format!("{}\n{}", header(template, claim), claim.text),
            });
        } else if decided {
            self.claims += 1;
            self.right += 1;
        } else if truth != Truth::Unforced {
            self.claims += 1;
            if self.open.len() < 12 {
                let own = claim.header.as_deref().unwrap_or_default();
                let around = own.rsplit("```\n").find(|piece| !piece.trim().is_empty());
                let around = around.unwrap_or_default().replace('\n', " ");
                self.open
                    .push(format!("{truth:?}, {said:?}: {} {around}", claim.shown));
            }
        }
    }
}

/// A table of names and whatever follows them.
fn lines(text: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let lines = text
        .lines()
        .filter(|l| !l.starts_with('#') && !l.is_empty());
    lines.map(|l| l.split_once(" | ").unwrap_or_else(|| panic!("{l}")))
}

fn floor(template: &Template) -> f64 {
    let old = lines(SHARES)
        .find(|(name, _)| *name == template.name)
        .map_or(0.0, |(_, share)| {
            let percent: f64 = share.trim().parse().expect("a share in percent");
            percent / 100.0
        });
    match template.kind {
        Kind::Rational => 1.0,
        Kind::Functions => old.max(0.9),
        Kind::Other => old,
    }
}

fn write_findings(folder: &Path, tallies: &BTreeMap<&'static str, Tally>) {
    for (name, tally) in tallies {
        if tally.faults.is_empty() {
            continue;
        }
        let mut text = format!(
            "# {name}: {} false of {} verdicts\n",
            tally.faults.len(),
            tally.claims
        );
        let mut kinds: BTreeMap<String, Vec<&Fault>> = BTreeMap::new();
        for fault in &tally.faults {
            kinds.entry(fault.what.to_string()).or_default().push(fault);
        }
        for (what, faults) in kinds {
            text += &format!("\n## {what} ({})\n\n", faults.len());
            for fault in faults.iter().take(10) {
                text += &format!(
                    "- is {:?}, said {:?}: {}\n",
                    fault.truth,
                    fault.said,
                    fault.shown.replace('\n', " ")
                );
            }
            let least = faults.iter().min_by_key(|f| f.document.len()).expect("one");
            text += &format!("\n````text\n{}\n````\n", least.document);
        }
        std::fs::create_dir_all(folder).expect("a folder");
        let path = folder.join(format!("{}.md", name.replace(['/', ' '], "-")));
        std::fs::write(path, text).expect("a file");
    }
}

#[test]
fn no_false_verdict_and_not_fewer_decided() {
    let claims = usize::try_from(number("REDERIVE_SOUNDNESS", CLAIMS as u64)).expect("a number");
    let seed = number("REDERIVE_SOUNDNESS_SEED", SEED);
    let only = std::env::var("REDERIVE_SOUNDNESS_ONLY").unwrap_or_default();
    let judge = std::env::var_os("REDERIVE_SOUNDNESS_PROGRAM").map(|path| Judge::Program {
        path: PathBuf::from(path),
        folder: Path::new(env!("CARGO_TARGET_TMPDIR")).join("soundness"),
    });
    let program = judge.is_some();
    let plain = only.is_empty() && !program && claims == CLAIMS && seed == SEED;
    println!("about {claims} claims, seed {seed}");
    let tallies = run(judge, claims, seed, &only);
    for (name, tally) in &tallies {
        println!(
            "{name} | {:.1} | {} claims, {} false verdicts",
            100.0 * tally.share(),
            tally.claims,
            tally.faults.len()
        );
        if std::env::var_os("REDERIVE_SOUNDNESS_OPEN").is_some() {
            for open in &tally.open {
                println!("      {open}");
            }
            for fault in tally.faults.iter().take(6) {
                println!("    ! {:?} {:?}: {}", fault.truth, fault.said, fault.shown);
            }
        }
    }
    if let Some(folder) = std::env::var_os("REDERIVE_SOUNDNESS_FINDINGS") {
        write_findings(Path::new(&folder), &tallies);
    }
    if program {
        return;
    }
    let wrong: BTreeSet<&str> = lines(KNOWN)
        .filter(|(_, what)| what.trim() == "wrong")
        .map(|(n, _)| n)
        .collect();
    let few: BTreeSet<&str> = lines(KNOWN)
        .filter(|(_, what)| what.trim() == "few")
        .map(|(n, _)| n)
        .collect();
    let mut complaints = Vec::new();
    for template in templates::all() {
        let Some(tally) = tallies.get(template.name) else {
            continue;
        };
        if !wrong.contains(template.name) {
            for fault in &tally.faults {
                complaints.push(format!(
                    "{}: {} (is {:?}, said {:?}): {}",
                    template.name, fault.what, fault.truth, fault.said, fault.shown
                ));
            }
        } else if plain && tally.faults.is_empty() {
            complaints.push(format!(
                "{}: is not wrong any more; take it out of known_wrong.txt",
                template.name
            ));
        }
        // Other claims than those of the table are decided about as often.
        let slack = if plain || template.kind == Kind::Rational {
            1e-3
        } else {
            0.15
        };
        let enough = tally.share() >= floor(template) - slack;
        if !enough && !few.contains(template.name) && !wrong.contains(template.name) {
            complaints.push(format!(
                "{}: {:.1} % decided in place of {:.1} %: {:?}",
                template.name,
                100.0 * tally.share(),
                100.0 * floor(template),
                tally.open
            ));
        }
        if plain && enough && few.contains(template.name) {
            complaints.push(format!(
                "{}: decides enough; take it out of known_wrong.txt",
                template.name
            ));
        }
    }
    assert!(
        complaints.is_empty(),
        "{} complaints:\n{}",
        complaints.len(),
        complaints.join("\n")
    );
}
