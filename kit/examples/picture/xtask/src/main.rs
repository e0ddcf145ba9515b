//! `cargo xtask kernels` compiles the kernels for GPUs, into `compiled/`.

// the program is linked with the kernels that it compiles
use picture_kernels as _;

fn main() -> std::process::ExitCode {
    organza_build::main(&organza_build::Project::of_xtask(env!("CARGO_MANIFEST_DIR"), "kernels"))
}
