//! `cargo xtask`: the kit's tools for organza's kernels, and `cargo xtask new`. Everybody else builds organza without a SPIR-V compiler.

#[cfg(feature = "kernels")]
muslin_build::xtask!(
    organza_shaders in "shader-crate",
    sources: ["kit/kernel", "kit/macros", "shader-crate"].map(String::from).into(),
    kernels: "host/render/kernels".into(),
    wgsl: true,
    parity: "test --workspace --test kernels is_right_on_every_device -- --nocapture",
    bench: "run --release -- bench --every-device",
    coverage: "test --workspace --test kernels is_right_on_every_device",
    snapshots: "test --workspace --test pictures snapshots",
);

#[cfg(not(feature = "kernels"))]
mod new;

/// Without its features this program is compiled in a second: it makes projects, and runs itself with them for all else.
#[cfg(not(feature = "kernels"))]
fn main() -> std::process::ExitCode {
    new::main()
}
