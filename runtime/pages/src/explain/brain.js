// The brain as two lists: its nodes and its edges.
import { element } from "../common/dom.js";

const number = (value) => value.toFixed(2);
const signed = (value) => (value < 0 ? "\u2212" : "+") + number(Math.abs(value));

function nodeText(node) {
  if (node.is_input) return `${node.id}: input of sensor ${node.part}`;
  return `${node.id}: oscillator of joint ${node.part}, a ${number(node.amplitude)}, p ${number(node.period)} s, o ${number(node.phase_offset)}`;
}

function edgeText(edge) {
  if (edge.source === edge.destination) return `${edge.source} \u21ba ${signed(edge.weight)}`;
  return `${edge.source} \u2192 ${edge.destination} ${signed(edge.weight)}`;
}

function chip(key, text, name) {
  return element("li", {}, element("button", { type: "button", class: `chip ${name}`, "data-key": key }, text));
}

export function brainView(environment) {
  const { nodes, edges } = environment;
  const at = environment.number;
  if (nodes.length === 0) return element("section", {}, element("h3", {}, "Brain"), element("p", { class: "quiet" }, "no sensor, no joint: no brain"));
  return element(
    "section",
    {},
    element("h3", {}, "Brain"),
    element(
      "ul",
      { class: "brain", "data-group": true, "data-scroll": true, "aria-label": `the brain in ${environment.name}` },
      nodes.map((node, k) => chip(`node:${at}:${k}`, nodeText(node), "node")),
      edges.map((edge, k) => chip(`edge:${at}:${k}`, edgeText(edge), edge.weight < 0 ? "negative" : "positive")),
    ),
  );
}
