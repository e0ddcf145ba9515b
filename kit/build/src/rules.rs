//! Rules for the source of kernels, and of the functions that they call. The compiler does not know them.
//!
//! - Loops are counted: functions that have some are `#[kernel]` or `#[loops]`, and no iterator loops by itself.
//! - Elementary functions come from `muslin::math`: a test on the CPU accepts `x.sin()`, and the compiler for GPUs does not know it.
//! - A loop ends at its condition: naga's reader miscompiles exits through several levels of control flow.
//! - Nothing panics: a GPU leaves out the rest of the invocation, without a message.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{
    Attribute, BinOp, Expr, ExprBinary, ExprCall, ExprField, ExprLit, ExprMethodCall, Field, FnArg,
    ImplItemFn, Item, ItemFn, Lit, Local, Macro, Member, Pat, ReturnType, Signature, Stmt,
    TraitItemFn, Type,
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
        false => bail!("{}", broken.join("\n")),
    }
}

/// Checks a file, and the files of its modules, which are in `folder`.
fn check_file(path: &Path, folder: &Path, broken: &mut Vec<String>) -> Result<()> {
    let text =
        fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    let file = syn::parse_file(&text).with_context(|| path.display().to_string())?;
    let mut found = WithArrays(["to_array".to_owned()].into());
    found.visit_file(&file);
    let mut rules = Rules::new(path.display().to_string(), found, broken);
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

/// Names of fields that are arrays, and of functions that return one, in a file.
struct WithArrays(HashSet<String>);

impl<'ast> Visit<'ast> for WithArrays {
    fn visit_field(&mut self, field: &'ast Field) {
        let name = field.ident.as_ref().filter(|_| is_array_type(&field.ty));
        self.0.extend(name.map(Ident::to_string));
    }

    fn visit_signature(&mut self, signature: &'ast Signature) {
        if let ReturnType::Type(_, ty) = &signature.output
            && is_array_type(ty)
        {
            self.0.insert(signature.ident.to_string());
        }
    }
}

/// A function that is looked at.
struct Function {
    name: String,
    /// Whether its loops are not counted.
    is_uncounted: bool,
    /// Whether the compiler can run it.
    is_const: bool,
}

/// Methods that the compiler for GPUs lacks, and what to write. A test on the CPU has them.
const METHODS: [(&str, &str); 19] = [
    (
        "sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh ln exp2 log2 saturating_add saturating_sub \
         isqrt",
        "use `math::NAME`",
    ),
    ("round_ties_even", "use `math::round_even`"),
    ("powf", "use `math::pow`"),
    ("log10", "GPUs lack it; write `math::ln(x) * core::f32::consts::LOG10_E`"),
    ("log", "GPUs lack it; write the quotient of two `math::ln`"),
    ("ilog", "GPUs lack it; divide in a `for` loop"),
    ("powi", "GPUs lack it; write the product, or `math::pow`"),
    ("hypot", "GPUs lack it; write `math::sqrt(x * x + y * y)`"),
    ("cbrt", "GPUs lack it; write `math::pow(x, 1.0 / 3.0)`, for x from 0 on"),
    ("sin_cos", "GPUs lack it; write `math::sin(x)` and `math::cos(x)`"),
    ("midpoint", "GPUs lack it; write the sum of the halves"),
    ("exp_m1", "GPUs lack it; write `math::exp(x) - 1.0`"),
    ("ln_1p", "GPUs lack it; write `math::ln(1.0 + x)`"),
    ("chebyshev_distance", "the compiler for GPUs lacks it; write `(a - b).abs().max_element()`"),
    ("to_be_bytes to_le_bytes to_ne_bytes", "GPUs have no pointers; shift, and mask with 0xff"),
    (
        "sort sort_unstable sort_by sort_unstable_by sort_unstable_by_key",
        "GPUs have no pointers; compare and exchange elements",
    ),
    ("iter_mut windows chunks chunks_exact", "GPUs have no pointers; count with an index"),
    ("copy_from_slice", "GPUs have no pointers; assign the elements, or the array"),
    ("zip", "the compiler for GPUs is wrong in it; write one `if let` within the other"),
];

/// Methods of integers, and numbers, that GPUs lack.
const PRODUCTS: &str = "pow wrapping_pow checked_pow checked_mul overflowing_mul saturating_mul";
const WIDE: &str = "u64 i64 u128 i128 f64";

/// What to write instead.
const OF_PRODUCTS: &str =
    "GPUs lack it; use products of `u32`, and `math::multiply_high` for the upper half of one";

/// Methods of iterators that loop, and take a closure.
const ITERATORS: &str = "fold rfold try_fold for_each try_for_each reduce any all find_map position rposition \
    min_by max_by min_by_key max_by_key";

/// Methods of iterators that loop within one round of a `for` loop.
const SKIPPING: &str = "filter filter_map skip_while flat_map flatten map_while";

/// Methods of iterators that the compiler cannot take apart.
const UNKNOWN: &str = "map chain copied cloned inspect scan peekable cycle";

/// Methods of ranges that do not loop.
const OF_RANGES: &str = "contains is_empty len start end";

/// Macros that panic.
const PANICS: &str = "assert assert_eq assert_ne panic unreachable todo unimplemented";

/// Whether a name is one of these, which are separated by spaces.
fn is_one_of(names: &str, name: &str) -> bool {
    names.split_whitespace().any(|one| one == name)
}

struct Rules<'a> {
    file: String,
    function: Option<Function>,
    /// Number of loops around what is looked at, within its function.
    loops: u32,
    /// Variables of the function that are ranges or other iterators.
    iterators: HashSet<Ident>,
    /// Variables of the function that are arrays.
    arrays: HashSet<Ident>,
    with_arrays: WithArrays,
    broken: &'a mut Vec<String>,
}

impl<'a> Rules<'a> {
    fn new(file: String, with_arrays: WithArrays, broken: &'a mut Vec<String>) -> Self {
        Self {
            file,
            with_arrays,
            function: None,
            loops: 0,
            iterators: HashSet::new(),
            arrays: HashSet::new(),
            broken,
        }
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
        let named = |is: fn(&Type) -> bool| {
            signature.inputs.iter().filter_map(move |argument| parameter(argument, is)).collect()
        };
        let iterators = std::mem::replace(&mut self.iterators, named(is_range));
        let arrays = std::mem::replace(&mut self.arrays, named(is_array_type));
        visit(self);
        self.function = outer;
        self.loops = loops;
        self.iterators = iterators;
        self.arrays = arrays;
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

    /// Whether an expression is seen to be a range, or an iterator over one or over an array.
    fn is_iterator(&self, expression: &Expr) -> bool {
        match expression {
            Expr::Paren(of) => self.is_iterator(&of.expr),
            Expr::Range(_) => true,
            Expr::Path(of) => of.path.get_ident().is_some_and(|name| self.iterators.contains(name)),
            Expr::MethodCall(call) => {
                let is = |names| is_one_of(names, &call.method.to_string());
                let is_first = call.args.is_empty() && is("iter into_iter");
                is_first || self.is_iterator(&call.receiver) && !is(OF_RANGES)
            }
            _ => false,
        }
    }

    /// Whether an expression is seen to be an array.
    fn is_array(&self, expression: &Expr) -> bool {
        let is_named = |name: &Ident| self.with_arrays.0.contains(&name.to_string());
        match expression {
            Expr::Field(ExprField { member: Member::Named(name), .. }) => is_named(name),
            Expr::MethodCall(call) => is_named(&call.method),
            Expr::Call(call) => {
                let Expr::Path(of) = &*call.func else { return false };
                of.path.segments.last().is_some_and(|name| is_named(&name.ident))
            }
            Expr::Paren(of) => self.is_array(&of.expr),
            Expr::Reference(of) => self.is_array(&of.expr),
            Expr::Path(of) => of.path.get_ident().is_some_and(|name| self.arrays.contains(name)),
            expression => matches!(expression, Expr::Array(_) | Expr::Repeat(_)),
        }
    }

    /// What only a compiler can compute, in a `const fn`.
    fn at_run_time(&mut self, span: Span, what: &str, remedy: &str) {
        if self.function.as_ref().is_some_and(|function| !function.is_const) {
            self.report(span, what, remedy);
        }
    }

    /// An iterator that loops: neither the CPU nor the limits of GPUs know how often.
    fn iterator(&mut self, span: Span, what: &str) {
        let remedy = "nothing counts the rounds of an iterator; write a `for` loop";
        self.at_run_time(span, what, remedy);
    }

    /// A `for` loop over what the compiler cannot take apart.
    fn unknown(&mut self, of: &Expr) {
        let Expr::MethodCall(call) = of else { return };
        let name = call.method.to_string();
        if is_one_of(UNKNOWN, &name) && self.is_iterator(&call.receiver) {
            let remedy = "the compiler for GPUs lacks it; compute it within the loop";
            self.report(call.method.span(), &format!("`.{name}()`"), remedy);
        }
    }

    /// What a `for` loop goes over: a range or an array, maybe with methods that take one step for each round.
    fn iterated(&mut self, of: &Expr) {
        match of {
            Expr::Paren(of) => self.iterated(&of.expr),
            Expr::MethodCall(call) if self.is_iterator(&call.receiver) => {
                let name = call.method.to_string();
                if is_one_of(SKIPPING, &name) {
                    self.iterator(call.method.span(), &format!("`.{name}()`"));
                }
                self.iterated(&call.receiver);
                call.args.iter().for_each(|argument| self.visit_expr(argument));
            }
            of => self.visit_expr(of),
        }
    }

    /// What ends an invocation with a panic. On a GPU there is no message, and its element remains unwritten.
    fn panics(&mut self, span: Span, what: &str, remedy: &str) {
        let remedy = format!("where it panics, a GPU silently leaves out the rest; {remedy}");
        self.at_run_time(span, what, &remedy);
    }

    fn method(&mut self, call: &ExprMethodCall) {
        let span = call.method.span();
        let name = call.method.to_string();
        let what = format!("`.{name}()`");
        let is_iterator = self.is_iterator(&call.receiver) && !is_one_of(OF_RANGES, &name);
        let adds = ["sum", "product"].contains(&&*name) && call.turbofish.is_some();
        let has_closure = call.args.iter().any(|argument| matches!(argument, Expr::Closure(_)));
        if is_iterator || adds || has_closure && is_one_of(ITERATORS, &name) {
            return self.iterator(span, &what);
        }
        if let Some((_, remedy)) = METHODS.iter().find(|(names, _)| is_one_of(names, &name)) {
            return self.report(span, &what, &remedy.replace("NAME", &name));
        }
        match &*name {
            name if is_one_of(PRODUCTS, name) => self.at_run_time(span, &what, OF_PRODUCTS),
            "swap" if call.args.len() == 2 => {
                let remedy = "GPUs have no pointers; keep one of both in a variable";
                self.report(span, &what, remedy);
            }
            name if name.starts_with("strict_") => {
                let remedy = "use the method of this name with `checked_` or `wrapping_`";
                self.panics(span, &what, remedy);
            }
            "unwrap" | "expect" => self.panics(span, &what, "use `unwrap_or`, or `if let`"),
            "clamp" if !call.args.iter().all(is_constant) => {
                let remedy = "use `.max(low).min(high)`, which takes a low above the high, too";
                self.panics(span, &what, remedy);
            }
            _ => {}
        }
    }

    /// A function of core that loops, or that makes an integer of bytes.
    fn call(&mut self, call: &ExprCall) {
        let Expr::Path(function) = &*call.func else { return };
        let segments = &function.path.segments;
        let names: Vec<_> = segments.iter().map(|segment| segment.ident.to_string()).collect();
        let span = function.span();
        let what = format!("`{}()`", names.join("::"));
        match names.last().map(String::as_str) {
            Some("from_be_bytes" | "from_le_bytes" | "from_ne_bytes") => {
                self.report(
                    span,
                    &what,
                    "GPUs have no pointers; shift the bytes, and put them together with `|`",
                );
            }
            _ if names.iter().rev().nth(1).is_some_and(|module| module == "iter") => {
                self.iterator(span, &what);
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

    fn visit_local(&mut self, local: &'ast Local) {
        visit::visit_local(self, local);
        let (pattern, is_array) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, is_array_type(&typed.ty)),
            pattern => (pattern, false),
        };
        if let (Pat::Ident(name), Some(init)) = (pattern, &local.init) {
            let is = [self.is_iterator(&init.expr), is_array || self.is_array(&init.expr)];
            for (names, is) in [&mut self.iterators, &mut self.arrays].into_iter().zip(is) {
                match is {
                    true => names.insert(name.ident.clone()),
                    false => names.remove(&name.ident),
                };
            }
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
            Expr::ForLoop(of) => {
                self.uncounted(of.span());
                self.unknown(&of.expr);
                self.iterated(&of.expr);
                self.loops += 1;
                self.visit_block(&of.body);
                self.loops -= 1;
                return;
            }
            Expr::While(_) | Expr::Loop(_) => {
                self.uncounted(expression.span());
                self.loops += 1;
                visit::visit_expr(self, expression);
                self.loops -= 1;
                return;
            }
            Expr::MethodCall(call) if self.is_iterator(&call.receiver) => {
                self.method(call);
                self.iterated(&call.receiver);
                return call.args.iter().for_each(|argument| self.visit_expr(argument));
            }
            Expr::Call(call) => self.call(call),
            Expr::Return(_) if self.loops > 0 => self.exit(expression.span(), "return"),
            Expr::Break(_) => self.exit(expression.span(), "break"),
            Expr::Continue(_) => self.exit(expression.span(), "continue"),
            Expr::MethodCall(call) => self.method(call),
            Expr::Binary(of)
                if matches!(of.op, BinOp::Eq(_) | BinOp::Ne(_))
                    && (self.is_array(&of.left) || self.is_array(&of.right)) =>
            {
                let remedy = "GPUs have no pointers; compare the elements";
                self.report(of.op.span(), "a comparison of arrays", remedy);
            }
            Expr::Binary(of)
                if can_grow(of)
                    && self.function.as_ref().is_some_and(|of| of.is_uncounted && !of.is_const) =>
            {
                let remedy = "it has 64 bits on the CPU and 32 on a GPU; use `u32`, or put `#[loops]` on the function: then the CPU run looks at it";
                self.report(of.op.span(), "arithmetic in `usize`", remedy);
            }
            Expr::Cast(cast) => {
                if let Type::Path(ty) = &*cast.ty
                    && let Some(name) = ty.path.get_ident().map(Ident::to_string)
                    && is_one_of(WIDE, &name)
                {
                    let remedy =
                        if name == "f64" { "GPUs lack it; use `f32`" } else { OF_PRODUCTS };
                    self.at_run_time(ty.span(), &format!("`{name}`"), remedy);
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
        if is_one_of(PANICS, &name) {
            let remedy = "use `debug_assert!`, which only debug builds on the CPU check";
            self.panics(of.span(), &format!("`{name}!`"), remedy);
        }
        self.tokens(of.tokens.clone());
    }
}

/// The name of a parameter of a type.
fn parameter(argument: &FnArg, is_meant: fn(&Type) -> bool) -> Option<Ident> {
    let FnArg::Typed(argument) = argument else { return None };
    let Pat::Ident(name) = &*argument.pat else { return None };
    is_meant(&argument.ty).then(|| name.ident.clone())
}

fn is_range(ty: &Type) -> bool {
    let Type::Path(ty) = ty else { return false };
    ty.path.segments.last().is_some_and(|name| name.ident.to_string().starts_with("Range"))
}

fn is_array_type(ty: &Type) -> bool {
    match ty {
        Type::Reference(of) => is_array_type(&of.elem),
        ty => matches!(ty, Type::Array(_)),
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

/// Whether an expression is a number, the name of a constant, or made of these, as `Vec3::splat(1.0)`.
fn is_constant(expression: &Expr) -> bool {
    match expression {
        Expr::Lit(_) => true,
        Expr::Call(call) => call.args.iter().all(is_constant),
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
        let expected = "lib.rs:3: `.sin()` in `wave`: use `math::sin`";
        let message = broken(text);
        assert!(message.contains(expected), "{message}");
        assert!(!message.contains("cos"), "{message}");
    }

    #[test]
    fn iterators_do_not_loop_by_themselves() {
        let body = |body: &str| {
            broken(&format!("#[kernel(threads(64), iterations = 9)]\nfn f() {{\n    {body}\n}}\n"))
        };
        for (wrong, what) in [
            ("let y = (0..n).fold(0, |a, b| a + b);", "`.fold()`"),
            ("let y: u32 = (0..n).map(|k| k * 3).sum();", "`.sum()`"),
            ("let y = (0..n).rev().max();", "`.max()`"),
            ("let y = numbers.iter().sum::<u32>();", "`.sum()`"),
            ("let y = all.into_iter().any(|k| k > 3);", "`.any()`"),
            ("let all = 0..n; let y = all.count();", "`.count()`"),
            ("for k in (0..n).filter(|k| k % 2 == 0) {}", "`.filter()`"),
            (
                "let y = core::iter::successors(Some(1), |k| Some(k + 1));",
                "`core::iter::successors()`",
            ),
        ] {
            let message = body(wrong);
            let start = format!("lib.rs:3: {what} in `f`: nothing counts the rounds");
            assert!(message.contains(&start), "{wrong}: {message}");
            assert_eq!(message.lines().count(), 1, "{message}");
        }
        let message = body("for k in (0..n).map(|k| 2 * k) {}");
        assert!(message.contains("lib.rs:3: `.map()` in `f`: the compiler for GPUs lacks it"));
        for right in [
            "for k in 0..n {}",
            "for k in (0..n).rev() {}",
            "let all = 0..n; for k in all {}",
            "for (k, x) in numbers.iter().enumerate() {}",
            "if (0..n).contains(&k) {}",
            "let y = x.sum() + mask.any() as u32;",
            "match k { 0..3 => {} _ => {} }",
            "let part = &numbers[1..3];",
            "let y = x.max(3);",
        ] {
            assert_eq!(body(right), "", "{right}");
        }
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
            ("let y = z.strict_add(3);", "`.strict_add()`", "with `checked_` or `wrapping_`"),
            ("let y = z.pow(3);", "`.pow()`", "use products"),
            (
                "let y = 3 * (z as usize);",
                "arithmetic in `usize`",
                "put `#[loops]` on the function",
            ),
            ("let y = z.clamp(x.low, 6);", "`.clamp()`", "use `.max(low).min(high)`"),
            ("let y = z.log10();", "`.log10()`", "LOG10_E`"),
            ("let y = z.to_be_bytes();", "`.to_be_bytes()`", "mask with 0xff"),
            ("let y = u32::from_be_bytes(z);", "`u32::from_be_bytes()`", "shift the bytes"),
            ("z.swap(1, 2);", "`.swap()`", "keep one of both in a variable"),
            ("let y = z == [1, 2];", "a comparison of arrays", "compare the elements"),
            ("let y = z.to_array() == w;", "a comparison of arrays", "compare the elements"),
            (
                "struct Row { all: [u32; 2] } let y = z.all == w.all;",
                "a comparison of arrays",
                "compare the elements",
            ),
            (
                "let a: [u32; 2] = z; let y = a != z;",
                "a comparison of arrays",
                "compare the elements",
            ),
        ] {
            let message = body(wrong);
            assert!(message.contains(&format!("lib.rs:2: {what} in `f`: ")), "{message}");
            assert!(message.ends_with(remedy) || message.contains(remedy), "{message}");
        }
        for right in [
            "debug_assert!(x == None);",
            "const { assert!(SIDE == 4) };",
            "const ALL: () = assert!(SIDE == 4);",
            "let y = z.clamp(-1.0, MAX);",
            "let y = z.clamp(Vec3::ZERO, Vec3::splat(2.0));",
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
        assert_eq!(message.lines().count(), 3, "{message}");
    }
}
