//! The values of a function in the order in which it computes them, and their gradients in reverse.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{Error, FieldPat, Pat, Result};

/// A part of a value: the value itself, or a field of it.
#[derive(Clone)]
pub struct Place {
    /// The value's number.
    pub value: usize,
    /// The fields on the way.
    pub path: Vec<TokenStream>,
}

impl From<usize> for Place {
    fn from(value: usize) -> Self {
        Self { value, path: Vec::new() }
    }
}

impl Place {
    /// A field of this part.
    pub fn field(&self, member: &impl ToTokens) -> Self {
        let mut place = self.clone();
        place.path.push(quote!(.#member));
        place
    }

    /// An element of this part.
    pub fn element(&self, index: usize) -> Self {
        let index = syn::Index::from(index);
        let mut place = self.clone();
        place.path.push(quote!([#index]));
        place
    }
}

/// The value of an expression.
pub enum Operand {
    /// Something without a gradient.
    Constant(TokenStream),
    /// A part of a value with a gradient.
    Active(Place),
}

impl Operand {
    pub fn place(self) -> Option<Place> {
        match self {
            Self::Constant(_) => None,
            Self::Active(place) => Some(place),
        }
    }
}

/// The term that a value adds to the gradient of a part that it was computed from.
pub struct Term {
    pub to: Place,
    pub is_negative: bool,
    pub gradient: TokenStream,
}

/// Writes, for the gradient of a value, the statements that its terms need, and the terms.
pub type Rule = Box<dyn FnOnce(&TokenStream) -> (TokenStream, Vec<Term>)>;

struct Value {
    name: TokenStream,
    /// None of an input.
    rule: Option<Rule>,
}

/// A function, or a branch of it.
#[derive(Default)]
pub struct Reverse {
    values: Vec<Value>,
    /// Names of what has a gradient.
    pub active: HashMap<String, Place>,
    /// All names.
    names: HashSet<String>,
    /// Names made up so far.
    count: usize,
    /// The statements of the forward pass.
    pub forward: TokenStream,
}

/// A name that no function has.
fn fresh(prefix: &str, number: usize) -> TokenStream {
    Ident::new(&format!("{prefix}{number}"), Span::mixed_site()).into_token_stream()
}

impl Reverse {
    /// A value that comes from outside.
    pub fn input(&mut self, name: TokenStream) -> usize {
        self.values.push(Value { name, rule: None });
        self.values.len() - 1
    }

    /// A name that nothing has.
    pub fn fresh(&mut self, prefix: &str) -> TokenStream {
        self.count += 1;
        fresh(prefix, self.count)
    }

    /// The name of the next value.
    pub fn next(&self) -> TokenStream {
        fresh("value_", self.values.len())
    }

    /// A value that the forward pass computes.
    pub fn value(&mut self, expression: &TokenStream, rule: Rule) -> Operand {
        let name = self.next();
        self.forward.extend(quote!(let #name = #expression;));
        self.values.push(Value { name, rule: Some(rule) });
        Operand::Active((self.values.len() - 1).into())
    }

    /// Gives a part of a value a name.
    pub fn name(&mut self, name: String, place: Place) {
        self.names.insert(name.clone());
        self.active.insert(name, place);
    }

    /// A name without a gradient.
    pub fn constant_name(&mut self, name: String) {
        self.names.insert(name);
    }

    /// A branch: what has a name here comes from outside.
    pub fn branch(&self) -> (Self, Vec<Place>) {
        let mut branch = Self { names: self.names.clone(), ..Self::default() };
        let mut outer: Vec<_> = self.active.iter().collect();
        outer.sort_by_key(|(name, _)| *name);
        let mut places = Vec::new();
        for (name, place) in outer {
            let ident = Ident::new(name, Span::call_site());
            let input = branch.input(quote!(#ident));
            branch.active.insert(name.clone(), input.into());
            places.push(place.clone());
        }
        (branch, places)
    }

    /// How the forward pass writes an operand.
    pub fn tokens(&self, operand: &Operand) -> TokenStream {
        match operand {
            Operand::Constant(tokens) => tokens.clone(),
            Operand::Active(Place { value, path }) => {
                let name = &self.values[*value].name;
                quote!(#name #(#path)*)
            }
        }
    }

    /// Binds the names of a pattern, and writes the binding.
    pub fn bind(&mut self, pattern: &Pat, value: &TokenStream, place: Option<Place>) -> Result<()> {
        self.forward.extend(quote!(let #pattern = #value;));
        self.names_of(pattern, place)
    }

    fn names_of(&mut self, pattern: &Pat, place: Option<Place>) -> Result<()> {
        match pattern {
            Pat::Ident(ident) if ident.by_ref.is_none() && ident.subpat.is_none() => {
                if ident.mutability.is_some() {
                    return Err(Error::new(
                        pattern.span(),
                        "a gradient needs all values of a variable: replace `mut` by a `let` for each value",
                    ));
                }
                let name = ident.ident.to_string();
                if self.names.contains(&name) {
                    let message = format!(
                        "`{name}` is taken, and a gradient needs both values: choose another name"
                    );
                    return Err(Error::new(pattern.span(), message));
                }
                match place {
                    Some(place) => self.name(name, place),
                    None => self.constant_name(name),
                }
            }
            Pat::Tuple(tuple) => {
                for (index, pattern) in tuple.elems.iter().enumerate() {
                    let field = place.as_ref().map(|place| place.field(&syn::Index::from(index)));
                    self.element_of(pattern, field, index + 1 == tuple.elems.len())?;
                }
            }
            Pat::Slice(slice) => {
                for (index, pattern) in slice.elems.iter().enumerate() {
                    let element = place.as_ref().map(|place| place.element(index));
                    self.element_of(pattern, element, index + 1 == slice.elems.len())?;
                }
            }
            Pat::Struct(of) => {
                for FieldPat { member, pat, .. } in &of.fields {
                    let field = place.as_ref().map(|place| place.field(member));
                    self.names_of(pat, field)?;
                }
            }
            Pat::Type(ty) => self.names_of(&ty.pat, place)?,
            Pat::Paren(paren) => self.names_of(&paren.pat, place)?,
            Pat::Wild(_) => {}
            _ => {
                return Err(Error::new(
                    pattern.span(),
                    "a gradient takes names, tuples, arrays and structs as patterns",
                ));
            }
        }
        Ok(())
    }

    /// A rest, `..`, is at the end: others do not know which elements follow.
    fn element_of(&mut self, pattern: &Pat, place: Option<Place>, is_last: bool) -> Result<()> {
        match pattern {
            Pat::Rest(_) if is_last => Ok(()),
            _ => self.names_of(pattern, place),
        }
    }

    /// The forward pass, the gradients of all values of which `output` is made, and the names of the gradients by value.
    pub fn backward(
        self,
        output: Place,
        seed: TokenStream,
    ) -> (TokenStream, Vec<Option<TokenStream>>) {
        let mut statements = self.forward;
        let mut terms: Vec<Vec<Term>> = self.values.iter().map(|_| Vec::new()).collect();
        let mut sums: Vec<_> = self.values.iter().map(|_| None).collect();
        terms[output.value].push(Term { to: output, is_negative: false, gradient: seed });
        for (number, Value { name, rule }) in self.values.into_iter().enumerate().rev() {
            let found = std::mem::take(&mut terms[number]);
            if found.is_empty() {
                continue;
            }
            let sum = fresh("gradient_", number);
            statements.extend(sum_of(&sum, &name, found));
            if let Some(rule) = rule {
                let (more, found) = rule(&sum);
                statements.extend(more);
                found.into_iter().for_each(|term| terms[term.to.value].push(term));
            }
            sums[number] = Some(sum);
        }
        (statements, sums)
    }
}

/// The sum of terms, on top of another. What is subtracted comes after the first that is added.
fn add(mut terms: Vec<Term>, before: Option<TokenStream>) -> TokenStream {
    let first = terms.iter().position(|term| !term.is_negative);
    let start = match (before, first) {
        (Some(before), _) => before,
        (None, Some(first)) => terms.remove(first).gradient,
        (None, None) => {
            let gradient = terms.remove(0).gradient;
            quote!(-(#gradient))
        }
    };
    terms.into_iter().fold(start, |sum, Term { is_negative, gradient, .. }| match is_negative {
        true => quote!(::muslin::gradient::Adjoint::minus(#sum, #gradient)),
        false => quote!(::muslin::gradient::Adjoint::plus(#sum, #gradient)),
    })
}

/// `let sum = ..`: the terms of the whole value, and over them those of its fields.
fn sum_of(sum: &TokenStream, value: &TokenStream, terms: Vec<Term>) -> TokenStream {
    let (whole, rest): (Vec<_>, Vec<_>) =
        terms.into_iter().partition(|term| term.to.path.is_empty());
    let whole = (!whole.is_empty()).then(|| add(whole, None));
    if rest.is_empty() {
        return quote!(let #sum = #whole;);
    }
    let mut fields: Vec<(String, Vec<TokenStream>, Vec<Term>)> = Vec::new();
    for term in rest {
        let path = &term.to.path;
        // a dot ends each part: no field is the beginning of another's name
        let key: String = path.iter().map(|part| format!("{part}.")).collect();
        match fields.iter_mut().find(|(other, ..)| *other == key) {
            Some((.., terms)) => terms.push(term),
            None => fields.push((key, path.clone(), vec![term])),
        }
    }
    // a field comes before its own fields
    fields.sort_by_key(|(_, path, _)| path.len());
    let mut written: Vec<String> = Vec::new();
    let is_whole = whole.is_some();
    let start = whole.unwrap_or(quote!(::muslin::gradient::Adjoint::zero(#value)));
    let mut statements = quote!(let mut #sum = #start;);
    for (key, path, terms) in fields {
        let has_some = is_whole || written.iter().any(|before| key.starts_with(before.as_str()));
        let before = has_some.then(|| quote!(#sum #(#path)*));
        let after = add(terms, before);
        statements.extend(quote!(#sum #(#path)* = #after;));
        written.push(key);
    }
    statements
}
