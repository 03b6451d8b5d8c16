//! The documents of the project are well formed, and the format's own page says what is so.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::document::{Document, Predicate, Role, VerdictWord};
use std::path::{Path, PathBuf};

fn proofs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs")
}

fn read(path: &Path) -> Document {
    Document::read(path).unwrap_or_else(|rejection| panic!("{rejection}"))
}

fn format_page() -> String {
    std::fs::read_to_string(proofs().join("README.md")).unwrap()
}

/// The blocks between lines that begin with `fence` and the word, and the bare fence.
fn blocks(page: &str, fence: &str, word: &str) -> Vec<String> {
    let opening = format!("{fence}{word}\n");
    page.split(&opening)
        .skip(1)
        .map(|rest| {
            rest.split(&format!("\n{fence}\n"))
                .next()
                .unwrap()
                .to_owned()
                + "\n"
        })
        .collect()
}

fn parse(text: &str) -> Document {
    Document::parse("example.md", text).unwrap_or_else(|diagnostics| {
        let shown = rederive::diagnostic::render("example.md", text, &diagnostics, false);
        panic!("{shown}")
    })
}

#[test]
fn every_paper_is_well_formed() {
    let mut papers = 0;
    for folder in std::fs::read_dir(proofs()).unwrap().map(Result::unwrap) {
        if folder.file_type().unwrap().is_dir() {
            for file in std::fs::read_dir(folder.path()).unwrap() {
                let document = read(&file.unwrap().path());
                papers += 1;
                for number in document.announced_numbers() {
                    assert!(
                        document.equation(&number.to_string()).is_some(),
                        "{}: equation {number} is announced and missing",
                        document.name
                    );
                }
            }
        }
    }
    assert!(papers >= 2);
}

#[test]
fn the_quarter_car_has_every_equation_of_the_section() {
    let document = read(&proofs().join("schiehlen-2006/quarter-car.md"));
    assert!(document.announced_numbers().eq(45..=68));
    let recalled: Vec<_> = document
        .equations
        .iter()
        .filter(|equation| equation.role == Role::Recall)
        .map(|equation| &equation.label.text[..])
        .collect();
    assert_eq!(recalled, ["46", "57"], "what is not checked stays little");
    let numeric = document.numeric.unwrap();
    assert_eq!((numeric.samples, numeric.points.len()), (200, 11));
    assert!(
        numeric
            .ranges
            .iter()
            .map(|range| &range.name)
            .chain(
                numeric
                    .points
                    .iter()
                    .flat_map(|point| point.values.iter().map(|(name, _)| name))
            )
            .all(|name| document
                .symbols
                .iter()
                .any(|symbol| symbol.name.text == name.text))
    );
}

#[test]
fn the_example_of_the_format_page_is_a_document() {
    let examples = blocks(&format_page(), "````", "markdown");
    assert_eq!(examples.len(), 1);
    let document = parse(&examples[0]);
    assert!(document.announced_numbers().eq(1..=5));
    assert_eq!(document.equations.len(), 5);
    assert_eq!(document.statements.len(), 1);
}

#[test]
fn the_predicates_of_the_format_page_are_those_of_the_format() {
    let page = format_page();
    let table = page
        .split("| predicate | arguments | holds if |")
        .nth(1)
        .expect("the table");
    let rows = table
        .trim()
        .lines()
        .take_while(|line| line.starts_with('|'));
    let mut words: Vec<&str> = Vec::new();
    for row in rows.skip(1) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        words.extend(cells[1].split(", ").map(|word| word.trim_matches('`')));
    }
    let known = Predicate::ALL.map(Predicate::as_str);
    assert_eq!(words, known, "the table and the format");
}

#[test]
fn the_settings_of_a_statement_on_the_format_page_are_those_of_the_format() {
    let lines = blocks(&format_page(), "```", "text").remove(1);
    let letters = "```toml symbols\nm = { positive = true, value = \"1\" }\n```\n";
    let text = format!("{letters}```statement S\nAs printed.\n```\n```toml S\n{lines}\n```\n");
    let document = parse(&text);
    let meaning = document.statements[0].meaning.as_ref().expect("a meaning");
    assert_eq!((meaning.of.len(), meaning.letters.len()), (2, 2));
}

#[test]
fn the_conventions_of_the_format_page_are_those_of_the_format() {
    let page = format_page();
    let entries: Vec<&str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `'")?.split_once("` |"))
        .map(|(entry, _)| entry)
        .collect();
    assert_eq!(entries.len(), 12);
    for entry in entries {
        let text = format!("```toml notation\n'{entry}\n```\n");
        assert_eq!(parse(&text).notation.len(), 1, "{entry}");
    }
}

#[test]
fn the_settings_of_the_format_page_are_those_of_the_format() {
    let lines = blocks(&format_page(), "```", "text").remove(0);
    for line in lines.lines() {
        // The labels that the lines name.
        let others = ["label", "44", "58"].map(|l| format!("```math {l} claim\nx = y\n```\n"));
        let text = format!("```math 1 claim\nx = y\n```\n```toml 1\n{line}\n```\n");
        let text = others.concat() + &text;
        parse(&text);
    }
}

/// Nothing in the document is wrong: not its algebra, and not its units.
fn assert_sound(document: &Document) {
    let audit = Audit::of(document, Options::default()).unwrap_or_else(|r| panic!("{r}"));
    for outcome in &audit.outcomes {
        let word = outcome.verdict.word();
        let label = &audit.model.equations[outcome.equation].label;
        assert!(
            matches!(word, VerdictWord::Holds | VerdictWord::Definition),
            "{} ({label}), link {}: {word}",
            document.name,
            outcome.member
        );
    }
    for outcome in &audit.statements {
        assert_eq!(outcome.word, VerdictWord::Holds, "{}", document.name);
    }
    let (_, findings) = rederive::unit::audit(&audit.model);
    assert_eq!(findings, [], "{}", document.name);
}

#[test]
fn the_example_of_the_format_page_is_sound() {
    assert_sound(&parse(&blocks(&format_page(), "````", "markdown")[0]));
}

#[test]
fn the_matrix_polynomial_solves_the_lyapunov_equation_of_every_system() {
    assert_sound(&read(&proofs().join("matrix-polynomial/lyapunov.md")));
}

#[test]
fn the_documents_of_a_paper_come_in_the_order_of_its_equations() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("order");
    std::fs::create_dir_all(&folder).expect("a folder");
    let text = |equations: &str, more: &str| {
        format!(
            "```toml document\ntitle = \"t\"\npaper = \"p\"\n{equations}{more}```\n```math 1 claim\nx = x\n```\n"
        )
    };
    for (name, equations, more) in [
        ("a.md", "equations = \"9\"\n", ""),
        ("b.md", "equations = \"2-3\"\n", ""),
        ("c.md", "", ""),
        ("d.md", "", "order = \"5/2\"\n"),
    ] {
        std::fs::write(folder.join(name), text(equations, more)).expect("a file");
    }
    let other = text("", "").replace("paper = \"p\"", "paper = \"q\"");
    std::fs::write(folder.join("0.md"), other).expect("a file");
    let read = rederive::input::read(&[&folder]);
    let names: Vec<String> = read
        .iter()
        .map(|d| {
            let path = std::path::Path::new(&d.as_ref().expect("a document").name);
            path.file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    assert_eq!(names, ["0", "b", "d", "a", "c"]);
}
