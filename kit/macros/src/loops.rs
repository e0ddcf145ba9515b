//! Counts the iterations of loops, in debug builds on the CPU.

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, ExprForLoop, ExprLoop, ExprWhile, Item, parse_quote_spanned};

/// Counts in every loop of a block.
pub fn count_iterations(block: &mut Block) {
    Loops.visit_block_mut(block);
}

struct Loops;

impl VisitMut for Loops {
    fn visit_expr_while_mut(&mut self, expression: &mut ExprWhile) {
        visit_mut::visit_expr_while_mut(self, expression);
        count(&mut expression.body, expression.while_token.span());
    }

    fn visit_expr_for_loop_mut(&mut self, expression: &mut ExprForLoop) {
        visit_mut::visit_expr_for_loop_mut(self, expression);
        count(&mut expression.body, expression.for_token.span());
    }

    fn visit_expr_loop_mut(&mut self, expression: &mut ExprLoop) {
        visit_mut::visit_expr_loop_mut(self, expression);
        count(&mut expression.body, expression.loop_token.span());
    }

    /// A function in a function is another one.
    fn visit_item_mut(&mut self, _: &mut Item) {}
}

/// The message of a loop that takes too many iterations has the place of its first word.
fn count(body: &mut Block, span: Span) {
    let statement = parse_quote_spanned! { span =>
        #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
        ::organza_kernel::kernel::iterate();
    };
    body.stmts.insert(0, statement);
}
