// What every part of the page uses.

export const $ = (id) => document.getElementById(id);

export const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

export function download(blob, name) {
  const link = element("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// A canvas of the screen's pixels, whose units are CSS pixels.
export function sharp(canvas, height) {
  const width = canvas.parentElement.clientWidth, dense = devicePixelRatio || 1;
  Object.assign(canvas, { width: width * dense, height: height * dense });
  canvas.style.height = `${height}px`;
  const context = canvas.getContext("2d");
  context.scale(dense, dense);
  return [context, width];
}

// The color of a value of 0 to 1.
export function rampColor(ramp, value) {
  return ramp[Math.round(Math.min(1, Math.max(0, value)) * (ramp.length - 1))];
}
