//! The gradient of a straight-line function: reverse mode, written out as a function.

mod calls;
mod lower;
mod reverse;
#[cfg(test)]
mod tests;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use syn::spanned::Spanned;
use syn::{Attribute, Error, Fields, FnArg, ImplItemFn, ItemStruct, Path, Result, Token, Type};

use reverse::Reverse;

/// The item, and what its gradient needs: of a function its backward function, of a struct its sums.
pub fn gradient(attribute: TokenStream, item: TokenStream) -> Result<TokenStream> {
    if let Ok(item) = syn::parse2::<ItemStruct>(item.clone()) {
        let adjoint = adjoint(&item)?;
        return Ok(quote!(#item #adjoint));
    }
    let by = syn::parse::Parser::parse2(better, attribute)?;
    let mut function: ImplItemFn = syn::parse2(item).map_err(|error| {
        Error::new(error.span(), "`#[gradient]` takes a function or a struct with fields")
    })?;
    let backward = backward(&function, by.as_ref())?;
    for input in &mut function.sig.inputs {
        if let FnArg::Typed(input) = input {
            input.attrs.retain(|attribute| !is_constant(attribute));
        }
    }
    Ok(quote!(#function #backward))
}

/// `by = f`
fn better(input: syn::parse::ParseStream<'_>) -> Result<Option<Path>> {
    if input.is_empty() {
        return Ok(None);
    }
    let name: Ident = input.parse()?;
    if name != "by" {
        return Err(Error::new(name.span(), "`#[gradient]` takes nothing but `by = f`"));
    }
    input.parse::<Token![=]>()?;
    input.parse().map(Some)
}

fn is_constant(attribute: &Attribute) -> bool {
    attribute.path().is_ident("constant")
}

/// Sums of a struct, field by field.
fn adjoint(item: &ItemStruct) -> Result<TokenStream> {
    let Fields::Named(fields) = &item.fields else {
        return Err(Error::new(item.ident.span(), "`#[gradient]` takes structs with named fields"));
    };
    let mut generics = item.generics.clone();
    for parameter in generics.type_params_mut() {
        parameter.bounds.push(syn::parse_quote!(::muslin::gradient::Adjoint));
    }
    let name = &item.ident;
    let (parameters, arguments, bounds) = generics.split_for_impl();
    let fields: Vec<_> = fields.named.iter().filter_map(|field| field.ident.as_ref()).collect();
    let each = |method: TokenStream| {
        let values = fields.iter().map(
            |field| quote!(#field: ::muslin::gradient::Adjoint::#method(self.#field, other.#field)),
        );
        quote!(#[inline(always)] fn #method(self, other: Self) -> Self { Self { #(#values),* } })
    };
    let plus = each(quote!(plus));
    let minus = each(quote!(minus));
    Ok(quote! {
        impl #parameters ::muslin::gradient::Adjoint for #name #arguments #bounds {
            #[inline(always)]
            fn zero(self) -> Self {
                Self { #(#fields: ::muslin::gradient::Adjoint::zero(self.#fields)),* }
            }
            #plus
            #minus
        }
    })
}

/// The gradient of a parameter.
struct Parameter {
    /// Name in the backward function.
    name: TokenStream,
    /// Name in the declaration, where that is a pattern.
    pattern: Option<syn::Pat>,
    /// Type, unless it takes no gradient.
    gradient: Option<Type>,
}

/// A parameter that is a number, or several: no reference, no integer, nothing marked `#[constant]`.
fn parameter(input: &mut FnArg, index: usize) -> Result<Parameter> {
    let input = match input {
        FnArg::Receiver(receiver) => {
            let gradient = receiver.reference.is_none().then(|| syn::parse_quote!(Self));
            let name = quote!(self);
            return Ok(Parameter { name, pattern: None, gradient });
        }
        FnArg::Typed(input) => input,
    };
    let marked = input.attrs.iter().any(is_constant);
    input.attrs.retain(|attribute| !is_constant(attribute));
    let is_number = match &*input.ty {
        Type::Reference(_) => false,
        Type::Path(ty) => {
            !["u32", "i32", "usize", "bool"].iter().any(|name| ty.path.is_ident(name))
        }
        _ => true,
    };
    let gradient = (is_number && !marked).then(|| (*input.ty).clone());
    if let syn::Pat::Ident(pattern) = &*input.pat
        && pattern.mutability.is_none()
    {
        let name = &pattern.ident;
        return Ok(Parameter { name: quote!(#name), pattern: None, gradient });
    }
    let name = Ident::new(&format!("argument_{index}"), Span::mixed_site());
    let pattern = std::mem::replace(&mut *input.pat, syn::parse_quote!(#name));
    Ok(Parameter { name: quote!(#name), pattern: Some(pattern), gradient })
}

/// The backward function.
fn backward(function: &ImplItemFn, by: Option<&Path>) -> Result<TokenStream> {
    let mut sig = function.sig.clone();
    let forward = sig.ident.clone();
    sig.ident = format_ident!("{forward}_backward");
    let syn::ReturnType::Type(_, output) = &sig.output else {
        return Err(Error::new(
            forward.span(),
            format!("`{forward}` returns nothing: a gradient begins at the value"),
        ));
    };
    let seed = Ident::new("gradient", Span::mixed_site());
    let output = output.clone();
    let inputs = sig.inputs.iter_mut().enumerate();
    let parameters =
        inputs.map(|(index, input)| parameter(input, index)).collect::<Result<Vec<_>>>()?;
    sig.inputs.push(syn::parse_quote!(#seed: #output));
    let types: Vec<_> = parameters
        .iter()
        .map(|parameter| match &parameter.gradient {
            Some(ty) => quote!(#ty),
            None => quote!(()),
        })
        .collect();
    sig.output = match &types[..] {
        [one] => syn::parse_quote!(-> #one),
        several => syn::parse_quote!(-> (#(#several),*)),
    };
    if parameters.iter().all(|parameter| parameter.gradient.is_none()) {
        return Err(Error::new(
            forward.span(),
            format!("no parameter of `{forward}` takes a gradient"),
        ));
    }
    let body = match by {
        Some(by) => {
            let names = parameters.iter().map(|parameter| &parameter.name);
            quote!(#by(#(#names,)* #seed))
        }
        None => body(function, &parameters, &seed)?,
    };
    let doc = format!(
        "The gradient of [`{forward}`](Self::{forward}): of a loss's derivative with respect to its value those with respect to its \
         parameters, `()` for one that takes none."
    );
    let doc = match function.sig.receiver() {
        Some(_) => doc,
        None => doc.replace("Self::", ""),
    };
    let attributes = kept(&function.attrs);
    let visibility = &function.vis;
    Ok(quote! {
        #[doc = #doc]
        #(#attributes)*
        #[allow(unused, clippy::all, clippy::pedantic)]
        #visibility #sig { #body }
    })
}

/// The attributes that the backward function has, too.
fn kept(attributes: &[Attribute]) -> impl Iterator<Item = &Attribute> {
    let names = ["cfg", "inline", "must_use", "allow"];
    attributes
        .iter()
        .filter(move |attribute| names.iter().any(|name| attribute.path().is_ident(name)))
}

fn body(function: &ImplItemFn, parameters: &[Parameter], seed: &Ident) -> Result<TokenStream> {
    let mut reverse = Reverse::default();
    let mut inputs = Vec::new();
    for parameter in parameters {
        let takes = parameter.gradient.is_some();
        let input = takes.then(|| reverse.input(parameter.name.clone()));
        inputs.push(input);
        match (&parameter.pattern, input) {
            (None, Some(input)) => reverse.name(parameter.name.to_string(), input.into()),
            (None, None) => reverse.constant_name(parameter.name.to_string()),
            (Some(pattern), _) => reverse.bind(pattern, &parameter.name, input.map(Into::into))?,
        }
    }
    let output = reverse.block(&function.block)?;
    let Some(output) = output.place() else {
        return Err(Error::new(
            function.block.span(),
            "the value does not depend on a parameter that takes a gradient",
        ));
    };
    let (statements, sums) = reverse.backward(output, quote!(#seed));
    let gradients =
        parameters.iter().zip(inputs).map(|(Parameter { name, .. }, input)| match input {
            Some(input) => {
                sums[input].clone().unwrap_or(quote!(::muslin::gradient::Adjoint::zero(#name)))
            }
            None => quote!(()),
        });
    Ok(match parameters.len() {
        1 => quote!(#statements #(#gradients)*),
        _ => quote!(#statements (#(#gradients),*)),
    })
}
