//! The sheet in LaTeX.

use super::{Erratum, Sheet};
use crate::report::latex::Tex;
use crate::report::latex::escape::escape;
use crate::report::latex::preamble::HEAD;
use crate::report::prose::Prose;

/// All sheets as one article.
pub fn latex(sheets: &[Sheet]) -> String {
    let mut tex = Tex::default();
    tex.line(HEAD.trim_end());
    let title = match sheets {
        [only] => format!("Errata: {}", escape(&only.title)),
        _ => "Errata".to_string(),
    };
    tex.line(&format!(
        "\\title{{{title}}}\n\\author{{rederive {}}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle",
        escape(env!("CARGO_PKG_VERSION"))
    ));
    if sheets.iter().all(Sheet::is_empty) {
        tex.line("Nothing to mend.");
    }
    for sheet in sheets.iter().filter(|s| !s.is_empty()) {
        if sheets.len() > 1 {
            tex.line(&format!("\\section{{{}}}", escape(&sheet.title)));
        }
        write(&mut tex, sheet);
    }
    tex.line("\\end{document}");
    tex.finish()
}

fn write(tex: &mut Tex, sheet: &Sheet) {
    for source in &sheet.sources {
        tex.paragraph(&Prose::of(format!("Checked: {source}.")));
    }
    tex.paragraph(&Prose::of(format!("{}.", sheet.summary())).capitalised());
    let [theirs, ours] = sheet.by_source();
    for (title, errata) in [
        ("Equations", theirs),
        ("To be compared with the printed page first", ours),
    ] {
        if errata.is_empty() {
            continue;
        }
        tex.heading(title);
        for one in errata {
            erratum(tex, one);
        }
    }
    if !sheet.unwritten.is_empty() {
        tex.heading("Relations that are used and not written");
        for unwritten in &sheet.unwritten {
            let line = unwritten.relations.clone();
            tex.paragraph(&line.words(format!(" for {}.", unwritten.equations.join(", "))));
        }
    }
    if !sheet.sentences.is_empty() {
        tex.heading("Sentences");
        for sentence in &sheet.sentences {
            tex.line(&format!(
                "\n\\begin{{quote}}{}\\end{{quote}}",
                escape(&sentence.text)
            ));
            for fact in &sentence.facts {
                tex.paragraph(&fact.clone().words("."));
            }
        }
    }
}

fn erratum(tex: &mut Tex, one: &Erratum) {
    tex.line(&format!(
        "\n\\paragraph{{{}}} is printed as",
        escape(&one.location)
    ));
    tex.display(&one.printed);
    if let Some(corrected) = &one.corrected {
        tex.line("and should read");
        tex.display(corrected);
    }
    let mut line = Prose::of("Correction: ")
        .then(one.correction.clone())
        .words(". ");
    if !one.why.is_empty() {
        line = line.words("Why: ").then(one.why.clone()).words(". ");
    }
    if let Some(effect) = &one.effect {
        line = line.words("Effect: ").then(effect.clone()).words(". ");
    }
    if let Some((source, because)) = &one.source {
        line = line.words(format!("Likelier the {}'s", source.as_str()));
        line = match because.is_empty() {
            true => line.words(". "),
            false => line.words(format!(": {because}. ")),
        };
    }
    if let Some(note) = &one.note {
        line = line.words(format!("Note: {note}"));
    }
    tex.paragraph(&line);
}
