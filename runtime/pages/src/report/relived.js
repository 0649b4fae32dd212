// Which runs' robots have lived again, and what that is worth.
import { element } from "../common/dom.js";
import { number, plural, range } from "./text.js";

// A record is one draw, and selection keeps the lucky ones.
const why = "A life is one draw from what a robot does, and selection keeps lucky draws: recorded values are too high, and not by the same in every experiment.";

export function relivedNote(data) {
  const { runs, of, least_lives: least, most_lives: most, command } = data.relived;
  if (!runs)
    return element("p", { class: "note", id: "relived" }, `${why} No robots of generation ${data.generation} have lived again`, command ? [": ", element("code", {}, command), " lets them."] : ".");
  const missing = runs < of ? ` Of ${plural(of - runs, "run")} they are missing, or of another generation${command ? `; '${command}' adds them` : ""}.` : "";
  return element(
    "p",
    { class: "note", id: "relived" },
    `${why} Relived values are medians of each robot's lives when it lived again, from starts 0 to 30 µm higher: ${plural(runs, "run")}, ${range([least, most])} lives of each survivor.${missing}`,
  );
}

// Of the best robot in a season, beside its record; null where it is not known.
export function relivedText(run, season) {
  const { state, best, speeds } = run.relived;
  if (state !== "here" || best !== run.best.id) return null;
  const lived = speeds.find((one) => one.season === season);
  if (!lived || lived.median === null) return null;
  return `relived ${number(lived.median)} (${number(lived.low)} to ${number(lived.high)})`;
}

export const relivedSpeed = (run, season) =>
  (run.relived.state === "here" && run.relived.best === run.best.id && run.relived.speeds.find((one) => one.season === season)) || { low: null, median: null, high: null };
