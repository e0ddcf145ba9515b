use glam::Vec3;
use muslin::math::length;
use organza_shaders::segment::contracted_ray;

#[test]
fn a_ray_too_short_to_square_has_no_long_direction() {
    for length_of_ray in [0.0, 1e-30, 1e-20, 0.5] {
        let ray = contracted_ray(Vec3::ZERO, Vec3::new(length_of_ray, 0.0, 0.0), 0.01);
        assert!(length(ray.direction) <= 1.0, "{} of {length_of_ray}", ray.direction);
    }
}
