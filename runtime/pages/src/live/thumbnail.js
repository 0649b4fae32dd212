// A body as a small picture: modules as squares, sensors as bars.
import { svg } from "../explain/svg.js";

const ahead = [[0, -1], [-1, 0], [0, 1], [1, 0]]; // by facing, y goes down

export function thumbnail({ modules }, colours) {
  const xs = modules.map((one) => one.x);
  const ys = modules.map((one) => -one.y);
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const view = svg("svg", {
    viewBox: `${left - 0.6} ${top - 0.6} ${Math.max(...xs) - left + 1.2} ${Math.max(...ys) - top + 1.2}`,
    class: "thumbnail",
    "aria-hidden": "true",
  });
  const isBar = (one) => one.type === "T";
  for (const one of [...modules.filter((m) => !isBar(m)), ...modules.filter(isBar)]) {
    const [dx, dy] = ahead[one.facing];
    const [x, y, width, height] = isBar(one)
      ? [one.x + dx * 0.4 - (dx ? 0.1 : 0.3), -one.y + dy * 0.4 - (dx ? 0.3 : 0.1), dx ? 0.2 : 0.6, dx ? 0.6 : 0.2]
      : [one.x - 0.5, -one.y - 0.5, 1, 1];
    view.append(svg("rect", { x, y, width, height, fill: colours[one.type] ?? "#999", stroke: "#333", "stroke-width": 0.06 }));
  }
  return view;
}
