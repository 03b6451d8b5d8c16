//! A surface in perspective with a map of it beside.

use super::axis::{number, ticks, ticks_around};
use super::colour::{GREY, INK, ORANGE, PALE, RED, WHITE, YELLOW, scale, shade};
use super::contour::{Sample, bands, line};
use super::legend;
use super::projection::{Place, Projection};
use super::scene::{Anchor, Point, Scene, Stroke};
use crate::figure::{Axis, Mark, MarkKind, Surface};
use crate::numeric::agreement::nearest;
use crate::report::decimal::decimal;
use crate::report::prose::Prose;
use num_rational::BigRational;

const WIDTH: f64 = 800.0;
const SIZE: f64 = 13.0;
const SMALL: f64 = 11.5;
/// The map: its left and upper edge and its side.
const MAP: (f64, f64, f64) = (520.0, 44.0, 216.0);
/// The first line of the legend.
const LEGEND: f64 = 358.0;
const LINE: f64 = 20.0;

fn float(value: &BigRational) -> f64 {
    nearest(value).unwrap_or(0.0)
}

/// The surface as numbers for the eye: coordinates from 0 to 1, and the values with their range.
struct View<'s> {
    surface: &'s Surface,
    /// Samples with multiples of the reference value.
    rows: Vec<Vec<Sample>>,
    /// The ticks of the values, the first and last of which are the ends of the upright axis.
    ticks: Vec<f64>,
    /// The levels between which the map has one colour.
    levels: Vec<f64>,
}

impl View<'_> {
    /// A point of an axis in units of its range.
    fn across(&self, axis: usize, value: f64) -> f64 {
        let (low, high) = self.surface.axes[axis].range();
        (value - float(low)) / (float(high) - float(low))
    }

    /// A value in units of the upright axis.
    fn height(&self, value: f64) -> f64 {
        let (low, high) = (self.ticks[0], self.ticks[self.ticks.len() - 1]);
        (value - low) / (high - low).max(1e-300)
    }

    /// A value in units of the range of colours.
    fn tone(&self, value: f64) -> f64 {
        let (low, high) = (self.levels[0], self.levels[self.levels.len() - 1]);
        (value - low) / (high - low).max(1e-300)
    }
}

/// The picture of a surface.
pub fn scene(surface: &Surface) -> Scene {
    let rows: Vec<Vec<Sample>> = surface
        .values
        .iter()
        .zip(&surface.axes[1].grid)
        .map(|(row, v)| {
            let points = row.iter().zip(&surface.axes[0].grid);
            points
                .map(|(z, u)| (float(u), float(v), float(z)))
                .collect()
        })
        .collect();
    let all = || rows.iter().flatten().map(|s| s.2);
    let low = all().fold(f64::INFINITY, f64::min);
    let high = all().fold(f64::NEG_INFINITY, f64::max);
    // A constant quantity still needs a range to be drawn in.
    let (low, high) = match high - low > 1e-9 {
        true => (low, high),
        false => (low - 0.5, high + 0.5),
    };
    let view = View {
        surface,
        rows,
        ticks: ticks_around(low, high, 5),
        levels: ticks_around(low, high, 12),
    };
    let marks: Vec<&Mark> = surface.marks.iter().collect();
    let told = marks
        .iter()
        .filter(|m| legend::mark(surface, m).is_some())
        .count();
    let mut scene = Scene::new(WIDTH, LEGEND + LINE * (1 + told) as f64);
    perspective(&mut scene, &view);
    map(&mut scene, &view);
    key(&mut scene, &view);
    scene
}

/// The label of an axis: the letter by its reference value.
fn axis_label(axis: &Axis) -> Prose {
    let unit = match axis.unit.as_deref() {
        None | Some("1") => String::new(),
        Some(unit) => format!(" {unit}"),
    };
    Prose::new()
        .math(axis.name.clone())
        .words(format!(" / ({}{unit})", decimal(&axis.reference, 6)))
}

/// The label of the values: the quantity by its reference value.
fn value_label(surface: &Surface) -> Prose {
    Prose::new()
        .math(surface.quantity.clone())
        .words(" / reference value")
}

fn perspective(scene: &mut Scene, view: &View<'_>) {
    let corner = |j: usize, i: usize| view.rows[j][i].2;
    let (m, n) = (view.rows.len() - 1, view.rows[0].len() - 1);
    // The lowest corner is nearest to the eye, so that nothing hides behind a hill.
    let corners = [
        (corner(0, 0), (false, false)),
        (corner(0, n), (true, false)),
        (corner(m, 0), (false, true)),
        (corner(m, n), (true, true)),
    ];
    let near = corners
        .iter()
        .fold(corners[0], |a, b| if b.0 < a.0 { *b } else { a })
        .1;
    let eye = Projection::new(near, 224.0, (256.0, 166.0));
    let end = |far: bool| f64::from(u8::from(far));
    // The corner nearest to the eye and the one opposite.
    let (a, b) = (end(near.0), end(near.1));
    let (c, d) = (1.0 - a, 1.0 - b);
    let pale = Stroke::solid(PALE, 0.8);
    let grey = Stroke::solid(GREY, 0.9);
    let seen = |places: &[Place]| places.iter().map(|p| eye.point(*p)).collect::<Vec<Point>>();
    let walls = [
        [
            (0.0, 0.0, 0.0),
            (1.0, 0.0, 0.0),
            (1.0, 1.0, 0.0),
            (0.0, 1.0, 0.0),
        ],
        [(c, 0.0, 0.0), (c, 1.0, 0.0), (c, 1.0, 1.0), (c, 0.0, 1.0)],
        [(0.0, d, 0.0), (1.0, d, 0.0), (1.0, d, 1.0), (0.0, d, 1.0)],
    ];
    for wall in walls {
        scene.polygon(
            seen(&wall),
            Some(super::colour::Colour(0xfa, 0xfa, 0xfa)),
            Some(grey),
        );
    }
    let round: Vec<Vec<f64>> = (0..2)
        .map(|k| {
            let (low, high) = view.surface.axes[k].range();
            ticks(float(low), float(high), 4)
        })
        .collect();
    for &t in &round[0] {
        let u = view.across(0, t);
        scene.line(seen(&[(u, b, 0.0), (u, d, 0.0), (u, d, 1.0)]), pale);
    }
    for &t in &round[1] {
        let v = view.across(1, t);
        scene.line(seen(&[(a, v, 0.0), (c, v, 0.0), (c, v, 1.0)]), pale);
    }
    for &t in &view.ticks {
        let h = view.height(t);
        scene.line(seen(&[(a, d, h), (c, d, h), (c, b, h)]), pale);
    }
    // The left and the right end of the floor carry the axes; the values stand on the left.
    let place =
        |s: &Sample| -> Place { (view.across(0, s.0), view.across(1, s.1), view.height(s.2)) };
    let mut cells = Vec::new();
    let (across, along) = (lines(n), lines(m));
    for j in along.windows(2) {
        for i in across.windows(2) {
            let quad = [
                view.rows[j[0]][i[0]],
                view.rows[j[0]][i[1]],
                view.rows[j[1]][i[1]],
                view.rows[j[1]][i[0]],
            ];
            let places: Vec<Place> = quad.iter().map(place).collect();
            let mean = |pick: &dyn Fn(&Place) -> f64| places.iter().map(pick).sum::<f64>() / 4.0;
            let middle = (mean(&|p| p.0), mean(&|p| p.1), mean(&|p| p.2));
            let value = quad.iter().map(|s| s.2).sum::<f64>() / 4.0;
            let edge = |k: usize| {
                (
                    places[k].0 - places[0].0,
                    places[k].1 - places[0].1,
                    places[k].2 - places[0].2,
                )
            };
            let light = eye.light(edge(1), edge(3));
            let colour = shade(scale(view.tone(value)), 0.72 + 0.38 * light.max(0.0));
            // How far the cell is from the eye decides; its height must not.
            cells.push((eye.depth((middle.0, middle.1, 0.5)), seen(&places), colour));
        }
    }
    cells.sort_by(|x, y| y.0.total_cmp(&x.0));
    for (_, corners, colour) in cells {
        let mesh = Stroke::solid(shade(colour, 0.72), 0.5);
        scene.polygon(corners, Some(colour), Some(mesh));
    }
    // The two upright edges and those of the floor in front.
    let ink = Stroke::solid(INK, 1.0);
    scene.line(
        seen(&[(a, d, 1.0), (a, d, 0.0), (a, b, 0.0), (c, b, 0.0)]),
        ink,
    );
    axis_in_space(scene, &eye, view, 0, &round[0], |u| (u, b, 0.0), d - b);
    axis_in_space(scene, &eye, view, 1, &round[1], |v| (a, v, 0.0), c - a);
    upright_axis(scene, &eye, view, (a, b), (c, d));
    for (kind, at) in visible(view) {
        let h = view.height(at.2);
        let (u, v) = (view.across(0, at.0), view.across(1, at.1));
        symbol(scene, kind, eye.point((u, v, h)), 5.5);
    }
}

/// The lines of a grid that are drawn: at most about twenty of them, the last included.
fn lines(last: usize) -> Vec<usize> {
    let step = last.div_ceil(24).max(1);
    let mut lines: Vec<usize> = (0..last).step_by(step).collect();
    lines.push(last);
    lines
}

/// Ticks and labels along an edge of the floor, pointing away from the box.
fn axis_in_space(
    scene: &mut Scene,
    eye: &Projection,
    view: &View<'_>,
    axis: usize,
    ticks: &[f64],
    edge: impl Fn(f64) -> Place,
    inward: f64,
) {
    let away = |at: f64, by: f64| -> Place {
        let (u, v, h) = edge(at);
        match axis {
            0 => (u, v - inward * by, h),
            _ => (u - inward * by, v, h),
        }
    };
    let ends = (eye.point(edge(0.0)), eye.point(edge(1.0)));
    let middle = ((ends.0.0 + ends.1.0) / 2.0, (ends.0.1 + ends.1.1) / 2.0);
    let right = middle.0 > eye.point((0.5, 0.5, 0.0)).0;
    let anchor = if right { Anchor::Start } else { Anchor::End };
    let side = if right { 1.0 } else { -1.0 };
    for &t in ticks {
        let at = view.across(axis, t);
        let (from, to) = (eye.point(away(at, 0.0)), eye.point(away(at, 0.025)));
        scene.line(vec![from, to], Stroke::solid(INK, 1.0));
        let place = eye.point(away(at, 0.04));
        let place = (place.0 + 2.0 * side, place.1 + 5.0);
        scene.text(place, Prose::of(number(t)), anchor, SMALL);
    }
    // Below the half of the edge that is nearer to the eye.
    let low = if ends.0.1 > ends.1.1 { 0.36 } else { 0.64 };
    let place = eye.point(edge(low));
    let at = (place.0 + 40.0 * side, place.1 + 34.0);
    scene.text(at, axis_label(&view.surface.axes[axis]), anchor, SIZE);
}

/// The axis of the values, on the upright edge that is farthest to the left.
fn upright_axis(
    scene: &mut Scene,
    eye: &Projection,
    view: &View<'_>,
    (a, b): (f64, f64),
    (c, d): (f64, f64),
) {
    let candidates = [(a, d), (c, b)];
    let left = |p: &(f64, f64)| eye.point((p.0, p.1, 0.0)).0;
    let edge = match left(&candidates[0]) <= left(&candidates[1]) {
        true => candidates[0],
        false => candidates[1],
    };
    let ink = Stroke::solid(INK, 1.0);
    let top = eye.point((edge.0, edge.1, 1.0));
    let bottom = eye.point((edge.0, edge.1, 0.0));
    scene.line(vec![top, bottom], ink);
    for &t in &view.ticks {
        let at = eye.point((edge.0, edge.1, view.height(t)));
        scene.line(vec![at, (at.0 - 5.0, at.1)], ink);
        // The lowest number would stand in the way of the floor's.
        if view.height(t) > 1e-9 {
            scene.text((at.0 - 9.0, at.1), Prose::of(number(t)), Anchor::End, SMALL);
        }
    }
    let middle = (top.0 + bottom.0) / 2.0;
    let at = (middle - 52.0, (top.1 + bottom.1) / 2.0);
    scene.upright_text(at, value_label(view.surface), SIZE);
}

/// The marks inside the drawn range with their value, in multiples of the reference; the reference
/// point is the first.
fn visible(view: &View<'_>) -> Vec<(Option<MarkKind>, (f64, f64, f64))> {
    let surface = view.surface;
    let one = BigRational::from_integer(1.into());
    let mut found = Vec::new();
    let in_range = |k: usize| {
        let (low, high) = surface.axes[k].range();
        low <= &one && &one <= high
    };
    if in_range(0) && in_range(1) {
        found.push((None, (1.0, 1.0, 1.0)));
    }
    for mark in &surface.marks {
        let Ok(place) = &mark.place else { continue };
        let middle = |k: usize| {
            let (low, high) = place.coordinates[k].interval();
            float(&((low + high) / BigRational::from_integer(2.into())))
        };
        let value = (float(&place.value.0) + float(&place.value.1)) / 2.0;
        let at = match mark.kind {
            MarkKind::Optimum(_) => (middle(0), middle(1), value),
            MarkKind::Section(axis, _) => {
                if !legend::is_drawn(surface, axis, &place.coordinates[0]) || !in_range(1 - axis) {
                    continue;
                }
                match axis {
                    0 => (middle(0), 1.0, value),
                    _ => (1.0, middle(0), value),
                }
            }
        };
        found.push((Some(mark.kind), at));
    }
    found
}

/// The symbol of a mark: a circle, a star, a diamond or a triangle.
fn symbol(scene: &mut Scene, kind: Option<MarkKind>, (x, y): Point, radius: f64) {
    let edge = Some(Stroke::solid(INK, 1.1));
    match kind {
        None => scene.circle((x, y), radius * 0.9, Some(WHITE), edge),
        Some(MarkKind::Optimum(_)) => {
            let corners = (0..10)
                .map(|k| {
                    let angle = std::f64::consts::PI * f64::from(k) / 5.0;
                    let r = if k % 2 == 0 {
                        1.5 * radius
                    } else {
                        0.62 * radius
                    };
                    (x + r * libm::sin(angle), y - r * libm::cos(angle))
                })
                .collect();
            scene.polygon(corners, Some(RED), edge);
        }
        Some(MarkKind::Section(0, _)) => {
            let r = 1.15 * radius;
            let corners = vec![(x, y - r), (x + r, y), (x, y + r), (x - r, y)];
            scene.polygon(corners, Some(ORANGE), edge);
        }
        Some(MarkKind::Section(..)) => {
            let r = 1.2 * radius;
            let corners = vec![
                (x, y - r),
                (x + 0.9 * r, y + 0.6 * r),
                (x - 0.9 * r, y + 0.6 * r),
            ];
            scene.polygon(corners, Some(YELLOW), edge);
        }
    }
}

fn map(scene: &mut Scene, view: &View<'_>) {
    let (left, top, side) = MAP;
    let at = |u: f64, v: f64| {
        let (u, v) = (view.across(0, u), view.across(1, v));
        (left + side * u, top + side * (1.0 - v))
    };
    let on_paper = |rings: Vec<Vec<Point>>| -> Vec<Vec<Point>> {
        let ring = |ring: Vec<Point>| ring.into_iter().map(|p| at(p.0, p.1)).collect();
        rings.into_iter().map(ring).collect()
    };
    let levels = &view.levels;
    for (rings, pair) in bands(&view.rows, levels).into_iter().zip(levels.windows(2)) {
        if rings.is_empty() {
            continue;
        }
        let colour = scale(view.tone((pair[0] + pair[1]) / 2.0));
        // A thin line of its own colour closes the seams between the pieces.
        let seam = Stroke::solid(colour, 0.6);
        scene.polygons(on_paper(rings), Some(colour), Some(seam));
    }
    for &level in &levels[1..levels.len() - 1] {
        let lines = on_paper(line(&view.rows, level));
        if !lines.is_empty() {
            let heavy = view.ticks.iter().any(|t| (t - level).abs() < 1e-9);
            let width = if heavy { 0.9 } else { 0.45 };
            scene.lines(lines, Stroke::solid(INK, width));
        }
    }
    let ink = Stroke::solid(INK, 1.0);
    scene.rectangle((left, top), (left + side, top + side), None, Some(ink));
    for (k, axis) in view.surface.axes.iter().enumerate() {
        let (low, high) = axis.range();
        for t in ticks(float(low), float(high), 4) {
            let along = view.across(k, t);
            if k == 0 {
                let x = left + side * along;
                scene.line(vec![(x, top + side), (x, top + side + 5.0)], ink);
                let place = (x, top + side + 16.0);
                scene.text(place, Prose::of(number(t)), Anchor::Middle, SMALL);
            } else {
                let y = top + side * (1.0 - along);
                scene.line(vec![(left, y), (left - 5.0, y)], ink);
                scene.text((left - 11.0, y), Prose::of(number(t)), Anchor::End, SMALL);
            }
        }
    }
    let [x, y] = &view.surface.axes;
    let below = (left + side / 2.0, top + side + 36.0);
    scene.text(below, axis_label(x), Anchor::Middle, SIZE);
    scene.upright_text((left - 56.0, top + side / 2.0), axis_label(y), SIZE);
    bar(scene, view);
    for (kind, (u, v, _)) in visible(view) {
        symbol(scene, kind, at(u, v), 5.5);
    }
}

/// The scale of the colours beside the map.
fn bar(scene: &mut Scene, view: &View<'_>) {
    let (left, top, side) = MAP;
    let (x, width) = (left + side + 16.0, 14.0);
    let ink = Stroke::solid(INK, 1.0);
    let y = |value: f64| top + side * (1.0 - view.tone(value));
    for pair in view.levels.windows(2) {
        let colour = scale(view.tone((pair[0] + pair[1]) / 2.0));
        let (low, high) = ((x, y(pair[1])), (x + width, y(pair[0])));
        scene.rectangle(low, high, Some(colour), Some(Stroke::solid(colour, 0.4)));
    }
    scene.rectangle((x, top), (x + width, top + side), None, Some(ink));
    let (low, high) = (view.levels[0], view.levels[view.levels.len() - 1]);
    for t in ticks(low, high, 6) {
        scene.line(vec![(x + width, y(t)), (x + width + 4.0, y(t))], ink);
        let place = (x + width + 8.0, y(t));
        scene.text(place, Prose::of(number(t)), Anchor::Start, SMALL);
    }
    let above = (x + width / 2.0, top - 16.0);
    scene.text(above, value_label(view.surface), Anchor::End, SIZE);
}

/// The legend below both.
fn key(scene: &mut Scene, view: &View<'_>) {
    let surface = view.surface;
    let mut y = LEGEND;
    let mut entry = |kind: Option<MarkKind>, words: Prose, drawn: bool| {
        if drawn {
            symbol(scene, kind, (52.0, y), 5.0);
        }
        scene.text((66.0, y), words, Anchor::Start, SIZE);
        y += LINE;
    };
    entry(None, legend::reference(surface), true);
    for mark in &surface.marks {
        if let Some(words) = legend::mark(surface, mark) {
            // What lies outside of the picture has no symbol in it.
            let drawn = match (&mark.kind, &mark.place) {
                (MarkKind::Section(k, _), Ok(place)) => {
                    legend::is_drawn(surface, *k, &place.coordinates[0])
                }
                (_, place) => place.is_ok(),
            };
            entry(Some(mark.kind), words, drawn);
        }
    }
}
