// Places that robots may be meant to reach: a ring on the ground and a pole, so
// that they are seen from afar.
import { CylinderGeometry, Group, Mesh, RingGeometry } from "three";
import { paint } from "./boxes.js";
import { targetColour } from "./colours.js";
import { flatMaterial } from "./materials.js";

const above = 0.002; // m, so that the ground does not hide it
const [inner, outer] = [0.06, 0.08]; // m, of the ring: a robot's core is 0.09 long
const [pole, thickness] = [0.3, 0.004]; // m
const material = flatMaterial();

export function makeTargets(season, ground) {
  const group = new Group();
  for (const { x, y } of season.targets ?? []) {
    const ring = new Mesh(paint(new RingGeometry(inner, outer, 32), targetColour), material);
    const stick = new Mesh(paint(new CylinderGeometry(thickness, thickness, pole), targetColour), material);
    stick.rotation.x = Math.PI / 2;
    stick.position.z = pole / 2;
    const target = new Group();
    target.add(ring, stick);
    target.position.set(x, y, ground.heightAt(x, y) + above);
    target.rotation.x = Math.atan2(-ground.normal.y, ground.normal.z);
    group.add(target);
  }
  return group;
}
