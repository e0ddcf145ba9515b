//! A separate folder for each test, in which the program runs.

use std::collections::{BTreeMap, HashMap};
use std::ffi::OsStr;
use std::fs::{self, DirEntry};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;
use std::thread;
use std::time::{Duration, Instant};

use organza_tests::cases;
use safetensors::SafeTensors;
use safetensors::tensor::{Dtype, TensorView};
use serde_json::Value;
use tempfile::TempDir;

/// The path of the program. Cargo gives an integration test only the programs of its own package. So this asks cargo
/// to build the program, which also makes sure that it is up to date.
pub fn program() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(build)
}

fn build() -> PathBuf {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // .../target/debug/deps/program-0123456789abcdef
    let own = std::env::current_exe().expect("a test is a file");
    let profile = own.ancestors().nth(2).and_then(Path::file_name).and_then(OsStr::to_str);
    let profile = profile.map_or("dev", |name| if name == "debug" { "dev" } else { name });
    let output = Command::new(cargo)
        // The features of dependencies depend on what is built. With the whole workspace and an example they are
        // the features of `cargo test --workspace`, so nothing is compiled again.
        .args(["build", "--quiet", "--workspace", "--bin", "organza", "--example", "render_tiles"])
        .args(["--message-format", "json", "--profile", profile])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stderr(Stdio::inherit())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "the program does not build");
    let messages = output.stdout.split(|&byte| byte == b'\n');
    let executable = |line| {
        let message: Value = serde_json::from_slice(line).ok()?;
        let is_program = message.get("target")?.get("name")? == "organza";
        message.get("executable")?.as_str().filter(|_| is_program).map(PathBuf::from)
    };
    messages.filter_map(executable).next_back().expect("cargo names the program")
}

/// Waits until something is so, which must come within minutes.
#[track_caller]
pub fn wait_until(what: &str, mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < Duration::from_secs(180), "it takes too long: {what}");
        thread::sleep(Duration::from_millis(2));
    }
}

/// The outcome of a run: its exit code and its output.
#[derive(Debug)]
pub struct Outcome {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl From<Output> for Outcome {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("the program writes UTF-8");
        Self {
            code: output.status.code(),
            stdout: text(output.stdout),
            stderr: text(output.stderr),
        }
    }
}

impl Outcome {
    /// Asserts that the run succeeded, and that no message says otherwise.
    #[track_caller]
    pub fn assert_ok(self) -> Self {
        assert_eq!(self.code, Some(0), "{self:?}");
        assert!(!self.stderr.contains("error:"), "{self:?}");
        self
    }

    /// Asserts that stderr has these words.
    #[track_caller]
    pub fn says(self, words: &[&str]) -> Self {
        words.iter().for_each(|words| assert!(self.stderr.contains(words), "{words}: {self:?}"));
        self
    }

    /// Asserts that stderr has none of these words.
    #[track_caller]
    pub fn says_not(self, words: &[&str]) -> Self {
        words.iter().for_each(|words| assert!(!self.stderr.contains(words), "{words}: {self:?}"));
        self
    }

    /// The JSON that a successful run prints.
    #[track_caller]
    pub fn json(self) -> Value {
        serde_json::from_str(&self.assert_ok().stdout).expect("only JSON")
    }

    /// Asserts exit code 2 and one error, which contains each of `facts`.
    #[track_caller]
    pub fn assert_refused(&self, facts: &[&str]) {
        assert_eq!(self.code, Some(2), "{self:?}");
        let errors: Vec<_> =
            self.stderr.lines().filter(|line| line.starts_with("error: ")).collect();
        let [error] = errors.as_slice() else { panic!("not one error: {self:?}") };
        for fact in facts {
            assert!(error.contains(fact), "{fact:?} is not in {error:?}");
        }
        assert!(!self.stderr.contains("panicked"), "{self:?}");
        assert!(!error.contains("bug in organza"), "{error}");
        assert_eq!(self.stdout, "");
    }
}

/// Commands on a sandbox's files, without their output.
pub const TILES: &str = "tiles scene.safetensors cameras.json tiles.json --backend cpu";
pub const RENDER: &str = "render scene.safetensors cameras.json --backend cpu";

/// A copy of a case, in a folder that is removed after the test.
#[derive(Debug)]
pub struct Sandbox {
    folder: TempDir,
}

/// What a safetensors file says of itself, and the shape and the data of each tensor.
pub type Metadata = HashMap<String, String>;
pub type Tensors = BTreeMap<String, (Vec<usize>, Vec<u8>)>;

impl Sandbox {
    pub fn new(case: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["scene.safetensors", "cameras.json", "tiles.json"] {
            fs::copy(cases::folder().join(case).join(name), folder.path().join(name)).unwrap();
        }
        Self { folder }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    #[track_caller]
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    #[track_caller]
    pub fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    #[track_caller]
    pub fn make_folder(&self, name: &str) {
        fs::create_dir_all(self.path(name)).unwrap();
    }

    /// Writes a file, and makes the folder that it is in.
    #[track_caller]
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().expect("a folder")).unwrap();
        fs::write(path, content).unwrap();
    }

    /// Writes a program, which is a script, to the folder `bin`.
    #[cfg(unix)]
    pub fn write_program(&self, name: &str, script: &str) {
        let name = format!("bin/{name}");
        self.write(&name, script);
        let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
        fs::set_permissions(self.path(&name), mode).unwrap();
    }

    #[track_caller]
    pub fn copy_file(&self, from: &str, to: &str) {
        self.write(to, self.read(from));
    }

    #[track_caller]
    pub fn rename(&self, from: &str, to: &str) {
        fs::rename(self.path(from), self.path(to)).unwrap();
    }

    #[track_caller]
    pub fn remove(&self, name: &str) {
        fs::remove_file(self.path(name)).unwrap();
    }

    /// A command to run in the folder. Words are separated by spaces.
    pub fn command(&self, words: &str) -> Command {
        let mut command = Command::new(program());
        command.args(words.split_whitespace());
        self.prepare(&mut command);
        command
    }

    /// A shell command in the folder; `"$ORGANZA"` in it is the program.
    #[cfg(target_os = "linux")]
    pub fn shell_command(&self, script: &str) -> Command {
        let mut command = Command::new("sh");
        command.args(["-c", script]).env("ORGANZA", program());
        self.prepare(&mut command);
        command
    }

    /// Runs a [`Self::shell_command`].
    #[cfg(target_os = "linux")]
    pub fn shell(&self, script: &str) -> Outcome {
        self.shell_command(script).output().expect("a shell runs").into()
    }

    /// Runs the program with this much address space, in KiB. Each thread reserves 66 MiB of it, so there are few threads on
    /// every machine.
    #[cfg(target_os = "linux")]
    pub fn run_within(&self, kib: u32, words: &str) -> Outcome {
        self.shell(&format!("ulimit -v {kib}; RAYON_NUM_THREADS=2 \"$ORGANZA\" {words}"))
    }

    fn prepare(&self, command: &mut Command) {
        command.current_dir(self.folder.path()).stdin(Stdio::null());
        // Only developers need a backtrace, only desktops have a folder for sockets, and help must not be as wide as a terminal.
        command.env_remove("RUST_BACKTRACE").env_remove("XDG_RUNTIME_DIR").env_remove("COLUMNS");
    }

    pub fn run(&self, words: &str) -> Outcome {
        self.command(words).output().expect("the program starts").into()
    }

    /// Asserts that the run is refused with these facts, and leaves the folder unchanged.
    #[track_caller]
    pub fn assert_refuses(&self, words: &str, facts: &[&str]) {
        let before = self.files();
        self.run(words).assert_refused(facts);
        assert!(before == self.files(), "{words} left {:?}", self.files().keys());
    }

    /// Every file and folder below, with the content of files.
    pub fn files(&self) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
        let mut files = BTreeMap::new();
        let mut folders = vec![self.folder.path().to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path.clone());
                }
                files.insert(path.clone(), fs::read(&path).ok());
            }
        }
        files
    }

    /// Contents of a folder's files by name. A folder in it has none.
    pub fn contents(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let content = |entry: DirEntry| {
            let name = entry.file_name().into_string().expect("UTF-8");
            let is_folder = entry.path().is_dir();
            (name, if is_folder { Vec::new() } else { fs::read(entry.path()).unwrap() })
        };
        fs::read_dir(self.path(folder)).unwrap().map(Result::unwrap).map(content).collect()
    }

    /// Contents of a folder's images by name.
    pub fn images(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let mut files = self.contents(folder);
        files.retain(|name, _| name.ends_with(".png"));
        files
    }

    pub fn read_json(&self, name: &str) -> Value {
        serde_json::from_slice(&self.read(name)).unwrap()
    }

    /// Rewrites a text file, which `edit` changes.
    #[track_caller]
    pub fn edit_text(&self, name: &str, edit: impl FnOnce(&str) -> String) {
        let before = self.text(name);
        let after = edit(&before);
        assert_ne!(before, after);
        self.write(name, after);
    }

    /// Changes one value of a JSON file.
    pub fn edit_json(&self, name: &str, pointer: &str, value: Value) {
        let mut json = self.read_json(name);
        *json.pointer_mut(pointer).expect("a place in the file") = value;
        self.write(name, json.to_string());
    }

    /// Reads a file of tensors, and writes it again after `edit`.
    pub fn edit_tensors(&self, name: &str, edit: impl FnOnce(&mut Metadata, &mut Tensors)) {
        let file = self.read(name);
        let (_, header) = SafeTensors::read_metadata(&file).unwrap();
        let mut metadata = header.metadata().clone().expect("metadata");
        let tensor = |(name, tensor): (&str, TensorView<'_>)| {
            (name.to_owned(), (tensor.shape().to_vec(), tensor.data().to_vec()))
        };
        let mut tensors = SafeTensors::deserialize(&file).unwrap().iter().map(tensor).collect();
        edit(&mut metadata, &mut tensors);
        let views = tensors.iter().map(|(name, (shape, data))| {
            (name, TensorView::new(Dtype::F32, shape.clone(), data).expect("all of the data"))
        });
        safetensors::serialize_to_file(views, Some(metadata), &self.path(name)).unwrap();
    }
}
