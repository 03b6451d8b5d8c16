//! Signs of rational functions on regions, factor by factor, with what proves them; and what a
//! strict inequality is worth that holds everywhere, on a part, or not at the reference.

use super::{Found, Ground};
use crate::check::admissible::sign_within;
use crate::document::VerdictWord;
use crate::model::range::{Numbers, Range};
use crate::model::statement::Proposition;
use crate::theory::algebraic::Algebraic;
use crate::verdict::statement::{
    Fact, FactorProof, Measure, Scope, Sign, SignCertificate, Subject, coefficient_sign, power,
    square_sign, times,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use ratpoly::{Budget, Polynomial, RationalFunction, RegionSign};

/// What is known about the sign of a function.
pub(super) struct SignStudy {
    /// The sign, where it is known.
    pub sign: Option<Sign>,
    /// The factors that have both signs.
    pub boundary: Vec<Polynomial>,
    /// A point where it is positive and one where it is negative.
    pub points: Option<(Vec<BigRational>, Vec<BigRational>)>,
    /// Factors of the denominator that may vanish there: what is said is said of all other values.
    pub poles: Vec<Polynomial>,
    /// What proves the sign.
    pub certificate: Option<SignCertificate>,
}

/// A point is looked for along one letter at these multiples of its reference value.
pub(super) const MULTIPLES: [(i64, i64); 12] = [
    (1, 2),
    (2, 1),
    (3, 2),
    (1, 4),
    (4, 1),
    (1, 10),
    (10, 1),
    (1, 100),
    (100, 1),
    (1000, 1),
    (1, 1000),
    (1, 1),
];

/// Further multiples of reference values, for signs that occur far away only.
const FAR: [(i64, i64); 6] = [(1, 2), (3, 2), (1, 10), (10, 1), (1, 100), (100, 1)];

impl Found {
    /// What the sign of a subject everywhere says.
    pub(super) fn add_study(&mut self, subject: Subject, study: SignStudy) {
        match study.sign {
            Some(Sign::Both) => self.facts.push(Fact::Boundary(subject, study.boundary)),
            Some(sign) => {
                self.facts
                    .push(Fact::Sign(subject, sign, Scope::Everywhere));
                self.signs.extend(study.certificate);
            }
            None => {}
        }
    }
}

impl Ground {
    /// The sign of a function where `scope` says.
    pub(super) fn sign(&self, f: &RationalFunction, scope: &Scope) -> SignStudy {
        let unknown = SignStudy {
            sign: None,
            boundary: Vec::new(),
            points: None,
            poles: Vec::new(),
            certificate: None,
        };
        let Some((f, region)) = self.on(f, scope) else {
            return unknown;
        };
        let budget = Budget::default();
        let (Some(top), Some(bottom)) = (
            factors(f.numerator(), &budget),
            factors(f.denominator(), &budget),
        ) else {
            return unknown;
        };
        let content = top.0 * bottom.0;
        let mut sign = match content.cmp(&BigInt::zero()) {
            std::cmp::Ordering::Greater => Sign::Positive,
            std::cmp::Ordering::Less => Sign::Negative,
            std::cmp::Ordering::Equal => Sign::Zero,
        };
        let mut proofs = Vec::new();
        let mut boundary = Vec::new();
        let mut poles = Vec::new();
        let above = top.1.into_iter().map(|(f, m)| (f, m, false));
        let below = bottom.1.into_iter().map(|(f, m)| (f, m, true));
        for (factor, multiplicity, divides) in above.chain(below) {
            let Some(proof) = self.factor_sign(&factor, &region, &budget) else {
                return unknown;
            };
            if proof.sign() == Sign::Both && multiplicity % 2 == 1 {
                boundary.push(factor.clone());
            }
            let mut own = power(proof.sign(), multiplicity);
            if divides && !matches!(own, Sign::Positive | Sign::Negative) {
                poles.push(factor.clone());
                // Where a divisor vanishes there is no value.
                own = match own {
                    Sign::NonNegative => Sign::Positive,
                    Sign::NonPositive => Sign::Negative,
                    Sign::Zero => return unknown,
                    Sign::Positive | Sign::Negative | Sign::Both => own,
                };
            }
            sign = times(sign, own);
            proofs.push((factor, multiplicity, proof));
        }
        let mut points = None;
        if sign == Sign::Both && self.admissible.has_functions(&f) {
            // A constant such as pi is no letter that may have other values.
            return unknown;
        }
        if sign == Sign::Both {
            let product = f.numerator() * f.denominator();
            points = match sign_within(&product, &region, &budget) {
                RegionSign::Changes { positive, negative }
                    if self.admits(&product, &positive) && self.admits(&product, &negative) =>
                {
                    Some((positive, negative))
                }
                // Factors that change together may have a product that does not.
                RegionSign::Undecided | RegionSign::Changes { .. } => {
                    self.both_signs(&product, &region)
                }
                other => {
                    return SignStudy {
                        sign: Sign::of(&other),
                        poles,
                        ..unknown
                    };
                }
            };
            if points.is_none() {
                return unknown;
            }
        }
        // Both signs are shown by points, not by a product; nor is one beside poles.
        let proved = sign != Sign::Both && poles.is_empty();
        SignStudy {
            sign: Some(sign),
            boundary,
            points,
            poles,
            certificate: proved.then(|| SignCertificate {
                function: f,
                sign,
                positive: self.positive.clone(),
                content,
                factors: proofs,
            }),
        }
    }

    fn factor_sign(
        &self,
        factor: &Polynomial,
        region: &[Range],
        budget: &Budget,
    ) -> Option<FactorProof> {
        if let Some(sign) = coefficient_sign(factor, &self.positive) {
            return Some(FactorProof::Coefficients(sign));
        }
        let square = factor
            .variables_occurring()
            .into_iter()
            .find_map(|x| Some((x, square_sign(factor, x, &self.positive)?)));
        if let Some((x, sign)) = square {
            return Some(FactorProof::Square(x, sign));
        }
        match Sign::of(&sign_within(factor, region, budget)) {
            Some(sign) => Some(FactorProof::Engine(sign)),
            None => self
                .both_signs(factor, region)
                .map(|_| FactorProof::Engine(Sign::Both)),
        }
    }

    /// Points of a region where a polynomial is positive and where it is negative, looked for at
    /// multiples of the reference values.
    fn both_signs(
        &self,
        f: &Polynomial,
        region: &[Range],
    ) -> Option<(Vec<BigRational>, Vec<BigRational>)> {
        let letters: Vec<usize> = f
            .variables_occurring()
            .into_iter()
            .filter(|l| self.reference[*l].is_some())
            .collect();
        let all_letters = f.variables_occurring();
        let start: Vec<BigRational> = self
            .reference
            .iter()
            .zip(region)
            .map(|(v, range)| {
                v.clone()
                    .unwrap_or_else(|| range.near(&BigRational::one(), 1))
            })
            .collect();
        let (mut positive, mut negative) = (None, None);
        let base = FAR.len() + 1;
        for code in 0..base
            .checked_pow(u32::try_from(letters.len()).ok()?)?
            .min(20_000)
        {
            let mut point = start.clone();
            let mut rest = code;
            for letter in &letters {
                if let Some((n, d)) = (rest % base).checked_sub(1).map(|k| FAR[k]) {
                    point[*letter] *= BigRational::new(n.into(), d.into());
                }
                rest /= base;
            }
            let value = f.evaluate(&point).ok()?;
            let inside = all_letters.iter().all(|l| region[*l].contains(&point[*l]));
            if inside && value.is_positive() {
                positive.get_or_insert(point);
            } else if inside && value.is_negative() {
                negative.get_or_insert(point);
            }
            if positive.is_some() && negative.is_some() {
                break;
            }
        }
        Some((positive?, negative?))
    }

    /// Whether a point may have the values of the letters of a polynomial.
    fn admits(&self, f: &Polynomial, point: &[BigRational]) -> bool {
        f.variables_occurring()
            .iter()
            .all(|l| self.range_of(*l).contains(&point[*l]))
    }

    /// Where a letter may be.
    pub(super) fn range_of(&self, letter: usize) -> &Range {
        self.admissible.range(letter)
    }

    /// The function with the letters inserted that have a value in a scope, and the ranges of the
    /// others. None where a letter is complex or an entry of a definite matrix.
    pub(super) fn on(
        &self,
        f: &RationalFunction,
        scope: &Scope,
    ) -> Option<(RationalFunction, Vec<Range>)> {
        let mut ranges = self.admissible.ranges_for(f);
        let f = match scope {
            Scope::Everywhere => f.clone(),
            Scope::Above(letter, value) => {
                ranges[*letter].raise(value.clone(), false);
                f.clone()
            }
            Scope::Box(sides) => {
                for (letter, low, high) in sides {
                    ranges[*letter].raise(low.clone(), true);
                    ranges[*letter].lower(high.clone(), true);
                }
                let kept: Vec<usize> = sides.iter().map(|(letter, ..)| *letter).collect();
                self.restricted(f, &kept)?
            }
            Scope::Line(letter) => self.restricted(f, &[*letter])?,
            Scope::LineAbove(letter, value) => {
                ranges[*letter].raise(value.clone(), false);
                self.restricted(f, &[*letter])?
            }
            Scope::Reference => self.restricted(f, &[])?,
        };
        let letters = self.letters_in(&f);
        let simple =
            |l: &usize| ranges[*l].numbers != Numbers::Complex && !self.admissible.is_drawn(*l);
        letters.iter().all(simple).then_some((f, ranges))
    }

    /// Whether a function is greater (or less) than zero wherever the proposition says, with the
    /// facts for it. `letter` is the one that the proposition is about; of a derivative by it, zeros
    /// that are isolated in the letter do not count.
    pub(super) fn strict(
        &self,
        g: &RationalFunction,
        positive: bool,
        subject: Subject,
        letter: Option<usize>,
        proposition: &Proposition,
    ) -> Found {
        let sides = self.sides(proposition);
        let scope = if proposition.only_in_box {
            Scope::Box(sides.clone())
        } else {
            Scope::Everywhere
        };
        let study = self.sign(g, &scope);
        let (wanted, weak) = match positive {
            true => (Sign::Positive, Sign::NonNegative),
            false => (Sign::Negative, Sign::NonPositive),
        };
        let mut found = Found::default();
        let isolated = letter.is_some_and(|x| self.zeros_are_isolated(g, x, &scope));
        let fits = study.sign == Some(wanted) || study.sign == Some(weak) && isolated;
        if fits && study.poles.is_empty() {
            found.word = VerdictWord::Holds;
            let sign = study.sign.unwrap_or(wanted);
            found.facts.push(Fact::Sign(subject, sign, scope));
            found.signs.extend(study.certificate);
            return found;
        }
        if !study.poles.is_empty() {
            found.facts.push(Fact::Pole(study.poles.clone()));
        }
        // A box need not be around the reference values.
        let among = |(letter, low, high): &(usize, BigRational, BigRational)| {
            let own = self.reference[*letter].as_ref();
            own.is_some_and(|value| low <= value && value <= high)
        };
        let meant = !proposition.only_in_box || sides.iter().all(among);
        let here = self.at(g).filter(|_| meant);
        let right = |value: &BigRational| match positive {
            true => value.is_positive(),
            false => value.is_negative(),
        };
        let certainly_wrong = |value: &BigRational| match positive {
            true => value.is_negative() || value.is_zero() && !isolated,
            false => value.is_positive() || value.is_zero() && !isolated,
        };
        if let Some(value) = here.clone().filter(certainly_wrong) {
            found.word = VerdictWord::Refuted;
            if let Some(sign) = study.sign.filter(|s| *s != Sign::Both) {
                found.facts.push(Fact::Sign(subject, sign, scope.clone()));
                found.signs.extend(study.certificate);
            }
            let point = self.point_of(g);
            found.facts.push(Fact::Witness {
                subject,
                point,
                value,
            });
            self.boundary_facts(g, &study.boundary, subject, letter, &mut found);
            return found;
        }
        let here_is_right = here.as_ref().is_some_and(right);
        let inside = (!sides.is_empty() && !proposition.only_in_box).then(|| {
            let scope = Scope::Box(sides.clone());
            (self.sign(g, &scope), scope)
        });
        let wrong = self.wrong_point(g, &certainly_wrong, &study, proposition, letter, positive);
        // What is false somewhere is loose where it is true at the reference.
        let signed = match study.sign {
            Some(Sign::Both) => study.points.is_some(),
            Some(Sign::Zero) => true,
            Some(Sign::Positive | Sign::NonNegative) => !positive,
            Some(Sign::Negative | Sign::NonPositive) => positive,
            None => false,
        };
        let false_somewhere = wrong.is_some() || signed;
        found.word = match (false_somewhere, here_is_right) {
            (true, true) => VerdictWord::Loose,
            (true, false) if here.is_none() && study.sign == Some(weak) => VerdictWord::Loose,
            (true, false) => VerdictWord::Refuted,
            (false, _) => VerdictWord::Undecided,
        };
        if found.word == VerdictWord::Undecided {
            found.reason = Some(match (fits, study.sign) {
                (true, _) => "it has a pole where it is meant".into(),
                (false, Some(_)) => "nothing shows that it vanishes nowhere".into(),
                (false, None) => "its sign is out of reach".into(),
            });
        }
        if let Some(sign) = study.sign.filter(|s| *s != Sign::Both) {
            found.facts.push(Fact::Sign(subject, sign, scope));
        }
        if study.sign.is_some()
            || inside
                .as_ref()
                .is_some_and(|(inner, _)| inner.sign.is_some())
        {
            self.boundary_facts(g, &study.boundary, subject, letter, &mut found);
        }
        if let Some((point, value)) = wrong {
            found.facts.push(Fact::Witness {
                subject,
                point,
                value,
            });
        }
        if let Some((inner, scope)) = inside
            && let Some(sign) = inner.sign
        {
            found.facts.push(Fact::Sign(subject, sign, scope));
            found.signs.extend(inner.certificate);
        }
        found
    }

    /// Whether the zeros of a function in a letter are isolated whatever the others are: a coefficient
    /// of its numerator vanishes nowhere.
    pub(super) fn zeros_are_isolated(&self, g: &RationalFunction, x: usize, scope: &Scope) -> bool {
        let Some((g, _)) = self.on(g, scope) else {
            return false;
        };
        g.numerator().coefficients_in(x).into_iter().any(|c| {
            let sign = self.sign(&c.into(), scope).sign;
            matches!(sign, Some(Sign::Positive | Sign::Negative))
        })
    }

    /// Where the sign changes: the polynomial, and how far from the reference value along the
    /// letter.
    fn boundary_facts(
        &self,
        g: &RationalFunction,
        boundary: &[Polynomial],
        subject: Subject,
        letter: Option<usize>,
        found: &mut Found,
    ) {
        if let Some(letter) = letter {
            for threshold in self.thresholds(g, letter) {
                found
                    .facts
                    .push(Fact::Number(Measure::Threshold(letter), threshold));
            }
        }
        if !boundary.is_empty() {
            found.facts.push(Fact::Boundary(subject, boundary.to_vec()));
        }
    }

    /// The multiples of a letter's reference value, next to one on both sides, at which a function
    /// vanishes, the other letters as in the reference.
    fn thresholds(&self, g: &RationalFunction, letter: usize) -> Vec<Algebraic> {
        let Some(own) = self.reference[letter].clone() else {
            return Vec::new();
        };
        let budget = Budget::default();
        let scaled = RationalFunction::variable(self.ring, letter)
            * RationalFunction::constant(self.ring, own);
        let roots = self
            .restricted(g, &[letter])
            .and_then(|line| line.substitute(&[(letter, scaled)]).ok())
            .and_then(|line| Algebraic::roots(line.numerator(), letter, &budget).ok())
            .unwrap_or_default();
        let one = BigRational::one();
        let below = roots
            .iter()
            .rfind(|r| r.is_positive() && r.compare_rational(&one).is_lt());
        let above = roots.iter().find(|r| r.compare_rational(&one).is_gt());
        below.into_iter().chain(above).cloned().collect()
    }

    /// A point with the wrong sign, as near to the reference as is easily found.
    fn wrong_point(
        &self,
        g: &RationalFunction,
        certainly_wrong: &dyn Fn(&BigRational) -> bool,
        study: &SignStudy,
        proposition: &Proposition,
        letter: Option<usize>,
        positive: bool,
    ) -> Option<(Vec<(usize, BigRational)>, BigRational)> {
        let occurring = self.letters_in(g);
        let wrong = |values: &[(usize, BigRational)]| {
            let mut point = self.reference.clone();
            for (letter, value) in values {
                point[*letter] = Some(value.clone());
            }
            let value = self.at_point(g, &point)?;
            let admitted = occurring.iter().all(|l| {
                let value = point[*l].as_ref();
                value.is_some_and(|v| self.range_of(*l).contains(v))
                    && !self.admissible.is_drawn(*l)
            });
            let wrong = admitted && certainly_wrong(&value);
            let shown = occurring.iter().map(|l| Some((*l, point[*l].clone()?)));
            wrong.then(|| Some((shown.collect::<Option<Vec<_>>>()?, value)))?
        };
        let inside = |letter: usize, value: &BigRational| {
            !proposition.only_in_box
                || self
                    .sides(proposition)
                    .iter()
                    .any(|(l, low, high)| *l == letter && low <= value && value <= high)
        };
        let multiples = |letter: usize| {
            MULTIPLES.iter().filter_map(move |(n, d)| {
                let value =
                    self.reference[letter].clone()? * BigRational::new((*n).into(), (*d).into());
                Some((letter, value))
            })
        };
        let mut order = occurring.clone();
        order.sort_by_key(|l| Some(*l) != letter);
        order.retain(|l| self.reference[*l].is_some());
        for &first in &order {
            let mut single = multiples(first).filter(|(l, v)| inside(*l, v));
            if let Some(found) = single.find_map(|v| wrong(&[v])) {
                return Some(found);
            }
        }
        for (k, &first) in order.iter().enumerate() {
            for &second in &order[k + 1..] {
                for v in multiples(first).filter(|(l, v)| inside(*l, v)) {
                    let mut other = multiples(second).filter(|(l, v)| inside(*l, v));
                    if let Some(found) = other.find_map(|w| wrong(&[v.clone(), w])) {
                        return Some(found);
                    }
                }
            }
        }
        let (plus, minus) = study.points.as_ref()?;
        let point = if positive { minus } else { plus };
        let point: Vec<(usize, BigRational)> =
            occurring.iter().map(|l| (*l, point[*l].clone())).collect();
        wrong(&point)
    }
}

/// Content and irreducible factors; the polynomial itself where factoring is out of reach.
fn factors(f: &Polynomial, budget: &Budget) -> Option<(BigInt, Vec<(Polynomial, u32)>)> {
    if f.is_zero() {
        return Some((BigInt::zero(), Vec::new()));
    }
    match f.factor_within(budget) {
        Ok(product) => Some((product.content, product.factors)),
        Err(_) => Some((BigInt::one(), vec![(f.clone(), 1)])),
    }
}
