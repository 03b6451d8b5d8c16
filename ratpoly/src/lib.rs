//! Exact sparse multivariate polynomials and rational functions over the integers and rationals.
