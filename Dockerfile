# Builds organza, and an image with nothing but the program and a Vulkan driver that needs no GPU:
#
#   docker build -t organza .
#   docker run --rm -v "$PWD:/data" organza train -o run
#
# Checked with buildah, but for two things: where no registry was in reach, bases made by debootstrap stood in for the two of
# `FROM`, and the program was compiled outside.
#
# For an NVIDIA GPU, add `--gpus all -e NVIDIA_DRIVER_CAPABILITIES=graphics,compute` (NVIDIA's container toolkit).

FROM rust:1.95-bookworm AS build
WORKDIR /organza
COPY . .
# rust-toolchain.toml names components that only developers need.
RUN rm rust-toolchain.toml && cargo build --release --locked --package organza --bin organza

FROM debian:bookworm-slim
RUN apt-get update \
    && apt-get install -y --no-install-recommends libvulkan1 mesa-vulkan-drivers \
    && rm -rf /var/lib/apt/lists/*
COPY --from=build /organza/target/release/organza /usr/local/bin/
WORKDIR /data
ENTRYPOINT ["organza"]
CMD ["--help"]
