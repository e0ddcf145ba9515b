@group(0) @binding(0) var<storage, read_write> gray: array<f32>;
@group(0) @binding(0) var<storage, read> bins: array<u32>;

@compute @workgroup_size(64)
fn fill(@builtin(global_invocation_id) id: vec3<u32>) {
    gray[id.x] = f32(id.x * id.x % 192) / 192;
}

@vertex
fn corner(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return vec4(f32(index & 1) * 4 - 1, f32(index & 2) * 2 - 1, 0, 1);
}

@fragment
fn pixel(@builtin(position) place: vec4<f32>) -> @location(0) u32 {
    return bins[u32(place.x)];
}
