//! Decides who may send requests: only pages that this server gave out.
//!
//! Any page in a browser can send requests to this machine. A request names the origin of its page (`Origin`). It
//! also names the host (`Host`): if somebody's DNS leads another name here, that name is not one of this machine.

use std::net::SocketAddr;

use hyper::header::{COOKIE, HOST, HeaderMap, ORIGIN};

/// Name of the cookie with the token.
const TOKEN: &str = "organza-token";

/// Decides who may send requests.
#[derive(Clone, Debug)]
pub struct Guard {
    /// The token that every client needs; `None` if the server only listens to this machine.
    token: Option<String>,
}

/// The decision about a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The request is answered. The answer sets a cookie if the address had the token.
    Welcome { cookie: Option<String> },
    /// The request is refused for this reason.
    Refused(&'static str),
}

impl Guard {
    /// A guard for a server at an address. If other machines can reach the address, it requires a token.
    pub fn new(address: SocketAddr) -> Self {
        let is_local = address.ip().is_loopback();
        let token = || format!("{:032x}", rand::random::<u128>());
        Self { token: (!is_local).then(token) }
    }

    /// The token that every client needs.
    pub fn token(&self) -> Option<&str> {
        self.token.as_deref()
    }

    /// Checks a request's headers, and the part of its address after the `?`.
    pub fn judge(&self, headers: &HeaderMap, query: Option<&str>) -> Verdict {
        let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
        let Some(host) = text(HOST) else { return Verdict::Refused("the request names no host") };
        if self.token.is_none() && !is_this_machine(host) {
            return Verdict::Refused("the request is for another host");
        }
        if headers.contains_key(ORIGIN) {
            let from = text(ORIGIN).and_then(|origin| origin.split_once("://"));
            if from.is_none_or(|(_, from)| from != host) {
                return Verdict::Refused("the request comes from another page");
            }
        }
        let Some(token) = &self.token else { return Verdict::Welcome { cookie: None } };
        let cookies = text(COOKIE).unwrap_or_default().split(';');
        if has(cookies, TOKEN, token) {
            return Verdict::Welcome { cookie: None };
        }
        if has(query.unwrap_or_default().split('&'), "token", token) {
            let cookie = format!("{TOKEN}={token}; HttpOnly; SameSite=Strict; Path=/");
            return Verdict::Welcome { cookie: Some(cookie) };
        }
        Verdict::Refused("the address lacks the token that the program has printed")
    }
}

/// Whether a host name belongs to this machine. The port is ignored, because forwarding changes it.
fn is_this_machine(host: &str) -> bool {
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    };
    ["localhost", "127.0.0.1", "[::1]"].contains(&name)
}

/// Whether one of the `name=value` pairs is this one. The time does not depend on the place of a difference.
fn has<'a>(mut pairs: impl Iterator<Item = &'a str>, name: &str, value: &str) -> bool {
    let is_same = |found: &str| {
        let differ = found.bytes().zip(value.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b));
        found.len() == value.len() && differ == 0
    };
    pairs.any(|pair| pair.trim().split_once('=').is_some_and(|(n, v)| n == name && is_same(v)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(pairs: &[(&'static str, &str)]) -> HeaderMap {
        let pair = |&(name, value): &(&'static str, &str)| {
            (hyper::header::HeaderName::from_static(name), value.parse().expect("a value"))
        };
        pairs.iter().map(pair).collect()
    }

    fn is_welcome(guard: &Guard, pairs: &[(&'static str, &str)]) -> bool {
        matches!(guard.judge(&headers(pairs), None), Verdict::Welcome { .. })
    }

    #[test]
    fn only_pages_of_this_machine_may_ask() {
        let guard = Guard::new("127.0.0.1:4747".parse().expect("an address"));
        assert_eq!(guard.token(), None);
        for host in ["localhost", "localhost:4747", "127.0.0.1:9", "[::1]:4747", "[::1]"] {
            assert!(is_welcome(&guard, &[("host", host)]), "{host}");
            let origin = format!("http://{host}");
            assert!(is_welcome(&guard, &[("host", host), ("origin", &origin)]), "{host}");
        }
        for host in ["example.com", "localhost.example.com:4747", "127.0.0.1.example.com", ""] {
            assert!(!is_welcome(&guard, &[("host", host)]), "{host}");
        }
        assert!(!is_welcome(&guard, &[]));
        for origin in
            ["http://example.com", "null", "http://localhost:1", "localhost:4747", "\u{e9}"]
        {
            let found = is_welcome(&guard, &[("host", "localhost:4747"), ("origin", origin)]);
            assert!(!found, "{origin}");
        }
    }

    #[test]
    fn others_need_the_token() {
        let guard = Guard::new("0.0.0.0:4747".parse().expect("an address"));
        let token = guard.token().expect("a token").to_owned();
        assert_eq!(token.len(), 32);
        let host = ("host", "machine.example:4747");
        let query = format!("a=b&token={token}");
        let welcome = guard.judge(&headers(&[host]), Some(&query));
        let Verdict::Welcome { cookie: Some(cookie) } = welcome else { panic!("{welcome:?}") };
        assert!(cookie.starts_with(&format!("organza-token={token};")), "{cookie}");
        let brought = format!("x=y; organza-token={token}");
        assert!(is_welcome(&guard, &[host, ("cookie", &brought)]));
        let from = ("origin", "http://evil.example");
        assert!(!is_welcome(&guard, &[host, ("cookie", &brought), from]));
        for wrong in ["", "token=", "token=0", &query[..query.len() - 1], "a=b"] {
            let found = guard.judge(&headers(&[host]), Some(wrong));
            assert!(matches!(found, Verdict::Refused(_)), "{wrong}: {found:?}");
        }
    }
}
