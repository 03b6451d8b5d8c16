//! Dense polynomials in one variable over a prime field.
//!
//! The zero polynomial is the empty slice; results are trimmed, that is they end with a non-zero
//! coefficient. Everything is quadratic: the degrees met here are those of small images.

use crate::modular::PrimeField;

/// Removes leading zeros.
#[inline]
pub fn trim(f: &mut Vec<u64>) {
    while f.last() == Some(&0) {
        f.pop();
    }
}

/// The value at a point, by Horner's rule.
#[inline]
pub fn evaluate(field: &PrimeField, f: &[u64], point: u64) -> u64 {
    f.iter()
        .rev()
        .fold(0, |value, &c| field.add(field.mul(value, point), c))
}

/// f + g.
pub fn add(field: &PrimeField, f: &[u64], g: &[u64]) -> Vec<u64> {
    let (short, long) = if f.len() < g.len() { (f, g) } else { (g, f) };
    let mut sum = long.to_vec();
    for (s, &c) in sum.iter_mut().zip(short) {
        *s = field.add(*s, c);
    }
    trim(&mut sum);
    sum
}

/// f - g.
pub fn sub(field: &PrimeField, f: &[u64], g: &[u64]) -> Vec<u64> {
    let mut difference = f.to_vec();
    sub_assign(field, &mut difference, g);
    difference
}

/// f -= g.
pub fn sub_assign(field: &PrimeField, f: &mut Vec<u64>, g: &[u64]) {
    if f.len() < g.len() {
        f.resize(g.len(), 0);
    }
    for (s, &c) in f.iter_mut().zip(g) {
        *s = field.sub(*s, c);
    }
    trim(f);
}

/// f·g.
pub fn mul(field: &PrimeField, f: &[u64], g: &[u64]) -> Vec<u64> {
    if f.is_empty() || g.is_empty() {
        return Vec::new();
    }
    let mut product = Vec::with_capacity(f.len() + g.len() - 1);
    for k in 0..f.len() + g.len() - 1 {
        let low = k.saturating_sub(g.len() - 1);
        let high = k.min(f.len() - 1);
        product.push(convolution(field, &f[low..=high], &g[k - high..=k - low]));
    }
    product
}

/// Σ fᵢ·g_{n-1-i} for slices of equal length. A product is below 2¹²⁴, so that four of them stay below
/// p·2⁶⁴ only if p is above 2⁶²·(1 - ε); the sum is therefore cut back after every addition.
#[inline]
fn convolution(field: &PrimeField, f: &[u64], g: &[u64]) -> u64 {
    let ceiling = u128::from(field.modulus()) << 64;
    let mut sum = 0u128;
    for (&a, &b) in f.iter().zip(g.iter().rev()) {
        sum += u128::from(a) * u128::from(b);
        if sum >= ceiling {
            sum -= ceiling;
        }
    }
    field.reduce(sum)
}

/// f².
pub fn square(field: &PrimeField, f: &[u64]) -> Vec<u64> {
    mul(field, f, f)
}

/// c·f.
pub fn scale(field: &PrimeField, f: &mut [u64], c: u64) {
    for coefficient in f {
        *coefficient = field.mul(*coefficient, c);
    }
}

/// f(c·x) in place.
pub fn scale_variable(field: &PrimeField, f: &mut [u64], c: u64) {
    let mut power = field.one();
    for coefficient in f {
        *coefficient = field.mul(*coefficient, power);
        power = field.mul(power, c);
    }
}

/// f divided by its leading coefficient; zero stays zero.
pub fn monic(field: &PrimeField, f: &mut [u64]) {
    if let Some(&leading) = f.last()
        && leading != field.one()
    {
        let inverse = field
            .inverse(leading)
            .expect("a leading coefficient is not zero");
        scale(field, f, inverse);
    }
}

/// Quotient and remainder.
///
/// # Panics
///
/// If `g` is zero.
pub fn div_rem(field: &PrimeField, f: &[u64], g: &[u64]) -> (Vec<u64>, Vec<u64>) {
    let leading = *g.last().expect("a divisor that is not zero");
    let mut remainder = f.to_vec();
    if f.len() < g.len() {
        return (Vec::new(), remainder);
    }
    let inverse = if leading == field.one() {
        leading
    } else {
        field
            .inverse(leading)
            .expect("a leading coefficient is not zero")
    };
    let mut quotient = vec![0; f.len() - g.len() + 1];
    let tail = &g[..g.len() - 1];
    for shift in (0..quotient.len()).rev() {
        let top = remainder.pop().expect("as long as the quotient");
        let q = field.mul(top, inverse);
        quotient[shift] = q;
        if q != 0 {
            let minus_q = field.neg(q);
            for (r, &c) in remainder[shift..].iter_mut().zip(tail) {
                *r = field.add(*r, field.mul(minus_q, c));
            }
        }
    }
    trim(&mut remainder);
    (quotient, remainder)
}

/// The remainder of f by g.
///
/// # Panics
///
/// If `g` is zero.
pub fn rem(field: &PrimeField, f: &[u64], g: &[u64]) -> Vec<u64> {
    div_rem(field, f, g).1
}

/// The monic greatest common divisor; zero if both are zero.
pub fn gcd(field: &PrimeField, f: &[u64], g: &[u64]) -> Vec<u64> {
    let mut divisor = gcd_up_to_unit(field, f.to_vec(), g.to_vec());
    monic(field, &mut divisor);
    divisor
}

/// A greatest common divisor with any leading coefficient, which saves the inversion.
///
/// Euclid's algorithm without inversions: a step by a quotient of degree one, by far the commonest, is
/// a·l² - (q₁x + q₀)·b with three products and one reduction for each coefficient.
pub fn gcd_up_to_unit(field: &PrimeField, mut f: Vec<u64>, mut g: Vec<u64>) -> Vec<u64> {
    if f.len() < g.len() {
        std::mem::swap(&mut f, &mut g);
    }
    while g.len() > 1 {
        let n = g.len();
        let l = g[n - 1];
        if f.len() == n + 1 {
            let minus_q1 = field.neg(field.mul(f[n], l));
            let minus_q0 = field.neg(field.mul_sub_mul(f[n - 1], l, f[n], g[n - 2]));
            let l2 = field.mul(l, l);
            f.truncate(n - 1);
            let mut below = 0;
            for (a, &b) in f.iter_mut().zip(&g) {
                let sum = u128::from(*a) * u128::from(l2)
                    + u128::from(minus_q1) * u128::from(below)
                    + u128::from(minus_q0) * u128::from(b);
                *a = field.reduce(sum);
                below = b;
            }
        } else {
            while f.len() >= n {
                let top = f.pop().expect("not empty");
                let shift = f.len() + 1 - n;
                let (low, high) = f.split_at_mut(shift);
                for a in low {
                    *a = field.mul(*a, l);
                }
                let minus_top = field.neg(top);
                for (a, &b) in high.iter_mut().zip(&g) {
                    *a = field.reduce(
                        u128::from(*a) * u128::from(l) + u128::from(minus_top) * u128::from(b),
                    );
                }
                trim(&mut f);
            }
        }
        trim(&mut f);
        std::mem::swap(&mut f, &mut g);
    }
    if g.is_empty() { f } else { g }
}

/// (d, s, t) with s·f + t·g = d, the monic greatest common divisor.
pub fn extended_gcd(field: &PrimeField, f: &[u64], g: &[u64]) -> (Vec<u64>, Vec<u64>, Vec<u64>) {
    let (mut r0, mut r1) = (f.to_vec(), g.to_vec());
    let (mut s0, mut s1) = (vec![field.one()], Vec::new());
    let (mut t0, mut t1) = (Vec::new(), vec![field.one()]);
    while !r1.is_empty() {
        let (quotient, remainder) = div_rem(field, &r0, &r1);
        let s = sub(field, &s0, &mul(field, &quotient, &s1));
        let t = sub(field, &t0, &mul(field, &quotient, &t1));
        (r0, r1, s0, s1, t0, t1) = (r1, remainder, s1, s, t1, t);
    }
    if let Some(&leading) = r0.last() {
        let inverse = field
            .inverse(leading)
            .expect("a leading coefficient is not zero");
        for f in [&mut r0, &mut s0, &mut t0] {
            scale(field, f, inverse);
        }
    } else {
        (s0, t0) = (Vec::new(), Vec::new());
    }
    (r0, s0, t0)
}

/// The derivative.
pub fn derivative(field: &PrimeField, f: &[u64]) -> Vec<u64> {
    let mut result = Vec::with_capacity(f.len());
    let mut exponent = 0;
    for &c in f.iter().skip(1) {
        exponent = field.add(exponent, field.one());
        result.push(field.mul(c, exponent));
    }
    trim(&mut result);
    result
}

/// Whether f has no repeated factor; zero counts as repeated.
pub fn is_square_free(field: &PrimeField, f: &[u64]) -> bool {
    match f.len() {
        0 => false,
        1 => true,
        _ => gcd_up_to_unit(field, f.to_vec(), derivative(field, f)).len() == 1,
    }
}

/// base^exponent modulo f.
pub fn pow_mod(field: &PrimeField, base: &[u64], exponent: u64, f: &[u64]) -> Vec<u64> {
    let mut power = rem(field, &[field.one()], f);
    if exponent == 0 {
        return power;
    }
    let base = rem(field, base, f);
    for bit in (0..64 - exponent.leading_zeros()).rev() {
        power = rem(field, &square(field, &power), f);
        if exponent >> bit & 1 == 1 {
            power = rem(field, &mul(field, &power, &base), f);
        }
    }
    power
}

/// The polynomial of degree below the number of points with the given values, by Newton's divided
/// differences; `None` when two points are equal.
pub fn interpolate(field: &PrimeField, points: &[u64], values: &[u64]) -> Option<Vec<u64>> {
    let mut result = Vec::with_capacity(points.len());
    let mut master = vec![field.one()];
    for (&point, &value) in points.iter().zip(values) {
        let inverse = field.inverse(evaluate(field, &master, point))?;
        let step = field.mul(field.sub(value, evaluate(field, &result, point)), inverse);
        result.resize(master.len(), 0);
        for (r, &m) in result.iter_mut().zip(&master) {
            *r = field.add(*r, field.mul(step, m));
        }
        master.push(0);
        for i in (0..master.len()).rev() {
            let shifted = if i == 0 { 0 } else { master[i - 1] };
            master[i] = field.sub(shifted, field.mul(point, master[i]));
        }
    }
    trim(&mut result);
    Some(result)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const PRIMES: [u64; 4] = [5, 101, 2147483647, (1 << 62) - 57];

    /// A prime field and polynomials over it, zero and constants among them.
    fn polynomials(count: usize) -> impl Strategy<Value = (PrimeField, Vec<Vec<u64>>)> {
        let polynomial =
            prop::collection::vec(prop_oneof![Just(0u64), 0u64..4, any::<u64>()], 0..9);
        (0usize..4, prop::collection::vec(polynomial, count)).prop_map(|(which, polynomials)| {
            let field = PrimeField::new(PRIMES[which]).unwrap();
            let polynomials = polynomials
                .into_iter()
                .map(|f| {
                    let mut f: Vec<u64> = f.into_iter().map(|c| field.from_u64(c)).collect();
                    trim(&mut f);
                    f
                })
                .collect();
            (field, polynomials)
        })
    }

    proptest! {
        #[test]
        fn ring_laws((field, p) in polynomials(3)) {
            let (f, g, h) = (&p[0], &p[1], &p[2]);
            prop_assert_eq!(mul(&field, f, g), mul(&field, g, f));
            let left = mul(&field, f, &add(&field, g, h));
            prop_assert_eq!(&left, &add(&field, &mul(&field, f, g), &mul(&field, f, h)));
            prop_assert_eq!(sub(&field, &add(&field, f, g), g), f.clone());
            let point = field.from_u64(12345);
            let product = field.mul(evaluate(&field, f, point), evaluate(&field, g, point));
            prop_assert_eq!(evaluate(&field, &mul(&field, f, g), point), product);
            // Leibniz.
            let both = add(&field, &mul(&field, &derivative(&field, f), g), &mul(&field, f, &derivative(&field, g)));
            prop_assert_eq!(derivative(&field, &mul(&field, f, g)), both);
        }

        #[test]
        fn division((field, p) in polynomials(2)) {
            let (f, g) = (&p[0], &p[1]);
            prop_assume!(!g.is_empty());
            let (q, r) = div_rem(&field, f, g);
            prop_assert!(r.len() < g.len());
            prop_assert_eq!(add(&field, &mul(&field, &q, g), &r), f.clone());
        }

        #[test]
        fn greatest_common_divisors((field, p) in polynomials(3)) {
            let (f, g) = (mul(&field, &p[0], &p[2]), mul(&field, &p[1], &p[2]));
            let d = gcd(&field, &f, &g);
            let (e, s, t) = extended_gcd(&field, &f, &g);
            prop_assert_eq!(&d, &e);
            prop_assert_eq!(&add(&field, &mul(&field, &s, &f), &mul(&field, &t, &g)), &d);
            if d.is_empty() {
                prop_assert!(f.is_empty() && g.is_empty());
            } else {
                prop_assert!(rem(&field, &f, &d).is_empty() && rem(&field, &g, &d).is_empty());
                prop_assert!(p[2].is_empty() || rem(&field, &d, &p[2]).is_empty());
            }
        }

        #[test]
        fn interpolation_inverts_evaluation((field, p) in polynomials(1)) {
            let count = 9.min(field.modulus());
            prop_assume!(p[0].len() as u64 <= count);
            let points: Vec<u64> = (0..count).map(|i| field.from_u64(i)).collect();
            let values: Vec<u64> = points.iter().map(|&x| evaluate(&field, &p[0], x)).collect();
            prop_assert_eq!(interpolate(&field, &points, &values), Some(p[0].clone()));
        }

        #[test]
        fn powers((field, p) in polynomials(2), exponent in 0u64..50) {
            let (base, f) = (&p[0], &p[1]);
            prop_assume!(!f.is_empty());
            let plain = (0..exponent).fold(vec![field.one()], |power, _| mul(&field, &power, base));
            prop_assert_eq!(pow_mod(&field, base, exponent, f), rem(&field, &plain, f));
        }

        #[test]
        fn squares_are_found((field, p) in polynomials(2)) {
            prop_assume!(p[0].len() > 1 && !p[1].is_empty());
            prop_assert!(!is_square_free(&field, &mul(&field, &square(&field, &p[0]), &p[1])));
        }
    }

    #[test]
    fn equal_points_are_refused() {
        let field = PrimeField::new(101).unwrap();
        assert_eq!(interpolate(&field, &[1, 1], &[2, 3]), None);
        assert!(!is_square_free(&field, &[]) && is_square_free(&field, &[5]));
    }
}
