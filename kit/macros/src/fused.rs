//! A kernel as a driver may compile it: multiplications and additions are fused.

use proc_macro2::Span;
use quote::quote_spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{BinOp, Block, Expr, ExprBinary, Local, Pat, Stmt};

/// Fuses every sum or difference of a product, and says whether there are some. Types are not known here: what is no float stays as it is.
pub fn fuse(block: &mut Block) -> bool {
    let mut fuse = Fuse { has_some: false };
    fuse.visit_block_mut(block);
    fuse.has_some
}

struct Fuse {
    has_some: bool,
}

/// The factors of a product.
fn factors(expression: &Expr) -> Option<(&Expr, &Expr)> {
    match expression {
        Expr::Paren(paren) => factors(&paren.expr),
        // what `checks` looks at
        Expr::Block(of) => match of.block.stmts.first()? {
            Stmt::Local(Local { pat: Pat::Ident(name), init: Some(of), .. })
                if name.ident == "_value" =>
            {
                factors(&of.expr)
            }
            _ => None,
        },
        Expr::Binary(ExprBinary { left, op: BinOp::Mul(_), right, .. }) => Some((left, right)),
        _ => None,
    }
}

/// The fused form of an expression, if it has one.
fn fused(ExprBinary { left, op, right, .. }: &ExprBinary) -> Option<Expr> {
    let (is_sum, is_assignment) = match op {
        BinOp::Add(_) => (true, false),
        BinOp::Sub(_) => (false, false),
        BinOp::AddAssign(_) => (true, true),
        BinOp::SubAssign(_) => (false, true),
        _ => return None,
    };
    let plain = if is_sum { quote::quote!(+) } else { quote::quote!(-) };
    let names = Span::mixed_site();
    let tokens = match (factors(left).filter(|_| !is_assignment), factors(right)) {
        (Some((a, b)), _) => {
            // a b + c, or a b - c
            let signs = if is_sum { quote::quote!([1.0, 1.0]) } else { quote::quote!([1.0, -1.0]) };
            quote_spanned! { names =>
                match (#a, #b, #right) {
                    (a, b, c) => ::muslin::kernel::fused(a, b, c, a * b #plain c, #signs),
                }
            }
        }
        (None, Some((a, b))) => {
            // c + a b, or c - a b
            let signs = if is_sum { quote::quote!([1.0, 1.0]) } else { quote::quote!([-1.0, 1.0]) };
            let value = quote_spanned! { names =>
                match (#left, #a, #b) {
                    (c, a, b) => ::muslin::kernel::fused(a, b, c, c #plain a * b, #signs),
                }
            };
            if is_assignment { quote_spanned!(names => #left = #value) } else { value }
        }
        (None, None) => return None,
    };
    syn::parse2(tokens).ok()
}

impl VisitMut for Fuse {
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        visit_mut::visit_expr_mut(self, expression);
        if let Expr::Binary(binary) = expression
            && let Some(fused) = fused(binary)
        {
            *expression = fused;
            self.has_some = true;
        }
    }

    only_what_runs!();

    fn visit_pat_mut(&mut self, _: &mut Pat) {}
}
