//! Checks in the body of a function, in debug builds on the CPU: iterations of loops are counted, paths to barriers are noted, and casts to
//! integers and arithmetic in `usize` are looked at.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{
    Arm, BinOp, Block, Expr, ExprBinary, ExprCast, ExprForLoop, ExprIf, ExprLoop, ExprWhile, FnArg,
    Ident, Item, ItemFn, Pat, Stmt, Type, parse_quote, parse_quote_spanned,
};

/// Adds the checks to a function. `has_barriers` says at run time whether its path to barriers matters; `None` if it never does.
pub fn add(block: &mut Block, has_barriers: Option<Expr>) {
    let notes_paths = has_barriers.is_some();
    let has_usize = has_usize(block.to_token_stream());
    Checks { notes_paths, has_usize }.visit_block_mut(block);
    if let Some(has_barriers) = has_barriers {
        let name = own("_has_barriers");
        let statement = parse_quote! {
            ::muslin::checked!(let #name = #has_barriers;);
        };
        block.stmts.insert(0, statement);
    }
}

/// Adds the checks to a part of a function, whose paths to barriers do not matter. `has_usize` is of the whole function.
pub fn add_to_part(block: &mut Block, has_usize: bool) {
    Checks { notes_paths: false, has_usize }.visit_block_mut(block);
}

/// The first word of a function's first loop.
pub fn first_loop(block: &Block) -> Option<Span> {
    struct First(Option<Span>);
    impl<'ast> Visit<'ast> for First {
        fn visit_expr(&mut self, expression: &'ast Expr) {
            let span = match expression {
                Expr::While(of) => Some(of.while_token.span()),
                Expr::ForLoop(of) => Some(of.for_token.span()),
                Expr::Loop(of) => Some(of.loop_token.span()),
                _ => None,
            };
            self.0 = self.0.or(span);
            visit::visit_expr(self, expression);
        }

        fn visit_item(&mut self, _: &'ast Item) {}
    }
    let mut first = First(None);
    first.visit_block(block);
    first.0
}

/// Whether a helper can wait at barriers: they are methods of `Invocation`.
pub fn takes_invocation(function: &ItemFn) -> bool {
    function.sig.inputs.iter().any(|argument| {
        let FnArg::Typed(argument) = argument else { return false };
        let mut ty = &*argument.ty;
        while let Type::Reference(reference) = ty {
            ty = &reference.elem;
        }
        let Type::Path(path) = ty else { return false };
        path.path.segments.last().is_some_and(|segment| segment.ident == "Invocation")
    })
}

/// Whether there can be a `usize`.
pub fn has_usize(tokens: TokenStream) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Group(group) => has_usize(group.stream()),
        TokenTree::Ident(word) => word == "usize" || word == "len",
        _ => false,
    })
}

struct Checks {
    notes_paths: bool,
    has_usize: bool,
}

/// Whether a result can have more than 32 bits, if its operands have 32.
fn can_grow(expression: &Expr) -> bool {
    match expression {
        Expr::Binary(of) => {
            matches!(of.op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Shl(_))
        }
        Expr::MethodCall(of) => {
            let name = of.method.to_string();
            name == "pow" || name.starts_with("wrapping_")
        }
        _ => false,
    }
}

/// Whether an expression is an assignment to a variable that can so grow.
fn lets_grow(expression: &Expr) -> bool {
    use BinOp::{AddAssign, MulAssign, ShlAssign, SubAssign};
    let Expr::Binary(of) = expression else { return false };
    let is_meant = matches!(of.op, AddAssign(_) | SubAssign(_) | MulAssign(_) | ShlAssign(_));
    is_meant && matches!(*of.left, Expr::Path(_))
}

impl Checks {
    /// Counts a loop. The message of one that takes too many iterations has the place of its first word.
    fn count(&self, body: &mut Block, span: Span) {
        let count = parse_quote_spanned! { span =>
            ::muslin::checked!(::muslin::kernel::iterate(););
        };
        body.stmts.insert(0, count);
        if self.notes_paths {
            let scope = own("_scope");
            let round = parse_quote! {
                ::muslin::checked!(#scope.round(););
            };
            body.stmts.insert(0, round);
        }
    }

    /// Looks at what becomes an integer. Only `f32` matters, and types are not known here.
    fn cast(cast: &mut ExprCast) {
        let Type::Path(ty) = &*cast.ty else { return };
        let is_integer = INTEGERS.iter().any(|name| ty.path.is_ident(name));
        if !is_integer || is_literal(&cast.expr) {
            return;
        }
        let ty = &cast.ty;
        let value = match &*cast.expr {
            Expr::Paren(paren) => &*paren.expr,
            value => value,
        };
        // a panic of what the cast is a part of has its line, too
        let span = cast.as_token.span();
        let name = own("_value");
        let check: Stmt = parse_quote_spanned! { span =>
            ::muslin::checked!(::muslin::kernel::check_cast::<#ty, _>(#name););
        };
        cast.expr = parse_quote_spanned! { span => { let #name = #value; #check #name }};
    }

    /// Looks at a result, which is a `usize` or not: types are not known here.
    fn arithmetic(expression: &mut Expr) {
        let span = match &*expression {
            Expr::Binary(of) => of.op.span(),
            Expr::MethodCall(of) => of.method.span(),
            of => of.span(),
        };
        let name = own("_value");
        *expression = match &*expression {
            Expr::Binary(ExprBinary { left, .. }) if !can_grow(expression) => {
                parse_quote_spanned! { span => {
                    #expression;
                    ::muslin::checked!(::muslin::kernel::check_usize(&#left););
                }}
            }
            _ => parse_quote_spanned! { span => {
                let #name = #expression;
                ::muslin::checked!(::muslin::kernel::check_usize(&#name););
                #name
            }},
        };
    }

    /// A loop over an array gets an index.
    fn each(of: &mut ExprForLoop) -> Option<Expr> {
        let (array, is_numbered) = array(&of.expr)?;
        let ExprForLoop { label, pat, body, .. } = of;
        let names = Span::mixed_site().located_at(of.expr.span());
        let item = match is_numbered {
            true => quote_spanned!(names => (at as usize, ::muslin::each::Each::at(&array, at))),
            false => quote_spanned!(names => ::muslin::each::Each::at(&array, at)),
        };
        Some(parse_quote_spanned! { names => {
            let array = #array;
            let mut at = 0u32;
            #label while at < ::muslin::each::Each::rounds(&array) {
                let #pat = #item;
                at += 1;
                #body
            }
        }})
    }

    /// The beginning of a branch.
    fn branch(span: Span) -> Stmt {
        let name = own("_has_barriers");
        parse_quote_spanned! { span =>
            ::muslin::checked!(let _branch = ::muslin::kernel::Scope::new(#name););
        }
    }
}

/// A name of the checks, which is the same one in a kernel that a macro declares. All else has the span of the checked code: messages have
/// its place.
fn own(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The array of `array`, `of.array`, `arrays[i]`, `&array`, `[a, b]`, `array.iter()` or `array.iter().enumerate()`, and whether its elements are numbered.
fn array(iterated: &Expr) -> Option<(Expr, bool)> {
    match iterated {
        Expr::Path(_) | Expr::Field(_) | Expr::Index(_) | Expr::Array(_) | Expr::Repeat(_) => {
            Some((iterated.clone(), false))
        }
        Expr::Paren(of) => array(&of.expr),
        Expr::Reference(of) => {
            array(&of.expr).map(|(_, is_numbered)| (iterated.clone(), is_numbered))
        }
        Expr::MethodCall(of) if of.args.is_empty() => {
            let (array, is_numbered) = array(&of.receiver)?;
            match &*of.method.to_string() {
                "iter" => Some((parse_quote!(&#array), is_numbered)),
                "into_iter" => Some((array, is_numbered)),
                "enumerate" if !is_numbered => Some((array, true)),
                _ => None,
            }
        }
        _ => None,
    }
}

const INTEGERS: [&str; 10] =
    ["u8", "u16", "u32", "u64", "usize", "i8", "i16", "i32", "i64", "isize"];

/// A literal takes its type from the cast.
fn is_literal(expression: &Expr) -> bool {
    match expression {
        Expr::Lit(_) => true,
        Expr::Unary(unary) => is_literal(&unary.expr),
        Expr::Paren(paren) => is_literal(&paren.expr),
        _ => false,
    }
}

impl VisitMut for Checks {
    /// A loop is in a block of its own, with the loop's rounds.
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        visit_mut::visit_expr_mut(self, expression);
        let span = match expression {
            Expr::While(of) => of.while_token.span(),
            Expr::ForLoop(of) => {
                let span = of.for_token.span();
                if let Some(each) = Self::each(of) {
                    *expression = each;
                }
                span
            }
            Expr::Loop(of) => of.loop_token.span(),
            Expr::Cast(of) => return Self::cast(of),
            of if self.has_usize && (can_grow(of) || lets_grow(of)) => {
                return Self::arithmetic(of);
            }
            _ => return,
        };
        if self.notes_paths {
            let [name, has_barriers] = ["_scope", "_has_barriers"].map(own);
            let scope: Stmt = parse_quote_spanned! { span =>
                ::muslin::checked!(let mut #name = ::muslin::kernel::Scope::new(#has_barriers););
            };
            *expression = parse_quote! {{ #scope #expression }};
        }
    }

    fn visit_expr_while_mut(&mut self, expression: &mut ExprWhile) {
        visit_mut::visit_expr_while_mut(self, expression);
        self.count(&mut expression.body, expression.while_token.span());
    }

    fn visit_expr_for_loop_mut(&mut self, expression: &mut ExprForLoop) {
        visit_mut::visit_expr_for_loop_mut(self, expression);
        self.count(&mut expression.body, expression.for_token.span());
    }

    fn visit_expr_loop_mut(&mut self, expression: &mut ExprLoop) {
        visit_mut::visit_expr_loop_mut(self, expression);
        self.count(&mut expression.body, expression.loop_token.span());
    }

    fn visit_expr_if_mut(&mut self, expression: &mut ExprIf) {
        visit_mut::visit_expr_if_mut(self, expression);
        if !self.notes_paths {
            return;
        }
        let span = expression.if_token.span();
        expression.then_branch.stmts.insert(0, Self::branch(span));
        if let Some((token, otherwise)) = &mut expression.else_branch
            && let Expr::Block(otherwise) = &mut **otherwise
        {
            otherwise.block.stmts.insert(0, Self::branch(token.span()));
        }
    }

    fn visit_arm_mut(&mut self, arm: &mut Arm) {
        visit_mut::visit_arm_mut(self, arm);
        if self.notes_paths {
            let branch = Self::branch(arm.pat.span());
            let body = &arm.body;
            arm.body = parse_quote! {{ #branch #body }};
        }
    }

    only_what_runs!();

    fn visit_pat_mut(&mut self, _: &mut Pat) {}
}
