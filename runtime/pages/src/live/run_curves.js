// Fitness over the generations of a run, as a small picture: of each season the
// best survivor (strong) and the median one (pale): cm/s, or what a formula has.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7"]; // Okabe and Ito's, told apart by all
const width = 600;
const height = 120;
const left = 34;

function svg(tag, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// `shown`: the generation that a line marks.
export function curves(run, shown) {
  const rows = run.generations;
  const values = rows.flatMap(({ fitness }) => [...fitness.best, ...fitness.median]).filter((value) => value !== null);
  // Robots that cannot move have -0.1, far below all others: below the picture.
  const most = Math.max(0, ...values);
  const own = run.own_fitness;
  const least = Math.min(0, ...values.filter((value) => own || value > -0.1));
  const shownAs = (value) => (own ? Number(value.toPrecision(3)) : (100 * value).toFixed(1));
  const span = most - least || 1;
  const x = (i) => left + ((width - left - 4) * i) / Math.max(rows.length - 1, 1);
  const y = (value) => 6 + ((height - 22) * Math.min(most - value, span)) / span;
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `Fitness over ${rows.length} generations${own ? "" : ", cm/s"}` });
  for (const value of [least, most])
    picture.append(svg("line", { x1: left, x2: width - 4, y1: y(value), y2: y(value), stroke: "#ccc" }), svg("text", { x: left - 4, y: y(value) + 4, "text-anchor": "end", "font-size": 11 }, shownAs(value)));
  run.seasons.forEach((season, i) => {
    const colour = colours[i % colours.length];
    for (const [which, opacity] of [
      ["median", 0.4],
      ["best", 1],
    ]) {
      const points = rows.flatMap(({ fitness }, at) => (fitness[which][i] === null ? [] : [`${x(at).toFixed(1)},${y(fitness[which][i]).toFixed(1)}`]));
      picture.append(svg("polyline", { points: points.join(" "), fill: "none", stroke: colour, "stroke-width": 1.6, opacity }));
    }
    picture.append(svg("text", { x: left + 4 + 90 * i, y: height - 4, fill: colour, "font-size": 11 }, season));
  });
  picture.append(svg("line", { x1: x(shown), x2: x(shown), y1: 4, y2: height - 16, stroke: "#333", "stroke-dasharray": "3 2" }));
  return picture;
}
