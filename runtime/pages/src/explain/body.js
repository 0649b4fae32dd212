// A body from above, as `plsc draw` draws it, with modules to point at.
import { svg } from "./svg.js";

const cell = 100; // px of the drawing
// By facing: front, left, back, right; y goes down.
const ahead = [[0, -1], [-1, 0], [0, 1], [1, 0]];

function square(place, attributes) {
  return svg("rect", { x: place.x * cell - 50, y: -place.y * cell - 50, width: cell, height: cell, ...attributes });
}

function inner(place, attributes) {
  return svg("rect", { x: place.x * cell - 45, y: -place.y * cell - 45, width: 90, height: 90, ...attributes });
}

// A sensor lies inside the edge of its parent's cell that it faces.
function bar(sensor, attributes) {
  const [dx, dy] = ahead[sensor.facing];
  const [width, height] = dx ? [14, 50] : [50, 14];
  const x = sensor.x * cell + dx * 38 - width / 2;
  const y = -sensor.y * cell + dy * 38 - height / 2;
  return svg("rect", { x, y, width, height, ...attributes });
}

function moduleShape(module, key, colour) {
  const label = `${module.type === "T" ? "sensor" : "module"} ${module.id}, ${module.type}`;
  const group = svg("g", { class: "module", role: "button", "aria-label": label, "data-key": key, "data-mark": module.mark });
  if (module.type === "T") {
    group.append(bar(module, { class: "face", fill: colour.fill }));
    return group;
  }
  const [x, y] = [module.x * cell, -module.y * cell];
  group.append(square(module, { class: "face", fill: colour.fill }));
  if (module.mark === "other") group.append(inner(module, { class: "under" }));
  if (module.mark !== "shared") group.append(inner(module, { class: `mark ${module.mark}` }));
  group.append(
    svg("text", { x, y: y + 8, class: "type", fill: colour.ink }, module.type),
    svg("text", { x, y: y + 32, class: "number", fill: colour.ink }, module.id),
  );
  return group;
}

function dot(module) {
  const [dx, dy] = ahead[module.facing];
  return svg("circle", { cx: module.x * cell - dx * 50, cy: -module.y * cell - dy * 50, r: 8, class: "dot" });
}

function missingShape(place) {
  return place.type === "T" ? bar(place, { class: "missing" }) : inner(place, { class: "missing" });
}

// `rows` are the first and last row of all bodies, so that cores lie on a line.
export function bodyView(environment, rows, colourOf) {
  const all = [...environment.modules, ...environment.missing];
  const left = Math.min(...all.map((one) => one.x));
  const right = Math.max(...all.map((one) => one.x));
  const width = (right - left + 1) * cell + 20;
  const height = (rows.front - rows.back + 1) * cell + 20;
  const view = svg("svg", {
    viewBox: `${left * cell - 60} ${-rows.front * cell - 60} ${width} ${height}`,
    class: "body",
    role: "group",
    "aria-label": `the body in ${environment.name}`,
    "data-group": true,
  });
  view.style.maxWidth = `${width * 0.62}px`;
  const squares = environment.modules.filter((module) => module.type !== "T");
  const taken = new Set(squares.map((module) => `${module.x},${module.y}`));
  const shapes = new Map(
    environment.modules.map((module, k) => [module, moduleShape(module, `mod:${environment.number}:${k}`, colourOf(environment, module))]),
  );
  view.append(
    ...environment.missing.filter((one) => one.type !== "T" && !taken.has(`${one.x},${one.y}`)).map(missingShape),
    ...squares.map((module) => shapes.get(module)),
    ...environment.missing.filter((one) => one.type === "T").map(missingShape),
    ...squares.filter((module) => !module.is_root).map(dot),
    ...environment.modules.filter((module) => module.type === "T").map((module) => shapes.get(module)),
  );
  return view;
}

export function rowsOf(environments) {
  const all = environments.flatMap((one) => [...one.modules, ...one.missing]);
  return { front: Math.max(...all.map((one) => one.y)), back: Math.min(...all.map((one) => one.y)) };
}
