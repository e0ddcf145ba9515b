//! The CPU runs kernels like a GPU, and also reports what a GPU would not: the invocation and the kernel that break a
//! rule.
//!
//! The broken kernels are declared here with `#[kernel]`, like all kernels. What one kernel alone can do wrong is in the
//! corpus beside.

extern crate muslin_kernel as muslin;

mod broken;
mod lanes;
mod regions;
mod sizes;
mod storage_barriers;
mod subgroups;
mod thorough;

use std::process::Command;

use muslin::given::Inputs;
use muslin::glam::UVec3;
use muslin::invocation::Invocation;
use muslin::kernel::Dispatch;
use muslin::memory::{Read, Shared, Write};
use muslin::prelude::{kernel, params};
use muslin::workgroup::{SharedMemory, Workgroup};
use muslin_check::{KernelRunner, devices, unwritten};
use muslin_device::{Device, DeviceOptions, Error, Modules};

use broken::*;

/// The error message of a kernel that must fail.
fn failure<'a>(
    device: &Device,
    kernel: &impl Dispatch<'a, muslin_device::Host>,
    items: u32,
) -> String {
    match device.run(kernel, items, 1) {
        Err(error @ Error::Kernel { .. }) => error.to_string(),
        other => panic!("`{}` gave {other:?}", kernel.info().name),
    }
}

fn assert_contains(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
}

/// What a call panics with.
fn panic_of(call: impl FnOnce() + std::panic::UnwindSafe) -> String {
    let panic = std::panic::catch_unwind(call).expect_err("it panics");
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.unwrap_or_else(|| *panic.downcast::<String>().expect("a text"))
}

fn checked() -> Device {
    let options = DeviceOptions::cpu(None).check_races(true);
    Device::open(&options, Modules::none()).expect("the CPU")
}

/// The first line of a source that contains a text, as messages name it.
fn line([name, source]: [&str; 2], text: &str) -> String {
    let line = source.lines().position(|line| line.contains(text)).expect("a line");
    format!("{name}:{}:", line + 1)
}

/// A struct with a name that could be a generic parameter.
#[params]
pub struct S {
    /// Items.
    pub count: u32,
}

/// Bindings with names that the code of the macro has, too.
#[kernel(threads(64), over(elements.len().min(uniform.count)))]
pub fn names_of_the_macro(
    id: Invocation,
    elements: Read<S>,
    uniform: &S,
    bindings: Read<u32>,
    visit: Write<u32>,
) {
    let index = id.index();
    if index < uniform.count {
        visit.write(index, elements.read(index).count + bindings.read(index));
    }
}

#[test]
fn bindings_have_any_names() {
    let elements = vec![S { count: 5 }, S { count: 7 }];
    let [bindings, visit] = [vec![1, 2], unwritten(2)];
    let given = NamesOfTheMacroInputs { elements, uniform: S { count: 2 }, bindings, visit };
    let device = checked();
    let runner = KernelRunner::new(&device, NamesOfTheMacroInputs::KERNEL);
    assert_eq!(runner.run(&given.kernel()).unwrap()[0].values, [6.0, 9.0]);
}

const BROKEN: [&str; 2] = ["broken.rs", include_str!("broken.rs")];

#[test]
fn an_index_out_of_range_is_told_with_its_invocation() {
    let device = devices::cpu(Some(2));
    let input = device.zeros("in", 100).unwrap();
    let output = device.zeros("out", 70).unwrap();
    let message = failure(&device, &ReachesTooFarKernel { input: &input, output: &output }, 100);
    assert_contains(
        &message,
        &[
            "kernel `reaches_too_far`: index 70 is out of range of `output`, which has 70 elements",
            "invocation [6, 0, 0] of workgroup [1, 0, 0], [70, 0, 0] in the dispatch",
            &line(BROKEN, "output.write(id.index()"),
        ],
    );
    let long = device.zeros("out", 128).unwrap();
    let message = failure(&device, &ReachesTooFarKernel { input: &input, output: &long }, 128);
    assert_contains(&message, &["index 100 is out of range of `input`, which has 100 elements"]);
}

#[test]
fn an_additional_workgroup_asks_for_the_test_of_the_index() {
    let device = devices::checked();
    let output = device.unwritten("out", 64).unwrap();
    let message = failure(&device, &NeighborKernel { output: &output }, 64);
    assert_contains(&message, &["so is a test of the index missing?"]);
}

#[test]
fn a_device_works_on_after_a_failure() {
    let device = devices::cpu(Some(2));
    let short = device.zeros::<u32>("short", 1).unwrap();
    let long = device.zeros("long", 64).unwrap();
    for _ in 0..3 {
        failure(&device, &MissingBarrierKernel { output: &long }, 64);
        failure(&device, &SkipsTheBarrierKernel { output: &long }, 64);
    }
    device.run(&NeighborKernel { output: &long }, 64, 1).unwrap();
    assert_eq!(device.read(&long).unwrap(), (0..64).map(|i| (i + 1) % 64).collect::<Vec<u32>>());
    assert_contains(&failure(&device, &NeighborKernel { output: &short }, 64), &["`output`"]);
}

#[test]
fn reads_of_unwritten_memory_are_refused() {
    let device = checked();
    let input = device.upload("in", &[7; 64]).unwrap();
    let output = device.unwritten("out", 64);
    let output = output.unwrap();
    let message = failure(&device, &AddsToNothingKernel { input: &input, output: &output }, 64);
    let parts = [
        "reads element ",
        " of `output`, which nothing has written",
        &line(BROKEN, "output.read(id"),
    ];
    assert_contains(&message, &parts);
    // the next kernel sees written values; `clear` and `write` count as writing
    device.clear(&output);
    device.run(&AddsToNothingKernel { input: &input, output: &output }, 64, 1).unwrap();
    assert_eq!(device.read(&output).unwrap(), [7; 64]);
    let parts = device.unwritten("parts", 65).unwrap();
    device.write(&parts, 0, &[1; 64]).unwrap();
    device.run(&AddsToNothingKernel { input: &parts, output: &output }, 64, 1).unwrap();
    // the same in a buffer that is only read
    #[cfg(debug_assertions)]
    {
        device.forget(&input);
        let kernel = AddsToNothingKernel { input: &input, output: &output };
        let message = failure(&device, &kernel, 64);
        assert_contains(
            &message,
            &[" of `input`, which nothing has written", &line(BROKEN, "+ input.read(id.index())")],
        );
    }
    // otherwise it can contain anything: debug builds fill it so that sums of it overflow
    #[cfg(debug_assertions)]
    {
        let plain = devices::cpu(None);
        let input = plain.upload("in", &[7; 64]).unwrap();
        let output = plain.unwritten("out", 64);
        let output = output.unwrap();
        let message = failure(&plain, &AddsToNothingKernel { input: &input, output: &output }, 64);
        assert_contains(
            &message,
            &["attempt to add with overflow", &line(BROKEN, "output.read(id")],
        );
    }
}

/// A kernel that adds to its output gives different numbers for different canaries.
#[test]
fn canaries_differ() {
    let device = devices::cpu(None);
    let run = |runner: KernelRunner<'_>| {
        let inputs = AddsToNothingInputs { input: vec![1; 64], output: unwritten(72) };
        runner.run(&inputs.kernel()).unwrap().remove(0)
    };
    let [one, other] = [KernelRunner::new, KernelRunner::with_other_canaries]
        .map(|new| run(new(&device, "adds_to_nothing")).values);
    assert!(one[..64].iter().zip(&other).all(|(one, other)| one != other));
    assert_eq!(one[64..], other[64..], "what is not written is the same");
}

#[test]
fn a_test_calls_a_kernel_with_barriers() {
    let input: Vec<u32> = (0..64).collect();
    let mut place = [0; 64];
    let mut bins = [5; 8];
    let counts = SharedMemory::new();
    let params = HistogramParams { count: 60 };
    let places = Write::from(&mut place[..]);
    let sums = Write::from(&mut bins[..]);
    let workgroup = Workgroup::new([64, 1, 1]);
    workgroup.run(|id| histogram(id, &params, Read::from(&input[..]), places, sums, counts.view()));
    assert_eq!(bins, [13, 13, 13, 13, 12, 12, 12, 12]);
    assert_eq!((place[8], place[59], place[60]), (1, 7, 0));
    // workgroup memory of another workgroup is unwritten
    let message = panic_of(|| {
        let mut output = [0; 64];
        let counts = SharedMemory::new();
        let output = Write::from(&mut output[..]);
        workgroup.run(|id| neighbor(id, output, counts.view()));
        workgroup.run(|id| {
            let _ = counts.view().read(id.local.x);
        });
    });
    assert_contains(&message, &["reads element 0 of `a buffer`, which no invocation has written"]);
    let message = panic_of(|| {
        let mut output = [0; 64];
        let values = SharedMemory::new();
        let output = Write::from(&mut output[..]);
        workgroup.run(|id| missing_barrier(id, output, values.view()));
    });
    assert_contains(
        &message,
        &[
            "reads element 0 of `values`",
            "no barrier lies between",
            "in invocation [1, 0, 0] of the workgroup",
        ],
    );
    // release builds do not look
    #[cfg(debug_assertions)]
    {
        let message = panic_of(|| {
            let mut output = [0; 64];
            let output = Write::from(&mut output[..]);
            let values = SharedMemory::new();
            Workgroup::new([32, 1, 1]).run(|id| neighbor(id, output, values.view()));
        });
        let expected =
            "kernel `neighbor` has workgroups of [64, 1, 1], and this one has [32, 1, 1]";
        assert_eq!(message, expected);
    }
    let message = panic_of(|| {
        let mut output = [0; 64];
        let id = Invocation::new(UVec3::ZERO, UVec3::ZERO, UVec3::ONE, UVec3::new(64, 1, 1));
        neighbor(id, Write::from(&mut output[..]), SharedMemory::new().view());
    });
    assert_contains(&message, &["a barrier, and no other invocation runs", "workgroup::Workgroup"]);
}

/// What others have done to an element since the last barrier counts, also behind an access of one's own.
#[test]
fn accesses_of_others_are_seen_behind_own_ones() {
    type Part = fn(bool, Shared<u32, 1>);
    let reads_and_writes: Part = |is_last, values| {
        let own = values.read(0);
        if is_last {
            values.write(0, own);
        }
    };
    let counts_and_reads: Part = |is_last, values| {
        values.atomic_add(0, 1);
        if is_last {
            values.read(0);
        }
    };
    let counts_and_writes: Part = |is_last, values| {
        values.atomic_add(0, 1);
        if is_last {
            values.write(0, 0);
        }
    };
    for (part, expected) in [
        (reads_and_writes, ["writes", "[62, 0, 0] of the workgroup has read"]),
        (counts_and_reads, ["reads", "[62, 0, 0] of the workgroup has atomically changed"]),
        (counts_and_writes, ["writes", "[62, 0, 0] of the workgroup has atomically changed"]),
    ] {
        let message = panic_of(|| {
            let values = SharedMemory::new();
            Workgroup::new([64, 1, 1]).run(|id| {
                let values = values.view();
                if id.local.x == 0 {
                    values.write(0, 5);
                }
                id.barrier();
                part(id.local.x == 63, values);
            });
        });
        let [does, other] = expected;
        let start = format!("{does} element 0 of `a buffer`, which invocation {other}");
        assert!(message.starts_with(&start), "{message}");
    }
}

#[test]
fn layers_stay_apart() {
    for device in [checked(), devices::cpu(Some(1)), devices::cpu(Some(3))] {
        let sums = device.zeros("sums", 8).unwrap();
        device.run(&LayersApartKernel { sums: &sums }, 128, 4).expect("no race");
        assert_eq!(device.read(&sums).unwrap(), [u32::MAX - 127, 127].repeat(4));
    }
}

/// Runs inside [`a_failed_call_of_a_kernel_names_the_invocation`].
#[test]
#[ignore = "it fails, and another test looks how"]
fn calls_a_kernel_that_fails() {
    let input = [1, 2, 3];
    let mut output = [0; 2];
    for x in 0..3 {
        let local = UVec3::new(x, 0, 0);
        let size = UVec3::new(64, 1, 1);
        let id = Invocation::new(local, UVec3::ZERO, UVec3::ONE, size);
        reaches_too_far(id, Read::from(&input[..]), Write::from(output.as_mut_slice()));
    }
}

/// The same, of a kernel with barriers.
#[test]
#[ignore = "it fails, and another test looks how"]
fn calls_a_kernel_that_fails_in_a_region() {
    let mut output = [0; 64];
    let output = Write::from(&mut output[..]);
    let values = SharedMemory::new();
    Workgroup::new([64, 1, 1]).run(|id| regions::fails_in_a_region(id, output, values.view()));
}

#[test]
#[cfg(debug_assertions)]
fn a_failed_call_of_a_kernel_names_the_invocation() {
    let regions = ["regions.rs", include_str!("regions.rs")];
    let fails: [(&str, [&str; 3]); 2] = [
        (
            "calls_a_kernel_that_fails",
            [
                "index 2 is out of range of `output`, which has 2 elements",
                &line(BROKEN, "output.write(id.index()"),
                "in kernel `reaches_too_far`, invocation [2, 0, 0] of workgroup [0, 0, 0], [2, 0, 0] in the dispatch",
            ],
        ),
        (
            "calls_a_kernel_that_fails_in_a_region",
            [
                "index 1000 is out of range of `output`, which has 64 elements",
                &line(regions, "output.write(values.read(id.local.x), 1)"),
                "in kernel `fails_in_a_region`, invocation [37, 0, 0] of workgroup [0, 0, 0], [37, 0, 0] in the dispatch",
            ],
        ),
    ];
    for (name, parts) in fails {
        let mut test = Command::new(std::env::current_exe().unwrap());
        let test = test.args(["--exact", name, "--ignored", "--nocapture"]);
        let message = String::from_utf8(test.output().unwrap().stderr).unwrap();
        assert_contains(&message, &parts);
        assert_eq!(message.matches("in kernel `").count(), 1, "{message}");
    }
}

#[test]
fn rows_of_samples_are_whole_vectors_of_numbers() {
    let device = checked();
    let params = CopiesFoursParams { samples: 5 };
    let short = device.upload("short", &[1.0; 7]).unwrap();
    let output = device.unwritten("out", 8).unwrap();
    let message =
        failure(&device, &CopiesFoursKernel { params, input: &short, output: &output }, 5);
    assert_contains(&message, &["`input` has 7 elements, and is read four at a time"]);
    let input = device.unwritten("in", 8).unwrap();
    device.write(&input, 0, &[1.0; 4]).unwrap();
    let message =
        failure(&device, &CopiesFoursKernel { params, input: &input, output: &output }, 5);
    // numbers are watched, and not vectors
    assert_contains(&message, &["reads element 4 of `input`, which nothing has written"]);
}

#[test]
fn small_integers_are_counted_one_by_one() {
    let device = checked();
    let bytes = device.upload("bytes", &[7_u8, 250, 3, 0, 255]).unwrap();
    let output = device.zeros("out", 64).unwrap();
    let message = failure(&device, &ReadsBytesKernel { bytes: &bytes, output: &output }, 64);
    assert_contains(&message, &["index 5 is out of range of `bytes`, which has 5 elements"]);
    assert_eq!(device.read_range(&output, 0, 5).unwrap(), [7, 250, 3, 0, 255]);
    // a kernel has written the first three words of sixteen
    let words = device.unwritten::<u32>("words", 16).unwrap();
    device.write(&words, 0, &[u32::MAX; 3]).unwrap();
    let bytes = words.view::<u8>();
    let message = failure(&device, &ReadsBytesKernel { bytes: &bytes, output: &output }, 64);
    assert_contains(&message, &["reads element 12 of `bytes`, which nothing has written"]);
}
