// The film of the keyframes' path: the program makes it, frame by frame, while the page waits.

import { post } from "./frames.js";
import { $, download } from "./page.js";

const NAMES = { mp4: ["MP4", "video/mp4", "mp4"], png: ["animated PNG", "image/apng", "png"] };

export class Film {
  // `path()` is what to film: keyframes, whether they are a loop, and the number of frames.
  constructor(view, rate, path) {
    Object.assign(this, { view, rate, path, abort: null });
    for (const kind of view.scene.films) $("film-kind").append(new Option(NAMES[kind][0], kind));
    $("film").onclick = () => (this.abort ? this.abort.abort() : this.make());
  }

  async make() {
    const [, type, ending] = NAMES[$("film-kind").value];
    this.abort = new AbortController();
    this.show("waiting", 0);
    $("film").textContent = "Cancel";
    fail("");
    try {
      const { mode, background, scene } = this.view;
      const request = { path: this.path(), kind: $("film-kind").value, fps: this.rate, mode, background };
      const reply = await post("/film", request, this.abort.signal);
      const film = await this.receive(reply.body.getReader());
      this.film = new Blob(film, { type });
      download(this.film, `${scene.title}.${ending}`);
    } catch (error) {
      if (error.name !== "AbortError") fail(error.message);
    }
    this.abort = null;
    $("film").textContent = "Make film";
    $("film-progress").hidden = true;
  }

  // Lines of JSON say how far it is; after the last of them come the film's bytes.
  async receive(reader) {
    let rest = new Uint8Array(), film = null, got = 0, size = 0;
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      if (film) {
        film.push(value);
        got += value.length;
        continue;
      }
      const joined = new Uint8Array(rest.length + value.length);
      joined.set(rest);
      joined.set(value, rest.length);
      rest = joined;
      for (let end; !film && (end = rest.indexOf(10)) >= 0; rest = rest.slice(end + 1)) {
        const said = JSON.parse(new TextDecoder().decode(rest.slice(0, end)));
        if (said.error) throw new Error(said.error);
        if (said.bytes === undefined) this.tell(said);
        else [film, size] = [[], said.bytes];
      }
      if (film) {
        film.push(rest);
        got = rest.length;
      }
    }
    if (!film || got !== size) throw new Error("The film has broken off. Is the program still running?");
    return film;
  }

  tell({ frame, frames }) {
    this.show(frame < frames ? `frame ${frame + 1} of ${frames}` : "encoding", frame / frames);
  }

  show(text, part) {
    $("film-progress").hidden = false;
    $("film-said").textContent = text;
    $("film-bar").firstElementChild.style.width = `${100 * part}%`;
  }
}

function fail(message) {
  $("message").hidden = !message;
  $("message").textContent = message;
}
