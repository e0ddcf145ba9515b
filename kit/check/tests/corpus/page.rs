//! Runs the corpus, and compares the page with the results.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use crate::BUGS;
use crate::bug::{Bench, Bug, Found};

/// A row of the table.
struct Finding {
    bug: &'static Bug,
    /// The simplest device that gives a message.
    device: &'static str,
    message: String,
    /// The line that the message names.
    line: Option<usize>,
    /// Whether it names the kernel and an invocation.
    has_place: bool,
}

/// Tests a bug on the ordinary CPU, and on both CPUs for tests.
fn find(bug: &'static Bug) -> Finding {
    let mut value = None;
    let found = Bench::all().map(|bench| match (bug.test)(&bench) {
        Err(Found::Message(text)) => Some(text),
        Err(Found::Value(text)) => {
            value = Some(text);
            None
        }
        Ok(()) => None,
    });
    let [plain, checked, thorough] = found;
    let device = match (&plain, &checked, &thorough) {
        (Some(_), ..) => "any",
        (_, Some(_), _) => "checked",
        (_, _, Some(_)) => "thorough",
        _ => "values",
    };
    let text = checked.or(thorough).or(plain).or(value);
    let text = text.unwrap_or_else(|| panic!("nothing finds `{}`", bug.name));
    let (message, line) = shorten(bug, &text);
    let place = ["kernel `", "invocation ["];
    let has_place = place.iter().all(|part| text.contains(part));
    Finding { bug, device, message, line, has_place }
}

/// The message without the kernel, the place and the invocation; and the line number of the place.
fn shorten(bug: &Bug, text: &str) -> (String, Option<usize>) {
    // machines differ in their separators
    let text = text.replace('\\', "/");
    let text = text.split_once("`: ").map_or(text.as_str(), |(_, message)| message);
    let file = format!("{}/{}.rs:", bug.kind, bug.name);
    let mut pieces = text.split(&file);
    let mut message = pieces.next().unwrap_or_default().to_owned();
    let mut line = None;
    for piece in pieces {
        let number: String = piece.chars().take_while(char::is_ascii_digit).collect();
        line = line.or(number.parse().ok());
        // the path before the file's folder, and the column
        message.truncate(message.rfind(' ').map_or(0, |space| space + 1));
        let rest =
            piece[number.len()..].trim_start_matches(|c: char| c == ':' || c.is_ascii_digit());
        write!(message, "line {number}{rest}").expect("a string");
    }
    let end = [", at line ", ", in invocation ", ", in workgroup "].iter();
    let end = end.filter_map(|end| message.find(end)).min().unwrap_or(message.len());
    message.truncate(end);
    (message, line)
}

/// The lines that are marked as wrong.
fn marked(bug: &Bug) -> Vec<usize> {
    let lines = (1..).zip(bug.source.lines()).filter(|(_, line)| line.ends_with("//~"));
    // a mark on a line of its own belongs to the next line
    lines.map(|(number, line)| number + usize::from(line.trim() == "//~")).collect()
}

/// The part of the page that the test writes.
fn table(findings: &[Finding]) -> String {
    let mut text =
        String::from("| mistake | line | device | message |\n| --- | --- | --- | --- |\n");
    for Finding { bug, device, message, line, .. } in findings {
        let Bug { kind, name, source, .. } = bug;
        let mut lines = source.lines();
        let what = lines.next().and_then(|first| first.strip_prefix("//! "));
        let what = what.unwrap_or_else(|| panic!("{name} does not say what is wrong"));
        let what = what.trim_end_matches('.');
        let code = line.and_then(|line| lines.nth(line - 2)).map_or(String::new(), |code| {
            let code = code.trim().trim_end_matches("//~").trim_end_matches([' ', '{', ';']);
            format!("`{}`", code.replace('|', "\\|"))
        });
        writeln!(text, "| [{what}]({kind}/{name}.rs) | {code} | {device} | {message} |")
            .expect("a string");
    }
    text
}

/// The corpus in the repository.
const FOLDER: &str = "kit/check/tests/corpus";

/// The end of the part that people write.
const BEGIN: &str = "<!-- The rest of this page is written by a test: see above. -->\n\n";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A message, if the error names a line that is not marked, or not both kernel and invocation.
fn elsewhere(finding: &Finding) -> Option<String> {
    let Finding { bug, device, message, line, has_place } = finding;
    let marked = marked(bug);
    let is_there = match line {
        Some(line) => marked.contains(line) && *has_place,
        // for wrong values, nothing says where they come from
        None => marked.is_empty() || *device == "values",
    };
    (!is_there).then(|| format!("{}: {message}: at {line:?}, not {marked:?}", bug.name))
}

#[test]
fn every_file_is_in_the_corpus() {
    let folder = fs::read_dir(root().join(FOLDER)).unwrap().map(|entry| entry.unwrap().path());
    let files: usize = folder.filter_map(|kind| fs::read_dir(kind).ok()).map(Iterator::count).sum();
    assert_eq!(files, BUGS.len(), "a file is missing in the list of main.rs");
}

#[test]
#[cfg(debug_assertions)]
fn the_page_lists_every_finding() {
    let findings: Vec<_> = BUGS.iter().map(find).collect();
    let wrong: Vec<_> = findings.iter().filter_map(elsewhere).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let path = root().join(FOLDER).join("README.md");
    let page = fs::read_to_string(&path).unwrap();
    let (begin, rest) = page.split_once(BEGIN).expect("the page's beginning");
    let table = table(&findings);
    if std::env::var_os("MUSLIN_WRITE_CORPUS").is_some() {
        fs::write(&path, [begin, BEGIN, &table].concat()).unwrap();
        return;
    }
    let differs = rest.lines().zip(table.lines()).find(|(page, found)| page != found);
    assert!(
        rest == table,
        "the page differs from what is found: {differs:?}; MUSLIN_WRITE_CORPUS=1 writes it"
    );
}
