//! Features that a server or a container lacks.

use organza_tests::devices;

use crate::sandbox::Outcome;
use crate::train::runs;

/// Mesa and libwayland look for a desktop's sockets in a folder that only a desktop has. That must not print
/// anything.
#[test]
fn a_missing_desktop_prints_nothing() {
    let sandbox = runs::sandbox();
    let backends = if devices::has_gpu() { &["auto", "gpu"][..] } else { &["auto"] };
    for backend in backends {
        for words in [
            format!("render scene.safetensors cameras.json -o images-{backend}"),
            format!("train views --config tiny.toml -o run-{backend} --steps 1"),
        ] {
            let mut command = sandbox.command(&format!("{words} -q --backend {backend}"));
            command.env_remove("XDG_RUNTIME_DIR").env_remove("NODEVICE_SELECT");
            let outcome: Outcome = command.output().expect("the program starts").into();
            assert_eq!(outcome.assert_ok().stderr, "", "{words}");
        }
    }
}
