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

/// A chain of unit masses, `n` states: link `i` between mass `i` and the next has the stiffness `c_i` and the
/// damping `d_i`, the last mass stands on the road by a spring `c`. With an odd number of states the road is
/// noise through a filter of first order with the corner `f`. There are `n - 1` letters.
pub fn chain(n: usize) -> Result<System, Error> {
    let masses = n / 2;
    let mut letters = vec!["c".to_string()];
    for i in 1..masses {
        letters.extend([format!("c{i}"), format!("d{i}")]);
    }
    let mut rows = vec![vec![String::from("0"); n]; n];
    let mut input = vec![String::from("0"); n];
    let mut add = |i: usize, j: usize, text: String| rows[i][j].push_str(&text);
    for i in 0..masses {
        add(i, masses + i, "+1".into());
        for (low, high) in [(i, i + 1), (i.wrapping_sub(1), i)] {
            // The links above and below: number `k` joins the masses `k - 1` and `k`.
            if high < masses && low < masses {
                let other = if low == i { high } else { low };
                for (offset, kind) in [(0, "c"), (masses, "d")] {
                    add(masses + i, offset + i, format!("-{kind}{high}"));
                    add(masses + i, offset + other, format!("+{kind}{high}"));
                }
            }
        }
    }
    add(2 * masses - 1, masses - 1, "-c".into());
    if n % 2 == 1 {
        letters.push("f".into());
        add(2 * masses - 1, n - 1, "+c".into());
        add(n - 1, n - 1, "-f".into());
        input[n - 1] = "1".into();
    } else {
        input[n - 1] = "c".into();
    }
    System::new(&letters, &rows, &input)
}

/// The letters of the half car: reciprocals of body mass and inertia, distances of the axles, springs,
/// dampers, reciprocals of the wheel masses, tyres; front, then rear.
pub const HALF_CAR: [&str; 12] = ["u", "j", "p", "q", "a", "b", "d", "e", "v", "w", "g", "h"];

/// The half car with white noise under the front wheel (`axle` 0) or the rear wheel (1): heave, pitch, two
/// wheels, and their velocities. The letters beyond the first `free` of [`HALF_CAR`] are replaced by small numbers.
pub fn half_car(axle: usize, free: usize) -> Result<System, Error> {
    let numbers = ["1", "1", "2", "3", "2", "3", "1", "2", "5", "4", "7", "9"];
    let letter = |k: usize| if k < free { HALF_CAR[k] } else { numbers[k] };
    let [u, j, p, q, a, b, d, e, v, w, g, h] = std::array::from_fn(letter);
    let mut rows = vec![vec![String::from("0"); 8]; 8];
    for i in 0..4 {
        rows[i][4 + i] = "1".into();
    }
    // The force of each suspension by displacements (offset 0) and velocities (offset 4): the coefficients of
    // heave, pitch and the wheel.
    for (offset, front, rear) in [(0, a, b), (4, d, e)] {
        let axles = [(front, format!("-{p}"), 2, v), (rear, q.to_string(), 3, w)];
        for (stiffness, arm, wheel, mobility) in axles {
            let deflection = [(0, "1".to_string()), (1, arm.clone()), (wheel, "-1".into())];
            for (column, factor) in deflection {
                let force = format!("{stiffness}*({factor})");
                rows[4][offset + column].push_str(&format!("-{u}*{force}"));
                rows[5][offset + column].push_str(&format!("-{j}*({arm})*{force}"));
                rows[4 + wheel][offset + column].push_str(&format!("+{mobility}*{force}"));
            }
        }
    }
    rows[6][2].push_str(&format!("-{v}*{g}"));
    rows[7][3].push_str(&format!("-{w}*{h}"));
    let mut input = vec![String::from("0"); 8];
    input[6 + axle] = if axle == 0 {
        format!("{v}*{g}")
    } else {
        format!("{w}*{h}")
    };
    let letters: Vec<String> = HALF_CAR[..free].iter().map(|s| s.to_string()).collect();
    System::new(&letters, &rows, &input)
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
