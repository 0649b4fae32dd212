// The Markdown that our language server writes, as elements: paragraphs, lists,
// tables, code; `code`, **strong** and *emphasis* in them. Anything else stays
// as it is, as text.
import { element } from "../../common/dom.js";

function inline(text) {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*|\*[^*\s][^*]*\*)/).map((part, i) => {
    if (i % 2 === 0) return part;
    if (part.startsWith("`")) return element("code", {}, part.slice(1, -1));
    if (part.startsWith("**")) return element("strong", {}, part.slice(2, -2));
    return element("em", {}, part.slice(1, -1));
  });
}

const cellsOf = (line) => line.replace(/^\||\|$/g, "").split("|").map((cell) => cell.trim());

function table(lines) {
  const [head, , ...rows] = lines;
  const row = (line, tag) => element("tr", {}, cellsOf(line).map((cell) => element(tag, {}, inline(cell))));
  return element("table", {}, element("thead", {}, row(head, "th")), element("tbody", {}, rows.map((line) => row(line, "td"))));
}

export function markdown(text) {
  const lines = text.split("\n");
  const made = element("div", { class: "markdown" });
  const take = (belongs) => {
    const taken = [];
    while (lines.length > 0 && belongs(lines[0])) taken.push(lines.shift());
    return taken;
  };
  while (lines.length > 0) {
    if (lines[0].trim() === "") lines.shift();
    else if (lines[0].startsWith("```")) {
      lines.shift();
      made.append(element("pre", {}, take((line) => !line.startsWith("```")).join("\n")));
      lines.shift();
    } else if (lines[0].startsWith("|")) made.append(table(take((line) => line.startsWith("|"))));
    else if (lines[0].startsWith("- "))
      made.append(element("ul", {}, take((line) => line.startsWith("- ")).map((line) => element("li", {}, inline(line.slice(2))))));
    else made.append(element("p", {}, inline(take((line) => line.trim() !== "" && !/^(```|\||- )/.test(line)).join(" "))));
  }
  return made;
}
