//! The table of methods: digits, operations, time.

use crate::methods::{AtPoint, Method, Methods, Row};

/// The head of the table; times only where they were measured.
pub fn head(time: bool) -> Vec<&'static str> {
    let mut head = vec![
        "method",
        "digits of the variance",
        "digits of P",
        "operations",
    ];
    if time {
        head.push("time");
    }
    head.push("");
    head
}

/// The cells of a row.
pub fn cells(row: &Row, time: bool) -> Vec<String> {
    let digits = |d: Option<f64>| d.map_or_else(|| "-".to_string(), |d| format!("{d:.1}"));
    let operations = row
        .operations
        .map_or_else(|| "-".to_string(), |n| n.to_string());
    let mut cells = vec![
        row.method.name().to_string(),
        digits(row.output),
        digits(row.covariance),
        operations,
    ];
    if time {
        cells.push(
            row.time
                .map_or_else(|| "-".to_string(), |ratio| format!("{ratio:.1}")),
        );
    }
    cells.push(row.remark.clone());
    cells
}

/// `reference, n = 4`.
pub fn title(at: &AtPoint) -> String {
    format!("{}, n = {}", at.point, at.order)
}

/// How much more the spectral integral costs than the first method, which solves the Lyapunov
/// equation: what the covariance analysis saves, and what it gives away.
pub fn headline(at: &AtPoint) -> Option<String> {
    let integral = at.rows.iter().find(|r| r.method == Method::Quadrature)?;
    let solved = at.rows.first()?;
    let ratio = integral.operations? as f64 / solved.operations? as f64;
    Some(format!(
        "the spectral integral takes {ratio:.0} times the operations of {} ({:.1} digits against {:.1})",
        solved.method.name(),
        integral.output?,
        solved.output?
    ))
}

/// For a terminal.
pub fn plain(methods: &Methods, time: bool) -> String {
    let mut out = format!(
        "{}\n{}\nsimulation with seed {}\n",
        methods.title, methods.document, methods.seed
    );
    for at in &methods.points {
        let mut rows = vec![
            head(time)
                .into_iter()
                .map(String::from)
                .collect::<Vec<String>>(),
        ];
        rows.extend(at.rows.iter().map(|row| cells(row, time)));
        let width = |k: usize| {
            let lengths = rows.iter().map(|row| row[k].chars().count());
            lengths.max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
        out += &format!("\n{}\n", title(at));
        for row in &rows {
            let mut line = String::new();
            for (k, cell) in row.iter().enumerate() {
                let width = widths[k];
                // Numbers to the right.
                line += &if k == 0 || k + 1 == row.len() {
                    format!(" {cell:<width$} ")
                } else {
                    format!(" {cell:>width$} ")
                };
            }
            out += line.trim_end();
            out.push('\n');
        }
        if let Some(line) = headline(at) {
            out += &format!(" {line}\n");
        }
    }
    out
}
