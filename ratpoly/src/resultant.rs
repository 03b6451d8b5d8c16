//! Resultants, subresultants and discriminants with respect to one variable, by the subresultant
//! polynomial remainder sequence (Collins 1967; Brown 1978; in the formulation of Ducos 2000).

use crate::budget::Budget;
use crate::error::Error;
use crate::polynomial::Polynomial;

/// The resultant in one variable: `lc(f)^n lc(g)^m` times the product of all differences of roots of `f`
/// (degree `m`) and roots of `g` (degree `n`), the determinant of Sylvester's matrix. Zero if an operand
/// is zero; otherwise zero exactly if the two have a common factor in which the variable occurs.
pub fn resultant(f: &Polynomial, g: &Polynomial, variable: usize) -> Result<Polynomial, Error> {
    resultant_within(f, g, variable, &Budget::unlimited())
}

/// [`resultant`] within a budget.
pub fn resultant_within(
    f: &Polynomial,
    g: &Polynomial,
    variable: usize,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    check(f, g, variable)?;
    let ring = f.ring();
    let (Some(m), Some(n)) = (f.degree(variable), g.degree(variable)) else {
        return Ok(Polynomial::zero(ring));
    };
    if m < n {
        let swapped = resultant_within(g, f, variable, budget)?;
        return Ok(if m % 2 == 1 && n % 2 == 1 {
            -swapped
        } else {
            swapped
        });
    }
    if n == 0 {
        return g.pow_within(m, budget);
    }
    let (mut a, mut b) = (f.coefficients_in(variable), g.coefficients_in(variable));
    // s is the leading coefficient of the last regular subresultant, 1 to begin with in degree m.
    let first = power(&b[b.len() - 1], (m - n) as usize, budget)?;
    let mut s = first.clone();
    let rest = pseudo_remainder(&a, &b, budget)?;
    // prem(a, -b) = (-1)^(m - n + 1) prem(a, b).
    a = std::mem::replace(&mut b, signed(rest, m - n + 1));
    // Now a is the subresultant of degree n (its formal leading coefficient is lc(a), s = lc^(m-n)).
    loop {
        let (d, Some(e)) = (a.len() - 1, b.len().checked_sub(1)) else {
            return Ok(Polynomial::zero(ring));
        };
        let gap = d - e;
        // The next subresultant of degree e: b if the gap is 1, otherwise lc(b)^(gap-1) b / s^(gap-1).
        let c = if gap > 1 {
            scaled_quotient(
                &b,
                &power(&b[e], gap - 1, budget)?,
                &power(&s, gap - 1, budget)?,
                budget,
            )?
        } else {
            b.clone()
        };
        if e == 0 {
            return Ok(c
                .into_iter()
                .next()
                .unwrap_or_else(|| Polynomial::zero(ring)));
        }
        // S_(e-1) = prem(a, -b) / (s^gap lc(a)).
        let divisor = power(&s, gap, budget)?.mul_within(&a[d], budget)?;
        let gap = u32::try_from(gap).map_err(|_| Error::ExponentOverflow)?;
        let rest = signed(pseudo_remainder(&a, &b, budget)?, gap + 1);
        let rest = rest.iter().map(|p| exact(p, &divisor)).collect();
        a = c;
        b = trim(rest);
        s = a[e].clone();
    }
}

/// The subresultants `S_0, ..., S_(n-1)` of polynomials of degrees `m >= n >= 1` in the variable: `S_j` has
/// degree at most `j`, its coefficient of degree `j` is the principal subresultant coefficient, `S_0` is
/// the resultant. By their definition as determinants of Sylvester's matrix, found from the remainder
/// sequence. The operands have a common factor of degree `k` exactly if `S_0, ..., S_(k-1)` vanish and
/// `S_k` does not; then `S_k` is that factor up to a factor free of the variable.
pub fn subresultants(
    f: &Polynomial,
    g: &Polynomial,
    variable: usize,
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    check(f, g, variable)?;
    let ring = f.ring();
    let (Some(m), Some(n)) = (f.degree(variable), g.degree(variable)) else {
        return Err(Error::Unsupported("an operand is zero"));
    };
    if m < n || n == 0 {
        return Err(Error::Unsupported("the degrees must satisfy m >= n >= 1"));
    }
    let mut all = vec![Polynomial::zero(ring); n as usize];
    let join = |c: &[Polynomial]| Polynomial::from_coefficients_in(ring, variable, c);
    let (mut a, mut b) = (f.coefficients_in(variable), g.coefficients_in(variable));
    let mut s = power(&b[b.len() - 1], (m - n) as usize, budget)?;
    let rest = pseudo_remainder(&a, &b, budget)?;
    a = std::mem::replace(&mut b, signed(rest, m - n + 1));
    while let Some(e) = b.len().checked_sub(1) {
        let d = a.len() - 1;
        let gap = d - e;
        all[d - 1] = join(&b)?;
        let c = if gap > 1 {
            let (top, bottom) = (power(&b[e], gap - 1, budget)?, power(&s, gap - 1, budget)?);
            let c = scaled_quotient(&b, &top, &bottom, budget)?;
            all[e] = join(&c)?;
            c
        } else {
            b.clone()
        };
        if e == 0 {
            break;
        }
        let divisor = power(&s, gap, budget)?.mul_within(&a[d], budget)?;
        let gap = u32::try_from(gap).map_err(|_| Error::ExponentOverflow)?;
        let rest = signed(pseudo_remainder(&a, &b, budget)?, gap + 1);
        a = c;
        b = trim(rest.iter().map(|p| exact(p, &divisor)).collect());
        s = a[e].clone();
    }
    Ok(all)
}

/// The discriminant in one variable: `(-1)^(n(n-1)/2) resultant(f, f') / lc(f)` for degree `n >= 1`.
pub fn discriminant(f: &Polynomial, variable: usize) -> Result<Polynomial, Error> {
    discriminant_within(f, variable, &Budget::unlimited())
}

/// [`discriminant`] within a budget.
pub fn discriminant_within(
    f: &Polynomial,
    variable: usize,
    budget: &Budget,
) -> Result<Polynomial, Error> {
    check(f, f, variable)?;
    let n = match f.degree(variable) {
        None | Some(0) => return Err(Error::Unsupported("the variable does not occur")),
        Some(n) => u64::from(n),
    };
    let slope = f.derivative(variable);
    let r = resultant_within(f, &slope, variable, budget)?;
    let lead = f
        .coefficients_in(variable)
        .pop()
        .expect("the degree is positive");
    let quotient = exact(&r, &lead);
    Ok(if n * (n - 1) / 2 % 2 == 1 {
        -quotient
    } else {
        quotient
    })
}

fn check(f: &Polynomial, g: &Polynomial, variable: usize) -> Result<(), Error> {
    if f.ring() != g.ring() {
        return Err(Error::RingMismatch);
    }
    if variable >= f.ring().len() {
        return Err(Error::VariableOutOfRange(variable));
    }
    Ok(())
}

/// The coefficients of the pseudo-remainder `lc(b)^(d - e + 1) a mod b`; see
/// [`Polynomial::pseudo_div_rem`].
fn pseudo_remainder(
    a: &[Polynomial],
    b: &[Polynomial],
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    let mut rest = a.to_vec();
    let e = b.len() - 1;
    for top in (e..a.len()).rev() {
        let head = rest.pop().expect("the degree is at least e");
        for (k, c) in rest.iter_mut().enumerate() {
            let mut value = c.mul_within(&b[e], budget)?;
            if k + e >= top && !head.is_zero() {
                value = value.try_sub(&head.mul_within(&b[k + e - top], budget)?)?;
            }
            *c = value;
        }
    }
    Ok(trim(rest))
}

fn power(f: &Polynomial, exponent: usize, budget: &Budget) -> Result<Polynomial, Error> {
    let exponent = u32::try_from(exponent).map_err(|_| Error::ExponentOverflow)?;
    f.pow_within(exponent, budget)
}

/// Every coefficient times `top / bottom`, which is known to be exact.
fn scaled_quotient(
    f: &[Polynomial],
    top: &Polynomial,
    bottom: &Polynomial,
    budget: &Budget,
) -> Result<Vec<Polynomial>, Error> {
    f.iter()
        .map(|p| Ok(exact(&p.mul_within(top, budget)?, bottom)))
        .collect()
}

fn signed(f: Vec<Polynomial>, exponent: u32) -> Vec<Polynomial> {
    if exponent % 2 == 1 {
        f.iter().map(|p| -p).collect()
    } else {
        f
    }
}

fn exact(f: &Polynomial, divisor: &Polynomial) -> Polynomial {
    if divisor.is_one() {
        return f.clone();
    }
    f.div_exact(divisor)
        .expect("exact by the theory of subresultants")
}

fn trim(mut f: Vec<Polynomial>) -> Vec<Polynomial> {
    while f.last().is_some_and(Polynomial::is_zero) {
        f.pop();
    }
    f
}
