//! The operations of subgroups on the CPU.

use glam::UVec4;
/// An operation of a subgroup on the CPU.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operation {
    Sum,
    Min,
    Max,
    SignedMin,
    SignedMax,
    And,
    Or,
    Xor,
    FloatSum,
    FloatMin,
    FloatMax,
    InclusiveSum,
    ExclusiveSum,
    InclusiveFloatSum,
    ExclusiveFloatSum,
    First,
    Shuffle,
    ShuffleXor,
    Ballot,
}

impl Operation {
    /// The result of the lane `lane`, of what each lane gives: the bits of a value, and which lane a shuffle asks for. A number is the
    /// result's first component.
    ///
    /// # Errors
    /// The lane that a shuffle asks for, if there is none.
    pub(crate) fn of(self, lane: usize, lanes: &[UVec4]) -> Result<UVec4, u32> {
        let values = || lanes.iter().map(|given| given.x);
        let signed = || values().map(u32::cast_signed);
        let floats = || values().map(f32::from_bits);
        let float = |value: Option<f32>| value.unwrap_or_default().to_bits();
        let value_of = |asked: u32| lanes.get(asked as usize).map(|given| given.x).ok_or(asked);
        let result = match self {
            Self::Sum => values().fold(0, u32::wrapping_add),
            Self::Min => values().min().unwrap_or_default(),
            Self::Max => values().max().unwrap_or_default(),
            Self::SignedMin => signed().min().unwrap_or_default().cast_unsigned(),
            Self::SignedMax => signed().max().unwrap_or_default().cast_unsigned(),
            Self::And => values().fold(!0, |all, bits| all & bits),
            Self::Or => values().fold(0, |all, bits| all | bits),
            Self::Xor => values().fold(0, |all, bits| all ^ bits),
            Self::FloatSum => float(floats().reduce(|a, b| a + b)),
            Self::FloatMin => float(floats().reduce(f32::min)),
            Self::FloatMax => float(floats().reduce(f32::max)),
            Self::InclusiveSum => values().take(lane + 1).fold(0, u32::wrapping_add),
            Self::ExclusiveSum => values().take(lane).fold(0, u32::wrapping_add),
            Self::InclusiveFloatSum => float(floats().take(lane + 1).reduce(|a, b| a + b)),
            Self::ExclusiveFloatSum => float(floats().take(lane).reduce(|a, b| a + b)),
            Self::First => lanes[0].x,
            Self::Shuffle => value_of(lanes[lane].y)?,
            Self::ShuffleXor => value_of(lane as u32 ^ lanes[lane].y)?,
            Self::Ballot => {
                let bits =
                    (0..).zip(values()).fold(0, |bits, (i, is_set)| bits | u128::from(is_set) << i);
                return Ok(UVec4::from_array(core::array::from_fn(|word| {
                    (bits >> (32 * word)) as u32
                })));
            }
        };
        Ok(UVec4::new(result, 0, 0, 0))
    }
}
