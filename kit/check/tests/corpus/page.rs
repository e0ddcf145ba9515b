//! Runs the corpus, and compares the page with the results.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use crate::BUGS;
use crate::bug::{Bench, Bug, Found};

/// The check that finds a bug.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Check {
    /// Every run on the CPU.
    Always,
    /// Every run on the CPU in a debug build: Rust checks integers, and loops are counted.
    Debug,
    /// A device for tests.
    Tests,
    /// The device for tests that takes its time.
    Thorough,
    /// The canaries in an output and after it.
    Canaries,
    /// The values.
    Values,
    /// No check.
    Nothing,
}

impl Check {
    const ALL: [Self; 7] = [
        Self::Always,
        Self::Debug,
        Self::Tests,
        Self::Thorough,
        Self::Canaries,
        Self::Values,
        Self::Nothing,
    ];

    const fn name(self) -> &'static str {
        match self {
            Self::Always => "always",
            Self::Debug => "debug builds",
            Self::Tests => "checked device",
            Self::Thorough => "thorough",
            Self::Canaries => "canaries",
            Self::Values => "values",
            Self::Nothing => "**not found**",
        }
    }
}

/// A row of the table.
struct Finding {
    bug: &'static Bug,
    check: Check,
    message: String,
    /// The line that the message names.
    line: Option<usize>,
    /// Whether it names the kernel and an invocation.
    has_place: bool,
}

/// Tests a bug on the ordinary CPU, and on both CPUs for tests.
fn find(bug: &'static Bug) -> Finding {
    let plain = (bug.test)(&Bench::plain()).err();
    let checked = (bug.test)(&Bench::checked()).err();
    let thorough = || (bug.test)(&Bench::thorough()).err();
    let has_message = |found: &Option<Found>| matches!(found, Some(Found::Message(_)));
    if !has_message(&plain)
        && !has_message(&checked)
        && let Some(Found::Message(text)) = thorough()
    {
        return finding(bug, Check::Thorough, &text);
    }
    let (check, text) = match (plain, checked) {
        (Some(Found::Message(text)), _) if is_of_debug_builds(&text) => (Check::Debug, text),
        // the plain device of these tests has a limit of time, those of programs do not
        (Some(Found::Message(_)), Some(Found::Message(text))) if is_of_time(&text) => {
            (Check::Tests, text)
        }
        (Some(Found::Message(text)), _) if !is_of_canaries(&text) => (Check::Always, text),
        (_, Some(Found::Message(text))) if !is_of_canaries(&text) => (Check::Tests, text),
        (Some(Found::Message(text)), _) | (_, Some(Found::Message(text))) => {
            (Check::Canaries, text)
        }
        (Some(Found::Value(text)), _) | (_, Some(Found::Value(text))) => (Check::Values, text),
        (None, None) => (Check::Nothing, String::new()),
    };
    finding(bug, check, &text)
}

/// The text of a message.
fn finding(bug: &'static Bug, check: Check, text: &str) -> Finding {
    let (message, mut line) = shorten(bug, text);
    let marked = marked(bug);
    // a loop is left anywhere in it, so all of it is marked
    if is_of_time(text) && line.is_some_and(|line| marked.contains(&line)) {
        line = marked.first().copied();
    }
    let place = ["kernel `", "invocation ["];
    let has_place = place.iter().all(|part| text.contains(part));
    Finding { bug, check, message, line, has_place }
}

/// Whether a message is about a workgroup that does not end.
fn is_of_time(text: &str) -> bool {
    text.contains("does not end")
}

/// Whether only debug builds give a message.
fn is_of_debug_builds(text: &str) -> bool {
    let parts = [": attempt to ", " more iterations than ", " in the branch of ", " in round "];
    parts.iter().any(|part| text.contains(part))
}

/// Whether a message is about a canary.
fn is_of_canaries(text: &str) -> bool {
    text.ends_with("its output")
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

/// The first line of a file, which describes the mistake.
fn what_is_wrong(bug: &Bug) -> &'static str {
    let first = bug.source.lines().next().unwrap_or_default();
    first.strip_prefix("//! ").unwrap_or_else(|| panic!("{} does not say what is wrong", bug.name))
}

/// The lines that are marked as wrong.
fn marked(bug: &Bug) -> Vec<usize> {
    let lines = (1..).zip(bug.source.lines()).filter(|(_, line)| line.ends_with("//~"));
    // a mark on a line of its own belongs to the next line
    lines.map(|(number, line)| number + usize::from(line.trim() == "//~")).collect()
}

/// The part of the page that the test writes.
fn table(findings: &[Finding]) -> String {
    let count = |check| findings.iter().filter(|finding| finding.check == check).count();
    let mut text = String::from("| found | bugs |\n| --- | ---: |\n");
    for check in Check::ALL.into_iter().filter(|&check| count(check) > 0) {
        writeln!(text, "| {} | {} |", check.name(), count(check)).expect("a string");
    }
    writeln!(text, "| in all | {} |", findings.len()).expect("a string");
    let mut kind = "";
    for Finding { bug, check, message, line, .. } in findings {
        if bug.kind != kind {
            kind = bug.kind;
            let title = kind.replace('_', " ");
            let title = title[..1].to_uppercase() + &title[1..];
            let head = "| wrong kernel | what is wrong | found | message | line |\n| --- | --- | --- | --- | ---: |";
            writeln!(text, "\n### {title}\n\n{head}").expect("a string");
        }
        let name = bug.name;
        let what = what_is_wrong(bug);
        let check = check.name();
        let line = line.map_or(String::new(), |line| line.to_string());
        let file = format!("../{FOLDER}/{kind}/{name}.rs");
        writeln!(text, "| [{name}]({file}) | {what} | {check} | {message} | {line} |")
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
    let Finding { bug, check, message, line, has_place } = finding;
    let marked = marked(bug);
    let is_there = match line {
        Some(line) => marked.contains(line) && *has_place,
        // for wrong values, nothing says where they come from
        None => marked.is_empty() || matches!(check, Check::Values | Check::Nothing),
    };
    (!is_there).then(|| format!("{}: {message}: at {line:?}, not {marked:?}", bug.name))
}

#[test]
fn every_file_is_in_the_corpus() {
    let folder = root().join(FOLDER);
    let mut files = 0;
    for kind in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let kind = if kind.is_dir() { kind } else { continue };
        files += fs::read_dir(kind).unwrap().count();
    }
    assert_eq!(files, BUGS.len(), "a file is missing in the list of main.rs");
}

#[test]
#[cfg(debug_assertions)]
fn the_page_is_what_is_found() {
    let findings: Vec<_> = BUGS.iter().map(find).collect();
    let wrong: Vec<_> = findings.iter().filter_map(elsewhere).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let path = root().join("docs/corpus.md");
    let page = fs::read_to_string(&path).unwrap();
    let (begin, rest) = page.split_once(BEGIN).expect("the page's beginning");
    let table = table(&findings);
    if std::env::var_os("MUSLIN_WRITE_CORPUS").is_some() {
        fs::write(&path, [begin, BEGIN, &table].concat()).unwrap();
    } else {
        let differs = rest.lines().zip(table.lines()).find(|(page, found)| page != found);
        assert!(
            rest == table,
            "docs/corpus.md differs from what is found: {differs:?}; MUSLIN_WRITE_CORPUS=1 writes it"
        );
    }
    let found = findings.iter().filter(|finding| finding.check != Check::Nothing).count();
    assert!(found * 100 >= findings.len() * 95, "{found} of {} are found", findings.len());
}
