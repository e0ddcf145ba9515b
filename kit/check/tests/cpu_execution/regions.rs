//! Kernels with barriers, of every form. Each gives what ordinary loops give: cut into regions as devices run it, watched or not and in
//! several orders, as a unit test calls it, and as coroutines.

use muslin::kernel::{CpuRun, KernelInfo, kernels_of};
use muslin::prelude::*;
use muslin::workgroup::{SharedMemory, Workgroup};
use muslin_device::{Buffer, Device, DeviceOptions, Modules};

use crate::{assert_contains, failure, line};

/// Parameters of all kernels here.
#[params]
pub struct Form {
    /// Rounds of loops.
    pub rounds: u32,
    /// Chooses branches.
    pub branch: u32,
}

/// Workgroups that run.
const WORKGROUPS: u32 = 3;

/// The values of a workgroup.
type Values = [u32; 64];

/// A kernel, and what it is compared with.
struct Case {
    name: &'static str,
    /// Whether it is cut into regions.
    is_cut: bool,
    run: fn(&Device, Form, &Buffer<u32>, &Buffer<u32>) -> muslin_device::Result<()>,
    call: fn(Invocation, &Form, Read<u32>, Write<u32>, Shared<u32, 64>),
    size: [u32; 3],
    /// What the workgroup of a number makes of its values.
    expected: fn(&Form, u32, Values) -> Values,
}

/// Declares kernels with the same parameters, which have these names.
macro_rules! forms {
    ($list:ident, $is_cut:literal: |$id:ident, $params:ident, $input:ident, $output:ident, $values:ident|
    $($name:ident $kernel:ident [$x:literal, $y:literal, $z:literal $($says:ident)?] $body:tt is $expected:expr;)*) => {
        $(
            #[doc = "Is compared with ordinary loops."]
            #[allow(unused_variables, clippy::all, reason = "forms that people write")]
            #[kernel(threads($x, $y, $z), iterations = 300 $(, $says)?)]
            pub fn $name(
                $id: Invocation,
                $params: &Form,
                $input: Read<u32>,
                $output: Write<u32>,
                $values: Shared<u32, 64>,
            ) $body
        )*
        const $list: &[Case] = &[$(Case {
            name: stringify!($name),
            is_cut: $is_cut,
            run: |device, params, input, output| {
                device.run_over(&$kernel { params, input, output }, [$x * WORKGROUPS, $y, 1])
            },
            call: $name,
            size: [$x, $y, $z],
            expected: $expected,
        }),*];
    };
}

/// The place of an invocation's value in a buffer.
fn place(id: Invocation) -> u32 {
    id.workgroup.x * 64 + id.local_index()
}

/// What is not `Copy`.
struct Counter {
    count: u32,
}

impl Counter {
    fn next(&mut self, by: u32) -> u32 {
        self.count += by;
        self.count
    }

    fn place(&mut self) -> &mut u32 {
        &mut self.count
    }
}

/// Moves a counter away.
fn used_up(counter: Counter) -> u32 {
    counter.count
}

/// A pair.
#[derive(Clone, Copy)]
struct Pair {
    low: u32,
    high: u32,
}

/// Waits in a helper.
fn reversed(id: Invocation, values: Shared<u32, 64>, own: u32) -> u32 {
    values.write(id.local.x, own);
    id.barrier();
    values.read(63 - id.local.x)
}

/// The sums of all values up to each.
fn prefix(values: Values) -> Values {
    let mut sum = 0;
    values.map(|value| {
        sum += value;
        sum
    })
}

/// Each value is another's.
fn moved(values: Values, from: impl Fn(usize) -> usize) -> Values {
    core::array::from_fn(|at| values[from(at)])
}

forms! { CUT, true: |id, params, input, output, values|
    halving HalvingKernel [64, 1, 1] {
        let at = id.local.x;
        let index = id.workgroup.x * 64 + at;
        values.write(at, input.read(index));
        id.barrier();
        let mut half = 32;
        while half > 0 {
            if at < half {
                values.write(at, values.read(at) + values.read(at + half));
            }
            id.barrier();
            half /= 2;
        }
        output.write(index, values.read(0));
    } is |_, _, values| [values.iter().sum(); 64];

    halving_the_other_way HalvingTheOtherWayKernel [64, 1, 1] {
        let at = id.local_index();
        values.write(at, input.read(id.index()));
        let mut half = 64u32;
        while 1 < half {
            half /= 2;
            id.barrier();
            if half > at && at + half < 64 {
                let other = values.read(at + half);
                values.write(at, values.read(at) + other);
            }
        }
        id.barrier();
        output.write(id.index(), values.read(0));
    } is |_, _, values| [values.iter().sum(); 64];

    scanning ScanningKernel [64, 1, 1] {
        let thread = id.local.x;
        let own = input.read(id.index());
        let mut inclusive = own;
        values.write(thread, inclusive);
        id.barrier();
        let mut step = 1;
        while step < 64 {
            if thread >= step {
                inclusive += values.read(thread - step);
            }
            id.barrier();
            values.write(thread, inclusive);
            id.barrier();
            step *= 2;
        }
        let before = inclusive - own;
        output.write(id.index(), before + own);
    } is |_, _, values| prefix(values);

    barriers_at_both_ends BarriersAtBothEndsKernel [64, 1, 1] {
        id.barrier();
        values.write(id.local.x, input.read(id.index()));
        id.barrier();
        id.barrier();
        output.write(id.index(), values.read(id.local.x ^ 5));
        id.barrier();
    } is |_, _, values| moved(values, |at| at ^ 5);

    nested_loops NestedLoopsKernel [64, 1, 1] {
        const TURNS: u32 = 2;
        let at = id.local.x;
        let mut own = input.read(id.index());
        for round in 0..params.rounds {
            let shift = round + 1;
            for turn in (0..TURNS).rev() {
                id.barrier();
                values.write(at, own);
                let mut inner = 0;
                while inner < turn {
                    inner += 1;
                    if inner == 7 {
                        break;
                    }
                }
                id.barrier();
                own = (own * 3 + values.read((at + shift) % 64) + inner) % 5000;
            }
        }
        output.write(id.index(), own);
    } is |params, _, mut values| {
        for round in 0..params.rounds as usize {
            for turn in [1, 0] {
                let before = values;
                values = core::array::from_fn(|at| (before[at] * 3 + before[(at + round + 1) % 64] + turn) % 5000);
            }
        }
        values
    };

    branches BranchesKernel [64, 1, 1] {
        let at = id.local.x;
        let mut own = input.read(id.index());
        let steps = if params.branch > 1 { 2 } else { 1 };
        if params.branch == 0 {
            own += 1;
        } else if params.branch == 1 {
            values.write(at, own);
            id.barrier();
            own = values.read(63 - at);
        } else {
            let twice = own * 2;
            values.write(at, twice);
            if steps == 2 {
                id.barrier();
                own += values.read(at ^ 1);
            }
            own += twice;
        }
        {
            let more = own + at;
            id.barrier();
            own = more - at + steps;
        }
        output.write(id.index(), own);
    } is |params, _, values| core::array::from_fn(|at| match params.branch {
        0 => values[at] + 2,
        1 => values[63 - at] + 1,
        _ => values[at] * 3 + 2 * values[at ^ 1] + 2,
    });

    votes VotesKernel [64, 1, 1] {
        let at = id.local.x;
        if at == 9 {
            values.write(0, params.rounds + 1);
        }
        id.barrier();
        let mut turns = values.read(0);
        let mut sum = input.read(id.index());
        while turns > 0 {
            id.barrier();
            sum += turns;
            turns -= 1;
        }
        for place in at..at + 3 {
            id.barrier();
            values.write(at, place);
            id.barrier();
            sum += values.read((at + 1) % 64);
        }
        for (i, _) in [(0u32, 1u32); 2].iter().enumerate() {
            sum += i as u32;
        }
        if values.read(at) != 1000 {
            id.barrier();
            sum += 1;
        } else if at > 0 {
            id.barrier();
        }
        output.write(id.index(), sum);
    } is |params, _, values| core::array::from_fn(|at| {
        let turns = (1..=params.rounds + 1).sum::<u32>();
        values[at] + turns + 3 * ((at as u32 + 1) % 64) + 3 + 1 + 1
    });

    patterns PatternsKernel [64, 1, 1] {
        let at = id.local.x;
        let own = input.read(id.index());
        let (low, mut high) = (own & 0xff, own >> 8);
        let Pair { low: first, high: mut second } = Pair { low: at, high: 2 * at };
        let [x, .., z] = [own, 1, 2];
        let mut rows = [0u32; 4];
        let mut counter = Counter { count: own };
        let pair = Pair { low: 1, high };
        let mut maybe = None;
        id.barrier();
        high += 1;
        second += first;
        rows[(at % 4) as usize] += z;
        let next = counter.next(3);
        maybe = if at % 2 == 0 { Some(next) } else { maybe };
        id.barrier();
        rows[(at % 4) as usize] += low + high + second + x + pair.low + pair.high;
        let (_, last) = (counter.next(1), counter);
        id.barrier();
        let mut sum = 0;
        for row in rows {
            sum += row;
        }
        output.write(id.index(), sum + last.count + maybe.map_or(0, |x| x));
    } is |_, _, values| core::array::from_fn(|at| {
        let (own, place) = (values[at], at as u32);
        let maybe = if place % 2 == 0 { own + 3 } else { 0 };
        2 + (own & 0xff) + (own >> 8) + 1 + 3 * place + own + 1 + (own >> 8) + own + 4 + maybe
    });

    shadows ShadowsKernel [64, 1, 1] {
        let own = input.read(id.index());
        let x = own + 1;
        let x = x * 2;
        id.barrier();
        let y = { let x = x + 1; x };
        let x = x + y;
        id.barrier();
        {
            let x = x % 1000;
            id.barrier();
            values.write(id.local.x, x);
        }
        let input = x + values.read(id.local.x);
        id.barrier();
        output.write(id.index(), input);
    } is |_, _, values| values.map(|own| {
        let x = (own + 1) * 4 + 1;
        x + x % 1000
    });

    returns ReturnsKernel [64, 1, 1] {
        let at = id.local.x;
        values.write(at, input.read(id.index()));
        if params.branch < 9 {
            id.barrier();
            let found = values.read(63 - at);
            output.write(id.index(), found);
            if at % 2 == 0 {
                return;
            }
            for i in 0..3 {
                if i == 2 {
                    output.write(id.index(), found + 1);
                    return;
                }
            }
            output.write(id.index(), 0);
        }
    } is |_, _, values| core::array::from_fn(|at| values[63 - at] + at as u32 % 2);

    boxes BoxesKernel [8, 4, 2] {
        let at = id.local_index();
        let row = id.local.y * 8 + id.local.x;
        let index = id.workgroup.x * 64 + at;
        values.write(at, input.read(index));
        id.barrier();
        if at < 40 {
            values.atomic_add(at, 1);
        }
        id.barrier();
        if id.local.x == 3 {
            values.atomic_add(at, 10);
        }
        id.barrier();
        output.write(index, values.read(32 * (1 - id.local.z) + 31 - row));
    } is |_, _, values| core::array::from_fn(|at| {
        let from = 32 * (1 - at / 32) + 31 - at % 32;
        values[from] + u32::from(from < 40) + 10 * u32::from(from % 8 == 3)
    });

    parts_of_a_workgroup PartsOfAWorkgroupKernel [64, 1, 1] {
        let at = id.local.x;
        values.write(at, input.read(id.index()));
        id.barrier();
        if at >= 60 { values.atomic_add(at, 1); }
        id.barrier();
        if at > 62 { values.atomic_add(at, 2); }
        id.barrier();
        if at <= params.rounds { values.atomic_add(at, 4); }
        id.barrier();
        if at == 63 && params.rounds < 100 { values.atomic_add(at, 8); }
        id.barrier();
        if 2 > at { values.atomic_add(at, 16); }
        id.barrier();
        if 2 >= at { values.atomic_add(at, 32); }
        id.barrier();
        if at == 64 + params.rounds { values.atomic_add(0, 1000); }
        id.barrier();
        if u32::MAX == id.local.x { values.atomic_add(0, 1000); }
        id.barrier();
        if at < 70 { values.atomic_add(at, 64); } else { values.write(0, 0); }
        id.barrier();
        if at as i32 - 3 < 0 { values.atomic_add(at, 128); }
        id.barrier();
        output.write(id.index(), values.read(at));
    } is |params, _, values| core::array::from_fn(|i| {
        let at = i as u32;
        let tests = [
            (at >= 60, 1), (at > 62, 2), (at <= params.rounds, 4), (at == 63, 8), (at < 2, 16), (at <= 2, 32), (true, 64), (at < 3, 128),
        ];
        values[i] + tests.iter().map(|(test, add)| u32::from(*test) * add).sum::<u32>()
    });

    rounds_of_memory RoundsOfMemoryKernel [64, 1, 1] {
        let at = id.local.x;
        let mut sum = 0u32;
        let mut first = 0;
        while first < params.rounds * 16 {
            let part = first / 16;
            if at < 16 {
                values.write(at, input.read(id.workgroup.x * 64 + (part * 16 + at) % 64));
            }
            id.barrier();
            let mut i = 0usize;
            'all: loop {
                let mut j = 0;
                while j < 4 {
                    if i == 16 {
                        break 'all;
                    }
                    sum = sum.wrapping_add(values.read(i as u32) * (part + 1));
                    i += 1;
                    j += 1;
                }
            }
            id.barrier();
            values.begin_round();
            first += 16;
        }
        output.write(id.index(), sum);
    } is |params, _, values| {
        let sum = (0..params.rounds).fold(0u32, |sum, part| {
            let begin = (part as usize * 16) % 64;
            values[begin..begin + 16].iter().fold(sum, |sum, value| sum.wrapping_add(value * (part + 1)))
        });
        [sum; 64]
    };

    closures_and_macros ClosuresAndMacrosKernel [64, 1, 1] {
        fn double(x: u32) -> u32 {
            2 * x
        }
        let at = id.local.x;
        let own = input.read(id.index());
        let is_odd = matches!(own % 2, 1);
        debug_assert!(at < 64, "invocation {at} of {}", id.local.x);
        id.barrier();
        let add = |x: u32| {
            if !is_odd {
                return double(x);
            }
            x + own
        };
        values.write(at, add(at));
        id.barrier();
        let place = at as usize;
        let found = [1, 0][place % 2] + place as u32 - at % 2;
        output.write(id.index(), values.read(found) + (is_odd as u32));
    } is |_, _, values| core::array::from_fn(|at| {
        let from = at ^ 1;
        let value = if values[from] % 2 == 1 { from as u32 + values[from] } else { 2 * from as u32 };
        value + values[at] % 2
    });

    moves_away MovesAwayKernel [64, 1, 1] {
        let mut counter = Counter { count: input.read(id.index()) };
        for _ in 0..params.rounds {
            id.barrier();
            let total = used_up(counter);
            values.write(id.local.x, total);
            id.barrier();
            counter = Counter { count: total + 1 };
            id.barrier();
        }
        output.write(id.index(), counter.next(values.read(63 - id.local.x)));
    } is |params, _, values| core::array::from_fn(|at| values[at] + values[63 - at] + 2 * params.rounds - 1);

    calls_a_variable CallsAVariableKernel [64, 1, 1] {
        fn counter(from: u32) -> impl FnMut() -> u32 {
            let mut count = from;
            move || {
                count += 1;
                count
            }
        }
        let mut next = counter(input.read(id.index()));
        id.barrier();
        next();
        id.barrier();
        output.write(id.index(), next());
    } is |_, _, values| values.map(|value| value + 2);

    no_barrier NoBarrierKernel [64, 1, 1] {
        values.write(id.local.x, input.read(id.index()));
        if values.read(id.local.x) % 3 == 0 {
            return;
        }
        output.write(id.index(), values.read(id.local.x));
    } is |_, _, values| values.map(|value| if value % 3 == 0 { 77 } else { value });
}

forms! { KEPT, false: |id, params, input, output, values|
    waits_in_a_helper WaitsInAHelperKernel [64, 1, 1] {
        output.write(id.index(), reversed(id, values, input.read(id.index())));
    } is |_, _, values| moved(values, |at| 63 - at);

    passes_itself_on PassesItselfOnKernel [64, 1, 1] {
        values.write(id.local.x, input.read(place(id)));
        id.barrier();
        output.write(place(id), values.read(id.local.x));
    } is |_, _, values| values;

    waits_in_a_match WaitsInAMatchKernel [64, 1, 1] {
        let own = input.read(id.index());
        match params.branch {
            0 => output.write(id.index(), own),
            _ => {
                values.write(id.local.x, own);
                id.barrier();
                output.write(id.index(), values.read(63 - id.local.x));
            }
        }
    } is |params, _, values| moved(values, |at| if params.branch == 0 { at } else { 63 - at });

    returns_before ReturnsBeforeKernel [64, 1, 1] {
        output.write(id.index(), input.read(id.index()));
        if params.branch == 1 {
            return;
        }
        id.barrier();
        output.write(id.index(), 2 * input.read(id.index()));
    } is |params, _, values| values.map(|value| if params.branch == 1 { value } else { 2 * value });

    breaks BreaksKernel [64, 1, 1] {
        let mut sum = input.read(id.index());
        let mut i = 0;
        while i < 10 {
            if i == params.rounds {
                break;
            }
            id.barrier();
            i += 1;
        }
        sum += i;
        output.write(id.index(), sum);
    } is |params, _, values| values.map(|value| value + params.rounds.min(10));

    waits_in_a_value WaitsInAValueKernel [64, 1, 1] {
        let own = if params.branch == 0 { 1 } else { id.barrier(); 2 };
        output.write(id.index(), own + input.read(id.index()));
    } is |params, _, values| values.map(|value| value + params.branch.min(1) + 1);

    borrows BorrowsKernel [64, 1, 1] {
        let mut state = input.read(id.index());
        let all = [state, 2, 3];
        let reference = &mut state;
        let slice = all.as_slice();
        id.barrier();
        *reference += slice[1];
        output.write(id.index(), state);
    } is |_, _, values| values.map(|value| value + 2);

    borrows_by_a_method BorrowsByAMethodKernel [64, 1, 1 coroutines] {
        let mut counter = Counter { count: input.read(id.index()) };
        let count = counter.place();
        id.barrier();
        *count += 1;
        output.write(id.index(), counter.count);
    } is |_, _, values| values.map(|value| value + 1);

    captures CapturesKernel [64, 1, 1] {
        let own = input.read(id.index());
        let add = |x: u32| x + own;
        id.barrier();
        output.write(id.index(), add(1));
    } is |_, _, values| values.map(|value| value + 1);

    declares_before DeclaresBeforeKernel [64, 1, 1] {
        let own;
        id.barrier();
        own = input.read(id.index());
        id.barrier();
        output.write(id.index(), own);
    } is |_, _, values| values;

    hides HidesKernel [64, 1, 1] {
        let mut x = input.read(id.index());
        for _ in 0..2 {
            x += 1;
            let x = x * 2;
            id.barrier();
            values.write(id.local.x, x);
        }
        id.barrier();
        output.write(id.index(), x + values.read(id.local.x));
    } is |_, _, values| values.map(|value| 3 * (value + 2));

    loops_apart LoopsApartKernel [64, 1, 1] {
        let at = id.local.x;
        let mut sum = input.read(id.index());
        for round in 0..3 + at % 2 {
            if round < 3 {
                id.barrier();
            }
            sum += round;
        }
        output.write(id.index(), sum);
    } is |_, _, values| core::array::from_fn(|at| values[at] + 3 + 3 * (at as u32 % 2));

    runs_over_an_array RunsOverAnArrayKernel [64, 1, 1] {
        let mut sum = input.read(id.index());
        for step in [1, 2, 4] {
            id.barrier();
            sum += step;
        }
        output.write(id.index(), sum);
    } is |_, _, values| values.map(|value| value + 7);
}

/// What invocations that write nothing leave.
const BEFORE: u32 = 77;

/// The values that kernels get.
fn given() -> Vec<u32> {
    (0..64 * WORKGROUPS).map(|i| (i * 7919 + i / 3) % 5000).collect()
}

/// Plain, checked and thorough. The kernels do not test their index, so no additional workgroup runs.
fn devices() -> [Device; 3] {
    [DeviceOptions::cpu(2), DeviceOptions::checked(), DeviceOptions::thorough(3)].map(|options| {
        Device::open(&options.extra_workgroup(false), Modules::none()).expect("the CPU")
    })
}

/// All workgroups, called as functions: together, or apart, because each invocation has parameters of its own.
fn called(case: &Case, params: &Form, input: &[u32], is_apart: bool) -> Vec<u32> {
    let mut output = vec![BEFORE; input.len()];
    let view = Write::from(&mut output[..]);
    for place in 0..WORKGROUPS {
        let values = SharedMemory::new();
        let workgroup = Workgroup::new(case.size).at([place, 0, 0], [WORKGROUPS, 1, 1]);
        workgroup.run(|id| {
            let own = *params;
            let params = if is_apart { &own } else { params };
            (case.call)(id, params, Read::from(input), view, values.view());
        });
    }
    output
}

#[test]
fn regions_give_what_loops_and_coroutines_give() {
    let input = given();
    let devices = devices();
    for case in CUT.iter().chain(KEPT) {
        let kernel = kernels_of(env!("CARGO_PKG_NAME")).find(|kernel| kernel.name == case.name);
        let KernelInfo { run, coroutines, .. } = kernel.unwrap();
        assert_eq!(matches!(run, CpuRun::Regions(..)), case.is_cut, "{}", case.name);
        assert_eq!(coroutines.is_none(), case.is_cut, "{}", case.name);
        for params in [0, 1, 2].map(|branch| Form { rounds: 3 + branch, branch }) {
            let workgroups = input.as_chunks::<64>().0.iter().zip(0..);
            let expected =
                workgroups.flat_map(|(all, place)| (case.expected)(&params, place, *all));
            let expected: Vec<_> = expected.collect();
            for is_apart in [false, true] {
                let found = called(case, &params, &input, is_apart);
                assert_eq!(found, expected, "{} as a function", case.name);
            }
            for device in &devices {
                let input = device.upload("input", &input).unwrap();
                let output = device.upload("output", &vec![BEFORE; 64 * WORKGROUPS as usize]);
                let output = output.unwrap();
                (case.run)(device, params, &input, &output).unwrap();
                assert_eq!(device.read(&output).unwrap(), expected, "{}: {params:?}", case.name);
            }
        }
    }
}

#[test]
fn a_test_calls_kernels_before_and_after_other_code() {
    let given = given();
    let both_inputs = Read::from(&given[..128]);
    let input = Read::from(&given[..64]);
    let params = Form { rounds: 3, branch: 1 };
    let [mut low, mut high, mut both] = [[BEFORE; 64]; 3];
    let [lows, highs, totals] =
        [&mut low, &mut high, &mut both].map(|all| Write::from(&mut all[..]));
    let [first, second, third, fourth] = [(); 4].map(|()| SharedMemory::new());
    let mut elsewhere = [BEFORE; 128];
    let elsewheres = Write::from(&mut elsewhere[..]);
    Workgroup::new([64, 1, 1]).run(|id| {
        let at = id.local.x;
        totals.write(at, 1000);
        // all the same, and then one that differs
        barriers_at_both_ends(id, &params, input, lows, first.view());
        totals.write(at, totals.read(at) + lows.read(63 - at));
        let own = if at % 3 == 0 { lows } else { highs };
        scanning(id, &params, input, own, second.view());
        if at < 64 {
            halving(id, &params, input, totals, third.view());
        }
        totals.write(at, totals.read(at) + own.read(at));
        // in the place of another workgroup
        let id = Invocation { workgroup: muslin::glam::UVec3::X, ..id };
        halving(id, &params, both_inputs, elsewheres, fourth.view());
    });
    let values: Values = core::array::from_fn(|at| input.read(at as u32));
    let sums = prefix(values);
    for at in 0..64 {
        let (own, other) = if at % 3 == 0 { (low, high) } else { (high, low) };
        assert_eq!(own[at], sums[at]);
        assert_eq!(other[at], if at % 3 == 0 { BEFORE } else { values[at ^ 5] });
        assert_eq!(both[at], sums[63] + sums[at]);
    }
    assert_eq!(elsewhere[..64], [BEFORE; 64]);
    assert_eq!(elsewhere[64..], [given[64..128].iter().sum::<u32>(); 64]);
}

/// Each of 64 rounds has 4 iterations: 320 in all.
#[kernel(threads(64), iterations = 320 - 1)]
pub fn one_iteration_more(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let mut sum = 0;
    for round in 0..64 {
        id.barrier();
        let mut i = 0;
        while i < 4 {
            values.write(id.local.x, i + round);
            sum += values.read(id.local.x);
            i += 1;
        }
    }
    output.write(id.index(), sum);
}

/// Eight iterations of each, and three of all together.
#[kernel(threads(64), iterations = 10)]
pub fn one_round_more(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let mut i = 0;
    while i < 8 {
        values.write(id.local.x, i);
        i += 1;
    }
    for round in 0..3 {
        id.barrier();
        values.write(id.local.x, round);
    }
    output.write(id.index(), values.read(id.local.x));
}

/// A part that could be larger than the workgroup.
#[kernel(threads(64))]
pub fn part_of_hundred(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, id.local.x);
    id.barrier();
    if id.local.x < 100 {
        values.atomic_add(id.local.x, 1);
    }
    id.barrier();
    output.write(id.index(), values.read(63 - id.local.x));
}

#[test]
fn a_part_ends_with_the_workgroup() {
    for device in devices() {
        let output = device.zeros("out", 64).unwrap();
        device.run(&PartOfHundredKernel { output: &output }, 64, 1).unwrap();
        assert!(device.read(&output).unwrap().into_iter().eq((1..65).rev()));
    }
}

/// Fails in its second region, in one invocation.
#[kernel(threads(64))]
pub fn fails_in_a_region(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, if id.local.x == 37 { 1000 } else { id.local.x });
    id.barrier();
    output.write(values.read(id.local.x), 1);
}

/// One half of the invocations takes other turns than the other.
#[kernel(threads(64), iterations = 10)]
pub fn turns_apart(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let turns = if id.local.x < 32 { 3 } else { 2 };
    let mut turn = 0;
    while turn < turns {
        values.write(id.local.x, turn);
        id.barrier(); // its barrier
        turn += 1;
    }
    output.write(id.index(), values.read(0));
}

/// Takes another branch in the last invocation.
#[kernel(threads(64))]
pub fn another_branch(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local.x, 1);
    if id.local.x == 63 {
        output.write(63, 0);
    } else {
        id.barrier(); // of the others
    }
}

#[test]
fn mistakes_in_regions_are_told_with_their_invocations() {
    let source = ["regions.rs", include_str!("regions.rs")];
    let [too_far, the_barrier, the_loop, another_barrier, the_branch] = [
        "output.write(values.read(id.local.x), 1)",
        "id.barrier(); // its barrier",
        "while turn < turns",
        "id.barrier(); // of the others",
        "if id.local.x == 63",
    ]
    .map(|text| line(source, text));
    for device in devices() {
        let output = device.zeros("out", 64).unwrap();
        let message = failure(&device, &FailsInARegionKernel { output: &output }, 64);
        let parts =
            ["index 1000 is out of range of `output`", "invocation [37, 0, 0] of workgroup"];
        assert_contains(&message, &[&parts[..], &[&too_far]].concat());
        let message = failure(&device, &TurnsApartKernel { output: &output }, 64);
        assert_contains(
            &message,
            &[
                "kernel `turns_apart`: a barrier in divergent control flow: invocation [0, 0, 0] (with 31 more) waits at the barrier of",
                &the_barrier,
                "in round 3 of the loop of",
                "while invocation [32, 0, 0] (with 31 more) leaves the loop of",
                &the_loop,
                "before round 3, in workgroup [0, 0, 0]",
            ],
        );
        let message = failure(&device, &AnotherBranchKernel { output: &output }, 64);
        assert_contains(
            &message,
            &[
                "invocation [0, 0, 0] (with 62 more) waits at the barrier of",
                &another_barrier,
                "while invocation [63, 0, 0] takes the branch of",
                &the_branch,
            ],
        );
    }
    #[cfg(debug_assertions)]
    {
        // in a unit test, too
        let message = crate::panic_of(|| {
            let mut output = [0; 64];
            let output = Write::from(&mut output[..]);
            let values = SharedMemory::new();
            Workgroup::new([64, 1, 1]).run(|id| turns_apart(id, output, values.view()));
        });
        assert_contains(&message, &["leaves the loop of", &the_loop, "before round 3"]);
        let device = muslin_check::devices::cpu(Some(1));
        let output = device.zeros("out", 64).unwrap();
        let messages = [
            (failure(&device, &OneIterationMoreKernel { output: &output }, 64), "while i < 4 "),
            (failure(&device, &OneRoundMoreKernel { output: &output }, 64), "for round in 0..3 {"),
        ];
        for (message, place) in messages {
            let parts = [
                "the loops take more iterations than the kernel declares",
                &line(source, place),
                "invocation [0, 0, 0] of",
            ];
            assert_contains(&message, &parts);
        }
    }
}
