//! A page of cards that lead to the pages of scenes, and the element that shows a page within another.

use maud::html;

use super::bundle;

/// A scene's page in a gallery.
#[derive(Clone, Debug)]
pub struct Card {
    /// Title of the page.
    pub title: String,
    /// Name of the page's folder, beside the gallery's document.
    pub folder: String,
}

const STYLE: &str = include_str!("page/gallery.css");

/// The document of a gallery.
#[must_use]
pub fn gallery(title: &str, cards: &[Card]) -> String {
    let body = html! {
        h1 { (title) }
        main {
            @for Card { title, folder } in cards {
                a href={ (folder) "/index.html" } {
                    img src={ (folder) "/poster.jpg" } alt="";
                    span { (title) }
                }
            }
        }
    };
    bundle::document(title, STYLE, &body)
}

/// The element that shows a page within another one. `path` is the page's, relative to that other one.
#[must_use]
pub fn embedding(title: &str, path: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let escaped = |byte: u8| match is_plain(byte) {
        true => char::from(byte).to_string(),
        false => format!("%{byte:02X}"),
    };
    let address: String = path.bytes().map(escaped).collect();
    let element = html! {
        iframe src={ (address) "?embed" } title=(title) loading="lazy" allow="fullscreen"
            style="width: 100%; aspect-ratio: 16 / 9; border: 0" {}
    };
    element.into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_escaped() {
        let card = Card { title: "<b>".to_owned(), folder: "b".to_owned() };
        let page = gallery("A & B", &[card]);
        assert!(page.contains("<h1>A &amp; B</h1>") && page.contains("<span>&lt;b&gt;</span>"));
        let element = embedding("\"", "my page#1/index.html");
        assert!(element.contains("src=\"my%20page%231/index.html?embed\" title=\"&quot;\""));
    }
}
