//! Calls and branches: what goes backward through code that stands elsewhere, or that ran only if a condition held.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::spanned::Spanned;
use syn::{Block, Error, Expr, ExprIf, Result};

use super::lower::{FIELDS, LANE, last, term};
use super::reverse::{Operand, Place, Reverse};

impl Reverse {
    /// `f(..)`: a vector, a struct without names, a function of every lane, or one that has a backward function beside it.
    pub fn call<'a>(
        &mut self,
        function: &Expr,
        arguments: impl Iterator<Item = &'a Expr> + Clone,
    ) -> Result<Operand> {
        let Expr::Path(of) = function else {
            return Err(Error::new(function.span(), "a gradient calls functions by their names"));
        };
        let path = &of.path;
        let Some(name) = last(path) else { return Err(Error::new(path.span(), "which function?")) };
        let words: Vec<_> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let vector = ["Vec2", "Vec3", "Vec4"]
            .iter()
            .any(|ty| words.iter().rev().nth(1).is_some_and(|word| word == ty));
        let is_vector =
            (vector && name == "new") || ["vec2", "vec3", "vec4"].iter().any(|ty| name == ty);
        if is_vector {
            return self.several(
                arguments,
                |values| quote!(#path(#(#values),*)),
                |index| {
                    let field = format_ident!("{}", FIELDS.get(index).unwrap_or(&"w"));
                    quote!(.#field)
                },
            );
        }
        if name.to_string().starts_with(char::is_uppercase) {
            return self.several(
                arguments,
                |values| quote!(#path(#(#values),*)),
                |index| {
                    let index = syn::Index::from(index);
                    quote!(.#index)
                },
            );
        }
        let operands =
            arguments.map(|argument| self.expression(argument)).collect::<Result<Vec<_>>>()?;
        if LANE.iter().any(|&(lane, arguments)| name == lane && arguments == operands.len()) {
            return Ok(self.lane(name, operands, |values| quote!(#path(#(#values),*))));
        }
        let mut backward = of.clone();
        if let Some(segment) = backward.path.segments.last_mut() {
            segment.ident = format_ident!("{}_backward", name, span = name.span());
        }
        Ok(self.called(
            operands,
            |values| quote!(#path(#(#values),*)),
            move |values, d| quote!(#backward(#(#values,)* #d)),
        ))
    }

    /// `x.f(..)`
    pub fn method(&mut self, of: &syn::ExprMethodCall) -> Result<Operand> {
        let name = &of.method;
        let turbofish = &of.turbofish;
        let arguments = std::iter::once(&*of.receiver).chain(&of.args);
        let operands =
            arguments.map(|argument| self.expression(argument)).collect::<Result<Vec<_>>>()?;
        let call = |values: &[TokenStream]| {
            let receiver = &values[0];
            let values = &values[1..];
            quote!(#receiver.#name #turbofish (#(#values),*))
        };
        if LANE.iter().any(|&(lane, arguments)| name == lane && arguments == operands.len()) {
            return Ok(self.lane(name, operands, |values| call(&values)));
        }
        let backward = format_ident!("{}_backward", name, span = name.span());
        Ok(self.called(
            operands,
            |values| call(&values),
            move |values, d| {
                let receiver = &values[0];
                let values = &values[1..];
                quote!(#receiver.#backward(#(#values,)* #d))
            },
        ))
    }

    /// A function of every lane: its gradient may also take the value.
    fn lane(
        &mut self,
        name: &syn::Ident,
        operands: Vec<Operand>,
        call: impl FnOnce(Vec<TokenStream>) -> TokenStream,
    ) -> Operand {
        let value = self.next();
        let backward = format_ident!("{}_backward", name);
        let takes_value = operands.len() == 1;
        self.called(operands, call, move |values, d| {
            let values = if takes_value { std::slice::from_ref(&value) } else { values };
            quote!(::muslin::gradient::#backward(#(#values,)* #d))
        })
    }

    /// A call, and one of its backward function, which gives an entry for each argument.
    pub fn called(
        &mut self,
        operands: Vec<Operand>,
        call: impl FnOnce(Vec<TokenStream>) -> TokenStream,
        backward: impl FnOnce(&[TokenStream], &TokenStream) -> TokenStream + 'static,
    ) -> Operand {
        let values: Vec<_> = operands.iter().map(|operand| self.tokens(operand)).collect();
        let value = call(values.clone());
        let entries: Vec<_> =
            operands.into_iter().map(|operand| (self.fresh("entry_"), operand.place())).collect();
        self.value(
            &value,
            Box::new(move |d| {
                let backward = backward(&values, d);
                let names = entries
                    .iter()
                    .map(|(name, place)| if place.is_some() { name.clone() } else { quote!(_) });
                let pattern =
                    if entries.len() == 1 { quote!(#(#names)*) } else { quote!((#(#names),*)) };
                let terms = entries
                    .iter()
                    .filter_map(|(name, place)| Some(term(place.as_ref()?, name.clone())));
                (quote!(let #pattern = #backward;), terms.collect())
            }),
        )
    }

    /// `if .. else ..`: only the branch that was taken runs backward.
    pub fn branches(&mut self, of: &ExprIf) -> Result<Operand> {
        if let Expr::Let(of) = &*of.cond {
            return Err(Error::new(of.span(), "a gradient has no `if let`: use `if .. else ..`"));
        }
        let Some((_, otherwise)) = &of.else_branch else {
            return Err(Error::new(
                of.span(),
                "a gradient needs a value in either case: add `else`",
            ));
        };
        let otherwise = match &**otherwise {
            Expr::Block(otherwise) => otherwise.block.clone(),
            otherwise => syn::parse_quote!({ #otherwise }),
        };
        let condition = self.constant(&of.cond);
        let condition = self.tokens(&condition);
        let seed = self.fresh("seed_");
        let (yes, places) = self.taken(&of.then_branch, &seed)?;
        let (no, _) = self.taken(&otherwise, &seed)?;
        let used: Vec<_> = (0..places.len())
            .filter(|&input| yes.1[input].is_some() || no.1[input].is_some())
            .collect();
        let values: Vec<_> = used
            .iter()
            .map(|&input| self.tokens(&Operand::Active(places[input].clone())))
            .collect();
        let gradients = |sums: &[Option<TokenStream>]| {
            let sums = used.iter().zip(&values).map(|(&input, value)| {
                sums[input].clone().unwrap_or(quote!(::muslin::gradient::Adjoint::zero(#value)))
            });
            quote!((#(#sums,)*))
        };
        let yes_gradients = gradients(&yes.1);
        let no_gradients = gradients(&no.1);
        let yes = yes.0;
        let no = no.0;
        let then = &of.then_branch;
        let names: Vec<_> = used.iter().map(|_| self.fresh("entry_")).collect();
        let places: Vec<_> = used.iter().map(|&input| places[input].clone()).collect();
        let value = quote!(if #condition #then else #otherwise);
        Ok(self.value(&value, Box::new(move |d| {
            let statements = quote! {
                let #seed = #d;
                let (#(#names,)*) = if #condition { #yes #yes_gradients } else { #no #no_gradients };
            };
            let terms = places.iter().zip(&names).map(|(place, name)| term(place, name.clone()));
            (statements, terms.collect())
        })))
    }

    /// A branch backward, and where its inputs come from.
    #[allow(clippy::type_complexity)]
    fn taken(
        &self,
        block: &Block,
        seed: &TokenStream,
    ) -> Result<((TokenStream, Vec<Option<TokenStream>>), Vec<Place>)> {
        let (mut branch, places) = self.branch();
        let backward = match branch.block(block)?.place() {
            Some(output) => branch.backward(output, seed.clone()),
            None => (quote!(), vec![None; places.len()]),
        };
        Ok((backward, places))
    }
}
