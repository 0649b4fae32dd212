// The way of a robot on the ground, as far as it has come.
import { BufferAttribute, BufferGeometry, Line } from "three";
import { paint } from "./boxes.js";
import { pathColour } from "./colours.js";
import { flatMaterial } from "./materials.js";

const above = 0.0015; // m, so that it is not hidden by the ground
const material = flatMaterial();

export function makePath(season, ground) {
  const [xs, ys] = season.centres;
  const points = new Float32Array(3 * xs.length);
  xs.forEach((x, i) => points.set([x, ys[i], ground.heightAt(x, ys[i]) + above], 3 * i));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  paint(geometry, pathColour);
  const line = new Line(geometry, material);
  line.frustumCulled = false; // seen or not changes with how much is drawn
  return line;
}
