//! The page: plain modules that are part of the program.

use organza_report::{UPLOT_SCRIPT, UPLOT_STYLE};

/// A file of the page: its address, its media type, and its content.
type Asset = (&'static str, &'static str, &'static str);

pub const PAGE: &str = "text/html; charset=utf-8";
pub const SCRIPT: &str = "text/javascript; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";

/// Every file of the page.
const ASSETS: [Asset; 17] = [
    ("/", PAGE, include_str!("page/index.html")),
    ("/icon.svg", "image/svg+xml", include_str!("page/icon.svg")),
    ("/page.css", STYLE, include_str!("page/page.css")),
    ("/main.js", SCRIPT, include_str!("page/main.js")),
    ("/camera.js", SCRIPT, include_str!("page/camera.js")),
    ("/controls.js", SCRIPT, include_str!("page/controls.js")),
    ("/edit.js", SCRIPT, include_str!("page/edit.js")),
    ("/explain.js", SCRIPT, include_str!("page/explain.js")),
    ("/film.js", SCRIPT, include_str!("page/film.js")),
    ("/frames.js", SCRIPT, include_str!("page/frames.js")),
    ("/keyframes.js", SCRIPT, include_str!("page/keyframes.js")),
    ("/measure.js", SCRIPT, include_str!("page/measure.js")),
    ("/overlay.js", SCRIPT, include_str!("page/overlay.js")),
    ("/page.js", SCRIPT, include_str!("page/page.js")),
    ("/training.js", SCRIPT, include_str!("page/training.js")),
    ("/uplot.js", SCRIPT, UPLOT_SCRIPT),
    ("/uplot.css", STYLE, UPLOT_STYLE),
];

/// The file at an address.
pub fn find(path: &str) -> Option<(&'static str, &'static str)> {
    let found = ASSETS.iter().find(|(address, ..)| *address == path);
    found.map(|(_, kind, content)| (*kind, *content))
}
