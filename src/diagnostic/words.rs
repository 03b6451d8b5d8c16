//! The words for each kind: what is wrong, what stands at the place, and what to do about it.

use super::DiagnosticKind;

/// A diagnostic in words.
pub(super) struct Words {
    /// What is wrong.
    pub title: String,
    /// A remark at the place; empty where the title says it all.
    pub label: String,
    /// What the second place is, if there is one.
    pub related: &'static str,
    /// What to do.
    pub help: String,
}

/// Longest piece of a document that a message repeats.
const QUOTE_LIMIT: usize = 80;

/// The piece in quotation marks, cut where it is too long to read.
fn quote(piece: &str) -> String {
    let mut chars = piece.chars();
    let shown: String = chars.by_ref().take(QUOTE_LIMIT).collect();
    let more = if chars.next().is_some() { " ..." } else { "" };
    format!("`{shown}{more}`")
}

fn list(items: &[String]) -> String {
    let quoted: Vec<String> = items.iter().map(|item| quote(item)).collect();
    quoted.join(", ")
}

/// The known words, led by the one that was probably meant.
fn suggestion(found: &str, known: &[String]) -> String {
    let nearest = known
        .iter()
        .map(|word| (strsim::damerau_levenshtein(found, word), word))
        .min()
        .filter(|(distance, word)| *distance <= 2 && *distance < word.chars().count());
    match nearest {
        Some((_, word)) => format!("did you mean `{word}`? Known here: {}", list(known)),
        None => format!("known here: {}", list(known)),
    }
}

/// The diagnostic in words.
pub(super) fn words(kind: &DiagnosticKind) -> Words {
    let roles = ["define", "solve", "claim", "recall"].map(String::from);
    let (title, label, help) = match kind {
        DiagnosticKind::Unexpected { found, expected } => (
            format!("expected {expected}, found {found}"),
            format!("expected {expected}"),
            String::new(),
        ),
        DiagnosticKind::Unbalanced { delimiter } => (
            format!("`{delimiter}` without its partner"),
            "no partner".into(),
            match delimiter.as_str() {
                "```" => "close the fence with a line that holds nothing but ```".into(),
                _ => "add the partner, or remove this one".into(),
            },
        ),
        // Brackets, arguments and scripts count each, often two for one construct: no number helps.
        DiagnosticKind::TooDeep { .. } => (
            "nested too deeply to be read".into(),
            "too deep from here on".into(),
            "split the expression by a definition of its own".into(),
        ),
        // The count ends where it is too large.
        DiagnosticKind::TooManyLetters { limit, .. } => (
            format!("more than {limit} letters and abbreviations"),
            "in this document".into(),
            "split the document by its sections".into(),
        ),
        DiagnosticKind::UnknownCommand { command } => (
            format!("the command {} is outside the LaTeX that is read", quote(command)),
            "unknown command".into(),
            "a command that is only typesetting can be left out; one that carries meaning needs \
             the notation it stands for"
                .into(),
        ),
        DiagnosticKind::Ambiguous { readings } => (
            "this can be read in more than one way".into(),
            format!("could be {}", list(readings)),
            "say in the tables of symbols or notation which is meant, or add brackets".into(),
        ),
        DiagnosticKind::UndeclaredName { name } => (
            format!("nothing says what {} is", quote(name)),
            "not declared".into(),
            match name.as_str() {
                "\\pi" => "if it is the number, add `'\\pi' = { constant = \"pi\" }` to the `toml notation` table",
                "i" | "\\mathrm{i}" => "if it is the imaginary unit, add it to the `toml notation` table with `{ constant = \"i\" }`",
                _ => "add it to the `toml symbols` or `toml notation` table, or define it in an equation",
            }
            .into(),
        ),
        DiagnosticKind::DuplicateName { name } => (
            format!("{} is declared or defined twice", quote(name)),
            "second time".into(),
            "keep one of the two; a name that is stated again is a claim".into(),
        ),
        DiagnosticKind::CyclicDefinition { cycle } => (
            format!("these definitions need each other: {}", cycle.join(" -> ")),
            "part of the circle".into(),
            "make one of them a claim".into(),
        ),
        DiagnosticKind::NoTime { name } => (
            format!("nothing says by what the dot over {} differentiates", quote(name)),
            "a derivative by the time".into(),
            "declare the time, `t = { unit = \"s\" }`, or what is a function of it".into(),
        ),
        DiagnosticKind::ShapeMismatch {
            operation,
            left,
            right,
        } => (
            format!("the shapes do not fit: {operation} of {left} and {right}"),
            format!("{left} and {right}"),
            "compare with the printed page; a transpose or an index may be lost".into(),
        ),
        DiagnosticKind::DivisionByZero => (
            "division by something that is zero identically".into(),
            "always zero".into(),
            "no value of the letters makes this finite".into(),
        ),
        DiagnosticKind::Exponent { exponent, limit } => (
            format!("the exponent {} cannot be used", quote(exponent)),
            String::new(),
            format!("exponents are whole numbers of size at most {limit}"),
        ),
        DiagnosticKind::BadNumber { text } => (
            format!("{} is not a number", quote(text)),
            "not a number".into(),
            "write a whole number, a decimal or a fraction: \"1200\", \"0.35\", \"7/20\", \"1e-6\""
                .into(),
        ),
        DiagnosticKind::LongNumber { digits, limit } => (
            format!("a number of {digits} digits; at most {limit} are read"),
            "too long".into(),
            "write it with a power of ten, or by a letter with a value".into(),
        ),
        DiagnosticKind::Undefined { name } => (
            format!("nothing says what {} is", quote(name)),
            "not declared, and a claim gives no name its value".into(),
            "write `define` instead of `claim` if this equation defines it; else correct the name, or \
             declare it in the `toml symbols` table"
                .into(),
        ),
        DiagnosticKind::Alternatives => (
            "equations joined by `or`: each equation of a display must hold".into(),
            "an alternative".into(),
            "write one claim that covers both, such as x^2 = a^2, or each with its condition".into(),
        ),
        DiagnosticKind::SaysNothing { clause } => (
            format!("{} alone says nothing that can be checked", quote(clause)),
            "no relation".into(),
            "a claim relates two things, as in a = b or a > 0; the values of an index are written \
             i = 1, 2, \\ldots, n; what stands in a display without a claim is `recall`"
                .into(),
        ),
        DiagnosticKind::NoFence { line, expected } => (
            format!("this line looks like a fence and is none: {}", quote(line)),
            "would be passed over".into(),
            format!("begin the line with {expected}, not indented, after the fence before it is closed"),
        ),
        DiagnosticKind::TooLong { what, size, limit } => (
            format!("{what} of {size} bytes is longer than is read"),
            format!("at most {limit} letters and signs are"),
            "split it into several".into(),
        ),
        DiagnosticKind::DuplicateLabel { label } => (
            format!("{} is used twice", quote(label)),
            "second time".into(),
            "give one of the two another label, such as a word, or merge them".into(),
        ),
        DiagnosticKind::BadLabel { found } if found.is_empty() => (
            "this fence has no label".into(),
            "nothing follows the language".into(),
            "write ```math LABEL ROLE or ```toml LABEL, where the label is the printed number or a \
             word"
                .into(),
        ),
        DiagnosticKind::BadLabel { found } => (
            format!("{} cannot be a label", quote(found)),
            "not a label".into(),
            "a label is the printed number or a word of letters, digits, `.`, `_` and `-`, and it \
             stands before the role"
                .into(),
        ),
        DiagnosticKind::UnknownLabel { label, tables } => (
            format!("no equation has the label {}", quote(label)),
            "settings without an equation".into(),
            format!(
                "a table that is not the settings of an equation is one of {}",
                list(tables)
            ),
        ),
        DiagnosticKind::UnknownRole { role } if role.is_empty() => (
            "this equation has no role".into(),
            "nothing follows the label".into(),
            format!("write one of {} after the label", list(&roles)),
        ),
        DiagnosticKind::UnknownRole { role } => (
            format!("{} is not a role", quote(role)),
            "unknown role".into(),
            suggestion(role, &roles),
        ),
        DiagnosticKind::UnknownKey { key, known } => (
            format!("the format has no key {} here", quote(key)),
            "unknown key".into(),
            suggestion(key, known),
        ),
        DiagnosticKind::NoValue { name } => (
            format!("{} has no value", quote(name)),
            "needs a value".into(),
            "give it one in the `toml symbols` table".into(),
        ),
        DiagnosticKind::UnknownEquation { label } => (
            format!("no equation has the label {}", quote(label)),
            "unknown label".into(),
            String::new(),
        ),
        DiagnosticKind::MissingKey { key } => (
            format!("this table needs a key {}", quote(key)),
            "not in this table".into(),
            String::new(),
        ),
        DiagnosticKind::UnknownWord { word, known } => (
            format!("{} is not one of the words that can stand here", quote(word)),
            "unknown word".into(),
            suggestion(word, known),
        ),
        DiagnosticKind::MissingReason { label } => (
            format!("equation {label} is recalled without a reason"),
            "recalled".into(),
            format!("add a table ```toml {label} with reason = \"why there is nothing to check\""),
        ),
        DiagnosticKind::MissingMeaning { label } => (
            format!("nothing says what statement {label} means"),
            "no predicate".into(),
            format!(
                "add a table ```toml {label} with `of` and `predicate`, or with reason = \"why \
                 there is nothing to check\""
            ),
        ),
        DiagnosticKind::NotPositive { name, value } => (
            format!("{} is declared positive, but its value is {value}", quote(name)),
            "not positive".into(),
            "correct the value, or leave out `positive`".into(),
        ),
        DiagnosticKind::BadUnit { unit, message } => (
            format!("{} is not a unit: {message}", quote(unit)),
            "not a unit".into(),
            "write SI units as in \"kg\", \"N s/m\", \"m^2/s\", \"J/(kg K)\", \"1\"".into(),
        ),
        DiagnosticKind::IncoherentUnit { unit, coherent } => (
            format!("a value in {} is not a number that formulas can take", quote(unit)),
            "has a prefix or a factor".into(),
            format!("give the value in {coherent}"),
        ),
        DiagnosticKind::EmptyRange {
            low,
            high,
            logarithmic,
        } => (
            format!("nothing can be drawn from the range from {low} to {high}"),
            String::new(),
            if *logarithmic {
                "write the smaller end first; on a logarithmic scale both ends are positive (or \
                 set scale = \"linear\")"
                    .into()
            } else {
                "write the smaller end first".into()
            },
        ),
        DiagnosticKind::EmptyDocument => (
            "this document has nothing to check".into(),
            String::new(),
            "equations stand in fences such as ```math 1 claim".into(),
        ),
        DiagnosticKind::NotUtf8 => (
            "this file is not UTF-8 text".into(),
            "the first bytes that are not".into(),
            "save it as UTF-8".into(),
        ),
        DiagnosticKind::Unreadable { message } => (
            format!("cannot read the file: {message}"),
            String::new(),
            String::new(),
        ),
        DiagnosticKind::Toml { message } => (
            format!("this table is not TOML: {message}"),
            String::new(),
            "names with a backslash or braces need single quotation marks: '\\zeta' = { unit = \
             \"m\" }"
                .into(),
        ),
    };
    let related = match kind {
        DiagnosticKind::DuplicateName { .. } | DiagnosticKind::DuplicateLabel { .. } => {
            "first time"
        }
        DiagnosticKind::Unbalanced { .. } => "opened here",
        _ => "this belongs to it",
    };
    Words {
        title,
        label,
        related,
        help,
    }
}
