//! Writes the function that runs a workgroup region by region.

use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::visit_mut::{self, VisitMut};
use syn::{BinOp, Expr, Ident, Lit, Member, Pat, Stmt, parse_quote};

use super::crossing::{Crossing, Variable};
use super::cut::{Head, List, Part};
use super::scan::is_name;
use super::uniform::Names;
use crate::checks;
use crate::function::hygienic;
use crate::parse::{Kernel, Lanes};

pub struct Writer<'a> {
    pub kernel: &'a Kernel,
    pub names: &'a Names<'a>,
    pub crossing: &'a Crossing<'a>,
    /// Whether the kernel can have a `usize`.
    pub has_usize: bool,
    /// The number of the next segment.
    pub next: usize,
}

/// Ends an invocation's part of a region where the kernel returns.
struct Returns;

impl VisitMut for Returns {
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        if let Expr::Return(of) = expression {
            let value = &of.expr;
            *expression = syn::parse2(hygienic!(break 'region #value)).expect("an expression");
        }
        visit_mut::visit_expr_mut(self, expression);
    }

    fn visit_expr_closure_mut(&mut self, _: &mut syn::ExprClosure) {}
    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}

/// The place in the source, for a message.
fn here(span: Span) -> TokenStream {
    quote_spanned!(span => ::muslin::regions::here())
}

/// The place of a list's first barrier.
fn barrier_of(list: &List) -> TokenStream {
    match list.first_barrier() {
        Some(method) => {
            let here = here(method.span());
            quote!(::core::option::Option::Some(#here))
        }
        None => quote!(::core::option::Option::None),
    }
}

impl Writer<'_> {
    /// Statements with the checks that debug builds have.
    fn checked(&self, statements: Vec<Stmt>) -> TokenStream {
        let mut block = syn::Block { brace_token: syn::token::Brace::default(), stmts: statements };
        checks::add_to_part(&mut block, self.has_usize);
        let statements = block.stmts;
        quote!(#(#statements)*)
    }

    /// Statements of which each ends with a semicolon, where it is none of its own.
    fn statements(&self, statements: &[&Stmt]) -> TokenStream {
        let ended = statements.iter().map(|&statement| match statement {
            Stmt::Expr(expression, None) => Stmt::Expr(expression.clone(), Some(parse_quote!(;))),
            other => other.clone(),
        });
        self.checked(ended.collect())
    }

    fn value(&self, expression: &Expr) -> TokenStream {
        let value = self.checked(vec![Stmt::Expr(expression.clone(), None)]);
        quote!({ #value })
    }

    /// The parts of a list, for a block.
    pub fn list(&mut self, list: &List) -> TokenStream {
        let items = &list.items;
        let parts: Vec<_> = list.parts.iter().map(|part| self.part(part)).collect();
        quote!(#(#items)* #(#parts)*)
    }

    fn part(&mut self, part: &Part) -> TokenStream {
        match part {
            Part::Region(statements) => self.region(statements),
            Part::Barrier(method) => {
                quote_spanned!(Span::mixed_site().located_at(method.span()) => regions.#method::<MUSLIN_PLAIN>()?;)
            }
            Part::Block(list) => {
                let list = self.list(list);
                quote!({ #list })
            }
            Part::Branch { at, condition, ways } => {
                let barriers = ways.each_ref().map(barrier_of);
                let [before, decision] = self.decision(*at, condition, barriers, false);
                let [then, otherwise] = ways.each_ref().map(|way| self.list(way));
                hygienic!({ #before if #decision { #then } else { #otherwise } })
            }
            Part::Loop { at, head, body } => self.looped(*at, head, body),
        }
    }

    fn looped(&mut self, at: Span, head: &Head, body: &List) -> TokenStream {
        // the message has the loop's place
        let regions = Ident::new("regions", Span::mixed_site());
        let count = quote_spanned! { at =>
            ::muslin::checked!(#regions.iterate(););
        };
        let barriers = [barrier_of(body), quote!(::core::option::Option::None)];
        match head {
            Head::For(pattern, over) if self.crossing.is_uniform_loop(pattern, over) => {
                let over = self.value(over);
                let body = self.list(body);
                hygienic!(for #pattern in #over { #count #body })
            }
            Head::For(pattern, over) => {
                let value = self.value(over);
                let begin = self.segment(&hygienic!([0, count]), |_| {
                    hygienic!(unsafe { rounds.put(index, ::core::iter::IntoIterator::into_iter(#value)) };)
                });
                let next = self.next_round(pattern);
                let fork = fork(at, &barriers, true);
                let body = self.list(body);
                let slot = self.slot();
                hygienic! {{
                    let rounds = #slot;
                    #begin
                    let mut round = 0;
                    loop {
                        round += 1;
                        #next
                        if !votes.decide(#fork)? {
                            break;
                        }
                        #count
                        #body
                    }
                }}
            }
            Head::While(condition) => {
                let [before, decision] = self.decision(at, condition, barriers, true);
                let body = self.list(body);
                let round = (!before.is_empty()).then(|| hygienic!(let mut round = 0;));
                let next = (!before.is_empty()).then(|| hygienic!(round += 1;));
                hygienic! {{
                    #round
                    loop {
                        #next
                        #before
                        if !#decision {
                            break;
                        }
                        #count
                        #body
                    }
                }}
            }
        }
    }

    /// Every invocation takes the next round of a loop, or votes for its end.
    fn next_round(&mut self, pattern: &Pat) -> TokenStream {
        let width = self.width();
        let next = self.segment(&hygienic!([0, count]), |puts| {
            hygienic! {
                let mut all = unsafe { rounds.take(index) };
                let next = ::core::iter::Iterator::next(&mut all);
                unsafe { rounds.put(index, all) };
                votes.set(index, #width, next.is_some());
                if let ::core::option::Option::Some(#pattern) = next {
                    #puts
                }
            }
        });
        let votes = self.votes();
        hygienic!(#votes #next)
    }

    /// What comes before a decision that all invocations make alike, and the decision.
    fn decision(
        &mut self,
        at: Span,
        condition: &Expr,
        barriers: [TokenStream; 2],
        is_loop: bool,
    ) -> [TokenStream; 2] {
        let value = self.value(condition);
        if self.crossing.is_uniform(condition) {
            return [quote!(), value];
        }
        let votes = self.votes();
        let width = self.width();
        let vote = self.segment(
            &hygienic!([0, count]),
            |puts| hygienic!(votes.set(index, #width, #value); #puts),
        );
        let fork = fork(at, &barriers, is_loop);
        [hygienic!(#votes #vote), hygienic!(votes.decide(#fork)?)]
    }

    fn votes(&self) -> TokenStream {
        let count = self.count();
        hygienic!(let mut votes = ::muslin::regions::Votes::<{ #count as usize }>::new();)
    }

    fn region(&mut self, statements: &[Stmt]) -> TokenStream {
        let sorted = self.names.sort(statements);
        let before = self.statements(&sorted.before);
        let after = self.statements(&sorted.after);
        // in debug builds, arithmetic can fail in any invocation
        let may_fail = sorted.places.iter().any(|name| self.names.has_arithmetic(name));
        let bounds = match may_fail {
            true => hygienic!([0, count]),
            false => self.bounds(&sorted.each),
        };
        let mut each = sorted.each.into_iter().cloned().collect::<Vec<_>>();
        each.iter_mut().for_each(|statement| Returns.visit_stmt_mut(statement));
        let each = self.statements(&each.iter().collect::<Vec<_>>());
        let is_empty = each.is_empty() && sorted.places.is_empty();
        let each = self.segment(&bounds, |puts| hygienic!(#each #puts));
        let each = (!is_empty).then_some(each);
        quote!(#before #each #after)
    }

    /// A loop over the invocations.
    fn segment(
        &mut self,
        bounds: &TokenStream,
        inner: impl FnOnce(TokenStream) -> TokenStream,
    ) -> TokenStream {
        let at = self.next;
        self.next += 1;
        let places = self.names.needed(&self.crossing.segments[at].names).into_iter().map(
            |(name, value)| {
                let value = self.value(value);
                let same = same(name);
                hygienic!(let #name = #same.of(#value);)
            },
        );
        let takes = self.crossing.takes(at).into_iter().map(
            |Variable { name, slot, .. }| hygienic!(let mut #name = unsafe { #slot.take(index) };),
        );
        let puts = self
            .crossing
            .puts(at)
            .into_iter()
            .map(|Variable { name, slot, .. }| hygienic!(unsafe { #slot.put(index, #name) };));
        let inner = inner(hygienic!(#(#puts)*));
        let id = &self.kernel.id;
        let width = self.width();
        hygienic! {
            let [mut step, end] = regions.steps::<MUSLIN_PLAIN>(#width, #bounds, count);
            while step < end {
                let entered = regions.enter::<MUSLIN_PLAIN>(step, &mut place);
                let index = entered.index;
                let #id = &place;
                #(#places)*
                #(#takes)*
                'region: { #inner }
                regions.leave(entered);
                step += #width;
            }
        }
    }

    /// What the lanes of a step are: of the kernel's type, if it takes several invocations.
    fn lanes(&self) -> TokenStream {
        match (&self.kernel.lanes, self.kernel.lanes_type()) {
            (Some(Lanes::Invocations(_)), Some(lanes)) => quote!(#lanes),
            _ => quote!(f32),
        }
    }

    /// The number of invocations that a step takes.
    fn width(&self) -> TokenStream {
        let lanes = self.lanes();
        quote!(<#lanes as ::muslin::lane::Lane>::WIDTH)
    }

    /// The number of invocations.
    pub fn count(&self) -> TokenStream {
        let [x, y, z] = &self.kernel.threads;
        quote!(((#x) * (#y) * (#z)))
    }

    fn slot(&self) -> TokenStream {
        let count = self.count();
        let lanes = self.lanes();
        quote!(::muslin::regions::PerInvocation::<_, { #count as usize }, #lanes>::new())
    }

    /// The arrays of variables that cross barriers, and the types of those that each region computes.
    pub fn arrays(&self) -> TokenStream {
        let slots = self.crossing.crossing().map(|variable| {
            let Variable { slot, .. } = variable;
            let new = self.slot();
            quote!(let #slot = #new;)
        });
        let types = self.names.places.iter().map(|(name, _)| {
            let same = same(name);
            quote!(let #same = ::muslin::regions::Same::new();)
        });
        quote!(#(#slots)* #(#types)*)
    }

    /// The invocations that do something in a region, as far as that is seen: `if at < half { .. }` is for those below `half`.
    fn bounds(&self, statements: &[&Stmt]) -> TokenStream {
        let all = hygienic!([0, count]);
        let [Stmt::Expr(Expr::If(of), _)] = statements else { return all };
        if of.else_branch.is_some() {
            return all;
        }
        let mut condition = &*of.cond;
        while let Expr::Binary(both) = condition
            && matches!(both.op, BinOp::And(_))
        {
            condition = &both.left;
        }
        let Expr::Binary(of) = condition else { return all };
        let is_right = self.is_index(&of.left) && self.names.is_uniform(&of.right);
        let is_left = self.is_index(&of.right) && self.names.is_uniform(&of.left);
        let bound = match (is_right, is_left) {
            (true, _) => self.value(&of.right),
            (_, true) => self.value(&of.left),
            _ => return all,
        };
        let range = match (&of.op, is_right) {
            (BinOp::Lt(_), true) | (BinOp::Gt(_), false) => hygienic!([0, bound]),
            (BinOp::Le(_), true) | (BinOp::Ge(_), false) => hygienic!([0, bound.saturating_add(1)]),
            (BinOp::Gt(_), true) | (BinOp::Lt(_), false) => {
                hygienic!([bound.saturating_add(1), count])
            }
            (BinOp::Ge(_), true) | (BinOp::Le(_), false) => hygienic!([bound, count]),
            (BinOp::Eq(_), _) => hygienic!([bound, bound.saturating_add(1)]),
            _ => return all,
        };
        hygienic!({ let bound: u32 = #bound; #range })
    }

    /// Whether an expression is the number of an invocation in its workgroup.
    fn is_index(&self, expression: &Expr) -> bool {
        let id = &self.kernel.id;
        let is_one = |size: &Expr| matches!(size, Expr::Lit(of) if matches!(&of.lit, Lit::Int(one) if one.base10_digits() == "1"));
        match expression {
            Expr::Paren(of) => self.is_index(&of.expr),
            Expr::MethodCall(of) => is_name(&of.receiver, id) && of.method == "local_index",
            Expr::Field(of) => {
                let is_x = matches!(&of.member, Member::Named(name) if name == "x");
                let is_local = matches!(&*of.base, Expr::Field(of) if is_name(&of.base, id) && matches!(&of.member, Member::Named(name) if name == "local"));
                is_x && is_local && self.kernel.threads[1..].iter().all(is_one)
            }
            Expr::Path(of) => {
                let value = |name: &Ident| self.names.places.iter().find(|(of, _)| of == name);
                of.path.get_ident().and_then(value).is_some_and(|(_, value)| self.is_index(value))
            }
            _ => false,
        }
    }
}

/// The name of a variable's type.
fn same(name: &Ident) -> Ident {
    quote::format_ident!("{name}_type", span = Span::mixed_site())
}

/// Where invocations can part, for a message.
fn fork(at: Span, [yes, no]: &[TokenStream; 2], is_loop: bool) -> TokenStream {
    let at = here(at);
    let round = if is_loop { hygienic!(round) } else { quote!(0) };
    hygienic!(&::muslin::regions::Fork { regions, at: #at, barriers: [#yes, #no], round: #round })
}
