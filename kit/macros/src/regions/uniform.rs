//! Variables that are the same in all invocations of a workgroup, because they come from parameters and constants: they live once. And
//! variables that a few operations make of an invocation's place: each region computes them anew.

use std::collections::{HashMap, HashSet};

use syn::visit::Visit;
use syn::{BinOp, Expr, ExprBinary, Ident, Local, Member, Pat, PatIdent, Stmt, UnOp};

use super::cut::{Head, List, Part, range};
use super::scan::{Changes, Each, PURE, Uses, is_assignment, is_name, is_one_of};

/// What is known of a kernel's names.
pub struct Names<'a> {
    pub id: &'a Ident,
    /// The parameters' names; the uniform buffer first, if there is one.
    pub uniform: Option<&'a Ident>,
    pub parameters: Vec<&'a Ident>,
    /// How often each name is bound.
    pub bound: HashMap<Ident, u32>,
    /// The variables that live once, and whether they change.
    pub once: HashMap<String, bool>,
    /// The variables that each region computes, in their order, with their values.
    pub places: Vec<(Ident, Expr)>,
    /// The variables whose declaration says their type. Of others, such as `let half = 128;`, it may be seen only later: until then, Rust
    /// knows none of their methods.
    pub typed: HashSet<String>,
}

/// The statements of a region, sorted.
#[derive(Default)]
pub struct Sorted<'a> {
    /// Run once, before the others.
    pub before: Vec<&'a Stmt>,
    /// The variables of [`Names::places`] that it declares.
    pub places: Vec<&'a Ident>,
    /// Run by every invocation.
    pub each: Vec<&'a Stmt>,
    /// Run once, after the others.
    pub after: Vec<&'a Stmt>,
}

/// The name that `let` declares, if it is a single one, and its value.
fn declared(statement: &Stmt) -> Option<(&PatIdent, &Expr)> {
    let Stmt::Local(Local { attrs, pat, init: Some(init), .. }) = statement else { return None };
    let pattern = match pat {
        Pat::Type(of) => &*of.pat,
        pattern => pattern,
    };
    let Pat::Ident(name) = pattern else { return None };
    let is_plain = attrs.is_empty() && name.subpat.is_none() && init.diverge.is_none();
    is_plain.then_some((name, &*init.expr))
}

/// The variable that a statement changes, and the value that it takes for it.
fn assigned(statement: &Stmt) -> Option<(&Expr, &Expr)> {
    match statement {
        Stmt::Expr(Expr::Assign(of), _) if of.attrs.is_empty() => Some((&of.left, &of.right)),
        Stmt::Expr(Expr::Binary(ExprBinary { attrs, left, op, right }), _)
            if attrs.is_empty() && is_assignment(op) =>
        {
            Some((left, right))
        }
        _ => None,
    }
}

/// `SIDE`, a constant.
fn is_constant_name(name: &Ident) -> bool {
    let name = name.to_string();
    name.chars().any(char::is_uppercase) && !name.chars().any(char::is_lowercase)
}

impl Names<'_> {
    /// Finds the variables of both kinds.
    pub fn find(&mut self, body: &List) {
        self.propose(body);
        loop {
            self.find_places(body);
            let wrong = self.wrong(body);
            if wrong.is_empty() {
                return;
            }
            self.once.retain(|name, _| !wrong.contains(name));
        }
    }

    /// Whether this name has one meaning in the whole kernel.
    fn is_unique(&self, name: &Ident) -> bool {
        self.bound.get(name) == Some(&1) && !self.parameters.contains(&name)
    }

    /// All variables that may live once.
    fn propose(&mut self, body: &List) {
        let mut found = Vec::new();
        body.each(&mut |part| match part {
            Part::Region(statements) => {
                found.extend(statements.iter().filter_map(declared).map(|(name, _)| name.clone()))
            }
            Part::Loop { head: Head::For(Pat::Ident(name), _), .. }
                if name.mutability.is_none() =>
            {
                found.push(name.clone());
            }
            _ => {}
        });
        found.retain(|name| self.is_unique(&name.ident) && !is_constant_name(&name.ident));
        self.find_types(body);
        self.once = found
            .into_iter()
            .map(|name| (name.ident.to_string(), name.mutability.is_some()))
            .collect();
    }

    /// Finds the variables of [`Self::typed`].
    fn find_types(&mut self, body: &List) {
        let mut found = Vec::new();
        body.each(&mut |part| match part {
            Part::Region(statements) => {
                for statement in statements {
                    let Some((name, value)) = declared(statement) else { continue };
                    let says = matches!(statement, Stmt::Local(Local { pat: Pat::Type(of), .. }) if !matches!(*of.ty, syn::Type::Infer(_)));
                    found.push((&name.ident, vec![value], says));
                }
            }
            Part::Loop { head: Head::For(Pat::Ident(name), over), .. } => {
                found.push((&name.ident, range(over).unwrap_or_default(), false));
            }
            _ => {}
        });
        for (name, values, says) in found {
            if says || values.into_iter().any(|value| self.says_type(value)) {
                self.typed.insert(name.to_string());
            }
        }
    }

    /// Whether an expression says its type.
    fn says_type(&self, expression: &Expr) -> bool {
        use BinOp::{Eq, Ge, Gt, Le, Lt, Ne, Shl, Shr};
        match expression {
            Expr::Lit(of) => match &of.lit {
                syn::Lit::Int(of) => !of.suffix().is_empty(),
                syn::Lit::Float(of) => !of.suffix().is_empty(),
                _ => true,
            },
            Expr::Paren(of) => self.says_type(&of.expr),
            Expr::Group(of) => self.says_type(&of.expr),
            Expr::Unary(of) => self.says_type(&of.expr),
            Expr::Cast(_) => true,
            Expr::Binary(of) => match of.op {
                Eq(_) | Ne(_) | Lt(_) | Le(_) | Gt(_) | Ge(_) => true,
                Shl(_) | Shr(_) => self.says_type(&of.left),
                _ => self.says_type(&of.left) || self.says_type(&of.right),
            },
            Expr::Path(of) => match of.path.get_ident() {
                Some(name) if self.typed.contains(&name.to_string()) => self.is_unique(name),
                _ => self.is_constant(expression),
            },
            Expr::Field(of) => {
                let is_known =
                    |name: &Ident| is_name(&of.base, name) && !self.bound.contains_key(name);
                is_known(self.id) || self.uniform.is_some_and(is_known) || self.says_type(&of.base)
            }
            Expr::MethodCall(of) => is_name(&of.receiver, self.id) || self.says_type(&of.receiver),
            Expr::If(of) => match &of.then_branch.stmts[..] {
                [Stmt::Expr(value, None)] => self.says_type(value),
                _ => false,
            },
            _ => false,
        }
    }

    /// The variables that were taken for ones that live once, and do not.
    fn wrong(&self, body: &List) -> HashSet<String> {
        let mut changes = Changes::default();
        let mut wrong = HashSet::new();
        body.each(&mut |part| match part {
            Part::Region(statements) => {
                for statement in self.sort(statements).each {
                    changes.visit_stmt(statement);
                    wrong.extend(declared(statement).map(|(name, _)| name.ident.to_string()));
                }
            }
            Part::Branch { condition, .. } => changes.visit_expr(condition),
            Part::Loop { head: Head::While(condition), .. } => changes.visit_expr(condition),
            Part::Loop { head: Head::For(pattern, over), .. } => {
                changes.visit_expr(over);
                if let Pat::Ident(name) = pattern
                    && !self.is_uniform_range(over)
                {
                    wrong.insert(name.ident.to_string());
                }
            }
            Part::Barrier(_) | Part::Block(_) => {}
        });
        wrong.retain(|name| self.once.contains_key(name));
        // a method may change what can change
        wrong.extend(changes.names.into_iter().filter(|name| self.once.get(name) == Some(&true)));
        wrong
    }

    /// Finds the variables that each region computes.
    fn find_places(&mut self, body: &List) {
        self.places.clear();
        let mut statements = Vec::new();
        body.each(&mut |part| {
            if let Part::Region(all) = part {
                statements.extend(all);
            }
        });
        for (name, value) in statements.into_iter().filter_map(declared) {
            let is_found = name.mutability.is_none()
                && self.is_unique(&name.ident)
                && !is_constant_name(&name.ident)
                && !self.is_uniform(value)
                && self.is_place(value);
            if is_found {
                self.once.remove(&name.ident.to_string());
                self.places.push((name.ident.clone(), value.clone()));
            }
        }
    }

    /// Sorts the statements of a region. What runs once only computes, so it may run earlier or later than where it is written.
    pub fn sort<'s>(&self, statements: &'s [Stmt]) -> Sorted<'s> {
        let mut sorted = Sorted::default();
        for statement in statements {
            match declared(statement) {
                Some((name, _)) if self.is_in_places(&name.ident) => {
                    sorted.places.push(&name.ident);
                }
                Some((name, value)) if self.lives_once(&name.ident) && self.is_fixed(value) => {
                    sorted.before.push(statement);
                }
                _ => sorted.each.push(statement),
            }
        }
        let first = sorted.each.iter().position(|statement| !self.runs_once(statement));
        let rest = sorted.each.split_off(first.unwrap_or(sorted.each.len()));
        sorted.before.append(&mut sorted.each);
        sorted.each = rest;
        let last = sorted.each.iter().rposition(|statement| !self.runs_once(statement));
        sorted.after = sorted.each.split_off(last.map_or(0, |last| last + 1));
        sorted
    }

    /// Whether a statement changes or declares a variable that lives once, and does nothing else.
    fn runs_once(&self, statement: &Stmt) -> bool {
        if let Some((name, value)) = declared(statement) {
            return self.lives_once(&name.ident) && self.is_uniform(value);
        }
        let Some((Expr::Path(variable), value)) = assigned(statement) else { return false };
        variable.path.get_ident().is_some_and(|name| self.lives_once(name))
            && self.is_uniform(value)
    }

    /// Whether a variable lives once.
    pub fn lives_once(&self, name: &Ident) -> bool {
        self.once.contains_key(&name.to_string())
    }

    /// Whether each region computes a variable.
    pub fn is_in_places(&self, name: &Ident) -> bool {
        self.places.iter().any(|(of, _)| of == name)
    }

    /// Whether a variable that each region computes takes more than to read a place.
    pub fn has_arithmetic(&self, name: &Ident) -> bool {
        let mut found = false;
        if let Some((_, value)) = self.places.iter().find(|(of, _)| of == name) {
            let mut look = |part: &Expr| {
                found |= matches!(part, Expr::Binary(_) | Expr::Unary(_) | Expr::Cast(_));
            };
            Each(&mut look).visit_expr(value);
        }
        found
    }

    /// The variables among [`Self::places`] that some names need, in their order.
    pub fn needed(&self, names: &HashSet<String>) -> Vec<&(Ident, Expr)> {
        let mut names = names.clone();
        let mut needed: Vec<_> = self
            .places
            .iter()
            .rev()
            .filter(|(name, value)| {
                let is_needed = names.contains(&name.to_string());
                if is_needed {
                    let mut uses = Uses::default();
                    uses.visit_expr(value);
                    names.extend(uses.0);
                }
                is_needed
            })
            .collect();
        needed.reverse();
        needed
    }

    /// Whether an expression has one value for a workgroup.
    pub fn is_uniform(&self, expression: &Expr) -> bool {
        self.computes(expression, Of { changing: true, place: false })
    }

    /// Whether it also keeps that value.
    fn is_fixed(&self, expression: &Expr) -> bool {
        self.computes(expression, Of { changing: false, place: false })
    }

    /// Whether an expression is a few operations with an invocation's place and with what keeps its value.
    fn is_place(&self, expression: &Expr) -> bool {
        self.computes(expression, Of { changing: false, place: true })
    }

    /// Whether a range is the same in all invocations.
    pub fn is_uniform_range(&self, expression: &Expr) -> bool {
        range(expression).is_some_and(|ends| ends.into_iter().all(|end| self.is_uniform(end)))
    }

    /// Whether an expression only computes, and of what.
    fn computes(&self, expression: &Expr, of: Of) -> bool {
        let computes = |expression: &Expr| self.computes(expression, of);
        match expression {
            Expr::Lit(_) => true,
            Expr::Paren(part) => computes(&part.expr),
            Expr::Group(part) => computes(&part.expr),
            Expr::Unary(part) => {
                matches!(part.op, UnOp::Neg(_) | UnOp::Not(_)) && computes(&part.expr)
            }
            Expr::Cast(part) => !matches!(*part.ty, syn::Type::Infer(_)) && computes(&part.expr),
            Expr::Binary(part) => {
                // a region computes a place anew, and divisions take time
                let is_division = matches!(part.op, BinOp::Div(_) | BinOp::Rem(_));
                let is_slow = of.place && is_division && !self.is_constant(&part.right);
                let is_left_out = is_slow || is_assignment(&part.op);
                !is_left_out && computes(&part.left) && computes(&part.right)
            }
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) if self.is_in_places(name) => of.place,
                Some(name) => match self.once.get(&name.to_string()) {
                    Some(changes) => of.changing || !changes,
                    None => self.is_constant(expression),
                },
                None => self.is_constant(expression),
            },
            Expr::Field(part) => match &part.member {
                Member::Named(name) if is_name(&part.base, self.id) => name != "local" || of.place,
                _ if self.uniform.is_some_and(|uniform| is_name(&part.base, uniform)) => {
                    !self.uniform.is_some_and(|uniform| self.bound.contains_key(uniform))
                }
                _ => self.says_type(&part.base) && computes(&part.base),
            },
            Expr::MethodCall(part) if is_name(&part.receiver, self.id) => {
                part.method == "workgroup_index" || of.place
            }
            Expr::MethodCall(part) => {
                is_one_of(&part.method, &PURE)
                    && part.turbofish.is_none()
                    && self.says_type(&part.receiver)
                    && computes(&part.receiver)
                    && part.args.iter().all(computes)
            }
            Expr::If(part) => {
                let way = |block: &syn::Block| match &block.stmts[..] {
                    [Stmt::Expr(value, None)] => computes(value),
                    _ => false,
                };
                let otherwise =
                    part.else_branch.as_ref().is_some_and(|(_, other)| match &**other {
                        Expr::Block(block) => block.label.is_none() && way(&block.block),
                        other => computes(other),
                    });
                computes(&part.cond) && way(&part.then_branch) && otherwise
            }
            _ => false,
        }
    }

    /// Whether an expression is a literal, or the name of a constant.
    fn is_constant(&self, expression: &Expr) -> bool {
        match expression {
            Expr::Lit(_) => true,
            Expr::Path(of) => {
                let is_bound = of.path.get_ident().is_some_and(|name| {
                    self.bound.contains_key(name) || self.parameters.contains(&name)
                });
                let last = of.path.segments.last();
                of.qself.is_none()
                    && !is_bound
                    && last.is_some_and(|last| {
                        last.arguments.is_none() && is_constant_name(&last.ident)
                    })
            }
            _ => false,
        }
    }
}

/// What an expression may be made of, beside parameters and constants.
#[derive(Clone, Copy)]
struct Of {
    /// Variables that live once and change.
    changing: bool,
    /// The invocation's place.
    place: bool,
}
