//! `cargo xtask kernels` compiles the kernels for GPUs, into `compiled/`.

muslin::build::xtask!(picture_kernels in "kernels");
