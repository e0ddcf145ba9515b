//! Finding photographs and masks.

use std::fs;

use super::colmap_files::{self, sample};
use super::*;

fn load_with(path: &Path, edit: impl FnOnce(&mut DatasetOptions)) -> Result<Dataset> {
    let mut options = in_the_world();
    edit(&mut options);
    Dataset::load(path, &options)
}

/// Two photographs of 6 x 4 pixels, with an edited `file_path`.
fn renamed(edit: impl Fn(&str) -> String) -> TempDir {
    let mut file = transforms(2);
    let folder = nerfstudio_folder(&file);
    for frame in file["frames"].as_array_mut().unwrap() {
        frame["file_path"] = json!(edit(frame["file_path"].as_str().unwrap()));
    }
    write_json(&folder.path().join("transforms.json"), &file);
    folder
}

#[test]
fn paths_may_begin_above_the_data_set() {
    let long = "a/".repeat(500_000);
    for prefix in ["data/fox/", "../fox/", "/home/nobody/fox/", "./a/../", &long] {
        let folder = renamed(|name| format!("{prefix}{name}"));
        let dataset = load(folder.path()).unwrap();
        assert_eq!((dataset.frames.len(), dataset.missing.len()), (2, 0), "{prefix:.20}");
        assert_eq!(dataset.frames[1].image.color(0, 0)[0], 1.0 / 255.0);
    }
}

/// Names of files repeat from camera to camera, so the folder must match.
#[test]
fn a_tail_has_a_folder() {
    let folder = renamed(|name| name.replace("images/", "left/"));
    fs::rename(folder.path().join("images/0.png"), folder.path().join("0.png")).unwrap();
    assert_refused(folder.path(), &[&folder.path().join("left/0.png").display().to_string()]);
}

#[test]
fn smaller_photographs_are_used_if_they_are_there() {
    let folder = nerfstudio_folder(&transforms(2));
    // 6 x 4 at 4 is 1.5 x 1.
    for index in 0..2 {
        write_image(&folder.path().join(format!("images_4/{index}.png")), [2, 1], [90, 91, 92]);
    }
    let dataset = load_with(folder.path(), |options| options.downscale = 4).unwrap();
    assert_eq!(dataset.prepared, 2);
    let frame = &dataset.frames[1];
    assert_eq!(
        (frame.name.as_str(), frame.image.pixels()),
        ("images/1.png", &[[90, 91, 92]; 2][..])
    );
    let Camera { fl_x, fl_y, cx, cy, width, height, .. } = frame.camera;
    assert_eq!(([width, height], [fl_x, cx]), ([2, 1], [8.0 / 3.0, 3.25 / 3.0]));
    assert_eq!([fl_y, cy], [9.0 / 4.0, 1.75 / 4.0]);
    // For another factor, the whole photographs are read.
    let dataset = load_with(folder.path(), |options| options.downscale = 2).unwrap();
    assert_eq!((dataset.prepared, dataset.frames[1].image.color(0, 0)[0]), (0, 1.0 / 255.0));
    // The smaller photographs alone are enough. Without the factor, the message says so.
    fs::remove_dir_all(folder.path().join("images")).unwrap();
    assert_eq!(load_with(folder.path(), |options| options.downscale = 4).unwrap().frames.len(), 2);
    assert_refused(folder.path(), &["images_4 is there", "--downscale 4"]);
    write_image(&folder.path().join("images_4/0.png"), [3, 1], [0; 3]);
    let result = load_with(folder.path(), |options| options.downscale = 4);
    assert_facts(result, &["images_4/0.png", "3 x 1", "6 x 4", "4 times smaller"]);
}

/// A mask with a black left half.
fn half(path: &Path, [width, height]: [u32; 2]) {
    let _ = fs::create_dir_all(path.parent().unwrap());
    let pixel = |x: u32, _| image::Luma([if x < width / 2 { 0 } else { 1 }]);
    image::GrayImage::from_fn(width, height, pixel).save(path).unwrap();
}

fn assert_half(photograph: &Photograph) {
    let width = photograph.width();
    let height = photograph.height();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        assert_eq!(photograph.is_valid(x, y), x >= width / 2, "{x},{y}");
    }
}

#[test]
fn masked_pixels_are_not_valid() {
    let mut file = transforms(3);
    file["frames"][0]["mask_path"] = json!("elsewhere/m.png");
    let folder = nerfstudio_folder(&file);
    assert_facts(load(folder.path()), &["elsewhere/m.png", "no such file"]);
    half(&folder.path().join("elsewhere/m.png"), [6, 4]);
    half(&folder.path().join("masks/1.png.png"), [6, 4]);
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.masked, 2);
    assert_half(&dataset.frames[0].image);
    assert_half(&dataset.frames[1].image);
    assert!(dataset.frames[2].image.all_valid());
    // A smaller pixel is valid if its whole square is.
    let dataset = load_with(folder.path(), |options| options.downscale = 2).unwrap();
    let valid: Vec<_> = (0..3).map(|x| dataset.frames[0].image.is_valid(x, 0)).collect();
    assert_eq!(valid, [false, false, true]);
    // The fingerprint includes masks.
    half(&folder.path().join("masks/1.png.png"), [6, 4]);
    let before = load(folder.path()).unwrap().fingerprint;
    write_image(&folder.path().join("masks/1.png.png"), [6, 4], [255; 3]);
    assert_eq!(load(folder.path()).unwrap().fingerprint.difference(&before), Some("photographs"));
    // A black mask hides a photograph whole. Something must be left.
    write_image(&folder.path().join("masks/1.png.png"), [6, 4], [0; 3]);
    let dataset = load_with(folder.path(), |options| options.hold_out_every = 0).unwrap();
    assert_eq!((&*dataset.train, dataset.frames.len()), (&[0, 2][..], 3));
    let [note] = &*dataset.notes else { panic!("{:?}", dataset.notes) };
    assert!(note.contains("1 of 3 photographs") && note.contains("images/1.png"), "{note}");
    write_image(&folder.path().join("masks/2.png.png"), [6, 4], [0; 3]);
    assert_refused(folder.path(), &["nothing is left to train on", "a mask is black"]);
    half(&folder.path().join("masks/1.png.png"), [5, 4]);
    assert_refused(folder.path(), &["masks/1.png.png", "5 x 4"]);
}

/// What programs call the mask of `images/sub/a.jpg`, and what it is not.
#[test]
fn masks_are_found_by_the_names_of_all_programs() {
    for (name, is_mask) in [
        ("masks/sub/a.jpg.png", true),
        ("masks/sub/a.png", true),
        ("masks/sub/a.jpg", true),
        ("masks/sub/a.JPG", true),
        ("masks/sub/a_mask.png", true),
        ("mask/sub/a.jpg.mask.png", true),
        (".mask/sub/a.png", true),
        ("images/sub/a.jpg.mask.png", true),
        ("images/sub/a.mask.jpeg", true),
        ("images/sub/a_mask.PNG", true),
        ("images/sub/dynamic_mask_a.png", true),
        ("masks/a.png", false),
        ("masks/sub/ab.png", false),
        ("masks_2/sub/a.png", false),
        ("images/sub/a.png", false),
        ("images/sub/a.jpg.texture.png", false),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        write_image(&path, [1, 1], [0; 3]);
        let found = masks::mask_of(folder.path(), Path::new("images/sub/a.jpg"), "");
        assert_eq!(found, is_mask.then_some(path.clone()), "{name}");
        let photographs = ["a.jpg", "ab.jpg"].map(Path::new);
        let is_beside = is_mask && name.starts_with("images/");
        let name_says =
            name.starts_with("images/") && masks::is_mask(&path, photographs.into_iter());
        assert_eq!(name_says, is_beside, "{name}");
    }
}

/// Gray levels with alpha, and whether each hides: 0 and 255, a label, a matte, JPEG's noise, alpha, black paint.
#[test]
fn masks_hide_below_half_of_their_white() {
    let opaque = |levels: &[u8]| levels.iter().map(|&level| [level, 255]).collect::<Vec<_>>();
    let cases = [
        ("a.png", opaque(&[0, 127, 128, 255]), "##.."),
        ("a.png", opaque(&[0, 1, 1, 0]), "#..#"),
        ("a.png", opaque(&[0, 38, 38, 0]), "#..#"),
        ("a.png", opaque(&[3, 255, 3, 255]), "#.#."),
        ("a.png", opaque(&[1, 1]), ".."),
        ("a.png", opaque(&[0, 0]), "##"),
        ("a.png", opaque(&[29, 0, 226, 255]), "##.."),
        ("a.png", vec![[255, 0], [255, 255], [255, 3]], "#.#"),
        ("a.png", vec![[0, 0], [9, 255], [200, 255]], "#.."),
        ("a.png", vec![[0, 255], [0, 0]], "#."),
        ("dynamic_mask_a.png", opaque(&[0, 255, 255]), ".##"),
        ("dynamic_mask_a.png", opaque(&[0, 0]), ".."),
    ];
    let folder = tempfile::tempdir().unwrap();
    for (name, levels, expected) in cases {
        let path = folder.path().join(name);
        let size = [levels.len() as u32, 1];
        let pixel = |x: u32, _| image::LumaA(levels[x as usize]);
        image::GrayAlphaImage::from_fn(size[0], 1, pixel).save(&path).unwrap();
        let mask = decode::decode(&fs::read(&path).unwrap(), size, &path, decode::MASK).unwrap();
        let found: String =
            masks::used(&mask, &path).map(|used| if used { '.' } else { '#' }).collect();
        assert_eq!(found, expected, "{levels:?}");
    }
}

#[test]
fn masks_that_hide_nothing_or_fit_nothing_are_noted() {
    let folder = nerfstudio_folder(&transforms(3));
    let notes = || load(folder.path()).unwrap().notes;
    write_image(&folder.path().join("masks/9.png"), [6, 4], [0; 3]);
    assert!(notes()[0].contains("no file in"), "{:?}", notes());
    write_image(&folder.path().join("masks/1.png"), [6, 4], [254; 3]);
    assert!(notes()[0].contains("no mask hides anything, such as"), "{:?}", notes());
    assert_eq!(load(folder.path()).unwrap().masked, 0);
}

/// The user meant a mask: a photograph without one would show what it hides.
#[cfg(unix)]
#[test]
fn a_mask_that_is_no_file_is_refused() {
    let folder = nerfstudio_folder(&transforms(2));
    fs::create_dir(folder.path().join("masks")).unwrap();
    let mask = folder.path().join("masks/1.png.png");
    let _socket = std::os::unix::net::UnixListener::bind(mask).expect("a special file");
    assert_refused(folder.path(), &["masks/1.png.png", "expected a regular file"]);
}

#[test]
fn masks_of_colmap_and_of_smaller_photographs() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    let mut model = sample();
    model.cameras.iter_mut().for_each(|camera| camera.1 = ("SIMPLE_PINHOLE", 0));
    model.cameras.iter_mut().for_each(|camera| camera.3 = vec![100.0, 32.0, 24.0]);
    colmap_files::write(root, &model, true);
    half(&root.join("masks/sub/c.png.png"), [64, 48]);
    let dataset = load(root).unwrap();
    assert_half(&dataset.frames[2].image);
    assert!(dataset.frames[0].image.all_valid());
    // A smaller photograph without its mask must not be used.
    write_image(&root.join("images_2/sub/c.png"), [32, 24], [1; 3]);
    let smaller = || load_with(root, |options| options.downscale = 2).unwrap();
    assert_eq!(smaller().prepared, 0);
    assert_half(&smaller().frames[2].image);
    half(&root.join("masks_2/sub/c.png"), [32, 24]);
    assert_eq!(smaller().prepared, 1);
    assert_half(&smaller().frames[2].image);
    assert_eq!(smaller().frames[2].image.color(20, 0), [1.0 / 255.0; 3]);
}

#[test]
fn alpha_can_be_a_mask() {
    let folder = nerfstudio_folder(&transforms(2));
    let path = folder.path().join("images/0.png");
    let pixel = |x: u32, _| image::Rgba([200, 100, 50, [0, 127, 128, 255, 255, 255][x as usize]]);
    image::RgbaImage::from_fn(6, 4, pixel).save(path).unwrap();
    let dataset = load_with(folder.path(), |options| options.alpha = Alpha::Mask).unwrap();
    let photograph = &dataset.frames[0].image;
    let valid: Vec<_> = (0..6).map(|x| photograph.is_valid(x, 0)).collect();
    assert_eq!(valid, [false, false, true, true, true, true]);
    // A used pixel has its own color, without a part of the background.
    assert_eq!(photograph.pixels()[2], [200, 100, 50]);
    assert!(dataset.frames[1].image.all_valid());
    assert!(load(folder.path()).unwrap().frames[0].image.all_valid());
}

/// Photographs that are there, but not where the data set says, and poses of a kind that is not read.
#[test]
fn photographs_in_another_folder_are_named() {
    let folder = nerfstudio_folder(&transforms(2));
    let root = folder.path();
    let move_to = format!("move them to {}", root.join("images").display());
    let below = root.join("poses");
    fs::create_dir(&below).unwrap();
    fs::copy(root.join("transforms.json"), below.join("transforms.json")).unwrap();
    assert_refused(&below, &["of these names are in", "poses/../images: move"]);
    fs::rename(root.join("images"), root.join("photos")).unwrap();
    let photos = root.join("photos").display().to_string();
    assert_refused(root, &["none of the 2 photographs", &photos, &move_to]);
    for name in ["0.png", "1.png"] {
        fs::rename(root.join("photos").join(name), root.join(name)).unwrap();
    }
    let beside = format!("of these names are in {}", root.display());
    assert_refused(root, &[&beside, &move_to]);
    let mut file = transforms(2);
    for name in ["/home/nobody/fox/images/0.png", "D:\\fox\\images\\0.png"] {
        file["frames"][0]["file_path"] = json!(name);
        write_json(&root.join("transforms.json"), &file);
        assert_refused(root, &[&beside, &move_to]);
    }
    assert_refused(&root.join("transforms.json"), &[&beside, &move_to]);
    fs::remove_file(root.join("transforms.json")).unwrap();
    fs::write(root.join("poses_bounds.npy"), "").unwrap();
    assert_refused(root, &["LLFF", "poses_bounds.npy", "organza capture"]);
}

/// What a folder has that is no data set, and what to do with it.
#[test]
fn other_sources_are_pointed_to() {
    for (name, content, facts) in [
        ("walk.MOV", "", ["this folder has a video", "walk.MOV -o NEW"]),
        ("metadata.json", r#"{"poses": []}"#, ["Record3D", "ns-process-data record3d"]),
        ("metadata.json", r#"{"a": 1}"#, ["no data set", "transforms.json"]),
        ("a.tiff", "", ["no data set", "TIFF, AVIF"]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(name), content).unwrap();
        assert_refused(folder.path(), &facts);
    }
    let folder = nerfstudio_folder(&transforms(1));
    let image = folder.path().join("images/0.png");
    fs::rename(&image, image.with_extension("tif")).unwrap();
    assert_refused(folder.path(), &["images/0.tif is there", "convert them to JPEG first"]);
}

#[test]
fn a_data_set_within_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    let dense = root.join("dense/0");
    colmap_files::write(&dense, &sample(), true);
    assert_refused(root, &["no data set", &dense.display().to_string()]);
    // The sparse model is above the photographs.
    colmap_files::write_model(&root.join("sparse/0"), &sample(), true);
    assert_refused(root, &["none of the 3 photographs", &dense.display().to_string()]);
}
