//! A kernel as a driver may compile it: with sums and products that are shortened, or fused. `(x + y) - y` may become x, and `(x * 0.1) * 3.0` may
//! become `x * 0.3`.

use std::collections::{HashMap, HashSet};

use proc_macro2::Span;
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{BinOp, Block, Expr, ExprBinary, Ident, Local, Pat, PatIdent, Stmt, parse_quote};

/// Shortens all sums and products that can be: terms that cancel are left out, and constants are put together. Says whether there are some. Types
/// are not known here: what is no float stays as it is.
pub fn regroup(block: &mut Block) -> bool {
    let mut regroup = Regroup::default();
    regroup.visit_block_mut(block);
    regroup.has_some
}

/// A sum, or a product.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Sum,
    Product,
}

/// A term of a sum or a factor of a product, and whether it is subtracted, or divides.
type Term = (Expr, bool);

#[derive(Default)]
struct Regroup {
    has_some: bool,
    /// Sums and products of names and literals that have a name themselves.
    named: HashMap<Ident, (Kind, Vec<Term>)>,
    /// Names whose value may change.
    mutable: HashSet<Ident>,
    /// Names of references through which a value may change.
    borrowed: HashSet<Ident>,
}

/// The kind of an operation, and whether it is the inverse one.
fn kind(op: &BinOp) -> Option<(Kind, bool)> {
    match op {
        BinOp::Add(_) => Some((Kind::Sum, false)),
        BinOp::Sub(_) => Some((Kind::Sum, true)),
        BinOp::Mul(_) => Some((Kind::Product, false)),
        BinOp::Div(_) => Some((Kind::Product, true)),
        _ => None,
    }
}

/// Calls `found` with every term of a sum or product.
fn each_term(
    expression: &mut Expr,
    of: Kind,
    inverse: bool,
    found: &mut dyn FnMut(&mut Expr, bool),
) {
    match expression {
        Expr::Paren(paren) => each_term(&mut paren.expr, of, inverse, found),
        Expr::Binary(ExprBinary { left, op, right, .. }) if kind(op).is_some_and(|k| k.0 == of) => {
            let flips = kind(op).is_some_and(|kind| kind.1);
            each_term(left, of, inverse, found);
            each_term(right, of, inverse ^ flips, found);
        }
        term => found(term, inverse),
    }
}

/// The sum or product that an expression is, and its terms.
fn terms(expression: &Expr) -> Option<(Kind, Vec<Term>)> {
    let Expr::Binary(ExprBinary { op, .. }) = expression else { return None };
    let (of, _) = kind(op)?;
    let mut terms = Vec::new();
    let add = &mut |term: &mut Expr, inverse| terms.push((term.clone(), inverse));
    each_term(&mut expression.clone(), of, false, add);
    Some((of, terms))
}

/// The terms that are left where a driver shortens: without those that cancel, and with the constants last. `None` if nothing changes.
fn shortened(terms: Vec<(Term, String)>) -> Option<(Vec<Term>, Vec<Term>)> {
    let mut left: Vec<(Term, String)> = Vec::new();
    let count = terms.len();
    for (term, text) in terms {
        match left.iter().position(|(other, same)| *same == text && other.1 != term.1) {
            Some(at) => drop(left.remove(at)),
            None => left.push((term, text)),
        }
    }
    let has_canceled = left.len() < count;
    let is_constant =
        |text: &str| !text.contains(|c: char| c.is_lowercase()) || text.parse::<f32>().is_ok();
    let (constants, others): (Vec<_>, Vec<_>) =
        left.into_iter().partition(|(_, text)| is_constant(text));
    let terms =
        |all: Vec<(Term, String)>| all.into_iter().map(|(term, _)| term).collect::<Vec<_>>();
    let is_short = !others.is_empty() && (has_canceled || constants.len() > 1);
    is_short.then(|| (terms(others), terms(constants)))
}

/// The sum or product of terms. The first one that is not subtracted begins.
fn joined(of: Kind, mut terms: Vec<Term>) -> Option<Expr> {
    terms.sort_by_key(|(_, inverse)| *inverse);
    let mut terms = terms.into_iter();
    let (first, _) = terms.next().filter(|(_, inverse)| !inverse)?;
    Some(terms.fold(first, |sum, (term, inverse)| match (of, inverse) {
        (Kind::Sum, false) => parse_quote!((#sum + #term)),
        (Kind::Sum, true) => parse_quote!((#sum - #term)),
        (Kind::Product, false) => parse_quote!((#sum * #term)),
        (Kind::Product, true) => parse_quote!((#sum / #term)),
    }))
}

impl Regroup {
    /// The shortened form of an expression, if it has one.
    fn regrouped(&mut self, expression: &Expr) -> Option<Expr> {
        let (of, _) = terms(expression)?;
        let mut plain = expression.clone();
        let mut values = Vec::new();
        let mut variables = Vec::new();
        let mut all = Vec::new();
        each_term(&mut plain, of, false, &mut |term, inverse| {
            let name = format!("term_{}", variables.len());
            let variable = Ident::new(&name, Span::mixed_site());
            let value = std::mem::replace(term, parse_quote!(#variable));
            let named = match &value {
                Expr::Path(path) => path.path.get_ident().and_then(|name| self.named.get(name)),
                _ => None,
            };
            match named {
                Some((kind, parts)) if *kind == of => {
                    all.extend(parts.iter().map(|(part, flips)| {
                        ((part.clone(), inverse ^ flips), part.to_token_stream().to_string())
                    }))
                }
                _ => {
                    // two calls with effects have two values
                    let text = match self.has_effects(&value) {
                        true => name,
                        false => value.to_token_stream().to_string(),
                    };
                    all.push(((parse_quote!(#variable), inverse), text));
                }
            }
            values.push(value);
            variables.push(variable);
        });
        let (others, constants) = shortened(all)?;
        let flips = constants.iter().all(|(_, inverse)| *inverse);
        let constants = constants.into_iter().map(|(term, inverse)| (term, inverse ^ flips));
        let constant = joined(of, constants.collect()).map(|constant| (constant, flips));
        let short = joined(of, others.into_iter().chain(constant).collect())?;
        values.iter_mut().for_each(|value| self.visit_expr_mut(value));
        self.has_some = true;
        let Expr::Binary(ExprBinary { op, .. }) = expression else { return None };
        // the place of the operation, which the message names
        syn::parse2(quote_spanned! { op.span() =>
            match (#(#values,)*) {
                (#(#variables,)*) => ::muslin::kernel::regrouped(#plain, || #short),
            }
        })
        .ok()
    }

    /// Whether a term is seen to change something, such as the state of a random generator.
    fn has_effects(&self, term: &Expr) -> bool {
        struct Effects<'a>(&'a Regroup, bool);
        impl<'ast> Visit<'ast> for Effects<'_> {
            fn visit_expr(&mut self, expression: &'ast Expr) {
                let Self(regroup, found) = self;
                let is_of = |names: &HashSet<Ident>, expression: &Expr| {
                    variable(expression).is_some_and(|name| names.contains(name))
                };
                *found |= match expression {
                    Expr::Reference(of) => of.mutability.is_some(),
                    Expr::Assign(_) | Expr::Macro(_) => true,
                    Expr::Binary(of) => is_assignment(&of.op),
                    Expr::MethodCall(of) => {
                        of.method.to_string().starts_with("atomic_")
                            || is_of(&regroup.mutable, &of.receiver)
                            || is_of(&regroup.borrowed, &of.receiver)
                    }
                    Expr::Call(of) => {
                        let is_atomic = matches!(&*of.func, Expr::Path(of) if of.path.segments.iter().any(|name| name.ident == "atomic"));
                        is_atomic
                            || is_of(&regroup.mutable, &of.func)
                            || of.args.iter().any(|argument| is_of(&regroup.borrowed, argument))
                    }
                    _ => false,
                };
                visit::visit_expr(self, expression);
            }
        }
        let mut effects = Effects(self, false);
        effects.visit_expr(term);
        effects.1
    }

    /// Whether a term is a literal, or a name that keeps its value.
    fn is_fixed(&self, term: &Expr) -> bool {
        match term {
            Expr::Lit(_) => true,
            Expr::Path(path) => {
                path.path.get_ident().is_some_and(|name| !self.mutable.contains(name))
            }
            _ => false,
        }
    }
}

/// The variable that a place lies in.
fn variable(place: &Expr) -> Option<&Ident> {
    match place {
        Expr::Path(of) => of.path.get_ident(),
        Expr::Field(of) => variable(&of.base),
        Expr::Index(of) => variable(&of.expr),
        Expr::Paren(of) => variable(&of.expr),
        Expr::Unary(of) => variable(&of.expr),
        _ => None,
    }
}

/// Whether an operation also assigns.
fn is_assignment(op: &BinOp) -> bool {
    use BinOp::{AddAssign, BitXorAssign, DivAssign, MulAssign, SubAssign};
    matches!(op, AddAssign(_) | SubAssign(_) | MulAssign(_) | DivAssign(_) | BitXorAssign(_))
}

/// Whether a term is this name.
fn is_name((term, _): &Term, name: &Ident) -> bool {
    matches!(term, Expr::Path(path) if path.path.is_ident(name))
}

impl VisitMut for Regroup {
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        match self.regrouped(expression) {
            Some(regrouped) => *expression = regrouped,
            None => visit_mut::visit_expr_mut(self, expression),
        }
    }

    fn visit_local_mut(&mut self, local: &mut Local) {
        let pattern = match &local.pat {
            Pat::Type(typed) => &*typed.pat,
            pattern => pattern,
        };
        let named = match (pattern, &local.init) {
            (Pat::Ident(pattern), Some(init)) if pattern.mutability.is_none() => {
                let name = pattern.ident.clone();
                let sum = terms(&init.expr);
                let sum = sum.filter(|(_, terms)| {
                    terms.iter().all(|term| self.is_fixed(&term.0) && !is_name(term, &name))
                });
                sum.map(|sum| (name, sum))
            }
            _ => None,
        };
        if let Some(init) = &mut local.init {
            self.visit_local_init_mut(init);
        }
        self.visit_pat_mut(&mut local.pat);
        self.named.extend(named);
        if let (Pat::Ident(name), Some(init)) = (&local.pat, &local.init)
            && matches!(&*init.expr, Expr::Reference(of) if of.mutability.is_some())
        {
            self.borrowed.insert(name.ident.clone());
        }
    }

    /// A name means something else from here on.
    fn visit_pat_ident_mut(&mut self, pattern: &mut PatIdent) {
        let name = &pattern.ident;
        self.named.retain(|of, (_, terms)| of != name && !terms.iter().any(|t| is_name(t, name)));
        match pattern.mutability {
            Some(_) => self.mutable.insert(name.clone()),
            None => self.mutable.remove(name),
        };
    }

    only_what_runs!();
}

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
