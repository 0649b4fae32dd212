// A robot of one season in the scene: a group a link, moved to where the
// recording has it. What is new since the season before glows at first, and
// what is gone stays as a ghost.
import { Group, Mesh } from "three";
import { boxGeometry, frontGeometry, joined } from "./boxes.js";
import { moduleColours, ghostColour, newColour, servoColour } from "./colours.js";
import { flatMaterial, ghostMaterial, setGlow, setOpacity, shadowMaterial, solidMaterial } from "./materials.js";
import { between } from "./tracks.js";
import { isSensor } from "./words.js";

// s of life in which a change is shown.
const changeShown = 4;

// m, of the core of a robot that was not simulated, which hovers at rest.
export const unlivedHeight = 0.15;

const plain = solidMaterial();
const touching = flatMaterial();
const shadow = shadowMaterial();

function colourOf(body, box) {
  if (box.part === "servo") return servoColour;
  return moduleColours[body.modules[box.module].type] ?? "#999999";
}

export class Robot {
  constructor(season, change) {
    this.season = season;
    this.object = new Group();
    this.shadow = new Group(); // draws over the ground, below all else
    this.shadow.matrixAutoUpdate = false;
    this.sensors = []; // meshes, in the order of the recording's touch track
    this.fresh = solidMaterial();
    this.ghost = ghostMaterial();
    this.links = season.body.links.map((link, i) => this.#addLink(link, i, change));
    this.#addGhosts(change.gone);
  }

  #addLink(link, i, change) {
    const { body } = this.season;
    const group = new Group();
    const old = [];
    const fresh = [];
    link.boxes.forEach((box, k) => {
      const geometry = boxGeometry(box, box.centre, colourOf(body, box));
      if (isSensor(body.modules[box.module])) {
        this.sensors.push({ module: box.module, mesh: this.#addMesh(group, geometry, plain) });
        return;
      }
      (change.isNew(i, k) ? fresh : old).push(geometry);
      if (box.part === "core") old.push(frontGeometry(box, box.centre));
    });
    this.#addMesh(group, joined(old), plain);
    this.#addMesh(group, joined(fresh), this.fresh);
    this.sensors.sort((a, b) => a.module - b.module);
    this.object.add(group);
    return group;
  }

  #addMesh(group, geometry, material) {
    if (!geometry) return null;
    const mesh = new Mesh(geometry, material);
    mesh.renderOrder = 2;
    group.add(mesh);
    return mesh;
  }

  #addGhosts(gone) {
    if (gone.length === 0) return;
    const rest = this.season.body.links[0].rest;
    const geometries = gone.map(({ box, centre }) =>
      boxGeometry(box, centre.map((part, axis) => part - rest[axis]), ghostColour),
    );
    this.ghosts = this.#addMesh(this.links[0], joined(geometries), this.ghost);
  }

  // `place` as placeOf gives it, `age` in s since the season began.
  pose(place, age) {
    const { motion } = this.season;
    this.links.forEach((link, i) => {
      if (!place) {
        const [x, y, z] = this.season.body.links[i].rest;
        link.position.set(x, y, z + unlivedHeight);
        return;
      }
      const at = (row) => between(motion.position, motion.samples, 3 * i + row, place);
      const part = (row) => between(motion.turn, motion.samples, 4 * i + row, place);
      link.position.set(at(0), at(1), at(2));
      link.quaternion.set(part(1), part(2), part(3), part(0)).normalize();
    });
    this.sensors.forEach(({ mesh }, k) => {
      const feels = place && motion.touch[k * motion.samples + place.index] > 0;
      mesh.material = feels ? touching : plain;
    });
    const left = Math.max(0, 1 - age / changeShown);
    setGlow(this.fresh, newColour, 0.6 * left);
    setOpacity(this.ghost, 0.5 * left);
    if (this.ghosts) this.ghosts.visible = left > 0;
  }

  // The shadow that light from `toLight` throws on the plane through `point`.
  castShadow(normal, point, toLight) {
    if (this.shadow.children.length === 0)
      for (const link of this.links)
        for (const { geometry, material } of [...link.children]) {
          if (material === this.ghost) continue;
          const mesh = new Mesh(geometry, shadow);
          mesh.renderOrder = 1;
          mesh.matrixAutoUpdate = false;
          mesh.frustumCulled = false; // its bounds are those of the robot
          mesh.userData.link = link;
          this.shadow.add(mesh);
        }
    const dot = normal.dot(toLight);
    const offset = normal.dot(point);
    const n = normal.toArray();
    const l = toLight.toArray();
    // p - l (n.p - offset) / (n.l)
    const cell = (r, c) => (r === c ? 1 : 0) - (l[r] * n[c]) / dot;
    const shift = (r) => (l[r] * offset) / dot;
    this.shadow.matrix.set(
      ...[0, 1, 2].flatMap((r) => [cell(r, 0), cell(r, 1), cell(r, 2), shift(r)]),
      ...[0, 0, 0, 1],
    );
    this.shadow.matrixWorldNeedsUpdate = true;
    for (const mesh of this.shadow.children) {
      const { link } = mesh.userData;
      mesh.matrix.compose(link.position, link.quaternion, link.scale);
    }
  }
}
