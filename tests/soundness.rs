//! No false verdict, ever: generated claims whose truth is known by construction or by an
//! independent evaluator, one family of relatives a module.

#[path = "soundness/admitted.rs"]
mod admitted;
#[path = "soundness/arms.rs"]
mod arms;
#[path = "soundness/boxes.rs"]
mod boxes;
#[allow(dead_code)]
mod common;
#[path = "soundness/corrected.rs"]
mod corrected;
#[path = "soundness/corrections.rs"]
mod corrections;
#[path = "soundness/dots.rs"]
mod dots;
#[path = "soundness/elasticities.rs"]
mod elasticities;
#[path = "soundness/enclosures.rs"]
mod enclosures;
#[path = "soundness/expectations.rs"]
mod expectations;
#[path = "soundness/floating.rs"]
mod floating;
#[path = "soundness/functions.rs"]
mod functions;
#[path = "soundness/mod.rs"]
mod generated;
#[path = "soundness/hypotheses.rs"]
mod hypotheses;
#[path = "soundness/integrals_and_limits.rs"]
mod integrals_and_limits;
#[path = "soundness/limits.rs"]
mod limits;
#[path = "soundness/moments.rs"]
mod moments;
#[path = "soundness/monotone.rs"]
mod monotone;
#[path = "soundness/one_case.rs"]
mod one_case;
#[path = "soundness/places.rs"]
mod places;
#[path = "soundness/plain_text.rs"]
mod plain_text;
#[path = "soundness/prints.rs"]
mod prints;
#[path = "soundness/random_letters.rs"]
mod random_letters;
#[path = "soundness/readings.rs"]
mod readings;
#[path = "soundness/references.rs"]
mod references;
#[path = "soundness/says.rs"]
mod says;
#[path = "soundness/signs.rs"]
mod signs;
#[path = "soundness/sizes.rs"]
mod sizes;
#[path = "soundness/solved.rs"]
mod solved;
#[path = "soundness/statements.rs"]
mod statements;
#[path = "soundness/supports.rs"]
mod supports;
#[path = "soundness/textbook.rs"]
mod textbook;
#[path = "soundness/unwritten.rs"]
mod unwritten;
#[path = "soundness/zero.rs"]
mod zero;
