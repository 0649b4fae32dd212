// The picture: one canvas behind all panels, each of which shows a life.
import { Color, LinearSRGBColorSpace, WebGLRenderer } from "three";
import { FollowingCamera } from "./camera.js";
import { sky } from "./colours.js";
import { LifeScene, radiusOf } from "./scene.js";

// Points of the picture a point of the page, each way: edges are smooth with
// two. (WebGL's own way to smooth them cannot be switched off when it is slow.)
const fineRatio = 2;
const roughRatio = 1;
// ms. Machines whose frames take longer on average draw roughly while anything
// moves; 50 frames a second is what recordings have.
const slow = 22;
const judged = 12; // frames
// ms without change after which a slow machine draws finely again.
const settling = 250;

const skyColour = new Color().setStyle(sky, LinearSRGBColorSpace);
const borderColour = new Color().setStyle("#c3ccd8", LinearSRGBColorSpace);

// Nothing where the browser has no WebGL. Asked for here, and not by three,
// which would complain on the console.
export function contextOf(canvas) {
  return canvas.getContext("webgl2", { antialias: false, stencil: true, alpha: false });
}

// Known by name, so that not even the first frames are slow.
function hasNoCard(context) {
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class Stage {
  // `surfaces`: an element a life, over the canvas, that takes the pointer.
  constructor(canvas, context, lives, surfaces) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // materials.js does it
    this.renderer.setClearColor(skyColour);
    this.renderer.setScissorTest(true);
    this.isSlow = hasNoCard(context);
    this.isRough = false; // of the picture that is shown
    this.changedAt = -Infinity; // ms
    this.frames = [];
    this.isLinked = true;
    this.retired = []; // scenes of lives before these
    this.scenes = [];
    this.surfaces = [];
    this.cameras = [];
    this.setLives(lives, surfaces);
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
  }

  // Other lives; where the surfaces stay the same, so does how one looks. To be
  // posed before the next frame.
  setLives(lives, surfaces) {
    // The same for all, so that sizes can be compared.
    const distance = 2.8 * Math.max(...lives.map(radiusOf));
    // Those that were not drawn yet have nothing that is worth waiting for.
    if (this.retired.length === 0) this.retired = this.scenes;
    else for (const scene of this.scenes) scene.dispose();
    this.scenes = lives.map((life) => new LifeScene(life));
    if (surfaces.length === this.surfaces.length && surfaces.every((surface, i) => surface === this.surfaces[i])) {
      for (const camera of this.cameras) camera.setDistance(distance);
      this.#change();
      return;
    }
    for (const camera of this.cameras) camera.dispose();
    this.surfaces = surfaces;
    this.cameras = surfaces.map((surface) => new FollowingCamera(surface, distance, (camera) => this.#turned(camera)));
    this.#resize();
  }

  #change() {
    this.isStale = true;
    this.changedAt = performance.now();
  }

  #turned(camera) {
    this.#change();
    if (!this.isLinked) return;
    const offset = camera.offset();
    for (const other of this.cameras) if (other !== camera) other.setOffset(offset);
  }

  #resize() {
    const whole = this.canvas.parentElement.getBoundingClientRect();
    this.size = [whole.width, whole.height];
    this.ratio = 0; // unlike any, so that it is set anew
    this.panes = this.surfaces.map((surface, i) => {
      const pane = surface.getBoundingClientRect();
      this.cameras[i].setAspect(pane.width / Math.max(pane.height, 1));
      return [pane.left - whole.left, whole.bottom - pane.bottom, pane.width, pane.height];
    });
    this.#change();
  }

  forEachCamera(change) {
    this.cameras.forEach(change);
    this.#change();
  }

  // Puts life `i` to `age` s of the season.
  pose(i, season, age) {
    const { target, isNew } = this.scenes[i].pose(season, age);
    this.cameras[i].follow(target, isNew);
    this.#change();
  }

  // Draws if there is anything to draw; gives whether it did. `now` in ms.
  draw(now) {
    const isSettled = now - this.changedAt > settling;
    if (!this.isStale && !(this.isRough && isSettled)) return false;
    this.#drawAll(this.isSlow && !isSettled);
    return true;
  }

  #drawAll(isRough) {
    this.isStale = false;
    this.isRough = isRough;
    const ratio = isRough ? roughRatio : fineRatio;
    if (ratio !== this.ratio) {
      this.ratio = ratio;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(...this.size, false);
    }
    this.#drawBorders();
    this.panes.forEach((pane, i) => {
      const camera = this.cameras[i];
      this.scenes[i].prepare(camera.offset().length(), isRough);
      this.renderer.setViewport(...pane);
      this.renderer.setScissor(...pane);
      this.renderer.render(this.scenes[i].scene, camera.camera);
    });
    // After the new ones were drawn, so that what both need is not made again.
    for (const scene of this.retired.splice(0)) scene.dispose();
  }

  // Between panels, where no pane is.
  #drawBorders() {
    if (this.panes.length === 1) return;
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(borderColour);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.renderer.setClearColor(skyColour);
  }

  // `milliseconds` since the last frame, while frames follow each other.
  judge(milliseconds) {
    this.frames.push(milliseconds);
    if (this.frames.length < judged) return;
    // The median: one frame that the browser was busy with tells nothing.
    const median = this.frames.sort((a, b) => a - b)[judged / 2];
    this.frames = [];
    this.isSlow ||= median > slow;
  }

  // What is shown now, for a file.
  picture() {
    this.#drawAll(false);
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}
