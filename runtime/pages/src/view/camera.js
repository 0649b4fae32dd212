// One life's camera: turned and zoomed by mouse, touch and buttons, and moved
// along with the robot if it follows.
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

// From where one looks, relative to the robot: x right, y ahead, z up.
const directions = {
  behind: [0.62, -1, 0.62],
  side: [1, 0, 0.22],
  above: [0, -0.001, 1],
};
export const views = Object.keys(directions);

export class FollowingCamera {
  // `distance` in m; `ontoChange` is called when the user moved it.
  constructor(surface, distance, onChange) {
    this.distance = distance;
    this.camera = new PerspectiveCamera(38, 1, 0.02, 80);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, surface);
    this.controls.minDistance = 0.15;
    this.controls.maxDistance = 8;
    this.controls.maxPolarAngle = 1.5; // rad, above the ground
    this.controls.zoomSpeed = 0.8;
    this.isFollowing = true;
    this.isOurs = false;
    this.controls.addEventListener("change", () => {
      if (!this.isOurs) onChange(this);
    });
    this.look("behind");
  }

  // For a robot of another size, seen from the same direction.
  setDistance(distance) {
    this.setOffset(this.offset().multiplyScalar(distance / this.distance));
    this.distance = distance;
  }

  dispose() {
    this.controls.dispose();
  }

  look(view) {
    const [x, y, z] = directions[view];
    this.setOffset(new Vector3(x, y, z).setLength(this.distance));
  }

  zoom(factor) {
    const length = this.offset().length() * factor;
    this.setOffset(this.offset().setLength(Math.min(Math.max(length, 0.15), 8)));
  }

  offset() {
    return this.camera.position.clone().sub(this.controls.target);
  }

  setOffset(offset) {
    this.camera.position.copy(this.controls.target).add(offset);
    this.#update();
  }

  // Of the robot, in a new frame or at another place of its life.
  follow([x, y, z], isJump) {
    if (!this.isFollowing && !isJump) return;
    const offset = this.offset();
    this.controls.target.set(x, y, z);
    this.setOffset(offset);
  }

  setAspect(aspect) {
    // Narrow panels see as much across as square ones.
    this.camera.zoom = Math.min(aspect, 1);
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  #update() {
    this.isOurs = true;
    this.controls.update();
    this.isOurs = false;
  }
}
