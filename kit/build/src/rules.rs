//! Rules for the source of kernels, and of the functions that they call. The compiler does not know them.
//!
//! - Loops are counted: functions that have some are `#[kernel]` or `#[loops]`.
//! - Elementary functions are those of `muslin::math`: a test on the CPU accepts `x.sin()`, and the compiler for GPUs does not know it.
//! - A loop ends at its condition: naga's reader miscompiles exits through several levels of control flow.
//! - Nothing panics: a GPU leaves out the rest of the invocation, without a message.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use proc_macro2::{Span, TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{
    Attribute, BinOp, Expr, ExprBinary, ExprLit, ExprMethodCall, ImplItemFn, Item, ItemFn, Lit,
    Macro, Signature, Stmt, TraitItemFn, Type,
};

/// Checks the sources of a crate of kernels.
///
/// # Errors
/// A line for each place that breaks a rule: its file, its line and its function.
pub fn check(shader_crate: &Path) -> Result<()> {
    let mut broken = Vec::new();
    let folder = shader_crate.join("src");
    check_file(&folder.join("lib.rs"), &folder, &mut broken)?;
    match broken.is_empty() {
        true => Ok(()),
        false => bail!("kernels break rules of the language:\n  {}", broken.join("\n  ")),
    }
}

/// Checks a file, and those of its modules, which are in `folder`.
fn check_file(path: &Path, folder: &Path, broken: &mut Vec<String>) -> Result<()> {
    let text =
        fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    let file = syn::parse_file(&text).with_context(|| path.display().to_string())?;
    let mut rules = Rules::new(path.display().to_string(), broken);
    rules.visit_file(&file);
    check_modules(&file.items, path, folder, broken)
}

/// Checks the files that items name with `mod`. Other files are not compiled.
fn check_modules(
    items: &[Item],
    path: &Path,
    folder: &Path,
    broken: &mut Vec<String>,
) -> Result<()> {
    for item in items {
        let Item::Mod(module) = item else { continue };
        if is_of_host(&module.attrs) {
            continue;
        }
        let inner = folder.join(module.ident.to_string());
        if let Some((_, items)) = &module.content {
            check_modules(items, path, &inner, broken)?;
            continue;
        }
        let own = path.parent().unwrap_or(folder);
        let named = module.attrs.iter().find_map(path_of).map(|path| own.join(path));
        let files = [inner.with_extension("rs"), inner.join("mod.rs")];
        let found = named.into_iter().chain(files).find(|file| file.exists());
        // where there is none, the compiler complains
        if let Some(file) = found {
            check_file(&file, &inner, broken)?;
        }
    }
    Ok(())
}

/// The path of `#[path = "path"]`.
fn path_of(attribute: &Attribute) -> Option<String> {
    let value = &attribute.meta.require_name_value().ok()?.value;
    match value {
        Expr::Lit(ExprLit { lit: Lit::Str(path), .. }) if attribute.path().is_ident("path") => {
            Some(path.value())
        }
        _ => None,
    }
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
    /// Whether the compiler can run it.
    is_const: bool,
}

/// Methods of `f32` that only a test on the CPU has, and others that the compiler for GPUs lacks. `muslin::math` has some of them.
const ELEMENTARY: [&str; 12] = [
    "sin",
    "cos",
    "tan",
    "ln",
    "log2",
    "log10",
    "asin",
    "acos",
    "atan",
    "saturating_add",
    "saturating_sub",
    "isqrt",
];

/// Methods of integers that the compiler for GPUs lacks.
const PRODUCTS: [&str; 7] = [
    "pow",
    "wrapping_pow",
    "checked_pow",
    "checked_mul",
    "overflowing_mul",
    "saturating_mul",
    "midpoint",
];

/// Numbers that GPUs lack.
const WIDE: [&str; 5] = ["u64", "i64", "u128", "i128", "f64"];

/// Macros that panic.
const PANICS: [&str; 7] =
    ["assert", "assert_eq", "assert_ne", "panic", "unreachable", "todo", "unimplemented"];

struct Rules<'a> {
    file: String,
    function: Option<Function>,
    /// Number of loops around what is looked at, within its function.
    loops: u32,
    broken: &'a mut Vec<String>,
}

impl<'a> Rules<'a> {
    fn new(file: String, broken: &'a mut Vec<String>) -> Self {
        Self { file, function: None, loops: 0, broken }
    }

    fn report(&mut self, span: Span, what: &str, remedy: &str) {
        let line = span.start().line;
        let file = &self.file;
        let name = self.function.as_ref().map_or("a macro", |function| &function.name);
        self.broken.push(format!("{file}:{line}: {what} in `{name}`: {remedy}"));
    }

    /// Visits a function.
    fn function(
        &mut self,
        attributes: &[Attribute],
        signature: &Signature,
        visit: impl FnOnce(&mut Self),
    ) {
        let counts = |attribute: &Attribute| {
            let name = attribute.path().segments.last();
            name.is_some_and(|name| name.ident == "kernel" || name.ident == "loops")
        };
        // the compiler computes what is constant
        let is_counted = signature.constness.is_some() || attributes.iter().any(counts);
        let name = signature.ident.to_string();
        let is_const = signature.constness.is_some();
        let function = Function { name, is_uncounted: !is_counted, is_const };
        let outer = self.function.replace(function);
        let loops = std::mem::take(&mut self.loops);
        visit(self);
        self.function = outer;
        self.loops = loops;
    }

    fn uncounted(&mut self, span: Span) {
        if self.function.as_ref().is_some_and(|function| function.is_uncounted) {
            self.report(span, "a loop that nothing counts", "put `#[loops]` on the function");
        }
    }

    fn exit(&mut self, span: Span, word: &str) {
        let remedy = "naga miscompiles exits of loops; let the loop's condition decide";
        self.report(span, &format!("`{word}`"), remedy);
    }

    /// What the compiler may still compute.
    fn missing(&mut self, span: Span, what: &str) {
        if self.function.as_ref().is_some_and(|function| !function.is_const) {
            let remedy = "GPUs lack it; use products of `u32`, and `math::multiply_high` for the upper half of one";
            self.report(span, what, remedy);
        }
    }

    /// What ends an invocation with a panic. On a GPU there is no message, and its element remains unwritten.
    fn panics(&mut self, span: Span, what: &str, remedy: &str) {
        if self.function.as_ref().is_some_and(|function| !function.is_const) {
            let remedy = format!("where it panics, a GPU silently leaves out the rest; {remedy}");
            self.report(span, what, &remedy);
        }
    }

    fn method(&mut self, call: &ExprMethodCall) {
        let span = call.method.span();
        let name = call.method.to_string();
        let what = format!("`.{name}()`");
        match &*name {
            name if ELEMENTARY.contains(&name) => {
                self.report(span, &what, "use the functions of `muslin::math`");
            }
            name if PRODUCTS.contains(&name) => self.missing(span, &what),
            "unwrap" | "expect" => self.panics(span, &what, "use `unwrap_or`, or `if let`"),
            "clamp" if !call.args.iter().all(is_constant) => {
                let remedy = "use `.max(low).min(high)`, which takes a low above the high, too";
                self.panics(span, &what, remedy);
            }
            _ => {}
        }
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
            // the compiler computes it
            Item::Const(_) | Item::Static(_) => return,
            _ => return visit::visit_item(self, item),
        };
        if !is_of_host(attributes) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.function(&item.attrs, &item.sig, |rules| visit::visit_item_fn(rules, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        if !is_of_host(&item.attrs) {
            self.function(&item.attrs, &item.sig, |rules| visit::visit_impl_item_fn(rules, item));
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        if !is_of_host(&item.attrs) {
            self.function(&item.attrs, &item.sig, |rules| visit::visit_trait_item_fn(rules, item));
        }
    }

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        let attributes = match statement {
            Stmt::Local(local) => &local.attrs,
            Stmt::Macro(of) => &of.attrs,
            Stmt::Expr(Expr::Block(block), _) => &block.attrs,
            _ => return visit::visit_stmt(self, statement),
        };
        if !is_of_host(attributes) {
            visit::visit_stmt(self, statement);
        }
    }

    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::While(_) | Expr::ForLoop(_) | Expr::Loop(_) => {
                self.uncounted(expression.span());
                self.loops += 1;
                visit::visit_expr(self, expression);
                self.loops -= 1;
                return;
            }
            Expr::Return(_) if self.loops > 0 => self.exit(expression.span(), "return"),
            Expr::Break(_) => self.exit(expression.span(), "break"),
            Expr::Continue(_) => self.exit(expression.span(), "continue"),
            Expr::MethodCall(call) => self.method(call),
            Expr::Binary(of)
                if can_grow(of)
                    && self.function.as_ref().is_some_and(|of| of.is_uncounted && !of.is_const) =>
            {
                let remedy = "it has 64 bits on the CPU and 32 on a GPU; use `u32`, or put `#[loops]` on the function: then the CPU run looks at it";
                self.report(of.op.span(), "arithmetic in `usize`", remedy);
            }
            Expr::Cast(cast) => {
                if let Type::Path(ty) = &*cast.ty
                    && let Some(name) = WIDE.iter().find(|name| ty.path.is_ident(name))
                {
                    self.missing(ty.span(), &format!("`{name}`"));
                }
            }
            // computed by the compiler
            Expr::Const(_) => return,
            _ => {}
        }
        visit::visit_expr(self, expression);
    }

    fn visit_macro(&mut self, of: &'ast Macro) {
        let name = of.path.segments.last().map_or_else(String::new, |name| name.ident.to_string());
        if PANICS.contains(&&*name) {
            let remedy = "use `debug_assert!`, which only debug builds on the CPU check";
            self.panics(of.span(), &format!("`{name}!`"), remedy);
        }
        self.tokens(of.tokens.clone());
    }
}

/// Whether an operation has an operand that is seen to be a `usize`, and a result that can have more bits.
fn can_grow(of: &ExprBinary) -> bool {
    let is_meant = matches!(of.op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Shl(_));
    is_meant && (is_usize(&of.left) || is_usize(&of.right))
}

fn is_usize(operand: &Expr) -> bool {
    match operand {
        Expr::Paren(paren) => is_usize(&paren.expr),
        Expr::Binary(of) => is_usize(&of.left) || is_usize(&of.right),
        Expr::Cast(cast) => matches!(&*cast.ty, Type::Path(ty) if ty.path.is_ident("usize")),
        Expr::MethodCall(call) => call.method == "len",
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.suffix() == "usize",
        _ => false,
    }
}

/// Whether an expression is a number or the name of a constant.
fn is_constant(expression: &Expr) -> bool {
    match expression {
        Expr::Lit(_) => true,
        Expr::Unary(unary) => is_constant(&unary.expr),
        Expr::Path(path) => path.path.segments.last().is_some_and(|name| {
            !name.ident.to_string().contains(|letter: char| letter.is_lowercase())
        }),
        _ => false,
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
    fn uncounted_loops_are_refused_with_line_and_function() {
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
    fn elementary_functions_outside_math_are_refused() {
        let text = "fn wave(x: f32) -> f32 {\n    math::cos(x)\n        + x.sin()\n}\n";
        let expected = "lib.rs:3: `.sin()` in `wave`: use the functions of `muslin::math`";
        let message = broken(text);
        assert!(message.contains(expected), "{message}");
        assert!(!message.contains("cos"), "{message}");
    }

    #[test]
    fn exits_of_loops_have_a_place_and_a_function() {
        let text = "#[kernel(threads(64))]\nfn half(id: Invocation) {\n    if id.index() > 9 {\n        return;\n    }\n}\n";
        assert_eq!(broken(text), "");
        let text = "#[loops]\nfn find() {\n    for i in 0..4 { if i == 2 { break; } else { continue } }\n    while true { return; }\n}\n";
        let message = broken(text);
        let places = [
            "lib.rs:3: `break` in `find`",
            "lib.rs:3: `continue` in `find`",
            "lib.rs:4: `return` in",
        ];
        for part in places {
            assert!(message.contains(part), "{message}");
        }
        let message = broken("macro_rules! early { () => { return; }; }\n");
        assert!(message.contains("lib.rs:1: `return` in `a macro`"), "{message}");
    }

    #[test]
    fn panics_have_a_place_and_a_remedy() {
        let body = |body: &str| broken(&format!("fn f(x: Option<u32>) {{\n    {body}\n}}\n"));
        for (wrong, what, remedy) in [
            ("assert!(x == None);", "`assert!`", "use `debug_assert!`"),
            ("let y = x.unwrap();", "`.unwrap()`", "use `unwrap_or`"),
            ("let y = (z as u64 * 3) >> 32;", "`u64`", "`math::multiply_high`"),
            ("let y = z.pow(3);", "`.pow()`", "use products"),
            (
                "let y = 3 * (z as usize);",
                "arithmetic in `usize`",
                "put `#[loops]` on the function",
            ),
            ("let y = z.clamp(x.low, 6);", "`.clamp()`", "use `.max(low).min(high)`"),
        ] {
            let message = body(wrong);
            assert!(message.contains(&format!("lib.rs:2: {what} in `f`: ")), "{message}");
            assert!(message.ends_with(remedy) || message.contains(remedy), "{message}");
        }
        for right in [
            "debug_assert!(x == None);",
            "const { assert!(SIDE == 4) };",
            "const ALL: () = assert!(SIDE == 4);",
            "let y = z.clamp(-1.0, MOST);",
            "#[cfg(not(target_arch = \"spirv\"))]\n    { assert!(x == None); }",
        ] {
            assert_eq!(body(right), "", "{right}");
        }
    }

    #[test]
    fn files_are_those_that_mod_names() {
        let folder = tempfile::tempdir().unwrap();
        let wrong = "fn f(x: f32) -> f32 { x.sin() }\n";
        for (file, text) in [
            ("lib.rs", "mod waves;\nmod inner { mod deep; }\n#[path = \"other.rs\"] mod named;\n"),
            ("waves.rs", "mod long;\n"),
            ("waves/long.rs", wrong),
            ("inner/deep/mod.rs", wrong),
            ("other.rs", wrong),
            ("draft.rs", "this is no Rust"),
        ] {
            let path = folder.path().join("src").join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        let message = check(folder.path()).unwrap_err().to_string();
        for file in ["long.rs:1", "mod.rs:1", "other.rs:1"] {
            assert!(message.contains(file), "{message}");
        }
        assert_eq!(message.lines().count(), 4, "{message}");
    }
}
