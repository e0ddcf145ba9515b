//! The page of a split: its blocks from above.

use std::path::Path;

use maud::{Markup, html};

use super::charts::Charts;
use super::page::{clean, page, section, table};
use organza_core::{Camera, Result, write_inside};
use organza_data::{Block, Point, Split};

/// Most points that the picture shows; others are left out evenly.
const MAX_POINTS: usize = 4000;
/// Width of the picture, in its own units, and the longest that its height may be.
const SIZE: f64 = 900.0;
/// Length of a camera's line, in the picture's units.
const CAMERA: f64 = 9.0;

/// Writes the page of a split of these cameras and points, atomically.
///
/// # Errors
/// [`Error::WriteFile`](organza_core::Error::WriteFile).
pub fn write_split_report(
    path: &Path,
    split: &Split,
    cameras: &[Camera],
    points: &[Point],
) -> Result<()> {
    let title = split.blocks[0].data.display().to_string();
    let titles = ["block", "photographs", "points"].map(str::to_owned);
    let row = |block: &Block| {
        let at = block.index;
        let photographs = format!("{} of {}", split.cameras[at].len(), cameras.len());
        vec![Block::name(at), photographs, split.points[at].len().to_string()]
    };
    let rows: Vec<_> = split.blocks.iter().map(row).collect();
    let body = html! {
        header { p.quiet { "A capture in " (rows.len()) " blocks" } h1 { (clean(&title)) } }
        @for note in &split.notes { p.note { (clean(note)) } }
        (section("From above", &picture(split, cameras, points)))
        (section("Blocks", &table("scores", &titles, 1, &rows)))
        p.note { "A photograph belongs to each block that it looks into." }
    };
    let html = page(&format!("{title} – organza"), &Charts::default(), &body);
    write_inside(path, |writer| writer.write_all(html.as_bytes()))
}

/// Points as dots, cameras as lines in the direction in which they look, and the sides of the blocks.
fn picture(split: &Split, cameras: &[Camera], points: &[Point]) -> Markup {
    let every = points.len().div_ceil(MAX_POINTS).max(1);
    let dots: Vec<_> = points.iter().step_by(every).map(|point| flat(point.position)).collect();
    let eyes: Vec<_> = cameras.iter().map(|camera| flat(camera.eye())).collect();
    let sides = |axis: usize| {
        let of = split.blocks.iter().flat_map(|block| block.sides);
        of.filter_map(move |side| side[axis])
    };
    let ends = [0, 1].map(|axis| {
        let mut along: Vec<_> = dots.iter().chain(&eyes).map(|place| place[axis]).collect();
        along.sort_by(f64::total_cmp);
        // a few far points would make everything else small
        let out = along.len() / 50;
        let most = [along[out], along[along.len() - 1 - out]];
        let known = eyes.iter().map(|eye| eye[axis]).chain(sides(axis));
        known.fold(most, |[low, high], at| [low.min(at), high.max(at)])
    });
    let length = ends.map(|[low, high]| (high - low).max(1e-9));
    let unit = SIZE / (1.1 * length[0].max(length[1]));
    let from = [0, 1].map(|axis| ends[axis][0] - 0.05 * length[axis]);
    let size = length.map(|length| (1.1 * unit * length).max(40.0));
    // y is up
    let at = |[x, y]: [f64; 2]| [unit * (x - from[0]), size[1] - unit * (y - from[1])];
    let block = |block: &Block| {
        let x = |end: usize, open: f64| block.sides[end][0].map_or(open, |x| at([x, 0.0])[0]);
        let y = |end: usize, open: f64| block.sides[end][1].map_or(open, |y| at([0.0, y])[1]);
        let [left, right] = [x(0, 0.0), x(1, size[0])];
        let [top, bottom] = [y(1, 0.0), y(0, size[1])];
        html! {
            rect x=(left) y=(top) width=((right - left).max(0.0)) height=((bottom - top).max(0.0))
                fill="none" stroke="var(--held-out)" stroke-width="2" {}
            text x=(left + 8.0) y=(top + 20.0) fill="var(--held-out)" font-size="15" { (block.index) }
        }
    };
    let line = |(camera, eye): (&Camera, &[f64; 2])| {
        let [x, y] = at(*eye);
        let [toward_x, toward_y, _] = camera.axes()[2].to_array();
        html! { line x1=(x) y1=(y) x2=(x + CAMERA * toward_x) y2=(y - CAMERA * toward_y) stroke="var(--accent)" stroke-width="2" {} }
    };
    html! {
        svg viewBox=(format!("0 0 {} {}", size[0], size[1])) width=(size[0]) style="max-width: 100%" role="img" {
            title { "The capture from above: points, cameras and blocks" }
            @for dot in &dots {
                @let [x, y] = at(*dot);
                circle cx=(x) cy=(y) r="1" fill="var(--quiet)" {}
            }
            @for camera in cameras.iter().zip(&eyes) { (line(camera)) }
            @for one in &split.blocks { (block(one)) }
        }
    }
}

fn flat([x, y, _]: [f64; 3]) -> [f64; 2] {
    [x, y]
}
