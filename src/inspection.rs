//! A document's verdicts together with what the floating-point route says of them.

use crate::audit::Audit;
use crate::comparison::{Comparison, Subject};
use crate::progress::{Unwatched, Watch};

/// Both routes on one document.
#[derive(Clone, Debug)]
pub struct Inspection {
    /// The exact route.
    pub audit: Audit,
    /// The floating-point route, where the document has a numeric table.
    pub comparison: Option<Comparison>,
}

impl Inspection {
    /// Runs the floating-point route at the document's points.
    pub fn of(audit: Audit) -> Self {
        Inspection::watched(audit, &Unwatched)
    }

    /// The same under a watch.
    pub fn watched(audit: Audit, watch: &(dyn Watch + Sync)) -> Self {
        let comparison = Comparison::watched(&audit, watch);
        Inspection { audit, comparison }
    }

    /// The fewest digits that the best method keeps on a quantity of the numeric table, and the
    /// point where.
    pub fn fewest_digits(&self, named: bool) -> Option<(f64, usize)> {
        let comparison = self.comparison.as_ref()?;
        let wanted = |subject: usize| matches!(comparison.subjects[subject], Subject::Quantity(_));
        comparison
            .rows
            .iter()
            .filter(|row| wanted(row.subject) && comparison.points[row.point].named == named)
            .map(|row| {
                let digits = row.computed.iter().filter_map(|c| c.digits);
                (digits.max_by(f64::total_cmp).unwrap_or(0.0), row.point)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
    }

    /// The name of a subject: a quantity in LaTeX, or the number of a link.
    pub fn subject(&self, subject: &Subject) -> String {
        match subject {
            Subject::Quantity(name) => name.clone(),
            Subject::Link { equation, member } => {
                let equation = &self.audit.model.equations[*equation];
                format!("({})", equation.number_of(*member))
            }
        }
    }
}
