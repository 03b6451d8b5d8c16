//! Text of a document, or a name of a file, on its way to a reader.
//!
//! Invariant: what comes out holds no character that a terminal or a browser acts on instead of
//! showing it: control characters (of both blocks: 0x9B alone begins an escape sequence), marks that
//! change the direction of writing, characters that cannot be seen (Unicode Technical Report 36,
//! section 2; Boucher and Anderson, *Trojan Source*, 2021). Each of them is shown by its code point.

use std::borrow::Cow;

/// The text with every character that cannot be shown replaced by its code point, such as
/// `<U+202E>`. Line ends and tabs stay; see [`printable_line`] where they must not.
pub fn printable(text: &str) -> Cow<'_, str> {
    replaced(text, |c| is_shown(c) || matches!(c, '\n' | '\t'))
}

/// The same for what stands on one line, such as the name of a file: a line end in it has its code
/// point too.
pub fn printable_line(text: &str) -> Cow<'_, str> {
    replaced(text, is_shown)
}

fn replaced(text: &str, stays: impl Fn(char) -> bool) -> Cow<'_, str> {
    if text.chars().all(&stays) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    let mut characters = text.chars().peekable();
    while let Some(c) = characters.next() {
        // The line ends of Windows are line ends.
        if c == '\r' && stays('\n') && characters.peek() == Some(&'\n') {
            continue;
        }
        if stays(c) {
            shown.push(c);
        } else {
            shown.push_str(&code_point(c));
        }
    }
    Cow::Owned(shown)
}

/// A character that cannot be shown, by its code point.
fn code_point(c: char) -> String {
    format!("<U+{:04X}>", u32::from(c))
}

/// Whether a reader sees the character as itself.
fn is_shown(c: char) -> bool {
    !c.is_control() && !is_invisible(c)
}

/// Whether the character is a mark of direction or format, or has no ink of its own.
fn is_invisible(c: char) -> bool {
    matches!(
        u32::from(c),
        0x00AD
            | 0x034F
            | 0x061C
            | 0x115F..=0x1160
            | 0x17B4..=0x17B5
            | 0x180B..=0x180F
            | 0x200B..=0x200F
            | 0x2028..=0x202E
            | 0x2060..=0x206F
            | 0x3164
            | 0xFE00..=0xFE0F
            | 0xFEFF
            | 0xFFA0
            | 0xFFF0..=0xFFFB
            | 0x1BCA0..=0x1BCA3
            | 0x1D173..=0x1D17A
            | 0xE0000..=0xE0FFF
    ) || is_noncharacter(c)
}

fn is_noncharacter(c: char) -> bool {
    let value = u32::from(c);
    (0xFDD0..=0xFDEF).contains(&value) || value & 0xFFFE == 0xFFFE
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_a_terminal_obeys_is_shown_by_its_code_point() {
        for (text, shown) in [
            ("a\u{1b}[31mb", "a<U+001B>[31mb"),
            ("\u{9b}2J", "<U+009B>2J"),
            ("a\0", "a<U+0000>"),
            ("x\u{202e}y\u{2066}", "x<U+202E>y<U+2066>"),
            ("\u{feff}# T", "<U+FEFF># T"),
            ("a\u{200b}b", "a<U+200B>b"),
            ("one\r\ntwo\tx\n", "one\ntwo\tx\n"),
            ("over\rwritten", "over<U+000D>written"),
            ("é ∫ 漢 σ̇", "é ∫ 漢 σ̇"),
        ] {
            assert_eq!(printable(text), shown, "{text:?}");
        }
        assert_eq!(printable_line("a\nb\tc"), "a<U+000A>b<U+0009>c");
    }

    #[test]
    fn plain_text_is_not_copied() {
        assert!(matches!(printable("plain\n"), Cow::Borrowed(_)));
    }

    proptest! {
        #[test]
        fn nothing_unseen_is_left(text in any::<String>()) {
            let shown = printable(&text);
            prop_assert!(shown.chars().all(|c| is_shown(c) || matches!(c, '\n' | '\t')));
            prop_assert_eq!(printable(&shown), shown.as_ref());
            prop_assert!(printable_line(&text).chars().all(is_shown));
        }
    }
}
