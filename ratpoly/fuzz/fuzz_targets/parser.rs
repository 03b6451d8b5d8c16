//! Any text is a polynomial that prints and parses back to itself, or a typed error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use ratpoly::{Order, Polynomial, Ring};

fuzz_target!(|text: &str| {
    let ring = Ring::new(["x", "y", "z_1"], Order::Grevlex).expect("names");
    if let Ok(f) = Polynomial::parse(ring, text) {
        assert!(f.is_canonical());
        assert_eq!(Polynomial::parse(ring, &f.to_string()), Ok(f));
    }
});
