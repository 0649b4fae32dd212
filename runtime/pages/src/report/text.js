// Numbers and names as people read them.

// Three digits, without needless zeros; "–" for none.
export function number(value) {
  if (value === null || value === undefined) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) return value.toExponential(2).replace("-", "−");
  return String(Number(value.toPrecision(3))).replace("-", "−");
}

export function percent(share) {
  return share === null || share === undefined ? "–" : `${number(Math.round(share * 1000) / 10)} %`;
}

export function pValue(p) {
  if (p === null) return "–";
  return p < 0.0001 ? p.toExponential(1).replace("-", "−") : String(Number(p.toPrecision(2)));
}

export function duration(seconds) {
  if (seconds === null || seconds === undefined) return "–";
  if (seconds < 60) return `${number(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${String(minutes % 60).padStart(2, "0")} min`;
}

export function whole(value) {
  return value === null || value === undefined ? "–" : value.toLocaleString("en-US");
}

export function plural(count, one, many = `${one}s`) {
  return `${whole(count)} ${count === 1 ? one : many}`;
}

// "20", or "12 to 20".
export function range(counts) {
  const least = Math.min(...counts);
  const most = Math.max(...counts);
  return least === most ? String(least) : `${least} to ${most}`;
}

export const withUnit = (measure) => (measure.unit ? `${measure.title} (${measure.unit})` : measure.title);

// For names of files.
export const fileName = (...parts) =>
  parts
    .join("-")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "")
    .slice(0, 80) || "chart";
