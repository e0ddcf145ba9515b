//! A corpus of wrong kernels, with mistakes that people make: for each message of the kit one, and up to three. Each file has one,
//! and its first line describes the mistake. A line with a mistake ends with `//~`.
//!
//! The tests run them as the author of a kernel would, and compare the table of `README.md` with the results.

extern crate muslin_kernel as muslin;

mod bug;
mod page;

use bug::Bug;

/// Declares the modules of all wrong kernels, by kind, and lists the kernels.
macro_rules! corpus {
    ($($kind:ident { $($name:ident)* })*) => {
        $(mod $kind { $(pub mod $name;)* })*

        const BUGS: &[Bug] = &[$($(Bug {
            kind: stringify!($kind),
            name: stringify!($name),
            source: include_str!(concat!(stringify!($kind), "/", stringify!($name), ".rs")),
            test: $kind::$name::test,
        }),*),*];
    };
}

corpus! {
    barriers {
        missing_before_read reduction_without_barrier divergent_half
        barrier_in_each_branch helper_in_both_branches rounds_apart barrier_for_storage
        barrier_for_all_workgroups storage_barrier_is_missing storage_barrier_for_all_workgroups
    }
    subgroups { lanes_without_items size_is_written_out }
    workgroup_memory {
        end_of_the_last_tile column_is_not_the_index counts_read_too_soon
        lanes_overwrite_their_neighbors
    }
    storage_races {
        scatter_with_duplicates shift_in_place atomic_and_plain
        reads_a_counter_too_soon sum_by_every_invocation layers_share_a_sum
    }
    out_of_range { no_test_of_the_index lanes_past_the_end }
    unwritten {
        last_element items_round_down counter_is_not_cleared behind_the_output
    }
    order { ticket_in_the_result reader_before_publisher }
    arithmetic {
        difference_underflows divides_by_zero shift_by_32 negative_float_to_unsigned
        nan_in_a_helper nan_of_an_empty_mean usize_has_64_bits square_by_pow
    }
    machine {
        denormal_is_not_zero side_of_a_fused_line
        rounds_by_a_large_number scales_in_two_steps
    }
    loops { understated helper_never_ends }
    bindings { swapped_inputs input_is_the_output too_long_an_axis }
    values { end_of_the_row }
}
