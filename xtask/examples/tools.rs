//! The kit's tools for organza's kernels. `cargo xtask` builds and runs them.

muslin_build::xtask!(
    organza_shaders in "shader-crate",
    sources: ["kit/kernel", "kit/macros", "shader-crate"].map(String::from).into(),
    kernels: "host/render/kernels".into(),
);
