//! Rules for the source of kernels, and of the functions that they call. The compiler does not know them.
//!
//! - Loops are counted: functions that have some are `#[kernel]` or `#[loops]`.
//! - Elementary functions are those of `muslin::math`: a test on the CPU accepts `x.sin()`, and the compiler for GPUs does not know it.
//! - A function has one exit, and a loop ends at its condition: naga's reader miscompiles exits through several levels of control flow.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use proc_macro2::{Span, TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, Expr, ImplItemFn, Item, ItemFn, Macro, Signature, TraitItemFn};

/// Checks the sources of a crate of kernels.
///
/// # Errors
/// A line for each place that breaks a rule: its file, its line and its function.
pub fn check(shader_crate: &Path) -> Result<()> {
    let mut broken = Vec::new();
    check_folder(&shader_crate.join("src"), &mut broken)?;
    match broken.is_empty() {
        true => Ok(()),
        false => bail!("kernels break rules of the language:\n  {}", broken.join("\n  ")),
    }
}

fn check_folder(folder: &Path, broken: &mut Vec<String>) -> Result<()> {
    let context = || format!("cannot read {}", folder.display());
    let entries = fs::read_dir(folder).with_context(context)?;
    let mut paths = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<PathBuf>>>()?;
    paths.sort();
    let mut files = Vec::new();
    let mut on_the_host = BTreeSet::new();
    for path in paths.iter().filter(|path| path.extension().is_some_and(|end| end == "rs")) {
        let text = fs::read_to_string(path)?;
        let file = syn::parse_file(&text).with_context(|| path.display().to_string())?;
        for item in &file.items {
            if let Item::Mod(module) = item
                && is_of_host(&module.attrs)
            {
                on_the_host.insert(module.ident.to_string());
            }
        }
        files.push((path, file));
    }
    let is_on_host = |path: &Path| {
        path.file_stem().is_some_and(|stem| on_the_host.contains(&*stem.to_string_lossy()))
    };
    for (path, file) in files.iter().filter(|(path, _)| !is_on_host(path)) {
        let mut rules = Rules { file: path.display().to_string(), function: None, broken };
        rules.visit_file(file);
    }
    for path in paths.iter().filter(|path| path.is_dir() && !is_on_host(path)) {
        check_folder(path, broken)?;
    }
    Ok(())
}

/// Whether an item exists only on the host.
fn is_of_host(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let syn::Meta::List(list) = &attribute.meta else { return false };
        let text = list.tokens.to_string().replace(' ', "");
        let is_host = text == "test" || text.contains("not(target_arch=\"spirv\")");
        attribute.path().is_ident("cfg") && is_host && !text.starts_with("any(")
    })
}

/// A function that is looked at.
struct Function {
    name: String,
    /// Whether nothing counts its loops.
    is_uncounted: bool,
}

/// Methods of `f32` that only a test on the CPU has. `muslin::math` has some of them.
const ELEMENTARY: [&str; 9] = ["sin", "cos", "tan", "ln", "log2", "log10", "asin", "acos", "atan"];

struct Rules<'a> {
    file: String,
    function: Option<Function>,
    broken: &'a mut Vec<String>,
}

impl Rules<'_> {
    fn report(&mut self, span: Span, what: &str, remedy: &str) {
        let line = span.start().line;
        let file = &self.file;
        let name = self.function.as_ref().map_or("a macro", |function| &function.name);
        self.broken.push(format!("{file}:{line}: {what} in `{name}`: {remedy}"));
    }

    fn function(&mut self, attributes: &[Attribute], signature: &Signature) {
        let counts = |attribute: &Attribute| {
            let name = attribute.path().segments.last();
            name.is_some_and(|name| name.ident == "kernel" || name.ident == "loops")
        };
        // the compiler computes what is constant
        let is_counted = signature.constness.is_some() || attributes.iter().any(counts);
        let name = signature.ident.to_string();
        self.function = Some(Function { name, is_uncounted: !is_counted });
    }

    fn loops(&mut self, span: Span) {
        if self.function.as_ref().is_some_and(|function| function.is_uncounted) {
            self.report(span, "a loop that nothing counts", "put `#[loops]` on the function");
        }
    }

    fn exit(&mut self, span: Span, word: &str) {
        let remedy = match word {
            "return" => "naga miscompiles such exits; put what follows into an `if`",
            _ => "naga miscompiles such exits; let the loop's condition decide",
        };
        self.report(span, &format!("`{word}`"), remedy);
    }

    /// A macro's text is no syntax tree yet.
    fn tokens(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(word) => {
                    let text = word.to_string();
                    if ["break", "continue", "return"].contains(&&*text) {
                        self.exit(word.span(), &text);
                    }
                }
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Rules<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes = match item {
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            Item::Mod(item) => &item.attrs,
            Item::Trait(item) => &item.attrs,
            Item::Macro(item) => &item.attrs,
            _ => return visit::visit_item(self, item),
        };
        if !is_of_host(attributes) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.function(&item.attrs, &item.sig);
        visit::visit_item_fn(self, item);
        self.function = None;
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        if !is_of_host(&item.attrs) {
            self.function(&item.attrs, &item.sig);
            visit::visit_impl_item_fn(self, item);
            self.function = None;
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        if !is_of_host(&item.attrs) {
            self.function(&item.attrs, &item.sig);
            visit::visit_trait_item_fn(self, item);
            self.function = None;
        }
    }

    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::While(_) | Expr::ForLoop(_) | Expr::Loop(_) => self.loops(expression.span()),
            Expr::Return(_) => self.exit(expression.span(), "return"),
            Expr::Break(_) => self.exit(expression.span(), "break"),
            Expr::Continue(_) => self.exit(expression.span(), "continue"),
            Expr::MethodCall(call) if ELEMENTARY.iter().any(|name| call.method == name) => {
                let what = format!("`.{}()`", call.method);
                self.report(call.method.span(), &what, "use the functions of `muslin::math`");
            }
            _ => {}
        }
        visit::visit_expr(self, expression);
    }

    fn visit_macro(&mut self, of: &'ast Macro) {
        self.tokens(of.tokens.clone());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mistake in a source.
    fn broken(source: &str) -> String {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("src")).unwrap();
        fs::write(folder.path().join("src/lib.rs"), source).unwrap();
        check(folder.path()).err().map_or_else(String::new, |error| error.to_string())
    }

    #[test]
    fn a_loop_that_nothing_counts_has_a_place_and_a_function() {
        let helper =
            "fn sum(n: u32) -> u32 {\n    let mut i = 0;\n    while i < n { i += 1; }\n    i\n}\n";
        let message = broken(helper);
        assert!(message.contains("lib.rs:3: a loop that nothing counts in `sum`"), "{message}");
        for counted in ["#[loops]\n", "#[kernel(threads(64), iterations = 8)]\n", "const "] {
            assert_eq!(broken(&format!("{counted}{helper}")), "");
        }
        let host = "#[cfg(not(target_arch = \"spirv\"))]\n";
        assert_eq!(broken(&format!("{host}{helper}")), "");
        assert_eq!(broken(&format!("#[cfg(test)] mod tests {{ {helper} }}")), "");
    }

    #[test]
    fn elementary_functions_are_those_of_math() {
        let text = "fn wave(x: f32) -> f32 {\n    math::cos(x)\n        + x.sin()\n}\n";
        let expected = "lib.rs:3: `.sin()` in `wave`: use the functions of `muslin::math`";
        let message = broken(text);
        assert!(message.contains(expected), "{message}");
        assert!(!message.contains("cos"), "{message}");
    }

    #[test]
    fn exits_have_a_place_and_a_function() {
        let text = "#[kernel(threads(64))]\nfn half(id: Invocation) {\n    if id.index() > 9 {\n        return;\n    }\n}\n";
        let message = broken(text);
        assert!(message.contains("lib.rs:4: `return` in `half`"), "{message}");
        let text = "#[loops]\nfn find() {\n    for i in 0..4 { if i == 2 { break; } else { continue } }\n}\n";
        let message = broken(text);
        for part in ["lib.rs:3: `break` in `find`", "lib.rs:3: `continue` in `find`"] {
            assert!(message.contains(part), "{message}");
        }
        let message = broken("macro_rules! early { () => { return; }; }\n");
        assert!(message.contains("lib.rs:1: `return` in `a macro`"), "{message}");
    }
}
