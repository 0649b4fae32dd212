// The frame of every chart: the drawing, its legend as part of it, a caption,
// and the buttons that hand out the drawing as SVG and its numbers as CSV.
import * as Plot from "@observablehq/plot";
import { download, element } from "../common/dom.js";
import { csv } from "./csv.js";

const svgNamespace = "http://www.w3.org/2000/svg";
const letterWidth = 6.3; // px of 11 px sans-serif, on average and a little more
const rowHeight = 16;

function svgElement(tag, attributes, text) {
  const made = document.createElementNS(svgNamespace, tag);
  for (const [name, value] of Object.entries(attributes)) if (value !== null) made.setAttribute(name, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

const shortened = (text, length) => (text.length > length ? `${text.slice(0, length - 1)}…` : text);

// Entries in rows that fit: [{text, style, x, y}], and the height of all: a row
// at least, so that charts side by side are level.
function arrange(entries, width) {
  const left = 8;
  let x = left;
  let row = 0;
  const placed = entries.map((entry) => {
    const text = shortened(entry.text, Math.floor((width - 48) / letterWidth));
    const needed = 32 + text.length * letterWidth + 12;
    if (x > left && x + needed > width) {
      x = left;
      row += 1;
    }
    const place = { ...entry, text, x, y: 12 + row * rowHeight };
    x += needed;
    return place;
  });
  return { placed, height: (row + 1) * rowHeight + 6 };
}

export const legendHeight = (entries, width) => arrange(entries, width).height;

// Draws the legend into the margin that the chart has left for it.
// Entries: {text, colour, dash, isArea}.
export function addLegend(svg, entries, width) {
  const group = svgElement("g", { "aria-label": "legend", "font-size": 11, "text-anchor": "start", class: "legend" });
  for (const { text, colour, dash, isArea, x, y } of arrange(entries, width).placed) {
    group.append(
      isArea
        ? svgElement("rect", { x, y: y - 9, width: 14, height: 10, fill: colour, stroke: "#444", "stroke-width": 0.5 })
        : svgElement("line", { x1: x, x2: x + 26, y1: y - 4, y2: y - 4, stroke: colour, "stroke-width": 2, "stroke-dasharray": dash }),
      svgElement("text", { x: x + (isArea ? 20 : 32), y, fill: "#1b1b1b" }, text),
    );
  }
  svg.append(group);
}

// Over the vertical axis, to which it belongs; Plot's own would stand over the
// legend.
export const axisTitle = (text, left) => Plot.text([text], { frameAnchor: "top-left", textAnchor: "start", lineAnchor: "bottom", dx: 6 - left, dy: -10 });

// A file of its own: white ground, no tips of a pointer that was there.
function standalone(svg, title) {
  const copy = svg.cloneNode(true);
  for (const tip of copy.querySelectorAll('[aria-label="tip"]')) tip.remove();
  copy.prepend(
    svgElement("title", {}, title),
    svgElement("rect", { width: "100%", height: "100%", fill: "#fff" }),
  );
  copy.setAttribute("xmlns", svgNamespace);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}

// `name` is that of its files, `rows` are objects for the CSV, `kind` is a class
// of main.css.
export function chartFigure({ svg, title, name, rows, caption, kind }) {
  const { width } = svg.viewBox.baseVal;
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", title);
  const button = (label, press) =>
    element("button", { type: "button", "aria-label": `${label} of ${title}`, onclick: press }, label);
  return element(
    "figure",
    { class: `chart ${kind}`, style: `flex-basis: ${width}px` },
    svg,
    element(
      "figcaption",
      {},
      element("span", {}, caption),
      element(
        "span",
        { class: "buttons" },
        button("SVG", () => download(`${name}.svg`, "image/svg+xml", standalone(svg, title))),
        button("CSV", () => download(`${name}.csv`, "text/csv", csv(rows))),
      ),
    ),
  );
}

// A table of texts that is wider than a phone scrolls by itself.
// `columns`: [{name, title, isNumber}]; `rows`: objects of cells, nodes or texts.
export function table(columns, rows, options = {}) {
  const cells = (row) =>
    columns.map(({ name, isNumber }) => element("td", { class: isNumber ? "number" : null }, row[name] ?? "–"));
  return element(
    "div",
    { class: "table", tabindex: "0", role: "region", "aria-label": options.label ?? "table" },
    element(
      "table",
      {},
      element("thead", {}, element("tr", {}, columns.map(({ title, isNumber }) => element("th", { scope: "col", class: isNumber ? "number" : null }, title)))),
      element("tbody", {}, rows.map((row) => element("tr", {}, cells(row)))),
    ),
  );
}

// The button under a table.
export const csvButton = (what, name, rows) =>
  element("p", { class: "buttons" }, element("button", { type: "button", "aria-label": `CSV of ${what}`, onclick: () => download(`${name}.csv`, "text/csv", csv(rows)) }, "CSV"));
