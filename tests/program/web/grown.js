// Looks through a camera with plans that are too small at first: how many images the page has shown, and whether the last one's plan
// is a larger one.
async (camera) => {
  const { pace, screen } = organza, show = screen.show;
  let shown = 0;
  screen.show = (...images) => {
    shown += 1;
    return show.apply(screen, images);
  };
  Object.assign(organza, { camera });
  pace.level.clear();
  await organza.image("rest", organza.least, 1);
  screen.show = show;
  const { plan } = organza.shown;
  return { shown, grown: pace.ladder(plan.tiles, plan.steps).indexOf(plan) > 0 };
}
