//! Complex numbers within rectangles.
//!
//! Roots, logarithms and powers are the principal ones, whose cut is the negative real axis; where a
//! rectangle meets the cut without lying on the real axis, or zero where there is no value, there is
//! no enclosure. A number whose imaginary part is exactly zero is real, and real functions are used.

use super::number::Real;
use std::cmp::Ordering;

/// A complex number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complex {
    /// The real part.
    pub re: Real,
    /// The imaginary part.
    pub im: Real,
}

impl From<Real> for Complex {
    fn from(re: Real) -> Self {
        Complex {
            re,
            im: Real::zero(),
        }
    }
}

impl Complex {
    /// An integer.
    pub fn integer(n: i64) -> Self {
        Real::integer(n).into()
    }

    /// The imaginary unit.
    pub fn imaginary_unit() -> Self {
        Complex {
            re: Real::zero(),
            im: Real::integer(1),
        }
    }

    /// Whether its imaginary part certainly is zero.
    pub fn is_real(&self) -> bool {
        self.im.is_zero()
    }

    /// Whether it certainly is zero.
    pub fn is_zero(&self) -> bool {
        self.re.is_zero() && self.im.is_zero()
    }

    /// Whether it certainly is one.
    pub fn is_one(&self) -> bool {
        self.re.is_one() && self.im.is_zero()
    }

    /// Whether it may be zero.
    pub fn may_vanish(&self) -> bool {
        self.re.may_vanish() && self.im.may_vanish()
    }

    /// Whether the two certainly differ.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        self.re.is_apart_from(&other.re) || self.im.is_apart_from(&other.im)
    }

    /// Whether both parts are known to so many digits.
    pub fn is_narrow(&self, digits: i64) -> bool {
        let tiny = |part: &Real, beside: &Real| {
            let (a, b) = (part.largest(64), beside.largest(64));
            match (a.magnitude(), b.magnitude()) {
                (Some(a), Some(b)) => a <= b - digits,
                (None, _) => true,
                (Some(_), None) => false,
            }
        };
        (self.re.is_narrow(digits) || tiny(&self.re, &self.im))
            && (self.im.is_narrow(digits) || tiny(&self.im, &self.re))
    }

    /// Whether computing with it cannot overflow.
    pub fn is_moderate(&self) -> bool {
        self.re.is_moderate() && self.im.is_moderate()
    }

    /// `-z`.
    #[must_use]
    pub fn negated(&self) -> Self {
        Complex {
            re: self.re.negated(),
            im: self.im.negated(),
        }
    }

    /// The conjugate.
    #[must_use]
    pub fn conjugate(&self) -> Self {
        Complex {
            re: self.re.clone(),
            im: self.im.negated(),
        }
    }

    /// `z + w`.
    #[must_use]
    pub fn add(&self, other: &Self, bits: u32) -> Self {
        Complex {
            re: self.re.add(&other.re, bits),
            im: self.im.add(&other.im, bits),
        }
    }

    /// `z - w`.
    #[must_use]
    pub fn subtract(&self, other: &Self, bits: u32) -> Self {
        self.add(&other.negated(), bits)
    }

    /// `z w`.
    #[must_use]
    pub fn multiply(&self, other: &Self, bits: u32) -> Self {
        if self.is_real() || other.is_real() {
            let (z, factor) = if other.is_real() {
                (self, &other.re)
            } else {
                (other, &self.re)
            };
            return Complex {
                re: z.re.multiply(factor, bits),
                im: z.im.multiply(factor, bits),
            };
        }
        let products = |a: &Real, b: &Real| a.multiply(b, bits);
        Complex {
            re: products(&self.re, &other.re).subtract(&products(&self.im, &other.im), bits),
            im: products(&self.re, &other.im).add(&products(&self.im, &other.re), bits),
        }
    }

    /// `|z|^2`.
    pub fn square_of_modulus(&self, bits: u32) -> Option<Real> {
        Some(self.re.power(2, bits)?.add(&self.im.power(2, bits)?, bits))
    }

    /// `z / w`; none where w may be zero.
    pub fn divide(&self, other: &Self, bits: u32) -> Option<Self> {
        if other.is_real() {
            return Some(Complex {
                re: self.re.divide(&other.re, bits)?,
                im: self.im.divide(&other.re, bits)?,
            });
        }
        let below = other.square_of_modulus(bits)?;
        let above = self.multiply(&other.conjugate(), bits);
        Some(Complex {
            re: above.re.divide(&below, bits)?,
            im: above.im.divide(&below, bits)?,
        })
    }

    /// `z^n`; none where n is negative and z may be zero, or beyond the limit of exponents.
    pub fn power(&self, n: i32, bits: u32) -> Option<Self> {
        let magnitude = n.unsigned_abs();
        let power = if self.is_real() {
            self.re.power(magnitude, bits)?.into()
        } else {
            if magnitude > 10_000 {
                return None;
            }
            let mut result = Complex::integer(1);
            let mut square = self.clone();
            let mut exponent = magnitude;
            while exponent > 0 {
                if exponent & 1 == 1 {
                    result = result.multiply(&square, bits);
                }
                exponent >>= 1;
                if exponent > 0 {
                    square = square.multiply(&square, bits);
                    if !square.is_moderate() {
                        return None;
                    }
                }
            }
            result
        };
        if n < 0 {
            Complex::integer(1).divide(&power, bits)
        } else {
            Some(power)
        }
    }

    /// `|z|`.
    pub fn modulus(&self, bits: u32) -> Option<Real> {
        if self.is_real() {
            return Some(self.re.absolute());
        }
        if self.re.is_zero() {
            return Some(self.im.absolute());
        }
        self.square_of_modulus(bits)?.root(2, bits)
    }

    /// The principal square root.
    pub fn square_root(&self, bits: u32) -> Option<Self> {
        if self.is_real() {
            return match self.re.sign() {
                Some(Ordering::Greater | Ordering::Equal) => Some(self.re.root(2, bits)?.into()),
                Some(Ordering::Less) => Some(Complex {
                    re: Real::zero(),
                    im: self.re.negated().root(2, bits)?,
                }),
                None => {
                    // On the real axis the root is continuous through zero, from one axis to the other.
                    let ends = self.re.interval(bits);
                    let upto = |end: super::dyadic::Dyadic| {
                        let zero = super::dyadic::Dyadic::zero();
                        super::interval::Interval::between(zero, end).root(2, bits)
                    };
                    Some(Complex {
                        re: Real::Enclosed(upto(ends.high().clone())?),
                        im: Real::Enclosed(upto(ends.low().negated())?),
                    })
                }
            };
        }
        let half = |x: Real| x.multiply(&Real::rational(half()), bits);
        let modulus = self.modulus(bits)?;
        let not_negative = |x: Real| -> Option<Real> {
            // What cannot be negative is computed as if it were by rounding only.
            let interval = x.interval(bits);
            let top = interval.high().clone();
            if top.is_negative() {
                return None;
            }
            let bottom = interval.low().clone().max(super::dyadic::Dyadic::zero());
            Some(Real::Enclosed(super::interval::Interval::between(
                bottom, top,
            )))
        };
        if self.re.sign() == Some(Ordering::Greater) {
            let re = half(modulus.add(&self.re, bits)).root(2, bits)?;
            let im = half(self.im.divide(&re, bits)?);
            return Some(Complex { re, im });
        }
        let above = self.im.sign()?;
        let im = half(modulus.subtract(&self.re, bits));
        let im = not_negative(im)?.root(2, bits)?;
        let re = half(modulus.add(&self.re, bits));
        let re = not_negative(re)?.root(2, bits)?;
        match above {
            Ordering::Greater => Some(Complex { re, im }),
            Ordering::Less => Some(Complex {
                re,
                im: im.negated(),
            }),
            Ordering::Equal => None,
        }
    }

    /// e^z.
    pub fn exponential(&self, bits: u32) -> Option<Self> {
        let modulus = self.re.exponential(bits)?;
        if self.is_real() {
            return Some(modulus.into());
        }
        let (cosine, sine) = self.im.cosine_and_sine(bits)?;
        Some(Complex {
            re: modulus.multiply(&cosine, bits),
            im: modulus.multiply(&sine, bits),
        })
    }

    /// The principal argument, greater than -pi and at most pi.
    pub fn argument(&self, bits: u32) -> Option<Real> {
        if self.is_real() {
            return match self.re.sign()? {
                Ordering::Greater => Some(Real::zero()),
                Ordering::Less => Some(Real::pi(bits)),
                Ordering::Equal => None,
            };
        }
        if self.re.sign() == Some(Ordering::Greater) {
            return self.im.divide(&self.re, bits)?.arctangent(bits);
        }
        let quarter = Real::pi(bits + 8).multiply(&Real::rational(half()), bits);
        let rest = self.re.divide(&self.im, bits)?.arctangent(bits)?;
        match self.im.sign()? {
            Ordering::Greater => Some(quarter.subtract(&rest, bits)),
            Ordering::Less => Some(quarter.negated().subtract(&rest, bits)),
            Ordering::Equal => None,
        }
    }

    /// The principal logarithm.
    pub fn logarithm(&self, bits: u32) -> Option<Self> {
        Some(Complex {
            re: self.modulus(bits)?.logarithm(bits)?,
            im: self.argument(bits)?,
        })
    }

    /// cos z and sin z.
    pub fn cosine_and_sine(&self, bits: u32) -> Option<(Self, Self)> {
        let (cosine, sine) = self.re.cosine_and_sine(bits)?;
        if self.is_real() {
            return Some((cosine.into(), sine.into()));
        }
        let (cosh, sinh) = self.im.hyperbolic(bits)?;
        Some((
            Complex {
                re: cosine.multiply(&cosh, bits),
                im: sine.multiply(&sinh, bits).negated(),
            },
            Complex {
                re: sine.multiply(&cosh, bits),
                im: cosine.multiply(&sinh, bits),
            },
        ))
    }

    /// cosh z and sinh z.
    pub fn hyperbolic(&self, bits: u32) -> Option<(Self, Self)> {
        let (cosh, sinh) = self.re.hyperbolic(bits)?;
        if self.is_real() {
            return Some((cosh.into(), sinh.into()));
        }
        let (cosine, sine) = self.im.cosine_and_sine(bits)?;
        Some((
            Complex {
                re: cosh.multiply(&cosine, bits),
                im: sinh.multiply(&sine, bits),
            },
            Complex {
                re: sinh.multiply(&cosine, bits),
                im: cosh.multiply(&sine, bits),
            },
        ))
    }
}

fn half() -> num_rational::BigRational {
    num_rational::BigRational::new(1.into(), 2.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use proptest::prelude::*;

    const BITS: u32 = 100;

    fn complex(a: i64, b: i64, d: i64) -> Complex {
        let part = |n: i64| Real::Exact(BigRational::new(n.into(), d.into()));
        Complex {
            re: part(a),
            im: part(b),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn principal_values(a in -50i64..50, b in -50i64..50, d in 1i64..9) {
            let z = complex(a, b, d);
            let root = z.square_root(BITS);
            prop_assert!(root.is_some());
            let root = root.unwrap();
            prop_assert!(!root.multiply(&root, BITS).is_apart_from(&z));
            prop_assert!(root.re.sign() != Some(Ordering::Less));
            if !z.is_zero() {
                let logarithm = z.logarithm(BITS).unwrap();
                let back = logarithm.exponential(BITS).unwrap();
                prop_assert!(!back.is_apart_from(&z));
                prop_assert!(logarithm.im.compared(&Real::integer(4)) == Some(Ordering::Less));
                let half = logarithm.multiply(&Real::rational(half()).into(), BITS);
                prop_assert!(!half.exponential(BITS).unwrap().is_apart_from(&root));
                let one = z.divide(&z, BITS).unwrap();
                prop_assert!(!one.is_apart_from(&Complex::integer(1)));
                let power = z.power(-3, BITS).unwrap().multiply(&z.power(3, BITS).unwrap(), BITS);
                prop_assert!(!power.is_apart_from(&Complex::integer(1)));
            }
            let (cosine, sine) = z.cosine_and_sine(BITS).unwrap();
            let turned = z.multiply(&Complex::imaginary_unit(), BITS).exponential(BITS).unwrap();
            let euler = cosine.add(&sine.multiply(&Complex::imaginary_unit(), BITS), BITS);
            prop_assert!(!euler.is_apart_from(&turned));
            let (cosh, sinh) = z.hyperbolic(BITS).unwrap();
            prop_assert!(!cosh.add(&sinh, BITS).is_apart_from(&z.exponential(BITS).unwrap()));
        }
    }

    #[test]
    fn the_cut_is_refused() {
        let near = super::super::interval::Interval::between(
            super::super::dyadic::Dyadic::power_of_two(-50).negated(),
            super::super::dyadic::Dyadic::power_of_two(-50),
        );
        let z = Complex {
            re: Real::integer(-2),
            im: Real::Enclosed(near.clone()),
        };
        assert!(z.square_root(BITS).is_none() && z.logarithm(BITS).is_none());
        let z = Complex::from(Real::Enclosed(near));
        let root = z.square_root(BITS).unwrap();
        assert!(root.re.may_vanish() && root.im.may_vanish());
        assert_eq!(complex(-4, 0, 1).square_root(BITS), Some(complex(0, 2, 1)));
    }
}
