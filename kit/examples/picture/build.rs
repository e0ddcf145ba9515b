fn main() {
    organza_manifest::embed_compiled();
}
