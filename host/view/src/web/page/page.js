// Elements and messages of the page.

/**
 * @typedef {object} Elements The elements of body.html, by their ids.
 * @property {HTMLElement} stage
 * @property {HTMLCanvasElement} view
 * @property {HTMLElement} poster
 * @property {HTMLElement} status
 * @property {HTMLElement} quality
 * @property {HTMLElement} far
 * @property {HTMLElement} numbers
 * @property {HTMLElement} message
 * @property {HTMLButtonElement} full-button
 * @property {HTMLButtonElement} help-button
 * @property {HTMLDialogElement} help
 */

/**
 * An element of the page by its id.
 * @type {<Id extends keyof Elements>(id: Id) => Elements[Id]}
 */
export const $ = (id) => /** @type {any} */ (document.getElementById(id));

/**
 * Shows a message, or none.
 * @param {string | null} message
 */
export function say(message) {
  $("message").hidden = !message;
  $("message").textContent = message ?? "";
}

/** @param {unknown} error */
export const reasonOf = (error) => (error instanceof Error ? error.message : String(error));

// Ends the page with a reason.
export class Missing extends Error {}

// Whether another page shows this one.
export const EMBEDDED = new URLSearchParams(location.search).has("embed");

export function fullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.();
}
