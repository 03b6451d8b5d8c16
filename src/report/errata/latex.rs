//! The sheet in LaTeX.

use super::{Erratum, Sentence, Sheet};
use crate::document::Source;
use crate::report::latex::Tex;
use crate::report::latex::escape::escape;
use crate::report::latex::preamble::HEAD;
use crate::report::latex::printed::printed;
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

/// One sheet, without its title.
pub(crate) fn write(tex: &mut Tex, sheet: &Sheet) {
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
        tex.heading("What is used and not written");
        for unwritten in &sheet.unwritten {
            let mut line = unwritten.relations.clone();
            line = line.words(format!(" for {}.", unwritten.equations.join(", ")));
            if let Some(note) = &unwritten.note {
                line = line.words(" ").then(note.clone());
            }
            tex.paragraph(&line);
        }
    }
    for (title, sentences) in sheet.groups() {
        if sentences.is_empty() {
            continue;
        }
        tex.heading(title);
        for one in sentences {
            sentence(tex, one);
        }
    }
    if !sheet.remarks.is_empty() {
        tex.heading("Notation");
        for remark in &sheet.remarks {
            tex.paragraph(remark);
        }
    }
}

fn erratum(tex: &mut Tex, one: &Erratum) {
    tex.line(&format!(
        "\n\\paragraph{{{}}} is printed as",
        escape(&one.location)
    ));
    tex.display(&printed(&one.printed));
    if let Some(corrected) = &one.corrected {
        tex.line("and should read");
        tex.display(&printed(corrected));
    }
    let mut items: Vec<Prose> = Vec::new();
    for (title, lines) in [
        ("Correction", &one.corrections),
        ("Why", &one.why),
        ("Effect", &one.effects),
    ] {
        if !lines.is_empty() {
            let all = Prose::joined(lines.iter().cloned(), "; ");
            items.push(Prose::of(format!("{title}: ")).then(all).words("."));
        }
    }
    items.extend(source(&one.source));
    items.extend(one.note.as_ref().map(noted));
    tex.list(&items);
}

/// Where a slip came in.
fn source(source: &Option<(Source, Prose)>) -> Option<Prose> {
    let (source, because) = source.as_ref()?;
    let line = Prose::of(format!("Likelier the {}'s", source.as_str()));
    Some(match because.is_empty() {
        true => line.words("."),
        false => line.words(": ").then(because.clone()).words("."),
    })
}

fn noted(note: &Prose) -> Prose {
    Prose::of("Note: ").then(note.clone())
}

fn sentence(tex: &mut Tex, one: &Sentence) {
    let quoted = |tex: &mut Tex, text: &Prose| {
        tex.line(&format!(
            "\n\\begin{{quote}}{}\\end{{quote}}",
            text.to_latex()
        ));
    };
    let text = match &one.place {
        Some(place) => one.text.clone().words(" (").then(place.clone()).words(")"),
        None => one.text.clone(),
    };
    quoted(tex, &text);
    if let Some(reads) = &one.reads {
        tex.line("It should read:");
        quoted(tex, reads);
    }
    if let Some((formula, corrected)) = &one.formula {
        tex.line("As a formula");
        tex.display(&printed(formula));
        if let Some(corrected) = corrected {
            tex.line("and should be");
            tex.display(&printed(corrected));
        }
    }
    let mut line = Prose::new();
    for fact in &one.facts {
        line = line.then(fact.clone().capitalised()).words(". ");
    }
    if let Some(source) = source(&one.source) {
        line = line.then(source).words(" ");
    }
    tex.paragraph(&match &one.note {
        Some(note) => line.then(noted(note)),
        None => line,
    });
}
