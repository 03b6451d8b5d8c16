//! Boxes in a row with arrows between them.

use super::colour::{Colour, INK};
use super::label::{runs, width};
use super::scene::{Anchor, Scene, Stroke};
use crate::document::figure::Station;
use crate::report::prose::Prose;

const SIZE: f64 = 15.0;
const SMALL: f64 = 13.0;
const HEIGHT: f64 = 64.0;
const MIDDLE: f64 = 60.0;
const MARGIN: f64 = 16.0;

/// The lines of a part: its formula and its words, wrapped where these are long.
fn lines(station: &Station) -> Vec<(Prose, f64, f64)> {
    let mut lines = Vec::new();
    if let Some(formula) = &station.formula {
        let wide: f64 = runs(&formula.text).iter().map(width).sum();
        lines.push((Prose::new().math(formula.text.clone()), wide * SIZE, SIZE));
    }
    for line in station.words.iter().flat_map(|w| wrapped(&w.text)) {
        let wide = line.chars().count() as f64 * 0.54 * SMALL;
        lines.push((Prose::of(line), wide, SMALL));
    }
    lines
}

/// Words in lines of at most about twenty letters.
fn wrapped(words: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < 20 => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_string()),
        }
    }
    lines
}

/// The picture of a chain.
pub fn scene(chain: &[Station]) -> Scene {
    let wide = |station: &Station| {
        let lines = lines(station);
        let text = lines.iter().map(|l| l.1).fold(0.0, f64::max);
        match station.is_box {
            true => (text + 28.0).max(96.0),
            false => (text + 26.0).max(64.0),
        }
    };
    let widths: Vec<f64> = chain.iter().map(wide).collect();
    let total = widths.iter().sum::<f64>() + 2.0 * MARGIN;
    let mut scene = Scene::new(total.max(320.0), 2.0 * MIDDLE);
    let ink = Stroke::solid(INK, 1.3);
    let mut x = (scene.width - total) / 2.0 + MARGIN;
    for (station, wide) in chain.iter().zip(widths) {
        let lines = lines(station);
        let centre = x + wide / 2.0;
        if station.is_box {
            let (top, bottom) = (MIDDLE - HEIGHT / 2.0, MIDDLE + HEIGHT / 2.0);
            let fill = Some(Colour(0xf2, 0xf5, 0xfa));
            scene.rectangle((x, top), (x + wide, bottom), fill, Some(ink));
            let first = MIDDLE - 9.0 * (lines.len() as f64 - 1.0);
            for (k, (text, _, size)) in lines.into_iter().enumerate() {
                let y = first + 18.0 * k as f64;
                scene.text((centre, y), text, Anchor::Middle, size);
            }
        } else {
            scene.arrow((x + 2.0, MIDDLE), (x + wide - 2.0, MIDDLE), ink);
            // The formula above the arrow, the words below.
            let mut below = MIDDLE + 15.0;
            for (text, _, size) in lines {
                if size == SIZE {
                    scene.text((centre - 3.0, MIDDLE - 14.0), text, Anchor::Middle, size);
                } else {
                    scene.text((centre - 3.0, below), text, Anchor::Middle, size);
                    below += 16.0;
                }
            }
        }
        x += wide;
    }
    scene
}
