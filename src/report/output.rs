//! Files in the output folder, each written whole or not at all, and the PDF where a TeX is near.

use crate::audit::Audit;
use crate::inspection::Inspection;
use crate::report::csv::csv;
use crate::report::drawing::{scene, svg};
use crate::report::errata::{self, Sheet};
use crate::report::{json, latex, vectors};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What became of the PDF.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pdf {
    /// It is there.
    Made(PathBuf),
    /// Neither latexmk nor pdflatex is on the path.
    NoTex,
    /// TeX stopped; its first complaint.
    Failed(String),
    /// Nobody waits for it any more.
    Stopped,
}

/// Writes `report.tex`, `verdicts.json`, `vectors.json`, the figures and, where TeX is installed,
/// `report.pdf`, which takes longest and is left out once `stop` says so.
///
/// # Errors
/// When the folder cannot be made or a file cannot be written.
pub fn write(
    folder: &Path,
    inspections: &[Inspection],
    stop: &dyn Fn() -> bool,
) -> io::Result<Pdf> {
    create(folder)?;
    let audits: Vec<&Audit> = inspections.iter().map(|i| &i.audit).collect();
    figures(folder, &audits)?;
    let report = latex::report(inspections);
    replace(
        &folder.join("verdicts.json"),
        &pretty(&json::verdicts(inspections))?,
    )?;
    replace(
        &folder.join("vectors.json"),
        &pretty(&vectors::vectors(inspections))?,
    )?;
    replace(&folder.join("report.tex"), report.as_bytes())?;
    if stop() {
        return Ok(Pdf::Stopped);
    }
    pdf(folder, "report", &report)
}

/// Writes `errata.md`, `errata.tex` and, where TeX is installed, `errata.pdf`.
///
/// # Errors
/// When the folder cannot be made or a file cannot be written.
pub fn errata(folder: &Path, sheets: &[Sheet], stop: &dyn Fn() -> bool) -> io::Result<Pdf> {
    create(folder)?;
    let text = errata::latex(sheets);
    replace(
        &folder.join("errata.md"),
        errata::markdown(sheets).as_bytes(),
    )?;
    replace(&folder.join("errata.tex"), text.as_bytes())?;
    if stop() {
        return Ok(Pdf::Stopped);
    }
    pdf(folder, "errata", &text)
}

/// Writes `quarter-car-figure-4.svg` for each figure of a document `quarter-car.md`, and where it
/// shows numbers these as `quarter-car-figure-4.csv`. Returns the paths.
///
/// # Errors
/// When the folder cannot be made or a file cannot be written.
pub fn figures(folder: &Path, audits: &[&Audit]) -> io::Result<Vec<PathBuf>> {
    let mut written = Vec::new();
    let stems = stems(audits);
    for (audit, stem) in audits.iter().zip(stems) {
        for figure in &audit.figures {
            let Some(scene) = scene(figure) else { continue };
            create(folder)?;
            let path = folder.join(format!("{stem}-figure-{}.svg", figure.label));
            replace(&path, svg(&scene).as_bytes())?;
            written.push(path);
            if let Some(table) = figure.table() {
                let path = folder.join(format!("{stem}-figure-{}.csv", figure.label));
                replace(&path, csv(&table).as_bytes())?;
                written.push(path);
            }
        }
    }
    Ok(written)
}

/// A name for each document's files: the document's own, led by those of its folders where two
/// documents have the same.
fn stems(audits: &[&Audit]) -> Vec<String> {
    let parts: Vec<Vec<String>> = audits
        .iter()
        .map(|audit| {
            let name = &audit.model.document.name;
            let name = name.strip_suffix(".md").unwrap_or(name);
            let plain = |part: &str| -> String {
                let keep = |c: char| if c.is_alphanumeric() { c } else { '-' };
                part.chars().map(keep).collect()
            };
            let parts = name
                .split(['/', '\\'])
                .filter(|p| !matches!(*p, "" | "." | ".."));
            parts.map(plain).collect()
        })
        .collect();
    let tail = |parts: &[String], n: usize| parts[parts.len().saturating_sub(n)..].join("-");
    parts
        .iter()
        .enumerate()
        .map(|(k, own)| {
            let unique = |n: &usize| {
                let name = tail(own, *n);
                parts
                    .iter()
                    .enumerate()
                    .all(|(j, p)| j == k || tail(p, *n) != name)
            };
            match (1..=own.len()).find(unique) {
                Some(n) => tail(own, n),
                None => format!("{}-{}", tail(own, own.len()), k + 1),
            }
        })
        .collect()
}

/// JSON with one value a line and a newline at the end.
///
/// # Errors
/// None in practice: every key is a string.
pub fn pretty(value: &impl serde::Serialize) -> io::Result<Vec<u8>> {
    let mut bytes = serde_json::to_vec_pretty(value)?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// Writes under another name and renames, so that no reader and no interruption sees a half.
fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let temporary = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
    let result = fs::write(&temporary, bytes).and_then(|()| fs::rename(&temporary, path));
    if result.is_err() {
        let _ = fs::remove_file(&temporary);
    }
    result.map_err(|error| at(path, &error))
}

/// Creates a folder and those around it.
fn create(folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder).map_err(|error| at(folder, &error))
}

/// An error that names its path, whose characters a terminal may be shown.
fn at(path: &Path, error: &io::Error) -> io::Error {
    let name = crate::diagnostic::printable_line(&path.display().to_string()).to_string();
    io::Error::new(error.kind(), format!("{name}: {error}"))
}

/// Runs TeX in a folder of its own inside the output folder, without a shell to escape to and
/// without leave to read or write elsewhere.
fn pdf(folder: &Path, name: &str, text: &str) -> io::Result<Pdf> {
    let work = folder.join(format!(".tex.{}.part", std::process::id()));
    create(&work)?;
    let result = compiled(&work, text).and_then(|pdf| match pdf {
        Pdf::Made(made) => {
            let path = folder.join(format!("{name}.pdf"));
            fs::rename(made, &path)?;
            Ok(Pdf::Made(path))
        }
        other => Ok(other),
    });
    fs::remove_dir_all(&work)?;
    result
}

fn compiled(work: &Path, text: &str) -> io::Result<Pdf> {
    fs::write(work.join("text.tex"), text)?;
    let common = [
        "-interaction=nonstopmode",
        "-halt-on-error",
        "-no-shell-escape",
    ];
    let run = |program: &str, arguments: &[&str]| {
        Command::new(program)
            .args(arguments)
            .args(common)
            .arg("text.tex")
            .current_dir(work)
            .env("SOURCE_DATE_EPOCH", "0")
            .env("FORCE_SOURCE_DATE", "1")
            .env("openin_any", "p")
            .env("openout_any", "p")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
    };
    let absent = |e: &io::Error| e.kind() == io::ErrorKind::NotFound;
    let succeeded = match run("latexmk", &["-pdf", "-norc"]) {
        Ok(status) => status.success(),
        Err(error) if absent(&error) => {
            let mut succeeded = true;
            // The widths of long tables settle in the third run.
            for _ in 0..3 {
                match run("pdflatex", &[]) {
                    Ok(status) => succeeded &= status.success(),
                    Err(error) if absent(&error) => return Ok(Pdf::NoTex),
                    Err(error) => return Err(error),
                }
            }
            succeeded
        }
        Err(error) => return Err(error),
    };
    let made = work.join("text.pdf");
    if succeeded && made.is_file() {
        return Ok(Pdf::Made(made));
    }
    let log = fs::read(work.join("text.log")).unwrap_or_default();
    let log = String::from_utf8_lossy(&log);
    let complaint = log.lines().find(|line| line.starts_with('!'));
    Ok(Pdf::Failed(complaint.unwrap_or("TeX stopped").to_string()))
}
