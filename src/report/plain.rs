//! LaTeX for a terminal: names and equations without backslashes and braces.
//!
//! For the eye only: nothing reads it back. Greek letters become what they are, bold letters
//! lose their weight, dots become primes, matrices become rows between brackets.

/// A printed name.
pub fn plain_name(latex: &str) -> String {
    plain(latex).replace(' ', "")
}

/// A printed formula.
pub fn plain(latex: &str) -> String {
    let mut reader = Reader {
        rest: latex,
        out: String::new(),
    };
    reader.read(None);
    tidy(&reader.out)
}

const GREEK: [(&str, &str); 40] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("varepsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("vartheta", "ϑ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("varpi", "ϖ"),
    ("rho", "ρ"),
    ("varrho", "ϱ"),
    ("sigma", "σ"),
    ("varsigma", "ς"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("varphi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("ell", "ℓ"),
];

/// The control word of a Greek letter.
pub fn greek(letter: char) -> Option<&'static str> {
    let found = GREEK.iter().find(|(_, shown)| shown.chars().eq([letter]));
    found.map(|(word, _)| *word)
}

const SYMBOLS: [(&str, &str); 28] = [
    ("sum", "Σ"),
    ("int", "∫"),
    ("infty", "∞"),
    ("partial", "∂"),
    ("cdot", "·"),
    ("times", "×"),
    ("le", "≤"),
    ("leq", "≤"),
    ("leqslant", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("geqslant", "≥"),
    ("ne", "≠"),
    ("neq", "≠"),
    ("approx", "≈"),
    ("sim", "~"),
    ("to", "→"),
    ("rightarrow", "→"),
    ("ldots", "..."),
    ("dots", "..."),
    ("cdots", "..."),
    ("prime", "'"),
    ("top", "T"),
    ("intercal", "T"),
    ("lt", "<"),
    ("gt", ">"),
    ("hbar", "ħ"),
    ("det", "det "),
];

/// Spaces inside of a formula.
const SPACES: [&str; 5] = ["\\,", "\\;", "\\:", "\\ ", "\\!"];

struct Reader<'l> {
    rest: &'l str,
    out: String,
}

impl Reader<'_> {
    fn read(&mut self, end: Option<char>) {
        while let Some(c) = self.take() {
            if Some(c) == end {
                return;
            }
            match c {
                '\\' => self.command(),
                '{' => self.group(),
                '}' => {}
                '^' | '_' => self.script(c),
                '&' => self.out.push(' '),
                c if c.is_whitespace() => self.out.push(' '),
                c => self.out.push(c),
            }
        }
    }

    fn take(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    fn skip_blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn word(&mut self) -> String {
        let end = self
            .rest
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word.to_string()
    }

    /// What the next token or group prints.
    fn argument(&mut self) -> String {
        self.skip_blanks();
        let before = std::mem::take(&mut self.out);
        match self.take() {
            Some('{') => self.read(Some('}')),
            Some('\\') => self.command(),
            Some(c) => self.out.push(c),
            None => {}
        }
        tidy(&std::mem::replace(&mut self.out, before))
    }

    /// A group: what has an exponent as a whole gets brackets.
    fn group(&mut self) {
        let start = self.rest;
        let before = std::mem::take(&mut self.out);
        self.read(Some('}'));
        let inner = std::mem::replace(&mut self.out, before);
        let latex = &start[..start.len() - self.rest.len()];
        let latex = latex.strip_suffix('}').unwrap_or(latex);
        let several = || factors(latex) > 1 || inner.contains(['^', '+', '-', '/', '·']);
        match self.after() == Next::Script && several() {
            true => self.out += &format!("({})", tidy(&inner)),
            false => self.out += &inner,
        }
    }

    /// A script. An index is a word; an exponent without braces is one letter or one number.
    fn script(&mut self, mark: char) {
        let inner = self.argument();
        self.out = self.out.trim_end().to_string();
        let digits = inner.chars().all(|c| c.is_ascii_digit());
        let bare = match mark {
            '_' => inner.chars().all(char::is_alphanumeric),
            _ => digits,
        };
        // A digit that comes next would belong to it.
        let ends = !inner.ends_with(|c: char| c.is_ascii_digit())
            || !self
                .rest
                .trim_start()
                .starts_with(|c: char| c.is_ascii_digit());
        match (bare || inner.chars().count() == 1) && ends {
            true => self.out += &format!("{mark}{inner}"),
            false => self.out += &format!("{mark}{{{inner}}}"),
        }
    }

    fn command(&mut self) {
        let word = self.word();
        if word.is_empty() {
            match self.take() {
                Some('\\') => self.out.push_str("; "),
                Some('{') => self.out.push('{'),
                Some('}') => self.out.push('}'),
                Some(',' | ';' | ':' | ' ' | '!') | None => self.out.push(' '),
                Some(c) => self.out.push(c),
            }
            return;
        }
        if let Some((_, letter)) = GREEK.iter().chain(&SYMBOLS).find(|(name, _)| *name == word) {
            self.out.push_str(letter);
            return;
        }
        match word.as_str() {
            "frac" | "tfrac" | "dfrac" => {
                let top = self.argument();
                let below = self.rest;
                let bottom = self.argument();
                let below = &below[..below.len() - self.rest.len()];
                // Without a bracket a/bc reads as (a/b)c; d/dx is one sign.
                let sign = |part: &str| match part.as_bytes() {
                    [b'd', next, ..] => *next != b'_',
                    part => part == b"d" || part.starts_with("∂".as_bytes()),
                };
                let derivative = sign(&top) && sign(&bottom);
                let bottom = match factors(below) > 1 && !derivative {
                    true => format!("({bottom})"),
                    false => bracketed(&bottom),
                };
                let quotient = format!("{}/{bottom}", bracketed(&top));
                // Beside another factor a quotient needs brackets: 2 1/x reads as 21/x, a/b c as a/(bc).
                let before = self.out.trim_end().chars().next_back();
                let beside = before.is_some_and(|c| ends_factor(c) || c == '/');
                match !derivative && (beside || self.after() != Next::Other) {
                    true => self.out += &format!("({quotient})"),
                    false => self.out += &quotient,
                }
            }
            "sqrt" => {
                self.skip_blanks();
                let mut degree = String::new();
                if self.rest.starts_with('[') {
                    self.take();
                    let before = std::mem::take(&mut self.out);
                    self.read(Some(']'));
                    degree = tidy(&std::mem::replace(&mut self.out, before));
                }
                let radicand = self.argument();
                let single =
                    radicand.chars().all(|c| c.is_ascii_digit()) || radicand.chars().count() == 1;
                let sign = match degree.as_str() {
                    "" => "√".to_string(),
                    "3" => "∛".to_string(),
                    "4" => "∜".to_string(),
                    other => format!("root {other} of "),
                };
                match single && self.after() == Next::Other {
                    true => self.out += &format!("{sign}{radicand}"),
                    false => self.out += &format!("{sign}({radicand})"),
                }
            }
            "dot" => self.dotted(1),
            "ddot" => self.dotted(2),
            "dddot" => self.dotted(3),
            "ddddot" => self.dotted(4),
            "underbrace" => {
                let body = self.argument();
                self.skip_blanks();
                if self.rest.starts_with('_') {
                    self.take();
                    let label = self.argument();
                    self.out += &format!("{body} {{= {label}}}");
                } else {
                    self.out += &body;
                }
            }
            "begin" => {
                let name = self.argument();
                self.environment(&name);
            }
            "end" => {
                self.argument();
            }
            "left" | "right" => {
                self.skip_blanks();
                self.rest = self.rest.strip_prefix('.').unwrap_or(self.rest);
            }
            "tilde" | "widetilde" => self.accented('~'),
            "hat" | "widehat" => self.accented('^'),
            "bar" | "overline" => self.accented('¯'),
            "mathbf" | "boldsymbol" | "bm" | "mathrm" | "mathcal" | "mathbb" | "text" | "mbox"
            | "textrm" | "operatorname" | "mathsf" | "textnormal" | "vec" => {
                let inner = self.argument();
                self.out += &inner;
            }
            "quad" | "qquad" => self.out.push_str("  "),
            "tag" => {
                self.argument();
            }
            "displaystyle" | "textstyle" | "scriptstyle" | "limits" | "nolimits" | "nonumber"
            | "notag" | "big" | "Big" | "bigg" | "Bigg" | "bigl" | "Bigl" | "biggl" | "Biggl"
            | "bigr" | "Bigr" | "biggr" | "Biggr" => {}
            other => {
                self.out.push_str(other);
                self.out.push(' ');
            }
        }
    }

    /// What comes next in the LaTeX.
    fn after(&self) -> Next {
        let mut rest = self.rest.trim_start();
        while let Some(behind) = SPACES.iter().find_map(|space| rest.strip_prefix(space)) {
            rest = behind.trim_start();
        }
        if rest.starts_with("\\{") {
            return Next::Factor;
        }
        let control = rest.strip_prefix('\\').map(|word| {
            let end = word.find(|c: char| !c.is_ascii_alphabetic());
            &word[..end.unwrap_or(word.len())]
        });
        match (rest.chars().next(), control) {
            (Some('^'), _) => Next::Script,
            (_, Some(word)) => {
                let space = matches!(
                    word,
                    "" | "quad" | "qquad" | "right" | "end" | "cdot" | "times"
                );
                let relation = matches!(
                    word,
                    "le" | "leq"
                        | "leqslant"
                        | "ge"
                        | "geq"
                        | "geqslant"
                        | "ne"
                        | "neq"
                        | "approx"
                        | "sim"
                        | "to"
                        | "rightarrow"
                        | "lt"
                        | "gt"
                        | "pm"
                        | "mp"
                        | "text"
                        | "quad"
                );
                match space || relation {
                    true => Next::Other,
                    false => Next::Factor,
                }
            }
            (Some(c), None) if c.is_alphanumeric() || matches!(c, '(' | '[' | '{' | '|') => {
                Next::Factor
            }
            (_, None) => Next::Other,
        }
    }

    fn dotted(&mut self, dots: usize) {
        let mut inner = self.argument();
        inner += &"'".repeat(dots);
        self.out += &inner;
    }

    fn accented(&mut self, mark: char) {
        let inner = self.argument();
        self.out += &format!("{inner}{mark}");
    }

    fn environment(&mut self, name: &str) {
        let name = name.trim_end_matches('*');
        let open = format!("\\begin{{{name}");
        let close = format!("\\end{{{name}");
        let mut depth = 0;
        let mut at = 0;
        let end = loop {
            let Some(next) = self.rest[at..].find('\\').map(|i| at + i) else {
                break self.rest.len();
            };
            let here = &self.rest[next..];
            if here.starts_with(&open) {
                depth += 1;
            } else if here.starts_with(&close) {
                if depth == 0 {
                    break next;
                }
                depth -= 1;
            }
            at = next + 1;
        };
        let (body, rest) = self.rest.split_at(end);
        self.rest = rest;
        let matrix = name.ends_with("matrix") || name == "array";
        let mut inner = String::new();
        if matrix {
            let body = match (name, body.strip_prefix('{').and_then(|b| b.split_once('}'))) {
                ("array", Some((_, rest))) => rest,
                _ => body,
            };
            let rows: Vec<String> = body
                .split("\\\\")
                .map(|row| {
                    let entries: Vec<String> = row.split('&').map(plain).collect();
                    entries.join(", ")
                })
                .filter(|row| !row.is_empty())
                .collect();
            inner += &format!("[{}]", rows.join("; "));
        } else {
            inner += &plain(body);
        }
        self.out += &inner;
        if self.rest.starts_with("\\end") {
            self.rest = &self.rest["\\end".len()..];
            self.argument();
        }
    }
}

/// What may follow a quotient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    /// Something that it is multiplied with.
    Factor,
    /// An exponent of the whole.
    Script,
    /// A sign, a relation, a bracket that closes, or nothing.
    Other,
}

/// Whether a factor ends with this character.
fn ends_factor(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, ')' | ']' | '}' | '\'' | '~' | '¯')
}

/// How many letters, numbers and groups stand beside each other in LaTeX; scripts belong to what they
/// stand at.
fn factors(latex: &str) -> usize {
    let latex = latex.trim();
    let mut reader = Reader {
        rest: latex
            .strip_prefix('{')
            .and_then(|inner| inner.strip_suffix('}'))
            .unwrap_or(latex),
        out: String::new(),
    };
    let mut count = 0;
    let mut in_number = false;
    while let Some(c) = reader.rest.trim_start().chars().next() {
        let digit = c.is_ascii_digit();
        match c {
            '_' | '^' => {
                reader.skip_blanks();
                reader.take();
                reader.argument();
            }
            _ => {
                // A root stands before what it is taken of.
                let root = reader.rest.trim_start().starts_with("\\sqrt");
                reader.argument();
                count += usize::from(!(digit && in_number || root));
            }
        }
        in_number = digit;
    }
    count
}

fn bracketed(inner: &str) -> String {
    let plain = inner
        .chars()
        .all(|c| c.is_alphanumeric() || matches!(c, '_' | '^' | '\''));
    if plain {
        inner.to_string()
    } else {
        format!("({inner})")
    }
}

/// One blank where there were several, none at the ends and before punctuation.
fn tidy(text: &str) -> String {
    let mut out = String::new();
    for word in text.split_whitespace() {
        if !out.is_empty() && !word.starts_with([',', ';', '.', ')', ']']) {
            out.push(' ');
        }
        out.push_str(word);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names() {
        for (latex, expected) in [
            ("m_A", "m_A"),
            ("\\mathbf{P}_{33}", "P_33"),
            ("\\ddot{z}_A", "z''_A"),
            ("\\sigma_a^2", "σ_a^2"),
            ("q_{10}", "q_10"),
            ("H_{k,k+1}", "H_{k,k+1}"),
        ] {
            assert_eq!(plain_name(latex), expected);
        }
    }

    #[test]
    fn formulas() {
        for (latex, expected) in [
            ("\\det H = a_4H_3", "det H = a_4H_3"),
            ("\\frac{c_A}{m_A}", "c_A/m_A"),
            ("\\frac{1}{2 \\det \\mathbf{H}}", "1/(2 det H)"),
            ("\\frac{x}{d_A m_A^2}", "x/(d_A m_A^2)"),
            ("\\frac{a}{12\\tilde{b}_{ij}}", "a/(12b~_ij)"),
            ("\\frac12 x", "(1/2) x"),
            ("\\frac{a}{12}", "a/12"),
            ("\\frac{d}{d\\Omega}", "d/dΩ"),
            ("\\frac{d_A}{d_R m}", "d_A/(d_R m)"),
            ("\\frac{a}{\\sqrt{3}}", "a/(√3)"),
            ("\\sqrt{\\frac{k}{m+M}}", "√(k/(m+M))"),
            ("\\sqrt{k}m", "√(k)m"),
            ("2\\pi\\frac{1}{2\\pi}", "2π(1/(2π))"),
            ("1\\frac{1}{2}x", "1(1/2)x"),
            ("\\frac{a}{b}c", "(a/b)c"),
            ("\\left(x\\right)\\frac{a}{b}", "(x)(a/b)"),
            ("c[0 \\ 0 \\ 1]^T", "c[0 0 1]^T"),
            ("\\left(1 + \\frac{m_R}{m_A} \\right)^3", "(1 + m_R/m_A)^3"),
            (
                "\\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}",
                "[a, b; c, d]",
            ),
            ("\\underbrace{x}_{\\mathbf{y}}", "x {= y}"),
        ] {
            assert_eq!(plain(latex), expected);
        }
    }

    #[test]
    fn what_is_no_latex_ends_all_the_same() {
        for latex in [
            "", "\\", "{", "}", "^", "_", "\\frac", "\\begin{", "\\end", "&&", "\\left",
        ] {
            let _ = plain(latex);
        }
    }
}
