//! The outputs: files against their schemas, exit codes, free text that must not act in TeX.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn rederive(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(arguments)
        .current_dir(ROOT)
        .output()
        .expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// A folder of its own for a test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

fn document(folder: &Path, text: &str) -> String {
    let path = folder.join("document.md");
    std::fs::write(&path, text).expect("a document for the test");
    path.display().to_string()
}

fn code(text: &str, name: &str) -> Option<i32> {
    let path = document(&folder(name), text);
    rederive(&[&path]).status.code()
}

fn assert_valid(schema: &str, instance: &Value) {
    let mut schemas = boon::Schemas::new();
    let mut compiler = boon::Compiler::new();
    let path = format!("{ROOT}/schemas/{schema}");
    let index = compiler.compile(&path, &mut schemas).expect("a schema");
    if let Err(error) = schemas.validate(instance, index) {
        panic!("{error:#}");
    }
}

fn claim<'v>(verdicts: &'v Value, equation: &str, member: u64) -> &'v Value {
    verdicts["claims"]
        .as_array()
        .into_iter()
        .flatten()
        .find(|c| c["equation"] == equation && c["member"] == member)
        .expect("the claim")
}

const QUARTER_CAR: &str = "proofs/schiehlen-2006/quarter-car.md";

#[test]
fn the_quarter_car_by_its_json() {
    let output = rederive(&["check", QUARTER_CAR, "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let verdicts: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_valid("verdicts.schema.json", &verdicts);
    assert_eq!(verdicts["coverage"]["numbered"], 24);
    assert_eq!(verdicts["coverage"]["covered"], 24);

    assert_eq!(claim(&verdicts, "61", 1)["verdict"], "holds");
    let hidden = claim(&verdicts, "61", 2);
    assert_eq!(hidden["verdict"], "holds given");
    assert_eq!(hidden["given"], serde_json::json!(["bd = ae"]));
    assert_eq!(hidden["implied_by"], serde_json::json!(["47"]));
    assert_eq!(hidden["residual"][0]["value"], "a*c^2*(d + e)*(b*d - a*e)");
    assert_eq!(hidden["certificate_verified"], true);

    let statement = |label: &str| {
        let statements = verdicts["statements"].as_array().into_iter().flatten();
        let mut found = statements.filter(|s| s["statement"] == label);
        found.next().unwrap_or_else(|| panic!("no {label}")).clone()
    };
    let damping = statement("strut-4");
    assert_eq!(damping["verdict"], "loose");
    assert_eq!(damping["numbers"][0]["closed"], "4√15/15 - 1");
    assert_eq!(damping["numbers"][0]["exact"], Value::Null);
    assert_eq!(damping["certificate_elementary"], true);
    assert_eq!(statement("strut-3")["numbers"][0]["exact"], "15/248");
    let boundary = &statement("strut-2")["boundary"];
    assert_eq!(
        boundary,
        &serde_json::json!([]),
        "the first letter has none"
    );
    assert_eq!(statement("standard-deviations")["likelier"], "paper");

    let misprint = claim(&verdicts, "55", 1);
    assert_eq!(misprint["verdict"], "misprint");
    assert_eq!(misprint["correction"]["only"], true);
    let corrected: Vec<&Value> = misprint["correction"]["edits"]
        .as_array()
        .into_iter()
        .flatten()
        .map(|e| &e["corrected"])
        .collect();
    assert_eq!(corrected, ["H_{k+1,1}", "\\mathbf{A}_{2k-m}"]);
}

#[test]
fn all_files_are_written_and_the_same_every_time() {
    let folders = [folder("once"), folder("twice")];
    for folder in &folders {
        let output = rederive(&[QUARTER_CAR, "--out", &folder.display().to_string()]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        // What is false is said before its correction is searched; the last line says what became of
        // the PDF, with TeX and without.
        let all = text(&output.stderr);
        assert!(
            all.contains(" (48.1): false as printed; searching"),
            "{all}"
        );
        let said = all.lines().last().unwrap_or_default();
        let pdf = folder.join("report.pdf").exists();
        let expected = if pdf {
            "the report is"
        } else {
            "no PDF was made: neither"
        };
        assert!(said.starts_with(expected), "{said}");
    }
    for name in ["report.tex", "verdicts.json", "vectors.json"] {
        let [once, twice] = folders
            .each_ref()
            .map(|f| std::fs::read(f.join(name)).unwrap());
        assert!(once == twice, "{name} differs from run to run");
    }
    let left: Vec<_> = std::fs::read_dir(&folders[0])
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|name| name.starts_with('.'))
        .collect();
    assert!(left.is_empty(), "left behind: {left:?}");

    let bytes = std::fs::read(folders[0].join("vectors.json")).unwrap();
    let vectors: Value = serde_json::from_slice(&bytes).unwrap();
    assert_valid("vectors.schema.json", &vectors);
    let points = vectors["documents"][0]["points"].as_array().unwrap();
    assert_eq!(points.len(), 11);
    let quantity = |name: &str| {
        points[0]["quantities"]
            .as_array()
            .into_iter()
            .flatten()
            .find(|q| q["name"] == name)
            .unwrap_or_else(|| panic!("no {name}"))["entries"]
            .clone()
    };
    // (67) and (68) at the reference car, by hand.
    assert_eq!(quantity("\\sigma_a^2")[0][0]["exact"], "1850/3");
    assert_eq!(quantity("\\sigma_f^2")[0][0]["exact"], "5079040000/3");
    assert_eq!(quantity("a_2")[0][0]["exact"], "4400");
    assert_eq!(
        quantity("\\det \\mathbf{H}")[0][0]["exact"],
        "384000000000000"
    );
    assert_eq!(quantity("\\mathbf{P}")[2][2]["exact"], "1850/3");
    assert_eq!(quantity("H_{i,j}")[3][0]["exact"], "-265600");
}

#[test]
fn what_is_not_in_the_schema_is_refused() {
    let output = rederive(&[QUARTER_CAR, "--json"]);
    let mut verdicts: Value = serde_json::from_slice(&output.stdout).unwrap();
    verdicts["claims"][0]["verdict"] = "proved".into();
    let mut schemas = boon::Schemas::new();
    let path = format!("{ROOT}/schemas/verdicts.schema.json");
    let index = boon::Compiler::new().compile(&path, &mut schemas).unwrap();
    assert!(schemas.validate(&verdicts, index).is_err());
}

fn sum(claim: &str, settings: &str, equations: &str) -> String {
    format!(
        "```toml document\nequations = \"{equations}\"\n```\n\
         ```toml symbols\na = {{}}\nb = {{}}\n```\n\
         ```math 1 claim\n{claim}\n```\n```toml 1\n{settings}\n```\n"
    )
}

const TRUE: &str = "(a + b)^2 = a^2 + 2ab + b^2";
const FALSE: &str = "(a + b)^2 = a^2 + ab + b^2";
const SLIP: &str = "(a + b)^2 = a^2 + 2ab + b^3";

#[test]
fn exit_codes() {
    assert_eq!(code(&sum(TRUE, "", "1"), "true"), Some(0));
    assert_eq!(code(&sum(FALSE, "", "1"), "false"), Some(1));
    assert_eq!(
        code(&sum(SLIP, "expect = \"misprint\"", "1"), "known"),
        Some(0)
    );
    assert_eq!(
        code(&sum(TRUE, "expect = \"misprint\"", "1"), "mended"),
        Some(1)
    );
    assert_eq!(code(&sum(TRUE, "", "1-2"), "absent"), Some(2));
    assert_eq!(code(&sum("a = \\infty", "", "1"), "undecided"), Some(2));
    assert_eq!(
        code(
            &sum("a = \\infty", "expect = \"undecided\"", "1"),
            "unknown is no pass"
        ),
        Some(2)
    );
    assert_eq!(code(&sum("(a = b", "", "1"), "unbalanced"), Some(3));
    assert_eq!(code("", "empty"), Some(3));
    assert_eq!(rederive(&["no-such-file.md"]).status.code(), Some(3));
    assert_eq!(rederive(&["--no-such-option"]).status.code(), Some(3));
    assert_eq!(rederive(&["--help"]).status.code(), Some(0));
}

#[test]
fn a_folder_without_documents_is_bad_input() {
    let folder = folder("nothing");
    std::fs::write(folder.join("README.md"), "# Words only\n").unwrap();
    let output = rederive(&[&folder.display().to_string()]);
    assert_eq!(output.status.code(), Some(3));
    assert!(text(&output.stderr).contains("no document in this folder"));
}

#[test]
fn a_false_claim_shows_residual_and_witness() {
    let path = document(&folder("shown"), &sum(FALSE, "", "1"));
    let output = rederive(&["explain", "1", &path]);
    let said = text(&output.stdout);
    assert!(said.contains("lhs - rhs = ab"), "{said}");
    assert!(
        said.contains("An exact point where the sides differ"),
        "{said}"
    );
    assert_eq!(rederive(&["explain", "99", &path]).status.code(), Some(3));
}

#[test]
fn explain_61_names_the_hidden_hypothesis() {
    let output = rederive(&["explain", "61", QUARTER_CAR]);
    assert_eq!(output.status.code(), Some(0));
    let said = text(&output.stdout);
    for words in [
        "61.1",
        "holds given bd = ae, implied by (47)",
        "lhs - rhs = ac^2(d + e)(bd - ae)",
        "Without the relation it is false",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
}

#[test]
fn explain_shows_what_a_loose_statement_misses() {
    let output = rederive(&["explain", "strut-4-comfort", QUARTER_CAR]);
    assert_eq!(output.status.code(), Some(0));
    // The lines as one, for they are broken anywhere.
    let said = text(&output.stdout);
    let said: Vec<&str> = said.split_whitespace().collect();
    let said = said.join(" ");
    for words in [
        "\"Damping coefficient with optimal comfort essentially deteriorates safety.\"",
        "loose",
        "7√6/12 - 1 ≈ 0.42887",
        "The only minimum of σ_a^2 over d_A is at d_A = c_A √((m_A + m_R)/c_R).",
        "The two minima coincide where 2 m_A c_A + 2 m_R c_A = m_A c_R.",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
}

#[test]
fn the_table_is_the_golden_one() {
    let output = rederive(&[QUARTER_CAR]);
    let path = format!("{ROOT}/tests/golden/quarter-car.txt");
    // When the document or the table changed on purpose: REDERIVE_BLESS=1 cargo test --test outputs
    if std::env::var_os("REDERIVE_BLESS").is_some() {
        std::fs::write(&path, &output.stdout).expect("the golden table is written");
    }
    let golden = std::fs::read_to_string(&path).expect("the golden table");
    assert_eq!(text(&output.stdout), golden);
}

#[test]
fn free_text_cannot_act_in_tex() {
    let hostile =
        "\\\\input{/etc/passwd} \\\\immediate\\\\write18{touch hacked} 100% & _ ^^5c # $ ~ }{";
    let text_of_document = format!(
        "# {hostile}\n```toml document\ntitle = \"{hostile}\"\nsource = \"{hostile}\"\n\
         equations = \"1\"\n```\n\
         ```toml symbols\na = {{ unit = \"kg\", value = \"2\", meaning = \"{hostile}\" }}\n```\n\
         ```math 1 claim\na = a \\text{{ by 100% & _ }}\n```\n\
         ```toml 1\nnote = \"{hostile}\"\n```\n\
         ```math 2 recall\na = a\n```\n```toml 2\nreason = \"{hostile}\"\n```\n"
    );
    let folder = folder("hostile");
    let path = document(&folder, &text_of_document);
    let out = folder.join("out");
    let output = rederive(&[&path, "--out", &out.display().to_string()]);
    let report = std::fs::read_to_string(out.join("report.tex"))
        .unwrap_or_else(|e| panic!("{e}: {}", text(&output.stderr)));
    assert!(!report.contains("\\input"), "a command got through");
    assert!(!report.contains("\\write"), "a command got through");
    assert!(!report.contains("^^"));
    assert!(report.contains("\\textbackslash{}input"));
    let said = text(&output.stderr);
    // With TeX the report compiles; a complaint of TeX would show here.
    assert!(
        said.contains("the report is") && !said.contains("no PDF was made: !"),
        "{said}"
    );
    assert!(!folder.join("hacked").exists() && !out.join("hacked").exists());
}
