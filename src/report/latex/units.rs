//! What the check of the units found.

use super::Tex;
use super::escape::escape;
use crate::audit::Audit;
use crate::latex;
use crate::report::prose::Prose;
use crate::report::terminal::{has_units, units_by_equation};

pub(super) fn write(tex: &mut Tex, audit: &Audit) {
    if !has_units(audit) && audit.units.is_empty() {
        return;
    }
    tex.heading("Units");
    tex.paragraph(&Prose::of(
        "Every equation was checked for dimensional homogeneity, entry by entry for matrices and \
         apart from the algebra. A letter without a declared unit gets one from its uses.",
    ));
    if audit.units.is_empty() {
        tex.paragraph(&Prose::of("All of them are homogeneous."));
        return;
    }
    let rows: Vec<Vec<String>> = units_by_equation(audit)
        .into_iter()
        .map(|(finding, more)| {
            // The unit of a letter that has none is written as the letter in brackets.
            let words = finding
                .to_string()
                .replace("[\\", "[$\\")
                .replace(")]", ")$]");
            let mut what = Prose::text(&words).to_latex();
            if more > 0 {
                what += &format!("; {more} more such places");
            }
            if !finding.suspects.is_empty() {
                let names: Vec<String> = finding
                    .suspects
                    .iter()
                    .map(|name| format!("${}$", latex::canonical(name)))
                    .collect();
                what += &format!(" (perhaps because of {})", names.join(", "));
            }
            vec![format!("({})", escape(&finding.label)), what]
        })
        .collect();
    let head = ["Equation", "Finding"].map(String::from);
    tex.table(&[0.15, 0.78], &head, &rows);
}
