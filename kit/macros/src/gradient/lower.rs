//! From expressions to values, each with the rule of its gradient.

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Block, Error, Expr, ExprIf, Lit, Macro, Path, Result, Stmt, UnOp};

use super::reverse::{Operand, Place, Reverse, Term};

/// Functions and methods whose value stays the same around almost every number.
const FLAT: [&str; 11] = [
    "less",
    "at_most",
    "both",
    "any",
    "index",
    "floor",
    "round",
    "ceil",
    "to_u32",
    "is_finite",
    "constant",
];

/// Functions and methods of every [`Lane`], with their numbers of arguments.
const LANE: [(&str, usize); 8] = [
    ("truncate", 1),
    ("sqrt", 1),
    ("exp", 1),
    ("settled", 1),
    ("min", 2),
    ("max", 2),
    ("mul_add", 3),
    ("select", 3),
];

/// Constructors of vectors, with their fields.
const FIELDS: [&str; 4] = ["x", "y", "z", "w"];

fn term(to: &Place, gradient: TokenStream) -> Term {
    Term { to: to.clone(), is_negative: false, gradient }
}

fn minus(to: &Place, gradient: TokenStream) -> Term {
    Term { to: to.clone(), is_negative: true, gradient }
}

/// The last word of a path.
fn last(path: &Path) -> Option<&syn::Ident> {
    path.segments.last().map(|segment| &segment.ident)
}

/// Whether an expression is a comparison, or another whose derivative is 0.
fn is_flat(expression: &Expr) -> bool {
    let is_flat = |name: &syn::Ident| FLAT.iter().any(|flat| name == flat);
    match expression {
        Expr::Cast(_) => true,
        Expr::Unary(of) => matches!(of.op, UnOp::Not(_)),
        Expr::MethodCall(of) => is_flat(&of.method),
        Expr::Call(of) => {
            matches!(&*of.func, Expr::Path(path) if last(&path.path).is_some_and(is_flat))
        }
        Expr::Binary(of) => matches!(
            of.op,
            BinOp::Lt(_)
                | BinOp::Le(_)
                | BinOp::Gt(_)
                | BinOp::Ge(_)
                | BinOp::Eq(_)
                | BinOp::Ne(_)
                | BinOp::And(_)
                | BinOp::Or(_)
        ),
        _ => false,
    }
}

fn is_arithmetic(op: BinOp) -> bool {
    matches!(op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_))
}

fn is_assignment(op: BinOp) -> bool {
    matches!(
        op,
        BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_)
    )
}

/// What no gradient has, even where it does not depend on a parameter: it changes what runs.
fn refuse(expression: &Expr) -> Result<()> {
    struct Control(Option<(proc_macro2::Span, &'static str)>);
    impl<'ast> Visit<'ast> for Control {
        fn visit_expr(&mut self, expression: &'ast Expr) {
            let advice = match expression {
                Expr::While(_) | Expr::ForLoop(_) | Expr::Loop(_) => {
                    "a gradient has no loops: write the body as a function with `#[gradient]`, and the loop around its backward function"
                }
                Expr::Return(_) => {
                    "a gradient has no `return`: choose the value with `if .. else ..` or `select`"
                }
                Expr::Try(_) => "a gradient has no `?`: give it numbers alone",
                Expr::Assign(_) => {
                    "a gradient needs all values of a variable: replace the assignment by a `let`"
                }
                Expr::Binary(of) if is_assignment(of.op) => {
                    "a gradient needs all values of a variable: replace the assignment by a `let`"
                }
                _ => "",
            };
            if !advice.is_empty() && self.0.is_none() {
                self.0 = Some((expression.span(), advice));
            }
            visit::visit_expr(self, expression);
        }
        // its own function
        fn visit_expr_closure(&mut self, _: &'ast syn::ExprClosure) {}
    }
    let mut control = Control(None);
    control.visit_expr(expression);
    control.0.map_or(Ok(()), |(span, advice)| Err(Error::new(span, advice)))
}

impl Reverse {
    /// Whether an expression depends on what has a gradient.
    fn is_active(&self, expression: &Expr) -> bool {
        struct Finds<'a>(&'a Reverse, bool);
        impl<'ast> Visit<'ast> for Finds<'_> {
            fn visit_path(&mut self, path: &'ast Path) {
                self.1 |= path
                    .get_ident()
                    .is_some_and(|name| self.0.active.contains_key(&name.to_string()));
                visit::visit_path(self, path);
            }
            fn visit_macro(&mut self, of: &'ast Macro) {
                let words = of.tokens.to_string();
                let mut words = words.split(|c: char| !c.is_alphanumeric() && c != '_');
                self.1 |= words.any(|word| self.0.active.contains_key(word));
            }
        }
        let mut finds = Finds(self, false);
        finds.visit_expr(expression);
        finds.1
    }

    /// The value of a block.
    pub fn block(&mut self, block: &Block) -> Result<Operand> {
        let mut value = None;
        for (index, statement) in block.stmts.iter().enumerate() {
            match statement {
                Stmt::Local(local) => {
                    let Some(init) = &local.init else {
                        return Err(Error::new(
                            local.span(),
                            "a gradient needs the value here: `let name = value`",
                        ));
                    };
                    if let Some((_, otherwise)) = &init.diverge {
                        return Err(Error::new(
                            otherwise.span(),
                            "a gradient has no `else` here: take the value apart without it",
                        ));
                    }
                    let operand = self.expression(&init.expr)?;
                    let tokens = self.tokens(&operand);
                    self.bind(&local.pat, &tokens, operand.place())?;
                }
                Stmt::Item(item) => item.to_tokens(&mut self.forward),
                Stmt::Expr(expression, None) if index + 1 == block.stmts.len() => {
                    value = Some(self.expression(expression)?);
                }
                Stmt::Expr(expression, _) => {
                    refuse(expression)?;
                    return Err(Error::new(
                        expression.span(),
                        "a gradient has no use for a statement without a value: remove it, or name its value with `let`",
                    ));
                }
                Stmt::Macro(of) => {
                    return Err(Error::new(
                        of.span(),
                        "a gradient does not look into macros: write out what it stands for",
                    ));
                }
            }
        }
        value.ok_or_else(|| {
            Error::new(
                block.span(),
                "a gradient begins at the value: end the block with an expression",
            )
        })
    }

    /// Something without a gradient: it gets a name, if that is shorter than to compute it again.
    fn constant(&mut self, expression: &Expr) -> Operand {
        match expression {
            Expr::Lit(_) | Expr::Path(_) | Expr::Reference(_) | Expr::Closure(_) => {
                Operand::Constant(quote!(#expression))
            }
            Expr::Paren(of) => self.constant(&of.expr),
            _ => {
                let name = self.fresh("constant_");
                self.forward.extend(quote!(let #name = #expression;));
                Operand::Constant(quote!(#name))
            }
        }
    }

    /// The value of an expression.
    fn expression(&mut self, expression: &Expr) -> Result<Operand> {
        refuse(expression)?;
        if !self.is_active(expression) || is_flat(expression) {
            return Ok(self.constant(expression));
        }
        match expression {
            Expr::Paren(of) => self.expression(&of.expr),
            Expr::Group(of) => self.expression(&of.expr),
            Expr::Path(of) => {
                match of.path.get_ident().and_then(|name| self.active.get(&name.to_string())) {
                    Some(place) => Ok(Operand::Active(place.clone())),
                    None => Err(Error::new(of.span(), "a gradient does not know this path")),
                }
            }
            Expr::Field(of) => self.part(&of.base, |place| place.field(&of.member)),
            Expr::Index(of) => match &*of.index {
                Expr::Lit(syn::ExprLit { lit: Lit::Int(index), .. })
                    if !self.is_active(&of.index) =>
                {
                    let index = index.base10_parse()?;
                    self.part(&of.expr, |place| place.element(index))
                }
                index => {
                    Err(Error::new(index.span(), "a gradient takes numbers as indices: `v[0]`"))
                }
            },
            Expr::Unary(of) if matches!(of.op, UnOp::Neg(_)) => {
                let operand = self.expression(&of.expr)?;
                let tokens = self.tokens(&operand);
                let Operand::Active(place) = operand else { return Ok(self.constant(expression)) };
                Ok(self.value(
                    &quote!(-#tokens),
                    Box::new(move |d| (quote!(), vec![minus(&place, d.clone())])),
                ))
            }
            Expr::Binary(of) if is_arithmetic(of.op) => self.binary(&of.left, of.op, &of.right),
            Expr::Call(of) => self.call(&of.func, of.args.iter()),
            Expr::MethodCall(of) => self.method(of),
            Expr::Struct(of) => self.literal(of),
            Expr::Tuple(of) => self.several(
                of.elems.iter(),
                |values| quote!((#(#values,)*)),
                |index| {
                    let index = syn::Index::from(index);
                    quote!(.#index)
                },
            ),
            Expr::Array(of) => self.several(
                of.elems.iter(),
                |values| quote!([#(#values),*]),
                |index| {
                    let index = syn::Index::from(index);
                    quote!([#index])
                },
            ),
            Expr::Block(of) if of.label.is_none() => self.block(&of.block),
            Expr::If(of) => self.branches(of),
            Expr::Reference(of) => {
                Err(Error::new(of.span(), "a reference has no gradient: pass the value itself"))
            }
            Expr::Match(of) => Err(Error::new(
                of.match_token.span(),
                "a gradient has no `match`: use `if .. else ..`",
            )),
            Expr::Closure(of) => Err(Error::new(
                of.span(),
                "a closure has no gradient: write it as a function with `#[gradient]`",
            )),
            other => Err(Error::new(
                other.span(),
                "a gradient has arithmetic, fields, structs, tuples, arrays, `if .. else ..`, and calls of functions with a gradient: write this with those",
            )),
        }
    }

    /// A field or an element of an expression.
    fn part(&mut self, base: &Expr, part: impl FnOnce(&Place) -> Place) -> Result<Operand> {
        let base = self.expression(base)?;
        Ok(match base {
            Operand::Active(place) => Operand::Active(part(&place)),
            constant => constant,
        })
    }

    fn binary(&mut self, left: &Expr, op: BinOp, right: &Expr) -> Result<Operand> {
        let (left, right) = (self.expression(left)?, self.expression(right)?);
        let (a, b) = (self.tokens(&left), self.tokens(&right));
        let (left, right) = (left.place(), right.place());
        let product = quote!(::muslin::gradient::Product);
        let is_one = a.to_string() == "1.0";
        let (name, by_left) = (self.next(), self.fresh("quotient_"));
        let value = quote!(#a #op #b);
        Ok(self.value(
            &value,
            Box::new(move |d| {
                let (left, right) = (left.as_ref(), right.as_ref());
                let mut terms = Vec::new();
                let mut statements = quote!();
                match op {
                    BinOp::Add(_) => terms.extend(
                        [left, right].into_iter().flatten().map(|place| term(place, d.clone())),
                    ),
                    BinOp::Sub(_) => {
                        terms.extend(left.map(|place| term(place, d.clone())));
                        terms.extend(right.map(|place| minus(place, d.clone())));
                    }
                    BinOp::Mul(_) => {
                        terms.extend(
                            left.map(|place| term(place, quote!(#product::by_left(#a, #b, #d)))),
                        );
                        terms.extend(
                            right.map(|place| term(place, quote!(#product::by_right(#a, #b, #d)))),
                        );
                    }
                    // of q = 1 / b it is -d q q: no second division
                    _ if is_one => {
                        terms.extend(right.map(|place| minus(place, quote!(#d * #name * #name))))
                    }
                    // of q = a / b: a = q b
                    _ => {
                        statements = quote!(let #by_left = #d / #b;);
                        terms.extend(left.map(|place| term(place, by_left.clone())));
                        let by_right = quote!(#product::by_right(#name, #b, #by_left));
                        terms.extend(right.map(|place| minus(place, by_right)));
                    }
                }
                (statements, terms)
            }),
        ))
    }

    /// Values next to each other, such as a tuple's.
    fn several<'a>(
        &mut self,
        values: impl Iterator<Item = &'a Expr>,
        whole: impl FnOnce(Vec<TokenStream>) -> TokenStream,
        part: impl Fn(usize) -> TokenStream,
    ) -> Result<Operand> {
        let operands = values.map(|value| self.expression(value)).collect::<Result<Vec<_>>>()?;
        let tokens = operands.iter().map(|operand| self.tokens(operand)).collect();
        let parts = operands.into_iter().enumerate();
        let parts: Vec<_> =
            parts.filter_map(|(index, operand)| Some((operand.place()?, part(index)))).collect();
        Ok(self.parts(&whole(tokens), parts))
    }

    /// A value whose parts are others.
    fn parts(&mut self, whole: &TokenStream, parts: Vec<(Place, TokenStream)>) -> Operand {
        self.value(
            whole,
            Box::new(move |d| {
                let terms = parts.iter().map(|(place, part)| term(place, quote!(#d #part)));
                (quote!(), terms.collect())
            }),
        )
    }

    fn literal(&mut self, of: &syn::ExprStruct) -> Result<Operand> {
        if let Some(rest) = &of.rest {
            return Err(Error::new(rest.span(), "a gradient needs every field: write them out"));
        }
        let (mut fields, mut parts) = (Vec::new(), Vec::new());
        for field in &of.fields {
            let (member, operand) = (&field.member, self.expression(&field.expr)?);
            let value = self.tokens(&operand);
            fields.push(quote!(#member: #value));
            parts.extend(operand.place().map(|place| (place, quote!(.#member))));
        }
        let path = &of.path;
        Ok(self.parts(&quote!(#path { #(#fields),* }), parts))
    }

    /// `f(..)`: a vector, a struct without names, a function of every lane, or one that has a backward function beside it.
    fn call<'a>(
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
    fn method(&mut self, of: &syn::ExprMethodCall) -> Result<Operand> {
        let (name, turbofish) = (&of.method, &of.turbofish);
        let arguments = std::iter::once(&*of.receiver).chain(&of.args);
        let operands =
            arguments.map(|argument| self.expression(argument)).collect::<Result<Vec<_>>>()?;
        let call = |values: &[TokenStream]| {
            let (receiver, values) = (&values[0], &values[1..]);
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
                let (receiver, values) = (&values[0], &values[1..]);
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
    fn called(
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
    fn branches(&mut self, of: &ExprIf) -> Result<Operand> {
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
        let (yes_gradients, no_gradients) = (gradients(&yes.1), gradients(&no.1));
        let (yes, no, then) = (yes.0, no.0, &of.then_branch);
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
