// What the page renders of a camera: pixels in base64, what they needed, and how many plans were too small.
async (camera, steps) => {
  const { side } = organza, tiles = Math.ceil(camera.w / side) * Math.ceil(camera.h / side);
  for (let small = 0; ; small++) {
    const found = await organza.pixels(camera, organza.pace.plan(tiles, steps));
    if (!found) continue;
    const pixels = await new Promise((done) => {
      const reader = new FileReader();
      reader.onload = () => done(reader.result.split(",")[1]);
      reader.readAsDataURL(new Blob([found.pixels]));
    });
    return { pixels, counts: found.counts, small };
  }
}
