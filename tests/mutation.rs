//! The checker is worth what it rejects: damaged equations do not pass, equivalent ones are not
//! refuted, and checkers that are blind in one way or another are caught by the very figures that
//! the program publishes.

use rederive::audit::Audit;
use rederive::check;
use rederive::document::{Document, VerdictWord};
use rederive::expr::walk::children_mut;
use rederive::expr::{Display, Expr, ExprKind, Sign};
use rederive::input;
use rederive::model::links::Place;
use rederive::mutation::tally::{Tally, kepts, tally};
use rederive::mutation::{
    Case, Class, Decide, Equivalence, Fate, Finding, Kept, Mutation, Options, Rewriting,
    TheChecker, Tried, mutate, mutate_by,
};
use rederive::progress::{Unwatched, Watch};
use rederive::report::mutation::{json, plain};
use rederive::verdict::EditClass;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// A lens, with every kind of place an edit can be in, and a definition that nothing tells apart.
const LENS: &str = r#"
```toml symbols
f = { unit = "m", positive = true, value = "1/20", meaning = "focal length" }
g = { unit = "m", positive = true, value = "1/5",  meaning = "distance of the object" }
```
```math 1 define
b = \frac{fg}{g - f}
```
```math 2 claim
\frac{1}{f} = \frac{1}{g} + \frac{1}{b}
```
```math 3 claim
(g - f)(b - f) = f^2
```
```math 4 claim
2b(g - f) = 2fg = fg + gf
```
```math 5 define
h = 3f
```
```math 6 claim
b(g - f) - fg = 0
```
"#;

fn document(text: &str) -> Document {
    Document::parse("small.md", text).unwrap_or_else(|diagnostics| panic!("{diagnostics:?}"))
}

fn read(path: &str) -> Document {
    Document::read(&Path::new(ROOT).join(path)).unwrap_or_else(|rejection| panic!("{rejection}"))
}

fn options() -> Options {
    Options {
        repairs: Some(0),
        ..Options::default()
    }
}

fn mutation(text: &str) -> Mutation {
    mutate(&document(text), &options(), &Unwatched)
        .unwrap_or_else(|rejection| panic!("{rejection}"))
}

fn total(mutation: &Mutation) -> Tally {
    tally([mutation]).0
}

/// What is wrong with the figures of a checker: nothing, if it is sound and sees.
fn faults(mutation: &Mutation) -> Vec<String> {
    let told = |tried: &Tried| format!("({}.{}) {}", tried.label, tried.member, tried.mutant);
    let faults = mutation.tried.iter().filter(|tried| {
        let alarm = matches!(
            tried.fate,
            Fate::Refuted {
                false_alarm: true,
                ..
            }
        );
        alarm || tried.fate == Fate::Survived
    });
    let rejected = mutation
        .rewritten
        .iter()
        .filter_map(|said| match &said.kept {
            Kept::Rejected(why) => {
                let (label, member, kind) = (&said.label, said.member, said.rewriting.as_str());
                Some(format!(
                    "({label}.{member}) {kind}: {}: {why}",
                    said.rewritten
                ))
            }
            Kept::Accepted | Kept::Undecided(_) => None,
        });
    faults.map(told).chain(rejected).collect()
}

#[test]
fn the_lens_refutes_what_is_not_equivalent() {
    let mutation = mutation(LENS);
    assert_eq!(faults(&mutation), Vec::<String>::new());
    assert_eq!(mutation.left_out, Vec::new());
    let total = total(&mutation);
    assert_eq!(total.mutants, mutation.possible);
    assert_eq!(
        total.mutants,
        total.refuted + total.equivalent + total.undecided + total.survived
    );
    assert!(total.refuted > 50 && total.equivalent > 0, "{total:?}");
    // (5) is used nowhere: what it says is never called refuted.
    for tried in mutation.tried.iter().filter(|t| t.label == "5") {
        let pass = matches!(
            tried.fate,
            Fate::Undecided(_) | Fate::Meaningless { .. } | Fate::Equivalent(_)
        );
        assert!(pass, "{tried:?}");
    }
    // A damaged definition is refuted by a claim that depends on it.
    let sign = mutation
        .tried
        .iter()
        .find(|t| t.label == "1" && t.class == EditClass::Sign && t.to.contains("g + f"))
        .expect("the sign in the definition");
    assert!(
        matches!(&sign.fate, Fate::Refuted { by, .. } if by.0 != "1"),
        "{:?}",
        sign.fate
    );
}

/// A sample of each document inside the program; `rederive mutate` tries all.
#[test]
fn no_mutant_of_the_papers_survives() {
    for input in input::read::<&str>(&[]) {
        let document = input.unwrap_or_else(|rejection| panic!("{rejection}"));
        let options = Options {
            limit: Some(8),
            ..options()
        };
        let mutation = mutate(&document, &options, &Unwatched)
            .unwrap_or_else(|rejection| panic!("{rejection}"));
        assert_eq!(faults(&mutation), Vec::<String>::new(), "{}", document.name);
        let total = total(&mutation);
        assert!(total.refuted > 0 || total.mutants == 0, "{}", document.name);
    }
}

/// The values that are kept from the undamaged document, and the equation put in place of another,
/// give what the program says of the damaged text itself.
#[test]
fn the_damaged_text_has_the_same_verdicts() {
    let documents = [
        (document(LENS), 400),
        (read("proofs/schiehlen-2006/nonlinear-example.md"), 12),
        (read("proofs/schiehlen-2006/variance-integral.md"), 12),
        (read("proofs/schiehlen-2006/multibody.md"), 8),
        (read("proofs/schiehlen-2006/quarter-car-filter-1.md"), 8),
    ];
    for (document, limit) in documents {
        let options = Options {
            limit: Some(limit),
            seed: 5,
            ..options()
        };
        let mutation = mutate(&document, &options, &Unwatched)
            .unwrap_or_else(|rejection| panic!("{rejection}"));
        let sound = words(&document).expect("a document that can be checked");
        // A misprint is refuted with and without another edit.
        let misprinted = |label: &str| {
            let false_word =
                |w: VerdictWord| matches!(w, VerdictWord::Refuted | VerdictWord::Misprint);
            let mut links = sound.iter();
            links.any(|(l, w)| l.starts_with(&format!("{label}.")) && false_word(*w))
        };
        for tried in mutation.tried.iter().filter(|t| !misprinted(&t.label)) {
            let equation = document
                .equations
                .iter()
                .find(|e| e.label.text == tried.label)
                .expect("the equation");
            let mut text = document.text.clone();
            let (start, end) = (equation.body.span.start, equation.body.span.end);
            text.replace_range(start..end, &format!("{}\n", tried.mutant));
            let damaged = Document::parse(&document.name, &text)
                .ok()
                .and_then(|d| words(&d));
            let rejected = match &damaged {
                None => true,
                Some(damaged) => damaged.iter().any(|(link, word)| {
                    let before = sound.iter().find(|(l, _)| l == link).map(|(_, w)| *w);
                    let is =
                        |w: VerdictWord| matches!(w, VerdictWord::Refuted | VerdictWord::Misprint);
                    is(*word) && before.is_none_or(|before| !is(before))
                }),
            };
            match &tried.fate {
                Fate::Refuted { .. } => assert!(rejected, "{}: {tried:?}", document.name),
                // What has no value is refused, refuted, left undecided, or the definition of another
                // name than the document has.
                Fate::Meaningless { .. } => {
                    let no_claim = damaged.is_some_and(|damaged| {
                        let mut links = damaged.iter().zip(&sound);
                        links.any(|((_, word), (_, before))| {
                            let silent =
                                matches!(word, VerdictWord::Undecided | VerdictWord::Definition);
                            silent && word != before
                        })
                    });
                    assert!(rejected || no_claim, "{}: {tried:?}", document.name);
                }
                // In print a matrix at what is none of its arguments is a product.
                Fate::Undecided(why) if why.starts_with("a function at another argument") => {}
                Fate::Equivalent(_) | Fate::Undecided(_) | Fate::Survived => {
                    assert!(!rejected, "{}: {tried:?}", document.name);
                }
            }
        }
    }
}

/// The verdicts without the search for corrections; none where the document is refused.
fn words(document: &Document) -> Option<Vec<(String, VerdictWord)>> {
    let options = check::Options {
        repair: false,
        ..check::Options::default()
    };
    let audit = Audit::of(document, options).ok()?;
    let words = audit.outcomes.iter().map(|o| {
        let label = &audit.model.equations[o.equation].label;
        (format!("{label}.{}", o.member), o.verdict.word())
    });
    Some(words.collect())
}

/// Judges that do not look.
struct Always(Finding);

impl Decide for Always {
    fn decide(&self, _: &Case<'_>, _: &mut dyn FnMut() -> Finding) -> Finding {
        self.0.clone()
    }
}

/// A checker that takes two equations for the same if they are so once something is erased.
struct Blind(fn(&mut Expr));

impl Decide for Blind {
    fn decide(&self, case: &Case<'_>, checker: &mut dyn FnMut() -> Finding) -> Finding {
        let seen = |display: &Display| {
            let mut display = display.clone();
            for clause in 0..display.clauses.len() {
                for member in 0..display.clauses[clause].chain.members.len() {
                    if let Some(expr) = (Place::Member { clause, member }).find_mut(&mut display) {
                        erase(expr, self.0);
                    }
                }
            }
            display
        };
        if seen(case.original) == seen(case.changed) {
            Finding::Accepted
        } else {
            checker()
        }
    }
}

fn erase(expr: &mut Expr, what: fn(&mut Expr)) {
    for child in children_mut(expr) {
        erase(child, what);
    }
    what(expr);
}

fn signs(expr: &mut Expr) {
    if let ExprKind::Sum(terms) = &mut expr.kind {
        for (sign, _) in terms {
            *sign = Sign::Plus;
        }
    }
    if let ExprKind::Sum(terms) = &expr.kind
        && let [(_, only)] = terms.as_slice()
    {
        expr.kind = only.kind.clone();
    }
}

fn exponents(expr: &mut Expr) {
    if let ExprKind::Power { base, .. } = &expr.kind {
        expr.kind = base.kind.clone();
    }
}

#[test]
fn blind_checkers_are_caught() {
    let judged = |decide: &dyn Decide| {
        mutate_by(&document(LENS), &options(), decide, &Unwatched)
            .unwrap_or_else(|rejection| panic!("{rejection}"))
    };
    let sound = judged(&TheChecker);
    assert_eq!(faults(&sound), Vec::<String>::new());

    let accepting = judged(&Always(Finding::Accepted));
    let refuted = |m: &Mutation, claim: bool| {
        let of_claims = m.tried.iter().filter(|t| t.definition != claim);
        of_claims
            .filter(|t| matches!(t.fate, Fate::Refuted { .. }))
            .count()
    };
    assert!(total(&accepting).survived >= refuted(&sound, true));
    // What a definition hides from such a checker is at least no pass.
    assert!(total(&accepting).undecided > total(&sound).undecided);

    let rejecting = judged(&Always(Finding::Refuted));
    assert!(total(&rejecting).false_alarms > 0 && total(&sound).equivalent > 0);
    let shrugging = judged(&Always(Finding::Undecided("who knows".into())));
    assert_eq!(total(&shrugging).refuted, total(&shrugging).meaningless);
    assert!(total(&shrugging).undecided > total(&sound).undecided);

    for (blind, class) in [
        (Blind(signs), EditClass::Sign),
        (Blind(exponents), EditClass::Exponent),
    ] {
        let mutation = judged(&blind);
        let survived = mutation.tried.iter().filter(|t| t.fate == Fate::Survived);
        // The sign of an exponent is a slip of both kinds.
        let both = |t: &&Tried| t.class == EditClass::Exponent && t.mutant.contains("^{-");
        let classes: Vec<EditClass> = survived
            .filter(|t| t.class == class || !both(t))
            .map(|t| t.class)
            .collect();
        assert!(classes.contains(&class), "{class:?}");
        assert!(classes.iter().all(|c| *c == class), "{classes:?}");
    }
}

/// Chains, sums of several kinds, inequalities: every rewriting occurs, and nothing true is rejected.
const REWRITTEN: &str = r#"
```toml symbols
a = { unit = "m", positive = true, value = "2", meaning = "" }
b = { unit = "m", positive = true, value = "3", meaning = "" }
x = { unit = "m", meaning = "" }
```
```math 1 define
s = a(b + x)
```
```math 2 claim
s = ab + ax = ab + xa
```
```math 3 claim
(a + x)^2 - 2ax = a^2 + x^2
```
```math 4 claim
a^2 + (x - b)^2 > 0
```
```math 5 claim
\frac{a + b}{ab} = \frac{1}{a} + \frac{1}{b}
```
```math 6 claim
\cos^2(x/a) + \sin^2(x/a) = 1
```
```math 7 claim
\begin{bmatrix} a & x \\ 0 & b \end{bmatrix} \begin{bmatrix} b \\ x \end{bmatrix} =
\begin{bmatrix} ab + x^2 \\ bx \end{bmatrix}
```
"#;

#[test]
fn what_says_the_same_keeps_its_verdict() {
    for text in [REWRITTEN, LENS] {
        let mutation = mutation(text);
        assert_eq!(faults(&mutation), Vec::<String>::new());
        assert_eq!(mutation.rewritten.len(), mutation.possible_rewritings);
        let mut undecided = mutation.rewritten.iter();
        assert_eq!(undecided.find(|said| said.kept != Kept::Accepted), None);
    }
    let mutation = mutation(REWRITTEN);
    let (_, by_kind) = kepts([&mutation]);
    for kind in Rewriting::ALL {
        assert!(by_kind.contains_key(&kind), "{}", kind.as_str());
    }
}

/// A checker that takes everything for false that is not printed as before.
struct Literal;

impl Decide for Literal {
    fn decide(&self, case: &Case<'_>, checker: &mut dyn FnMut() -> Finding) -> Finding {
        if case.original == case.changed {
            checker()
        } else {
            Finding::Refuted
        }
    }
}

/// One that cannot see through a definition.
struct NoDefinitions;

impl Decide for NoDefinitions {
    fn decide(&self, case: &Case<'_>, checker: &mut dyn FnMut() -> Finding) -> Finding {
        match case.class {
            Class::Rewriting(Rewriting::InsertDefinition | Rewriting::ScaleUnit) => {
                Finding::Refuted
            }
            Class::Rewriting(_) | Class::Edit(_) => checker(),
        }
    }
}

#[test]
fn checkers_that_reject_what_says_the_same_are_caught() {
    let judged = |decide: &dyn Decide| {
        mutate_by(&document(REWRITTEN), &options(), decide, &Unwatched)
            .unwrap_or_else(|rejection| panic!("{rejection}"))
    };
    let rejecting = judged(&Always(Finding::Refuted));
    let (all, _) = kepts([&rejecting]);
    assert!(
        all.rejected > 50 && all.rejected == all.rewritings,
        "{all:?}"
    );
    // It refutes every mutant, which alone would look well.
    let literal = judged(&Literal);
    assert_eq!(total(&literal).survived, 0);
    assert_eq!(kepts([&literal]).0.rejected, all.rewritings);
    let shrugging = judged(&Always(Finding::Undecided("who knows".into())));
    let (undecided, _) = kepts([&shrugging]);
    assert_eq!((undecided.accepted, undecided.rejected), (0, 0));
    let blind = judged(&NoDefinitions);
    let (_, by_kind) = kepts([&blind]);
    for (kind, kepts) in by_kind {
        let caught = matches!(kind, Rewriting::InsertDefinition | Rewriting::ScaleUnit);
        assert_eq!(kepts.rejected > 0, caught, "{kind:?}");
    }
}

#[test]
fn the_same_figures_from_any_number_of_threads() {
    let document = read("proofs/schiehlen-2006/variance-integral.md");
    let run = |threads| {
        let options = Options {
            threads,
            limit: Some(30),
            repairs: Some(3),
            ..Options::default()
        };
        mutate(&document, &options, &Unwatched).unwrap_or_else(|rejection| panic!("{rejection}"))
    };
    let (one, two) = (run(1), run(2));
    assert_eq!(one, two);
    assert_eq!(plain(&one), plain(&run(3)));
}

#[test]
fn a_seed_draws_its_own_sample() {
    let drawn = |seed, limit| {
        let options = Options {
            seed,
            limit: Some(limit),
            ..options()
        };
        let mutation = mutate(&document(LENS), &options, &Unwatched)
            .unwrap_or_else(|rejection| panic!("{rejection}"));
        assert_eq!(mutation.seed, seed);
        mutation.tried
    };
    assert_eq!(drawn(1, 10).len(), 10);
    assert_eq!(drawn(1, 10), drawn(1, 10));
    assert_ne!(drawn(1, 10), drawn(2, 10));
    assert_eq!(drawn(1, 0), Vec::new());
    assert_eq!(drawn(1, 100_000).len(), mutation(LENS).possible);
}

#[test]
fn the_search_finds_its_way_back() {
    let options = Options {
        repairs: Some(12),
        ..Options::default()
    };
    let mutation = mutate(&document(LENS), &options, &Unwatched)
        .unwrap_or_else(|rejection| panic!("{rejection}"));
    let total = total(&mutation);
    assert_eq!(total.repairs_tried, 12);
    assert!(total.repaired_first <= total.repaired_any);
    assert!(total.repaired_any <= total.repairs_tried);
    assert!(total.repaired_first > 6, "{total:?}");
}

/// What is not true is not damaged: every mutant of it would be refuted for nothing.
#[test]
fn nothing_true_gives_nothing_to_count() {
    let nothing = mutation(
        "```toml symbols\nx = { meaning = \"\" }\n```\n```math 1 claim\nx = x^2 + 7x^5\n```\n",
    );
    assert_eq!(nothing.possible, 0);
    assert_eq!(nothing.left_out.len(), 1);
    assert!(plain(&nothing).contains("(1.1) false as it stands"));
    let symbols = mutation("```toml symbols\nx = { meaning = \"\" }\n```\n");
    assert_eq!((symbols.possible, symbols.left_out), (0, Vec::new()));
}

/// A misprint is mended first, and what is damaged is the mended equation.
#[test]
fn a_misprint_is_mended_before_it_is_damaged() {
    let misprint = LENS.replace("(g - f)(b - f) = f^2", "(g - f)(b - f) = f^3");
    let mended = mutation(&misprint);
    assert_eq!(mended.left_out, Vec::new());
    assert_eq!(faults(&mended), Vec::<String>::new());
    let sound = mutation(LENS);
    let three = |m: &Mutation| -> Vec<(String, Fate)> {
        let of = m.tried.iter().filter(|t| t.label == "3");
        of.map(|t| (t.mutant.clone(), t.fate.clone())).collect()
    };
    assert_eq!(three(&mended), three(&sound));
}

/// Stops after so many units.
struct Impatient(AtomicUsize);

impl Watch for Impatient {
    fn begin(&self, _: &str, _: usize) {}
    fn advance(&self) {
        self.0.fetch_add(1, Ordering::SeqCst);
    }
    fn end(&self) {}
    fn stop(&self) -> bool {
        self.0.load(Ordering::SeqCst) >= 7
    }
}

#[test]
fn an_interrupted_run_keeps_what_is_finished() {
    let watch = Impatient(AtomicUsize::new(0));
    let options = Options {
        threads: 1,
        ..options()
    };
    let mutation =
        mutate(&document(LENS), &options, &watch).unwrap_or_else(|rejection| panic!("{rejection}"));
    assert_eq!(mutation.tried.len(), 7);
    assert!(mutation.possible > 7);
    assert!(plain(&mutation).contains("7 of "));
}

fn rederive(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(arguments)
        .current_dir(ROOT)
        .output()
        .expect("the program runs")
}

fn file(name: &str, text: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutation");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(name);
    std::fs::write(&path, text).expect("a file");
    path.display().to_string()
}

#[test]
fn the_figures_for_programs() {
    let lens = file("lens.md", LENS);
    let arguments = ["mutate", "--json", "--repair", "5", "--limit", "60", &lens];
    let output = rederive(&arguments);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(output.stdout, rederive(&arguments).stdout);
    let figures: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let mut schemas = boon::Schemas::new();
    let mut compiler = boon::Compiler::new();
    let path = format!("{ROOT}/schemas/mutation.schema.json");
    let index = compiler.compile(&path, &mut schemas).expect("a schema");
    if let Err(error) = schemas.validate(&figures, index) {
        panic!("{error:#}");
    }
    let count = |key: &str| figures["total"][key].as_u64().expect("a number");
    assert_eq!(count("mutants"), 60);
    assert_eq!(
        count("mutants"),
        count("refuted") + count("equivalent") + count("undecided") + count("survived")
    );
    assert_eq!(figures["repairs_tried"], 5);
    assert_eq!(figures["survivors"], serde_json::json!([]));
    let rewritings = &figures["rewritings"];
    assert_eq!(rewritings["wrongly_rejected"], serde_json::json!([]));
    assert_eq!(rewritings["total"]["rewritings"], 60);
    let classes = figures["by_class"].as_object().expect("an object").values();
    let sum: u64 = classes.filter_map(|c| c["mutants"].as_u64()).sum();
    assert_eq!(sum, 60);
    assert_eq!(
        figures["equivalents"].as_array().map(Vec::len),
        usize::try_from(count("equivalent")).ok()
    );
}

#[test]
fn bad_input_has_its_exit_code() {
    let empty = file("empty.md", "");
    let open = file("open.md", "```math 1 claim\nx = (y\n```\n");
    for path in [&empty, &open] {
        let output = rederive(&["mutate", path]);
        assert_eq!(output.status.code(), Some(3), "{path}");
        assert!(!output.stderr.is_empty());
    }
    let lens = file("lens-2.md", LENS);
    for arguments in [
        ["mutate", "--repair", "many", &lens],
        ["mutate", "--limit", "-1", &lens],
        ["mutate", "--seed", "x", &lens],
    ] {
        assert_eq!(rederive(&arguments).status.code(), Some(3), "{arguments:?}");
    }
    let output = rederive(&["mutate", "--limit", "0", &lens]);
    assert_eq!(output.status.code(), Some(0));
    let none = String::from_utf8(output.stdout).expect("text");
    assert!(none.contains("0 of "), "{none}");
}

/// A document whose linear system has no small solution ends at a limit instead of the memory's.
#[test]
fn mutants_beyond_all_limits_are_undecided() {
    let letters: Vec<String> = (1..=9)
        .map(|k| format!("'x_{k}' = {{ meaning = \"\" }}\n'y_{k}' = {{ meaning = \"\" }}\n"))
        .collect();
    let matrix = |l: char| {
        let row = |r: usize| format!("{l}_{} & {l}_{} & {l}_{}", 3 * r + 1, 3 * r + 2, 3 * r + 3);
        format!(
            r"\begin{{bmatrix}} {} \\ {} \\ {} \end{{bmatrix}}",
            row(0),
            row(1),
            row(2)
        )
    };
    let text = format!(
        "```toml symbols\n{}```\n```math 1 define\n\\mathbf{{A}} = {}, \\quad \\mathbf{{B}} = {}\n```\n\
         ```math 2 solve \\mathbf{{X}}\n\\mathbf{{A}}\\mathbf{{X}}\\mathbf{{B}} + \
         \\mathbf{{B}}\\mathbf{{X}}\\mathbf{{A}} + \\mathbf{{X}} = \\mathbf{{A}}\n```\n",
        letters.concat(),
        matrix('x'),
        matrix('y')
    );
    let document = document(&text);
    let audit = Audit::of(&document, check::Options::default())
        .unwrap_or_else(|rejection| panic!("{rejection}"));
    let words: Vec<VerdictWord> = audit.outcomes.iter().map(|o| o.verdict.word()).collect();
    assert_eq!(words.last(), Some(&VerdictWord::Undecided));
    let figures = json::figures(&[], 1);
    assert!(serde_json::to_string(&figures).is_ok());
}

/// What mutants have found in the checker itself.
#[test]
fn faults_that_mutants_found_stay_mended() {
    let word = |text: &str, label: &str| {
        let link = format!("{label}.1");
        let words = words(&document(text)).expect("a document that can be checked");
        let found = words.iter().find(|(l, _)| *l == link);
        found.map(|(_, word)| *word).expect("the link")
    };
    // A bound of the eigenvalues other than zero was taken for zero.
    let eigenvalues = |bound: &str| {
        let text = format!(
            "```toml symbols\na = {{ positive = true, meaning = \"\" }}\n\
             '\\lambda' = {{ function_of = '\\mathbf{{A}}', meaning = \"\" }}\n```\n```math 1 define\n\
             \\mathbf{{A}} = \\begin{{bmatrix}} -a & 1 \\\\ 0 & -2a \\end{{bmatrix}}\n```\n\
             ```math 2 claim\n\\operatorname{{Re}}\\lambda(\\mathbf{{A}}) < {bound}\n```\n"
        );
        word(&text, "2")
    };
    for bound in ["0", "1", "a"] {
        assert_eq!(eigenvalues(bound), VerdictWord::Holds, "{bound}");
    }
    for bound in ["-1", "-a", "-2a"] {
        assert_eq!(eigenvalues(bound), VerdictWord::Refuted, "{bound}");
    }
    // A process at another argument was taken for the process.
    let process = |claim: &str| {
        let text = format!(
            "```toml symbols\nt = {{ meaning = \"\" }}\n\
             z = {{ function_of = \"t\", meaning = \"\" }}\n```\n\
             ```math 1 define\ns(t) = 2z(t)\n```\n```math 2 claim\n{claim}\n```\n"
        );
        word(&text, "2")
    };
    assert_eq!(process("s(t) = 2z(t)"), VerdictWord::Holds);
    assert_eq!(process("s(t^2) = 2z(t)"), VerdictWord::Undecided);
    assert_eq!(
        process("\\int_0^1 z(t)\\,dt = z(t)"),
        VerdictWord::Undecided
    );
}

/// An inequality with another bound may be true as well: it is proved, and holds at points.
#[test]
fn an_inequality_that_is_true_as_well_is_no_survivor() {
    let text = "```toml symbols\na = { positive = true, meaning = \"\" }\n```\n\
                ```math 1 claim\n2a + 1 > 0\n```\n";
    let sound = mutation(text);
    assert_eq!(faults(&sound), Vec::<String>::new());
    let count = |m: &Mutation, wanted: fn(&Fate) -> bool| {
        m.tried.iter().filter(|t| wanted(&t.fate)).count()
    };
    let as_well = |f: &Fate| matches!(f, Fate::Equivalent(Equivalence::TrueAsWell));
    let refuted = |f: &Fate| matches!(f, Fate::Refuted { .. });
    assert!(count(&sound, as_well) > 0 && count(&sound, refuted) > 0);
    let blind = mutate_by(
        &document(text),
        &options(),
        &Always(Finding::Accepted),
        &Unwatched,
    );
    let blind = blind.unwrap_or_else(|rejection| panic!("{rejection}"));
    assert!(total(&blind).survived >= count(&sound, refuted));
}

/// Twice what grows without bound grows without bound: true as well, and confirmed at points; what
/// stays finite is refuted.
#[test]
fn a_limit_that_is_true_as_well_is_no_survivor() {
    let mutation = mutation(
        r#"
```toml symbols
x = { positive = true, value = "1", meaning = "a wave number" }
c = { positive = true, value = "2", meaning = "a constant" }
```
```math 1 claim
\int_0^\infty \frac{c}{x^2} dx \to \infty
```
```math 2 claim
x \to 0, \quad \frac{c}{x} \to \infty
```
"#,
    );
    let tally = total(&mutation);
    assert_eq!(tally.survived, 0, "{:?}", faults(&mutation));
    assert!(tally.refuted > 10 && tally.equivalent > 10, "{tally:?}");
}
