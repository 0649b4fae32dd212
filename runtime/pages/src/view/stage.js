// The picture: one canvas behind all panels, each of which shows a life.
import { Color, WebGLRenderer } from "three";
import { sky } from "./colours.js";
import { FollowingCamera } from "./camera.js";
import { LifeScene, radiusOf } from "./scene.js";

// ms. Frames that take longer than this on average are drawn with fewer pixels.
const slow = 24;
const judged = 40; // frames

// Nothing where the browser has no WebGL. Asked for here, and not by three,
// which would complain on the console.
export function contextOf(canvas) {
  return canvas.getContext("webgl2", { antialias: true, stencil: true, alpha: false, powerPreference: "high-performance" });
}

export class Stage {
  // `surfaces`: an element a life, over the canvas, that takes the pointer.
  constructor(canvas, context, lives, surfaces) {
    this.canvas = canvas;
    this.surfaces = surfaces;
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.setClearColor(new Color(sky));
    this.renderer.setScissorTest(true);
    this.ratio = Math.min(devicePixelRatio, 2);
    this.frames = [];
    this.isStale = true;
    this.isLinked = true;
    // The same for all, so that sizes can be compared.
    const distance = 3.1 * Math.max(...lives.map(radiusOf));
    this.scenes = lives.map((life) => new LifeScene(life));
    this.cameras = surfaces.map((surface) => new FollowingCamera(surface, distance, (camera) => this.#turned(camera)));
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
    this.#resize();
  }

  #turned(camera) {
    this.isStale = true;
    if (!this.isLinked) return;
    const offset = camera.offset();
    for (const other of this.cameras) if (other !== camera) other.setOffset(offset);
  }

  #resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    const whole = this.canvas.getBoundingClientRect();
    this.panes = this.surfaces.map((surface, i) => {
      const pane = surface.getBoundingClientRect();
      this.cameras[i].setAspect(pane.width / Math.max(pane.height, 1));
      return [pane.left - whole.left, whole.bottom - pane.bottom, pane.width, pane.height];
    });
    this.isStale = true;
  }

  forEachCamera(change) {
    this.cameras.forEach(change);
    this.isStale = true;
  }

  // Puts life `i` to `age` s of the season.
  pose(i, season, age) {
    const { target, isNew } = this.scenes[i].pose(season, age);
    this.cameras[i].follow(target, isNew);
    this.isStale = true;
  }

  // Draws if anything changed; gives whether it did.
  draw() {
    if (!this.isStale) return false;
    this.isStale = false;
    this.panes.forEach((pane, i) => {
      const camera = this.cameras[i];
      this.scenes[i].fade(camera.offset().length());
      this.renderer.setViewport(...pane);
      this.renderer.setScissor(...pane);
      this.renderer.render(this.scenes[i].scene, camera.camera);
    });
    return true;
  }

  // Slow machines get fewer pixels, down to one a point of the page.
  judge(milliseconds) {
    this.frames.push(milliseconds);
    if (this.frames.length < judged) return;
    const mean = this.frames.reduce((a, b) => a + b) / judged;
    this.frames = [];
    if (mean < slow || this.ratio <= 1) return;
    this.ratio = 1;
    this.#resize();
  }

  // What is shown now, for a file.
  picture() {
    this.isStale = true;
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}
