//! Checks that ranks make before they begin.

use super::Ranks;
use crate::error::{Error, Result};
use muslin_device::Device;

/// Makes sure that all ranks compute the same bits from the same input: that they run the same version of the
/// program, on devices that round alike. `commit` is the program's commit. `input` names each input that the ranks
/// have read, with a value that identifies it, such as a hash. `mixed` allows different programs and devices.
///
/// # Errors
/// [`Error::Rank`], on every rank, for the first rank that differs from rank 0; those of [`Ranks::max`].
pub fn check_agreement(
    ranks: &dyn Ranks,
    device: &Device,
    commit: &str,
    (what, input): (&str, &str),
    mixed: bool,
) -> Result<()> {
    let program = format!("organza {} {commit}", env!("CARGO_PKG_VERSION"));
    let mine = [program.trim_end(), &device.arithmetic(), input].join("\n");
    let all = ranks.gather(mine.into_bytes())?;
    let parts = |bytes: &[u8]| -> Vec<String> {
        String::from_utf8_lossy(bytes).splitn(3, '\n').map(str::to_owned).collect()
    };
    let first = parts(&all[0]);
    for (rank, bytes) in all.iter().enumerate() {
        let found = parts(bytes);
        let differs = |part: usize| found.get(part) != first.get(part);
        let message = if differs(2) {
            format!("it has read other {what} than rank 0: give all ranks the same files")
        } else if !mixed && (differs(0) || differs(1)) {
            format!(
                "it is {} on {}, but rank 0 is {} on {}: the result would depend on which of them computes what; \
                 use the same program, device and `--instruction-set` everywhere, or allow it with `--mixed`",
                found[0], found[1], first[0], first[1]
            )
        } else {
            continue;
        };
        return Err(Error::Rank { rank, message });
    }
    Ok(())
}
