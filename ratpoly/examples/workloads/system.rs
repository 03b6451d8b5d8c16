//! The linear systems `x' = A x + B w`, driven by white noise.

use ratpoly::{Error, Matrix, Order, Polynomial, Ring};

/// A system with polynomial entries.
pub struct System {
    pub ring: Ring,
    pub a: Matrix<Polynomial>,
    pub b: Vec<Polynomial>,
}

impl System {
    /// The system with the given entries in the plain notation.
    pub fn new(letters: &[String], rows: &[Vec<String>], input: &[String]) -> Result<Self, Error> {
        let ring = Ring::new(letters.iter().cloned(), Order::Lex)?;
        let parse = |text: &String| Polynomial::parse(ring, text);
        let rows: Vec<Vec<Polynomial>> = rows
            .iter()
            .map(|row| row.iter().map(parse).collect())
            .collect::<Result<_, _>>()?;
        Ok(System {
            ring,
            a: Matrix::<Polynomial>::new(ring, rows)?,
            b: input.iter().map(parse).collect::<Result<_, _>>()?,
        })
    }

    /// The number of states.
    pub fn size(&self) -> usize {
        self.b.len()
    }
}

/// The quarter car in the letters a to e, on a road that is white noise (`w1`), noise through shape filter I
/// (`w6a`), through a filter of second order (`w6b`), through shape filter II (`w6c`).
pub fn quarter_car(name: &str) -> Result<System, Error> {
    let (n, letters) = match name {
        "w1" => (4, 5),
        "w6a" => (5, 6),
        "w6b" => (6, 7),
        _ => (6, 8),
    };
    let car = [
        ["0", "0", "1", "0"],
        ["0", "0", "0", "1"],
        ["-a", "a", "-d", "d"],
        ["b", "-b-c", "e", "-e"],
    ];
    let mut rows = vec![vec!["0".to_string(); n]; n];
    let mut input = vec!["0".to_string(); n];
    for (row, entries) in rows.iter_mut().zip(car) {
        for (slot, text) in row.iter_mut().zip(entries) {
            *slot = text.to_string();
        }
    }
    let mut set = |i: usize, j: usize, text: &str| rows[i][j] = text.to_string();
    match name {
        "w1" => input[3] = "c".into(),
        "w6a" => {
            set(3, 4, "c");
            set(4, 4, "-f");
        }
        _ => {
            set(3, 4, if name == "w6b" { "c" } else { "c*h" });
            if name == "w6c" {
                set(3, 5, "c");
            }
            set(4, 5, "1");
            set(5, 4, "-g");
            set(5, 5, "-f");
        }
    }
    if n > 4 {
        input[n - 1] = "1".into();
    }
    let names: Vec<String> = ["a", "b", "c", "d", "e", "f", "g", "h"][..letters]
        .iter()
        .map(|s| s.to_string())
        .collect();
    System::new(&names, &rows, &input)
}
