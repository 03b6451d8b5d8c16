//! The head of the report, the words on the method, and the texts that were read.

use super::escape::{code, escape};
use crate::inspection::Inspection;
use crate::report::drawing::MACROS;
use crate::report::json::sha256;

/// The class, the packages and the macros for formulas.
pub(crate) const HEAD: &str = r"\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{amsmath,amssymb}
\usepackage{array,booktabs,longtable}
\usepackage{pgf}
\setlength{\textwidth}{160mm}
\setlength{\oddsidemargin}{0mm}
\setlength{\evensidemargin}{0mm}
\setlength{\textheight}{235mm}
\setlength{\topmargin}{-5mm}
\setlength{\emergencystretch}{3em}
% Fractions in the text do not touch the lines above.
\setlength{\lineskiplimit}{2pt}
\setlength{\lineskip}{3pt}
\setlength{\LTleft}{0pt}
\setlength{\LTright}{0pt plus 1fill}
\allowdisplaybreaks
\setcounter{tocdepth}{1}
% The same input gives the same bytes.
\ifdefined\pdftrailerid\pdftrailerid{}\fi
\ifdefined\pdfsuppressptexinfo\pdfsuppressptexinfo=-1\fi
% \keeproom: a heading does not stand alone at the foot of a page.
\newcommand{\keeproom}[1][9]{\par\ifdim\pagegoal<\maxdimen
  \ifdim\dimexpr\pagegoal-\pagetotal\relax<#1\baselineskip\newpage\fi\fi}
% \fitted{number}{formula}: a display in the largest size in which it fits its line.
\newsavebox{\fitbox}
\newsavebox{\fitnumber}
\newcommand{\fitset}[2]{\ifx\relax#1\relax\[#2\]\else\begin{equation*}#2\tag*{#1}\end{equation*}\fi}
\newcommand{\fitin}[4]{#1\sbox{\fitnumber}{#2}\sbox{\fitbox}{$\displaystyle#3$}%
  \ifdim\dimexpr\wd\fitbox+2\wd\fitnumber+1em\relax<\linewidth\fitset{#2}{#3}\else#4\fi}
\newcommand{\fitted}[2]{\begingroup
  \fitin{\normalsize}{#1}{#2}{\fitin{\small}{#1}{#2}{\fitin{\footnotesize}{#1}{#2}{%
  \fitin{\scriptsize}{#1}{#2}{\tiny\fitset{#1}{#2}}}}}\endgroup}
";

/// Everything before the first section: packages and title.
pub(super) fn preamble(inspections: &[Inspection]) -> String {
    let mut out = String::from(HEAD);
    out += MACROS;
    // The paper that all documents with one are of: others may say what it builds on.
    let mut papers = inspections.iter().filter_map(paper_of);
    let first = papers.next();
    let title = match (inspections, first) {
        ([only], _) => Some(&only.audit.model.document.title[..]),
        (_, Some(title)) if papers.all(|other| other == title) => Some(title),
        _ => None,
    };
    let title = title.map_or("Equations re-derived".to_string(), |title| {
        format!("{}: a re-derivation", escape(title))
    });
    out += &format!(
        "\\title{{{title}}}\n\\author{{rederive {}}}\n\\date{{}}\n",
        escape(env!("CARGO_PKG_VERSION"))
    );
    out += "\\begin{document}\n\\maketitle\n";
    out
}

/// The title of the paper that a document covers a part of.
fn paper_of(inspection: &Inspection) -> Option<&str> {
    let paper = inspection.audit.model.document.paper.as_ref()?;
    Some(&paper.title.text)
}

/// The heading of a document: its title, without that of the paper which all are of.
pub(super) fn heading(inspection: &Inspection) -> String {
    let title = &inspection.audit.model.document.title[..];
    // Titles of papers may begin with their authors.
    let own = title.split_once(": ").filter(|(of, _)| {
        let paper = paper_of(inspection);
        paper.is_some_and(|paper| paper.ends_with(of))
    });
    let Some((_, own)) = own else {
        return escape(title);
    };
    let mut letters = own.chars();
    let first = letters.next().map(char::to_uppercase);
    escape(
        &first
            .into_iter()
            .flatten()
            .chain(letters)
            .collect::<String>(),
    )
}

/// The texts that were read, so that anyone can tell whether a text is the one that was checked.
pub(super) fn documents(inspections: &[Inspection]) -> String {
    let mut out = String::from("\n\\section*{Documents}\n\nEach with the SHA-256 of its text.\n");
    out += "\n{\\footnotesize\\begin{longtable}{@{}l@{}}\n\\toprule\n";
    for inspection in inspections {
        let document = &inspection.audit.model.document;
        out += &format!(
            "{} \\\\*\n\\quad {} \\\\\n",
            code(&document.name),
            code(&sha256(&document.text))
        );
    }
    out += "\\bottomrule\n\\end{longtable}}\n";
    out
}

/// How a verdict is reached.
pub(super) const METHOD: &str = r#"
\section{How the equations were checked}

Every equation was read from its printed form. Each pair of neighbours in a chain of equalities is a
link of its own, numbered in the order of reading: (61.2) is the second link of equation~(61). Both
sides of a link are evaluated exactly, as rational functions with rational coefficients in the letters
of the document; matrices entry by entry. No floating-point number and no random number decides a
verdict.

A link \emph{holds} if both sides are the same rational function of the printed letters, or become so
when the definitions of those letters are inserted that it spells out itself. It \emph{holds given} a
relation if the sides differ as functions of the printed letters and agree once all definitions are
inserted: the letters then satisfy relations that are not printed. These are found by eliminating the
definitions (a Gr\"obner basis), and the difference of the sides is written as a combination of them,
the certificate. Whatever survives the insertion of all definitions is false. For a false link all
small changes of its printed form are tried, in the order of their number: signs, indices, exponents,
factors, letters, dots. If one makes it true it is a \emph{misprint} and the change is its correction,
and what follows is computed from the corrected equation; otherwise it is \emph{refuted}. A link is
\emph{undecided} if a limit of time or size was met or if it lies outside of what can be decided here;
this is never counted as true. A \emph{definition} gives a name its value, and what is \emph{recalled}
is stated without anything to check.

Each certificate was checked by multiplying out. Each division leaves the condition that its divisor
does not vanish; the conditions stand with the first equation that needs them.
"#;
