//! Formulas on a terminal say what was printed: random formulas are written in LaTeX, shown as plain text, read back
//! by the reader here, and compared by their values at a point. The reader knows what everybody does: what stands
//! beside each other is a product, a slash divides by the whole product after it, a dot ends it, an exponent
//! without braces is one letter or one number.

use super::dots::Draw;
use rederive::report::plain::plain;

/// The letters with their values.
const LETTERS: [(&str, char, f64); 5] = [
    ("a", 'a', 1.3),
    ("b", 'b', 0.7),
    ("x", 'x', 1.9),
    ("y", 'y', 0.4),
    (r"\pi", 'π', 3.1),
];

/// What a formula is, by how it may stand.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// A letter, a bracket, a root.
    Atom,
    Number,
    /// A power or a quotient: a factor that takes no exponent as it is.
    Factor,
    Product,
    Sum,
}

/// LaTeX, its value, and its kind.
#[derive(Clone)]
struct Formula(String, f64, Kind);

fn random(draw: &mut Draw, depth: usize) -> Formula {
    if depth == 0 || draw.below(6) == 0 {
        if draw.below(3) == 0 {
            let n = [2, 3, 5, 22][draw.below(4)];
            return Formula(n.to_string(), f64::from(n), Kind::Number);
        }
        let (latex, _, value) = LETTERS[draw.below(LETTERS.len())];
        return Formula(latex.into(), value, Kind::Atom);
    }
    let mut part = |d: usize| random(draw, d);
    let (one, two) = (part(depth - 1), part(depth - 1));
    match draw.below(8) {
        0 => {
            let minus = draw.coin();
            let (sign, value) = match minus {
                true => ("-", one.1 - two.1),
                false => ("+", one.1 + two.1),
            };
            let right = factor_of(&two, Kind::Product);
            Formula(format!("{} {sign} {right}", one.0), value, Kind::Sum)
        }
        1 => Formula(
            format!("-{}", factor_of(&one, Kind::Product)),
            -one.1,
            Kind::Sum,
        ),
        2 | 3 => {
            let (left, right) = (
                factor_of(&one, Kind::Product),
                factor_of(&two, Kind::Product),
            );
            // Letters and numbers need something between, and a sign a bracket.
            let between = match right.starts_with(|c: char| c.is_ascii_digit()) {
                true => r" \cdot ",
                false => [" ", "", r"\,"][draw.below(3)],
            };
            let between = match left.ends_with(|c: char| c.is_alphabetic()) && between.is_empty() {
                true => " ",
                false => between,
            };
            Formula(
                format!("{left}{between}{right}"),
                one.1 * two.1,
                Kind::Product,
            )
        }
        4 => Formula(
            format!(r"\frac{{{}}}{{{}}}", one.0, two.0),
            one.1 / two.1,
            Kind::Factor,
        ),
        5 | 6 => {
            let base = factor_of(&one, Kind::Number);
            let exponent = two.1.clamp(-3.0, 3.0);
            // Values stay of a size that can be compared.
            if exponent != two.1 || one.1.abs() > 50.0 || one.1 < 0.01 {
                return one;
            }
            Formula(
                format!("{base}^{{{}}}", two.0),
                one.1.powf(two.1),
                Kind::Factor,
            )
        }
        _ if one.1 > 0.0 => Formula(format!(r"\sqrt{{{}}}", one.0), one.1.sqrt(), Kind::Atom),
        _ => Formula(format!(r"\left|{}\right|", one.0), one.1.abs(), Kind::Atom),
    }
}

/// A formula as a part of one that takes this and what is simpler, in brackets if it must.
fn factor_of(f: &Formula, most: Kind) -> String {
    let stands = match most {
        Kind::Atom | Kind::Number => matches!(f.2, Kind::Atom | Kind::Number),
        Kind::Factor => !matches!(f.2, Kind::Product | Kind::Sum),
        Kind::Product | Kind::Sum => f.2 != Kind::Sum,
    };
    match stands {
        true => f.0.clone(),
        false => format!(r"\left({}\right)", f.0),
    }
}

/// Reads plain text.
struct Reader<'t> {
    rest: std::iter::Peekable<std::iter::Filter<std::str::Chars<'t>, fn(&char) -> bool>>,
}

impl<'t> Reader<'t> {
    fn value(text: &'t str) -> Option<f64> {
        let seen: fn(&char) -> bool = |c| *c != ' ';
        let mut reader = Reader {
            rest: text.chars().filter(seen).peekable(),
        };
        let value = reader.sum()?;
        reader.rest.next().is_none().then_some(value)
    }

    fn takes(&mut self, c: char) -> bool {
        self.rest.next_if_eq(&c).is_some()
    }

    fn sum(&mut self) -> Option<f64> {
        let mut sum = match self.takes('-') {
            true => -self.product()?,
            false => self.product()?,
        };
        loop {
            if self.takes('+') {
                sum += self.product()?;
            } else if self.takes('-') {
                sum -= self.product()?;
            } else {
                return Some(sum);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut product = self.quotient()?;
        while self.takes('·') {
            product *= self.quotient()?;
        }
        Some(product)
    }

    fn quotient(&mut self) -> Option<f64> {
        let mut quotient = self.beside()?;
        while self.takes('/') {
            quotient /= self.beside()?;
        }
        Some(quotient)
    }

    fn beside(&mut self) -> Option<f64> {
        let mut product = self.factor()?;
        while self
            .rest
            .peek()
            .is_some_and(|c| c.is_alphanumeric() || matches!(c, '(' | '√'))
        {
            product *= self.factor()?;
        }
        Some(product)
    }

    fn factor(&mut self) -> Option<f64> {
        let base = match self.rest.next()? {
            '(' => {
                let inner = self.sum()?;
                self.takes(')').then_some(inner)?
            }
            '√' => match self.takes('(') {
                true => {
                    let inner = self.sum()?;
                    self.takes(')').then_some(inner.sqrt())?
                }
                false => {
                    let c = self.rest.next()?;
                    self.number_or_letter(c)?.sqrt()
                }
            },
            c => self.number_or_letter(c)?,
        };
        if !self.takes('^') {
            return Some(base);
        }
        let exponent = match self.takes('{') {
            true => {
                let inner = self.sum()?;
                self.takes('}').then_some(inner)?
            }
            false => {
                let c = self.rest.next()?;
                self.number_or_letter(c)?
            }
        };
        Some(base.powf(exponent))
    }

    fn number_or_letter(&mut self, c: char) -> Option<f64> {
        if let Some(digit) = c.to_digit(10) {
            let mut number = f64::from(digit);
            while let Some(next) = self.rest.next_if(char::is_ascii_digit) {
                number = 10.0 * number + f64::from(next.to_digit(10)?);
            }
            return Some(number);
        }
        let found = LETTERS.iter().find(|(_, letter, _)| *letter == c);
        found.map(|(.., value)| *value)
    }
}

#[test]
fn plain_text_shows_the_formula_that_is_printed() {
    let mut draw = Draw::new(10);
    let mut wrong = Vec::new();
    let mut all = 0;
    while all < 3_000 {
        let depth = 2 + draw.below(3);
        let Formula(latex, value, _) = random(&mut draw, depth);
        if !value.is_finite() || value.abs() > 1e9 || latex.contains(r"\left|") {
            continue;
        }
        all += 1;
        let shown = plain(&latex);
        let read = Reader::value(&shown);
        let same = read.is_some_and(|r| (r - value).abs() <= 1e-9 * value.abs().max(1.0));
        if !same {
            wrong.push(format!("{latex}  ->  {shown}"));
        }
    }
    let few: Vec<&String> = wrong.iter().take(30).collect();
    assert!(wrong.is_empty(), "{} of {all}: {few:#?}", wrong.len());
}

#[test]
fn exponents_and_quotients_keep_their_brackets() {
    for (latex, expected) in [
        ("a^{2b}b", "a^{2b}b"),
        ("a^{bx}x", "a^{bx}x"),
        (r"\left(a + b\right)^{2a}b", "(a + b)^{2a}b"),
        (r"\left|a - b\right|^{2a}", "|a - b|^{2a}"),
        ("e^{ix}", "e^{ix}"),
        (r"a^{2\pi}", "a^{2π}"),
        ("a^{22}x", "a^22x"),
        (r"a^2 \cdot 3", "a^2 · 3"),
        ("a^T", "a^T"),
        (r"\frac12 a", "(1/2) a"),
        (r"\frac{1}{2}a^{2}", "(1/2)a^2"),
        (r"-\frac{1}{2}a", "-(1/2)a"),
        (r"\frac12\,a", "(1/2) a"),
        (r"\frac12\sin x", "(1/2)sin x"),
        (r"\frac{1}{2}\left|x\right|", "(1/2)|x|"),
        (r"\frac a2a^x", "(a/2)a^x"),
        (r"a^{\frac12a}", "a^{(1/2)a}"),
        (r"\frac12 + a", "1/2 + a"),
        (r"\frac12 = a", "1/2 = a"),
        (r"\frac{1}{2} \cdot a", "1/2 · a"),
        (
            r"\frac{1}{2}\begin{bmatrix} a \\ b \end{bmatrix}",
            "(1/2)[a; b]",
        ),
        (r"a/\frac{b}{x}", "a/(b/x)"),
        (r"\sum_{k=0}^{2}3k", "Σ_{k=0}^{2}3k"),
    ] {
        assert_eq!(plain(latex), expected, "{latex}");
    }
}
