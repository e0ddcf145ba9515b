use super::*;

#[test]
fn sizes_are_readable() {
    assert_eq!(format_bytes(12), "12 bytes");
    assert_eq!(format_bytes(1536), "1.50 KiB");
    assert_eq!(format_bytes(5 << 20), "5.00 MiB");
    assert_eq!(format_bytes(3 << 29), "1.50 GiB");
}

#[test]
fn memory_error_gives_both_sizes() {
    let error = DeviceError::OutOfMemory {
        needed: 3 << 30,
        available: Some(512 << 20),
        what: "the tile batch".to_owned(),
    };
    let text = error.to_string();
    assert!(text.contains("the tile batch needs 3.00 GiB"), "{text}");
    assert!(text.contains("512.00 MiB are available"), "{text}");
}

#[test]
fn json_error_points_at_the_text() {
    let text = b"{\n  \"levels\": [1, x]\n}";
    let error = serde_json::from_slice::<serde_json::Value>(text).unwrap_err();
    let error = Error::json(Path::new("a.json"), "JSON", text, &error).to_string();
    assert!(error.starts_with("a.json: JSON, line 2 column 17:"), "{error}");
    assert!(error.contains("\"levels\": [1, x"), "{error}");
    assert_eq!(error.matches("column").count(), 1, "{error}");
}
