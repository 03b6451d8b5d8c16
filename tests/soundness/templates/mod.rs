//! The templates, one family a file.

mod definitions;
mod dynamics;
mod expectations;
mod functions;
mod hypotheses;
mod integrals;
mod limits;
mod matrices;
mod rational;
mod sizes;
mod statements;
mod sums;

use super::generator::Template;

/// All of them.
pub fn all() -> impl Iterator<Item = &'static Template> {
    [
        rational::TEMPLATES,
        definitions::TEMPLATES,
        functions::TEMPLATES,
        dynamics::TEMPLATES,
        expectations::TEMPLATES,
        hypotheses::TEMPLATES,
        integrals::TEMPLATES,
        limits::TEMPLATES,
        matrices::TEMPLATES,
        sizes::TEMPLATES,
        statements::TEMPLATES,
        sums::TEMPLATES,
    ]
    .into_iter()
    .flatten()
}
