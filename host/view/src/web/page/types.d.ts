/** What the program writes into a page. A test compares it with a page. */

import type { Camera, Placement, Pose, Vector } from "../../page/protocol";

/** The name of a kernel, its code, and the access of each binding. */
export interface Kernel {
  name: string;
  access: ("uniform" | "read" | "write")[];
  code: string;
}

/** `[word of the parameters, buffer of counts, place, first, largest]` */
export type CountRow = [number, number, number, number, number];

/** Part of a buffer: `[buffer, begin, bytes]` */
export type BufferPart = [number, number, number];

export type Dispatch = [string, number[], CountRow[], BufferPart[], [number, number, number]];
export type Clear = ["clear", ...BufferPart];
/** `[from, begin, bytes, to, at]` */
export type Copy = ["copy", ...BufferPart, number, number];
export type Publish = ["publish"];

/** A frame that the page replays. */
export interface Plan {
  tiles: number;
  side: number;
  /** Length of T's steps, in those of the scene. */
  steps: number;
  /** The room for each of the counts. */
  capacity: number[];
  /** Lengths of the plan's own buffers, which are numbered after the scene's. */
  buffers: number[];
  /** Buffers with content, as words. */
  contents: [number, number[]][];
  /** A buffer with the camera for each scene, and the scene's place. */
  cameras: [number, Placement][];
  /** Buffers with the places of tiles. */
  places: number[];
  counts: number;
  image: number;
  frame: (Dispatch | Clear | Copy | Publish)[];
}

export interface Header {
  title: string;
  version: string;
  gaussians: number;
  aabb: Vector[];
  background: Vector;
  up: Vector;
  center: Vector;
  home: Camera;
  /** The eyes of the slow turn. */
  way: Vector[];
  /** Where photographs were taken. */
  poses: Pose[];
  /** The length of each buffer of the scene, in bytes. */
  buffers: number[];
  kernels: Kernel[];
  plans: Plan[];
}

/** What `unpack` gives. */
export interface Content {
  header: Header;
  buffers: Uint8Array<ArrayBuffer>[];
}

declare global {
  /** The packed content. */
  const ORGANZA_SCENE: string;
}
