// The page: opens the scene on a GPU, and shows it.

import { Controls } from "./controls.js";
import { $, EMBEDDED, Missing, fullScreen, reasonOf, say } from "./page.js";
import { Player, unpack } from "./player.js";
import { Viewer } from "./viewer.js";

/** @type {(what: string) => string} */
const picture = (what) => `This is a picture. To turn the scene, ${what}`;

async function openDevice() {
  if (!navigator.gpu) {
    const where = isSecureContext
      ? "open it in a browser with WebGPU: a current Chrome, Edge, Safari or Firefox."
      : "open the page over https: browsers offer WebGPU only there.";
    throw new Missing(picture(where));
  }
  const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
  if (!adapter) {
    throw new Missing(picture("this browser needs a GPU, and WebGPU found none: try another browser."));
  }
  return adapter.requestDevice();
}

if (EMBEDDED) document.documentElement.classList.add("embed");
$("full-button").hidden = !document.fullscreenEnabled;
$("full-button").onclick = fullScreen;
try {
  if (typeof ORGANZA_SCENE === "undefined") {
    throw new Missing(picture("the page needs scene.js beside it: copy the whole folder."));
  }
  const device = await openDevice();
  const content = await unpack(ORGANZA_SCENE);
  const { header } = content;
  const viewer = new Viewer(device, await Player.open(device, content), header);
  device.addEventListener("uncapturederror", ({ error }) => viewer.fail(error));
  device.lost.then(({ reason, message }) => {
    if (reason !== "destroyed") say(`The GPU was lost (${message}). Load the page again.`);
  });
  const [heading, facts] = $("help").children;
  heading.textContent = header.title;
  const count = new Intl.NumberFormat("en").format(header.gaussians);
  facts.textContent = `${count} Gaussians, rendered on this device by organza ${header.version}`;
  $("help-button").onclick = () => $("help").showModal();
  viewer.controls = new Controls($("view"), viewer);
  for (const event of ["pointerdown", "keydown", "wheel"]) {
    const touch = () => (event === "wheel" && viewer.leavesWheel()) || viewer.touch();
    addEventListener(event, touch, { passive: true });
  }
  viewer.start();
  new ResizeObserver(() => viewer.resize()).observe($("stage"));
  Object.assign(window, { organza: viewer });
} catch (error) {
  const isMissing = error instanceof Missing;
  $("status").hidden = $("help-button").hidden = true;
  $("message").classList.toggle("plain", isMissing);
  say(isMissing ? error.message : `The page could not start: ${reasonOf(error)}`);
}
document.documentElement.dataset.ready = "";
