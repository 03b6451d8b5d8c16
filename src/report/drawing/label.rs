//! Formulas as runs of characters: what SVG can show of LaTeX.

use crate::expr::{Accent, Bracket, Expr, ExprKind, Font, Letter, Name, Sign};
use crate::latex::{self, Signature};
use crate::report::plain::{plain, plain_name};

/// How high a run stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// On the line.
    Line,
    /// A subscript.
    Below,
    /// A superscript.
    Above,
}

/// Characters of the same looks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The characters.
    pub text: String,
    /// Slanted, as letters in formulas are.
    pub italic: bool,
    /// Bold, as matrices are.
    pub bold: bool,
    /// How high it stands.
    pub level: Level,
    /// Above the subscript before it rather than behind it.
    pub stacked: bool,
}

impl Run {
    /// Words.
    pub fn words(text: &str) -> Run {
        Run {
            text: text.into(),
            italic: false,
            bold: false,
            level: Level::Line,
            stacked: false,
        }
    }
}

/// The runs of a formula.
pub fn runs(formula: &str) -> Vec<Run> {
    match latex::parse_expr(formula, 0, &Signature::default()) {
        Ok(expr) => {
            let mut writer = Writer { runs: Vec::new() };
            writer.expr(&expr, Level::Line);
            writer.runs
        }
        Err(_) => vec![Run::words(&plain(formula))],
    }
}

struct Writer {
    runs: Vec<Run>,
}

impl Writer {
    fn push(&mut self, text: &str, italic: bool, bold: bool, level: Level) {
        if let Some(last) = self.runs.last_mut()
            && (last.italic, last.bold, last.level) == (italic, bold, level)
            && !last.stacked
        {
            last.text.push_str(text);
            return;
        }
        self.runs.push(Run {
            text: text.into(),
            italic,
            bold,
            level,
            stacked: false,
        });
    }

    fn words(&mut self, text: &str, level: Level) {
        self.push(text, false, false, level);
    }

    fn expr(&mut self, expr: &Expr, level: Level) {
        match &expr.kind {
            ExprKind::Name(name) => self.name(name, level),
            ExprKind::Number(_) => self.words(&plain(&latex::write_expr(expr)), level),
            ExprKind::Apply {
                function,
                arguments,
            } => {
                self.name(function, level);
                self.words("(", level);
                for (k, argument) in arguments.iter().enumerate() {
                    if k > 0 {
                        self.words(", ", level);
                    }
                    self.expr(argument, level);
                }
                self.words(")", level);
            }
            ExprKind::Sum(terms) => {
                for (k, (sign, term)) in terms.iter().enumerate() {
                    let text = match (sign, k) {
                        (Sign::Plus, 0) => "",
                        (Sign::Plus, _) => " + ",
                        (Sign::Minus, 0) => "−",
                        (Sign::Minus, _) => " − ",
                    };
                    if !text.is_empty() {
                        self.words(text, level);
                    }
                    self.expr(term, level);
                }
            }
            ExprKind::Product(factors) => {
                for factor in factors {
                    self.expr(factor, level);
                }
            }
            ExprKind::Quotient {
                numerator,
                denominator,
                ..
            } => {
                self.operand(numerator, level);
                self.words("/", level);
                self.operand(denominator, level);
            }
            ExprKind::Power { base, exponent } if level == Level::Line => {
                self.operand(base, level);
                let before = self.runs.len();
                let stacked = self
                    .runs
                    .last()
                    .is_some_and(|run| run.level == Level::Below);
                self.expr(exponent, Level::Above);
                if let (true, Some(run)) = (stacked, self.runs.get_mut(before)) {
                    run.stacked = true;
                }
            }
            ExprKind::Group { bracket, inner } => {
                let (open, close) = match bracket {
                    Bracket::Square => ("[", "]"),
                    Bracket::Curly => ("{", "}"),
                    Bracket::Bar => ("|", "|"),
                    _ => ("(", ")"),
                };
                self.words(open, level);
                self.expr(inner, level);
                self.words(close, level);
            }
            ExprKind::Tuple(items) => {
                self.words("(", level);
                for (k, item) in items.iter().enumerate() {
                    if k > 0 {
                        self.words(", ", level);
                    }
                    self.expr(item, level);
                }
                self.words(")", level);
            }
            ExprKind::Transpose(inner) if level == Level::Line => {
                self.operand(inner, level);
                self.push("T", true, false, Level::Above);
            }
            _ => self.words(&plain(&latex::write_expr(expr)), level),
        }
    }

    fn operand(&mut self, expr: &Expr, level: Level) {
        let bracketed = matches!(expr.kind, ExprKind::Sum(_) | ExprKind::Quotient { .. });
        if bracketed {
            self.words("(", level);
        }
        self.expr(expr, level);
        if bracketed {
            self.words(")", level);
        }
    }

    fn name(&mut self, name: &Name, level: Level) {
        let bare = Name {
            letter: Letter {
                font: Font::Italic,
                accent: None,
                primes: 0,
                ..name.letter.clone()
            },
            dots: 0,
            subscript: None,
        };
        let mut text = plain_name(&latex::canonical(&bare));
        let capital_greek = text.chars().all(|c| ('Α'..='Ω').contains(&c));
        let italic = name.letter.font == Font::Italic && !capital_greek;
        match name.letter.accent {
            Some(Accent::Tilde) => text.push('\u{303}'),
            Some(Accent::Hat) => text.push('\u{302}'),
            Some(Accent::Bar) => text.push('\u{305}'),
            Some(Accent::Vector) => text.push('\u{20d7}'),
            None => {}
        }
        match name.dots {
            0 => {}
            1 => text.push('\u{307}'),
            2 => text.push('\u{308}'),
            n => text.push_str(&"\u{307}".repeat(n.into())),
        }
        text.push_str(&"′".repeat(name.letter.primes.into()));
        self.push(&text, italic, name.letter.font == Font::Bold, level);
        if let Some(subscript) = &name.subscript {
            let below = match level {
                Level::Line => Level::Below,
                other => other,
            };
            match latex::parse_name(&subscript.label, 0) {
                // A single letter is slanted, a word is not.
                Ok(label) if label.subscript.is_none() => self.name(&label, below),
                _ => self.words(&plain_name(&subscript.label), below),
            }
        }
    }
}

/// About how wide a run is, in units of the size of its letters.
pub fn width(run: &Run) -> f64 {
    let letters: f64 = run
        .text
        .chars()
        .map(|c| match c {
            '\u{300}'..='\u{36f}' | '\u{20d7}' => 0.0,
            'i' | 'j' | 'l' | 't' | 'f' | ' ' | '.' | ',' | '(' | ')' | '/' | '′' | '\'' => 0.31,
            'm' | 'w' | 'M' | 'W' => 0.78,
            c if c.is_uppercase() => 0.67,
            c if c.is_ascii_digit() => 0.5,
            _ => 0.49,
        })
        .sum();
    match run.level {
        Level::Line => letters,
        Level::Below | Level::Above => 0.7 * letters,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_and_powers_stand_where_they_belong() {
        let shown = runs("\\sigma_a^2");
        let text: Vec<&str> = shown.iter().map(|r| r.text.as_str()).collect();
        assert_eq!(text, ["σ", "a", "2"]);
        let level: Vec<Level> = shown.iter().map(|r| r.level).collect();
        assert_eq!(level, [Level::Line, Level::Below, Level::Above]);
        assert!(shown[2].stacked && shown[1].italic && !shown[2].italic);
    }

    #[test]
    fn dots_stand_on_their_letter() {
        assert_eq!(runs("\\ddot{z}_A")[0].text, "z\u{308}");
        assert_eq!(runs("\\Phi_0")[0].text, "Φ");
        assert!(!runs("\\Phi_0")[0].italic);
        assert!(runs("\\mathbf{A}")[0].bold);
    }

    #[test]
    fn what_cannot_be_read_is_shown_as_it_is() {
        assert_eq!(runs("a = b")[0].text, "a = b");
    }
}
