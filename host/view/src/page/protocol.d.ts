/** What the page and the program send each other. A test compares it with what the program sends. */

/** Three coordinates, or a color. */
export type Vector = number[];

/** Column and row. */
export type Pixel = number[];

/** A camera-to-world matrix with OpenGL axes, row by row. */
export type Pose = number[][];

export interface Camera {
  file_path?: string;
  w: number;
  h: number;
  fl_x: number;
  fl_y: number;
  cx: number;
  cy: number;
  camera_to_world: Pose;
}

/** Where a scene lies in the world. */
export interface Placement {
  offset: Vector;
  scale: number;
  up: Vector;
  right: Vector;
  meters?: number | null;
}

export type Mode = "color" | "visibility" | "weight" | "depth" | "normal" | "gaussians" | "error";

/** A camera of the data set. */
export interface View {
  name: string;
  held_out: boolean;
  camera: Camera;
}

/** GET scene.json */
export interface Scene {
  title: string;
  version: string;
  device: string;
  gaussians: number;
  /** Scenes that are shown together. */
  scenes: number;
  aabb: Vector[];
  placement: Placement;
  step: number;
  background: Vector;
  up: Vector;
  /** What the camera goes around at first. */
  center: Vector;
  home: Camera;
  views: View[];
  /** Whether there are any of the views. */
  photographs: boolean;
  /** Number of points. */
  points: number;
  purpose: "look" | "edit" | "train";
  /** Modes, and the colors of their scales. */
  modes: [Mode, string[] | null][];
}

export type Quality = "moving" | "still" | "exact";

/** POST frame */
export interface FrameRequest {
  /** A random number of the page. */
  client: number;
  sequence: number;
  quality: Quality;
  camera: Camera;
  mode: Mode;
  background: Vector | null;
  /** The view whose photograph is compared. */
  view: number | null;
}

/** The header x-organza of a frame */
export interface FrameAbout {
  sequence: number;
  quality: Quality;
  mode: Mode;
  size: number[];
  /** Number of changes to what is shown. */
  version: number;
  milliseconds: number;
  gaussians: number;
  pairs: number;
  /** Tile intersections. */
  members: number;
  /** Pairs whose T was found anew. */
  renewed: number;
  samples: number;
  /** Length of T's steps, in those of the scene. */
  steps: number;
  /** Of a split: blocks that are shown, those that could not be read, and all. */
  blocks: number[] | null;
  /** The values at both ends of the scale. */
  range: number[] | null;
}

/** POST explain */
export interface PixelRequest {
  camera: Camera;
  pixel: Pixel;
}

/** A Gaussian of a pixel. */
export interface Contribution {
  gaussian: number;
  distance: number;
  falloff: number;
  opacity: number;
  samples: number;
  transmittance: number;
  alpha: number;
  color: Vector;
  color_sum: Vector;
  alpha_sum: number;
  mean2d: Pixel;
  depth: number;
  conic: Vector;
  /** The ray in the unit cube. */
  places: Vector[];
  /** T from the Gaussian to the end of each step. */
  transmittances: number[];
}

/** The answer to PixelRequest */
export interface Explanation {
  pixel: Pixel;
  /** Number of all Gaussians, of which `gaussians` are the heaviest. */
  all: number;
  gaussians: Contribution[];
  color_sum: Vector;
  alpha_sum: number;
  background: Vector;
  divided: boolean;
  color: Vector;
  color_8_bit: number[];
}

/** POST edit */
export type EditRequest =
  | "look" | "clear" | "remove" | "keep" | "undo" | "save"
  | { crop: { low: Vector; high: Vector; outside: boolean } }
  | { paint: { camera: Camera; places: Pixel[]; radius: number } }
  | { clean: number }
  | { meters: number };

/** What the floaters' slider hides. */
export interface Clean {
  /** Views that were looked at, of this many. */
  seen: number;
  views: number;
  hidden: number;
  /** Their share of the views' pixels. */
  weight: number;
}

/** The answer to EditRequest */
export interface EditAnswer {
  left: number;
  selected: number;
  /** Of selected Gaussians. */
  places: Vector[];
  removals: number;
  clean: Clean;
  saved: string | null;
}

/** POST path */
export interface PathRequest {
  keyframes: Camera[];
  loop: boolean;
  frames: number;
}

/** The answer to PathRequest, and to POST keyframes, which sends a file */
export interface Cameras {
  cameras: Camera[];
}

/** A scene's place among others, in world units and degrees. */
export interface Place {
  offset: Vector;
  turn: Vector;
  scale: number;
}

/** POST places; null only asks */
export interface PlaceRequest {
  scene: number;
  place: Place;
}

/** The answer to PlaceRequest is a list of these */
export interface PlacedScene {
  name: string;
  place: Place;
  /** A ball around it, in the first scene's coordinates. */
  center: Vector;
  radius: number;
}

/** POST training */
export type TrainingCommand = "pause" | "go" | "step" | "stop";

export interface Curve {
  step: number[];
  loss: (number | null)[];
  psnr: (number | null)[];
}

export interface Evaluations {
  step: number[];
  psnr: (number | null)[];
}

/** GET training.json */
export interface TrainingState {
  step: number;
  steps: number;
  seconds: number;
  gaussians: number;
  paused: boolean;
  stopping: boolean;
  /** Part of the time that images took. */
  share: number;
  curve: Curve;
  evaluations: Evaluations;
}
