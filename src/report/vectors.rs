//! Reference vectors for other implementations: exact values at the document's named points,
//! each with the nearest double. The shape is `schemas/vectors.schema.json`.

use crate::audit::Audit;
use crate::evaluate::Value;
use crate::inspection::Inspection;
use crate::numeric::agreement::nearest;
use crate::report::json::{Software, sha256};
use crate::report::ordered::Ordered;
use crate::report::values::Quantities;
use num_rational::BigRational;
use ratpoly::RationalFunction;
use serde::Serialize;

/// The whole file.
#[derive(Debug, Serialize)]
pub struct Vectors {
    software: Software,
    documents: Vec<Document>,
}

#[derive(Debug, Serialize)]
struct Document {
    document: String,
    title: String,
    sha256: String,
    points: Vec<Point>,
}

#[derive(Debug, Serialize)]
struct Point {
    name: String,
    parameters: Ordered<Number>,
    quantities: Vec<Quantity>,
    /// What has no rational number here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    left_out: Vec<LeftOut>,
}

/// A quantity without numbers.
#[derive(Debug, Serialize)]
struct LeftOut {
    name: String,
    why: Why,
}

/// Why there is no rational number.
#[derive(Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Why {
    /// Roots or other functions occur in it.
    Functions,
    /// It divides by what is zero at the point.
    Pole,
    /// A letter of it has no value.
    Letters,
}

#[derive(Debug, Serialize)]
struct Quantity {
    name: String,
    kind: &'static str,
    shape: [usize; 2],
    /// Row by row; `null` where the quantity has no value.
    entries: Vec<Vec<Option<Number>>>,
}

/// A rational number and the double nearest to it; no double where it overflows.
#[derive(Debug, Serialize)]
struct Number {
    exact: String,
    double: Option<f64>,
}

impl Number {
    fn of(value: &BigRational) -> Self {
        Number {
            exact: value.to_string(),
            double: nearest(value),
        }
    }
}

/// The vectors of some documents.
pub fn vectors(inspections: &[Inspection]) -> Vectors {
    Vectors {
        software: Software::this(),
        documents: inspections.iter().map(|i| document(&i.audit)).collect(),
    }
}

fn document(audit: &Audit) -> Document {
    let document = &audit.model.document;
    let quantities = Quantities::of(audit);
    let names: Vec<(String, Vec<(String, BigRational)>)> = match &document.numeric {
        None => vec![("reference".into(), Vec::new())],
        Some(numeric) if numeric.points.is_empty() => vec![("reference".into(), Vec::new())],
        Some(numeric) => numeric
            .points
            .iter()
            .map(|p| {
                let values = p.values.iter().map(|(n, v)| (n.text.clone(), v.clone()));
                (p.name.text.clone(), values.collect())
            })
            .collect(),
    };
    Document {
        document: document.name.clone(),
        title: document.title.clone(),
        sha256: sha256(&document.text),
        points: names
            .into_iter()
            .map(|(name, values)| point(audit, &quantities, name, &values))
            .filter(|point| !point.parameters.0.is_empty())
            .collect(),
    }
}

fn point(
    audit: &Audit,
    quantities: &Quantities<'_>,
    name: String,
    replaced: &[(String, BigRational)],
) -> Point {
    let symbols = &audit.model.symbols;
    let declared = &audit.model.document.symbols;
    let value_of = |symbol: usize| {
        replaced
            .iter()
            .find(|(name, _)| *name == declared[symbols[symbol].declared].name.text)
            .map(|(_, value)| value.clone())
            .or_else(|| symbols[symbol].value.clone())
    };
    let point = quantities.point(value_of);
    let parameters = (0..symbols.len())
        .filter_map(|s| {
            Some((
                declared[symbols[s].declared].name.text.clone(),
                Number::of(&value_of(s)?),
            ))
        })
        .collect();
    let entry = |f: &RationalFunction| quantities.at(f, &point).map(|v| Number::of(&v));
    let functions = quantities.with_functions.iter();
    let mut left_out: Vec<LeftOut> = functions
        .map(|name| LeftOut {
            name: name.clone(),
            why: Why::Functions,
        })
        .collect();
    let mut listed = Vec::new();
    for quantity in &quantities.list {
        let (shape, entries) = match &quantity.value {
            Value::Scalar(f) => ([1, 1], vec![vec![entry(f)]]),
            Value::Matrix(m) => (
                [m.rows(), m.columns()],
                (0..m.rows())
                    .map(|i| (0..m.columns()).map(|j| entry(&m[(i, j)])).collect())
                    .collect(),
            ),
            Value::Zero => continue,
        };
        let name = quantity.name.clone();
        if entries.iter().flatten().any(Option::is_some) {
            listed.push(Quantity {
                name,
                kind: quantity.kind.as_str(),
                shape,
                entries,
            });
        } else {
            let all = quantity.value.entries().into_iter();
            let why = match all.into_iter().all(|f| quantities.has_values(f, &point)) {
                true => Why::Pole,
                false => Why::Letters,
            };
            left_out.push(LeftOut { name, why });
        }
    }
    Point {
        name,
        parameters: Ordered(parameters),
        quantities: listed,
        left_out,
    }
}
