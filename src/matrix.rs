//! A rectangular array of values with its shape; no arithmetic of its own.
//!
//! Invariant: `entries.len() == rows * columns`, stored row by row, and no side is empty.

/// A matrix stored row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix<T> {
    rows: usize,
    columns: usize,
    entries: Vec<T>,
}

impl<T> Matrix<T> {
    /// The `rows x columns` matrix with the entry `entry(i, j)` (both from 0) at row i, column j.
    ///
    /// # Panics
    /// When a side is zero: the callers' shapes come from matrices that exist.
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> T) -> Self {
        assert!(rows > 0 && columns > 0, "a matrix has at least one entry");
        let entries = (0..rows * columns)
            .map(|k| entry(k / columns, k % columns))
            .collect();
        Matrix {
            rows,
            columns,
            entries,
        }
    }

    /// The matrix with these rows; `None` when they are ragged or empty.
    pub fn from_rows(rows: Vec<Vec<T>>) -> Option<Self> {
        let columns = rows.first()?.len();
        if columns == 0 || rows.iter().any(|row| row.len() != columns) {
            return None;
        }
        Some(Matrix {
            rows: rows.len(),
            columns,
            entries: rows.into_iter().flatten().collect(),
        })
    }

    /// Like [`Matrix::from_fn`], stopping at the first error.
    ///
    /// # Errors
    /// The first error of `entry`.
    pub fn try_from_fn<E>(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> Result<T, E>,
    ) -> Result<Self, E> {
        let entries = (0..rows * columns)
            .map(|k| entry(k / columns, k % columns))
            .collect::<Result<_, _>>()?;
        Ok(Matrix {
            rows,
            columns,
            entries,
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// `(rows, columns)`.
    pub fn shape(&self) -> (usize, usize) {
        (self.rows, self.columns)
    }

    /// Whether there are as many rows as columns.
    pub fn is_square(&self) -> bool {
        self.rows == self.columns
    }

    /// The entries, row by row.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.entries.iter()
    }

    /// The matrix of the images of the entries.
    pub fn map<U>(&self, image: impl FnMut(&T) -> U) -> Matrix<U> {
        Matrix {
            rows: self.rows,
            columns: self.columns,
            entries: self.entries.iter().map(image).collect(),
        }
    }

    /// Like [`Matrix::map`], stopping at the first error.
    ///
    /// # Errors
    /// The first error of `image`.
    pub fn try_map<U, E>(&self, image: impl FnMut(&T) -> Result<U, E>) -> Result<Matrix<U>, E> {
        Ok(Matrix {
            rows: self.rows,
            columns: self.columns,
            entries: self.entries.iter().map(image).collect::<Result<_, _>>()?,
        })
    }
}

impl<T: Clone> Matrix<T> {
    /// The transposed matrix.
    #[must_use]
    pub fn transpose(&self) -> Self {
        Matrix::from_fn(self.columns, self.rows, |i, j| self[(j, i)].clone())
    }

    /// The matrix without row `i` and column `j` (both from 0); `None` when nothing would be left.
    #[must_use]
    pub fn without(&self, i: usize, j: usize) -> Option<Self> {
        if self.rows < 2 || self.columns < 2 {
            return None;
        }
        Some(Matrix::from_fn(self.rows - 1, self.columns - 1, |r, c| {
            self[(r + usize::from(r >= i), c + usize::from(c >= j))].clone()
        }))
    }

    /// The leading principal submatrix of order `order`, `1 <= order <= min(rows, columns)`.
    #[must_use]
    pub fn leading(&self, order: usize) -> Self {
        Matrix::from_fn(order, order, |i, j| self[(i, j)].clone())
    }
}

impl<T> std::ops::Index<(usize, usize)> for Matrix<T> {
    type Output = T;
    fn index(&self, (i, j): (usize, usize)) -> &T {
        assert!(
            i < self.rows && j < self.columns,
            "entry outside the matrix"
        );
        &self.entries[i * self.columns + j]
    }
}

impl<T> std::ops::IndexMut<(usize, usize)> for Matrix<T> {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut T {
        assert!(
            i < self.rows && j < self.columns,
            "entry outside the matrix"
        );
        &mut self.entries[i * self.columns + j]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_and_entries() {
        let m = Matrix::from_fn(2, 3, |i, j| 10 * i + j);
        assert_eq!(m.shape(), (2, 3));
        assert_eq!(m.transpose()[(2, 1)], 12);
        assert_eq!(
            m.without(0, 1).unwrap(),
            Matrix::from_fn(1, 2, |_, j| 10 + 2 * j)
        );
        assert_eq!(Matrix::from_rows(vec![vec![1], vec![1, 2]]), None);
        assert_eq!(Matrix::<u8>::from_rows(vec![]), None);
        assert_eq!(Matrix::from_fn(1, 1, |_, _| 0).without(0, 0), None);
    }
}
