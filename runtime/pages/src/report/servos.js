// Whether the equations of motion were solved: how far joints were from what
// their servos were told.
import { element } from "../common/dom.js";
import { csvButton, table } from "./chart.js";
import { number } from "./text.js";

const solverName = ({ engine, solver, iterations }) =>
  engine === "articulated" ? "the articulated engine" : solver === "iterative" ? `ODE, iterative, ${iterations} iterations` : "ODE, direct";

const columns = [
  { name: "experiment", title: "experiment" },
  { name: "season", title: "season" },
  { name: "solver", title: "solver" },
  { name: "median", title: "servo error, median, rad/s", isNumber: true },
  { name: "worst", title: "worst, rad/s", isNumber: true },
  { name: "runs", title: "runs", isNumber: true },
];

const told = (value) => (value === null ? "not measured" : number(value));

// A line for each season that an iterative solver lived.
function warnings(data) {
  const lines = data.servo_errors
    .filter(({ solver }) => solver === "iterative")
    .map((one) => {
      const where = `${one.experiment}, ${one.season}`;
      return one.median === null
        ? `${where}: lived by ODE's iterative solver; how well it converged was not measured by the plsc that made these runs.`
        : `${where}: lived by ODE's iterative solver, which leaves half of the joints' speeds ${number(one.median)} rad/s or more from what servos are told (direct: 0.0001).`;
    });
  return lines.length ? element("ul", { class: "note", id: "iterative" }, lines.map((line) => element("li", {}, line))) : null;
}

export function servos(data) {
  if (!data.servo_errors.length) return null;
  const rows = data.servo_errors.map((one) => ({
    experiment: one.experiment,
    season: one.season,
    solver: solverName(one),
    median: told(one.median),
    worst: told(one.worst),
    runs: String(one.runs),
  }));
  return [
    element("h3", {}, "Were the equations of motion solved?"),
    element(
      "p",
      { class: "note" },
      "A servo within its torque turns its joint as fast as it is told, so where the median over steps and joints is not near 0 the solver has not converged. Medians over the last populations; the worst is also of servos that are held up.",
    ),
    warnings(data),
    table(columns, rows, { label: "errors of servos" }),
    csvButton("the errors of servos", "servo_errors", data.servo_errors),
  ];
}
