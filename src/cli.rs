//! The command line: arguments in, tables and files out, and nothing else.

use crate::audit::Audit;
use crate::check::Options;
use crate::diagnostic::{Rejection, printable_line};
use crate::document::Document;
use crate::input;
use crate::inspection::Inspection;
use crate::methods::Methods;
use crate::mutation::{self, Mutation};
use crate::paper::papers;
use crate::progress::{self, INTERRUPTED_CODE, Terminal, Watch};
use crate::report::difference::{self, Recorded};
use crate::report::mutation as mutation_report;
use crate::report::output::{self, Pdf};
use crate::report::terminal::{self, Style};
use crate::report::{errata, explain, json};
use crate::stack::{in_parallel, with_deep_stack};
use crate::standing::exit_code;
use clap::{Args, Parser, Subcommand};
use std::collections::BTreeSet;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;

/// Re-derives published equations exactly: which hold, which only under a condition, and which
/// are misprinted and how to mend them.
///
/// Exit code: 0 all verdicts are as expected; 1 a verdict differs from the recorded one, or a slip
/// is not recorded; 2 something is undecided or a numbered equation has no verdict; 3 a document
/// cannot be read; 4 the program contradicts itself (a certificate that does not verify, or certified
/// enclosures that are apart where it proved equality); 130 interrupted by Ctrl-C, and what was
/// finished is printed. Of several, the first in the order 130, 4, 3, 1, 2.
#[derive(Debug, Parser)]
#[command(name = "rederive", version, args_conflicts_with_subcommands = true)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Commands>,
    #[command(flatten)]
    check: Check,
}

#[derive(Debug, Subcommand)]
enum Commands {
    /// Check documents (the default command).
    Check(Check),
    /// Show the whole reasoning for one equation.
    Explain(Explain),
    /// Compare the floating-point methods: digits, operations, and where asked for time.
    Methods(MethodsArguments),
    /// Write what is false as an errata sheet, in Markdown or LaTeX.
    Errata(ErrataArguments),
    /// Damage every claim and definition in every single way, and count what the checker lets pass.
    ///
    /// Exit code: 0 every mutant was refuted, is equivalent or is undecided; 1 one has survived, or
    /// was refuted although it is equivalent; 3 a document cannot be checked; 130 interrupted.
    Mutate(MutateArguments),
    /// List the verdicts that differ between two runs' JSON.
    ///
    /// Exit code: 0 none differs; 1 some do; 3 a file cannot be read.
    Diff(DiffArguments),
    /// Write the figures only: an SVG for each, and its numbers as CSV.
    Figures(Figures),
}

#[derive(Debug, Args)]
struct Check {
    /// Documents, or folders of documents; without any, the ones inside the program.
    paths: Vec<PathBuf>,
    /// Write report.tex, verdicts.json, vectors.json, the figures as SVG and CSV and, where TeX is
    /// installed, report.pdf.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print one JSON object instead of tables.
    #[arg(long)]
    json: bool,
    /// How many candidates for a correction are tried for each false equation.
    #[arg(long, value_name = "N", default_value_t = Options::default().candidates)]
    budget: usize,
}

#[derive(Debug, Args)]
struct Figures {
    /// Documents, or folders of documents; without any, the ones inside the program.
    paths: Vec<PathBuf>,
    /// Where the files go.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

#[derive(Debug, Args)]
struct MethodsArguments {
    /// Documents, or folders of documents; without any, the ones inside the program.
    paths: Vec<PathBuf>,
    /// Measure times too, as ratios; they are not the same twice.
    #[arg(long)]
    time: bool,
}

#[derive(Debug, Args)]
struct DiffArguments {
    /// What `rederive check --json` printed before.
    old: PathBuf,
    /// What it prints now.
    new: PathBuf,
}

#[derive(Debug, Args)]
struct ErrataArguments {
    /// Documents, or folders of documents; without any, the ones inside the program.
    paths: Vec<PathBuf>,
    /// Write errata.md, errata.tex and, where TeX is installed, errata.pdf instead of printing.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print LaTeX instead of Markdown.
    #[arg(long, conflicts_with = "out")]
    latex: bool,
}

#[derive(Debug, Args)]
struct MutateArguments {
    /// Documents, or folders of documents; without any, the ones inside the program.
    paths: Vec<PathBuf>,
    /// Print one JSON object instead of tables.
    #[arg(long)]
    json: bool,
    /// What samples are drawn with.
    #[arg(long, default_value_t = 1, value_name = "N")]
    seed: u64,
    /// On how many of a document's refuted claims the search for corrections is tried: a number,
    /// `all` or `none`.
    #[arg(long, default_value = "200", value_name = "N|all|none", value_parser = amount)]
    repair: Amount,
    /// At most so many mutants and so many rewritings of each document, drawn at random.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,
}

/// How many of something.
#[derive(Clone, Copy, Debug)]
enum Amount {
    All,
    AtMost(usize),
}

fn amount(text: &str) -> Result<Amount, String> {
    match text {
        "all" => Ok(Amount::All),
        "none" => Ok(Amount::AtMost(0)),
        _ => text
            .parse()
            .map(Amount::AtMost)
            .map_err(|_| "a number, `all` or `none`".to_string()),
    }
}

#[derive(Debug, Args)]
struct Explain {
    /// The printed number, such as 61.
    equation: String,
    /// The documents to look in; without any, the ones inside the program.
    paths: Vec<PathBuf>,
}

/// Runs the program on the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help is no error; anything else is bad input.
            let code = if error.use_stderr() { 3 } else { 0 };
            let _ = error.print();
            return ExitCode::from(code);
        }
    };
    let watch = Terminal::new();
    let result = with_deep_stack(|| match arguments.command {
        Some(Commands::Explain(arguments)) => explain(&arguments, &watch),
        Some(Commands::Errata(arguments)) => errata(&arguments, &watch),
        Some(Commands::Diff(arguments)) => diff(&arguments),
        Some(Commands::Figures(arguments)) => figures(&arguments, &watch),
        Some(Commands::Methods(arguments)) => methods(&arguments, &watch),
        Some(Commands::Mutate(arguments)) => mutate(&arguments, &watch),
        Some(Commands::Check(arguments)) => check(&arguments, &watch),
        None => check(&arguments.check, &watch),
    });
    match result {
        Ok(_) if watch.interrupted() => {
            let _ = writeln!(io::stderr(), "interrupted: only what was finished is here");
            ExitCode::from(INTERRUPTED_CODE)
        }
        Ok(code) => ExitCode::from(code),
        // Whoever reads our output has had enough, as in `rederive | head`.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(io::stderr(), "error: {error}");
            ExitCode::from(3)
        }
    }
}

/// The documents that could be checked, and how many could not; these are reported at once.
fn audits(
    paths: &[PathBuf],
    options: Options,
    watch: &Terminal,
    told: Searches,
) -> io::Result<(Vec<Audit>, usize)> {
    let documents = input::read(paths);
    watch.begin("checking", documents.len());
    // Of several documents at once the lines come in any order: only people who wait get them.
    let told = match documents.len() > 1 && !io::stderr().is_terminal() {
        true => Searches::Silent,
        false => told,
    };
    // The longest first: none is left for one thread at the end.
    let length = |k: &usize| documents[*k].as_ref().map_or(0, |d| d.text.len());
    let mut order: Vec<usize> = (0..documents.len()).collect();
    order.sort_by_key(|k| std::cmp::Reverse(length(k)));
    let found = in_parallel(&order, |k| {
        let begun = !watch.stop();
        let audit = begun.then(|| match &documents[*k] {
            Ok(document) => match told {
                Searches::Told => telling(document, options, watch),
                Searches::Silent => Audit::of(document, options),
            },
            Err(rejection) => Err(rejection.clone()),
        });
        watch.advance();
        audit
    });
    let mut found: Vec<_> = order.into_iter().zip(found).collect();
    found.sort_by_key(|(k, _)| *k);
    progress::printing();
    let mut audits = Vec::new();
    let mut rejections = Vec::new();
    for audit in found.into_iter().filter_map(|(_, audit)| audit) {
        match audit {
            Ok(audit) => audits.push(audit),
            Err(rejection) => rejections.push(rejection),
        }
    }
    watch.end();
    for rejection in &rejections {
        report(rejection)?;
    }
    Ok((audits, rejections.len()))
}

/// Whether a run says what it found false before it searches for a correction.
#[derive(Clone, Copy)]
enum Searches {
    Told,
    Silent,
}

/// The same with the usual options, without a word on what is searched for.
fn silent_audits(paths: &[PathBuf], watch: &Terminal) -> io::Result<(Vec<Audit>, usize)> {
    audits(paths, Options::default(), watch, Searches::Silent)
}

fn telling(document: &Document, options: Options, watch: &Terminal) -> Result<Audit, Rejection> {
    let said = Mutex::new(BTreeSet::new());
    Audit::telling(document, options, &|model, told| {
        let equation = &model.equations[told.equation];
        let number = equation.number_of(told.member);
        let line = format!(
            "{} ({number}): false as printed; searching for a correction",
            document.name
        );
        // Each of several sizes finds it false; it is said once.
        let new = said.lock().is_ok_and(|mut said| said.insert(line.clone()));
        if new {
            watch.say(&printable_line(&line));
        }
    })
}

fn report(rejection: &Rejection) -> io::Result<()> {
    let colour = colour(io::stderr().is_terminal());
    write!(io::stderr(), "{}", rejection.render(colour))
}

fn check(arguments: &Check, watch: &Terminal) -> io::Result<u8> {
    let options = Options {
        candidates: arguments.budget,
        ..Options::default()
    };
    let (audits, rejected) = audits(&arguments.paths, options, watch, Searches::Told)?;
    let inspections: Vec<Inspection> = audits
        .into_iter()
        .map(|audit| Inspection::watched(audit, watch))
        .collect();
    let mut out = io::stdout().lock();
    if arguments.json {
        out.write_all(&output::pretty(&json::verdicts(&inspections))?)?;
    } else {
        let style = Style {
            colour: colour(out.is_terminal()),
            width: width(out.is_terminal()),
        };
        for paper in papers(&inspections) {
            writeln!(out, "{}\n{}\n", paper.title, paper.coverage())?;
        }
        for (k, inspection) in inspections.iter().enumerate() {
            if k > 0 {
                writeln!(out)?;
            }
            out.write_all(terminal::table(inspection, style).as_bytes())?;
        }
    }
    if let Some(folder) = &arguments.out {
        let pdf = output::write(folder, &inspections, &|| watch.stop())?;
        told(pdf, "report", folder)?;
    }
    out.flush()?;
    Ok(exit_code(&inspections, rejected))
}

/// Says what became of the PDF of a text.
fn told(pdf: Pdf, text: &str, folder: &Path) -> io::Result<()> {
    let said = match pdf {
        Pdf::Made(path) => format!("the {text} is {}", path.display()),
        Pdf::NoTex => format!(
            "no PDF was made: neither latexmk nor pdflatex is on the PATH; the {text} is {}",
            folder.join(format!("{text}.tex")).display()
        ),
        Pdf::Failed(complaint) => format!("no PDF was made: {complaint}"),
        Pdf::Stopped => "no PDF was made".to_string(),
    };
    writeln!(io::stderr(), "{said}")
}

fn methods(arguments: &MethodsArguments, watch: &Terminal) -> io::Result<u8> {
    let (audits, rejected) = silent_audits(&arguments.paths, watch)?;
    let mut out = io::stdout().lock();
    let mut found = false;
    for audit in &audits {
        if let Some(methods) = Methods::of(audit, arguments.time) {
            if found {
                writeln!(out)?;
            }
            found = true;
            let table = crate::report::methods::plain(&methods, arguments.time);
            out.write_all(table.as_bytes())?;
        }
    }
    if !found {
        writeln!(
            io::stderr(),
            "error: no document names points and an output for its methods"
        )?;
        return Ok(3);
    }
    Ok(if rejected > 0 { 3 } else { 0 })
}

fn mutate(arguments: &MutateArguments, watch: &Terminal) -> io::Result<u8> {
    let options = mutation::Options {
        seed: arguments.seed,
        repairs: match arguments.repair {
            Amount::All => None,
            Amount::AtMost(n) => Some(n),
        },
        limit: arguments.limit,
        ..mutation::Options::default()
    };
    let mut mutations: Vec<Mutation> = Vec::new();
    let mut rejected = 0;
    let mut out = io::stdout().lock();
    for document in input::read(&arguments.paths) {
        if watch.stop() {
            break;
        }
        match document.and_then(|d| mutation::mutate(&d, &options, watch)) {
            Ok(mutation) => {
                if !arguments.json {
                    let gap = if mutations.is_empty() { "" } else { "\n" };
                    write!(out, "{gap}{}", mutation_report::plain(&mutation))?;
                    out.flush()?;
                }
                mutations.push(mutation);
            }
            Err(rejection) => {
                rejected += 1;
                report(&rejection)?;
            }
        }
    }
    if arguments.json {
        let figures = mutation_report::json::figures(&mutations, arguments.seed);
        out.write_all(&output::pretty(&figures)?)?;
    } else if mutations.len() > 1 {
        write!(out, "\n{}", mutation_report::summary(&mutations))?;
    }
    out.flush()?;
    let (total, _) = mutation::tally::tally(&mutations);
    let (rewritings, _) = mutation::tally::kepts(&mutations);
    let faults = total.survived + total.false_alarms + rewritings.rejected;
    Ok(match (rejected, faults) {
        (0, 0) => 0,
        (0, _) => 1,
        _ => 3,
    })
}

fn explain(arguments: &Explain, watch: &Terminal) -> io::Result<u8> {
    let (audits, rejected) = silent_audits(&arguments.paths, watch)?;
    let mut out = io::stdout().lock();
    let columns = usize::from(width(out.is_terminal()).unwrap_or(100)).clamp(40, 120);
    let mut found = false;
    for audit in &audits {
        if let Some(text) = explain::explain(audit, &arguments.equation, columns) {
            if found {
                writeln!(out)?;
            }
            found = true;
            out.write_all(text.as_bytes())?;
        }
    }
    if !found {
        writeln!(
            io::stderr(),
            "error: no document has an equation ({})",
            arguments.equation
        )?;
        return Ok(3);
    }
    Ok(if rejected > 0 { 3 } else { 0 })
}

fn errata(arguments: &ErrataArguments, watch: &Terminal) -> io::Result<u8> {
    let (audits, rejected) = silent_audits(&arguments.paths, watch)?;
    let documents: Vec<&Audit> = audits.iter().collect();
    let sheets = errata::sheets(&documents);
    let mut out = io::stdout().lock();
    match &arguments.out {
        None if arguments.latex => out.write_all(errata::latex(&sheets).as_bytes())?,
        None => out.write_all(errata::markdown(&sheets).as_bytes())?,
        Some(folder) => {
            let made = output::errata(folder, &sheets, &|| watch.stop())?;
            told(made, "errata", folder)?;
        }
    }
    out.flush()?;
    Ok(if rejected > 0 { 3 } else { 0 })
}

/// The longest JSON of verdicts that is read, in bytes.
const LARGEST_RECORD: usize = 256 << 20;

fn diff(arguments: &DiffArguments) -> io::Result<u8> {
    let read = |path: &Path| {
        let text = crate::document::bytes_of(path, LARGEST_RECORD)
            .map_err(|e| e.to_string())
            .and_then(|bytes| match bytes.len() > LARGEST_RECORD {
                true => Err(format!("longer than {LARGEST_RECORD} bytes")),
                false => String::from_utf8(bytes).map_err(|e| e.to_string()),
            });
        text.and_then(|text| Recorded::read(&text)).map_err(|why| {
            let name = path.display().to_string();
            io::Error::other(format!("{}: {why}", printable_line(&name)))
        })
    };
    let changes = difference::changes(&read(&arguments.old)?, &read(&arguments.new)?);
    let mut out = io::stdout().lock();
    for change in &changes {
        writeln!(out, "{}", printable_line(&change.to_string()))?;
    }
    out.flush()?;
    Ok(u8::from(!changes.is_empty()))
}

fn figures(arguments: &Figures, watch: &Terminal) -> io::Result<u8> {
    let (audits, rejected) = silent_audits(&arguments.paths, watch)?;
    let documents: Vec<&Audit> = audits.iter().collect();
    let written = output::figures(&arguments.out, &documents)?;
    let mut out = io::stdout().lock();
    for path in &written {
        writeln!(out, "{}", path.display())?;
    }
    out.flush()?;
    let drawn = audits.iter().flat_map(|a| &a.figures);
    let undrawn = drawn.filter(|f| f.content.is_err()).count();
    Ok(match (rejected, undrawn) {
        (0, 0) => 0,
        (0, _) => 2,
        _ => 3,
    })
}

/// Colours on a terminal, unless the user wants none (https://no-color.org).
fn colour(terminal: bool) -> bool {
    terminal && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}

/// The columns of the terminal; none where the output goes elsewhere.
fn width(terminal: bool) -> Option<u16> {
    if !terminal {
        return None;
    }
    // A terminal that does not tell its width is no narrow one.
    comfy_table::Table::new()
        .width()
        .filter(|width| *width >= 20)
}
