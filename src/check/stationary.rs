//! Whether what is called a covariance belongs to a system that has a stationary state.

use super::Checker;
use crate::domain::Domain;
use crate::model::Node;
use crate::theory::stability::hurwitz_determinants;
use crate::verdict::CounterProof;
use num_traits::Signed;

impl Checker<'_> {
    /// What is called a covariance and solves a Lyapunov equation must belong to a stable system: at
    /// the reference point, or for all positive letters, its Hurwitz determinants say whether it does.
    pub(super) fn instability(&mut self, system: usize) -> Option<CounterProof> {
        let node = Node::Unknown {
            system,
            position: 0,
        };
        if !self.model.covariances().any(|(_, n, _)| n == node) {
            return None;
        }
        let matrix = self.exact.lyapunov_matrix(system)?;
        let minors = hurwitz_determinants(&self.exact.field, "A", matrix).ok()?;
        let all: Vec<usize> = self.inserted.keys().copied().collect();
        let definitions = self.insertion(&all).letters;
        let point = self.reference_point();
        for (k, minor) in minors.iter().enumerate() {
            let minor = minor.substitute(&definitions).ok()?;
            let letters = self.exact.field.letters(&minor);
            let known = letters.iter().all(|l| self.has_reference(*l));
            let (negative, value) = match minor.evaluate(&point) {
                Ok(value) if known => (!value.is_positive(), value.to_string()),
                _ => {
                    let constant_sign = !minor.is_zero() && self.is_negative(&minor);
                    (minor.is_zero() || constant_sign, minor.to_string())
                }
            };
            if negative {
                return Some(CounterProof::Unstable {
                    order: k + 1,
                    determinant: value,
                });
            }
        }
        None
    }
}
