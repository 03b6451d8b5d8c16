//! Operation counts: additions and multiplications of the dense kernels, leading terms.
//!
//! They follow Golub & Van Loan, *Matrix Computations* (4th ed. 2013), so that methods can be
//! compared by a number that no machine changes. A complex operation counts as four real ones.

/// A product of an `m x k` by a `k x n` matrix.
pub fn product(m: usize, k: usize, n: usize) -> u64 {
    2 * (m as u64) * (k as u64) * (n as u64)
}

/// The LU factors of an `n x n` matrix by partial pivoting (section 3.4).
pub fn lu(n: usize) -> u64 {
    let n = n as u64;
    2 * n * n * n / 3
}

/// Both triangular solves for `columns` right-hand sides of `n` entries.
pub fn triangular_solves(n: usize, columns: usize) -> u64 {
    2 * (n as u64) * (n as u64) * (columns as u64)
}

/// The real Schur form with its orthogonal matrix (section 7.5.6): about `25 n^3`.
pub fn real_schur(n: usize) -> u64 {
    let n = n as u64;
    25 * n * n * n
}

/// The spectral decomposition of a symmetric matrix with its vectors (section 8.3.3): about `9 n^3`.
pub fn symmetric_eigen(n: usize) -> u64 {
    let n = n as u64;
    9 * n * n * n
}

/// A complex operation in real ones.
pub const COMPLEX: u64 = 4;
