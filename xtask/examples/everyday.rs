//! Compiles the everyday kernels of the kit's examples: `cargo xtask everyday kernels`.

muslin_build::xtask!(
    muslin_everyday_kernels in "kit/examples/everyday/kernels",
    sources: ["kit/kernel", "kit/macros", "kit/examples/everyday/kernels"].map(String::from).into(),
    kernels: "kit/examples/everyday/compiled".into(),
);
