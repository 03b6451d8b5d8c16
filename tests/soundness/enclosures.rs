//! The second route: true claims are apart at no admissible point, false ones at some.
//!
//! Every identity stands here once as it is and once with a small number added to its right side, so
//! that half of the claims are true and half are false; what is false in another way stands in lists of
//! its own. The truth of each is known from textbooks or by construction.

use rederive::document::Document;
use rederive::enclose::{Budget, Challenge, challenge};
use rederive::enclose::{Comparison, NoPoint, Points, World};
use rederive::model::Model;
use std::collections::BTreeMap;
use std::fmt::Write;

const POINTS: usize = 20;

fn model(text: &str) -> Model {
    let document = Document::parse("test.md", text).unwrap_or_else(|d| panic!("{d:?}\n{text}"));
    Model::build(&document).unwrap_or_else(|d| panic!("{d:?}\n{text}"))
}

/// A document with these claims, each an equation of its own.
fn document(head: &str, claims: &[String]) -> String {
    let mut text = format!("{head}\n");
    for (k, claim) in claims.iter().enumerate() {
        let _ = write!(text, "```math c{k} claim\n{claim}\n```\n\n");
    }
    text
}

/// What is found about each claim at twenty points.
fn found(head: &str, claims: &[String]) -> Vec<Challenge> {
    let model = model(&document(head, claims));
    let mut outcomes = Vec::new();
    for instance in 0..model.instances.len() {
        let world = World::new(&model, instance, BTreeMap::new());
        let budget = Budget {
            points: POINTS,
            tries: POINTS,
            bits: vec![128],
            ..Budget::default()
        };
        for k in 0..claims.len() {
            let equation = model.equation(&format!("c{k}")).unwrap();
            let links = &model.equations[equation].links;
            let assume = &model.equations[equation].assume;
            // Primes are derivatives, whatever a claim that begins with them is taken for.
            let defines = &model.equations[equation].defines;
            let primed = claims[k].contains('\'');
            assert!(
                primed || defines.iter().all(Option::is_none),
                "{}",
                claims[k]
            );
            for link in links {
                outcomes.push(challenge(&world, equation, link, assume, &budget));
            }
        }
    }
    outcomes
}

fn all_true(head: &str, claims: &[String]) {
    for (claim, outcome) in claims.iter().zip(found(head, claims)) {
        assert!(
            outcome.apart.is_none(),
            "{claim} is true: {:?}",
            outcome.apart
        );
        assert!(
            outcome.evaluated > 0,
            "{claim} was not evaluated: {outcome:?}"
        );
    }
}

fn all_false(head: &str, claims: &[String]) {
    for (claim, outcome) in claims.iter().zip(found(head, claims)) {
        assert!(outcome.apart.is_some(), "{claim} is false: {outcome:?}");
    }
}

fn lines(text: &str) -> Vec<String> {
    let lines = text.lines().map(str::trim).filter(|l| !l.is_empty());
    lines.map(String::from).collect()
}

/// Identities as they are, and with something added.
fn both(head: &str, identities: &str) {
    let identities = lines(identities);
    all_true(head, &identities);
    let spoilt: Vec<String> = identities
        .iter()
        .map(|i| format!("{i} + \\frac{{1}}{{97}}"))
        .collect();
    all_false(head, &spoilt);
}

const LETTERS: &str = r#"```toml document
title = "t"
```
```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
x = { meaning = "real" }
y = { meaning = "real" }
z = { domain = "complex" }
w = { domain = "complex" }
n = { domain = "integer", range = "1 \\le n" }
s = { meaning = "bound" }
u = { range = "0 < u < 1" }
```
```toml notation
'\pi' = { constant = "pi" }
'e' = { constant = "e" }
'i' = { constant = "i" }
```
"#;

#[test]
fn algebra() {
    both(
        LETTERS,
        r"
        (x + y)^2 = x^2 + 2xy + y^2
        (x - y)(x + y) = x^2 - y^2
        (x + 1)^3 = x^3 + 3x^2 + 3x + 1
        \frac{1}{a} + \frac{1}{b} = \frac{a + b}{ab}
        \frac{a^2 - b^2}{a + b} = a - b
        \frac{x}{1 + x^2} + \frac{x^3}{1 + x^2} = x
        \frac{1}{1 + \frac{1}{a}} = \frac{a}{a + 1}
        (a b)^{-2} = \frac{1}{a^2 b^2}
        (x^2 + y^2)(a^2 + b^2) = (ax - by)^2 + (bx + ay)^2
        z^2 - w^2 = (z - w)(z + w)
        (z + w)^3 = z^3 + 3z^2w + 3zw^2 + w^3
        i^2 = -1
        (1 + i)^4 = -4
        \sum_{k=1}^{5} k = 15
        \sum_{k=1}^{6} k^2 = 91
        \sum_{k=0}^{4} x^k (1 - x) = 1 - x^5
        \sum_{j=1}^{3} \sum_{k=1}^{3} jk = 36
        0.1 + 0.2 = 0.3
        \frac{a}{b} \cdot \frac{b}{c} \cdot \frac{c}{a} = 1
        (x-1)^2 = x^2 - 2x + 1
        ",
    );
}

#[test]
fn functions() {
    both(
        LETTERS,
        r"
        \cos^2 x + \sin^2 x = 1
        \cos(x + y) = \cos x \cos y - \sin x \sin y
        \sin(x + y) = \sin x \cos y + \cos x \sin y
        \sin 2x = 2\sin x\cos x
        \cos 2x = 2\cos^2 x - 1
        \cos 3x = 4\cos^3 x - 3\cos x
        \tan u = \frac{\sin u}{\cos u}
        \cot u = \frac{\cos u}{\sin u}
        1 + \tan^2 u = \frac{1}{\cos^2 u}
        \cosh^2 x - \sinh^2 x = 1
        \cosh u = \frac{e^u + e^{-u}}{2}
        \sinh u = \frac{e^u - e^{-u}}{2}
        \tanh u = \frac{\sinh u}{\cosh u}
        \tanh u = \frac{e^{2u} - 1}{e^{2u} + 1}
        e^{u + s - s} = e^{u}
        e^{\ln a} = a
        \ln(ab) = \ln a + \ln b
        \ln\sqrt a = \frac12 \ln a
        \ln\frac{1}{a} = -\ln a
        \ln a^3 = 3\ln a
        2^u = e^{u\ln 2}
        (e^u)^u = e^{u u}
        a^{\frac12} = \sqrt a
        \sqrt{a}\sqrt{b} = \sqrt{ab}
        \sqrt{a^2} = a
        \sqrt{x^2} = |x|
        \sqrt{a + b + 2\sqrt{ab}} = \sqrt a + \sqrt b
        \sqrt{3 + 2\sqrt 2} = 1 + \sqrt 2
        \sqrt{\sin^2 x} = |\sin x|
        \cos\frac{\pi}{3} = \frac12
        \sin\frac{\pi}{6} = \frac12
        \cos\frac{\pi}{4} = \frac{\sqrt 2}{2}
        \tan\frac{\pi}{4} = 1
        \cos\pi = -1
        \sin\pi = 0
        e^{i\pi} = -1
        e^{ix} = \cos x + i\sin x
        |e^{ix}| = 1
        |x|^2 = x^2
        |z w| = |z||w|
        |z|^2 = (\mathrm{Re}\, z)^2 + (\mathrm{Im}\, z)^2
        z = \mathrm{Re}\, z + i\,\mathrm{Im}\, z
        \sqrt{-4} = 2i
        (\sqrt{z})^2 = z
        |\sqrt{z}|^2 = |z|
        \exp(a + b) = \exp a\exp b
        \cos(-x) = \cos x
        \sin(x + 2\pi) = \sin x
        \sin(x + \frac{\pi}{2}) = \cos x
        \cos(100\pi + u) = \cos u
        a^{n} a = a^{n + 1}
        (a b)^{x} = a^{x} b^{x}
        a^{x + y} = a^x a^y
        (\sqrt 2 + \sqrt 3)^2 = 5 + 2\sqrt 6
        \cosh(x + y) = \cosh x\cosh y + \sinh x \sinh y
        ",
    );
    all_false(
        LETTERS,
        &lines(
            r"
            \sqrt{x^2} = x
            |z|^2 = z^2
            |x| = x
            \sqrt{z^2} = z
            |\sqrt x|^2 = x
            \cos x = \sin x
            e^{x + y} = e^x + e^y
            \ln(a + b) = \ln a + \ln b
            \sqrt{a + b} = \sqrt a + \sqrt b
            \pi = \frac{22}{7}
            e = 2.718281828
            \sqrt 2 = 1.414213562373
            \cos(x + y) = \cos x\cos y + \sin x\sin y
            \tan 2u = 2\tan u
            |x + y| = |x| + |y|
            \mathrm{Re}(zw) = \mathrm{Re}\, z\,\mathrm{Re}\, w
            a^{b} = b^{a}
            \cosh x = \cos x
            ",
        ),
    );
}

#[test]
fn inequalities() {
    all_true(
        LETTERS,
        &lines(
            r"
            (x - 1)^2 \ge 0
            x^2 + y^2 \ge 2xy
            a + b \ge 2\sqrt{ab}
            \cos x < 2
            e^a > 1
            \sqrt{a + 8} > \sqrt a
            |x + y| \le |x| + |y|
            a + 1 > 0
            u^2 < u
            n \ge 1
            e^x > 0
            \ln a \le a - 1
            \sin a < a
            \cosh x \ge 1
            |z + w| \le |z| + |w|
            x^2 + 1 \ne 0
            \pi > 3
            \pi < \frac{22}{7}
            -a < b
            \tanh x < 1
            ",
        ),
    );
    all_false(
        LETTERS,
        &lines(
            r"
            x^2 > 0
            (x - 1)^2 > 1
            a > b
            x \ge 0
            a + b \ge 3\sqrt{ab} + 1
            \cos x < \frac12
            e^x > 1
            \sin x > 0
            u > \frac12
            \ln a > 0
            n > 2
            |x| > |y|
            x \ne x
            \pi < 3.1415926
            a^2 < a
            x^2 + y^2 \le 2xy
            ",
        ),
    );
}

#[test]
fn derivatives_and_integrals() {
    both(
        LETTERS,
        r"
        \frac{d}{dx} x^3 = 3x^2
        \frac{d}{dx}(x^2 y) = 2xy
        \frac{d}{dx} \exp(\sin x) = \cos x\exp(\sin x)
        \frac{d}{dx} \sin(x^2) = 2x\cos(x^2)
        \frac{d^2}{dx^2} \sin x = -\sin x
        \frac{d^3}{dx^3} x^5 = 60x^2
        \frac{d}{da} \ln a = \frac{1}{a}
        \frac{d}{da} \sqrt a = \frac{1}{2\sqrt a}
        \frac{d}{da} a^{b} = b a^{b - 1}
        \frac{d}{db} a^{b} = a^{b}\ln a
        \frac{d}{du} \tan u = 1 + \tan^2 u
        \frac{d}{dx} \cosh x = \sinh x
        \frac{d}{dx} \tanh x = 1 - \tanh^2 x
        \frac{d}{dx} \frac{1}{1 + x^2} = -\frac{2x}{(1 + x^2)^2}
        \frac{\partial^2}{\partial x\partial y} (x^3 y^2) = 6x^2y
        \frac{\partial}{\partial y} e^{xy} = x e^{xy}
        \frac{d}{da} |-a| = 1
        \frac{d}{dx} \left( x \frac{d}{dx} x^3 \right) = 9x^2
        \frac{d^2}{dx^2} e^{x^2} = (4x^2 + 2)e^{x^2}
        \int_0^1 s^2\, ds = \frac13
        \int_0^a s\, ds = \frac{a^2}{2}
        \int_x^y 3s^2\, ds = y^3 - x^3
        \int_0^1 e^s\, ds = e - 1
        \int_0^u e^{-s}\, ds = 1 - e^{-u}
        \int_0^\pi \sin s\, ds = 2
        \int_0^1 \frac{1}{1 + s^2}\, ds = \frac{\pi}{4}
        \int_1^2 \frac{1}{s}\, ds = \ln 2
        \int_0^1 s e^{s}\, ds = 1
        \int_{-1}^{1} s^3\, ds = 0
        \int_0^1 (s^2 + xs)\, ds = \frac13 + \frac{x}{2}
        \frac{d}{dx} \int_0^x \cos s\, ds = \cos x
        \int_0^1 \int_0^1 xs\, ds\, dx = \frac14
        \int_0^2 |s - 1|\, ds = 1 + 0
        ",
    );
    all_false(
        LETTERS,
        &lines(
            r"
            \frac{d}{dx} \exp(\sin x) = \exp(\cos x)
            \frac{d^2}{dx^2} \sin x = \sin x
            \frac{d}{dx} (xy) = x
            \frac{d}{da} \frac{1}{a} = \frac{1}{a^2}
            \int_0^1 s^2\, ds = \frac12
            \int_0^a e^s\, ds = e^a
            \int_0^1 \sin s\, ds = 1 - \sin 1
            \frac{d}{da} a^{b} = a^{b} \ln a
            \frac{d}{dx} \int_0^x s^2\, ds = 2x
            ",
        ),
    );
}

const DEFINED: &str = r#"```toml document
title = "t"
```
```toml symbols
x = { meaning = "real" }
y = { meaning = "real" }
u = { meaning = "argument" }
v = { meaning = "argument" }
a = { positive = true }
```
```math d1 define
f(u) = u^2, \quad 0 < u < 1
```
```math d2 define
g(u) = u^3 + a u
```
```math d3 define
h(u) = \begin{cases} u & u \ge 0 \\ -u & u < 0 \end{cases}
```
```math d4 define
k(u, v) = u v^2
```
```math d5 define
q = a^2 + 1
```
```math d6 define
p_0 = 1
```
```math d7 define
p_m = x p_{m-1} + 1, \quad m = 1(1)5
```
```math d8 define
\sigma^2 = a^4 + q
```
```math d9 define
j(u) = \begin{cases} u^2 & u < 1 \\ 2u - 1 & u \ge 1 \end{cases}
```
"#;

#[test]
fn definitions() {
    both(
        DEFINED,
        r"
        f(0.5) = \frac14
        g(2) = 8 + 2a
        g(u = x + 1) - g(x) = 3x^2 + 3x + 1 + a
        g(u = g(1)) = (1 + a)^3 + a(1 + a)
        h(x) = |x|
        h(u = -3) = 3
        k(x, y) = xy^2
        k(y, x) = yx^2
        k(u = 2, v = 3) = 18
        q - 1 = a^2
        p_2 = x^2 + x + 1
        p_5 - x p_4 = 1
        \sigma^2 - q = a^4
        \sigma^4 - q^2 = a^8 + 2a^4 q
        \frac{d}{du} g(u) = 3u^2 + a
        \frac{d}{dx} g(u = 2x) = 24x^2 + 2a
        g'(u) = 3u^2 + a
        g'(2) = 12 + a
        g''(x) = 6x
        j(3) = 5
        j(0.5) = \frac14
        ",
    );
    all_false(
        DEFINED,
        &lines(
            r"
            h(x) = x
            k(x, y) = k(y, x)
            g'(u) = 7au
            g(u = x + y) = g(x) + g(y)
            p_3 = x^3 + 1
            j(x) = x^2
            ",
        ),
    );
}

#[test]
fn outside_of_its_range_a_function_has_no_value() {
    let claims = lines(
        r"
        f(5) = 25
        f(5) = 26
        f(0) = 0
        f(u = a + 1) = 7
        ",
    );
    for (claim, outcome) in claims.iter().zip(found(DEFINED, &claims)) {
        assert!(
            outcome.apart.is_none() && outcome.evaluated == 0,
            "{claim}: {outcome:?}"
        );
        assert!(outcome.undefined > 0, "{claim}: {outcome:?}");
    }
}

#[test]
fn what_has_no_value_is_not_apart() {
    let claims = lines(
        r"
        \frac{1}{x - x} = 7
        \frac{x - x}{x - x} = 1
        \ln(-a) = 3
        0^{x - x} = 1
        (-8)^{\frac13} = -2
        \frac{x^2 - x^2}{x - x} = 0
        ",
    );
    for (claim, outcome) in claims.iter().zip(found(LETTERS, &claims)) {
        assert!(
            outcome.apart.is_none() && outcome.evaluated == 0,
            "{claim}: {outcome:?}"
        );
        assert!(outcome.undefined == POINTS, "{claim}: {outcome:?}");
    }
}

const MATRICES: &str = r#"```toml document
title = "t"
instances = { f = [2, 3] }
```
```toml symbols
'\mathbf{M}' = { shape = ["f", "f"], symmetric = true, positive_definite = true }
'\mathbf{K}' = { shape = ["f", "f"], symmetric = true, positive_definite = true }
'\mathbf{G}' = { shape = ["f", "f"], skew = true }
'\mathbf{A}' = { shape = ["f", "f"] }
'\mathbf{B}' = { shape = ["f", "f"] }
'\mathbf{x}' = { shape = ["f", 1] }
'\mathbf{y}' = { shape = ["f", 1] }
'\lambda' = { meaning = "a number" }
a = { positive = true }
```
```toml notation
'\mathbf{E}' = { identity = "f" }
'\mathbf{0}' = { zero = true }
'A_{i,j}' = { entry_of = '\mathbf{A}' }
'a_i' = { characteristic_coefficient_of = '\mathbf{A}' }
'\mathbf{H}' = { hurwitz_matrix_of = '\mathbf{A}' }
'H_i' = { leading_minor_of = '\mathbf{H}' }
'C_{i,j}' = { cofactor_of = '\mathbf{A}' }
```
"#;

#[test]
fn matrices() {
    all_true(
        MATRICES,
        &lines(
            r"
            (\mathbf{A}\mathbf{B})^T = \mathbf{B}^T\mathbf{A}^T
            \det(\mathbf{A}\mathbf{B}) = \det\mathbf{A}\det\mathbf{B}
            \det\mathbf{A}^T = \det\mathbf{A}
            \mathbf{M}\mathbf{M}^{-1} = \mathbf{E}
            (\mathbf{M}\mathbf{K})^{-1} = \mathbf{K}^{-1}\mathbf{M}^{-1}
            \operatorname{tr}(\mathbf{A}\mathbf{B}) = \operatorname{tr}(\mathbf{B}\mathbf{A})
            \mathbf{G}^T = -\mathbf{G}
            \mathbf{x}^T\mathbf{G}\mathbf{x} = 0
            \mathbf{M} > \mathbf{0}
            \mathbf{M} + \mathbf{K} > \mathbf{0}
            \det\mathbf{M} > 0
            \mathbf{x}^T\mathbf{M}\mathbf{x} \ge 0
            \mathbf{M}^T = \mathbf{M}
            \mathbf{A} - \mathbf{A} = \mathbf{0}
            \det(\lambda\mathbf{E}) = \lambda^{f}
            \operatorname{tr}\mathbf{E} = f
            a_1 = -\operatorname{tr}\mathbf{A}
            H_1 = a_1
            C_{1,1}A_{1,1} = A_{1,1}C_{1,1}
            \begin{bmatrix} \mathbf{A} & \mathbf{0} \\ \mathbf{0} & \mathbf{B} \end{bmatrix} \begin{bmatrix} \mathbf{x} \\ \mathbf{y} \end{bmatrix} = \begin{bmatrix} \mathbf{A}\mathbf{x} \\ \mathbf{B}\mathbf{y} \end{bmatrix}
            \det\begin{bmatrix} \mathbf{A} & \mathbf{0} \\ \mathbf{0} & \mathbf{B} \end{bmatrix} = \det\mathbf{A}\det\mathbf{B}
            \mathbf{M}^{-1} > \mathbf{0}
            \mathbf{A}^2 \mathbf{A} = \mathbf{A}^3
            \mathbf{x}^T\mathbf{y} = \mathbf{y}^T\mathbf{x}
            ",
        ),
    );
    all_false(
        MATRICES,
        &lines(
            r"
            \mathbf{A}\mathbf{B} = \mathbf{B}\mathbf{A}
            (\mathbf{A}\mathbf{B})^T = \mathbf{A}^T\mathbf{B}^T
            \det(\mathbf{A} + \mathbf{B}) = \det\mathbf{A} + \det\mathbf{B}
            \mathbf{A}^T = \mathbf{A}
            \operatorname{tr}(\mathbf{A}\mathbf{B}) = \operatorname{tr}\mathbf{A}\operatorname{tr}\mathbf{B}
            \mathbf{M} - \mathbf{K} > \mathbf{0}
            \mathbf{A} + \mathbf{A}^T > \mathbf{0}
            \mathbf{x}^T\mathbf{A}\mathbf{x} \ge 0
            (\mathbf{A} + \mathbf{B})^2 = \mathbf{A}^2 + 2\mathbf{A}\mathbf{B} + \mathbf{B}^2
            \det(2\mathbf{A}) = 2\det\mathbf{A}
            \mathbf{M} = \mathbf{K}
            \operatorname{tr}\mathbf{E} = f + 1
            a_1 = \operatorname{tr}\mathbf{A}
            C_{1,1} = A_{1,1}
            \mathbf{M}^{-1} > \mathbf{M}
            ",
        ),
    );
}

#[test]
fn any_size_is_looked_at() {
    let claims = lines(r"\det(-\mathbf{A}) = \det\mathbf{A}");
    let outcomes = found(MATRICES, &claims);
    assert!(outcomes[0].apart.is_none() && outcomes[1].apart.is_some());
}

const MOTION: &str = r#"```toml document
title = "t"
```
```toml symbols
t = { unit = "s" }
'\omega' = { positive = true }
m = { positive = true }
k = { positive = true }
y = { function_of = "t" }
x = { function_of = "t" }
'\mathbf{r}' = { shape = [2, 1], function_of = "t" }
```
```math d1 define
\varphi = \omega t
```
```math d2 define
\psi = m t^2
```
```math d3 define
\ddot y = -\frac{k}{m} y
```
```math d4 define
T = \frac12 m \dot y^2
```
```math d5 define
U = \frac12 k y^2
```
"#;

#[test]
fn time() {
    both(
        MOTION,
        r"
        \dot\varphi = \omega
        \ddot\varphi = 0
        \dot\psi = 2mt
        \ddot\psi = 2m
        \dddot y = -\frac{k}{m}\dot y
        \ddddot y = \frac{k^2}{m^2} y
        \dot T + \dot U = 0
        \frac{d}{dt}(xy) = \dot x y + x \dot y
        \frac{d}{dt} x^2 = 2x\dot x
        \frac{d^2}{dt^2} x^2 = 2\dot x^2 + 2x\ddot x
        \frac{d}{dt}\sin x = \dot x\cos x
        \frac{d}{dt}\cos\varphi = -\omega\sin\varphi
        \frac{d^2}{dt^2}\cos\varphi = -\omega^2\cos\varphi
        \frac{d}{dt} m = 0
        \frac{d}{dt}(t x) = x + t\dot x
        \frac{d}{dt}(\mathbf{r}^T\mathbf{r}) = 2\mathbf{r}^T\dot{\mathbf{r}}
        m\ddot y + ky = 0
        ",
    );
    all_true(MOTION, &lines(r"T + U = \text{const.}"));
    all_false(
        MOTION,
        &lines(
            r"
            \dot\varphi = 0
            \dot\varphi = \omega t
            \dot\psi = mt
            \dot x = 0
            \ddot y = \frac{k}{m} y
            \frac{d}{dt}(xy) = \dot x\dot y
            T - U = \text{const.}
            \dot{\mathbf{r}} = \mathbf{r}
            \dot x = \dot y
            ",
        ),
    );
}

const SOLVED: &str = r#"```toml document
title = "t"
```
```toml symbols
a = { positive = true }
b = { positive = true }
d = { positive = true }
q = { positive = true }
```
```toml notation
'\mathbf{0}' = { zero = true }
'P_{i,j}' = { entry_of = '\mathbf{P}' }
```
```math d1 define
\mathbf{A} = \begin{bmatrix} 0 & 1 \\ -a & -b \end{bmatrix}, \quad \mathbf{B} = \begin{bmatrix} 0 \\ 1 \end{bmatrix}
```
```math s1 solve \mathbf{P}
\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T + q\mathbf{B}\mathbf{B}^T = \mathbf{0}
```
```math s2 solve x, y
x + y = a, \quad x - y = b
```
```math s3 solve z
a z + z = d
```
"#;

#[test]
fn unknowns() {
    both(
        SOLVED,
        r"
        P_{11} = \frac{q}{2ab}
        P_{22} = \frac{q}{2b}
        P_{12} = 0
        x = \frac{a + b}{2}
        y = \frac{a - b}{2}
        xy = \frac{a^2 - b^2}{4}
        z = \frac{d}{1 + a}
        \frac{\partial}{\partial a} P_{11} = -\frac{q}{2a^2b}
        \frac{\partial}{\partial d} z = \frac{1}{1 + a}
        a P_{11} = P_{22}
        ",
    );
    all_true(
        SOLVED,
        &lines(
            r"
            \mathbf{P} > \mathbf{0}
            \mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T = -q\mathbf{B}\mathbf{B}^T
            \mathbf{P}^T = \mathbf{P}
            ",
        ),
    );
    all_false(
        SOLVED,
        &lines(
            r"
            P_{11} = P_{22}
            \mathbf{P} = \mathbf{0}
            -\mathbf{P} > \mathbf{0}
            x = y
            \frac{\partial}{\partial b} P_{11} = -\frac{q}{2a^2b}
            ",
        ),
    );
}

#[test]
fn a_covariance_is_semidefinite() {
    let head = r#"```toml document
title = "t"
```
```toml symbols
'\phi' = { range = "1 < \\phi" }
q = { positive = true }
r = { function_of = "t" }
t = { unit = "s" }
```
```toml notation
'p' = { covariance_of = 'r' }
```
```math s1 solve p
p = \phi^2 p + q
```
"#;
    let claims = lines(r"p = \frac{q}{1 - \phi^2}");
    let outcomes = found(head, &claims);
    assert!(
        outcomes[0].evaluated == 0 && outcomes[0].undefined == POINTS,
        "{:?}",
        outcomes[0]
    );
}

#[test]
fn hypotheses_are_obeyed() {
    let head = |assume: &str, claim: &str| {
        format!("{LETTERS}```math c0 claim\n{claim}\n```\n```toml c0\nassume = [{assume}]\n```\n")
    };
    let outcome = |assume: &str, claim: &str| {
        let model = model(&head(assume, claim));
        let world = World::new(&model, 0, BTreeMap::new());
        let equation = model.equation("c0").unwrap();
        let link = &model.equations[equation].links[0];
        challenge(
            &world,
            equation,
            link,
            &model.equations[equation].assume,
            &Budget::default(),
        )
    };
    for (assume, claim) in [
        ("'x > 3'", "x^2 > 9"),
        ("'0 < x < 1'", "x^2 < x"),
        ("'x > y', 'y > 0'", "x^2 > y^2"),
        ("'x < 0'", "|x| = -x"),
        ("'x \\ne 0'", "x^2 > 0"),
        ("'x \\le 2', 'x \\ge 2'", "x = 2"),
        ("'x + y > 5'", "x + y > 4"),
    ] {
        let found = outcome(assume, claim);
        assert!(
            found.apart.is_none() && found.evaluated > 0,
            "{assume}: {claim}: {found:?}"
        );
    }
    for (assume, claim) in [
        ("'x > 3'", "x > 5"),
        ("'a < 2'", "a = 2"),
        ("'x \\ne 0'", "x > 0"),
        ("'x > y'", "x^2 > y^2"),
        ("'0 < x < 1'", "x = \\frac12"),
    ] {
        let found = outcome(assume, claim);
        assert!(found.apart.is_some(), "{assume}: {claim}: {found:?}");
    }
    for assume in ["'a < 0'", "'x > 3', 'x < 2'", "'x^2 < 0'"] {
        let found = outcome(assume, "x = y");
        assert!(
            found.apart.is_none() && found.evaluated == 0,
            "{assume}: {found:?}"
        );
        assert!(found.no_point.is_some(), "{assume}: {found:?}");
    }
    let contradictory = outcome("'x > 3', 'x < 2'", "x = y");
    assert!(matches!(
        contradictory.no_point,
        Some(NoPoint::Contradictory(_))
    ));
}

#[test]
fn points_are_the_same_each_time() {
    let model = model(&document(LETTERS, &lines("x = y + z")));
    let world = World::new(&model, 0, BTreeMap::new());
    let shown = || {
        let mut points = Points::new(&world, []).unwrap();
        (0..12)
            .map(|_| {
                let point = points.next_point().unwrap();
                match world.compare(0, &model.equations[0].links[0], &point, 128, 1000) {
                    Comparison::Apart(shown) => {
                        assert!(shown.is_rational());
                        format!("{:?} {:?}", shown.point(&model, 20), shown.sides(20))
                    }
                    other => format!("{other:?}"),
                }
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(shown(), shown());
}

const TIED: &str = r#"```toml document
title = "t"
```
```toml symbols
a = { positive = true }
b = { positive = true }
c = { positive = true }
h = { positive = true }
s = { meaning = "sine" }
k = { meaning = "cosine" }
x = { meaning = "real" }
y = { meaning = "real" }
f = { range = "0 < f < 10" }
'\mu' = { range = "0 < \\mu < 1" }
t = { unit = "s" }
'\varphi' = { unit = "1" }
'\omega' = { unit = "1/s" }
r = { function_of = "t" }
v = { function_of = "t" }
'\mathbf{u}' = { shape = [2, 1], function_of = "t" }
'\mathbf{w}' = { shape = [2, 1], function_of = "t" }
'\mathbf{A}' = { shape = [2, 2] }
'\mathbf{P}' = { shape = [2, 2] }
```
```toml notation
'\mathbf{0}' = { zero = true }
```
```math d1 define
\mathbf{D} = \frac12(\mathbf{P} + \mathbf{P}^T)
```
"#;

/// What is true on the solutions of equations, false beside them, and the other way round.
#[test]
fn equations_are_solved() {
    let challenged = |assume: &[&str], claim: &str| {
        let list: Vec<String> = assume.iter().map(|a| format!("'{a}'")).collect();
        let text = format!(
            "{TIED}```math c0 claim\n{claim}\n```\n```toml c0\nassume = [{}]\n```\n",
            list.join(", ")
        );
        let model = model(&text);
        let world = World::new(&model, 0, BTreeMap::new());
        let equation = model.equation("c0").unwrap();
        let link = &model.equations[equation].links[0];
        let assume = &model.equations[equation].assume;
        challenge(&world, equation, link, assume, &Budget::default())
    };
    let cases: &[(&[&str], &str)] = &[
        (&[r"a = b"], r"\frac{a^2 - b^2}{a + b} = 0"),
        (&[r"a h = b c"], r"\frac{a}{b} = \frac{c}{h}"),
        (&[r"s^2 + k^2 = 1"], r"(s + k)^2 = 1 + 2sk"),
        (&[r"f(1 + \mu) = 1"], r"\frac{1}{f} = 1 + \mu"),
        (&[r"\cos x = y"], r"y^2 + \sin^2 x = 1"),
        (&[r"\cos x = y", r"x = 0"], r"y = 1"),
        (&[r"a^3 + a = 5"], r"a^4 = 5a - a^2"),
        (&[r"\exp x = a"], r"x = \ln a"),
        (&[r"a + b = 3", r"a - b = 1"], r"ab = 2"),
        (&[r"a = 2b", r"b = 2c"], r"a = 4c"),
        (&[r"x = a"], r"|x| = a"),
        (&[r"\ddot r = -r"], r"\dddot r = -\dot r"),
        (
            &[r"a\ddot r = -b r"],
            r"\frac{d}{dt}(a\dot r^2 + b r^2) = 0",
        ),
        (&[r"\dot r = v"], r"\ddot r = \dot v"),
        (&[r"r = a"], r"\dot r = 0"),
        (
            &[r"\mathbf{u} = \mathbf{A}\mathbf{w}"],
            r"\dot{\mathbf{u}} = \mathbf{A}\dot{\mathbf{w}}",
        ),
        (&[r"\mathbf{D} = \mathbf{0}"], r"\mathbf{P}^T = -\mathbf{P}"),
        (&[r"a = b", r"a > 3"], r"b > 3"),
    ];
    for (assume, claim) in cases {
        let found = challenged(assume, claim);
        assert!(
            found.apart.is_none(),
            "{assume:?}: {claim}: {:?}",
            found.apart
        );
        assert!(found.evaluated > 0, "{assume:?}: {claim}: {found:?}");
        let without = challenged(&[], claim);
        assert!(without.apart.is_some(), "without: {claim}: {without:?}");
    }
    let wrong: &[(&[&str], &str)] = &[
        (&[r"a = b"], r"a = 2b"),
        (&[r"a h = b c"], r"\frac{a}{b} = \frac{h}{c}"),
        (&[r"s^2 + k^2 = 1"], r"s + k = 1"),
        (&[r"\cos x = y"], r"y = \sin x"),
        (&[r"a^3 + a = 5"], r"a = \frac32"),
        (&[r"\exp x = a"], r"x = a - 1"),
        (&[r"\ddot r = -r"], r"\ddot r = r"),
        (&[r"\ddot r = -r"], r"\dddot r = \dot r"),
        (&[r"\mathbf{D} = \mathbf{0}"], r"\mathbf{P} = \mathbf{0}"),
        (&[r"a + b = 3"], r"ab = 2"),
    ];
    for (assume, claim) in wrong {
        let found = challenged(assume, claim);
        assert!(found.apart.is_some(), "{assume:?}: {claim}: {found:?}");
    }
    // Nothing is said about what an equation ties to the time or to a letter of a derivative.
    for (assume, claim) in [
        (&[r"\varphi = \omega t"], r"\dot\varphi = \omega"),
        (&[r"\varphi = \omega t"], r"\dot\varphi = 0"),
        (&[r"y = \cos x"], r"\frac{d}{dx} y = 0"),
        (&[r"a + b = 0"], r"a = 1"),
        (&[r"1 = 2"], r"a = 1"),
    ] {
        let found = challenged(assume, claim);
        assert!(
            found.apart.is_none() && found.evaluated == 0,
            "{assume:?}: {claim}: {found:?}"
        );
    }
}

const RANDOM: &str = r#"```toml document
title = "t"
```
```toml symbols
a = { positive = true }
b = { positive = true }
q = { positive = true }
t = { unit = "s" }
x = { function_of = "t" }
y = { function_of = "t" }
n = { function_of = "t" }
```
```toml notation
'\mathbf{0}' = { zero = true }
'P_{i,j}' = { entry_of = '\mathbf{P}' }
'\mathbf{P}' = { covariance_of = '\mathbf{z}' }
```
```math d1 define
\mathbf{z} = \begin{bmatrix} x \\ y \end{bmatrix}, \quad \mathbf{A} = \begin{bmatrix} -a & 1 \\ 0 & -b \end{bmatrix}, \quad \mathbf{B} = \begin{bmatrix} 0 \\ 1 \end{bmatrix}
```
```math s1 solve \mathbf{P}
\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T + q\mathbf{B}\mathbf{B}^T = \mathbf{0}
```
"#;

#[test]
fn expectations() {
    both(
        RANDOM,
        r"
        E\{x^2\} = P_{11}
        E\{xy\} = P_{12}
        E\{(x + a y)^2\} = P_{11} + 2a P_{12} + a^2 P_{22}
        E\{a\} = a
        E\{x + 3\} = 3
        E\{y^2\} = \frac{q}{2b}
        ",
    );
    all_true(RANDOM, &lines(r"E\{\mathbf{z}\mathbf{z}^T\} = \mathbf{P}"));
    let unknown = lines(
        r"
        E\{\cos x\} = \cos x
        E\{x \exp y\} = 0
        E\{n^2\} = 1
        E\{x^4\} = 3 P_{11}^2
        E\{x n\} = 0
        ",
    );
    for (claim, outcome) in unknown.iter().zip(found(RANDOM, &unknown)) {
        assert!(
            outcome.apart.is_none() && outcome.evaluated == 0,
            "{claim}: {outcome:?}"
        );
    }
}
