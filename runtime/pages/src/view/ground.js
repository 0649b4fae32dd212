// The ground of a season: a plane without end, tilted or not, and what rises
// from it (runtime/recording/ground_json). Each kind has
//   object          to be put into the scene,
//   normal          of the plane that shadows fall on,
//   moveTo([x, y])  which a plane does with the robot, by whole metres,
//   heightAt(x, y)  m,
//   setRough(isRough)  drawn in less time, and less beautiful.
import { BoxGeometry, BufferAttribute, BufferGeometry, Group, Mesh, PlaneGeometry, Vector3 } from "three";
import { joined, paint } from "./boxes.js";
import { hillMaterial, planeMaterial, solidMaterial } from "./materials.js";
import { drapedLines, gridLines, squareMetre } from "./squares.js";
import { readTrack } from "./tracks.js";

// m; it fades out before its end is seen.
const reach = 60;

class Plane {
  constructor(tilt, fading) {
    this.tilt = tilt;
    this.normal = new Vector3(0, -Math.sin(tilt), Math.cos(tilt));
    const geometry = paint(new PlaneGeometry(reach, reach), "#ffffff");
    const uv = geometry.getAttribute("uv");
    for (let i = 0; i < uv.count; ++i) uv.setXY(i, uv.getX(i) * reach, uv.getY(i) * reach);
    this.fine = new Mesh(geometry, planeMaterial(squareMetre(tilt !== 0), fading));
    this.rough = gridLines(fading, tilt !== 0);
    this.object = new Group();
    this.object.rotation.x = tilt;
    this.object.add(this.fine, this.rough);
    this.setRough(false);
  }
  setRough(isRough) {
    this.fine.visible = !isRough;
    this.rough.visible = isRough;
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
  constructor({ x, y, spacing, columns, rows, ...track }, fading) {
    Object.assign(this, { x, y, spacing, columns, rows });
    this.heights = readTrack({ ...track, rows }, columns);
    this.normal = new Vector3(0, 0, 1);
    const geometry = paint(this.#geometry(), "#f3f6fa");
    this.fine = hillMaterial(squareMetre(false), fading);
    this.rough = hillMaterial(null, fading);
    this.mesh = new Mesh(geometry, this.fine);
    const extent = { x, y, width: (columns - 1) * spacing, length: (rows - 1) * spacing };
    this.lines = drapedLines(fading, extent, (...place) => this.heightAt(...place));
    this.object = new Group();
    this.object.add(this.mesh, this.lines);
    this.setRough(false);
  }
  #geometry() {
    const { x, y, spacing, columns, rows, heights } = this;
    const positions = new Float32Array(3 * columns * rows);
    const places = new Float32Array(2 * columns * rows);
    const corners = [];
    for (let row = 0, i = 0; row < rows; ++row)
      for (let column = 0; column < columns; ++column, ++i) {
        const place = [x + column * spacing, y + row * spacing];
        positions.set([...place, heights[i]], 3 * i);
        places.set(place, 2 * i);
        if (row + 1 < rows && column + 1 < columns)
          corners.push(i, i + 1, i + columns, i + 1, i + columns + 1, i + columns);
      }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("uv", new BufferAttribute(places, 2));
    geometry.setIndex(corners);
    geometry.computeVertexNormals();
    return geometry;
  }
  setRough(isRough) {
    this.mesh.material = isRough ? this.rough : this.fine;
    this.lines.visible = isRough;
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
// Neighbours are told apart, also steps that rise behind each other.
const greys = ["#cfd8e3", "#bccad9", "#dbe1e9"];

class Boxes {
  constructor({ samples, ...track }, fading) {
    this.plane = new Plane(0, fading);
    this.normal = this.plane.normal;
    const numbers = readTrack(track, samples);
    const row = (i) => numbers.subarray(i * samples, (i + 1) * samples);
    const [xs, ys, widths, lengths, tops] = [0, 1, 2, 3, 4].map(row);
    this.boxes = Array.from(tops, (top, i) => ({ x: xs[i], y: ys[i], width: widths[i], length: lengths[i], top }));
    const geometries = this.boxes.map(({ x, y, width, length, top }, i) =>
      paint(new BoxGeometry(width, length, top + sunk).translate(x, y, (top - sunk) / 2), greys[i % greys.length]),
    );
    this.object = new Group();
    this.object.add(this.plane.object, new Mesh(joined(geometries), solidMaterial(fading)));
  }
  setRough(isRough) {
    this.plane.setRough(isRough);
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

export function makeGround(terrain, relief, fading) {
  if (relief.heights) return new Hills(relief.heights, fading);
  if (relief.boxes?.samples > 0) return new Boxes(relief.boxes, fading);
  return new Plane(terrain.tilt ?? 0, fading);
}
