//! Figures: the files, the marks, what is refused, and a run that is interrupted.

use num_rational::BigRational;
use rederive::audit::Audit;
use rederive::check::Options;
use rederive::diagnostic::DiagnosticKind;
use rederive::document::Document;
use rederive::figure::{Agreement, Content, Figure, MarkKind, Surface};
use rederive::report::csv::csv;
use rederive::report::drawing::{pgf, scene, svg};
use std::path::{Path, PathBuf};
use std::process::Command;

const QUARTER_CAR: &str = "proofs/schiehlen-2006/quarter-car.md";

fn audit(name: &str, text: &str) -> Result<Audit, Vec<DiagnosticKind>> {
    let kinds = |diagnostics: Vec<rederive::diagnostic::Diagnostic>| {
        diagnostics.into_iter().map(|d| d.kind).collect::<Vec<_>>()
    };
    let document = Document::parse(name, text).map_err(kinds)?;
    Audit::of(&document, Options::default()).map_err(|r| kinds(r.diagnostics))
}

fn quarter_car() -> Audit {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(QUARTER_CAR);
    let text = std::fs::read_to_string(path).expect("the document");
    audit(QUARTER_CAR, &text).expect("an audit")
}

fn figure<'a>(audit: &'a Audit, label: &str) -> &'a Figure {
    audit
        .figures
        .iter()
        .find(|f| f.label == label)
        .expect("the figure")
}

fn surface<'a>(audit: &'a Audit, label: &str) -> &'a Surface {
    match &figure(audit, label).content {
        Ok(Content::Surface(surface)) => surface,
        other => panic!("no surface: {other:?}"),
    }
}

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// The squares of the ends of an interval enclose a number.
fn square_is_within(interval: (BigRational, BigRational), square: &BigRational) -> bool {
    &(&interval.0 * &interval.0) <= square && square <= &(&interval.1 * &interval.1)
}

#[test]
fn the_marks_are_the_exact_optima() {
    let audit = quarter_car();
    // Comfort over the strut's parameters falls with both toward the corner; along the damping alone
    // it is least at d_A = c_A sqrt((m_A + m_R)/c_R), whose square by that of 4800 is 5/32.
    let comfort = surface(&audit, "4");
    let place = comfort.marks[0].place.as_ref().expect("an optimum");
    assert_eq!(place.inside, [false, false]);
    assert_eq!(place.coordinates[0].exact(), Some(&ratio(1, 2)));
    assert_eq!(place.coordinates[1].exact(), Some(&ratio(1, 2)));
    assert_eq!(place.value.0, ratio(1, 2));
    let along = comfort
        .marks
        .iter()
        .find(|m| matches!(m.kind, MarkKind::Section(1, _)))
        .expect("a section along the damping");
    let place = along.place.as_ref().expect("an optimum");
    assert!(square_is_within(
        place.coordinates[0].interval(),
        &ratio(5, 32)
    ));

    // Safety has its optimum inside: at c_A = c_R m_R m_A/(m_A + m_R)^2 = 18750 N/m, 5/8 of the
    // reference, and d_A^2 = 21093750 there.
    let safety = surface(&audit, "5");
    let place = safety.marks[0].place.as_ref().expect("an optimum");
    assert_eq!(place.inside, [true, true]);
    assert_eq!(place.coordinates[0].exact(), Some(&ratio(5, 8)));
    let square = ratio(21_093_750, 4800 * 4800);
    assert!(square_is_within(place.coordinates[1].interval(), &square));

    for label in ["6", "7"] {
        let place = surface(&audit, label).marks[0]
            .place
            .as_ref()
            .expect("an optimum");
        assert!(
            place
                .coordinates
                .iter()
                .all(|c| c.exact() == Some(&ratio(1, 2)))
        );
    }
}

#[test]
fn no_point_of_the_grid_is_below_the_optimum() {
    let audit = quarter_car();
    for label in ["4", "5", "6", "7"] {
        let surface = surface(&audit, label);
        let place = surface.marks[0].place.as_ref().expect("an optimum");
        let mut values = surface.values.iter().flatten();
        assert!(values.all(|v| v >= &place.value.0), "figure {label}");
        // The reference point is a point of the grid, where the value is one.
        assert_eq!(surface.values[20][20], ratio(1, 1));
    }
}

#[test]
fn the_sketch_is_a_picture_of_the_equations_of_motion() {
    let audit = quarter_car();
    let Ok(Content::Sketch(sketch)) = &figure(&audit, "3").content else {
        panic!("a sketch");
    };
    assert_eq!(sketch.equations, Some(("45".into(), Agreement::Agrees)));

    // With the damper at the tyre it is another car.
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(QUARTER_CAR);
    let text = std::fs::read_to_string(path).expect("the document");
    let other = text
        .replace("{ spring = 'c_A', damper = 'd_A' }", "{ spring = 'c_A' }")
        .replace(
            "{ spring = 'c_R', tyre = true }",
            "{ spring = 'c_R', damper = 'd_A', tyre = true }",
        );
    assert_ne!(text, other);
    let other = self::audit("other.md", &other).expect("an audit");
    assert!(figure(&other, "3").contradicts());
}

#[test]
fn pictures_are_well_formed_and_always_the_same() {
    let (first, second) = (quarter_car(), quarter_car());
    for (figure, again) in first.figures.iter().zip(&second.figures) {
        let picture = scene(figure).expect("a picture");
        let file = svg(&picture);
        assert_eq!(file, svg(&scene(again).expect("a picture")));
        let tree = roxmltree::Document::parse(&file).expect("XML");
        let texts = tree.descendants().filter(|n| n.has_tag_name("text"));
        assert!(texts.count() > 3);
        for attribute in tree.descendants().flat_map(|n| n.attributes()) {
            assert!(!attribute.value().contains("NaN") && !attribute.value().contains("inf"));
        }
        let tex = pgf(&picture);
        assert_eq!(tex.matches('{').count(), tex.matches('}').count());
        assert!(!tex.contains("NaN") && !tex.contains("inf"));
    }
}

const SPRING: &str = "# A spring\n\n```toml symbols\n\
    x = { unit = \"m\", positive = true, value = \"2\", meaning = \"elongation\" }\n\
    c = { unit = \"N/m\", positive = true, value = \"3\", meaning = \"stiffness\" }\n\
    y = { meaning = \"without a value\" }\n```\n\
    ```math 1 define\nW = \\frac{c x^2}{2}, \\quad V = W + y\n```\n";

fn spring(figure: &str) -> Result<Audit, Vec<DiagnosticKind>> {
    audit(
        "spring.md",
        &format!("{SPRING}```toml figure 1\ntitle = \"Work\"\n{figure}\n```\n"),
    )
}

#[test]
fn the_numbers_of_a_surface() {
    let audit = spring(
        "kind = \"surface\"\nquantity = 'W'\npoints = 2\noptimum = \"maximum\"\n\
         relative = { x = [\"1/2\", \"1\"], c = [\"1\", \"4/3\"] }",
    )
    .expect("an audit");
    let table = figure(&audit, "1").table().expect("numbers");
    assert_eq!(
        csv(&table).lines().collect::<Vec<_>>(),
        [
            "x [m],c [N/m],W [kg m^2/s^2],x / reference [1],c / reference [1],W / reference [1]",
            "1,3,1.5,0.5,1,0.25",
            "2,3,6,1,1,1",
            "1,4,2,0.5,1.3333333333333333,0.33333333333333333",
            "2,4,8,1,1.3333333333333333,1.3333333333333333",
        ]
    );
    let place = surface(&audit, "1").marks[0]
        .place
        .as_ref()
        .expect("a maximum");
    assert_eq!(place.value.0, ratio(4, 3));
}

#[test]
fn the_numbers_of_curves() {
    let audit = spring(
        "kind = \"curves\"\nquantity = 'W'\npoints = 3\naxes = \"log-log\"\n\
         over = { x = [\"1/10\", \"10\"] }\nfamily = { c = { soft = \"2\", hard = \"20\" } }",
    )
    .expect("an audit");
    let table = figure(&audit, "1").table().expect("numbers");
    assert_eq!(
        csv(&table).lines().collect::<Vec<_>>(),
        [
            "x [m],W (soft) [kg m^2/s^2],W (hard) [kg m^2/s^2]",
            "0.1,0.01,0.1",
            "1,1,10",
            "10,100,1000",
        ]
    );
    assert!(
        roxmltree::Document::parse(&svg(&scene(figure(&audit, "1")).expect("a picture"))).is_ok()
    );
}

#[test]
fn a_chain_is_drawn() {
    let audit = spring(
        "kind = \"chain\"\nchain = [{ arrow = 'x' }, { box = 'c', words = \"a spring <&>\" }, \
         { arrow = 'cx' }]",
    )
    .expect("an audit");
    let file = svg(&scene(figure(&audit, "1")).expect("a picture"));
    let tree = roxmltree::Document::parse(&file).expect("XML");
    let words: Vec<&str> = tree.descendants().filter_map(|n| n.text()).collect();
    assert!(words.contains(&"a spring <&>"), "{words:?}");
}

#[test]
fn bad_tables_are_refused() {
    let kinds = |table: &str| spring(table).err().unwrap_or_default();
    let surface = |rest: &str| format!("kind = \"surface\"\n{rest}");
    let ranges = "relative = { x = [\"1/2\", \"1\"], c = [\"1\", \"2\"] }";
    type Wanted = fn(&DiagnosticKind) -> bool;
    let cases: [(String, Wanted); 11] = [
        ("kind = \"pie\"".into(), |k| {
            matches!(k, DiagnosticKind::UnknownWord { .. })
        }),
        ("quantity = 'W'".into(), |k| {
            matches!(k, DiagnosticKind::MissingKey { .. })
        }),
        (surface(ranges), |k| {
            matches!(k, DiagnosticKind::MissingKey { .. })
        }),
        (
            surface(&format!("quantity = 'U'\n{ranges}")),
            |k| matches!(k, DiagnosticKind::UndeclaredName { name } if name == "U"),
        ),
        (
            surface(&format!("quantity = 'V'\n{ranges}")),
            |k| matches!(k, DiagnosticKind::NoValue { name } if name == "y"),
        ),
        (surface(&format!("quantity = '\\frac{{'\n{ranges}")), |_| {
            true
        }),
        (
            surface("quantity = 'W'\nrelative = { x = [\"1\", \"2\"] }"),
            |k| matches!(k, DiagnosticKind::Unexpected { .. }),
        ),
        (
            surface("quantity = 'W'\nrelative = { x = [\"1\", \"2\"], y = [\"1\", \"2\"] }"),
            |k| matches!(k, DiagnosticKind::NoValue { name } if name == "y"),
        ),
        (
            surface("quantity = 'W'\nrelative = { x = [\"2\", \"1\"], c = [\"1\", \"2\"] }"),
            |k| matches!(k, DiagnosticKind::EmptyRange { .. }),
        ),
        (
            "kind = \"chain\"\nchain = [{ box = 'x' }, { box = 'c' }]".into(),
            |k| matches!(k, DiagnosticKind::Unexpected { .. }),
        ),
        ("kind = \"sketch\"\ncolumn = [{ road = 'x' }]".into(), |k| {
            matches!(k, DiagnosticKind::Unexpected { .. })
        }),
    ];
    for (table, wanted) in cases {
        let found = kinds(&table);
        assert!(found.iter().any(wanted), "{table}: {found:?}");
    }
}

/// A pole on the grid costs the figure, and the verdicts of the document stay.
#[test]
fn a_pole_costs_only_its_figure() {
    let table = "kind = \"surface\"\nquantity = '1/(x - 2)'\n\
                 relative = { x = [\"1/2\", \"2\"], c = [\"1\", \"2\"] }";
    let figure = spring(table).expect("an audit").figures.remove(0);
    assert!(figure.content.is_err());
}

#[test]
fn figures_that_are_announced_and_not_there_are_not_covered() {
    let text = format!("```toml document\nfigures = \"1-2\"\n```\n{SPRING}");
    let audit = audit("spring.md", &text).expect("an audit");
    assert_eq!(audit.figure_coverage().absent, [1, 2]);
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

#[test]
fn the_command_writes_its_files() {
    let out = folder("figures");
    let run = Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(["figures", QUARTER_CAR, "--out", &out.display().to_string()])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("the program runs");
    assert_eq!(run.status.code(), Some(0));
    for file in [
        "quarter-car-figure-3.svg",
        "quarter-car-figure-4.svg",
        "quarter-car-figure-7.csv",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    // No progress where nobody looks.
    assert!(run.stderr.is_empty());
}

/// SIGINT reaches a run that has long to go; what is finished comes out.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_run_says_what_is_finished() {
    use std::io::{BufRead, BufReader, Read};
    use std::process::Stdio;

    let folder = folder("interrupted");
    std::fs::create_dir_all(&folder).expect("a folder");
    let text = "# Long\n\n```toml symbols\nx = { value = \"2\", meaning = \"\" }\n```\n\
        ```math 1 claim\n(x + 1)^2 = x^2 + 2x + 1\n```\n\
        ```math 2 claim\nx + 1 = x + 2\n```\n\
        ```toml numeric\nseed = 1\nsamples = 100000\nquantities = ['(x + 1)^{200}']\n\
        box = { x = [\"1\", \"2\"] }\npoints = { reference = {} }\n```\n";
    std::fs::write(folder.join("long.md"), text).expect("a document");
    let mut child = Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(["check", "long.md"])
        .current_dir(&folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    // What is false is said before its correction is searched: then the first claim is decided.
    let mut said = BufReader::new(child.stderr.take().expect("its messages"));
    let mut messages = String::new();
    while !messages.contains("(2)") {
        let read = said.read_line(&mut messages).expect("a message");
        assert!(read > 0, "it was over too soon: {messages}");
    }
    assert!(
        child.try_wait().expect("a status").is_none(),
        "it was over too soon"
    );
    let killed = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(killed.expect("kill").success());
    let output = child.wait_with_output().expect("output");
    assert_eq!(output.status.code(), Some(130));
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(printed.contains(" 1  holds"), "{printed}");
    said.read_to_string(&mut messages).expect("its messages");
    assert!(messages.contains("interrupted"), "{messages}");
}

#[test]
fn the_format_s_example_is_drawn() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/README.md");
    let page = std::fs::read_to_string(path).expect("the page");
    let example = page.split("````markdown\n").nth(1);
    let text = example.and_then(|rest| rest.split("\n````").next());
    let text = format!("{}\n", text.expect("the example"));
    let audit = audit("circuit.md", &text).expect("an audit");
    assert_eq!(audit.figures.len(), 1);
    // The noise k theta/C does not depend on R: it is smallest on a whole edge, which is no one place.
    let surface = surface(&audit, "1");
    assert!(surface.marks[0].place.is_err());
    assert_eq!(surface.values[0][0], ratio(2, 1));
}
