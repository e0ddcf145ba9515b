// What every part of the page uses.

/** @import { Elements } from "./elements" */

/**
 * An element of the page by its id.
 * @type {<Id extends keyof Elements>(id: Id) => Elements[Id]}
 */
export const $ = (id) => /** @type {any} */ (document.getElementById(id));

/** @param {string} name */
export const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Partial<HTMLElementTagNameMap[Tag]>} properties
 * @param {(Node | string)[]} children
 */
export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/**
 * @param {Blob} blob
 * @param {string} name
 */
export function download(blob, name) {
  const link = element("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/**
 * Shows a message over the image, or none.
 * @param {string | null} message
 */
export function tell(message) {
  $("message").hidden = !message;
  $("message").textContent = message ?? "";
}

/** @param {unknown} error */
export const reason = (error) => (error instanceof Error ? error.message : String(error));

/** @param {HTMLCanvasElement} canvas */
export const brush = (canvas) => /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));

/**
 * A canvas of the screen's pixels, whose units are CSS pixels. Gives what draws on it, and its width.
 * @param {HTMLCanvasElement} canvas
 * @param {number} height
 * @returns {[CanvasRenderingContext2D, number]}
 */
export function sharp(canvas, height) {
  const width = canvas.parentElement?.clientWidth ?? 0;
  const dense = devicePixelRatio || 1;
  Object.assign(canvas, { width: width * dense, height: height * dense });
  canvas.style.height = `${height}px`;
  const context = brush(canvas);
  context.scale(dense, dense);
  return [context, width];
}

/**
 * The color of a value of 0 to 1.
 * @param {string[]} ramp
 * @param {number} value
 */
export function rampColor(ramp, value) {
  return ramp[Math.round(Math.min(1, Math.max(0, value)) * (ramp.length - 1))];
}
