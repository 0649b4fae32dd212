// The ground of a season: a plane without end with squares of 10 cm, tilted or
// not, and what rises from it (runtime/formats/ground_json).
import { BufferAttribute, BufferGeometry, CanvasTexture, Color, Group, InstancedMesh, Matrix4, Mesh } from "three";
import { BoxGeometry, MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry, RepeatWrapping, SRGBColorSpace } from "three";
import { Vector3 } from "three";
import { readTrack } from "./tracks.js";

// m; fog hides where it ends. Moves along with the robot by whole metres.
const reach = 40;
const squares = 10; // to a metre, as the legend says

// A square metre of squares; `arrow` points uphill.
function squareMetre(arrow) {
  const side = 1000; // px
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = side;
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#f8f9fb";
  pen.fillRect(0, 0, side, side);
  for (let i = 0; i <= squares; ++i) {
    const isMetre = i % squares === 0;
    pen.strokeStyle = isMetre ? "#8795a8" : i % 5 === 0 ? "#b3bdca" : "#d3dae3";
    pen.lineWidth = isMetre ? 10 : 5;
    const at = (i * side) / squares;
    pen.beginPath();
    pen.moveTo(at, 0);
    pen.lineTo(at, side);
    pen.moveTo(0, at);
    pen.lineTo(side, at);
    pen.stroke();
  }
  if (arrow) {
    pen.strokeStyle = "#c9d1dc";
    pen.lineWidth = 14;
    for (const x of [250, 750])
      for (const y of [250, 750]) {
        pen.beginPath();
        pen.moveTo(x - 30, y + 15);
        pen.lineTo(x, y - 20);
        pen.lineTo(x + 30, y + 15);
        pen.stroke();
      }
  }
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}

const textures = new Map();
function textureOf(arrow) {
  if (!textures.has(arrow)) textures.set(arrow, squareMetre(arrow));
  return textures.get(arrow);
}

class Plane {
  constructor(tilt) {
    this.tilt = tilt;
    this.normal = new Vector3(0, -Math.sin(tilt), Math.cos(tilt));
    const geometry = new PlaneGeometry(reach, reach);
    const uv = geometry.getAttribute("uv");
    for (let i = 0; i < uv.count; ++i) uv.setXY(i, uv.getX(i) * reach, uv.getY(i) * reach);
    const material = new MeshBasicMaterial({ map: textureOf(tilt !== 0) });
    this.object = new Mesh(geometry, material);
    this.object.rotation.x = tilt;
  }
  moveTo([x, y]) {
    const along = Math.round(y / Math.cos(this.tilt));
    this.object.position.set(Math.round(x), along * Math.cos(this.tilt), along * Math.sin(this.tilt));
  }
  heightAt(x, y) {
    return y * Math.tan(this.tilt);
  }
}

class Hills {
  constructor({ x, y, spacing, columns, rows, ...track }) {
    Object.assign(this, { x, y, spacing, columns, rows });
    this.heights = readTrack({ ...track, rows }, columns);
    this.normal = new Vector3(0, 0, 1);
    const geometry = new BufferGeometry();
    const positions = new Float32Array(3 * columns * rows);
    const uvs = new Float32Array(2 * columns * rows);
    for (let row = 0, i = 0; row < rows; ++row)
      for (let column = 0; column < columns; ++column, ++i) {
        const place = [x + column * spacing, y + row * spacing];
        positions.set([...place, this.heights[i]], 3 * i);
        uvs.set(place, 2 * i);
      }
    const corners = [];
    for (let row = 0; row + 1 < rows; ++row)
      for (let column = 0; column + 1 < columns; ++column) {
        const a = row * columns + column;
        corners.push(a, a + 1, a + columns, a + 1, a + columns + 1, a + columns);
      }
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("uv", new BufferAttribute(uvs, 2));
    geometry.setIndex(corners);
    geometry.computeVertexNormals();
    this.object = new Mesh(geometry, new MeshLambertMaterial({ map: textureOf(false) }));
  }
  moveTo() {}
  heightAt(x, y) {
    const { spacing, columns, rows, heights } = this;
    const across = Math.min(Math.max((x - this.x) / spacing, 0), columns - 1.001);
    const along = Math.min(Math.max((y - this.y) / spacing, 0), rows - 1.001);
    const [i, k] = [Math.floor(across), Math.floor(along)];
    const [u, v] = [across - i, along - k];
    const at = (column, row) => heights[row * columns + column];
    return (at(i, k) * (1 - u) + at(i + 1, k) * u) * (1 - v) + (at(i, k + 1) * (1 - u) + at(i + 1, k + 1) * u) * v;
  }
}

// m below the plane, where a box begins.
const sunk = 0.01;

class Boxes {
  constructor({ samples, ...track }) {
    this.plane = new Plane(0);
    this.normal = this.plane.normal;
    const numbers = readTrack(track, samples);
    const row = (i) => numbers.subarray(i * samples, (i + 1) * samples);
    const [xs, ys, widths, lengths, tops] = [0, 1, 2, 3, 4].map(row);
    this.boxes = Array.from(tops, (top, i) => ({ x: xs[i], y: ys[i], width: widths[i], length: lengths[i], top }));
    const mesh = new InstancedMesh(new BoxGeometry(1, 1, 1), new MeshLambertMaterial(), samples);
    this.boxes.forEach(({ x, y, width, length, top }, i) => {
      const matrix = new Matrix4().makeScale(width, length, top + sunk);
      mesh.setMatrixAt(i, matrix.setPosition(x, y, (top - sunk) / 2));
      // Neighbours are told apart, also where steps rise behind each other.
      mesh.setColorAt(i, new Color(["#cfd8e3", "#bfcbd9", "#d9dfe7"][i % 3]));
    });
    mesh.frustumCulled = false;
    this.object = new Group();
    this.object.add(this.plane.object, mesh);
  }
  moveTo(place) {
    this.plane.moveTo(place);
  }
  heightAt(x, y) {
    let height = 0;
    for (const box of this.boxes)
      if (box.top > height && Math.abs(x - box.x) <= box.width / 2 && Math.abs(y - box.y) <= box.length / 2)
        height = box.top;
    return height;
  }
}

// {object, normal, moveTo([x, y]), heightAt(x, y)}
export function makeGround(terrain, relief) {
  if (relief.heights) return new Hills(relief.heights);
  if (relief.boxes?.samples > 0) return new Boxes(relief.boxes);
  return new Plane(terrain.tilt ?? 0);
}
