//! Integers that are worked on, outside of the kernels: contents, factors, constants.

use crate::coefficient::Value;
use crate::integer_gcd::integer_gcd;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::ToPrimitive;

/// An integer in 128 bits while it fits, then unbounded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Scalar {
    Small(i128),
    /// Never a value that fits 128 bits.
    Big(BigInt),
}

impl From<BigInt> for Scalar {
    fn from(value: BigInt) -> Self {
        match value.to_i128() {
            Some(small) => Scalar::Small(small),
            None => Scalar::Big(value),
        }
    }
}

impl From<&BigInt> for Scalar {
    fn from(value: &BigInt) -> Self {
        match value.to_i128() {
            Some(small) => Scalar::Small(small),
            None => Scalar::Big(value.clone()),
        }
    }
}

impl From<Scalar> for BigInt {
    fn from(value: Scalar) -> Self {
        match value {
            Scalar::Small(c) => c.into(),
            Scalar::Big(c) => c,
        }
    }
}

impl Scalar {
    pub fn value(&self) -> Value<'_> {
        match self {
            Scalar::Small(c) => Value::Small(*c),
            Scalar::Big(c) => Value::Big(c),
        }
    }

    pub fn is_one(&self) -> bool {
        matches!(self, Scalar::Small(1))
    }

    pub fn is_zero(&self) -> bool {
        matches!(self, Scalar::Small(0))
    }

    pub fn negated(self) -> Scalar {
        match self {
            Scalar::Small(c) if c != i128::MIN => Scalar::Small(-c),
            other => (-BigInt::from(other)).into(),
        }
    }

    pub fn plus(&self, other: &Scalar) -> Scalar {
        if let (Scalar::Small(a), Scalar::Small(b)) = (self, other)
            && let Some(sum) = a.checked_add(*b)
        {
            return Scalar::Small(sum);
        }
        (self.value().to_big() + other.value().to_big()).into()
    }

    pub fn times(&self, other: Value<'_>) -> Scalar {
        if let (Scalar::Small(a), Value::Small(b)) = (self, other)
            && let Some(product) = a.checked_mul(b)
        {
            return Scalar::Small(product);
        }
        (self.value().to_big() * other.to_big()).into()
    }

    /// The nonnegative greatest common divisor.
    pub fn gcd(&self, other: Value<'_>) -> Scalar {
        match (self, other) {
            (Scalar::Small(a), Value::Small(b)) => {
                let (a, b) = (a.unsigned_abs(), b.unsigned_abs());
                let gcd = match (u64::try_from(a), u64::try_from(b)) {
                    (Ok(a), Ok(b)) => u128::from(a.gcd(&b)),
                    _ => a.gcd(&b),
                };
                // 2^127 is the one magnitude that does not fit.
                i128::try_from(gcd).map_or_else(|_| BigInt::from(gcd).into(), Scalar::Small)
            }
            (a, b) => integer_gcd(&a.value().to_big(), &b.to_big()).into(),
        }
    }

    /// The quotient of a value by this scalar, if it divides (zero divides nothing here).
    pub fn divide(&self, value: Value<'_>) -> Option<Scalar> {
        match (value, self) {
            (_, Scalar::Small(0)) => None,
            (value, Scalar::Small(1)) => Some(value.to_scalar()),
            (Value::Small(a), Scalar::Small(b)) => match (i64::try_from(a), i64::try_from(*b)) {
                (Ok(a), Ok(b)) if b != -1 => (a % b == 0).then(|| Scalar::Small((a / b).into())),
                _ if *b == -1 => Some(Scalar::Small(a).negated()),
                _ => (a % b == 0).then(|| Scalar::Small(a / b)),
            },
            (a, b) => {
                let (quotient, remainder) = a.to_big().div_rem(&b.value().to_big());
                (remainder == BigInt::ZERO).then(|| quotient.into())
            }
        }
    }
}
