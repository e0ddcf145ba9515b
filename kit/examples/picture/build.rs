fn main() {
    muslin_manifest::embed_compiled();
}
