// What the page says of seasons, in the words of `plsc simulate`.

const changes = {
  born: "born",
  none: "the same robot",
  brain: "the same body, another brain",
  body: "another body",
};

export function changeWord(season) {
  return changes[season.change] ?? season.change;
}

// "another body: inclined False -> True"
export function changeText(season) {
  const reason = season.change_reason.replaceAll("->", "→");
  return reason ? `${changeWord(season)}: ${reason}` : changeWord(season);
}

export function outcomeText(season) {
  const outcome = season.outcome.replaceAll("_", " ");
  return season.reason ? `${outcome}: ${season.reason}` : outcome;
}

const number = (value, digits) => String(Number(value.toFixed(digits)));

export function groundText({ type, ...rest }) {
  switch (type) {
    case "tilted":
      return `tilted by ${number((rest.tilt * 180) / Math.PI, 2)}°`;
    case "rough":
      return `rough: hills of ${number(rest.amplitude * 100, 2)} cm, ${number(rest.wavelength * 100, 1)} cm apart`;
    case "steps":
      return `${rest.count} steps of ${number(rest.height * 100, 2)} cm, ${number(rest.depth * 100, 1)} cm deep`;
    case "obstacles":
      return `obstacles up to ${number(rest.height * 100, 2)} cm high`;
    default:
      return type;
  }
}

// Behind the season's name, which is often the ground's.
export function groundBehind(season) {
  const text = groundText(season.terrain);
  return text.startsWith(season.name) ? text.slice(season.name.length).replace(/^[: ]+/, "") : text;
}

const plain = (digits) => digits.replace("-", "−").replace(/^−([0.]+)$/, "$1");

// cm/s, the paper's unit of Speed.
export function speedText(season) {
  return season.speed === null ? "–" : `${plain((season.speed * 100).toFixed(2))} cm/s`;
}

export function balanceText(season) {
  return season.balance === null ? "–" : season.balance.toFixed(3);
}

export function timeText(seconds) {
  return `${seconds.toFixed(1)} s`;
}

function count(many, one) {
  return `${many} ${one}${many === 1 ? "" : "s"}`;
}

export function bodyText(body) {
  const sensors = body.modules.filter((module) => isSensor(module)).length;
  if (body.modules.length === 0) return "no robot";
  return [
    count(body.modules.length - sensors, "module"),
    count(body.joints.length, "joint"),
    count(sensors, "touch sensor"),
  ].join(", ");
}

export function isSensor(module) {
  return module.type === "T";
}
