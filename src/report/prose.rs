//! Sentences with formulas in them, written once and shown twice: in a terminal and in LaTeX.

use crate::report::latex::escape::escape;
use crate::report::latex::printed::printed;
use crate::report::plain::{greek, plain};

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words; the LaTeX writer escapes them.
    Words(String),
    /// Words that are emphasised where the medium can.
    Strong(String),
    /// A name from a program or a file.
    Code(String),
    /// A formula.
    Math {
        /// In LaTeX.
        latex: String,
        /// For a terminal.
        plain: String,
    },
}

/// A sentence.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Prose(Vec<Piece>);

impl Prose {
    /// Nothing yet.
    pub fn new() -> Self {
        Prose::default()
    }

    /// Only words.
    pub fn of(words: impl Into<String>) -> Self {
        Prose::new().words(words)
    }

    /// Free text of a document: formulas stand between dollars, names of programs between backquotes.
    pub fn text(text: &str) -> Self {
        let mut prose = Prose::new();
        let mut words = String::new();
        let mut rest = text;
        while let Some(c) = rest.chars().next() {
            match enclosed(rest, words.chars().last()) {
                Some((inner, after)) => {
                    if !words.is_empty() {
                        prose = prose.words(std::mem::take(&mut words));
                    }
                    prose = match c {
                        '$' => prose.formula(printed(inner), plain(inner)),
                        _ => prose.code(inner),
                    };
                    rest = after;
                }
                None => {
                    let begins = words.chars().last().is_none_or(|c| !c.is_alphanumeric());
                    if let Some(name) = Some(c).filter(|_| begins).and_then(|_| indexed(rest)) {
                        if !words.is_empty() {
                            prose = prose.words(std::mem::take(&mut words));
                        }
                        prose = prose.formula(printed(&spelt(name)), plain(name));
                        rest = &rest[name.len()..];
                        continue;
                    }
                    words.push(c);
                    rest = &rest[c.len_utf8()..];
                }
            }
        }
        if words.is_empty() {
            prose
        } else {
            prose.words(words)
        }
    }

    /// Appends words.
    #[must_use]
    pub fn words(mut self, words: impl Into<String>) -> Self {
        self.0.push(Piece::Words(words.into()));
        self
    }

    /// Appends emphasised words.
    #[must_use]
    pub fn strong(mut self, words: impl Into<String>) -> Self {
        self.0.push(Piece::Strong(words.into()));
        self
    }

    /// Appends a name from a program or a file.
    #[must_use]
    pub fn code(mut self, name: impl Into<String>) -> Self {
        self.0.push(Piece::Code(name.into()));
        self
    }

    /// Appends a formula in LaTeX.
    #[must_use]
    pub fn math(mut self, latex: impl Into<String>) -> Self {
        let latex = latex.into();
        let plain = plain(&latex);
        self.0.push(Piece::Math { latex, plain });
        self
    }

    /// Appends a formula in both forms.
    #[must_use]
    pub fn formula(mut self, latex: impl Into<String>, plain: impl Into<String>) -> Self {
        self.0.push(Piece::Math {
            latex: latex.into(),
            plain: plain.into(),
        });
        self
    }

    /// Appends another sentence.
    #[must_use]
    pub fn then(mut self, other: Prose) -> Self {
        self.0.extend(other.0);
        self
    }

    /// With a capital letter, where it begins with a word.
    #[must_use]
    pub fn capitalised(mut self) -> Self {
        if let Some(Piece::Words(words)) = self.0.first_mut() {
            let mut letters = words.chars();
            if let Some(first) = letters.next() {
                *words = first.to_uppercase().chain(letters).collect();
            }
        }
        self
    }

    /// What it consists of.
    pub fn pieces(&self) -> &[Piece] {
        &self.0
    }

    /// Whether nothing was said.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The same as from one list with commas.
    pub fn joined(items: impl IntoIterator<Item = Prose>, between: &str) -> Prose {
        let mut all = Prose::new();
        for (k, item) in items.into_iter().enumerate() {
            if k > 0 {
                all = all.words(between);
            }
            all = all.then(item);
        }
        all
    }

    /// For a terminal.
    pub fn to_plain(&self) -> String {
        self.0
            .iter()
            .map(|piece| match piece {
                Piece::Words(words) | Piece::Strong(words) | Piece::Code(words) => words.as_str(),
                Piece::Math { plain, .. } => plain,
            })
            .collect()
    }

    /// For TeX.
    pub fn to_latex(&self) -> String {
        self.written(["$", "$"], |piece| match piece {
            Piece::Words(words) => escape(words),
            Piece::Strong(words) => format!("\\textbf{{{}}}", escape(words)),
            Piece::Code(words) => crate::report::latex::escape::code(words),
            Piece::Math { latex, .. } => latex.clone(),
        })
    }

    /// Piece by piece in a language with these delimiters of formulas. Neighbouring formulas are one,
    /// so that a line may break at the relation between them.
    pub fn written(&self, delimiters: [&str; 2], piece: impl Fn(&Piece) -> String) -> String {
        let is_math = |k: Option<usize>| {
            let piece = k.and_then(|k| self.0.get(k));
            matches!(piece, Some(Piece::Math { .. }))
        };
        let mut out = String::new();
        for (k, one) in self.0.iter().enumerate() {
            let math = is_math(Some(k));
            if math && !is_math(k.checked_sub(1)) {
                out += delimiters[0];
            }
            out += &piece(one);
            if math && !is_math(Some(k + 1)) {
                out += delimiters[1];
            }
        }
        out
    }
}

/// The letter with an index or an exponent that a text begins with, such as `c_R`, `Φ_0` or `v^3`: words
/// have none.
fn indexed(text: &str) -> Option<&str> {
    let first = text.chars().next()?;
    let is_letter = first.is_ascii_alphabetic() || ('α'..='Ω').contains(&first) || is_greek(first);
    if !is_letter {
        return None;
    }
    let mut end = first.len_utf8();
    let mut scripts = 0;
    while let Some(mark) = text[end..]
        .chars()
        .next()
        .filter(|c| matches!(c, '_' | '^'))
    {
        let inner = &text[end + mark.len_utf8()..];
        let length = match inner.strip_prefix('{') {
            Some(group) => group.find('}').filter(|_| !group.contains(['\\', '$']))? + 2,
            None => {
                let digits = inner.bytes().take_while(u8::is_ascii_digit).count();
                let next = inner.chars().next().filter(|c| c.is_ascii_alphabetic());
                digits.max(next.map_or(0, char::len_utf8))
            }
        };
        if length == 0 {
            return None;
        }
        end += mark.len_utf8() + length;
        scripts += 1;
    }
    let after = text[end..].chars().next();
    (scripts > 0 && !after.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_'))
        .then(|| &text[..end])
}

fn is_greek(c: char) -> bool {
    ('α'..='ω').contains(&c) || ('Α'..='Ω').contains(&c)
}

/// The same in LaTeX, which has words for Greek letters.
fn spelt(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        match greek(c) {
            Some(word) => out += &format!("\\{word} "),
            None => out.push(c),
        }
    }
    out
}

/// What stands between the sign that a text begins with and the next one, and what follows: for a
/// dollar only where it can be no price.
fn enclosed(text: &str, before: Option<char>) -> Option<(&str, &str)> {
    let sign = text.chars().next().filter(|c| matches!(c, '$' | '`'))?;
    let inner = &text[1..];
    let end = inner.find(sign)?;
    let (inner, after) = (&inner[..end], &inner[end + 1..]);
    let is_blank = |c: Option<char>| c.is_none_or(char::is_whitespace);
    let tight = !is_blank(inner.chars().next()) && !is_blank(inner.chars().last());
    let price = sign == '$'
        && (after.starts_with(|c: char| c.is_ascii_digit())
            || before.is_some_and(|c| c == '\\' || c.is_ascii_digit()));
    (tight && !price).then_some((inner, after))
}

/// A paragraph, a displayed formula or a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// A paragraph.
    Paragraph(Prose),
    /// A formula on lines of its own.
    Display {
        /// In LaTeX.
        latex: String,
        /// For a terminal.
        plain: String,
    },
    /// Rows under a head.
    Table {
        /// The head.
        head: Vec<String>,
        /// The rows, as long as the head.
        rows: Vec<Vec<Prose>>,
    },
}

impl Block {
    /// A paragraph.
    pub fn paragraph(prose: Prose) -> Self {
        Block::Paragraph(prose)
    }
}

#[cfg(test)]
mod tests {
    use super::Prose;

    #[test]
    fn formulas_and_names_in_free_text_are_told_from_prices() {
        for (text, latex, terminal) in [
            (
                "the slope $-w$ of $\\Phi$, see `rederive explain`",
                "the slope $-w$ of $\\Phi$, see \\texttt{rederive explain}",
                "the slope -w of Φ, see rederive explain",
            ),
            ("5 $ and 6 $", "5 \\$ and 6 \\$", "5 $ and 6 $"),
            ("from $5 to $6", "from \\$5 to \\$6", "from $5 to $6"),
            (
                "the tyre c_R, Φ_0 and v^3 of H_{01}, not snake_case",
                "the tyre $c_R$, $\\Phi _0$ and $v^3$ of $H_{01}$, not snake\\_case",
                "the tyre c_R, Φ_0 and v^3 of H_01, not snake_case",
            ),
            ("a ` alone", "a \\textasciigrave{} alone", "a ` alone"),
            (
                "$$ and ``",
                "\\$\\$ and \\textasciigrave{}\\textasciigrave{}",
                "$$ and ``",
            ),
        ] {
            assert_eq!(Prose::text(text).to_plain(), terminal);
            assert_eq!(
                Prose::text(text).to_latex().replace("\\allowbreak{}", ""),
                latex
            );
        }
    }

    #[test]
    fn a_formula_in_free_text_cannot_act() {
        let latex = Prose::text("see $\\input{/etc/passwd}$ there").to_latex();
        assert!(!latex.contains("\\input"), "{latex}");
    }
}
