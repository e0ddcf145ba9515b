//! Cuts a kernel's body at its barriers.

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::{Block, Expr, Ident, Item, Pat, Stmt};

use super::Kept;
use super::scan::{Each, Jumps, barrier, has_barrier};

/// A list of parts, with the items that are declared among them.
#[derive(Default)]
pub struct List {
    pub items: Vec<Item>,
    pub parts: Vec<Part>,
}

/// A part of a kernel.
pub enum Part {
    /// Statements without a barrier.
    Region(Vec<Stmt>),
    /// The method that waits.
    Barrier(Ident),
    /// `if condition { .. } else { .. }`, with barriers in it.
    Branch { at: Span, condition: Expr, ways: [List; 2] },
    /// A loop with barriers in it.
    Loop { at: Span, head: Head, body: List },
    /// A block with barriers in it.
    Block(List),
}

/// The beginning of a loop.
pub enum Head {
    While(Expr),
    For(Pat, Expr),
}

/// The parts of a body, whose invocation is called `id`.
pub fn cut(body: &Block, id: &Ident) -> Result<List, Kept> {
    Cut { id }.list(&body.stmts, true, false)
}

struct Cut<'a> {
    id: &'a Ident,
}

impl Cut<'_> {
    fn waits(&self, statement: &Stmt) -> bool {
        has_barrier(self.id, |found| Each(found).visit_stmt(statement))
    }

    /// Cuts statements. Nothing follows them if they are the last, and they may be in a loop with barriers.
    fn list(&self, statements: &[Stmt], is_last: bool, in_loop: bool) -> Result<List, Kept> {
        let mut list = List::default();
        let mut region = Vec::new();
        let end = statements.iter().rposition(|s| !matches!(s, Stmt::Item(_)));
        let last_barrier = statements.iter().rposition(|statement| self.waits(statement));
        for (at, statement) in statements.iter().enumerate() {
            if let Stmt::Item(item) = statement {
                list.items.push(item.clone());
                continue;
            }
            if !self.waits(statement) {
                let mut jumps = Jumps::default();
                jumps.visit_stmt(statement);
                let may_return = is_last && last_barrier.is_none_or(|barrier| barrier < at);
                if jumps.returns && !may_return {
                    return Err("a `return` before a barrier");
                }
                if jumps.leaves_loop && in_loop {
                    return Err("a `break` or `continue` of a loop with a barrier");
                }
                region.push(statement.clone());
                continue;
            }
            let Stmt::Expr(expression, _) = statement else {
                return Err("a barrier within a `let`");
            };
            if !region.is_empty() {
                list.parts.push(Part::Region(std::mem::take(&mut region)));
            }
            list.parts.push(self.part(expression, is_last && end == Some(at), in_loop)?);
        }
        if !region.is_empty() {
            list.parts.push(Part::Region(region));
        }
        Ok(list)
    }

    /// A condition, or what a loop runs over.
    fn head(&self, expression: &Expr) -> Result<Expr, Kept> {
        let mut is_let = false;
        Each(&mut |part| is_let |= matches!(part, Expr::Let(_))).visit_expr(expression);
        if is_let || has_barrier(self.id, |found| Each(found).visit_expr(expression)) {
            return Err("a barrier in a condition, or in a branch that binds");
        }
        let mut jumps = Jumps::default();
        jumps.visit_expr(expression);
        if jumps.returns || jumps.leaves_loop {
            return Err("a `return` before a barrier");
        }
        Ok(expression.clone())
    }

    fn part(&self, expression: &Expr, is_last: bool, in_loop: bool) -> Result<Part, Kept> {
        if let (Some(method), Expr::MethodCall(of)) = (barrier(expression, self.id), expression) {
            return match of.attrs.is_empty() {
                true => Ok(Part::Barrier(method.clone())),
                false => Err("a barrier with an attribute"),
            };
        }
        let list = |block: &Block, is_last, in_loop| self.list(&block.stmts, is_last, in_loop);
        match expression {
            Expr::If(of) if of.attrs.is_empty() => {
                let otherwise = match &of.else_branch {
                    None => List::default(),
                    Some((_, otherwise)) => match &**otherwise {
                        Expr::Block(otherwise) => list(&otherwise.block, is_last, in_loop)?,
                        other => self.list(&[Stmt::Expr(other.clone(), None)], is_last, in_loop)?,
                    },
                };
                Ok(Part::Branch {
                    at: of.if_token.span(),
                    condition: self.head(&of.cond)?,
                    ways: [list(&of.then_branch, is_last, in_loop)?, otherwise],
                })
            }
            Expr::While(of) if of.attrs.is_empty() => Ok(Part::Loop {
                at: of.while_token.span(),
                head: Head::While(self.head(&of.cond)?),
                body: list(&of.body, false, true)?,
            }),
            Expr::ForLoop(of) if of.attrs.is_empty() && is_range(&of.expr) => Ok(Part::Loop {
                at: of.for_token.span(),
                head: Head::For((*of.pat).clone(), self.head(&of.expr)?),
                body: list(&of.body, false, true)?,
            }),
            Expr::Block(of) if of.attrs.is_empty() && of.label.is_none() => {
                Ok(Part::Block(list(&of.block, is_last, in_loop)?))
            }
            _ => Err("a barrier in an expression that is neither a loop over a range nor a branch"),
        }
    }
}

/// Whether a `for` loop runs over a range.
fn is_range(expression: &Expr) -> bool {
    range(expression).is_some()
}

/// The two ends of a range, and the step between, if it has one.
pub fn range(expression: &Expr) -> Option<Vec<&Expr>> {
    match expression {
        Expr::Paren(of) => range(&of.expr),
        Expr::Range(of) => Some(vec![of.start.as_deref()?, of.end.as_deref()?]),
        Expr::MethodCall(of) => {
            let mut ends = range(&of.receiver)?;
            match &*of.method.to_string() {
                "rev" => Some(ends),
                "step_by" => {
                    ends.extend(&of.args);
                    Some(ends)
                }
                _ => None,
            }
        }
        _ => None,
    }
}

impl List {
    /// The first barrier that whoever enters the list comes to.
    pub fn first_barrier(&self) -> Option<&Ident> {
        self.parts.iter().find_map(|part| match part {
            Part::Barrier(method) => Some(method),
            Part::Block(list) => list.first_barrier(),
            _ => None,
        })
    }

    /// Calls a function with every region, and with every part.
    pub fn each<'a>(&'a self, found: &mut dyn FnMut(&'a Part)) {
        for part in &self.parts {
            found(part);
            match part {
                Part::Branch { ways, .. } => ways.iter().for_each(|way| way.each(found)),
                Part::Loop { body, .. } | Part::Block(body) => body.each(found),
                Part::Region(_) | Part::Barrier(_) => {}
            }
        }
    }
}
