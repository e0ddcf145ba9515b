//! `cargo xtask kernels` compiles the kernels for GPUs, into `compiled/`.

organza_build::xtask!(picture_kernels in "kernels");
