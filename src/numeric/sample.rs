//! Seeded points in a box, log-uniform and dyadic.
//!
//! A floating-point method and the exact engine can only be compared at the very same point, so
//! every coordinate is a double with a short mantissa: small as an exact rational too.
//! Log-uniform needs no logarithm: an exponent is drawn uniformly, a mantissa `1 <= m < 2` is drawn
//! uniformly and kept with probability `1 / m`, and what falls outside the range is drawn again.
//! Only integer arithmetic and exact products are used, so every machine draws the same points.

use super::NumericError;
use rand_core::Rng;
use rand_pcg::Pcg64;

/// Mantissa bits of a coordinate where the range is wide enough.
const BITS: u32 = 24;
const STREAM: u128 = 0x5851_f42d_4c95_7f2d_1405_7b7e_f767_814f;

/// The closed range of one coordinate, `0 < low <= high`, both normal doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    low: f64,
    high: f64,
}

impl Range {
    /// A range; [`NumericError::Range`] unless `0 < low <= high` and both are normal.
    pub fn new(low: f64, high: f64) -> Result<Self, NumericError> {
        if low.is_normal() && high.is_normal() && 0.0 < low && low <= high {
            Ok(Range { low, high })
        } else {
            Err(NumericError::Range)
        }
    }

    /// The least value.
    pub fn low(self) -> f64 {
        self.low
    }

    /// The greatest value.
    pub fn high(self) -> f64 {
        self.high
    }

    fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }
}

/// A seeded source of points.
#[derive(Clone, Debug)]
pub struct Sampler {
    source: Pcg64,
}

impl Sampler {
    /// The points of a seed, always the same.
    pub fn new(seed: u64) -> Self {
        Sampler {
            source: Pcg64::new(u128::from(seed), STREAM),
        }
    }

    /// A point of the box, one coordinate for each range.
    pub fn point(&mut self, ranges: &[Range]) -> Vec<f64> {
        ranges.iter().map(|range| self.coordinate(*range)).collect()
    }

    /// One log-uniform coordinate.
    pub fn coordinate(&mut self, range: Range) -> f64 {
        let exponents = (exponent(range.low), exponent(range.high));
        // A narrow range may hold no short mantissa, and the acceptance would be poor.
        if range.high <= range.low * (1.0 + 1e-3) {
            return self.narrow(range);
        }
        loop {
            let e = exponents.0 + self.below((exponents.1 - exponents.0 + 1) as u64) as i64;
            let m = 1.0 + self.below(1 << BITS) as f64 / (1u64 << BITS) as f64;
            // keep with probability 1 / m
            let keep = self.below(1 << 26) as f64 * m < (1u64 << 26) as f64;
            let x = m * power_of_two(e);
            if keep && range.contains(x) {
                return x;
            }
        }
    }

    /// A uniform coordinate of the closed range `low <= x <= high`, which may hold zero or negative
    /// numbers: a multiple of a power of two, with 24 bits where the range is wide enough.
    pub fn uniform(&mut self, low: f64, high: f64) -> Result<f64, NumericError> {
        let largest = low.abs().max(high.abs());
        if !(low <= high && largest.is_finite()) {
            return Err(NumericError::Range);
        }
        if low == high || !largest.is_normal() {
            return Ok(low);
        }
        // Multiples of the grid are counted by integers of at most 53 bits, so all is exact.
        for bits in [BITS, 52] {
            let step = exponent(largest) - i64::from(bits);
            if step < -1022 {
                return Ok(low);
            }
            let grid = power_of_two(step);
            let (first, last) = ((low / grid).ceil() as i64, (high / grid).floor() as i64);
            if last - first >= 1 << 12 || bits == 52 && last >= first {
                let k = first + self.below((last - first + 1) as u64) as i64;
                return Ok(k as f64 * grid);
            }
        }
        Ok(low)
    }

    /// A uniform coordinate of a range so narrow that log-uniform is the same, or its one value.
    fn narrow(&mut self, range: Range) -> f64 {
        let (low, high) = (range.low.to_bits(), range.high.to_bits());
        // Positive doubles are ordered like their bits; zero low bits keep the mantissa short.
        let first = low + self.below(high - low + 1);
        let shortened = f64::from_bits(first & !((1 << 16) - 1));
        if range.contains(shortened) {
            shortened
        } else {
            f64::from_bits(first)
        }
    }

    /// A uniform integer below `bound > 0`, without bias: draws that do not fit are repeated.
    fn below(&mut self, bound: u64) -> u64 {
        let limit = u64::MAX - u64::MAX % bound;
        loop {
            let draw = self.source.next_u64();
            if draw < limit {
                return draw % bound;
            }
        }
    }
}

/// `e` with `2^e <= x < 2^(e+1)` for a positive normal double.
fn exponent(x: f64) -> i64 {
    (x.to_bits() >> 52) as i64 - 1023
}

/// `2^e` for an exponent of a normal double.
fn power_of_two(e: i64) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const GOLDEN: [[f64; 2]; 2] = [
        [526.8618774414063, 0.007587217725813389],
        [220.89647674560547, 1.2987389936824911e-6],
    ];

    #[test]
    fn golden_points() {
        // Any change here changes every published sample: the generator, the stream or the method.
        let ranges = [
            Range::new(100.0, 5000.0).unwrap(),
            Range::new(1e-6, 1.0).unwrap(),
        ];
        let mut sampler = Sampler::new(2006);
        let points: Vec<Vec<f64>> = (0..2).map(|_| sampler.point(&ranges)).collect();
        assert_eq!(points, GOLDEN);
    }

    #[test]
    fn every_decade_gets_its_share() {
        let range = Range::new(1e-3, 1e3).unwrap();
        let mut sampler = Sampler::new(1);
        let mut counts = [0i32; 6];
        let n = 12_000;
        for _ in 0..n {
            let x = sampler.coordinate(range);
            let decade = [1e-2, 1e-1, 1.0, 1e1, 1e2]
                .iter()
                .filter(|edge| x >= **edge)
                .count();
            counts[decade] += 1;
        }
        // 2000 each, five standard deviations of a binomial
        let slack = 5.0 * (f64::from(n) * (1.0 / 6.0) * (5.0 / 6.0)).sqrt();
        for count in counts {
            assert!((f64::from(count) - 2000.0).abs() < slack, "{counts:?}");
        }
    }

    #[test]
    fn uniform_points_fill_their_range_evenly() {
        let mut sampler = Sampler::new(3);
        let n = 10_000;
        let mut below = 0;
        for _ in 0..n {
            let x = sampler.uniform(-1.0, 3.0).unwrap();
            below += i32::from(x < 0.0);
        }
        assert!((f64::from(below) - 2500.0).abs() < 5.0 * (f64::from(n) * 0.25 * 0.75).sqrt());
        assert_eq!(sampler.uniform(0.0, 0.0), Ok(0.0));
        for (low, high) in [(1.0, 0.0), (f64::NAN, 1.0), (0.0, f64::INFINITY)] {
            assert_eq!(sampler.uniform(low, high), Err(NumericError::Range));
        }
    }

    #[test]
    fn ranges_without_meaning() {
        for (low, high) in [
            (0.0, 1.0),
            (-1.0, 1.0),
            (2.0, 1.0),
            (f64::NAN, 1.0),
            (1.0, f64::INFINITY),
            (5e-324, 1.0),
        ] {
            assert_eq!(Range::new(low, high), Err(NumericError::Range));
        }
    }

    proptest! {
        #[test]
        fn points_lie_in_the_box_and_are_short(seed: u64, low in 1e-9f64..1e9, ratio in 1.0f64..1e6) {
            let range = Range::new(low, low * ratio).unwrap();
            let x = Sampler::new(seed).coordinate(range);
            prop_assert!(range.contains(x));
            if ratio > 1.01 {
                prop_assert_eq!(x.to_bits() & ((1 << (52 - BITS)) - 1), 0);
            }
        }

        #[test]
        fn uniform_points_lie_in_their_range(seed: u64, x in -1e9f64..1e9, y in -1e9f64..1e9) {
            let (low, high) = (x.min(y), x.max(y));
            let point = Sampler::new(seed).uniform(low, high).unwrap();
            prop_assert!(low <= point && point <= high);
            let close = Sampler::new(seed).uniform(low, low + low.abs() * 1e-15).unwrap();
            prop_assert!(low <= close && close <= low + low.abs() * 1e-15);
        }

        #[test]
        fn a_range_of_one_value_gives_that_value(seed: u64, x in 1e-300f64..1e300) {
            prop_assert_eq!(Sampler::new(seed).coordinate(Range::new(x, x).unwrap()), x);
        }
    }
}
