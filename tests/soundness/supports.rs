//! A function by cases times a Dirac distribution: what counts is the value where the distribution stands. The
//! functions are evaluated here, at rational numbers; a product with a jump at that place has no meaning.

use super::dots::Draw;
use super::unwritten::{Claim, Truth, undecided};

const PREAMBLE: &str = r"# Functions by cases beside a distribution

```toml symbols
x = {}
y = {}
a = { positive = true }
'\xi' = {}
```

```toml notation
'\delta' = { dirac = true }
```

```math steps define
h(\xi) = \begin{cases} 0 & \xi < 0 \\ 1 & \xi \ge 0 \end{cases}
```

```math modulus define
m(\xi) = \begin{cases} -\xi & \xi \le 0 \\ \xi & \xi > 0 \end{cases}
```

```math window define
w(\xi) = \begin{cases} 3 & -1 \le \xi \le 1 \\ 0 & \text{otherwise} \end{cases}
```

```math limiter define
p(\xi) = \begin{cases} -1 & \xi < -1 \\ \xi & -1 \le \xi \le 1 \\ 1 & \xi > 1 \end{cases}
```

```math gap define
g(\xi) = \begin{cases} 2 & \xi < -1 \\ 5 & \xi > 1 \end{cases}
```
";

/// A function of the preamble, at halves.
#[derive(Clone, Copy)]
struct Function {
    name: &'static str,
    /// Twice its value at half of this; none where it jumps or has no value.
    at: fn(i64) -> Option<i64>,
}

const FUNCTIONS: [Function; 5] = [
    Function {
        name: "h",
        at: |u| (u != 0).then_some(if u > 0 { 2 } else { 0 }),
    },
    Function {
        name: "m",
        at: |u| Some(u.abs()),
    },
    Function {
        name: "w",
        at: |u| (u.abs() != 2).then_some(if u.abs() < 2 { 6 } else { 0 }),
    },
    Function {
        name: "p",
        at: |u| Some(u.clamp(-2, 2)),
    },
    Function {
        name: "g",
        at: |u| (u.abs() > 2).then_some(if u > 0 { 10 } else { 4 }),
    },
];

/// Half of a number, in print.
fn half(n: i64) -> String {
    match n % 2 {
        0 => format!("{}", n / 2),
        _ if n < 0 => format!(r"-\frac{{{}}}{{2}}", -n),
        _ => format!(r"\frac{{{n}}}{{2}}"),
    }
}

fn moved(letter: &str, by: i64) -> String {
    match by {
        0 => letter.into(),
        n if n < 0 => format!("{letter} - {}", half(-n)),
        n => format!("{letter} + {}", half(n)),
    }
}

fn multiple(of: i64, delta: &str) -> String {
    match of {
        0 => "0".into(),
        2 => delta.into(),
        n => format!("{}{delta}", half(n)),
    }
}

#[test]
fn what_counts_is_the_value_where_a_distribution_stands() {
    let mut draw = Draw::new(71);
    let mut claims = Vec::new();
    while claims.len() < 300 {
        let function = FUNCTIONS[draw.below(FUNCTIONS.len())];
        let other = FUNCTIONS[draw.below(FUNCTIONS.len())];
        // In halves: where it stands, and how far the arguments are moved.
        let place = [0, draw.below(7) as i64 - 3][draw.below(2)];
        let [by, also] = [(); 2].map(|()| draw.below(11) as i64 - 5);
        let scale = [1, 1, 2, -1][draw.below(4)];
        let delta = format!(r"\delta\left({}\right)", moved("x", -place));
        let argument = match scale {
            1 => moved("x", by),
            -1 => moved("-x", by),
            n => moved(&format!("{n}x"), by),
        };
        let value = (function.at)(scale * place + by);
        let (left, value) = match draw.below(3) {
            0 => {
                let second = (other.at)(place + also);
                let left = format!(
                    r"{}\left({argument}\right){}\left({}\right){delta}",
                    function.name,
                    other.name,
                    moved("x", also)
                );
                // Quarters, which are halves here.
                let both = value.zip(second).map(|(u, v)| u * v);
                (left, both.filter(|b| b % 2 == 0).map(|b| b / 2))
            }
            1 => (
                format!(r"{delta}{}\left({argument}\right)", function.name),
                value,
            ),
            _ => (
                format!(r"{}\left({argument}\right){delta}", function.name),
                value,
            ),
        };
        let Some(value) = value else {
            if draw.below(4) == 0 {
                let said = draw.below(3) as i64 * 2 + 14;
                let right = multiple(said, &delta);
                claims.push(Claim::plain(format!("{left} = {right}"), Truth::Open));
            }
            continue;
        };
        let right = draw.coin();
        let said = match right {
            true => value,
            false => value + [1, -2, 4][draw.below(3)],
        };
        let said = multiple(said, &delta);
        let truth = if right { Truth::True } else { Truth::False };
        claims.push(Claim::plain(format!("{left} = {said}"), truth));
    }
    for (claim, truth) in [
        (r"h(x - 1)\delta(x) = 0", Truth::True),
        (r"h(x - a)\delta(x) = 0", Truth::True),
        (r"h(x + a)\delta(x) = \delta(x)", Truth::True),
        (r"h(x + a)\delta(x) = 0", Truth::False),
        (r"h(x - a)\delta(x) = \delta(x)", Truth::False),
        (r"m(x - a)\delta(x) = a\delta(x)", Truth::True),
        (r"m(x - a)\delta(x) = -a\delta(x)", Truth::False),
        (r"m(x - y)\delta(x) = m(y)\delta(x)", Truth::True),
        (r"m(x - y)\delta(x) = |y|\delta(x)", Truth::True),
        (r"m(x - y)\delta(x) = m(-y)\delta(x)", Truth::True),
        (r"m(x - y)\delta(x) = y\delta(x)", Truth::False),
        (r"m(x - y)\delta(x) = 2m(y)\delta(x)", Truth::False),
        (r"m(x - y)\delta(x - y) = 0", Truth::True),
        (r"h(x)\delta(x) = 7\delta(x)", Truth::Open),
        (r"g(x)\delta(x) = 0", Truth::Open),
        (r"g(x)\delta(x) = 7\delta(x)", Truth::Open),
        (r"h(x - 1)\delta(x) = h(x - 1)", Truth::False),
        (
            r"h(x - 1)\left(1 + \delta(x)\right) = h(x - 1)",
            Truth::True,
        ),
        (
            r"h(x + 1)\left(1 + \delta(x)\right) = h(x + 1) + \delta(x)",
            Truth::True,
        ),
        (
            r"h(x + 1)\left(1 + \delta(x)\right) = h(x + 1)",
            Truth::False,
        ),
    ] {
        claims.push(Claim::plain(claim, truth));
    }
    // What is false where no x = 0 stands is not shown.
    let with_truth = claims.iter().filter(|c| c.has_truth()).count();
    let open = undecided(PREAMBLE, &claims);
    assert!(
        2 * open.len() < with_truth,
        "{} of {with_truth} undecided: {open:#?}",
        open.len()
    );
}

const POLES: &str = r"# What cancels where a distribution stands

```toml symbols
x = {}
a = { positive = true }
'\xi' = {}
```

```toml notation
'\delta' = { dirac = true }
```

```math named define
s = \frac{1}{x}, \quad r = \frac{1}{x - 1}
```

```math f define
f(\xi) = \frac{1}{\xi}
```

```math m define
m(\xi) = \xi^2, \quad 0 < \xi < 2
```
";

#[test]
fn what_has_no_value_where_a_distribution_stands_is_open() {
    let mut draw = Draw::new(12);
    let mut claims = Vec::new();
    let shifted = |by: usize| ["x", "(x - 1)"][by].to_string();
    while claims.len() < 240 {
        let [place, pole] = [(); 2].map(|()| draw.below(2));
        let power = draw.below(3);
        let delta = [r"\delta(x)", r"\delta(x - 1)"][place];
        let factor = match power {
            0 => String::new(),
            1 => shifted(place),
            _ => format!("{}^2", shifted(place)),
        };
        let inverse = match draw.below(4) {
            0 => ["s", "r"][pole].to_string(),
            1 => ["f(x)", "f(x - 1)"][pole].to_string(),
            2 => format!(r"\frac{{1}}{{{}}}", shifted(pole)),
            _ => format!(r"\frac{{a}}{{a{}}}", shifted(pole)),
        };
        // 1 over 0 - 1, or over 1 - 0.
        let value = match (power, place) {
            (0, 0) => "-",
            (0, _) => "",
            _ => "0",
        };
        let right = draw.coin();
        let said = match (right, value) {
            (true, "0") => "0".to_string(),
            (true, sign) => format!("{sign}{delta}"),
            (false, _) => format!("2{delta}"),
        };
        let truth = match (place == pole, right) {
            (true, _) => Truth::Open,
            (false, true) => Truth::True,
            (false, false) => Truth::False,
        };
        let inside = format!("{factor}{inverse}{delta}");
        claims.push(match draw.below(3) {
            0 => {
                let number =
                    said.replace(delta, if said == format!("2{delta}") { "" } else { "1" });
                Claim::plain(format!(r"\int_{{-3}}^3 {inside}\,dx = {number}"), truth)
            }
            1 => Claim::plain(format!(r"a{inside} = a\left({said}\right)"), truth),
            _ => Claim::plain(format!("{inside} = {said}"), truth),
        });
    }
    for (claim, truth) in [
        (r"xs\delta(x) = xs\delta(x) + 0", Truth::Open),
        (r"\frac{x\delta(x)}{x} = \delta(x)", Truth::Open),
        (r"\frac{x^2s}{x}\delta(x) = \delta(x)", Truth::Open),
        (r"\frac{\sin x}{x} \cdot x\delta(x) = 0", Truth::Open),
        (r"x\delta(x) = 0", Truth::True),
        (r"\frac{x}{a}\delta(x) = 0", Truth::True),
        (r"m(x)\delta(x - 1) = \delta(x - 1)", Truth::True),
        (r"m(x)\delta(x - 3) = 9\delta(x - 3)", Truth::Open),
        (r"m(x)\delta(x) = 0", Truth::Open),
        (r"m(x)\delta(x - 2) = 4\delta(x - 2)", Truth::Open),
        ("xs = 1", Truth::True),
    ] {
        claims.push(Claim::plain(claim, truth));
    }
    let with_truth = claims.iter().filter(|c| c.has_truth()).count();
    let open = undecided(POLES, &claims);
    assert!(
        2 * open.len() < with_truth,
        "{} of {with_truth}: {open:#?}",
        open.len()
    );
}
