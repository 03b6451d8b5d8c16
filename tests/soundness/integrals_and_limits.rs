//! Limits of what has an argument at the goal, and integrals that diverge, beside the similar ones that do not:
//! difference quotients, divergent integrals inside of other things, removable poles under a cosine,
//! coefficients of what diverges that may vanish, and spectra that do not decay where distributions are declared.

use super::signs::{Family, LETTERS, Random};

/// A function of q with its derivative.
const FUNCTIONS: &[(&str, &str, &str)] = &[
    ("F", "q^2 + q + 1", "2q + 1"),
    ("G", r"\frac{1}{q + 3}", r"-\frac{1}{(q + 3)^2}"),
    ("H", "e^{2q}", "2e^{2q}"),
    ("L", "q^3 - 2q", "3q^2 - 2"),
    ("C", r"\cos q", r"-\sin q"),
    ("Q", "aq^2 + bq", "2aq + b"),
];

fn with_functions() -> String {
    let mut head = LETTERS.replace("y = {", "q = { }\nt = { }\ny = {");
    for (k, (name, body, _)) in FUNCTIONS.iter().enumerate() {
        head += &format!("```math f{k} define\n{name}(q) = {body}\n```\n");
    }
    head + "```math fk define\nK(q, t) = q + t^2\n```\n\
            ```math fp define\nP(q) = \\frac{1}{q^2}\n```\n\
            ```math fr define\nR(q) = \\frac{q + a}{q}\n```\n\
            ```math fs define\ns(q) = \\begin{cases} 1 & q \\ge 0 \\\\ 2 & q < 0 \\end{cases}\n```\n"
}

/// The increment of a function over that of its argument is the derivative, whatever the goal is called.
#[test]
fn difference_quotients() {
    let mut random = Random::new(91);
    let mut family = Family::new("difference quotients", &with_functions());
    for (name, body, derivative) in FUNCTIONS {
        for goal in ["0", "1", "2", "y", "a", "-1", "b"] {
            if *name == "G" && goal == "y" {
                continue;
            }
            let at = |f: &str| format!("({})", f.replace('q', &format!("({goal})")));
            let (value, slope) = (at(body), at(derivative));
            let step = match goal {
                "0" => "x".to_owned(),
                "-1" => "(x + 1)".to_owned(),
                _ => format!("(x - {goal})"),
            };
            let flat = *name == "C" && goal == "0";
            let forms = [
                (
                    format!(r"\frac{{{name}(x) - {name}({goal})}}{{{step}}}"),
                    slope.clone(),
                    false,
                ),
                (
                    format!(r"\frac{{{name}({goal}) - {name}(x)}}{{2{step}}}"),
                    format!(r"-\frac{{1}}{{2}}{slope}"),
                    false,
                ),
                (
                    format!(r"\frac{{{name}({goal}) - {value}}}{{{step}}}"),
                    "0".to_owned(),
                    true,
                ),
                (
                    format!(r"{name}(x) - {name}({goal}) + {step}"),
                    "0".to_owned(),
                    true,
                ),
                (
                    format!(r"\frac{{{name}(x)^2 - {name}({goal})^2}}{{{step}}}"),
                    format!("2{value}{slope}"),
                    false,
                ),
                (
                    format!(r"\frac{{{name}(x) - {name}({goal}) - {step}{slope}}}{{{step}}}"),
                    "0".to_owned(),
                    true,
                ),
            ];
            let (form, limit, zero) = random.pick(&forms).clone();
            family.add(format!(r"x \to {goal}, \quad {form} \to {limit}"), true);
            family.add(
                format!(r"x \to {goal}, \quad {form} \to {limit} + 1"),
                false,
            );
            // Zero is what the argument at the goal would give if it moved.
            let (form, limit, _) = forms[0].clone();
            family.add(format!(r"x \to {goal}, \quad {form} \to {limit}"), true);
            let vanishing = ["Q", "F", "L"].contains(name) && ["y", "a", "b"].contains(&goal);
            if !flat && !vanishing {
                family.add(format!(r"x \to {goal}, \quad {form} \to 0"), false);
            }
            if !flat && zero {
                let form = &forms[2].0;
                family.add(format!(r"x \to {goal}, \quad {form} \to {slope}"), false);
            }
        }
    }
    for (claim, truth) in [
        (r"x \to 0, \quad \frac{K(x, 0) - x}{x^2} \to 0", true),
        (r"x \to 0, \quad \frac{K(x, 0) - x}{x^2} \to 1", false),
        (r"x \to 0, \quad \frac{K(0, x)}{x^2} \to 1", true),
        (r"x \to 0, \quad \frac{K(0, 0) - x}{x} \to -1", true),
        (r"x \to 1, \quad \frac{F(2 - x) - F(1)}{x - 1} \to -3", true),
        (
            r"x \to 1, \quad \frac{F(2 - x) - F(1)}{x - 1} \to -6",
            false,
        ),
        (
            r"x \to 0, \quad \frac{F(x) - F(0) - xF'(0)}{x^2} \to 1",
            true,
        ),
        (
            r"x \to 0, \quad \frac{F(x) - F(0) - xF'(0)}{x^2} \to 0",
            false,
        ),
        (r"x \to t, \quad \int_0^1 F(t)\,dt \to \frac{11}{6}", true),
        (r"x \to t, \quad \int_0^1 F(t)\,dt \to t^2 + t + 1", false),
        (r"x \to k, \quad \sum_{k=0}^2 F(k) \to 11", true),
        (r"x \to k, \quad \sum_{k=0}^2 F(k) \to 3F(k)", false),
        (r"x \to 0, \quad F(0) \to 1", true),
        (r"x \to 0, \quad F(0) \to 2", false),
        (r"x \to y, \quad F(y) \to F(y)", true),
        (r"x \to y, \quad F(y) \to F(y) + 1", false),
        (r"x \to y, \quad F(y) \to F(x) + 1", false),
        (r"x \to \infty, \quad F(0) \to 1", true),
        (r"x \to \infty, \quad F(0) \to 3", false),
        (r"x \to \infty, \quad F(0) + G(0) \to \frac{4}{3}", true),
        // Where the argument is the goal and there is no value, the limit there is meant.
        (r"x \to 0, \quad P(0) \to \infty", true),
        (r"x \to 0, \quad P(0) \to -\infty", false),
        (r"x \to 0, \quad P(0) \to 0", false),
        (r"x \to 0, \quad 1 - 2P(0) \to -\infty", true),
        (r"x \to 0, \quad 1 - 2P(0) \to \infty", false),
        // A step: its value, or from both sides.
        (r"x \to 0, \quad s(0) \to 1", true),
        (r"x \to 0, \quad s(0) \to 2", false),
        (r"x \to 0, \quad s(0) \to 3", false),
        (r"x \to 0, \quad \frac{s(0) - 1}{x} \to 0", true),
        (r"x \to 0, \quad s(x) - s(0) \to 0", false),
    ] {
        family.add(claim, truth);
    }
    assert!(family.len() >= 150);
    family.decides(0.9, 0.9);
}
