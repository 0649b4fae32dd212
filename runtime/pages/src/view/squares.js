// Squares of 10 cm on the ground, as a texture and, where drawing is slow, as
// lines alone.
import { BufferAttribute, BufferGeometry, CanvasTexture, LineSegments, RepeatWrapping } from "three";
import { sky } from "./colours.js";
import { partsOf, planeMaterial } from "./materials.js";

const squares = 10; // to a metre, as the legend says
const colours = { metre: "#8795a8", half: "#b9c2ce", tenth: "#d5dbe4" };

const uphill = "#e0a458";

function colourOf(i) {
  return i % squares === 0 ? colours.metre : i % 5 === 0 ? colours.half : colours.tenth;
}

// A square metre; `hasArrows` that point uphill.
function draw(hasArrows) {
  const side = 1024; // px
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = side;
  const pen = canvas.getContext("2d");
  pen.fillStyle = sky;
  pen.fillRect(0, 0, side, side);
  // Metres last: they cross all others.
  for (const i of [1, 2, 3, 4, 6, 7, 8, 9, 5, 0, 10]) {
    const at = (i * side) / squares;
    pen.strokeStyle = colourOf(i);
    pen.lineWidth = i % squares === 0 ? 7 : 4;
    pen.beginPath();
    pen.moveTo(at, 0);
    pen.lineTo(at, side);
    pen.moveTo(0, at);
    pen.lineTo(side, at);
    pen.stroke();
  }
  if (hasArrows) drawArrows(pen, side);
  return canvas;
}

function drawArrows(pen, side) {
  pen.strokeStyle = uphill;
  pen.lineWidth = side / 90;
  for (const x of [0.25, 0.75])
    for (const y of [0.25, 0.75]) {
      pen.beginPath();
      pen.moveTo((x - 0.025) * side, (y + 0.012) * side);
      pen.lineTo(x * side, (y - 0.012) * side);
      pen.lineTo((x + 0.025) * side, (y + 0.012) * side);
      pen.stroke();
    }
}

const textures = new Map();
export function squareMetre(hasArrows) {
  if (!textures.has(hasArrows)) {
    const texture = new CanvasTexture(draw(hasArrows));
    texture.wrapS = texture.wrapT = RepeatWrapping;
    texture.anisotropy = 8; // the ground is seen at a slant
    textures.set(hasArrows, texture);
  }
  return textures.get(hasArrows);
}

// m, each way from the middle: of all lines, and of those between metres.
const reach = 12;
const fine = 2.5;

// Line `i` both ways, from -length to length in pieces of `piece` m: programs
// that draw without a graphics card lose long lines that pass the camera.
function addLine(i, length, piece, add) {
  const at = i / squares;
  const colour = partsOf(colourOf(Math.abs(i)));
  const count = Math.round((2 * length) / piece);
  for (let k = 0; k < count; ++k) {
    const [a, b] = [k, k + 1].map((end) => -length + (2 * length * end) / count);
    add([at, a], [at, b], colour);
    add([a, at], [b, at], colour);
  }
}

function linesOf(points, paints, fading) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(paints), 3));
  return new LineSegments(geometry, planeMaterial(null, fading));
}

function addArrows(points, paints) {
  for (let x = 0.25 - Math.ceil(fine); x < fine; x += 0.5)
    for (let y = 0.25 - Math.ceil(fine); y < fine; y += 0.5) {
      points.push(x - 0.025, y - 0.012, 0, x, y + 0.012, 0, x, y + 0.012, 0, x + 0.025, y - 0.012, 0);
      for (let k = 0; k < 4; ++k) paints.push(...partsOf(uphill));
    }
}

// On a plane.
export function gridLines(fading, hasArrows) {
  const points = [];
  const paints = [];
  const add = (a, b, colour) => {
    points.push(...a, 0, ...b, 0);
    paints.push(...colour, ...colour);
  };
  for (let i = -fine * squares; i <= fine * squares; ++i) if (i % squares !== 0) addLine(i, fine, 0.25, add);
  for (let i = -reach; i <= reach; ++i) addLine(i * squares, reach, 0.5, add);
  if (hasArrows) addArrows(points, paints);
  return linesOf(points, paints, fading);
}

const above = 0.001; // m, so that hills do not hide them

// On ground of any heights, as far as it goes: {x, y, width, length}, m.
export function drapedLines(fading, { x, y, width, length }, heightAt) {
  const points = [];
  const paints = [];
  const covers = ([px, py]) => px >= x && py >= y && px <= x + width && py <= y + length;
  const add = (a, b, colour) => {
    if (!covers(a) || !covers(b)) return;
    for (const [px, py] of [a, b]) points.push(px, py, heightAt(px, py) + above);
    paints.push(...colour, ...colour);
  };
  const most = Math.ceil(Math.max(-x, -y, x + width, y + length));
  for (let i = -most * squares; i <= most * squares; ++i) addLine(i, most, 0.1, add);
  return linesOf(points, paints, fading);
}
