//! The LaTeX commands of the fragment and what each of them is.
//!
//! Everything the lexer lets through is in one of these tables; whatever is in none of them is an
//! unknown command, reported where it stands.

use crate::expr::{Accent, Bracket, Font, Function, Relation};

/// The commands that print a letter.
const LETTERS: &[&str] = &[
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "pi",
    "varpi",
    "rho",
    "varrho",
    "sigma",
    "varsigma",
    "tau",
    "upsilon",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Upsilon",
    "Phi",
    "Psi",
    "Omega",
    "ell",
    "hbar",
];

/// The other commands with a meaning of their own in the grammar.
const STRUCTURE: &[&str] = &[
    "frac",
    "tfrac",
    "dfrac",
    "sum",
    "int",
    "infty",
    "underbrace",
    "partial",
    "ldots",
    "dots",
    "cdots",
    "cdot",
    "times",
    "prime",
    "top",
    "intercal",
];

/// Whether the command prints a letter.
pub(super) fn is_letter(command: &str) -> bool {
    LETTERS.contains(&command)
}

/// Whether the grammar knows the command.
pub(super) fn is_known(command: &str) -> bool {
    is_letter(command)
        || STRUCTURE.contains(&command)
        || relation(command).is_some()
        || function(command).is_some()
        || font(command).is_some()
        || accent(command).is_some()
        || dots(command).is_some()
}

/// The relation a command stands for.
pub(super) fn relation(command: &str) -> Option<Relation> {
    Some(match command {
        "ne" | "neq" => Relation::NotEqual,
        "lt" => Relation::Less,
        "gt" => Relation::Greater,
        "le" | "leq" | "leqslant" => Relation::LessEqual,
        "ge" | "geq" | "geqslant" => Relation::GreaterEqual,
        "sim" => Relation::Distributed,
        "approx" => Relation::Approximately,
        "to" | "rightarrow" | "longrightarrow" => Relation::Tends,
        _ => return None,
    })
}

/// The function a command stands for.
pub(super) fn function(command: &str) -> Option<Function> {
    Some(match command {
        "det" => Function::Determinant,
        "Re" => Function::RealPart,
        "Im" => Function::ImaginaryPart,
        "cos" => Function::Cosine,
        "sin" => Function::Sine,
        "tan" => Function::Tangent,
        "cot" => Function::Cotangent,
        "cosh" => Function::HyperbolicCosine,
        "sinh" => Function::HyperbolicSine,
        "tanh" => Function::HyperbolicTangent,
        "exp" => Function::Exponential,
        "ln" | "log" => Function::Logarithm,
        "sqrt" => Function::SquareRoot,
        _ => return None,
    })
}

/// The function an upright word stands for, as in `\text{Re}` and `\operatorname{tr}`.
pub(super) fn word_function(word: &str) -> Option<Function> {
    Some(match word {
        "tr" | "trace" => Function::Trace,
        "det" | "Re" | "Im" | "cos" | "sin" | "tan" | "cot" | "cosh" | "sinh" | "tanh" | "exp"
        | "ln" | "log" => return function(word),
        _ => return None,
    })
}

/// Words that only join one equation to the next.
pub(super) fn is_conjunction(word: &str) -> bool {
    is_condition(word)
        || is_conclusion(word)
        || matches!(word.trim(), "and" | "or" | "with" | "where")
}

/// Words after which stands what is claimed.
fn is_conclusion(word: &str) -> bool {
    matches!(
        word.trim().trim_end_matches(','),
        "so" | "so that"
            | "hence"
            | "and hence"
            | "thus"
            | "and thus"
            | "then"
            | "and then"
            | "therefore"
            | "and therefore"
            | "consequently"
            | "which gives"
            | "it follows that"
    )
}

/// Words after which stands under what condition an equation is meant.
pub(crate) fn is_condition(word: &str) -> bool {
    matches!(
        word.trim().trim_end_matches(','),
        "for"
            | "for all"
            | "for any"
            | "for each"
            | "for every"
            | "if"
            | "when"
            | "whenever"
            | "provided"
            | "provided that"
            | "as long as"
            | "given"
            | "given that"
            | "assuming"
            | "assuming that"
    )
}

/// Words for all cases that no other condition names.
pub(super) fn is_otherwise(word: &str) -> bool {
    matches!(
        word.trim().trim_end_matches(['.', ',', ';']),
        "otherwise"
            | "else"
            | "elsewhere"
            | "in all other cases"
            | "in any other case"
            | "in other cases"
    )
}

/// Words that tell where an equation comes from, and nothing of what it says.
pub(super) fn is_justification(words: &str) -> bool {
    let mut each = words
        .split(|c: char| !c.is_alphanumeric())
        .filter(|w| !w.is_empty());
    let reasons = ["by", "from", "see", "using", "cf", "according", "due"];
    let side = words.trim() == "from above";
    each.next().is_some_and(|first| reasons.contains(&first)) && !restricts(words) && !side
}

/// Whether one of some words restricts what stands beside them, or takes it back.
pub(super) fn restricts(words: &str) -> bool {
    let mut each = words.split(|c: char| !c.is_alphanumeric());
    each.any(|word| {
        matches!(
            word.to_lowercase().as_str(),
            "if" | "for"
                | "when"
                | "where"
                | "unless"
                | "except"
                | "provided"
                | "only"
                | "not"
                | "no"
                | "never"
                | "cannot"
                | "false"
                | "wrong"
                | "incorrect"
                | "untrue"
                | "nearly"
                | "almost"
                | "approximately"
                | "approximation"
                | "assumption"
                | "mistake"
                | "more"
                | "less"
                | "than"
                | "that"
                | "positive"
                | "negative"
                | "left"
                | "right"
                | "below"
                | "up"
        )
    })
}

/// The word for "some constant".
pub(super) fn is_constant(word: &str) -> bool {
    matches!(word, "const" | "const." | "constant")
}

/// The typeface a command selects, when it takes mathematics (words are the lexer's).
pub(super) fn font(command: &str) -> Option<Font> {
    Some(match command {
        "mathbf" | "boldsymbol" | "bm" => Font::Bold,
        "mathcal" => Font::Calligraphic,
        "mathbb" => Font::Blackboard,
        _ => return None,
    })
}

/// The accent a command sets.
pub(super) fn accent(command: &str) -> Option<Accent> {
    Some(match command {
        "tilde" | "widetilde" => Accent::Tilde,
        "hat" | "widehat" => Accent::Hat,
        "bar" | "overline" => Accent::Bar,
        "vec" => Accent::Vector,
        _ => return None,
    })
}

/// How many dots a command sets.
pub(super) fn dots(command: &str) -> Option<u8> {
    Some(match command {
        "dot" => 1,
        "ddot" => 2,
        "dddot" => 3,
        "ddddot" => 4,
        _ => return None,
    })
}

/// Commands that typeset the text in the brace that follows.
pub(super) fn is_text(command: &str) -> bool {
    matches!(
        command,
        "text" | "mbox" | "textrm" | "mathrm" | "operatorname" | "mathsf" | "textnormal"
    )
}

/// Commands that change the look of what follows and nothing else.
pub(super) fn is_invisible(command: &str) -> bool {
    matches!(
        command,
        "displaystyle"
            | "textstyle"
            | "scriptstyle"
            | "limits"
            | "nolimits"
            | "nonumber"
            | "notag"
            | "big"
            | "Big"
            | "bigg"
            | "Bigg"
            | "bigl"
            | "Bigl"
            | "biggl"
            | "Biggl"
            | "bigr"
            | "Bigr"
            | "biggr"
            | "Biggr"
    )
}

/// What an environment holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Environment {
    /// Equations line by line: `aligned`, `gathered`, ...
    Lines,
    /// Entries by rows and columns.
    Matrix(Bracket),
    /// A matrix printed for its determinant.
    Determinant,
    /// `array`: equations or entries, which its content tells.
    Array,
    /// Expressions with conditions.
    Cases,
}

/// The environment of a name.
pub(super) fn environment(name: &str) -> Option<Environment> {
    Some(match name.trim_end_matches('*') {
        "aligned" | "align" | "alignat" | "alignedat" | "gathered" | "gather" | "split"
        | "equation" | "eqnarray" | "multline" | "multlined" => Environment::Lines,
        "bmatrix" => Environment::Matrix(Bracket::Square),
        "pmatrix" => Environment::Matrix(Bracket::Round),
        "Bmatrix" => Environment::Matrix(Bracket::Curly),
        "matrix" | "smallmatrix" => Environment::Matrix(Bracket::None),
        "vmatrix" => Environment::Determinant,
        "array" => Environment::Array,
        "cases" => Environment::Cases,
        _ => return None,
    })
}

/// Whether the environment's name is followed by an argument such as `{rcl}`.
pub(super) fn takes_argument(name: &str) -> bool {
    matches!(
        name.trim_end_matches('*'),
        "array" | "alignat" | "alignedat"
    )
}
