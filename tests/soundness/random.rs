//! Seeded numbers, the same on every machine: SplitMix64 (Steele, Lea & Flood, *Fast splittable
//! pseudorandom number generators*, 2014). It shares nothing with what the program draws with.

/// A source of numbers.
pub struct Random(u64);

impl Random {
    /// A source of its own for each seed and each name.
    pub fn new(seed: u64, name: &str) -> Self {
        // FNV-1a, so that a template draws the same whatever other templates there are.
        let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| {
            (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3)
        });
        let mut source = Random(hash ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        source.next();
        source
    }

    /// A source that begins with this state.
    pub fn seeded(state: u64) -> Self {
        Random(state)
    }

    /// The next 64 bits.
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below a bound.
    pub fn below(&mut self, bound: usize) -> usize {
        usize::try_from(self.next() % bound as u64).expect("below a usize")
    }

    /// A number between two, both included.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        let span = u64::try_from(high - low).expect("an interval") + 1;
        low + i64::try_from(self.next() % span).expect("within the interval")
    }

    /// The same without zero.
    pub fn nonzero(&mut self, low: i64, high: i64) -> i64 {
        loop {
            let found = self.between(low, high);
            if found != 0 {
                return found;
            }
        }
    }

    /// Heads, once in `of` throws.
    pub fn once_in(&mut self, of: usize) -> bool {
        self.below(of) == 0
    }

    /// One of some.
    pub fn pick<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }

    /// Some different ones, in a random order.
    pub fn some<T: Clone>(&mut self, of: &[T], how_many: usize) -> Vec<T> {
        let mut all = of.to_vec();
        self.shuffle(&mut all);
        all.truncate(how_many);
        all
    }

    /// Puts them in a random order (Fisher and Yates).
    pub fn shuffle<T>(&mut self, of: &mut [T]) {
        for k in (1..of.len()).rev() {
            of.swap(k, self.below(k + 1));
        }
    }

    /// A number of the unit interval.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}
