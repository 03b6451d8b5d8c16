//! Complex numbers in floating point, with principal values: what the independent evaluator counts in.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

impl Complex {
    /// A real number.
    pub fn real(re: f64) -> Self {
        Complex { re, im: 0.0 }
    }

    /// The imaginary unit.
    pub const I: Complex = Complex { re: 0.0, im: 1.0 };

    /// The modulus.
    pub fn modulus(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// Whether both parts are numbers of a size that says something.
    pub fn is_usable(self) -> bool {
        self.modulus().is_finite() && self.modulus() < 1e8
    }

    pub fn exp(self) -> Self {
        let r = self.re.exp();
        Complex {
            re: r * self.im.cos(),
            im: r * self.im.sin(),
        }
    }

    pub fn ln(self) -> Self {
        Complex {
            re: self.modulus().ln(),
            im: self.im.atan2(self.re),
        }
    }

    pub fn sqrt(self) -> Self {
        if self.modulus() == 0.0 {
            return Complex::real(0.0);
        }
        // Exact zeros stay exact, so that the cut is met from its upper side.
        if self.im == 0.0 {
            return if self.re >= 0.0 {
                Complex::real(self.re.sqrt())
            } else {
                Complex {
                    re: 0.0,
                    im: (-self.re).sqrt(),
                }
            };
        }
        let r = ((self.modulus() + self.re) / 2.0).max(0.0).sqrt();
        let i = ((self.modulus() - self.re) / 2.0).max(0.0).sqrt();
        Complex {
            re: r,
            im: i.copysign(self.im),
        }
    }

    /// The principal value of a power; none of zero to what is not positive.
    pub fn power(self, exponent: Complex) -> Option<Self> {
        if exponent.im == 0.0 && exponent.re.fract() == 0.0 && exponent.re.abs() < 64.0 {
            let n = exponent.re.abs() as u32;
            let whole = (0..n).fold(Complex::real(1.0), |p, _| p * self);
            return match exponent.re >= 0.0 {
                true => Some(whole),
                false if whole.modulus() == 0.0 => None,
                false => Some(Complex::real(1.0) / whole),
            };
        }
        if self.modulus() == 0.0 {
            return (exponent.re > 0.0).then_some(self);
        }
        Some((self.ln() * exponent).exp())
    }

    pub fn cosh(self) -> Self {
        (self.exp() + (-self).exp()) / Complex::real(2.0)
    }

    pub fn sinh(self) -> Self {
        (self.exp() - (-self).exp()) / Complex::real(2.0)
    }

    pub fn cos(self) -> Self {
        (Complex::I * self).cosh()
    }

    pub fn sin(self) -> Self {
        (Complex::I * self).sinh() / Complex::I
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Complex {
            re: self.re + o.re,
            im: self.im + o.im,
        }
    }
}
impl Sub for Complex {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}
impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Complex {
            re: -self.re,
            // Minus a real number is real: the cut is met from above on both sides.
            im: if self.im == 0.0 { 0.0 } else { -self.im },
        }
    }
}
impl Mul for Complex {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        if self.im == 0.0 && o.im == 0.0 {
            return Complex::real(self.re * o.re);
        }
        Complex {
            re: self.re * o.re - self.im * o.im,
            im: self.re * o.im + self.im * o.re,
        }
    }
}
impl Div for Complex {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        if self.im == 0.0 && o.im == 0.0 {
            return Complex::real(self.re / o.re);
        }
        let d = o.re * o.re + o.im * o.im;
        Complex {
            re: (self.re * o.re + self.im * o.im) / d,
            im: (self.im * o.re - self.re * o.im) / d,
        }
    }
}
