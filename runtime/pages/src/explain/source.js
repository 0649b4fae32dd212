// The genotype's text, as it was written, with its rules and their symbols to
// point at.
import { element } from "../common/dom.js";

// Places are bytes of UTF-8; the text of bytes [begin, end).
function slicer(text) {
  const bytes = new TextEncoder().encode(text);
  const decoder = new TextDecoder();
  return { size: bytes.length, slice: (begin, end) => decoder.decode(bytes.subarray(begin, end)) };
}

function ruleText(rule, number, { slice }) {
  const parts = [];
  let at = rule.span[0];
  rule.symbols.forEach((symbol, i) => {
    const [begin, end] = symbol.span;
    parts.push(slice(at, begin), element("span", { "data-key": `symbol:${number}:${i + 1}` }, slice(begin, end)));
    at = end;
  });
  parts.push(slice(at, rule.span[1]));
  return element("span", { class: "rule-text", "data-key": `rule:${number}` }, parts);
}

export function sourceView(robot) {
  const source = slicer(robot.text);
  // The IR groups rules by symbol; here they stand as they were written.
  const rules = robot.rules.map((rule, i) => ({ rule, number: i + 1 })).sort((a, b) => a.rule.span[0] - b.rule.span[0]);
  const parts = [];
  let at = 0;
  for (const { rule, number } of rules) {
    parts.push(source.slice(at, rule.span[0]), ruleText(rule, number, source));
    at = rule.span[1];
  }
  parts.push(source.slice(at, source.size));
  return element(
    "details",
    { class: "source", open: true },
    element("summary", {}, `The text, ${robot.file}`),
    element("pre", { "data-scroll": true, "data-group": true, "aria-label": "the genotype's text" }, parts),
  );
}
