//! Reading and writing LaTeX: the printed forms of a paper, forms that must be refused, and laws.

#[path = "latex/laws.rs"]
mod laws;
#[path = "latex/refused.rs"]
mod refused;

use rederive::expr::reading;
use rederive::latex::{Signature, parse_display, parse_name, write_display};

/// A table's list of strings.
fn strings(table: &toml::Table, key: &str) -> Vec<String> {
    let list = table.get(key).and_then(|value| value.as_array());
    list.into_iter()
        .flatten()
        .map(|item| item.as_str().expect("a string").to_owned())
        .collect()
}

/// A table's string.
fn string<'t>(table: &'t toml::Table, key: &str) -> &'t str {
    table
        .get(key)
        .and_then(|value| value.as_str())
        .unwrap_or_else(|| panic!("{key} is missing in {table:?}"))
}

/// What the tables declare, the later ones on top of the earlier.
fn signature(tables: &[&toml::Table]) -> Signature {
    let mut signature = Signature::default();
    for table in tables {
        let names = |key| -> Vec<_> {
            let texts = strings(table, key);
            let read = |text: &String| parse_name(text, 0).expect("a name");
            texts.iter().map(read).collect()
        };
        let variables = names("variables");
        for function in names("functions") {
            signature.declare_function(&function, &variables);
        }
        for name in names("names") {
            signature.declare(&name);
        }
    }
    signature
}

/// The cases of a file of the corpus with what each of them declares.
fn cases(text: &str) -> Vec<(toml::Table, Signature)> {
    let file: toml::Table = text.parse().expect("TOML");
    let cases = file["case"].as_array().expect("cases");
    cases
        .iter()
        .map(|case| {
            let case = case.as_table().expect("a table").clone();
            // A case that declares names of its own declares all of them.
            let signature = if case.contains_key("names") {
                signature(&[&case])
            } else {
                signature(&[&file, &case])
            };
            (case, signature)
        })
        .collect()
}

fn reads_as_printed(text: &str, at_least: usize) {
    let cases = cases(text);
    assert!(cases.len() >= at_least, "only {} cases", cases.len());
    let mut failures = Vec::new();
    for (case, signature) in cases {
        if let Err(why) = reads(&case, &signature) {
            failures.push(format!("{}: {why}", string(&case, "name")));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}

/// One case: the printed form gives the tree, and what is written for the tree gives it again.
fn reads(case: &toml::Table, signature: &Signature) -> Result<(), String> {
    let latex = string(case, "latex");
    let read = |text: &str| {
        parse_display(text, 0, signature).map_err(|wrong| format!("{text}\nis refused: {wrong:#?}"))
    };
    let expect = |found: String, expected: &str, text: &str| {
        let same = found == expected;
        same.then_some(())
            .ok_or_else(|| format!("{text}\n  found    {found}\n  expected {expected}"))
    };
    let display = read(latex)?;
    let tree = string(case, "tree").trim();
    expect(reading::display(&display), tree, latex)?;
    let written = write_display(&display);
    let again = read(&written)?;
    // The writer knows no signature: where a document's declarations alone decide the reading, it
    // writes brackets, and the case gives the tree with them.
    let rewritten = case.get("rewritten").and_then(|tree| tree.as_str());
    expect(
        reading::display(&again),
        rewritten.unwrap_or(tree).trim(),
        &written,
    )?;
    expect(write_display(&again), &written, &written)
}

#[test]
fn equations_1_to_15_of_the_paper() {
    reads_as_printed(include_str!("latex/state-equations.toml"), 15);
}

#[test]
fn equations_16_to_35_of_the_paper() {
    reads_as_printed(include_str!("latex/road.toml"), 20);
}

#[test]
fn equations_36_to_44_of_the_paper() {
    reads_as_printed(include_str!("latex/random-vibration.toml"), 9);
}

#[test]
fn equations_45_to_68_of_the_paper() {
    reads_as_printed(include_str!("latex/quarter-car.toml"), 24);
}

#[test]
fn forms_that_papers_print() {
    reads_as_printed(include_str!("latex/forms.toml"), 60);
}

/// What a display defines decides how later equations are read.
#[test]
fn definitions_declare_their_names() {
    let mut signature = Signature::default();
    let applied = |text: &str, signature: &Signature| {
        parse_display(text, 0, signature).map(|display| reading::display(&display))
    };
    for text in ["c(s)", "g(s)", "w(s)", "b(s)", "x(s)"] {
        assert!(applied(text, &signature).is_err(), "{text}");
    }
    signature.declare_definitions(
        r"\begin{aligned} b &= 1, \\ c_i &= x + y, & \dot{h} &= 1, \\ g(s) &= s^2 \end{aligned}",
    );
    signature.declare_definitions(r"c = 2 \quad \underbrace{g(3)}_{w(s)} = \underbrace{d}_{k}");
    for (text, tree) in [
        ("c(n)", "(* c (round n))"),
        ("b(n)", "(* b (round n))"),
        ("c_4(n)", "(* c_4 (round n))"),
        ("k(m)", "(* k (round m))"),
        ("g(s + 1)", "(@ g (+s +1))"),
        ("w(m)", "(@ w m)"),
        ("u(s)", "(@ u s)"),
    ] {
        assert_eq!(applied(text, &signature).as_deref(), Ok(tree), "{text}");
    }
    assert!(applied("x(y)", &signature).is_err());
    // A defined quantity may depend on time; a declared one says what it depends on.
    let [t, z, k] = ["t", "z", "k"].map(|name| parse_name(name, 0).expect("a name"));
    signature.declare_function(&z, &[t]);
    assert_eq!(applied("c(t)", &signature).as_deref(), Ok("(@ c t)"));
    signature.declare(&k);
    assert_eq!(
        applied("k(t)", &signature).as_deref(),
        Ok("(* k (round t))")
    );
    signature.declare_definitions("((");
}
