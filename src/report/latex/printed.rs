//! Equations as they are printed, safe to hand to TeX.
//!
//! A document's LaTeX goes into the report only through here: every control word is on the list
//! below, texts are escaped, comments and equation numbers are dropped, environments that cannot
//! stand inside a display are replaced by those that can. What is not understood is printed as
//! program text.

use super::escape::{code, escape};

/// Control words that typeset and do nothing else.
const HARMLESS: &str = " alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota \
    kappa lambda mu nu xi pi varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega \
    Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega ell hbar frac tfrac dfrac sum int \
    infty underbrace underline partial ldots dots cdots cdot times prime top ne neq lt gt le leq ge geq sim \
    approx to rightarrow longrightarrow det Re Im cos sin exp ln log sqrt mathbf boldsymbol \
    mathcal mathbb tilde widetilde hat widehat bar overline vec dot ddot dddot ddddot mathrm \
    operatorname mathsf displaystyle textstyle scriptstyle limits nolimits big Big bigg Bigg bigl \
    Bigl biggl Biggl bigr Bigr biggr Biggr left right quad qquad vert lvert rvert Vert ";

/// Control words with a stand-in from the packages that the report loads.
fn stand_in(word: &str) -> Option<&'static str> {
    Some(match word {
        "bm" => "\\boldsymbol",
        "intercal" => "\\top",
        "leqslant" => "\\leq",
        "geqslant" => "\\geq",
        "nonumber" | "notag" => "",
        _ => return None,
    })
}

/// The environment that stands for this one inside a display; none where only its body stays.
fn environment(name: &str) -> Option<Option<&'static str>> {
    Some(match name.trim_end_matches('*') {
        "aligned" | "align" | "alignat" | "alignedat" | "split" | "eqnarray" => Some("aligned"),
        "gathered" | "gather" | "multline" | "multlined" => Some("gathered"),
        "equation" => None,
        "bmatrix" => Some("bmatrix"),
        "pmatrix" => Some("pmatrix"),
        "Bmatrix" => Some("Bmatrix"),
        "matrix" => Some("matrix"),
        "smallmatrix" => Some("smallmatrix"),
        "vmatrix" => Some("vmatrix"),
        "array" => Some("array"),
        "cases" => Some("cases"),
        _ => return None,
    })
}

/// What may stand between the dollars of a display.
pub fn printed(source: &str) -> String {
    let mut reader = Reader {
        rest: source.trim(),
        out: String::new(),
        depth: 0,
        lines: false,
    };
    if reader.read().is_none() || reader.depth != 0 {
        return code(source);
    }
    let text = reader.out.trim().to_string();
    if reader.lines {
        format!("\\begin{{aligned}}\n{text}\n\\end{{aligned}}")
    } else {
        text
    }
}

struct Reader<'s> {
    rest: &'s str,
    out: String,
    /// Open environments.
    depth: usize,
    /// Whether lines or columns occur outside every environment.
    lines: bool,
}

impl<'s> Reader<'s> {
    fn read(&mut self) -> Option<()> {
        let mut braces = 0i64;
        while let Some(c) = self.take() {
            match c {
                '\\' => self.command()?,
                '%' => {
                    let end = self.rest.find('\n').unwrap_or(self.rest.len());
                    self.rest = &self.rest[end..];
                }
                '&' => {
                    self.lines |= self.depth == 0;
                    self.out.push('&');
                }
                '{' | '}' => {
                    braces += if c == '{' { 1 } else { -1 };
                    if braces < 0 {
                        return None;
                    }
                    self.out.push(c);
                }
                '^' if self.rest.starts_with('^') => return None,
                '$' | '#' | '~' | '"' | '`' => return None,
                // A blank line would end the display.
                c if c.is_whitespace() => {
                    if !self.out.ends_with([' ', '\n']) {
                        self.out.push(if c == '\n' { '\n' } else { ' ' });
                    }
                }
                c if c.is_ascii_graphic() => self.out.push(c),
                _ => return None,
            }
        }
        (braces == 0).then_some(())
    }

    fn take(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    fn word(&mut self) -> &'s str {
        let end = self
            .rest
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word
    }

    /// The text of a brace group without braces in it.
    fn plain_group(&mut self) -> Option<&'s str> {
        let inner = self.rest.trim_start().strip_prefix('{')?;
        let end = inner.find(['{', '}'])?;
        if !inner[end..].starts_with('}') {
            return None;
        }
        self.rest = &inner[end + 1..];
        Some(&inner[..end])
    }

    fn command(&mut self) -> Option<()> {
        let word = self.word();
        if word.is_empty() {
            let c = self.take()?;
            match c {
                '\\' => {
                    self.lines |= self.depth == 0;
                    self.rest = self.rest.strip_prefix('*').unwrap_or(self.rest);
                    self.out.push_str("\\\\");
                    // A bracket on the next line is no distance.
                    self.out.push_str("\\relax ");
                }
                '{' | '}' | ' ' | ',' | ';' | ':' | '!' | '|' | '%' | '&' => {
                    self.out.push('\\');
                    self.out.push(c);
                }
                '\n' => self.out.push_str("\\ "),
                _ => return None,
            }
            return Some(());
        }
        match word {
            "text" | "mbox" | "textrm" | "textnormal" => {
                let text = escape(self.plain_group()?);
                self.out += &format!("\\text{{{text}}}");
            }
            "tag" | "label" => {
                self.plain_group()?;
            }
            "begin" | "end" => {
                let name = environment(self.plain_group()?)?;
                let begins = word == "begin";
                if let Some(name) = name {
                    self.out += &format!("\\{word}{{{name}}}");
                }
                if begins {
                    self.depth += 1;
                } else {
                    self.depth = self.depth.checked_sub(1)?;
                }
                if begins && name == Some("array") {
                    let columns = self.plain_group()?;
                    if !columns.chars().all(|c| "lcr| ".contains(c)) {
                        return None;
                    }
                    self.out += &format!("{{{columns}}}");
                }
            }
            _ => match stand_in(word) {
                Some(other) => self.out.push_str(other),
                None if HARMLESS.contains(&format!(" {word} ")) => {
                    self.out += &format!("\\{word}");
                }
                None => return None,
            },
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_printed_stays() {
        for source in [
            "\\det H = a_4H_3 = ac(c^2de).",
            "\\begin{bmatrix} a & b \\end{bmatrix}^T",
            "\\underbrace{x}_{\\mathbf{x}}",
        ] {
            assert_eq!(printed(source), source);
        }
        assert_eq!(
            printed("a &= b"),
            "\\begin{aligned}\na &= b\n\\end{aligned}"
        );
        assert_eq!(printed("a = b \\tag{3}"), "a = b");
        assert_eq!(printed("x = \\text{const}."), "x = \\text{const}.");
    }

    #[test]
    fn nothing_reaches_tex_that_could_act() {
        for source in [
            "a = \\input{/etc/passwd}",
            "\\immediate\\write18{ls}",
            "\\text{\\input{x}}",
            "\\def\\x{y}",
            "a ^^5cinput b",
            "\\catcode`\\@=0",
            "a = b}",
            "{a",
            "$$ \\bye",
            "\\end{document}",
            "\\begin{verbatim}",
            "\\end{equation*}",
            "\\csname input\\endcsname",
            "\\begin{array}{>{\\input{x}}l} a \\end{array}",
        ] {
            assert!(printed(source).starts_with("\\texttt{"), "{source}");
        }
        assert_eq!(printed("a % \\input{x}\n= b"), "a = b");
        assert_eq!(printed("\\text{50% & more}"), "\\text{50\\% \\& more}");
    }
}
