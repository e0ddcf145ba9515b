use organza_shaders::hash_grid_backward::all;

/// The CPU's lanes do not look at flags, so no device here would skip one that is missing.
#[test]
fn one_corner_without_a_flag_is_not_all() {
    assert!(all([true; 8]));
    for corner in 0..8 {
        let mut are_set = [true; 8];
        are_set[corner] = false;
        assert!(!all(are_set));
    }
}
