//! Several scenes in one picture: arguments and places.

use crate::sandbox::Sandbox;

const PLACE: &str = r#"{"offset": [0.2, 0, 0.1], "turn": [0, 0, 40], "scale": 0.5}"#;
const RENDER: &str = "render scene.safetensors b.safetensors@place.json cameras.json --backend cpu";

/// A scene, another one, and its place.
fn two() -> Sandbox {
    let sandbox = Sandbox::new("basic");
    sandbox.copy_file("scene.safetensors", "b.safetensors");
    sandbox.write("place.json", PLACE);
    sandbox
}

#[test]
fn a_scene_stands_beside_another() {
    let sandbox = two();
    sandbox.run(&format!("{RENDER} -o a")).assert_ok();
    sandbox.run("render scene.safetensors cameras.json -o alone --backend cpu").assert_ok();
    let [both, alone] = ["a", "alone"].map(|folder| sandbox.images(folder));
    assert!(both != alone, "the second scene has no effect");
    // an `@` in a folder's name
    sandbox.write("x@y.com/place.json", PLACE);
    sandbox.copy_file("scene.safetensors", "x@y.com/b.safetensors");
    let at = "x@y.com/b.safetensors@x@y.com/place.json";
    let words = RENDER.replace("b.safetensors@place.json", at);
    sandbox.run(&format!("{words} -o at")).assert_ok();
    assert!(sandbox.images("at") == both, "another place");
    let film = RENDER.replace("render", "film");
    sandbox.run(&format!("{film} -o film --frames 2")).assert_ok();
    assert_eq!(sandbox.images("film").len(), 2);
    let words = "view scene.safetensors b.safetensors@place.json --edit c.safetensors";
    sandbox.assert_refuses(words, &["`--edit` takes one scene"]);
}

#[test]
fn bad_places_are_refused() {
    let sandbox = two();
    let words = format!("{RENDER} -o out");
    for (place, facts) in [
        (r#"{"scale": 0}"#, ["place.json: `scale` is 0", "expected a positive"]),
        (r#"{"scale": -1e-3}"#, ["place.json", "`scale` is -0.001"]),
        (r#"{"scale": 1e-300}"#, ["place.json: `scale` is", "expected 1e-9 to 1e9"]),
        (r#"{"offset": [0, NaN, 0]}"#, ["place.json", "JSON has no NaN"]),
        (r#"{"offset": [0, 1e999, 0]}"#, ["place.json", "out of range"]),
        (r#"{"offset": [0, 1e300, 0]}"#, ["place.json: `offset` is", "too far"]),
        (r#"{"turn": [0, 90]}"#, ["place.json", "array of length 3"]),
        (r#"{"rotate": [0, 0, 90]}"#, ["unknown field `rotate`", "`offset`, `turn`, `scale`"]),
        ("3", ["place.json", "this is no place of a scene"]),
        ("{", ["place.json", "line 1"]),
    ] {
        sandbox.write("place.json", place);
        sandbox.assert_refuses(&words, &facts);
    }
    sandbox.remove("place.json");
    sandbox.assert_refuses(&words, &["place.json", "no such file"]);
    sandbox.write("place.json", "{}");
    let with = |others: &str| format!("render scene.safetensors {others} -o out --backend cpu");
    for (words, facts) in [
        (with("none.safetensors@place.json cameras.json"), ["none.safetensors", "no such file"]),
        (
            with("cameras.json@place.json cameras.json"),
            ["cameras.json", "this is a file of cameras"],
        ),
        (with("cameras.json b.safetensors"), ["cameras can be named once", "@PLACE.json"]),
        (with("b@c.com/none.json"), ["cannot read b@c.com/none.json", "no such file"]),
        (with("b.safetensors@place.json"), ["scene.safetensors", "name the data set"]),
    ] {
        sandbox.assert_refuses(&words, &facts);
    }
}
