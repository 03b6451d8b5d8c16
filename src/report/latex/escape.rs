//! Free text for TeX: whatever stands in a document's titles, meanings and notes is printed as it
//! stands and can do nothing.

/// Text that prints as it stands.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 16);
    let mut previous = ' ';
    for c in text.chars() {
        match special(c) {
            Some(command) => out.push_str(command),
            // Two hyphens or commas in a row would become a dash or a quotation mark.
            None if matches!(c, '-' | ',' | '\'') && c == previous => {
                out.push_str("{}");
                out.push(c);
            }
            None if c.is_ascii_graphic() || c == ' ' => out.push(c),
            None if c.is_whitespace() => out.push(' '),
            None if is_in_font(c) => out.push(c),
            None if c.is_control() => {}
            None => out.push_str(&format!("[U+{:04X}]", u32::from(c))),
        }
        previous = c;
    }
    out
}

/// A name from a program or a file: typewriter letters, with places where a line may break.
pub fn code(text: &str) -> String {
    let mut out = String::from("\\texttt{");
    let mut since = 0;
    for (k, c) in text.chars().enumerate() {
        // Words break behind their signs, what has none after some letters.
        since = if matches!(c, '/' | '_' | '-' | '.') {
            0
        } else {
            since + 1
        };
        if k > 0 && since > 0 && since % 24 == 0 {
            out.push_str("\\allowbreak{}");
        }
        out.push_str(&escape(&c.to_string()));
        if matches!(c, '/' | '_' | '-' | '.') {
            out.push_str("\\allowbreak{}");
        }
    }
    out.push('}');
    out
}

/// Letters of the languages that the T1 encoding prints.
fn is_in_font(c: char) -> bool {
    // Latin-1 letters; of Latin Extended-A those with accents that T1 has as characters.
    matches!(c, 'À'..='Ö' | 'Ø'..='ö' | 'ø'..='ÿ')
        || "ĂăĄąĆćČčĎďĐđĘęĚěĞğĹĺĽľŁłŃńŇňŐőŒœŔŕŘřŚśŞşŠšŢţŤťŮůŰűŸŹźŻżŽž".contains(c)
}

fn special(c: char) -> Option<&'static str> {
    Some(match c {
        'ᵀ' => "\\textsuperscript{T}",
        '\\' => "\\textbackslash{}",
        '{' => "\\{",
        '}' => "\\}",
        '$' => "\\$",
        '&' => "\\&",
        '#' => "\\#",
        '%' => "\\%",
        '_' => "\\_",
        '^' => "\\textasciicircum{}",
        '~' => "\\textasciitilde{}",
        '<' => "\\textless{}",
        '>' => "\\textgreater{}",
        '|' => "\\textbar{}",
        '"' => "\\textquotedbl{}",
        '`' => "\\textasciigrave{}",
        '\u{a0}' => " ",
        '–' => "--",
        '—' => "---",
        '‘' => "`",
        '’' => "'",
        '“' => "``",
        '”' => "''",
        '„' => "\\quotedblbase{}",
        '«' => "\\guillemotleft{}",
        '»' => "\\guillemotright{}",
        '…' => "\\dots{}",
        '×' => "\\ensuremath{\\times}",
        '÷' => "\\ensuremath{\\div}",
        '·' => "\\ensuremath{\\cdot}",
        '−' => "\\ensuremath{-}",
        '±' => "\\ensuremath{\\pm}",
        '≤' => "\\ensuremath{\\leq}",
        '≥' => "\\ensuremath{\\geq}",
        '≠' => "\\ensuremath{\\neq}",
        '≈' => "\\ensuremath{\\approx}",
        '→' => "\\ensuremath{\\rightarrow}",
        '∞' => "\\ensuremath{\\infty}",
        '√' => "\\ensuremath{\\surd}",
        '°' => "\\textdegree{}",
        '²' => "\\ensuremath{^2}",
        '³' => "\\ensuremath{^3}",
        '⁰' => "\\ensuremath{^0}",
        '¹' => "\\ensuremath{^1}",
        '⁴' => "\\ensuremath{^4}",
        '⁵' => "\\ensuremath{^5}",
        '⁶' => "\\ensuremath{^6}",
        '⁷' => "\\ensuremath{^7}",
        '⁸' => "\\ensuremath{^8}",
        '⁹' => "\\ensuremath{^9}",
        '⁻' => "\\ensuremath{^-}",
        '§' => "\\S{}",
        'α' => "\\ensuremath{\\alpha}",
        'β' => "\\ensuremath{\\beta}",
        'γ' => "\\ensuremath{\\gamma}",
        'δ' => "\\ensuremath{\\delta}",
        'ε' => "\\ensuremath{\\varepsilon}",
        'ζ' => "\\ensuremath{\\zeta}",
        'η' => "\\ensuremath{\\eta}",
        'θ' => "\\ensuremath{\\theta}",
        'κ' => "\\ensuremath{\\kappa}",
        'λ' => "\\ensuremath{\\lambda}",
        'μ' | 'µ' => "\\ensuremath{\\mu}",
        'ν' => "\\ensuremath{\\nu}",
        'ξ' => "\\ensuremath{\\xi}",
        'π' => "\\ensuremath{\\pi}",
        'ρ' => "\\ensuremath{\\rho}",
        'σ' => "\\ensuremath{\\sigma}",
        'τ' => "\\ensuremath{\\tau}",
        'φ' => "\\ensuremath{\\varphi}",
        'χ' => "\\ensuremath{\\chi}",
        'ψ' => "\\ensuremath{\\psi}",
        'ω' => "\\ensuremath{\\omega}",
        'Γ' => "\\ensuremath{\\Gamma}",
        'Δ' => "\\ensuremath{\\Delta}",
        'Θ' => "\\ensuremath{\\Theta}",
        'Λ' => "\\ensuremath{\\Lambda}",
        'Σ' => "\\ensuremath{\\Sigma}",
        'Φ' => "\\ensuremath{\\Phi}",
        'Ψ' => "\\ensuremath{\\Psi}",
        'Ω' => "\\ensuremath{\\Omega}",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn commands_are_printed_and_not_obeyed() {
        assert_eq!(
            escape("\\input{/etc/passwd}"),
            "\\textbackslash{}input\\{/etc/passwd\\}"
        );
        assert_eq!(
            escape("\\immediate\\write18{ls}"),
            "\\textbackslash{}immediate\\textbackslash{}write18\\{ls\\}"
        );
        assert_eq!(
            escape("100% of A_1 & B #2 ~ $3^4$"),
            "100\\% of A\\_1 \\& B \\#2 \\textasciitilde{} \\$3\\textasciicircum{}4\\$"
        );
    }

    #[test]
    fn carets_cannot_build_characters() {
        // TeX reads ^^5c as a backslash.
        assert!(!escape("^^5cinput").contains("^^"));
    }

    #[test]
    fn lines_and_controls_vanish() {
        assert_eq!(escape("a\nb\tc\u{7}d"), "a b cd");
        assert_eq!(escape("中"), "[U+4E2D]");
    }

    proptest! {
        /// Every backslash that is left begins one of the commands above, and every brace that is
        /// not escaped belongs to one.
        #[test]
        fn nothing_active_is_left(text in "\\PC{0,40}") {
            let mut rest = escape(&text);
            for c in text.chars() {
                if let Some(command) = special(c) {
                    rest = rest.replacen(command, "", 1);
                }
            }
            prop_assert!(!rest.contains(['\\', '$', '&', '#', '%', '_', '^', '~']), "{rest}");
            prop_assert_eq!(rest.replace("{}", "").matches(['{', '}']).count(), 0);
        }
    }
}
