//! Compares every kernel on every device with the CPU, and the CPU with the equations in f64.

use std::collections::BTreeSet;

use muslin_check::{KernelRunner, Parity, Rounding, missing};
use organza::{InstructionSet, Renderer};
use organza_parity::project_backward::ProjectBackward;
use organza_tests::{cases, devices};

#[test]
fn a_kernel_without_a_case_is_told_where_to_add_it() {
    let mut cases = organza_parity::cases();
    let removed = cases.remove(0);
    let missing = missing(&cases);
    assert_eq!(missing.len(), 1);
    for part in [removed.kernel, "shader-crate/src/adam.rs", "`case!`"] {
        assert!(missing[0].contains(part), "{}", missing[0]);
    }
}

#[test]
fn every_kernel_is_right_on_every_device() {
    muslin_check::assert_parity(&organza_parity::cases(), &organza::MODULES);
}

#[test]
fn the_pipeline_has_no_races() {
    let renderer = Renderer::new(devices::checked());
    for case in cases::all() {
        let scene = renderer.upload(&case.scene).unwrap();
        let checked = renderer.render(&scene, &case.cameras, &case.tiles);
        let checked = checked.unwrap_or_else(|error| panic!("{}: {error}", case.name));
        let plain = Renderer::new(devices::with(InstructionSet::Scalar));
        let scene = plain.upload(&case.scene).unwrap();
        let plain = plain.render(&scene, &case.cameras, &case.tiles).unwrap();
        assert!(checked.data == plain.data, "{}: checking changes the image", case.name);
    }
}

/// No sum may have an order that threads decide.
#[test]
fn the_number_of_threads_changes_no_bit() {
    let [one, three] = [1, 3].map(|threads| devices::cpu(Some(threads)));
    for case in organza_parity::cases() {
        let measure = case.measure(&one, &three, Rounding::AsWritten).expect("the kernel runs");
        assert_eq!(measure.share.value, 0.0, "{}: the number of threads shows", case.kernel);
    }
}

/// All integers in an output of a kernel, over all sets.
fn all_of<P: Parity>(output: &str) -> BTreeSet<u32> {
    let cpu = devices::cpu(None);
    let outputs = |set: P| set.run(&KernelRunner::new(&cpu, P::KERNEL)).expect("the kernel runs");
    let all = P::sets().into_iter().flat_map(|(_, set)| outputs(set));
    all.filter(|found| found.name == output).flat_map(|found| found.words()).collect()
}

/// Sets avoid places where rounding decides, but must still reach every branch.
#[test]
fn sets_reach_every_branch() {
    let classes = all_of::<organza_parity::project::Project>("class");
    assert!([0, 1, 2].iter().all(|class| classes.contains(class)), "{classes:?}");
    let counts = all_of::<organza_parity::segment::Segment>("count");
    assert!([0, 1, 2, 16_384].iter().all(|count| counts.contains(count)), "{counts:?}");
    let words = all_of::<organza_parity::tile::TileMask>("mask");
    assert!(words.contains(&0) && words.len() > 100, "{} words", words.len());
    // x / z and y / z of a pair: below the range to which J clamps them, inside, and above
    let mut ratios = [[0; 3]; 2];
    for (_, set) in ProjectBackward::sets() {
        for (axis, seen) in ratios.iter_mut().enumerate() {
            for place in set.pairs_in_image() {
                let x = place[axis];
                let size = f64::from(set.forward.cameras[0].size[axis]);
                seen[usize::from(x >= -0.15 * size) + usize::from(x > 1.15 * size)] += 1;
            }
        }
    }
    assert!(ratios.as_flattened().iter().all(|&count| count > 100), "{ratios:?}");
}
