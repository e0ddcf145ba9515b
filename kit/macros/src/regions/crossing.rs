//! Variables that live across barriers: in which segments they are taken from their array, and put back.

use std::collections::{BTreeSet, HashSet};

use proc_macro2::Span;
use quote::format_ident;
use syn::visit::{self, Visit};
use syn::{Expr, Ident, Local, Pat, Stmt};

use super::Kept;
use super::cut::{Head, List, Part};
use super::scan::{Changes, Uses, bound, is_one_of};
use super::uniform::Names;

/// A variable that each invocation has.
pub struct Variable {
    pub name: Ident,
    /// Its array.
    pub slot: Ident,
    is_mutable: bool,
    /// The segment that declares it.
    declared: usize,
    /// Why it cannot live in an array.
    kept: Option<Kept>,
    crosses: bool,
}

/// What every invocation runs in one go: the statements of a region, a condition, or what a loop runs over. They are numbered in the
/// order of the source.
#[derive(Default)]
pub struct Segment {
    /// All names in it.
    pub names: HashSet<String>,
    uses: BTreeSet<usize>,
    /// The variables that it may change: what it only moves away has no value to put.
    changes: HashSet<String>,
    declares: Vec<usize>,
    /// The loops around it, from the outside in.
    loops: Vec<usize>,
}

/// The segments of a kernel, and their variables.
pub struct Crossing<'a> {
    names: &'a Names<'a>,
    pub variables: Vec<Variable>,
    pub segments: Vec<Segment>,
    /// The variables that have a name here; the last one of a name is meant.
    scope: Vec<usize>,
    loops: Vec<usize>,
    loop_count: usize,
}

/// Methods whose result borrows.
const BORROWING: [&str; 22] = [
    "as_bytes",
    "as_mut",
    "as_mut_slice",
    "as_ptr",
    "as_ref",
    "as_slice",
    "borrow",
    "borrow_mut",
    "chunks",
    "chunks_exact",
    "deref",
    "enumerate",
    "first",
    "get",
    "get_mut",
    "iter",
    "iter_mut",
    "last",
    "split_at",
    "split_first",
    "split_last",
    "windows",
];

/// Whether a value may borrow from variables, or has a type of its own.
fn borrows(value: &Expr) -> bool {
    let mut found = false;
    super::scan::Each(&mut |part| {
        found |= match part {
            Expr::Reference(_) | Expr::RawAddr(_) | Expr::Closure(_) => true,
            Expr::MethodCall(of) => is_one_of(&of.method, &BORROWING),
            _ => false,
        };
    })
    .visit_expr(value);
    found
}

/// The names to which something gives what may borrow.
struct Assigned(HashSet<String>);

/// Methods that keep what they get.
const KEEPING: [&str; 5] = ["get_or_insert", "insert", "push", "replace", "set"];

impl<'ast> Visit<'ast> for Assigned {
    fn visit_expr(&mut self, expression: &'ast Expr) {
        let place = match expression {
            Expr::Assign(of) if borrows(&of.right) => Some(&of.left),
            Expr::MethodCall(of) if is_one_of(&of.method, &KEEPING) => {
                of.args.iter().any(borrows).then_some(&of.receiver)
            }
            _ => None,
        };
        if let Some(place) = place {
            let mut names = Uses::default();
            names.visit_expr(place);
            self.0.extend(names.0);
        }
        visit::visit_expr(self, expression);
    }
}

impl<'a> Crossing<'a> {
    /// Finds the variables that cross.
    pub fn find(body: &List, names: &'a Names<'a>) -> Result<Self, Kept> {
        let mut crossing = Self {
            names,
            variables: Vec::new(),
            segments: Vec::new(),
            scope: Vec::new(),
            loops: Vec::new(),
            loop_count: 0,
        };
        crossing.list(body)?;
        crossing.check()?;
        Ok(crossing)
    }

    /// Whether a branch or a `while` loop needs no votes.
    pub fn is_uniform(&self, condition: &Expr) -> bool {
        self.names.is_uniform(condition)
    }

    /// Whether a `for` loop is the same in all invocations.
    pub fn is_uniform_loop(&self, pattern: &Pat, over: &Expr) -> bool {
        let is_once = match pattern {
            Pat::Wild(_) => true,
            Pat::Ident(name) => self.names.lives_once(&name.ident),
            _ => false,
        };
        is_once && self.names.is_uniform_range(over)
    }

    fn list(&mut self, list: &List) -> Result<(), Kept> {
        let scope = self.scope.len();
        for part in &list.parts {
            match part {
                Part::Region(statements) => self.region(statements),
                Part::Barrier(_) => {}
                Part::Block(list) => self.list(list)?,
                Part::Branch { condition, ways, .. } => {
                    if !self.is_uniform(condition) {
                        // who does not come along is missed at a barrier
                        let barrier = ways.iter().find_map(List::first_barrier);
                        barrier.ok_or("a barrier in two branches, of which the outer one is not the same in all invocations")?;
                        self.expression(condition);
                    }
                    ways.iter().try_for_each(|way| self.list(way))?;
                }
                Part::Loop { head, body, .. } => self.head(head, body)?,
            }
        }
        self.scope.truncate(scope);
        Ok(())
    }

    fn head(&mut self, head: &Head, body: &List) -> Result<(), Kept> {
        let scope = self.scope.len();
        let is_uniform = match head {
            Head::While(condition) => self.is_uniform(condition),
            Head::For(pattern, over) => self.is_uniform_loop(pattern, over),
        };
        if let (Head::For(_, over), false) = (head, is_uniform) {
            self.expression(over);
        }
        self.loops.push(self.loop_count);
        self.loop_count += 1;
        if !is_uniform {
            body.first_barrier()
                .ok_or("a barrier in a branch of a loop that is not the same in all invocations")?;
            match head {
                Head::While(condition) => self.expression(condition),
                Head::For(pattern, _) => {
                    let segment = self.segment(HashSet::new());
                    self.declare(segment, pattern, None);
                }
            }
        }
        self.list(body)?;
        self.loops.pop();
        self.scope.truncate(scope);
        Ok(())
    }

    fn region(&mut self, statements: &[Stmt]) {
        let sorted = self.names.sort(statements);
        let mut names = Uses::default();
        sorted.each.iter().for_each(|statement| names.visit_stmt(statement));
        names.0.extend(sorted.places.iter().map(ToString::to_string));
        let segment = self.segment(names.0);
        let mut changes = Changes::every_call();
        sorted.each.iter().for_each(|statement| changes.visit_stmt(statement));
        self.segments[segment].changes = changes.names;
        for statement in sorted.each {
            if let Stmt::Local(local) = statement {
                self.declare(segment, &local.pat, Some(local));
            }
        }
    }

    fn expression(&mut self, expression: &Expr) {
        let mut names = Uses::default();
        names.visit_expr(expression);
        let segment = self.segment(names.0);
        let mut changes = Changes::every_call();
        changes.visit_expr(expression);
        self.segments[segment].changes = changes.names;
    }

    /// A segment with these names. Returns its number.
    fn segment(&mut self, names: HashSet<String>) -> usize {
        let variables = &self.variables;
        let found =
            |name: &String| self.scope.iter().rev().find(|&&at| variables[at].name == *name);
        let uses: BTreeSet<usize> = names.iter().filter_map(found).copied().collect();
        uses.iter().for_each(|&at| self.variables[at].crosses = true);
        self.segments.push(Segment {
            names,
            uses,
            changes: HashSet::new(),
            declares: Vec::new(),
            loops: self.loops.clone(),
        });
        self.segments.len() - 1
    }

    /// A segment declares the variables of a pattern, of `let` or of a loop.
    fn declare(&mut self, segment: usize, pattern: &Pat, local: Option<&Local>) {
        let kept = local.and_then(|local| match &local.init {
            _ if !local.attrs.is_empty() => Some("a variable with an attribute crosses a barrier"),
            None => Some("a variable without a value crosses a barrier"),
            Some(init) if borrows(&init.expr) => {
                Some("a variable that may borrow crosses a barrier")
            }
            Some(_) => None,
        });
        for found in bound(pattern) {
            let at = self.variables.len();
            self.variables.push(Variable {
                slot: format_ident!("{}_{at}", found.ident, span = Span::mixed_site()),
                name: found.ident,
                is_mutable: found.mutability.is_some(),
                declared: segment,
                kept,
                crosses: false,
            });
            self.scope.push(at);
            self.segments[segment].declares.push(at);
        }
    }

    fn check(&self) -> Result<(), Kept> {
        let crossing = self.variables.iter().filter(|variable| variable.crosses);
        if let Some(kept) = crossing.filter_map(|variable| variable.kept).next() {
            return Err(kept);
        }
        for (at, segment) in self.segments.iter().enumerate() {
            let hides = |put: &&Variable| {
                let same = |&&declared: &&usize| self.variables[declared].name == put.name;
                let last = segment.declares.iter().rfind(same);
                last.is_some_and(|&last| self.variables[last].slot != put.slot)
            };
            if self.puts(at).iter().any(hides) {
                return Err("a variable that crosses a barrier is hidden by another");
            }
        }
        Ok(())
    }

    /// Fails if something assigns what may borrow to a variable that crosses.
    pub fn check_assignments(&self, body: &syn::Block) -> Result<(), Kept> {
        let mut assigned = Assigned(HashSet::new());
        assigned.visit_block(body);
        let is_wrong = |variable: &Variable| {
            variable.crosses && assigned.0.contains(&variable.name.to_string())
        };
        match self.variables.iter().any(is_wrong) {
            true => Err("a variable that may borrow crosses a barrier"),
            false => Ok(()),
        }
    }

    /// The variables with an array.
    pub fn crossing(&self) -> impl Iterator<Item = &Variable> {
        self.variables.iter().filter(|variable| variable.crosses)
    }

    /// The variables that a segment takes.
    pub fn takes(&self, segment: usize) -> Vec<&Variable> {
        self.segments[segment].uses.iter().map(|&at| &self.variables[at]).collect()
    }

    /// The variables that a segment puts: those that it may change or declares, if they are used afterwards.
    pub fn puts(&self, segment: usize) -> Vec<&Variable> {
        let Segment { uses, changes, declares, .. } = &self.segments[segment];
        let may_change = |at: &&usize| {
            let Variable { name, is_mutable, .. } = &self.variables[**at];
            *is_mutable && changes.contains(&name.to_string())
        };
        let changed = uses.iter().filter(may_change);
        let all = changed.chain(declares).filter(|&&at| self.is_used_after(at, segment));
        all.map(|&at| &self.variables[at]).collect()
    }

    /// Whether a variable is used after a segment.
    fn is_used_after(&self, variable: usize, segment: usize) -> bool {
        let loops = |segment: usize| &self.segments[segment].loops;
        let outside = loops(self.variables[variable].declared);
        self.segments.iter().enumerate().filter(|(_, user)| user.uses.contains(&variable)).any(
            |(at, user)| {
                let comes_again =
                    user.loops.iter().any(|l| loops(segment).contains(l) && !outside.contains(l));
                at > segment || comes_again
            },
        )
    }
}
