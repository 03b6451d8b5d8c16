//! What the README says is so: its tables are what the program prints, its example is checked, and
//! its exit codes are those of the program.

use rederive::audit::Audit;
use rederive::check::Options;
use rederive::inspection::Inspection;
use rederive::paper::papers;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn readme() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    std::fs::read_to_string(path).expect("the README")
}

/// The body of the first fence after a marker.
fn fence_after<'a>(text: &'a str, marker: &str) -> &'a str {
    let rest = &text[text.find(marker).unwrap_or_else(|| panic!("{marker}"))..];
    let start = rest.find("```").expect("a fence");
    let ticks = rest[start..].bytes().take_while(|b| *b == b'`').count();
    let body = start + rest[start..].find('\n').expect("an info string") + 1;
    let close = format!("\n{}\n", "`".repeat(ticks));
    let end = body + rest[body..].find(&close).expect("the end of the fence") + 1;
    &rest[body..end]
}

/// Compares what the program prints with the fence after a marker; with `REDERIVE_BLESS` set the fence
/// is rewritten instead, to be read in the difference before it is committed.
fn compare_or_bless(printed: &str, marker: &str) {
    let text = readme();
    let shown = fence_after(&text, marker);
    if std::env::var_os("REDERIVE_BLESS").is_some() && printed.trim_end() != shown.trim_end() {
        let new = text.replacen(shown, &format!("{}\n", printed.trim_end()), 1);
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
        std::fs::write(path, new).expect("the README is written");
        return;
    }
    assert_eq!(printed.trim_end(), shown.trim_end());
}

fn rederive(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program runs")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[test]
fn the_table_is_what_the_program_prints() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let document = "proofs/schiehlen-2006/quarter-car.md";
    let output = rederive(root, &["check", document]);
    let printed = String::from_utf8(output.stdout).expect("text");
    compare_or_bless(&printed, &format!("<!-- table: {document} -->"));
    assert_eq!(output.status.code(), Some(0));
}

#[test]
fn the_headline_counts_the_equations_of_the_paper() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/schiehlen-2006");
    let inspections: Vec<Inspection> = rederive::input::read(&[folder])
        .into_iter()
        .map(|document| Inspection {
            audit: Audit::of(&document.expect("a document"), Options::default()).expect("an audit"),
            comparison: None,
        })
        .collect();
    let papers = papers(&inspections);
    let [paper] = &papers[..] else {
        panic!("{papers:?}");
    };
    let words: Vec<String> = readme().split_whitespace().map(String::from).collect();
    let said = words.join(" ");
    assert!(said.contains(&paper.coverage()), "{}", paper.coverage());
}

#[test]
fn the_example_is_checked_as_shown() {
    let text = readme();
    let lens = fence_after(&text, "Save this as `lens.md`");
    let folder = folder("readme-example");
    std::fs::write(folder.join("lens.md"), lens).expect("a file");
    let output = rederive(&folder, &["check", "lens.md"]);
    let printed = String::from_utf8(output.stdout).expect("text");
    compare_or_bless(&printed, "<!-- output: rederive check lens.md -->");
    // The slip is not recorded yet.
    assert_eq!(output.status.code(), Some(1));

    let record = fence_after(&text, "Record the verdict");
    std::fs::write(folder.join("lens.md"), format!("{lens}\n{record}")).expect("a file");
    let output = rederive(&folder, &["check", "lens.md"]);
    assert_eq!(output.status.code(), Some(0));
}

/// The figures take minutes: what is stored is what the command beside it printed.
#[test]
fn the_figures_of_honesty_are_the_stored_ones() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let stored = std::fs::read_to_string(root.join("tests/golden/mutation.txt")).expect("a file");
    let (command, table) = stored.split_once('\n').expect("the command and the table");
    let text = readme();
    let shown = fence_after(&text, "<!-- table: tests/golden/mutation.txt -->");
    assert_eq!(table.trim(), shown.trim());
    let command = command.trim_start_matches("# ");
    assert!(text.contains(&format!("`{command}`")), "{command}");
    // The command is one that the program takes; it is given no mutant to try.
    let arguments: Vec<&str> = command
        .split(' ')
        .skip(1)
        .take_while(|a| *a != "|")
        .collect();
    let all: Vec<&str> = arguments
        .iter()
        .map(|a| if *a == "100" { "0" } else { a })
        .collect();
    let lens = folder("readme-mutation").join("lens.md");
    std::fs::write(&lens, fence_after(&text, "Save this as `lens.md`")).expect("a file");
    let path = lens.display().to_string();
    let swapped: Vec<&str> = all
        .iter()
        .map(|a| {
            if a.starts_with("proofs") {
                &path[..]
            } else {
                a
            }
        })
        .collect();
    assert_eq!(
        rederive(root, &swapped).status.code(),
        Some(0),
        "{swapped:?}"
    );
    // In every row each edit and each rewriting has one fate; none has survived, none is wrongly rejected.
    let mut count = 0;
    for row in table.lines().skip(1) {
        let cells = row
            .split("  ")
            .map(str::trim)
            .filter(|cell| !cell.is_empty());
        // What is not asked of a row has a dash.
        let number = |cell: &str| match cell {
            "-" => 0,
            cell => cell.parse::<usize>().unwrap_or_else(|_| panic!("{row}")),
        };
        let numbers: Vec<usize> = cells.skip(1).take(7).map(number).collect();
        let [
            tried,
            refuted,
            meaningless,
            equivalent,
            undecided,
            survived,
            rejected,
        ] = numbers[..]
        else {
            panic!("{row}");
        };
        assert_eq!(refuted + equivalent + undecided, tried, "{row}");
        assert!(meaningless <= refuted, "{row}");
        assert_eq!((survived, rejected), (0, 0), "{row}");
        count += 1;
    }
    assert!(count > 10, "{count} rows");
}

#[test]
fn bad_input_has_its_exit_code() {
    let folder = folder("readme-bad-input");
    std::fs::write(folder.join("bad.md"), b"```math 1 claim\n\xff\n```\n").expect("a file");
    std::fs::write(folder.join("open.md"), "```math 1 claim\nx = (y\n```\n").expect("a file");
    std::fs::write(folder.join("empty.md"), "").expect("a file");
    for file in ["bad.md", "open.md", "empty.md", "missing.md"] {
        let output = rederive(&folder, &["check", file]);
        assert_eq!(output.status.code(), Some(3), "{file}");
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(told.contains(file), "{file}: {told}");
    }
    // A sum of so many terms is not evaluated.
    let odd = "```toml symbols\nx = { meaning = \"\" }\n```\n```math 1 claim\n20000x = \\sum_{i=1}^{20000} x\n```\n";
    std::fs::write(folder.join("odd.md"), odd).expect("a file");
    assert_eq!(
        rederive(&folder, &["check", "odd.md"]).status.code(),
        Some(2)
    );
}
