//! Serialisation: a ring as its variables and order, a value as its ring and its text in the plain
//! notation. Reading goes through the parser, so that nothing that is not canonical can be read.

use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::ring::{Order, Ring};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

#[derive(Serialize, Deserialize)]
#[serde(rename = "Ring")]
struct RingText {
    variables: Vec<String>,
    order: Order,
}

#[derive(Serialize, Deserialize)]
#[serde(rename = "Expression")]
struct ExpressionText {
    ring: Ring,
    value: String,
}

impl Serialize for Ring {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        RingText {
            variables: self.variables().to_vec(),
            order: self.order(),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Ring {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = RingText::deserialize(deserializer)?;
        Ring::new(text.variables, text.order).map_err(D::Error::custom)
    }
}

macro_rules! by_text {
    ($type:ident) => {
        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let text = ExpressionText {
                    ring: self.ring(),
                    value: self.to_string(),
                };
                text.serialize(serializer)
            }
        }

        impl<'de> Deserialize<'de> for $type {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let text = ExpressionText::deserialize(deserializer)?;
                $type::parse(text.ring, &text.value).map_err(D::Error::custom)
            }
        }
    };
}

by_text!(Polynomial);
by_text!(RationalFunction);
