//! Relations of order whose truth is known by construction: quadratic forms, polynomials on ranges
//! with and without their ends, integers, functions, matrices that are declared definite.

use crate::common::audit;
use rederive::check::Options;
use rederive::document::VerdictWord;

/// Claims with their truth, under one table of letters.
pub struct Family {
    name: String,
    head: String,
    claims: Vec<(String, bool)>,
}

impl Family {
    pub fn new(name: &str, head: &str) -> Self {
        Family {
            name: name.into(),
            head: head.into(),
            claims: Vec::new(),
        }
    }

    pub fn add(&mut self, claim: impl Into<String>, truth: bool) {
        self.claims.push((claim.into(), truth));
    }

    pub fn len(&self) -> usize {
        self.claims.len()
    }

    /// No claim may have the wrong definite verdict; what is returned are the shares decided of the
    /// true and of the false ones.
    pub fn check(&self) -> (f64, f64) {
        self.shares(self.count())
    }

    fn shares(&self, (decided, all): ([usize; 2], [usize; 2])) -> (f64, f64) {
        let share = |k: usize| decided[k] as f64 / all[k].max(1) as f64;
        println!(
            "{}: {} true, {:.0} % decided; {} false, {:.0} % decided",
            self.name,
            all[1],
            100.0 * share(1),
            all[0],
            100.0 * share(0)
        );
        (share(1), share(0))
    }

    /// The same as `decides`, with so many claims in one document: letters of functions are shared there.
    pub fn decides_in_parts(&self, of: usize, of_true: f64, of_false: f64) {
        let (mut decided, mut all) = ([0; 2], [0; 2]);
        for claims in self.claims.chunks(of) {
            let part = Family {
                name: self.name.clone(),
                head: self.head.clone(),
                claims: claims.to_vec(),
            };
            let (own, total) = part.count();
            for k in 0..2 {
                decided[k] += own[k];
                all[k] += total[k];
            }
        }
        let (t, f) = self.shares((decided, all));
        assert!(t >= of_true && f >= of_false, "{}: {t} {f}", self.name);
    }

    /// How many of the false and of the true claims are decided, and how many there are.
    fn count(&self) -> ([usize; 2], [usize; 2]) {
        let mut text = self.head.clone();
        for (k, (claim, _)) in self.claims.iter().enumerate() {
            text += &format!("\n```math {} claim\n{claim}\n```\n", k + 1);
        }
        let options = Options {
            repair: false,
            ..Options::default()
        };
        let audit = audit(&text, options).unwrap_or_else(|r| panic!("{}: {r}", self.name));
        let (mut wrong, mut open) = (Vec::new(), Vec::new());
        let (mut decided, mut all) = ([0_usize; 2], [0_usize; 2]);
        for (k, (claim, truth)) in self.claims.iter().enumerate() {
            let words = audit
                .outcomes
                .iter()
                .filter(|o| audit.model.equations[o.equation].label == (k + 1).to_string())
                .map(|o| o.verdict.word())
                .filter(|w| *w != VerdictWord::Definition);
            let words: Vec<VerdictWord> = words.collect();
            assert!(
                !words.is_empty(),
                "{}: nothing was checked of {claim}",
                self.name
            );
            all[usize::from(*truth)] += 1;
            let holds = words.iter().all(|w| *w == VerdictWord::Holds);
            let fails = words
                .iter()
                .any(|w| matches!(w, VerdictWord::Refuted | VerdictWord::Misprint));
            if holds && !truth || fails && *truth {
                wrong.push(format!("{claim} is {truth}, and said to be {words:?}"));
            }
            decided[usize::from(*truth)] += usize::from(holds || fails);
            if !holds && !fails {
                open.push(format!("open, {truth}: {claim}"));
            }
        }
        assert!(
            wrong.is_empty(),
            "{}: {} of {} are wrong:\n{}",
            self.name,
            wrong.len(),
            self.claims.len(),
            wrong.join("\n")
        );
        if std::env::var("SHOW_CLAIMS").is_ok() {
            println!("{}", open.join("\n"));
        }
        (decided, all)
    }

    /// The same, with at least these shares decided of the true and of the false claims.
    pub fn decides(&self, of_true: f64, of_false: f64) {
        let (t, f) = self.check();
        assert!(t >= of_true && f >= of_false, "{}: {t} {f}", self.name);
    }
}

/// A linear congruential generator (Knuth's MMIX constants).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// An integer from `low` to `high`.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let span = (high - low + 1) as u64;
        low + ((self.0 >> 33) % span) as i64
    }

    pub fn pick<'a, T>(&mut self, of: &'a [T]) -> &'a T {
        &of[self.between(0, of.len() as i64 - 1) as usize]
    }
}

pub const LETTERS: &str = r#"
```toml symbols
x = { unit = "1", meaning = "" }
y = { unit = "1", meaning = "" }
z = { unit = "1", meaning = "" }
a = { unit = "1", positive = true, meaning = "" }
b = { unit = "1", positive = true, meaning = "" }
c = { unit = "1", positive = true, meaning = "" }
u = { unit = "1", range = '0 \le u \le 2', meaning = "" }
v = { unit = "1", range = '-1 < v < 3', meaning = "" }
w = { unit = "1", range = '1 \le w', meaning = "" }
n = { unit = "1", domain = "integer", range = '0 < n', meaning = "" }
k = { unit = "1", domain = "integer", meaning = "" }
```
```toml notation
'e' = { constant = "e" }
'\pi' = { constant = "pi" }
```
"#;

/// `2x^2 - 3xy + y^2`
fn form(letters: [&str; 3], m: [[i64; 3]; 3]) -> String {
    let mut text = String::new();
    for i in 0..3 {
        for j in i..3 {
            let c = if i == j { m[i][i] } else { 2 * m[i][j] };
            if c != 0 {
                let sign = if c < 0 { "-" } else { "+" };
                text += &format!(" {sign} {}{}{}", c.abs(), letters[i], letters[j]);
            }
        }
    }
    text.trim_start_matches([' ', '+']).to_string()
}

/// Whether all (or all leading) principal minors are not negative (positive).
fn is_definite(m: [[i64; 3]; 3], strict: bool) -> bool {
    let minor = |kept: &[usize]| -> i64 {
        match kept {
            [i] => m[*i][*i],
            [i, j] => m[*i][*i] * m[*j][*j] - m[*i][*j] * m[*j][*i],
            _ => {
                m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
                    - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                    + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
            }
        }
    };
    if strict {
        return [&[0][..], &[0, 1], &[0, 1, 2]].iter().all(|k| minor(k) > 0);
    }
    let all = [&[0][..], &[1], &[2], &[0, 1], &[0, 2], &[1, 2], &[0, 1, 2]];
    all.iter().all(|k| minor(k) >= 0)
}

#[test]
fn quadratic_forms() {
    let mut random = Random::new(1);
    let head = format!(
        "{LETTERS}\n```toml symbols\nt = {{ unit = \"s\" }}\np = {{ unit = \"1\", function_of = \"t\" }}\n\
         q = {{ unit = \"1\", function_of = \"t\" }}\nr = {{ unit = \"1\", function_of = \"t\" }}\n```\n"
    );
    let mut family = Family::new("quadratic forms", &head);
    for _ in 0..110 {
        let mut m = [[0; 3]; 3];
        // Half of them are sums of squares of linear forms, and semidefinite.
        if random.between(0, 1) == 0 {
            for _ in 0..random.between(1, 3) {
                let l = [0; 3].map(|_: i64| random.between(-2, 2));
                for i in 0..3 {
                    for j in 0..3 {
                        m[i][j] += l[i] * l[j];
                    }
                }
            }
        } else {
            for i in 0..3 {
                for j in i..3 {
                    m[i][j] = random.between(-1, 2);
                    m[j][i] = m[i][j];
                }
            }
        }
        if m == [[0; 3]; 3] {
            continue;
        }
        let plain = form(["x", "y", "z"], m);
        family.add(format!(r"{plain} \ge 0"), is_definite(m, false));
        family.add(format!("{plain} + 1 > 0"), is_definite(m, false));
        family.add(format!("{plain} > 0"), false);
        let moving = form([r"\dot{p}", r"\dot{q}", r"\dot{r}"], m);
        family.add(format!(r"{moving} \ge 0"), is_definite(m, false));
        if m[0][0] != 0 && m[1][1] != 0 && m[2][2] != 0 {
            // Positive unless all rates vanish.
            family.add(format!("{moving} > 0"), is_definite(m, true));
        }
    }
    assert!(family.claims.len() >= 200);
    family.decides(0.6, 0.9);
}

#[test]
fn polynomials_on_ranges() {
    let mut random = Random::new(2);
    let mut family = Family::new("polynomials on ranges", LETTERS);
    // Letter, ends in halves (none: infinite), and whether they belong to it.
    type Ends = (&'static str, Option<(i64, bool)>, Option<(i64, bool)>);
    let letters: [Ends; 5] = [
        ("x", None, None),
        ("a", Some((0, false)), None),
        ("u", Some((0, true)), Some((4, true))),
        ("v", Some((-2, false)), Some((6, false))),
        ("w", Some((2, true)), None),
    ];
    for _ in 0..240 {
        let (letter, low, high) = *random.pick(&letters);
        let roots: Vec<i64> = (0..random.between(1, 3))
            .map(|_| random.between(-3, 7))
            .collect();
        let sign = *random.pick(&[1, -1]);
        let factors: Vec<String> = roots
            .iter()
            .map(|r| format!("(2{letter} - ({r}))"))
            .collect();
        let f = format!("{}{}", if sign < 0 { "-" } else { "" }, factors.concat());
        let value = |halves: f64| {
            let product: f64 = roots.iter().map(|r| halves - *r as f64).product();
            product * f64::from(sign)
        };
        let inside = |h: f64| {
            low.is_none_or(|(l, closed)| h > l as f64 || closed && h == l as f64)
                && high.is_none_or(|(l, closed)| h < l as f64 || closed && h == l as f64)
        };
        // Roots, ends and a point between any two neighbours.
        let mut points: Vec<f64> = (-40..=80).map(|q| f64::from(q) / 4.0).collect();
        points.retain(|h| inside(*h));
        let all = |test: fn(f64) -> bool| points.iter().all(|h| test(value(*h)));
        let (relation, truth) = match random.between(0, 3) {
            0 => (">", all(|v| v > 0.0)),
            1 => (r"\ge", all(|v| v >= 0.0)),
            2 => ("<", all(|v| v < 0.0)),
            _ => (r"\le", all(|v| v <= 0.0)),
        };
        if random.between(0, 3) == 0 {
            // Over a denominator that has no zero.
            family.add(
                format!(r"\frac{{{f}}}{{{letter}^2 + 1}} {relation} 0"),
                truth,
            );
        } else {
            family.add(format!("{f} {relation} 0"), truth);
        }
    }
    for (claim, truth) in [
        ("u + 1 > 0", true),
        (r"u \ge 0", true),
        ("u > 0", false),
        ("u < 2", false),
        (r"u \le 2", true),
        (r"u(2 - u) \ge 0", true),
        ("v > -1", true),
        (r"v \ge -1", true),
        ("v^2 < 9", true),
        ("v^2 < 8", false),
        ("w > 1", false),
        (r"w^2 \ge w", true),
        ("w^2 > w", false),
        ("uv > -2", true),
        (r"uv \ge -2", true),
        ("uv > -3", true),
        ("uw < 0", false),
        ("a + w > 1", true),
        ("a + u > 0", true),
        ("u + v > -1", true),
        ("u + v < 5", true),
        (r"u - v \ge 0", false),
        (r"n \ge 1", true),
        ("n > 1", false),
        (r"n^2 \ge n", true),
        ("n > 0", true),
        (r"k \ge 0", false),
        (r"k^2 \ge 0", true),
        (r"a \neq 0", true),
        (r"x \neq 0", false),
        (r"x^2 \neq -1", true),
        (r"a \neq b", false),
        (r"a + b \neq 0", true),
        (r"u \neq 3", true),
        (r"u \neq 2", false),
        (r"x - x > 0", false),
        (r"x - x \ge 0", true),
        (r"\frac{1}{x^2} > 0", true),
        (r"\frac{1}{x} > 0", false),
        (r"\frac{x^2}{x^2 + y^2} \ge 0", true),
        (r"\frac{x}{x - y} > 0", false),
    ] {
        family.add(claim, truth);
    }
    family.decides(0.9, 0.95);
}

#[test]
fn functions() {
    let mut family = Family::new("signs with functions", LETTERS);
    for c in ["-2", "-1", "-1/2", "0", "1/2", "1", "3/2", "2"] {
        let number = |text: &str| match text.split_once('/') {
            Some((n, d)) => n.parse::<f64>().unwrap() / d.parse::<f64>().unwrap(),
            None => text.parse::<f64>().unwrap(),
        };
        let value = number(c);
        let c = format!("({c})");
        for f in [r"\cos x", r"\sin y", r"\cos(a + x)"] {
            family.add(format!("{f} < {c}"), value > 1.0);
            family.add(format!(r"{f} \le {c}"), value >= 1.0);
            family.add(format!("{f} > {c}"), value < -1.0);
            family.add(format!(r"{f} \ge {c}"), value <= -1.0);
        }
        family.add(format!("e^a > {c}"), value <= 1.0);
        family.add(format!("e^x > {c}"), value <= 0.0);
        family.add(format!(r"e^{{-a}} < {c}"), value >= 1.0);
        family.add(format!(r"e^u \ge {c}"), value <= 1.0);
        family.add(format!(r"\sqrt a > {c}"), value <= 0.0);
        family.add(format!(r"\sqrt{{x^2 + 1}} \ge {c}"), value <= 1.0);
        family.add(format!(r"a + b \ge {c}\sqrt{{ab}}"), value <= 2.0);
        family.add(format!(r"a + b > {c}\sqrt{{ab}}"), value < 2.0);
        family.add(format!(r"\sqrt{{a + 4}} > \sqrt a + {c}"), value <= 0.0);
        family.add(format!(r"\ln a < {c}"), false);
        family.add(format!(r"\pi > 1 + {c}"), true);
        family.add(format!(r"2\pi < 6 + {c}"), value > 0.29);
        family.add(format!(r"\sqrt 2 > {c}"), value < 1.41);
        family.add(format!(r"a + \cos x > {c}"), value <= -1.0);
        family.add(format!(r"e^a + \sin y \ge {c}"), value <= 0.0);
    }
    for (claim, truth) in [
        (r"\sqrt{a+8} > \sqrt a", true),
        (r"\sqrt{a+8} < \sqrt a", false),
        (r"\cos x \neq 2", true),
        (r"\cos x \neq 1", false),
        (r"e^x \neq 0", true),
        (r"|x| \ge 0", true),
        (r"|x| > 0", false),
        (r"|x| \ge x", true),
        (r"|x| < 3", false),
    ] {
        family.add(claim, truth);
    }
    assert!(family.claims.len() >= 200);
    family.decides(0.4, 0.8);
}

#[test]
fn definite_matrices() {
    let head = |n: usize| {
        format!(
            "{LETTERS}\n```toml symbols\n\
             '\\mathbf{{M}}' = {{ shape = [{n}, {n}], symmetric = true, positive_definite = true }}\n\
             '\\mathbf{{K}}' = {{ shape = [{n}, {n}], symmetric = true, positive_definite = true }}\n\
             '\\mathbf{{S}}' = {{ shape = [{n}, {n}], symmetric = true }}\n\
             '\\mathbf{{F}}' = {{ shape = [{n}, {n}] }}\n\
             '\\mathbf{{f}}' = {{ shape = [{n}, 1] }}\n```\n```toml notation\n\
             '\\mathbf{{E}}' = {{ identity = {n} }}\n'\\mathbf{{0}}' = {{ zero = true }}\n\
             'M_{{i,j}}' = {{ entry_of = '\\mathbf{{M}}' }}\n'K_{{i,j}}' = {{ entry_of = '\\mathbf{{K}}' }}\n\
             'S_{{i,j}}' = {{ entry_of = '\\mathbf{{S}}' }}\n```\n"
        )
    };
    for n in [2, 3] {
        let mut family = Family::new("definite matrices", &head(n));
        let mut random = Random::new(n as u64);
        for _ in 0..if n == 2 { 60 } else { 40 } {
            let [m, k, e] = [0; 3].map(|_: i64| random.between(-1, 3));
            let matrix = format!(r"({m})\mathbf M + ({k})a\mathbf K + ({e})\mathbf E");
            let (least, most) = (m.min(k).min(e), m.max(k).max(e));
            family.add(format!(r"{matrix} > \mathbf 0"), least >= 0 && most > 0);
            family.add(format!(r"{matrix} \ge \mathbf 0"), least >= 0);
            family.add(format!(r"\mathbf 0 < {matrix}"), least >= 0 && most > 0);
        }
        for c in -3..=3 {
            family.add(
                format!("M_{{11}} + ({c})M_{{12}} + M_{{22}} > 0"),
                i64::abs(c) <= 2,
            );
            family.add(
                format!(r"M_{{11}} + ({c})M_{{12}} + M_{{22}} \ge 0"),
                i64::abs(c) <= 2,
            );
            family.add(format!("M_{{11}} + ({c})K_{{11}} > 0"), c >= 0);
            family.add(format!(r"M_{{11}} \neq {c}"), c <= 0);
            family.add(format!("M_{{11}}M_{{22}} + ({c})M_{{12}}^2 > 0"), c >= -1);
            family.add(format!(r"\det\mathbf M + ({c})\det\mathbf K > 0"), c >= 0);
            family.add(format!("S_{{11}}^2 + ({c}) > 0"), c > 0);
        }
        for (claim, truth) in [
            (r"\mathbf M > 0", true),
            (r"\mathbf M \ge 0", true),
            (r"\mathbf S > 0", false),
            (r"\mathbf S \ge 0", false),
            (r"\mathbf S^2 \ge 0", true),
            (r"\mathbf S^2 > 0", false),
            (r"\mathbf M^{-1} > 0", true),
            (r"\mathbf M^{-1} + \mathbf K^{-1} > 0", true),
            (r"\mathbf M^2 > 0", true),
            (r"\mathbf M\mathbf K\mathbf M > 0", true),
            (r"\mathbf F^T\mathbf M\mathbf F \ge 0", true),
            (r"\mathbf F^T\mathbf M\mathbf F > 0", false),
            (r"\mathbf F\mathbf F^T + \mathbf E > 0", true),
            (r"\mathbf f^T\mathbf M\mathbf f \ge 0", true),
            (r"\mathbf f\mathbf f^T \ge 0", true),
            (r"\mathbf f^T\mathbf M\mathbf f + 1 > 0", true),
            (r"\mathbf f^T\mathbf M\mathbf f > 0", false),
            (r"\mathbf M > \mathbf K", false),
            (r"\mathbf M + \mathbf K > \mathbf K", true),
            (r"\mathbf M > -\mathbf K", true),
            (r"-\mathbf M < 0", true),
            (r"-\mathbf M > 0", false),
            (r"\mathbf M < 0", false),
            (r"\mathbf M - \mathbf E > 0", false),
            (r"\det\mathbf M > 0", true),
            (r"\det(\mathbf M + \mathbf K) > 0", true),
            (r"\det(\mathbf M - \mathbf K) > 0", false),
            (r"\det\mathbf M > 1", false),
            (r"\det\mathbf S > 0", false),
            (r"\operatorname{tr}\mathbf M > 0", true),
            (r"\operatorname{tr}(\mathbf M\mathbf K) > 0", true),
            (r"M_{11} > 0", true),
            (r"M_{22} > 0", true),
            (r"M_{12} > 0", false),
            (r"M_{11} + M_{12} > 0", false),
            (r"S_{11} > 0", false),
            (r"a\mathbf M > 0", true),
            (r"x\mathbf M > 0", false),
            (r"x^2\mathbf M \ge 0", true),
            (r"x^2\mathbf M > 0", false),
        ] {
            family.add(claim, truth);
        }
        assert!(family.claims.len() >= 200);
        family.decides(0.85, 0.9);
    }
}
