//! Reads a kernel's declaration.

use std::ops::Deref;

use proc_macro2::TokenStream;
use syn::meta::ParseNestedMeta;
use syn::parse::{Parse, Parser};
use syn::spanned::Spanned;
use syn::{
    Error, Expr, FnArg, GenericArgument, Ident, ItemFn, ItemStruct, Pat, PathArguments,
    PathSegment, Result, Stmt, Type, TypeParamBound, parse_quote,
};

use crate::checks::first_loop;
use crate::regions;

/// The role of a kernel's parameter.
pub enum Role {
    /// `&P`
    Uniform,
    /// `Read<T>` or `ReadFours<T>`
    Read,
    /// `Packed<T>`
    Packed,
    /// `Write<T>` or `WriteFours<T>`
    Write,
    /// `Shared<T, N>`, with its length
    Shared(Box<GenericArgument>),
    /// `&mut impl SharedTile<T, N>`, with its length
    SharedTile(Box<GenericArgument>),
}

impl Role {
    /// Whether the host binds a buffer to it.
    pub fn is_binding(&self) -> bool {
        matches!(self, Self::Uniform | Self::Read | Self::Packed | Self::Write)
    }

    /// Whether it is a view of memory that the CPU run names in its messages.
    pub fn is_named(&self) -> bool {
        matches!(self, Self::Read | Self::Packed | Self::Write | Self::Shared(_))
    }
}

/// One parameter after the invocation.
pub struct Parameter {
    pub name: Ident,
    pub role: Role,
    /// `P` or `T` of [`Role`].
    pub element: Type,
    /// The same on a GPU: of `ReadFours<T>` and `WriteFours<T>`, a vector.
    pub device_element: Type,
    /// Whether it is `Write<impl SumWord>`: `u32`, and in the variant `u64`.
    pub is_sum: bool,
}

/// How the CPU fills the lanes of a kernel that is generic over them.
pub enum Lanes {
    /// With consecutive invocations along x, those below a field of the uniform buffer.
    Invocations(Ident),
    /// The kernel does it itself: each invocation has all lanes.
    Inside,
}

/// A kernel's declaration.
pub struct Kernel {
    pub function: ItemFn,
    /// Invocations of a workgroup: constant expressions.
    pub threads: [Expr; 3],
    pub attribute: Attribute,
    /// Whether it is generic over `Samples`: an invocation of a GPU takes four of them.
    pub samples: bool,
    /// Name of the invocation in the kernel.
    pub id: Ident,
    pub parameters: Vec<Parameter>,
}

/// What `#[kernel(..)]` says beside the threads.
#[derive(Default)]
pub struct Attribute {
    pub fused: bool,
    /// Whether it has barriers without workgroup memory.
    pub storage_barriers: bool,
    /// Whether it has operations of subgroups.
    pub subgroups: bool,
    /// Whether it is not to be cut into regions.
    pub coroutines: bool,
    /// The shape of its products of tiles, if it has some.
    pub tiles: Option<[Expr; 3]>,
    /// On the CPU the workgroups of one z run one after another, on one thread.
    pub z_serial: bool,
    /// On the CPU the workgroups of one x and y run one after another.
    pub z_innermost: bool,
    pub lanes: Option<Lanes>,
    /// Largest number of iterations of one invocation.
    pub iterations: Option<Expr>,
    /// Fields of the uniform buffer whose values only the device can know.
    pub counts: Vec<Ident>,
    /// Bindings whose elements come in any order.
    pub unordered: Vec<Ident>,
    /// What a dispatch runs over.
    pub over: Vec<Expr>,
}

impl Deref for Kernel {
    type Target = Attribute;

    fn deref(&self) -> &Attribute {
        &self.attribute
    }
}

impl Kernel {
    pub fn parse(attribute: TokenStream, item: TokenStream) -> Result<Self> {
        let function: ItemFn = syn::parse2(item)?;
        let (threads, attribute) = parse_attribute(attribute)?;
        let mut inputs = function.sig.inputs.iter();
        let id = inputs.next().and_then(invocation).ok_or_else(|| {
            Error::new(function.sig.span(), "the first parameter of a kernel is `id: Invocation`")
        })?;
        let parameters = inputs.map(parse_parameter).collect::<Result<Vec<_>>>()?;
        if parameters.iter().filter(|p| matches!(p.role, Role::Uniform)).count() > 1 {
            return Err(Error::new(function.sig.span(), "a kernel has at most one `&Params`"));
        }
        let generics = &function.sig.generics;
        if attribute.lanes.is_none() && !generics.params.is_empty() {
            let name = &function.sig.ident;
            let message = format!(
                "the kernel `{name}` is generic, and a kernel without `lanes` is not: make the body a generic function, and let a \
                 kernel for each instance call it, as `{name}::<16>(id, ..)`"
            );
            return Err(Error::new(generics.span(), message));
        }
        if attribute.lanes.is_some()
            && (generics.params.len() != 1 || generics.type_params().count() != 1)
        {
            return Err(Error::new(
                function.sig.span(),
                "a kernel with `lanes` is generic over one `Lane` or `Samples`",
            ));
        }
        let samples =
            generics.type_params().flat_map(|parameter| &parameter.bounds).any(is_samples);
        let kernel = Self { function, threads, attribute, samples, id, parameters };
        if kernel.samples && !matches!(kernel.lanes, Some(Lanes::Invocations(_))) {
            let message = "a kernel that is generic over `Samples` has `lanes(field)`";
            return Err(Error::new(kernel.function.sig.span(), message));
        }
        if !kernel.counts.is_empty() && kernel.uniform().is_none() {
            let message = "`counts` are fields of the kernel's `&Params`";
            return Err(Error::new(kernel.function.sig.span(), message));
        }
        let is_written = |name: &Ident| {
            let is_it = |parameter: &Parameter| {
                parameter.name == *name && matches!(parameter.role, Role::Write)
            };
            kernel.parameters.iter().any(is_it)
        };
        if let (None, Some(span)) = (&kernel.iterations, first_loop(&kernel.function.block)) {
            let name = &kernel.function.sig.ident;
            let message = format!(
                "the kernel `{name}` has a loop: state how many iterations its loops take at most, all together, with \
                 `#[kernel(.., iterations = ..)]`"
            );
            return Err(Error::new(span, message));
        }
        if let Some(name) = kernel.unordered.iter().find(|name| !is_written(name)) {
            return Err(Error::new(name.span(), "`unordered` names bindings of the type `Write`"));
        }
        let has_others = kernel.lanes.is_some() || kernel.subgroups || kernel.storage_barriers;
        if kernel.tiles.is_some() && (has_others || kernel.has_variant()) {
            let message = "a kernel with `tiles` has no `lanes`, storage barriers, subgroups, sums or shared tiles";
            return Err(Error::new(kernel.function.sig.span(), message));
        }
        if kernel.lanes.is_some()
            && kernel.waits()
            && let Err(kept) = regions::function(&kernel)
        {
            let message = format!(
                "the kernel `{}` has `lanes`, and the CPU cannot cut it at its barriers: {kept}",
                kernel.function.sig.ident
            );
            return Err(Error::new(kernel.function.sig.span(), message));
        }
        Ok(kernel)
    }

    /// The uniform buffer.
    pub fn uniform(&self) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| matches!(parameter.role, Role::Uniform))
    }

    /// Name of the type of lanes in the kernel.
    pub fn lanes_type(&self) -> Option<&Ident> {
        self.function.sig.generics.type_params().next().map(|parameter| &parameter.ident)
    }

    /// Whether the invocations of a workgroup can wait for each other.
    pub fn waits(&self) -> bool {
        self.storage_barriers || self.subgroups || self.has(|role| matches!(role, Role::Shared(_)))
    }

    /// Whether it has a second entry point, beside that with tiles.
    pub fn has_variant(&self) -> bool {
        self.has_shared_tiles() || self.sums().next().is_some()
    }

    /// Whether the variant has shared tiles in workgroup memory.
    pub fn has_shared_tiles(&self) -> bool {
        self.has(|role| matches!(role, Role::SharedTile(_)))
    }

    /// The bindings that are 64-bit integers in the variant.
    pub fn sums(&self) -> impl Iterator<Item = &Parameter> {
        self.parameters.iter().filter(|parameter| parameter.is_sum)
    }

    fn has(&self, what: impl Fn(&Role) -> bool) -> bool {
        self.parameters.iter().any(|parameter| what(&parameter.role))
    }
}

/// `threads(x)`, `threads(x, y)` or `threads(x, y, z)`, `iterations = n`, `fused`, `storage_barriers`, `subgroups`, `coroutines`, `z_serial` or `z_innermost`, `lanes` or
/// `lanes(field)`, `tiles(m, n, k)`, `over(items, ..)`, `counts(field, ..)`, and `unordered(binding, ..)`
fn parse_attribute(attribute: TokenStream) -> Result<([Expr; 3], Attribute)> {
    let mut threads = None;
    let mut found = Attribute::default();
    let parser = syn::meta::parser(|meta| {
        let flags = [
            ("fused", &mut found.fused),
            ("storage_barriers", &mut found.storage_barriers),
            ("subgroups", &mut found.subgroups),
            ("coroutines", &mut found.coroutines),
            ("z_serial", &mut found.z_serial),
            ("z_innermost", &mut found.z_innermost),
        ];
        if let Some((_, flag)) = flags.into_iter().find(|(name, _)| meta.path.is_ident(name)) {
            *flag = true;
            return Ok(());
        }
        if meta.path.is_ident("iterations") {
            found.iterations = Some(meta.value()?.parse()?);
            return Ok(());
        }
        if meta.path.is_ident("lanes") {
            found.lanes = Some(if meta.input.peek(syn::token::Paren) {
                let content;
                syn::parenthesized!(content in meta.input);
                Lanes::Invocations(content.parse()?)
            } else {
                Lanes::Inside
            });
            return Ok(());
        }
        if meta.path.is_ident("over") {
            found.over = up_to_three(&meta)?;
            return Ok(());
        }
        if meta.path.is_ident("tiles") {
            let shape = up_to_three(&meta)?.try_into();
            let wrong = "expected the sides of a product, `tiles(M, N, K)`";
            found.tiles = Some(shape.map_err(|_| meta.error(wrong))?);
            return Ok(());
        }
        if meta.path.is_ident("counts") || meta.path.is_ident("unordered") {
            let content;
            syn::parenthesized!(content in meta.input);
            let names = content.parse_terminated(Ident::parse, syn::Token![,])?;
            let list =
                if meta.path.is_ident("counts") { &mut found.counts } else { &mut found.unordered };
            list.extend(names);
            return Ok(());
        }
        if !meta.path.is_ident("threads") {
            let expected = "expected `threads(x, y, z)`, `iterations = n`, `fused`, `storage_barriers`, `subgroups`, `coroutines`, `z_serial`, `z_innermost`, `lanes`, `lanes(field)`, `tiles(m, n, k)`, `over(items, ..)`, `counts(field, ..)` or `unordered(binding, ..)`";
            return Err(meta.error(expected));
        }
        // lengths of workgroup memory are `usize`, and one constant serves both
        let mut sizes = up_to_three(&meta)?.into_iter().map(|size| match size {
            Expr::Lit(_) => size,
            size => parse_quote!(((#size) as u32)),
        });
        threads = Some([(); 3].map(|()| sizes.next().unwrap_or_else(|| parse_quote!(1))));
        Ok(())
    });
    parser.parse2(attribute.clone())?;
    let threads = threads
        .ok_or_else(|| Error::new(attribute.span(), "expected `#[kernel(threads(x, y, z))]`"))?;
    if found.z_serial && found.z_innermost {
        return Err(Error::new(
            attribute.span(),
            "workgroups run by `z_serial` or by `z_innermost`",
        ));
    }
    Ok((threads, found))
}

/// One to three sizes in parentheses.
fn up_to_three(meta: &ParseNestedMeta<'_>) -> Result<Vec<Expr>> {
    let content;
    syn::parenthesized!(content in meta.input);
    let sizes = content.parse_terminated(Expr::parse, syn::Token![,])?;
    if sizes.is_empty() || sizes.len() > 3 {
        return Err(meta.error("expected one to three sizes"));
    }
    // a macro puts what it got as an expression into a group
    let ungrouped = |mut size: Expr| {
        while let Expr::Group(of) = size {
            size = *of.expr;
        }
        size
    };
    Ok(sizes.into_iter().map(ungrouped).collect())
}

/// The name of `id: Invocation`.
fn invocation(argument: &FnArg) -> Option<Ident> {
    let FnArg::Typed(argument) = argument else { return None };
    let Pat::Ident(pattern) = &*argument.pat else { return None };
    let is_invocation = last_segment(&argument.ty).is_some_and(|s| s.ident == "Invocation");
    is_invocation.then(|| pattern.ident.clone())
}

fn last_segment(ty: &Type) -> Option<&syn::PathSegment> {
    match ty {
        Type::Path(path) => path.path.segments.last(),
        _ => None,
    }
}

/// `Samples`
fn is_samples(bound: &TypeParamBound) -> bool {
    let TypeParamBound::Trait(bound) = bound else { return false };
    bound.path.segments.last().is_some_and(|segment| segment.ident == "Samples")
}

/// The trait of `impl Trait`.
fn implemented(ty: &Type) -> Option<&PathSegment> {
    let Type::ImplTrait(ty) = ty else { return None };
    ty.bounds.iter().find_map(|bound| match bound {
        TypeParamBound::Trait(bound) => bound.path.segments.last(),
        _ => None,
    })
}

fn parse_parameter(argument: &FnArg) -> Result<Parameter> {
    let FnArg::Typed(argument) = argument else {
        return Err(Error::new(argument.span(), "a kernel is a free function"));
    };
    let Pat::Ident(pattern) = &*argument.pat else {
        return Err(Error::new(argument.pat.span(), "a binding is a plain name"));
    };
    let name = pattern.ident.clone();
    if let Type::Reference(reference) = &*argument.ty
        && matches!(&*reference.elem, Type::Slice(_) | Type::Array(_))
    {
        let message = format!("`{name}` is a buffer: its type is `Read<T>` or `Write<T>`");
        return Err(Error::new(argument.ty.span(), message));
    }
    let (role, element) = role(&argument.ty).ok_or_else(|| {
        Error::new(
            argument.ty.span(),
            "a parameter is `&Params`, `Read<T>`, `Packed<T>`, `Write<T>`, `ReadFours<T>`, `WriteFours<T>`, `Shared<T, N>` or `&mut impl SharedTile<T, N>`",
        )
    })?;
    let is_sum = matches!(role, Role::Write)
        && implemented(&element).is_some_and(|segment| segment.ident == "SumWord");
    let element = if is_sum { parse_quote!(u32) } else { element };
    let is_small = ["u8", "u16"].iter().any(|small| is_path(&element, small));
    if matches!(role, Role::Packed) && !is_small {
        let message = format!("the elements of `{name}` are `u8` or `u16`: use `Read` for others");
        return Err(Error::new(argument.ty.span(), message));
    }
    let is_buffer = matches!(role, Role::Read | Role::Write);
    if let Some(wrong) = with_another_layout(&element)
        && is_buffer
    {
        let message = format!("the elements of `{name}` are {wrong}");
        return Err(Error::new(argument.ty.span(), message));
    }
    if is_path(&element, "bool") {
        let message = format!(
            "the elements of `{name}` are `bool`, which GPUs lack in workgroup memory: use `u32`"
        );
        return Err(Error::new(argument.ty.span(), message));
    }
    let is_fours =
        |ty| last_segment(ty).is_some_and(|segment| segment.ident.to_string().ends_with("Fours"));
    let device_element = match is_fours(&argument.ty) {
        true => parse_quote!(<#element as ::muslin::memory::Fours>::Vector),
        false => element.clone(),
    };
    Ok(Parameter { name, role, element, device_element, is_sum })
}

/// Most fields of a struct of parameters: it has a slot of 256 bytes.
const MAX_FIELDS: usize = 64;

/// Refuses a struct of parameters with a field that a GPU reads in another way, or with a number of fields that a GPU can't bind.
pub fn check_params(item: &ItemStruct) -> Result<()> {
    let name = &item.ident;
    if item.fields.is_empty() {
        let message =
            format!("`{name}` has no fields: leave out the parameter of the type `&{name}`");
        return Err(Error::new(item.span(), message));
    }
    if item.fields.len() > MAX_FIELDS {
        let message = format!(
            "`{name}` has {} fields, and a kernel has at most {MAX_FIELDS} parameters: put the others into a buffer",
            item.fields.len()
        );
        return Err(Error::new(item.span(), message));
    }
    for field in &item.fields {
        let wrong = match &field.ty {
            Type::Array(_) => Some(another_layout("an array", "one field for each value")),
            ty => with_another_layout(ty).or_else(|| vector(ty)),
        };
        if let Some(wrong) = wrong {
            let name = field.ident.as_ref().map_or_else(String::new, ToString::to_string);
            let message = format!("`{name}` of `{}` is {wrong}", item.ident);
            return Err(Error::new(field.ty.span(), message));
        }
    }
    Ok(())
}

/// A type of [`WITH_ANOTHER_LAYOUT`], the reason not to use it, and what to use instead.
fn with_another_layout(ty: &Type) -> Option<String> {
    let segment = last_segment(ty)?;
    let (name, advice) = WITH_ANOTHER_LAYOUT.iter().find(|(ty, _)| segment.ident == ty)?;
    Some(another_layout(&format!("`{name}`"), advice))
}

/// A vector, which a uniform buffer aligns.
fn vector(ty: &Type) -> Option<String> {
    let name = last_segment(ty)?.ident.to_string();
    let number = match name.trim_end_matches(|end: char| end.is_ascii_digit()) {
        "Vec" => "f32",
        "UVec" => "u32",
        "IVec" => "i32",
        _ => return None,
    };
    let count = if name.ends_with('2') { "two" } else { "four" };
    let advice = format!("{count} `{number}`, and make a vector of them in the kernel");
    Some(another_layout(&format!("`{name}`"), &advice))
}

fn another_layout(ty: &str, advice: &str) -> String {
    format!("{ty}, which a GPU lays out in another way than Rust, or lacks: use {advice}")
}

fn is_path(ty: &Type, name: &str) -> bool {
    matches!(ty, Type::Path(path) if path.path.is_ident(name))
}

/// Types that no buffer has, and what has the same layout on every device. The kernel builder finds structs of them.
const WITH_ANOTHER_LAYOUT: [(&str, &str); 14] = [
    ("f64", "`f32`"),
    ("u64", "two `u32`"),
    ("i64", "two `u32`"),
    ("u8", "`Packed<u8>`, or `u32`"),
    ("u16", "`Packed<u16>`, or `u32`"),
    ("bool", "`u32`"),
    ("Vec3", "three `f32`, or `Vec4`"),
    ("Vec3A", "three `f32`, or `Vec4`"),
    ("UVec3", "three `u32`, or `UVec4`"),
    ("IVec3", "three `i32`, or `IVec4`"),
    ("Mat2", "four `f32`, or `Vec4`"),
    ("Mat3", "nine `f32`"),
    ("Mat3A", "nine `f32`"),
    ("usize", "`u32`"),
];

/// The role of a parameter's type, and the type of its elements.
fn role(ty: &Type) -> Option<(Role, Type)> {
    if let Type::Reference(reference) = ty {
        if reference.mutability.is_none() {
            return Some((Role::Uniform, (*reference.elem).clone()));
        }
        let segment =
            implemented(&reference.elem).filter(|segment| segment.ident == "SharedTile")?;
        let (element, length) = arguments(segment)?;
        return Some((Role::SharedTile(Box::new(length?)), element));
    }
    let segment = last_segment(ty)?;
    let (element, length) = arguments(segment)?;
    let role = match segment.ident.to_string().as_str() {
        "Read" | "ReadFours" => Role::Read,
        "Packed" => Role::Packed,
        "Write" | "WriteFours" => Role::Write,
        "Shared" => Role::Shared(Box::new(length?)),
        _ => return None,
    };
    Some((role, element))
}

/// `T` and N of `Name<T, N>`.
fn arguments(segment: &PathSegment) -> Option<(Type, Option<GenericArgument>)> {
    let PathArguments::AngleBracketed(generics) = &segment.arguments else { return None };
    let mut generics = generics.args.iter().filter(|a| !matches!(a, GenericArgument::Lifetime(_)));
    let Some(GenericArgument::Type(element)) = generics.next() else { return None };
    Some((element.clone(), generics.next().map(without_braces)))
}

/// A length without the braces that generic arguments need: as an array's, the compiler would warn of them.
fn without_braces(length: &GenericArgument) -> GenericArgument {
    match length {
        GenericArgument::Const(Expr::Block(block)) => match &block.block.stmts[..] {
            [Stmt::Expr(length, None)] => GenericArgument::Const(length.clone()),
            _ => GenericArgument::Const(Expr::Block(block.clone())),
        },
        _ => length.clone(),
    }
}
