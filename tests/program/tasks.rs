//! Folders with files: `render --task` and `--missing` add to them, and nothing of others is removed.

use crate::sandbox::Sandbox;

const RENDER: &str = "render scene.safetensors cameras.json --backend cpu --channels depth";

/// Three tasks run at the same time, and one is killed. After rendering missing images, the folder equals the folder of a
/// single call.
#[test]
fn tasks_and_missing_images_equal_one_call() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("{RENDER} -o whole")).assert_ok();
    let whole = sandbox.images("whole");
    let views = whole.len() / 2;
    assert!(views >= 2, "{:?}", whole.keys());

    std::thread::scope(|scope| {
        let task = |index| {
            scope.spawn({
                let sandbox = &sandbox;
                move || sandbox.run(&format!("{RENDER} -o out --task {index}/3 --json")).json()
            })
        };
        let results = [0, 1, 2].map(task).map(|thread| thread.join().expect("a result"));
        for (index, result) in results.iter().enumerate() {
            let expected: Vec<_> = (index..views).step_by(3).collect();
            let list = result["images"].as_array().unwrap();
            let found: Vec<_> =
                list.iter().map(|image| image["view"].as_u64().unwrap() as usize).collect();
            assert_eq!(found, expected);
            assert_eq!(result["rendered"], expected.len());
        }
    });
    assert_eq!(sandbox.images("out"), whole);
    // nothing is missing
    let result = sandbox.run(&format!("{RENDER} -o out --missing --json")).json();
    assert_eq!(result["rendered"], 0);

    // one channel is missing
    sandbox.remove("out/0001.depth.png");
    let result = sandbox.run(&format!("{RENDER} -o out --missing --task 1/2 --json")).json();
    assert_eq!(result["rendered"], 1);
    assert_eq!(sandbox.images("out"), whole);
    // a file that is there stays, even if it is no image
    sandbox.write("out/0000.png", "mine");
    sandbox.run(&format!("{RENDER} -o out --missing")).assert_ok();
    assert_eq!(sandbox.read("out/0000.png"), b"mine");
}

/// Images of an older scene, of other cameras or with other options are not those that are missing.
#[test]
fn images_of_anything_else_do_not_stay() {
    let sandbox = Sandbox::new("tiny");
    let render = |words: &str| sandbox.run(&format!("{WHOLE} {words}"));
    let refused = |words: &str| {
        let facts = ["0000.png was not made of this scene", "leave out `--missing`"];
        sandbox.assert_refuses(&format!("{WHOLE} {words} --missing"), &facts);
    };
    render("").assert_ok();
    sandbox.remove("out/0001.png");
    refused("--half-grids");
    sandbox.edit_json("cameras.json", "/frames/0/transform_matrix/0/3", serde_json::json!(2.5));
    refused("");
    render("").assert_ok();
    sandbox.remove("out/0001.png");
    render("--missing").assert_ok();
    // a view that stays is of the older scene
    sandbox.rename("scene.safetensors", "older.safetensors");
    sandbox.run("edit older.safetensors -o scene.safetensors --scale 2 --backend cpu").assert_ok();
    render("--views 1").assert_ok();
    refused("");
    render("").assert_ok();
    render("--missing").assert_ok();
}

#[test]
fn an_empty_task_succeeds_and_bad_tasks_are_refused() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("{RENDER} -o out --task 90/91")).assert_ok().says(&["nothing to render"]);
    for (task, reason) in [
        ("2/2", "no task 2 of 2: they are 0 to 1"),
        ("0", "expected I/N, such as 0/8"),
        ("slurm", "SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT are not set"),
    ] {
        sandbox.assert_refuses(&format!("{RENDER} -o out --task {task}"), &[reason]);
    }
}

const WHOLE: &str = "render scene.safetensors cameras.json --backend cpu -o out";

#[test]
fn views_of_the_same_cameras_add_up() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run(&format!("{WHOLE} --views 0 --channels depth")).assert_ok();
    sandbox.run(&format!("{WHOLE} --views 1")).assert_ok();
    for name in ["0000.png", "0000.depth.png", "0001.png"] {
        assert!(sandbox.path("out").join(name).exists(), "{name}");
    }
}

#[test]
fn other_files_are_refused_unless_they_may_stay() {
    let sandbox = Sandbox::new("tiny");
    let film = "film scene.safetensors cameras.json --backend cpu -o out --frames 2";
    for name in ["out/0000.png", "out/mine.png"] {
        sandbox.write(name, "mine");
    }
    for words in [WHOLE, film] {
        sandbox.assert_refuses(words, &["out has other files, such as ", "--overwrite"]);
        sandbox.run(&format!("{words} --overwrite")).assert_ok();
        assert_eq!(sandbox.read("out/mine.png"), b"mine");
    }
    let image = sandbox.read("out/0000.png");
    assert!(image.starts_with(b"\x89PNG"), "the image is not replaced");
}
