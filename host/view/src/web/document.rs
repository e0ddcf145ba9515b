//! The document of a page, and its script.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, PreEscaped, html};

/// The modules. Each comes after those that it imports.
const SCRIPTS: [&str; 9] = [
    include_str!("../page/camera.js"),
    include_str!("../page/controls.js"),
    include_str!("page/page.js"),
    include_str!("page/pace.js"),
    include_str!("page/player.js"),
    include_str!("page/screen.js"),
    include_str!("page/turn.js"),
    include_str!("page/viewer.js"),
    include_str!("page/main.js"),
];
const STYLE: &str = concat!(include_str!("../page/page.css"), include_str!("page/page.css"));
const BODY: &str = include_str!("page/body.html");
const ICON: &str = include_str!("../page/icon.svg");

/// All modules as one script.
pub fn script() -> String {
    let own = SCRIPTS.map(|module| {
        let lines = module.lines().filter(|line| !line.starts_with("import "));
        lines
            .map(|line| line.strip_prefix("export ").unwrap_or(line))
            .collect::<Vec<_>>()
            .join("\n")
    });
    format!("\"use strict\";\n(async () => {{\n{}\n}})();\n", own.join("\n"))
}

/// The document. `poster` is the address of the picture to show before the scene; `scripts` are elements that load the scene and
/// the page's script.
pub fn html(title: &str, poster: &str, scripts: &str) -> String {
    let picture = html! {
        div id="poster" role="img" aria-label=(title) style={ "--picture: url(" (poster) ")" } {}
        h1 id="title" { (title) }
    };
    let body = BODY.replacen("<!-- poster and title -->", &picture.into_string(), 1);
    let icon = STANDARD.encode(ICON);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="generator" content=(concat!("organza ", env!("CARGO_PKG_VERSION")));
                title { (title) " · organza" }
                link rel="icon" href={ "data:image/svg+xml;base64," (icon) };
                style { (PreEscaped(STYLE)) }
            }
            body { (PreEscaped(body)) (PreEscaped(scripts)) }
        }
    };
    page.into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_script_is_no_module_and_ends_no_element() {
        let script = script();
        for word in ["\nimport ", "\nexport ", "</script", "<!--"] {
            assert!(!script.contains(word), "{word}");
        }
        let page = html("<i>&\"", "poster.jpg", "");
        assert!(page.contains("<title>&lt;i&gt;&amp;&quot; · organza</title>"));
        assert!(page.contains("<h1 id=\"title\">&lt;i&gt;&amp;&quot;</h1>"));
        assert!(page.contains("url(poster.jpg)"));
    }
}
