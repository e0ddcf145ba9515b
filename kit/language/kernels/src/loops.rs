//! Loops in the forms that the builder changes: each device ends them where the source does.

use muslin::prelude::*;

use crate::{CountParams, rows};

/// `output [8, count]`: what loops leave behind, of `a` and `b`, both `[count]` and below 8.
#[kernel(threads(64), over(params.count), iterations = 120)]
pub fn loops(id: Invocation, params: &CountParams, a: Read<u32>, b: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let [a, b] = [a.read(index), b.read(index)];
        rows! { output [params.count] at index;
            one_condition(a, b),
            two_conditions(a, b),
            work_before_the_end(a, b),
            a_condition_of_the_body(a, b),
            a_loop_in_a_loop(a, b),
            a_match(a, b),
            a_division(a, b),
            ranges(a, b),
        }
    }
}

#[loops]
fn one_condition(a: u32, b: u32) -> u32 {
    let mut n = 0;
    let mut sum = 7;
    while n < a {
        sum += b;
        n += 1;
    }
    sum
}

/// Each of both gives its own value for after the loop.
#[loops]
fn two_conditions(a: u32, b: u32) -> u32 {
    let mut n = 0;
    let mut sum = 7;
    while n < a && sum < 7 + 2 * b {
        sum += b;
        n += 1;
    }
    sum + 100 * n
}

#[loops]
fn work_before_the_end(a: u32, b: u32) -> u32 {
    let mut n = 0;
    let mut sum = 7;
    let mut goes_on = true;
    while goes_on {
        n += 1;
        if n >= a {
            sum += 3;
            goes_on = false;
        } else {
            sum += b;
        }
    }
    sum + 100 * n
}

#[loops]
fn a_condition_of_the_body(a: u32, b: u32) -> u32 {
    let mut n = 0;
    let mut sum = 7;
    let mut is_low = true;
    while n < a && is_low {
        sum += b;
        n += 1;
        is_low = sum < 12;
    }
    sum + 100 * n
}

#[loops]
fn a_loop_in_a_loop(a: u32, b: u32) -> u32 {
    let mut n = 0;
    let mut sum = 7;
    while n < a {
        let mut k = 0;
        while k < n && sum < 40 {
            sum += b;
            k += 1;
        }
        sum += k;
        n += 1;
    }
    sum
}

/// It ends in one case of a `match`.
#[loops]
fn a_match(a: u32, b: u32) -> u32 {
    let mut n = a % 4;
    let mut sum = 7;
    let mut goes_on = true;
    while goes_on {
        match n {
            3 => goes_on = false,
            1 => n += 2,
            _ => n += 1,
        }
        sum += b;
    }
    sum
}

/// The compiler adds a way out of the loop, for a divisor of 0.
#[loops]
fn a_division(a: u32, b: u32) -> u32 {
    let mut n = 0;
    let mut sum = 7;
    while n < a {
        sum += 60 / (b + n + 1);
        n += 1;
    }
    sum
}

#[loops]
fn ranges(a: u32, b: u32) -> u32 {
    let mut sum = 7;
    for n in (0..a).rev() {
        for k in n..b {
            sum += n + 10 * k;
        }
    }
    sum
}
