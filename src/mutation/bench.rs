//! Where one mutant is put to the test: the checkers of all instances, and the fate that they decide.

use super::dependence::{Dependences, Dependents, LinkAt, values_of};
use super::mutants::Mutant;
use super::{Case, Class, Decide, Equivalence, Fate};
use crate::check::trial::{Finding, Nonsense};
use crate::check::{Checker, Options};
use crate::diagnostic::Rejection;
use crate::document::Document;
use crate::evaluate::Value;
use crate::expr::{Display, Relation};
use crate::latex;
use crate::model::links::Link;
use crate::model::{DefinitionKind, Model, Node};
use ratpoly::RationalFunction;
use std::collections::BTreeSet;

/// Why a definition may be undecided.
pub(super) const UNTOLD: &str = "no claim tells it apart";

/// Why a rewriting may be undecided.
pub(super) const LOST: &str = "nothing is left to check";

/// At how many points an inequality that is true after an edit too is evaluated.
const POINTS: u32 = 32;

/// What every bench needs to know of the document.
pub(super) struct Plan<'p> {
    /// The document with its misprints corrected.
    pub document: &'p Document,
    /// The links that are true claims.
    pub claims: &'p [LinkAt],
    /// What depends on what.
    pub dependences: &'p Dependences,
    /// Who decides.
    pub decide: &'p dyn Decide,
}

/// The checkers of a document, warm: what the undamaged document needs is computed.
pub(super) struct Bench<'m, 'p> {
    pub plan: &'p Plan<'p>,
    pub model: &'m Model,
    pub checkers: Vec<Checker<'m>>,
    /// How many letters for functions the undamaged document uses.
    pub letters: usize,
    /// The values of the original that the last mutant changed: instance, equation and what.
    before: Option<((usize, usize, Changed), Option<Values>)>,
}

/// Values of sides and definitions.
type Values = Vec<Value<RationalFunction>>;

/// What a mutant changes.
#[derive(Clone, PartialEq)]
pub(super) struct Changed {
    /// Claims with a changed side.
    pub claims: Vec<LinkAt>,
    /// Nodes with a changed value, each with a link that gives it.
    pub nodes: Vec<(Node, usize)>,
}

/// The checkers of all instances of a model.
pub(super) fn checkers(
    model: &Model,
) -> Result<Vec<Checker<'_>>, Vec<crate::diagnostic::Diagnostic>> {
    let options = Options {
        repair: false,
        ..Options::default()
    };
    (0..model.instances.len())
        .map(|instance| Checker::in_instance(model, options, instance))
        .collect()
}

impl<'m, 'p> Bench<'m, 'p> {
    /// A bench whose checkers have computed what the undamaged document needs.
    pub fn new(plan: &'p Plan<'p>, model: &'m Model) -> Result<Self, Rejection> {
        let mut checkers = checkers(model).map_err(|d| plan.document.reject(d))?;
        super::base::standings(model, &mut checkers);
        let letters = model.functions.as_ref().map_or(0, |t| t.given_out());
        Ok(Bench {
            plan,
            model,
            checkers,
            letters,
            before: None,
        })
    }

    /// What becomes of a mutant.
    pub fn fate(&mut self, mutant: &Mutant) -> Fate {
        let original = &self.model.equations[mutant.at.0].display;
        if latex::write_display(original) == latex::write_display(&mutant.display) {
            return Fate::Equivalent(Equivalence::PrintsTheSame);
        }
        if mutant.structural {
            return self.fate_read_anew(mutant);
        }
        let changed = self.changed(mutant.at.0, &mutant.display);
        let nodes: BTreeSet<Node> = changed.nodes.iter().map(|(node, _)| *node).collect();
        // What a document is refused for, before anything is computed.
        let names = self.model.check_names_of(mutant.at.0, &mutant.display);
        if let Some(diagnostic) = names.first() {
            return Fate::Meaningless {
                why: Nonsense::of_diagnostic(&diagnostic.kind),
                by: None,
            };
        }
        if self
            .model
            .would_need_itself(mutant.at.0, &mutant.display, &nodes)
        {
            return Fate::Meaningless {
                why: Nonsense::Circular,
                by: None,
            };
        }
        let dependents = self.plan.dependences.dependents(&nodes);
        let mut fate = None;
        for instance in 0..self.checkers.len() {
            let found = self.fate_in(instance, mutant, &changed, &dependents);
            fate = Some(match fate {
                None => found,
                Some(before) => worse(before, found),
            });
            if matches!(fate, Some(Fate::Refuted { .. } | Fate::Meaningless { .. })) {
                break;
            }
        }
        fate.unwrap_or(Fate::Undecided("no instance".into()))
    }

    /// The nodes that depend on some nodes.
    pub fn stale(&self, nodes: impl Iterator<Item = Node>) -> BTreeSet<Node> {
        self.plan.dependences.dependents(&nodes.collect()).stale
    }

    /// What another display changes.
    pub fn changed(&self, e: usize, display: &Display) -> Changed {
        let equation = &self.model.equations[e];
        let differs = |place: crate::model::links::Place| {
            place.find(&equation.display) != place.find(display)
        };
        let claims = (0..equation.links.len())
            .filter(|l| self.plan.claims.contains(&(e, *l)))
            .filter(|l| {
                let Link { left, right, .. } = equation.links[*l];
                differs(left) || differs(right)
            })
            .map(|l| (e, l))
            .collect();
        let nodes = values_of(self.model, e)
            .into_iter()
            .filter(|(_, place)| place.is_none_or(differs))
            .filter_map(|(node, _)| {
                let link = match node {
                    Node::Definition(d) => equation.defines.iter().position(|x| *x == Some(d))?,
                    _ => 0,
                };
                Some((node, link))
            })
            .collect();
        Changed { claims, nodes }
    }

    fn fate_in(
        &mut self,
        instance: usize,
        mutant: &Mutant,
        changed: &Changed,
        dependents: &Dependents,
    ) -> Fate {
        let e = mutant.at.0;
        let model = self.model;
        // Whatever is computed from here on is forgotten again, with the letters it was given.
        let original = model.equations[e].display.clone();
        let mut undamaged = self.checkers[instance].changed(e, original, &BTreeSet::new());
        let before = self.values_before(&mut undamaged, instance, mutant, changed);
        let mut damaged = undamaged.changed(e, mutant.display.clone(), &dependents.stale);
        let checker = &mut damaged;
        let mut fate = match checker.nonsense() {
            Some(nonsense) => Fate::Meaningless {
                why: nonsense,
                by: None,
            },
            None => self.judged(checker, e, &case_of(mutant, model), changed, dependents),
        };
        // A second opinion, from the values alone: what has passed must be the same, and what is
        // refuted must not be.
        let much = changed.nodes.iter().any(|(node, _)| match node {
            Node::Definition(d) => {
                let kind = &model.definitions[*d].kind;
                matches!(kind, DefinitionKind::Family { .. })
            }
            _ => true,
        });
        let after = match &fate {
            Fate::Meaningless { .. } => None,
            Fate::Refuted { .. } if much => None,
            _ => self.values(checker, changed, &mutant.display),
        };
        let equal = after.is_some() && before == after;
        fate = match fate {
            Fate::Survived if equal => Fate::Equivalent(Equivalence::SameValue),
            Fate::Survived if changed.nodes.is_empty() => self
                .inequality(checker, mutant, changed)
                .map_or(Fate::Survived, Fate::Equivalent),
            Fate::Survived if !changed.nodes.is_empty() => Fate::Undecided(UNTOLD.into()),
            Fate::Refuted { by, .. } => Fate::Refuted {
                by,
                false_alarm: equal,
            },
            Fate::Undecided(_) if equal => Fate::Equivalent(Equivalence::SameValue),
            other => other,
        };
        drop((undamaged, damaged));
        if let Some(table) = &self.model.functions {
            table.take_back(self.letters);
        }
        fate
    }

    /// Whether the changed claims are inequalities that ask the same as before, or these or limits are
    /// true at points as well.
    fn inequality(
        &self,
        checker: &mut Checker<'m>,
        mutant: &Mutant,
        changed: &Changed,
    ) -> Option<Equivalence> {
        let mut same = true;
        for (e, l) in &changed.claims {
            let equation = &self.model.equations[*e];
            let link = &equation.links[*l];
            let mut under = match checker.under(*e) {
                None => None,
                Some(under) => Some(under.ok()?),
            };
            let checker = under.as_mut().unwrap_or(&mut *checker);
            if link.relation == Relation::Tends {
                same = false;
                if checker.tends_at_points(&mutant.display, link) != Some(true) {
                    return None;
                }
                continue;
            }
            let asked = checker.asked_positive(&mutant.display, link)?;
            let strict = matches!(link.relation, Relation::Greater | Relation::Less);
            if checker.asked_positive(&equation.display, link).as_ref() != Some(&asked) {
                same = false;
                let mut asked = asked.iter();
                if !asked.all(|f| checker.is_positive_at(f, POINTS, strict)) {
                    return None;
                }
            }
        }
        Some(if same {
            Equivalence::SameValue
        } else {
            Equivalence::TrueAsWell
        })
    }

    /// The verdicts on what a mutant changes and on what depends on it; [`Fate::Survived`] where all
    /// of them are passes.
    pub fn judged(
        &self,
        checker: &mut Checker<'m>,
        e: usize,
        case: &Case<'_>,
        changed: &Changed,
        dependents: &Dependents,
    ) -> Fate {
        let mut undecided = None;
        let definitions = changed.nodes.iter().map(|(_, link)| (e, *link));
        let others = dependents.claims.iter().copied();
        let others = others.filter(|at| !changed.claims.contains(at));
        // What a definition defines may be much; a claim needs little of it.
        let claims = changed.claims.iter().copied();
        let judged: Vec<LinkAt> = claims.chain(others).chain(definitions).collect();
        for at in judged {
            match self.decided(checker, case, at) {
                Finding::Accepted => {}
                Finding::Refuted => {
                    return Fate::Refuted {
                        by: self.name(at),
                        false_alarm: false,
                    };
                }
                Finding::Meaningless(why) => {
                    return Fate::Meaningless {
                        why,
                        by: Some(self.name(at)),
                    };
                }
                // A claim that has turned into something else has got past the checker; one that was
                // only rewritten is lost.
                Finding::NothingToCheck => match case.class {
                    Class::Edit(_) => return Fate::Survived,
                    Class::Rewriting(_) => return Fate::Undecided(LOST.into()),
                },
                Finding::Undecided(reason) => {
                    undecided.get_or_insert(reason);
                }
            }
        }
        undecided.map_or(Fate::Survived, Fate::Undecided)
    }

    fn decided(&self, checker: &mut Checker<'m>, case: &Case<'_>, at: LinkAt) -> Finding {
        let decide = self.plan.decide;
        decide.decide(case, &mut || checker.finding(at.0, at.1))
    }

    fn name(&self, (e, l): LinkAt) -> (String, usize) {
        let equation = &self.model.equations[e];
        (equation.label.clone(), equation.links[l].member)
    }

    /// The values of the original of what a mutant changes; those of the last mutant if it changed
    /// the same.
    fn values_before(
        &mut self,
        checker: &mut Checker<'m>,
        instance: usize,
        mutant: &Mutant,
        changed: &Changed,
    ) -> Option<Values> {
        let key = (instance, mutant.at.0, changed.clone());
        // With functions the letters that values are spelt in are taken back after each mutant.
        if self.model.functions.is_none()
            && let Some((known, values)) = &self.before
            && *known == key
        {
            return values.clone();
        }
        let original = &self.model.equations[mutant.at.0].display;
        let values = self.values(checker, changed, original);
        self.before = Some((key, values.clone()));
        values
    }

    /// The values of what a mutant changes: the sides of its claims, and what it defines.
    fn values(
        &self,
        checker: &mut Checker<'m>,
        changed: &Changed,
        display: &Display,
    ) -> Option<Values> {
        let model = self.model;
        let mut values = Vec::new();
        for (node, _) in &changed.nodes {
            values.extend(match node {
                Node::Definition(d) => checker.defined(*d)?,
                Node::Unknown { system, .. } => checker.determined(*system)?,
                _ => Vec::new(),
            });
        }
        for (e, l) in &changed.claims {
            let link = &model.equations[*e].links[*l];
            let sides = match checker.under(*e) {
                None => checker.expanded_sides(*e, display, link)?,
                Some(under) => under.ok()?.expanded_sides(*e, display, link)?,
            };
            values.extend(sides.into_iter().flatten());
        }
        Some(values.into_iter().map(plain).collect())
    }

    /// The fate of a mutant that changes what the names of the document are: everything is read and
    /// computed anew.
    fn fate_read_anew(&mut self, mutant: &Mutant) -> Fate {
        let (e, _) = mutant.at;
        let refused = |why| Fate::Meaningless { why, by: None };
        let span = self.model.equations[e].span;
        let mut text = self.plan.document.text.clone();
        let mut written = latex::write_display(&mutant.display);
        if text[span.start..span.end].ends_with('\n') {
            written.push('\n');
        }
        text.replace_range(span.start..span.end, &written);
        let Ok(document) = Document::parse(&self.plan.document.name, &text) else {
            return refused(Nonsense::Unreadable);
        };
        let model = match Model::build(&document) {
            Ok(model) => model,
            Err(diagnostics) => {
                let first = diagnostics
                    .first()
                    .map(|d| Nonsense::of_diagnostic(&d.kind));
                return refused(first.unwrap_or(Nonsense::Unreadable));
            }
        };
        let mut anew = match checkers(&model) {
            Ok(checkers) => checkers,
            Err(diagnostics) => {
                let first = diagnostics
                    .first()
                    .map(|d| Nonsense::of_diagnostic(&d.kind));
                return refused(first.unwrap_or(Nonsense::Unreadable));
            }
        };
        let case = case_of(mutant, self.model);
        let links = (0..model.equations.len()).flat_map(|q| {
            let links = 0..model.equations[q].links.len();
            links.map(move |l| (q, l))
        });
        // Claims of other equations that are true in the undamaged document, and all of this one.
        let (own, others): (Vec<LinkAt>, Vec<LinkAt>) = links
            .filter(|at| at.0 == e || self.plan.claims.contains(at))
            .partition(|at| at.0 == e);
        let mut undecided = None;
        for at in own.into_iter().chain(others) {
            for checker in &mut anew {
                let found = self
                    .plan
                    .decide
                    .decide(&case, &mut || checker.finding(at.0, at.1));
                let name = || {
                    let equation = &model.equations[at.0];
                    (equation.label.clone(), equation.links[at.1].member)
                };
                match found {
                    Finding::Accepted | Finding::NothingToCheck => {}
                    Finding::Refuted => {
                        return Fate::Refuted {
                            by: name(),
                            false_alarm: false,
                        };
                    }
                    Finding::Meaningless(why) => {
                        return Fate::Meaningless {
                            why,
                            by: Some(name()),
                        };
                    }
                    Finding::Undecided(reason) => {
                        undecided.get_or_insert(reason);
                    }
                }
            }
        }
        Fate::Undecided(undecided.unwrap_or_else(|| UNTOLD.into()))
    }
}

/// What is asked about a mutant.
fn case_of<'c>(mutant: &'c Mutant, model: &'c Model) -> Case<'c> {
    Case {
        class: Class::Edit(mutant.class),
        original: &model.equations[mutant.at.0].display,
        changed: &mutant.display,
    }
}

/// Zeros of all shapes alike, a matrix with one entry like its entry.
fn plain(value: Value<RationalFunction>) -> Value<RationalFunction> {
    match value {
        Value::Scalar(s) if s.is_zero() => Value::Zero,
        Value::Matrix(m) if m.iter().all(RationalFunction::is_zero) => Value::Zero,
        other => other,
    }
}

/// Of two fates in different instances the one that counts.
fn worse(one: Fate, other: Fate) -> Fate {
    let weight = |fate: &Fate| match fate {
        Fate::Equivalent(_) => 0,
        Fate::Undecided(_) => 1,
        Fate::Survived => 2,
        Fate::Meaningless { .. } => 3,
        Fate::Refuted { .. } => 4,
    };
    if weight(&other) > weight(&one) {
        other
    } else {
        one
    }
}
