//! Each test has one shape of a loop, and runs it step by step before and after the pass.

mod interpreter;

use interpreter::{module, run};
use rspirv::dr::Module;
use rspirv::spirv::Op;

use crate::lower::bytes;

use super::{block, end_at_conditions, find, id, terminator};

/// Runs the pass over a function of `%a` and `%b`. The result must compute the same in the same order, and naga must
/// read it. A second run must find nothing to do. Returns the number of loops that end at conditions and not at their
/// last block.
fn check(text: &str) -> usize {
    let before = module(text);
    let mut after = module(text);
    end_at_conditions(&mut after).unwrap();
    for a in 0..6 {
        for b in 0..6 {
            assert_eq!(run(&before, a, b), run(&after, a, b), "of {a} and {b}");
        }
    }
    crate::validate::check(&bytes(&after)).unwrap();
    let once = bytes(&after);
    end_at_conditions(&mut after).unwrap();
    assert_eq!(bytes(&after), once, "a second run");
    let function = &after.functions[0];
    let merges = function.blocks.iter().filter_map(|block| find(block, Op::LoopMerge));
    merges
        .filter(|merge| terminator(block(function, id(merge, 1))).class.opcode == Op::Branch)
        .count()
}

/// The module after the pass.
fn after(text: &str) -> Module {
    let mut module = module(text);
    end_at_conditions(&mut module).unwrap();
    module
}

/// The numbers of blocks and of phis in the function.
fn size(module: &Module) -> (usize, usize) {
    let blocks = &module.functions[0].blocks;
    let all = blocks.iter().flat_map(|block| &block.instructions);
    (blocks.len(), all.filter(|i| i.class.opcode == Op::Phi).count())
}

/// `while n < a { sum += b; n += 1 }`
const WHILE: &str = "
    %entry = OpLabel
    OpBranch %head
    %head = OpLabel
    %n = OpPhi %uint %0 %entry %n_next %next
    %sum = OpPhi %uint %7 %entry %sum_next %next
    OpLoopMerge %end %next None
    OpBranch %test
    %test = OpLabel
    %more = OpULessThan %bool %n %a
    OpSelectionMerge %join None
    OpBranchConditional %more %body %else
    %body = OpLabel
    %sum_1 = OpIAdd %uint %sum %b
    %n_1 = OpIAdd %uint %n %1
    OpBranch %join
    %else = OpLabel
    OpBranch %join
    %join = OpLabel
    %n_next = OpPhi %uint %n_1 %body %undefined %else
    %sum_next = OpPhi %uint %sum_1 %body %undefined %else
    OpBranch %next
    %next = OpLabel
    OpBranchConditional %more %head %end
    %end = OpLabel
    OpReturnValue %sum";

#[test]
fn a_while_ends_in_its_first_block() {
    assert_eq!(check(WHILE), 1);
    let module = after(WHILE);
    // entry, head, body, next, end: the test is in the head, and the join is gone
    assert_eq!(size(&module), (5, 2));
    let head = &module.functions[0].blocks[1];
    assert!(find(head, Op::ULessThan).is_some());
    assert_eq!(terminator(head).class.opcode, Op::BranchConditional);
}

/// The condition is inverted, and the body is the other side: `loop { if n >= a { break } .. }`
#[test]
fn a_condition_can_be_the_other_way_round() {
    let text = WHILE
        .replace("%more = OpULessThan %bool %n %a", "%more = OpULessThanEqual %bool %a %n")
        .replace("%more %body %else", "%more %else %body")
        .replace("%more %head %end", "%more %end %head");
    assert_eq!(check(&text), 1);
    assert_eq!(size(&after(&text)), (5, 2));
}

/// The side that ends the loop may produce values that code after the loop uses.
#[test]
fn values_of_the_ending_side_are_kept() {
    let text = WHILE
        .replace("%undefined %else", "%3 %else")
        .replace("OpReturnValue %sum", "%both = OpIAdd %uint %sum_next %n\nOpReturnValue %both");
    assert_eq!(check(&text), 1);
}

/// The optimizer turns a phi into a selection if its values are computed before the condition.
#[test]
fn a_join_may_select_by_the_condition() {
    let text = WHILE
        .replace("    %n_1 = OpIAdd %uint %n %1\n", "")
        .replace("%more = OpULess", "%n_1 = OpIAdd %uint %n %1\n%more = OpULess")
        .replace("    %n_next = OpPhi %uint %n_1 %body %undefined %else\n", "")
        .replace("OpBranch %next", "%n_next = OpSelect %uint %more %n_1 %sum_next\nOpBranch %next")
        .replace("%undefined %else", "%3 %else")
        .replace("OpReturnValue %sum", "%both = OpIAdd %uint %n_next %n\nOpReturnValue %both");
    assert_eq!(check(&text), 1);
    // a computation from other values stays where it is
    let text = text.replace("OpSelect %uint %more %n_1 %sum_next", "OpIAdd %uint %n %1");
    assert_eq!(check(&text), 0);
}

/// A phi after the loop may also use the value.
#[test]
fn a_phi_after_the_loop_gets_the_value_of_the_other_side() {
    let text = WHILE.replace("%undefined %else", "%3 %else").replace(
        "OpReturnValue %sum",
        "%last = OpPhi %uint %n_next %next\n%both = OpIAdd %uint %sum %last\nOpReturnValue %both",
    );
    assert_eq!(check(&text), 1);
}

/// `while n < a && sum < 7 + 2 b { .. }`: two conditions, each around the next, and a phi of both at the end
const TWO_CONDITIONS: &str = "
    %entry = OpLabel
    %limit_1 = OpIAdd %uint %b %b
    %limit = OpIAdd %uint %limit_1 %7
    OpBranch %head
    %head = OpLabel
    %n = OpPhi %uint %0 %entry %n_next %next
    %sum = OpPhi %uint %7 %entry %sum_next %next
    OpLoopMerge %end %next None
    OpBranch %test
    %test = OpLabel
    %more = OpULessThan %bool %n %a
    OpSelectionMerge %join None
    OpBranchConditional %more %test_2 %else
    %test_2 = OpLabel
    %more_2 = OpULessThan %bool %sum %limit
    OpSelectionMerge %join_2 None
    OpBranchConditional %more_2 %body %else_2
    %body = OpLabel
    %sum_1 = OpIAdd %uint %sum %b
    %n_1 = OpIAdd %uint %n %1
    OpBranch %join_2
    %else_2 = OpLabel
    OpBranch %join_2
    %join_2 = OpLabel
    %n_2 = OpPhi %uint %n_1 %body %2 %else_2
    %sum_2 = OpPhi %uint %sum_1 %body %undefined %else_2
    OpBranch %join
    %else = OpLabel
    OpBranch %join
    %join = OpLabel
    %n_next = OpPhi %uint %n_2 %join_2 %3 %else
    %sum_next = OpPhi %uint %sum_2 %join_2 %undefined %else
    %again = OpPhi %bool %more_2 %join_2 %false %else
    OpBranch %next
    %next = OpLabel
    OpBranchConditional %again %head %end
    %end = OpLabel
    OpReturnValue %sum";

#[test]
fn each_of_two_conditions_ends_the_loop() {
    assert_eq!(check(TWO_CONDITIONS), 1);
    // entry, head, test_2, body, next, end
    assert_eq!(size(&after(TWO_CONDITIONS)), (6, 2));
}

/// The two conditions give different values for after the loop: 3 and 2.
#[test]
fn each_way_out_has_its_own_value() {
    let text = TWO_CONDITIONS
        .replace("OpReturnValue %sum", "%both = OpIAdd %uint %sum %n_next\nOpReturnValue %both");
    assert_eq!(check(&text), 1);
    // and the value is a phi at the end now
    assert_eq!(size(&after(&text)), (6, 3));
    let text = TWO_CONDITIONS.replace(
        "OpReturnValue %sum",
        "%last = OpPhi %uint %n_next %next\n%both = OpIAdd %uint %sum %last\nOpReturnValue %both",
    );
    assert_eq!(check(&text), 1);
}

/// `loop { n += 1; if n == a { sum += 3; break } sum += b; }`, at most 7 times: work before a `break`
#[test]
fn a_side_may_work_before_it_ends_the_loop() {
    let text = "
    %entry = OpLabel
    OpBranch %head
    %head = OpLabel
    %n = OpPhi %uint %0 %entry %n_next %next
    %sum = OpPhi %uint %7 %entry %sum_next %next
    OpLoopMerge %end %next None
    OpBranch %first
    %first = OpLabel
    %n_1 = OpIAdd %uint %n %1
    %out = OpULessThanEqual %bool %a %n_1
    OpSelectionMerge %join None
    OpBranchConditional %out %leaving %body
    %leaving = OpLabel
    %sum_3 = OpIAdd %uint %sum %3
    OpBranch %join
    %body = OpLabel
    %sum_b = OpIAdd %uint %sum %b
    OpBranch %join
    %join = OpLabel
    %n_next = OpPhi %uint %undefined %leaving %n_1 %body
    %sum_next = OpPhi %uint %sum_3 %leaving %sum_b %body
    %again = OpPhi %bool %false %leaving %true %body
    OpBranch %next
    %next = OpLabel
    OpBranchConditional %again %head %end
    %end = OpLabel
    OpReturnValue %sum_next";
    assert_eq!(check(text), 1);
}

/// `while n < a { sum += b; n += 1; if sum == 8 { break } }`: the last condition stands alone at the end
#[test]
fn a_condition_at_the_end_of_the_body_is_decided_there() {
    let text = WHILE
        .replace(
            "%n_1 = OpIAdd %uint %n %1",
            "%n_1 = OpIAdd %uint %n %1\n%low = OpULessThan %bool %sum_1 %limit",
        )
        .replace(
            "OpBranch %head\n    %head",
            "%limit = OpIAdd %uint %7 %3\nOpBranch %head\n    %head",
        )
        .replace("OpBranch %next", "%again = OpPhi %bool %low %body %false %else\nOpBranch %next")
        .replace("OpBranchConditional %more %head", "OpBranchConditional %again %head");
    assert_eq!(check(&text), 1);
}

/// A loop may already have a way out: Rust-GPU ends an invocation that divides by zero this way, with a flag for the
/// code after it.
#[test]
fn ways_out_that_are_there_stay() {
    let text = WHILE
        .replace("%sum_1 = OpIAdd", "%zero = OpIEqual %bool %b %n\nOpSelectionMerge %fine None\nOpBranchConditional %zero %abort %fine\n%abort = OpLabel\nOpBranch %end\n%fine = OpLabel\n%sum_1 = OpIAdd")
        .replace("%n_1 %body", "%n_1 %fine")
        .replace("%sum_1 %body", "%sum_1 %fine")
        .replace("OpReturnValue %sum", "%aborted = OpPhi %uint %1 %abort %0 %next\n%both = OpIAdd %uint %sum %aborted\nOpReturnValue %both");
    assert_eq!(check(&text), 1);
}

/// In nested loops, the outer loop uses the inner one's results.
#[test]
fn loops_in_loops_are_rewritten_too() {
    let inner = WHILE
        .replace("%a", "%n_outer")
        .replace("%7 %entry", "%sum_outer %entry")
        .replace("%entry = OpLabel", "%entry = OpLabel\n%unused = OpIAdd %uint %n_outer %1")
        .replace("OpReturnValue %sum", "%n_2 = OpIAdd %uint %n_outer %1\nOpBranch %join_outer");
    let text = format!(
        "%start = OpLabel
        OpBranch %head_outer
        %head_outer = OpLabel
        %n_outer = OpPhi %uint %0 %start %n_more %next_outer
        %sum_outer = OpPhi %uint %3 %start %sum_more %next_outer
        OpLoopMerge %end_outer %next_outer None
        OpBranch %test_outer
        %test_outer = OpLabel
        %more_outer = OpULessThan %bool %n_outer %a
        OpSelectionMerge %join_outer None
        OpBranchConditional %more_outer {} %else_outer
        {inner}
        %else_outer = OpLabel
        OpBranch %join_outer
        %join_outer = OpLabel
        %n_more = OpPhi %uint %n_2 %end %undefined %else_outer
        %sum_more = OpPhi %uint %sum %end %undefined %else_outer
        OpBranch %next_outer
        %next_outer = OpLabel
        OpBranchConditional %more_outer %head_outer %end_outer
        %end_outer = OpLabel
        OpReturnValue %sum_outer",
        "%entry"
    );
    assert_eq!(check(&text), 2);
}

/// `loop { sum += b; n += 1; if n >= a { break } }` has its condition once, at its end: there is nothing to do.
#[test]
fn a_loop_that_ends_at_its_end_stays() {
    let text = "
    %entry = OpLabel
    OpBranch %head
    %head = OpLabel
    %n = OpPhi %uint %0 %entry %n_1 %next
    %sum = OpPhi %uint %7 %entry %sum_1 %next
    OpLoopMerge %end %next None
    OpBranch %body
    %body = OpLabel
    %sum_1 = OpIAdd %uint %sum %b
    %n_1 = OpIAdd %uint %n %1
    %more = OpULessThan %bool %n_1 %a
    OpBranch %next
    %next = OpLabel
    OpBranchConditional %more %head %end
    %end = OpLabel
    OpReturnValue %sum_1";
    assert_eq!(check(text), 0);
    assert_eq!(bytes(&after(text)), bytes(&module(text)));
}

/// A `match` ends the loop in one of its cases: naga's reader would miscompile a way out from there.
#[test]
fn a_match_stays() {
    let text = "
    %entry = OpLabel
    OpBranch %head
    %head = OpLabel
    %n = OpPhi %uint %0 %entry %n_next %next
    OpLoopMerge %end %next None
    OpBranch %test
    %test = OpLabel
    OpSelectionMerge %join None
    OpSwitch %n %case 3 %last
    %case = OpLabel
    %n_1 = OpIAdd %uint %n %1
    OpBranch %join
    %last = OpLabel
    OpBranch %join
    %join = OpLabel
    %n_next = OpPhi %uint %n_1 %case %undefined %last
    %again = OpPhi %bool %true %case %false %last
    OpBranch %next
    %next = OpLabel
    OpBranchConditional %again %head %end
    %end = OpLabel
    OpReturnValue %n";
    assert_eq!(check(text), 0);
}
