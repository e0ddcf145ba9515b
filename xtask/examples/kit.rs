//! The kit's tools for its own kernels. `cargo xtask kit` builds and runs them.

muslin_build::xtask!(
    muslin_language_kernels in "kit/language/kernels",
    sources: ["kit/kernel", "kit/macros", "kit/language/kernels"].map(String::from).into(),
    kernels: "kit/language/compiled".into(),
);
