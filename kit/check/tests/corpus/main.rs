//! A corpus of wrong kernels, with mistakes that people make. Each file has one, and its first line describes the
//! mistake.
//!
//! The tests run them as the author of a kernel would, and compare the table of `docs/corpus.md` with the results. A
//! line with a mistake ends with `//~`.

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
        missing_before_read
        missing_before_overwrite
        reduction_without_barrier
        scan_in_place
        last_warp_needs_none
        next_tile_overwrites
        divergent_half
        returns_before_barrier
        barrier_in_each_branch
        helper_in_both_branches
        rounds_apart
        loop_of_different_lengths
        barrier_behind_a_vote
        barrier_for_storage
        storage_barrier_for_all_workgroups
        storage_barrier_is_missing
        barrier_for_all_workgroups
    }
    subgroups {
        lanes_without_items
        size_is_written_out
        ballot_of_one_word
        operation_for_a_barrier
    }
    workgroup_memory {
        half_is_loaded
        counts_are_not_cleared
        end_of_the_last_tile
        halo_is_missing
        past_the_end
        index_of_the_dispatch
        one_cell_for_all
        fewer_invocations_than_elements
        more_invocations_than_elements
        column_is_not_the_index
        row_without_its_padding
        shared_is_not_global
        counts_read_too_soon
    }
    storage_races {
        two_write_one
        sum_in_one_element
        histogram_without_atomics
        atomic_and_plain
        reads_a_counter_too_soon
        blur_in_place
        shift_in_place
        transpose_in_place
        reverse_in_place
        scatter_with_duplicates
        append_without_atomics
        flag_without_atomics
        sum_by_every_invocation
        spans_overlap
        rows_overlap
        wide_sum_without_layers
        layers_share_a_sum
    }
    out_of_range {
        no_test_of_the_index
        test_is_off_by_one
        neighbor_of_the_last
        neighbor_of_the_first
        negative_column
        stride_of_four
        bytes_for_elements
        index_from_a_buffer
        clamped_to_the_length
        last_word_of_a_mask
        height_for_width
        lanes_past_the_end
    }
    unwritten {
        last_element
        one_branch_writes
        dispatch_rounds_down
        items_round_down
        dispatch_without_rows
        every_second_pair
        behind_the_output
        counter_is_not_cleared
        sum_onto_its_output
        consumer_before_producer
        producer_is_too_short
    }
    order {
        ticket_in_the_result
        ticket_within_a_workgroup
        reader_before_publisher
        last_one_wins
    }
    arithmetic {
        sum_overflows
        product_overflows
        difference_underflows
        divides_by_zero
        remainder_by_zero
        shift_by_32
        bits_shifted_out
        color_spills_over
        float_counts_too_far
        negative_float_to_unsigned
        too_large_for_an_integer
        nan_becomes_an_index
        nan_in_a_helper
        nan_of_an_empty_mean
        nan_of_a_root
        nan_of_a_direction
        sign_is_lost
        usize_has_64_bits
        square_by_pow
    }
    machine {
        denormal_is_not_zero
        divides_by_a_denormal
        root_of_a_fused_difference
        side_of_a_fused_line
        rounds_by_a_large_number
        scales_in_two_steps
    }
    loops {
        understated
        inner_loop_forgotten
        depends_on_data
        one_iteration_too_many
        never_ends
        helper_is_not_counted
        helper_never_ends
    }
    bindings {
        swapped_inputs
        swapped_parameters
        input_is_the_output
        tail_of_the_output
        view_of_the_output
        buffer_of_another_size
        count_of_another_buffer
    }
    workgroups {
        size_is_written_out
        one_row_of_workgroups
        rows_have_one_index
        layers_are_not_in_the_index
        stride_of_the_dispatch
        too_long_an_axis
    }
    values {
        end_of_the_row
        transposed
        one_weight_for_all_lanes
        index_of_the_first_lane
        rest_of_the_lanes
    }
}
