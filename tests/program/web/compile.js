// Compiles kernels on a device with the limits that all have; gives what went wrong.
async (kernels) => {
  const adapter = await navigator.gpu.requestAdapter();
  const device = await adapter.requestDevice();
  const type = { uniform: "uniform", read: "read-only-storage", write: "storage" };
  const failures = await Promise.all(kernels.map(async ({ name, access, code }) => {
    try {
      const entries = access.map((kind, binding) => ({ binding, visibility: GPUShaderStage.COMPUTE, buffer: { type: type[kind] } }));
      const layout = device.createPipelineLayout({ bindGroupLayouts: [device.createBindGroupLayout({ entries })] });
      const module = device.createShaderModule({ code });
      await device.createComputePipelineAsync({ layout, compute: { module, entryPoint: name } });
    } catch (error) {
      return `${name}: ${error.message}`;
    }
  }));
  return failures.filter(Boolean);
}
