//! The time in hypotheses, what starts somewhere, what is constant in pieces, transposes of scalars, and the parts of
//! complex letters. A hypothesis such as x sin t = 0 may be meant at a moment or always; sin t = 0 at a moment says
//! nothing of x.

use super::dots::Draw;
use super::unwritten::{Claim, Truth, undecided};
use Truth::{False, Open, True};

const LETTERS: &str = r"```toml symbols
a = { positive = true }
b = { positive = true }
x = { }
y = { }
z = { }
u = { domain = 'complex' }
w = { domain = 'complex' }
t = { }
p = { function_of = 't' }
q = { function_of = 't' }
r = { function_of = 't' }
'\xi' = { }
```
```toml notation
'\pi' = { constant = 'pi' }
e = { constant = 'e' }
i = { constant = 'i' }
```
```math 1 define
h(\xi) = \begin{cases} 1 & \xi \ge 0 \\ 0 & \xi < 0 \end{cases}
```
```math 2 define
p(0) = a, \quad \dot q = b, \quad q(0) = a
```
```math 3 define
\varphi = a t
```
";

/// Functions of the time that vanish at a moment.
const VANISHING: [(&str, &str); 8] = [
    (r"\sin t", "0"),
    (r"\sin t", r"\pi"),
    (r"\sin t", r"2\pi"),
    (r"\cos t", r"\pi/2"),
    ("t", "0"),
    ("(t - 1)", "1"),
    ("(t^2 - 4)", "2"),
    ("(e^t - 1)", "0"),
];

#[test]
fn a_hypothesis_with_the_time_says_nothing_at_a_moment_at_which_it_is_empty() {
    let mut claims = Vec::new();
    for (f, moment) in VANISHING {
        for (left, right) in [("x", "0"), ("x", "y"), ("x", "ay"), ("x + y", "z")] {
            let empty = match right {
                "0" => format!("{left}{f} = 0"),
                _ if left.contains('+') => format!("({left}){f} = {right}{f}"),
                _ => format!("{left}{f} = {right}{f}"),
            };
            let at = format!("t = {moment}");
            let equal = format!("{left} = {right}");
            claims.extend(Claim::assumed_and_given(&equal, &[&empty, &at], False));
            claims.extend(Claim::assumed_and_given(&equal, &[&empty], Open));
        }
    }
    // What processes are tied by always, beside a moment.
    for (relation, at) in [
        (r"r^3 + r = x\cos t", r"\pi/2"),
        ("r^3 + r = xt", "0"),
        (r"r^3 + r = x\sin t", r"\pi"),
        ("r^2 = e^{xt}", "0"),
        (r"e^r = 2 + x\sin^2 t", r"\pi"),
        (r"r^2 = 2 + \sin(xt)", "0"),
    ] {
        for moment in [
            vec![format!("t = {at}")],
            vec!["t = y".into(), format!("y = {at}")],
        ] {
            let mut all = vec![relation];
            all.extend(moment.iter().map(String::as_str));
            for claim in ["x = 0", r"x^2 \le 0", "x < 1"] {
                claims.extend(Claim::assumed_and_given(claim, &all, False));
            }
        }
    }
    for (relation, other) in [
        ("t(1 + r^2) = 0", "q = xt"),
        ("r = t", "r = 1"),
        ("te^r = 0", "z = xt"),
    ] {
        for claim in [r"\dot r = 1", r"\dot r = 0", r"\dot q = 0", "x = 0"] {
            claims.extend(Claim::assumed_and_given(claim, &[relation, other], Open));
            claims.extend(Claim::assumed_and_given(claim, &[other, relation], Open));
        }
    }
    for (c, angle, value) in [
        ("a", r"\pi/2", "0"),
        ("b", r"\pi", "-1"),
        ("ab", r"\pi/3", r"\frac12"),
    ] {
        let at = format!("{c}t = {angle}");
        let cosine = format!(r"\cos {c}t = {value}");
        claims.extend(Claim::assumed_and_given(&cosine, &[&at], True));
        let wrong = format!(r"\cos {c}t = {value} + 1");
        claims.extend(Claim::assumed_and_given(&wrong, &[&at], False));
    }
    for angle in [r"\pi/2", r"\pi", "1", "b"] {
        let at = format!(r"\varphi = {angle}");
        claims.extend(Claim::assumed_and_given(r"\dot\varphi = 0", &[&at], False));
        claims.extend(Claim::assumed_and_given(r"\dot\varphi = a", &[&at], True));
    }
    undecided(LETTERS, &claims);
}

#[test]
fn where_a_process_is_follows_from_where_it_starts() {
    let mut claims = Vec::new();
    for (rate, at) in [
        ("b", "a + bt"),
        ("0", "a"),
        ("2t", "a + t^2"),
        ("-p", "ae^{-t}"),
        ("bp", "ae^{bt}"),
        (r"b\cos t", r"a + b\sin t"),
        ("b + t", r"a + bt + \frac12t^2"),
    ] {
        let motion = format!(r"\dot p = {rate}");
        let path = format!("p = {at}");
        claims.extend(Claim::assumed_and_given(&path, &[&motion], True));
        let square = format!("p^2 = ({at})^2");
        claims.extend(Claim::assumed_and_given(&square, &[&motion], True));
        let off = format!("p = {at} + 1");
        claims.extend(Claim::assumed_and_given(&off, &[&motion], False));
    }
    for k in 1..=40 {
        claims.push(Claim::plain(format!("{k}q = {k}a + {k}bt"), True));
        claims.push(Claim::plain(format!("{k}q = {k}a + bt + {k}"), False));
    }
    undecided(LETTERS, &claims);
}

#[test]
fn what_is_constant_in_pieces_is_no_constant() {
    let mut random = Draw::new(41);
    let mut claims = Vec::new();
    for _ in 0..70 {
        let k = 1 + random.below(6);
        let letter = ["t", "p", "r"][random.below(3)];
        let piece = match random.below(7) {
            0 => format!(r"\frac{{|{letter}|}}{{{letter}}}"),
            1 => format!(r"\frac{{{k}\cos {letter}}}{{\sqrt{{1 - \sin^2 {letter}}}}}"),
            2 => format!("h({letter})"),
            3 => format!("h({letter} - {k}) + {k}"),
            4 => format!(r"\frac{{\sqrt{{{letter}^2}}}}{{{k}{letter}}}"),
            5 => format!("2^{{h({letter})}}"),
            _ => format!(r"\frac{{|{letter} - {k}|}}{{{letter} - {k}}}"),
        };
        claims.push(Claim::plain(format!(r"{piece} = \mathrm{{const}}"), False));
        let truly = match random.below(4) {
            0 => format!(r"\cos^2 {letter} + \sin^2 {letter} + {k}"),
            1 => format!(r"{k}\sqrt{{a^2 + b}}"),
            2 => format!(r"\frac{{{k}{letter} + {k}a}}{{{letter} + a}}"),
            _ => format!(r"e^{{{letter}}}e^{{{k} - {letter}}}"),
        };
        claims.push(Claim::plain(format!(r"{truly} = \mathrm{{const}}"), True));
    }
    let open = undecided(LETTERS, &claims);
    assert!(open.len() <= claims.len() * 6 / 10, "{open:#?}");
}

#[test]
fn a_superscript_t_of_a_scalar_is_no_transpose_in_silence() {
    let head = r"```toml symbols
x = { positive = true }
y = { positive = true }
K = { positive = true }
```
```toml notation
e = { constant = 'e' }
```
";
    let mut claims = Vec::new();
    for letter in ["t", "T"] {
        for base in ["x", "(1 + x)", r"\frac{x}{y}", "(xy)", "2x", r"\cos x"] {
            let raised = match base {
                "2x" => format!("2x^{letter}"),
                r"\cos x" => format!(r"\cos^{letter} x"),
                base if base.starts_with('\\') => format!(r"\left({base}\right)^{letter}"),
                base => format!("{base}^{letter}"),
            };
            claims.push(Claim::plain(format!("{raised} = {base}"), Open));
            claims.push(Claim::plain(
                format!(r"K \cdot {raised} = K \cdot {base}"),
                Open,
            ));
            claims.push(Claim::plain(format!("{raised} + y = {base} + y"), Open));
            claims.push(Claim::plain(format!("{raised} = {base} + 1"), Open));
        }
    }
    for base in ["K", "Kx", "K + x"] {
        for n in 2..=10 {
            let sum = format!(r"\sum_{{t=1}}^{{{n}}} \frac{{{base}}}{{(1 + x)^t}}");
            claims.push(Claim::plain(
                format!(r"{sum} = {n} \cdot \frac{{{base}}}{{1 + x}}"),
                Open,
            ));
            claims.push(Claim::plain(format!("{sum} = {n}({base})"), Open));
        }
    }
    undecided(head, &claims);
}

#[test]
fn parts_and_moduli_of_complex_letters() {
    let re = |f: &str| format!(r"\operatorname{{Re}}({f})");
    let im = |f: &str| format!(r"\operatorname{{Im}}({f})");
    let mut claims = Vec::new();
    let mut both = |left: String, right: String, wrong: String| {
        claims.push(Claim::plain(format!("{left} = {right}"), True));
        claims.push(Claim::plain(format!("{left} = {wrong}"), False));
    };
    for (f, g) in [
        ("u", "w"),
        ("w", "u"),
        ("u + x", "w"),
        ("2u", "w - y"),
        ("iu", "w"),
        ("u", "x + iy"),
    ] {
        both(
            re(&format!("({f}) + ({g})")),
            format!("{} + {}", re(f), re(g)),
            format!("{} - {}", re(f), re(g)),
        );
        both(
            im(&format!("({f}) - ({g})")),
            format!("{} - {}", im(f), im(g)),
            format!("{} - {}", im(f), re(g)),
        );
        let product = format!("({f})({g})");
        both(
            re(&product),
            format!(r"{} \cdot {} - {} \cdot {}", re(f), re(g), im(f), im(g)),
            format!(r"{} \cdot {}", re(f), re(g)),
        );
        both(
            im(&product),
            format!(r"{} \cdot {} + {} \cdot {}", re(f), im(g), im(f), re(g)),
            format!(r"{} \cdot {}", im(f), im(g)),
        );
        both(
            format!("|{product}|"),
            format!("|{f}||{g}|"),
            format!("|{f}| + |{g}|"),
        );
        both(
            format!(r"\left|\frac{{{f}}}{{{g}}}\right|"),
            format!(r"\frac{{|{f}|}}{{|{g}|}}"),
            format!(r"\frac{{|{g}|}}{{|{f}|}}"),
        );
        both(
            format!("|{f}|^2"),
            format!("({})^2 + ({})^2", re(f), im(f)),
            format!("({f})^2"),
        );
        both(
            format!("|({f}) + ({g})|^2 + |({f}) - ({g})|^2"),
            format!("2|{f}|^2 + 2|{g}|^2"),
            format!("|{f}|^2 + |{g}|^2"),
        );
        both(
            format!("|e^{{{f}}}|"),
            format!("e^{{{}}}", re(f)),
            format!("e^{{{f}}}"),
        );
        both(re(&format!("i({f})")), format!("-{}", im(f)), im(f));
    }
    let open = undecided(LETTERS, &claims);
    assert!(open.len() * 10 <= claims.len(), "{open:#?}");
}
