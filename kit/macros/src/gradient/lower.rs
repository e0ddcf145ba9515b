//! From expressions to values, each with the rule of its gradient.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Block, Error, Expr, Lit, Macro, Path, Result, Stmt, UnOp};

use super::reverse::{Operand, Place, Reverse, Term};

/// Functions and methods whose value stays the same around almost every number.
const FLAT: [&str; 11] = [
    "less",
    "less_equal",
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
pub const LANE: [(&str, usize); 8] = [
    ("truncate", 1),
    ("sqrt", 1),
    ("exp", 1),
    ("materialize", 1),
    ("min", 2),
    ("max", 2),
    ("mul_add", 3),
    ("select", 3),
];

/// Constructors of vectors, with their fields.
pub const FIELDS: [&str; 4] = ["x", "y", "z", "w"];

pub fn term(to: &Place, gradient: TokenStream) -> Term {
    Term { to: to.clone(), is_negative: false, gradient }
}

fn minus(to: &Place, gradient: TokenStream) -> Term {
    Term { to: to.clone(), is_negative: true, gradient }
}

/// The last word of a path.
pub fn last(path: &Path) -> Option<&syn::Ident> {
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

/// Constructs without a gradient, even where it does not depend on a parameter: it changes what runs.
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
    pub fn is_active(&self, expression: &Expr) -> bool {
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
    pub fn constant(&mut self, expression: &Expr) -> Operand {
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
    pub fn expression(&mut self, expression: &Expr) -> Result<Operand> {
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
    pub fn part(&mut self, base: &Expr, part: impl FnOnce(&Place) -> Place) -> Result<Operand> {
        let base = self.expression(base)?;
        Ok(match base {
            Operand::Active(place) => Operand::Active(part(&place)),
            constant => constant,
        })
    }

    pub fn binary(&mut self, left: &Expr, op: BinOp, right: &Expr) -> Result<Operand> {
        let left = self.expression(left)?;
        let right = self.expression(right)?;
        let a = self.tokens(&left);
        let b = self.tokens(&right);
        let left = left.place();
        let right = right.place();
        let product = quote!(::muslin::gradient::Product);
        let is_one = a.to_string() == "1.0";
        let name = self.next();
        let by_left = self.fresh("quotient_");
        let value = quote!(#a #op #b);
        Ok(self.value(
            &value,
            Box::new(move |d| {
                let left = left.as_ref();
                let right = right.as_ref();
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
    pub fn several<'a>(
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
    pub fn parts(&mut self, whole: &TokenStream, parts: Vec<(Place, TokenStream)>) -> Operand {
        self.value(
            whole,
            Box::new(move |d| {
                let terms = parts.iter().map(|(place, part)| term(place, quote!(#d #part)));
                (quote!(), terms.collect())
            }),
        )
    }

    pub fn literal(&mut self, of: &syn::ExprStruct) -> Result<Operand> {
        if let Some(rest) = &of.rest {
            return Err(Error::new(rest.span(), "a gradient needs every field: write them out"));
        }
        let mut fields = Vec::new();
        let mut parts = Vec::new();
        for field in &of.fields {
            let member = &field.member;
            let operand = self.expression(&field.expr)?;
            let value = self.tokens(&operand);
            fields.push(quote!(#member: #value));
            parts.extend(operand.place().map(|place| (place, quote!(.#member))));
        }
        let path = &of.path;
        Ok(self.parts(&quote!(#path { #(#fields),* }), parts))
    }
}
