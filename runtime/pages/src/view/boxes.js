// Boxes of robots as geometry: rounded, in the colours of their modules, many
// in one so that a link is drawn at once.
import { BufferAttribute, BufferGeometry, Matrix4, Quaternion, Vector3 } from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";
import { mergeGeometries, mergeVertices } from "three/addons/utils/BufferGeometryUtils.js";
import { partsOf } from "./materials.js";

// m, of edges; thin plates have less.
const roundness = 0.0025;

export function paint(geometry, colour) {
  const [r, g, b] = partsOf(colour);
  const count = geometry.getAttribute("position").count;
  const colours = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) colours.set([r, g, b], 3 * i);
  geometry.setAttribute("color", new BufferAttribute(colours, 3));
  return geometry;
}

// `centre`: of the box, in the frame of what it becomes part of.
export function boxGeometry(box, centre, colour) {
  const [x, y, z] = box.size;
  const geometry = new RoundedBoxGeometry(x, y, z, 1, Math.min(roundness, Math.min(x, y, z) / 4));
  const [qw, qx, qy, qz] = box.turn;
  const turn = new Quaternion(qx, qy, qz, qw).normalize();
  geometry.applyMatrix4(new Matrix4().compose(new Vector3(...centre), turn, new Vector3(1, 1, 1)));
  geometry.deleteAttribute("uv");
  return paint(mergeVertices(geometry), colour);
}

// An arrow head on top of the core, at its front (+y): which way is ahead.
export function frontGeometry(core, centre) {
  const [x, y, z] = core.size;
  const top = centre[2] + z / 2 + 0.0004;
  const at = (right, ahead) => [centre[0] + right * x, centre[1] + ahead * y, top];
  const corners = [at(-0.22, 0.05), at(0.22, 0.05), at(0, 0.36)].flat();
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]), 3));
  geometry.setIndex([0, 1, 2]);
  return paint(geometry, "#5b4d00");
}

export function joined(geometries) {
  return geometries.length > 0 ? mergeGeometries(geometries) : null;
}
