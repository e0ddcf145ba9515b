fn main() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    organza_manifest::embed(&folder.join("compiled"), folder);
}
