//! Decides who may send requests: only pages that this server gave out.
//!
//! Any page in a browser can send requests to this machine. A request names the origin of its page (`Origin`). It
//! also names the host (`Host`): if DNS leads another name here, that name is not one of this machine.

use std::net::SocketAddr;

use hyper::header::{COOKIE, HOST, HeaderMap, ORIGIN};

/// Decides who may send requests.
#[derive(Clone, Debug)]
pub struct Guard {
    /// The token that every client needs. Other users of this machine can reach the server, too.
    pub token: String,
    /// Whether the server only listens to this machine.
    is_local: bool,
}

/// The decision about a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Access {
    /// The request is answered. The answer sets a cookie if the address had the token.
    Allowed { cookie: Option<String> },
    /// The request is refused for this reason.
    Refused(&'static str),
}

impl Guard {
    /// A guard for a server at an address.
    pub fn new(address: SocketAddr) -> Self {
        let token = format!("{:032x}", rand::random::<u128>());
        Self { token, is_local: address.ip().is_loopback() }
    }

    /// Checks a request's headers, and the part of its address after the `?`.
    pub fn judge(&self, headers: &HeaderMap, query: Option<&str>) -> Access {
        let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
        let Some(host) = text(HOST) else { return Access::Refused("the request names no host") };
        let (machine, port) = name_and_port(host);
        if self.is_local && !["localhost", "127.0.0.1", "[::1]"].contains(&machine) {
            return Access::Refused("the request is for another host");
        }
        if headers.contains_key(ORIGIN) {
            let from = text(ORIGIN).and_then(|origin| origin.split_once("://"));
            if from.is_none_or(|(_, from)| from != host) {
                return Access::Refused("the request comes from another page");
            }
        }
        let token = &self.token;
        // a browser sends a cookie to every port of a host, so each port has its own name
        let name = format!("organza-token-{port}");
        let cookies = text(COOKIE).unwrap_or_default().split(';');
        if has(cookies, &name, token) {
            return Access::Allowed { cookie: None };
        }
        if has(query.unwrap_or_default().split('&'), "token", token) {
            let cookie = format!("{name}={token}; HttpOnly; SameSite=Strict; Path=/");
            return Access::Allowed { cookie: Some(cookie) };
        }
        Access::Refused("the address lacks the token that the program has printed")
    }
}

/// The name and the port of a `Host` header. Forwarding may have changed the port.
fn name_and_port(host: &str) -> (&str, &str) {
    match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => (name, port),
        _ => (host, "80"),
    }
}

/// Whether one of the `name=value` pairs is this one. The time does not depend on the place of a difference.
fn has<'a>(mut pairs: impl Iterator<Item = &'a str>, name: &str, value: &str) -> bool {
    let is_same = |found: &str| {
        let differ = found.bytes().zip(value.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b));
        found.len() == value.len() && differ == 0
    };
    pairs.any(|pair| pair.trim().split_once('=').is_some_and(|(n, v)| n == name && is_same(v)))
}
