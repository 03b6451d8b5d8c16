//! Lines of LaTeX about as long as a page is wide.

/// Formulas up to about this many characters go on one line.
pub(super) const LINE: usize = 64;

/// Lines of pieces, each line about as long as a page is wide.
pub(super) fn broken(name: &str, pieces: &[String]) -> String {
    let mut lines = vec![String::new()];
    let mut used = width(name) + 2;
    for piece in pieces {
        let needs = width(piece) + 1;
        if used + needs > LINE && used > width(name) + 2 {
            lines.push("&\\quad ".into());
            used = 4;
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() && !line.ends_with(' ') {
                line.push(' ');
            }
            line.push_str(piece);
        }
        used += needs;
    }
    format!(
        "\\begin{{aligned}}[t]\n{name} &= {}\n\\end{{aligned}}",
        lines.join(" \\\\\n")
    )
}

/// About how many characters wide a piece of LaTeX is in print.
pub fn width(latex: &str) -> usize {
    let mut width = 0.0_f64;
    let mut script = 0;
    let mut characters = latex.chars().peekable();
    let mut after_script = false;
    while let Some(c) = characters.next() {
        match c {
            '\\' => {
                let mut word = String::new();
                while let Some(next) = characters.next_if(char::is_ascii_alphabetic) {
                    word.push(next);
                }
                let invisible = matches!(
                    word.as_str(),
                    "mathbf"
                        | "left"
                        | "right"
                        | "bigl"
                        | "bigr"
                        | "dot"
                        | "ddot"
                        | "dddot"
                        | "frac"
                        | "mathrm"
                        | "tilde"
                        | "hat"
                        | "bar"
                        | "quad"
                        | "text"
                );
                if !invisible {
                    width += 1.0;
                }
            }
            '^' | '_' => {
                after_script = true;
                continue;
            }
            '{' if after_script => script += 1,
            '{' if script > 0 => script += 1,
            '}' if script > 0 => script -= 1,
            '{' | '}' | ' ' | '&' => {}
            '+' | '-' | '=' if script == 0 => width += 2.4,
            _ if script > 0 || after_script => width += 0.7,
            _ => width += 1.0,
        }
        after_script = false;
    }
    width.ceil() as usize
}
