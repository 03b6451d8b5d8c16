//! The closure of the single edits: what one edit spoils, one edit mends.
//!
//! If E is a single edit that turns an equation A into B, then A is among the single edits of B as
//! it is read from print. Were it not, the search for corrections could never propose the original.
//! Nothing is checked here: the law is about the lists alone.

use rederive::check::edit::form::same_reading;
use rederive::check::edit::{Context, Replacement, singles, sites};
use rederive::document::Document;
use rederive::expr::walk::children;
use rederive::expr::{Display, Expr, ExprKind};
use rederive::latex::{self, Signature};
use rederive::model::Model;
use rederive::model::links::{Link, Place};
use rederive::verdict::EditClass;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

const SCALARS: &str = r#"
```toml symbols
a = { unit = "m", positive = true, meaning = "a length" }
b = { unit = "m", positive = true, meaning = "a length" }
c = { unit = "m", positive = true, meaning = "a length" }
d = { unit = "m", positive = true, meaning = "a length" }
m = { unit = "kg", positive = true, meaning = "a mass" }
'x_1' = { unit = "m", meaning = "a place" }
'x_2' = { unit = "m", meaning = "a place" }
```
```toml notation
'\pi' = { constant = "pi" }
e = { constant = "e", meaning = "the base of logarithms" }
```
```math quotients claim
\frac{1}{a} = \frac{1}{b} + \frac{2}{c}
```
```math powers claim
(a - b)(c + d)^2 = a^3 - 12b^2c
```
```math slash claim
a/(b + c) = m d/b - a^{-2}
```
```math places claim
x_1^2 + x_2^2 = 2ab - 0.25c^2
```
```math root claim
a = 2\pi\sqrt{\frac{m}{b}} + \sqrt{c^2 - d^2}
```
```math functions claim
c\cos(a + b) = \sin a \cos b - e^{-2d}
```
```math half claim
-\frac{1}{2}m(a - b) = \frac{a}{b}(c - d - m)
```
```math nested claim
a = \frac{b + c}{d - \frac{m}{a + b}}
```
"#;

const MATRICES: &str = r#"
```toml symbols
'\mathbf{A}' = { shape = [2, 2], meaning = "a matrix" }
'\mathbf{P}' = { shape = [2, 2], symmetric = true, meaning = "another" }
'\mathbf{v}' = { shape = [2, 1], meaning = "a vector" }
a = { meaning = "a number" }
b = { meaning = "a number" }
```
```toml notation
'\mathbf{0}' = { zero = true, meaning = "zero" }
'\mathbf{E}' = { identity = 2, meaning = "the unit matrix" }
```
```math Lyapunov claim
\mathbf{A}\mathbf{P} + \mathbf{P}\mathbf{A}^T + 2a\mathbf{v}\mathbf{v}^T = \mathbf{0}
```
```math entries claim
\mathbf{A} = \begin{bmatrix} 0 & 1 \\ -\frac{a}{b} & -2b \end{bmatrix}
```
```math resolvent claim
(a\mathbf{E} - \mathbf{A})^{-1}\mathbf{v} = \mathbf{v}^T\mathbf{P} - b\mathbf{A}^2
```
"#;

const SUMS: &str = r#"
```toml symbols
'\mathbf{P}' = { shape = [3, 3], meaning = "a matrix" }
'\mathbf{Q}' = { shape = [3, 3], meaning = "another" }
a = { meaning = "a number" }
n = { meaning = "an order" }
```
```toml notation
'P_{i,j}' = { entry_of = '\mathbf{P}' }
'Q_{i,j}' = { entry_of = '\mathbf{Q}' }
```
```math trace claim
a = \sum_{k=1}^{3} P_{k,k}
```
```math product claim
P_{1,2} = \sum_{i=1}^{3} 2P_{1,i}Q_{i+1,2} - a^2
```
"#;

const PROCESSES: &str = r#"
```toml symbols
t = { unit = "s", meaning = "time" }
m = { unit = "kg", positive = true, meaning = "mass" }
k = { unit = "N/m", positive = true, meaning = "stiffness" }
x = { unit = "m", function_of = "t", meaning = "a displacement" }
y = { unit = "m", function_of = "t", meaning = "a displacement" }
T = { unit = "s", positive = true, meaning = "a period" }
w = { unit = "1/s", positive = true, meaning = "a frequency" }
```
```math motion claim
m\ddot{x}(t) + 2k(x(t) - y(t)) = k\dot{y}(t)
```
```math measure claim
w = \int_0^T w^2 t \cos(wt) dt
```
"#;

/// How many edits of each class are tried for each equation.
const EACH: usize = 14;

fn model(text: &str) -> Model {
    let document = Document::parse("edits.md", text).expect("a document");
    Model::build(&document).expect("a model")
}

fn signature(model: &Model) -> Signature {
    let mut signature = Signature::default();
    for symbol in &model.symbols {
        match &symbol.function_of {
            Some(argument) => {
                signature.declare_function(&symbol.name, std::slice::from_ref(argument));
            }
            None => signature.declare(&symbol.name),
        }
    }
    for matrix in &model.matrices {
        signature.declare(&matrix.name);
    }
    for notation in &model.notation {
        signature.declare(&notation.name);
    }
    signature
}

fn applied(display: &Display, edit: &Replacement) -> Display {
    let mut edited = display.clone();
    assert!(edit.apply(&mut edited));
    edited
}

/// At most `EACH` edits of each class, from all over the list.
fn sample(edits: &[Replacement]) -> Vec<&Replacement> {
    let mut by_class: BTreeMap<EditClass, Vec<&Replacement>> = BTreeMap::new();
    for edit in edits {
        by_class.entry(edit.class).or_default().push(edit);
    }
    let spread = |class: Vec<&'_ Replacement>| -> Vec<_> {
        let step = class.len().div_ceil(EACH);
        class.into_iter().step_by(step).cloned().collect()
    };
    let chosen: BTreeSet<_> = by_class
        .into_values()
        .flat_map(spread)
        .map(|e| (e.address, format!("{:?}", e.change)))
        .collect();
    let is = |e: &&Replacement| chosen.contains(&(e.address.clone(), format!("{:?}", e.change)));
    edits.iter().filter(is).collect()
}

/// Whether a single edit of the damaged display gives the original.
fn leads_back(original: &Display, damaged: &Display, link: &Link, context: &Context) -> bool {
    let written = latex::write_display(original);
    let back = singles(damaged, &[link.left, link.right], context);
    let mended: Vec<Display> = back.iter().map(|edit| applied(damaged, edit)).collect();
    mended.iter().any(|m| latex::write_display(m) == written)
        || mended.iter().any(|m| same_reading(m, original, link))
}

/// Whether the edit took something away that stands nowhere else in print. What is lost so cannot be
/// in a list that knows only what is printed: the search solves for it instead.
fn loses(edit: &Replacement, original: &Display, damaged: &Display, context: &Context) -> bool {
    let old = edit.address.find(original).expect("what is edited");
    let new = edit.change.result(old).expect("what it is changed to");
    let new = Expr::new(new, old.span);
    let after: Vec<String> = children(&new).into_iter().map(latex::write_expr).collect();
    let gone = match edit.class {
        EditClass::Letter => vec![old],
        EditClass::Term | EditClass::Exponent => children(old),
        _ => Vec::new(),
    };
    let printed = |piece: &Expr| {
        let text = latex::write_expr(piece);
        let places = [edit.address.place, original_other(edit, original)];
        after.contains(&text)
            || places.iter().any(|place| {
                let mut all = sites(damaged, *place).into_iter();
                all.any(|site| latex::write_expr(site.expr) == text)
            })
    };
    let known = |piece: &Expr| match &piece.kind {
        ExprKind::Name(name) | ExprKind::Apply { function: name, .. } => {
            context.letters.iter().any(|k| k.name == *name)
        }
        ExprKind::Number(_) => edit.class == EditClass::Exponent,
        _ => false,
    };
    let letter = edit.class != EditClass::Term;
    gone.into_iter()
        .any(|piece| !(printed(piece) || letter && known(piece)))
}

/// The other side of an equation of two members.
fn original_other(edit: &Replacement, original: &Display) -> Place {
    let Place::Member { clause, member } = edit.address.place else {
        return edit.address.place;
    };
    assert_eq!(original.clauses[clause].chain.members.len(), 2);
    Place::Member {
        clause,
        member: 1 - member,
    }
}

#[test]
fn what_one_edit_spoils_one_edit_mends() {
    let mut figures: BTreeMap<EditClass, (usize, usize)> = BTreeMap::new();
    let (mut gone, mut lost) = (0, String::new());
    for text in [SCALARS, MATRICES, SUMS, PROCESSES] {
        let model = model(text);
        let (signature, context) = (signature(&model), Context::of(&model));
        for equation in &model.equations {
            let (original, link) = (&equation.display, &equation.links[0]);
            let edits = singles(original, &[link.left, link.right], &context);
            for edit in sample(&edits) {
                let damaged = applied(original, edit);
                let printed = latex::write_display(&damaged);
                // As it is read from print, where that can be read.
                let read = latex::parse_display(&printed, 0, &signature);
                let damaged = read.unwrap_or(damaged);
                let same = printed == latex::write_display(original)
                    || same_reading(&damaged, original, link);
                if same {
                    continue;
                }
                let (mended, all) = figures.entry(edit.class).or_default();
                *all += 1;
                if leads_back(original, &damaged, link, &context) {
                    *mended += 1;
                } else if loses(edit, original, &damaged, &context) {
                    *all -= 1;
                    gone += 1;
                } else {
                    let class = edit.class.as_str();
                    writeln!(lost, "{class}: {} from {}", printed.trim(), equation.label)
                        .expect("text");
                }
            }
        }
    }
    let tried: usize = figures.values().map(|(_, all)| all).sum();
    println!("{figures:?}, beyond print {gone}\n{lost}");
    assert!(figures.len() >= 11, "{figures:?}");
    assert!(tried > 900 && 20 * gone < tried, "{tried} and {gone}");
    let closed = figures.values().all(|(mended, all)| mended == all);
    assert!(closed, "{figures:?}\n{lost}");
}
