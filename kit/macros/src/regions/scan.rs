//! What expressions and statements use, change and leave.

use std::collections::{HashMap, HashSet};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprMethodCall, Ident, Item, Lifetime, Macro, Member, Pat, PatIdent, UnOp};

use super::Kept;

/// The methods of `Invocation` at which a kernel is cut.
const BARRIERS: [&str; 2] = ["barrier", "storage_barrier"];

/// Its other methods that are known here: nothing waits in them.
const METHODS: [&str; 4] = ["global", "index", "local_index", "workgroup_index"];

/// Its fields.
const FIELDS: [&str; 5] = ["local", "workgroup", "workgroups", "size", "each"];

/// Macros that neither jump, nor wait, nor declare.
const MACROS: [&str; 14] = [
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "debug_assert_ne",
    "matches",
    "panic",
    "unreachable",
    "print",
    "println",
    "eprint",
    "eprintln",
    "stringify",
];

/// Methods that only compute, of numbers and vectors.
pub const PURE: [&str; 34] = [
    "abs",
    "abs_diff",
    "clamp",
    "count_ones",
    "count_zeros",
    "div_ceil",
    "ilog2",
    "is_multiple_of",
    "is_power_of_two",
    "isqrt",
    "leading_zeros",
    "max",
    "max_element",
    "min",
    "min_element",
    "next_multiple_of",
    "next_power_of_two",
    "pow",
    "reverse_bits",
    "rem_euclid",
    "rotate_left",
    "rotate_right",
    "saturating_add",
    "saturating_sub",
    "signum",
    "swap_bytes",
    "to_bits",
    "trailing_zeros",
    "unsigned_abs",
    "wrapping_add",
    "wrapping_mul",
    "wrapping_neg",
    "wrapping_sub",
    "xyz",
];

/// Whether a name is one of a list.
pub fn is_one_of(name: &Ident, list: &[&str]) -> bool {
    list.iter().any(|of| name == of)
}

/// Whether an expression is this name.
pub fn is_name(expression: &Expr, name: &Ident) -> bool {
    matches!(expression, Expr::Path(path) if path.qself.is_none() && path.path.is_ident(name))
}

/// The barrier that an expression is.
pub fn barrier<'a>(expression: &'a Expr, id: &Ident) -> Option<&'a Ident> {
    let Expr::MethodCall(ExprMethodCall { receiver, method, .. }) = expression else { return None };
    (is_name(receiver, id) && is_one_of(method, &BARRIERS)).then_some(method)
}

/// Whether something has a barrier.
pub fn has_barrier(id: &Ident, visit: impl FnOnce(&mut dyn FnMut(&Expr))) -> bool {
    let mut found = false;
    visit(&mut |expression| found |= barrier(expression, id).is_some());
    found
}

/// Calls a function with every expression, from the outside in. A function in a function is another one.
pub struct Each<'a>(pub &'a mut dyn FnMut(&Expr));

impl<'ast> Visit<'ast> for Each<'_> {
    fn visit_expr(&mut self, expression: &'ast Expr) {
        (self.0)(expression);
        visit::visit_expr(self, expression);
    }

    fn visit_item(&mut self, _: &'ast Item) {}
}

/// The names in a macro's tokens, also in those of format strings.
fn words(tokens: TokenStream, found: &mut HashSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => words(group.stream(), found),
            TokenTree::Punct(_) => {}
            word => {
                let text = word.to_string();
                let names = text.split(|c: char| c != '_' && !c.is_alphanumeric());
                found.extend(names.map(str::to_owned));
            }
        }
    }
}

/// What the whole body of a kernel has.
pub struct Body<'a> {
    id: &'a Ident,
    /// How often each name is bound.
    pub bound: HashMap<Ident, u32>,
    /// Why it cannot be cut.
    kept: Option<Kept>,
}

impl<'a> Body<'a> {
    /// Looks at a body, whose invocation is called `id`.
    pub fn of(block: &syn::Block, id: &'a Ident) -> Result<Self, Kept> {
        let mut body = Self { id, bound: HashMap::new(), kept: None };
        body.visit_block(block);
        body.kept.map_or(Ok(body), Err)
    }

    fn keep(&mut self, kept: Kept) {
        self.kept.get_or_insert(kept);
    }

    /// A macro's tokens may name the invocation only to use what is known of it.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(name) if name == *self.id => {
                    let dot = tokens.next();
                    let is_dot = matches!(dot, Some(TokenTree::Punct(dot)) if dot.as_char() == '.');
                    let is_known = matches!(tokens.next(), Some(TokenTree::Ident(name)) if is_one_of(&name, &FIELDS) || is_one_of(&name, &METHODS));
                    if !is_dot || !is_known {
                        self.keep("the invocation is passed on");
                    }
                }
                TokenTree::Ident(name) if is_one_of(&name, &["return", "break", "continue"]) => {
                    self.keep("a macro may leave");
                }
                TokenTree::Punct(sign) if sign.as_char() == '?' => self.keep("a macro may leave"),
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Body<'_> {
    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::Field(of) if is_name(&of.base, self.id) => match &of.member {
                Member::Named(name) if is_one_of(name, &FIELDS) => return,
                _ => self.keep("the invocation is passed on"),
            },
            Expr::MethodCall(of) if is_name(&of.receiver, self.id) => {
                if !is_one_of(&of.method, &METHODS) && !is_one_of(&of.method, &BARRIERS) {
                    self.keep("the invocation is passed on");
                }
                return of.args.iter().for_each(|argument| self.visit_expr(argument));
            }
            Expr::Path(_) if is_name(expression, self.id) => {
                self.keep("the invocation is passed on");
            }
            Expr::Path(of)
                if of.path.segments.iter().any(|s| is_one_of(&s.ident, &["Cell", "RefCell"])) =>
            {
                self.keep("what does not look so may change");
            }
            Expr::Async(_)
            | Expr::Await(_)
            | Expr::Yield(_)
            | Expr::TryBlock(_)
            | Expr::Verbatim(_) => {
                self.keep("an expression that is not known");
            }
            _ => {}
        }
        visit::visit_expr(self, expression);
    }

    fn visit_pat_ident(&mut self, pattern: &'ast PatIdent) {
        if pattern.ident == *self.id {
            self.keep("the invocation's name means something else");
        }
        if pattern.by_ref.is_some() {
            self.keep("a pattern borrows");
        }
        *self.bound.entry(pattern.ident.clone()).or_default() += 1;
        visit::visit_pat_ident(self, pattern);
    }

    fn visit_macro(&mut self, of: &'ast Macro) {
        let is_known = of.path.segments.last().is_some_and(|name| is_one_of(&name.ident, &MACROS));
        if !is_known {
            self.keep("a macro that is not known");
        }
        self.tokens(of.tokens.clone());
    }

    fn visit_item(&mut self, item: &'ast Item) {
        if matches!(item, Item::Macro(_)) {
            self.keep("a macro that is not known");
        }
    }
}

/// Whether something is left that it does not contain: a loop, or the kernel.
#[derive(Default)]
pub struct Jumps {
    loops: u32,
    labels: Vec<Lifetime>,
    /// A `break` or `continue` of a loop around it.
    pub leaves_loop: bool,
    /// A `return`, or a `?`.
    pub returns: bool,
}

impl Jumps {
    fn inside(&mut self, label: Option<&syn::Label>, is_loop: bool, visit: impl FnOnce(&mut Self)) {
        self.loops += u32::from(is_loop);
        self.labels.extend(label.map(|label| label.name.clone()));
        visit(self);
        self.loops -= u32::from(is_loop);
        if label.is_some() {
            self.labels.pop();
        }
    }

    fn jump(&mut self, label: Option<&Lifetime>) {
        self.leaves_loop |= match label {
            Some(label) => !self.labels.contains(label),
            None => self.loops == 0,
        };
    }
}

impl<'ast> Visit<'ast> for Jumps {
    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::Break(of) => self.jump(of.label.as_ref()),
            Expr::Continue(of) => self.jump(of.label.as_ref()),
            Expr::Return(_) | Expr::Try(_) => self.returns = true,
            _ => {}
        }
        match expression {
            Expr::While(of) => {
                self.inside(of.label.as_ref(), true, |s| visit::visit_expr_while(s, of))
            }
            Expr::ForLoop(of) => {
                self.inside(of.label.as_ref(), true, |s| visit::visit_expr_for_loop(s, of))
            }
            Expr::Loop(of) => {
                self.inside(of.label.as_ref(), true, |s| visit::visit_expr_loop(s, of))
            }
            Expr::Block(of) => {
                self.inside(of.label.as_ref(), false, |s| visit::visit_expr_block(s, of))
            }
            // a closure leaves itself
            Expr::Closure(_) => {}
            _ => visit::visit_expr(self, expression),
        }
    }

    fn visit_item(&mut self, _: &'ast Item) {}
}

/// The names that something uses. What it binds itself counts, too.
#[derive(Default)]
pub struct Uses(pub HashSet<String>);

impl<'ast> Visit<'ast> for Uses {
    fn visit_expr_path(&mut self, path: &'ast syn::ExprPath) {
        self.0.extend(path.path.get_ident().map(ToString::to_string));
        visit::visit_expr_path(self, path);
    }

    fn visit_macro(&mut self, of: &'ast Macro) {
        words(of.tokens.clone(), &mut self.0);
    }

    fn visit_item(&mut self, _: &'ast Item) {}
}

/// The variables that something may change.
#[derive(Default)]
pub struct Changes {
    pub names: HashSet<String>,
    /// Whether methods of [`PURE`]'s names, and functions in variables, may do so.
    every_call: bool,
}

impl Changes {
    /// Counts every call of what a variable has.
    pub fn every_call() -> Self {
        Self { every_call: true, ..Self::default() }
    }

    /// The variables in which a place lies, or several places.
    fn place(&mut self, place: &Expr) {
        match place {
            Expr::Field(of) => self.place(&of.base),
            Expr::Index(of) => self.place(&of.expr),
            Expr::Paren(of) => self.place(&of.expr),
            Expr::Group(of) => self.place(&of.expr),
            Expr::Unary(of) if matches!(of.op, UnOp::Deref(_)) => self.place(&of.expr),
            Expr::MethodCall(of) => self.place(&of.receiver),
            Expr::Path(_) | Expr::Tuple(_) | Expr::Array(_) | Expr::Struct(_) | Expr::Call(_) => {
                let mut names = Uses::default();
                names.visit_expr(place);
                self.names.extend(names.0);
            }
            _ => {}
        }
    }
}

impl<'ast> Visit<'ast> for Changes {
    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::Assign(of) => self.place(&of.left),
            Expr::Binary(of) if is_assignment(&of.op) => self.place(&of.left),
            Expr::Reference(of) if of.mutability.is_some() => self.place(&of.expr),
            Expr::RawAddr(of) => self.place(&of.expr),
            Expr::MethodCall(of) if self.every_call || !is_one_of(&of.method, &PURE) => {
                self.place(&of.receiver);
            }
            Expr::Call(of) if self.every_call => self.place(&of.func),
            _ => {}
        }
        visit::visit_expr(self, expression);
    }

    fn visit_macro(&mut self, of: &'ast Macro) {
        words(of.tokens.clone(), &mut self.names);
    }

    fn visit_item(&mut self, _: &'ast Item) {}
}

/// Whether an operation assigns.
pub fn is_assignment(op: &BinOp) -> bool {
    use BinOp::{
        AddAssign, BitAndAssign, BitOrAssign, BitXorAssign, DivAssign, MulAssign, RemAssign,
        ShlAssign, ShrAssign, SubAssign,
    };
    matches!(
        op,
        AddAssign(_)
            | SubAssign(_)
            | MulAssign(_)
            | DivAssign(_)
            | RemAssign(_)
            | BitXorAssign(_)
            | BitAndAssign(_)
            | BitOrAssign(_)
            | ShlAssign(_)
            | ShrAssign(_)
    )
}

/// The names that a pattern binds.
pub fn bound(pattern: &Pat) -> Vec<PatIdent> {
    struct Bound(Vec<PatIdent>);
    impl<'ast> Visit<'ast> for Bound {
        fn visit_pat_ident(&mut self, pattern: &'ast PatIdent) {
            self.0.push(pattern.clone());
            visit::visit_pat_ident(self, pattern);
        }
        fn visit_expr(&mut self, _: &'ast Expr) {}
    }
    let mut bound = Bound(Vec::new());
    bound.visit_pat(pattern);
    bound.0
}
