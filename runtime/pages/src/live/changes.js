// What changed against the last good version, in the text and in the robot.
import { element } from "../common/dom.js";

const most = 40; // lines; what is beyond is counted

function textLines({ texts }) {
  return texts.flatMap(({ changes }) =>
    changes.map((change) => {
      const { item, old, new: now, parts } = change;
      const what = element("b", {}, item, " ");
      if (change.change === "added") return element("li", { class: "added" }, what, "added");
      if (change.change === "removed") return element("li", { class: "removed" }, what, "removed");
      if (parts?.length > 0) return element("li", {}, what, parts.map(partText).join("; "));
      return element("li", {}, what, element("code", { class: "old" }, old), " → ", element("code", { class: "new" }, now));
    }),
  );
}

function partText({ kind, change, what, old, new: now }) {
  const name = what ?? change ?? kind ?? "";
  if (old && now) return `${name} ${old} → ${now}`;
  return `${name} ${now ? `+ ${now}` : old ? `− ${old}` : ""}`;
}

function robotLines({ robots }) {
  return robots.flatMap(({ environments = [] }) =>
    environments.flatMap(({ environment, differences }) =>
      differences.map(({ kind, what, old, new: now }) =>
        element("li", {}, element("span", { class: "quiet" }, environment === "any" ? "" : `${environment}: `), kind === "changed" ? `${what}: ${old} → ${now}` : `${what} ${kind}`),
      ),
    ),
  );
}

function list(label, lines, none) {
  const shown = lines.slice(0, most);
  if (lines.length > most) shown.push(element("li", { class: "quiet" }, `and ${lines.length - most} more`));
  return element("div", {}, element("h3", {}, label), lines.length > 0 ? element("ul", {}, shown) : element("p", { class: "quiet" }, none));
}

export class Changes {
  constructor() {
    this.body = element("div", { class: "changes" });
    this.object = element("section", { "aria-label": "What changed", hidden: true }, element("h2", {}, "What changed"), this.body);
  }

  // `difference` as `plsc diff --format json` has it; null: nothing to compare.
  show(difference, number) {
    this.object.hidden = difference === null;
    if (difference === null) return;
    const robots = robotLines(difference);
    this.body.replaceChildren(
      list("In the text", textLines(difference), "nothing but layout"),
      list("In the robot", robots, "nothing: it is the same robot"),
    );
    this.object.firstChild.textContent = `What changed against version ${number}`;
  }
}
