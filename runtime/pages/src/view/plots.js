// Joint angles and touch of one life as small plots, a row each, with a cursor
// at the present time. A plot shows a stretch of time and turns to the next
// when the cursor leaves it, so that it is drawn rarely.
import { element } from "../common/dom.js";
import { moduleColours, moduleNames, touchColour } from "./colours.js";
import { isSensor } from "./words.js";

const row = 26; // px
const footer = 18; // px, for the times
const left = 46; // px, for the names
const right = 8;
const ink = "#1b1b1b";
const quiet = "#5a5a5a";
const line = "#d0d0d0";

function rowsOf(season) {
  const { modules, joints } = season.body;
  const { samples, angle, touch } = season.motion;
  const angles = joints.map((joint, i) => ({
    ...modules[joint.module],
    numbers: angle.subarray(i * samples, (i + 1) * samples),
  }));
  const sensors = modules.filter(isSensor).map((module, i) => ({
    ...module,
    isTouch: true,
    numbers: touch.subarray(i * samples, (i + 1) * samples),
  }));
  return samples > 0 ? [...angles, ...sensors] : [];
}

// rad, the same for all joints so that they can be compared.
function rangeOf(rows) {
  let most = 0.1;
  for (const { isTouch, numbers } of rows) if (!isTouch) for (const one of numbers) most = Math.max(most, Math.abs(one));
  return most;
}

// s between ticks: of 1, 2 or 5 times a power of ten.
function tickOf(span, width) {
  const least = (span * 60) / Math.max(width, 60);
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * power).find((tick) => tick >= least);
}

export class Plots {
  // `span`: s shown at once; Infinity for the season.
  constructor(life, span) {
    this.life = life;
    this.span = span;
    this.season = null;
    this.begin = 0; // s of the season, of what is shown
    this.canvas = element("canvas", { role: "img" });
    this.cursor = element("div", { class: "plot-cursor" });
    this.note = element("p", { class: "quiet" });
    this.object = element(
      "div",
      { class: "plots" },
      element("h3", {}, life.name),
      this.note,
      element("div", { class: "plot" }, this.canvas, this.cursor),
    );
    new ResizeObserver(() => this.#draw()).observe(this.object);
  }

  setSpan(span) {
    this.span = span;
    this.#draw();
  }

  show(season, age) {
    const isNew = season !== this.season;
    if (isNew) this.#take(season);
    this.age = age;
    const length = this.#length();
    if (isNew || age < this.begin || age > this.begin + length) this.#draw();
    this.#moveCursor();
  }

  #take(season) {
    this.season = season;
    this.rows = rowsOf(season);
    this.range = rangeOf(this.rows);
    const degrees = Math.round((this.range * 180) / Math.PI);
    const joints = this.rows.filter((one) => !one.isTouch).length;
    const none = season.motion.samples > 0 ? "no joints" : "not simulated";
    const touch = this.rows.length > joints ? "; touch sensors: high while they touch" : "";
    this.note.textContent =
      this.rows.length > 0 ? `${season.name}: angles of joints, up to ±${degrees}°${touch}` : `${season.name}: ${none}`;
    this.canvas.setAttribute("aria-label", `Angles of ${joints} joints in ${season.name}`);
  }

  #length() {
    return Math.min(this.span, this.season.duration);
  }

  #draw() {
    if (!this.season) return;
    const length = this.#length();
    this.begin = Math.min(Math.floor(this.age / length) * length, Math.max(this.season.duration - length, 0));
    const width = this.object.clientWidth;
    const height = this.rows.length * row + footer;
    const ratio = devicePixelRatio;
    this.width = width;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.style.height = `${height}px`;
    this.cursor.style.height = `${height - footer}px`;
    const pen = this.canvas.getContext("2d");
    pen.scale(ratio, ratio);
    pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
    pen.textBaseline = "middle";
    this.#drawTimes(pen, height);
    this.rows.forEach((one, i) => this.#drawRow(pen, one, i * row));
    this.#moveCursor();
  }

  #xOf(time) {
    return left + ((time - this.begin) / this.#length()) * (this.width - left - right);
  }

  #drawTimes(pen, height) {
    const tick = tickOf(this.#length(), this.width - left - right);
    pen.textAlign = "center";
    for (let i = Math.ceil(this.begin / tick - 1e-9); i * tick <= this.begin + this.#length() + 1e-9; ++i) {
      const x = this.#xOf(i * tick);
      pen.strokeStyle = "#ececec";
      pen.beginPath();
      pen.moveTo(x, 0);
      pen.lineTo(x, height - footer);
      pen.stroke();
      pen.fillStyle = quiet;
      const digits = tick < 1 ? 1 : 0;
      pen.fillText((this.season.start + i * tick).toFixed(digits), Math.min(x, this.width - 12), height - footer / 2);
    }
    pen.textAlign = "left";
    pen.fillText("s", left - 18, height - footer / 2);
  }

  #drawRow(pen, { id, type, isTouch, numbers }, top) {
    pen.fillStyle = moduleColours[type];
    pen.fillRect(0, top + row / 2 - 5, 10, 10);
    pen.fillStyle = ink;
    pen.textAlign = "left";
    pen.fillText(id, 14, top + row / 2, left - 16);
    const middle = top + row / 2;
    pen.strokeStyle = line;
    pen.beginPath();
    pen.moveTo(left, isTouch ? top + row - 5 : middle);
    pen.lineTo(this.width - right, isTouch ? top + row - 5 : middle);
    pen.stroke();
    if (isTouch) this.#drawTouch(pen, numbers, top);
    else this.#drawAngle(pen, numbers, middle);
  }

  #samples() {
    const { times, samples } = this.season.motion;
    const end = this.begin + this.#length();
    let first = 0;
    while (first < samples && times[first] < this.begin - 1e-6) ++first;
    let last = first;
    while (last + 1 < samples && times[last + 1] <= end + 1e-6) ++last;
    return { first, last: Math.min(last, samples - 1), times };
  }

  #drawAngle(pen, numbers, middle) {
    const { first, last, times } = this.#samples();
    const scale = (row / 2 - 3) / this.range;
    pen.strokeStyle = "#0072b2";
    pen.lineWidth = 1.4;
    pen.beginPath();
    for (let i = first; i <= last; ++i) pen.lineTo(this.#xOf(times[i]), middle - numbers[i] * scale);
    pen.stroke();
    pen.lineWidth = 1;
  }

  #drawTouch(pen, numbers, top) {
    const { first, last, times } = this.#samples();
    pen.fillStyle = touchColour;
    for (let i = first; i <= last; ++i) {
      if (numbers[i] === 0) continue;
      const begin = this.#xOf(times[i]);
      while (i < last && numbers[i + 1] > 0) ++i;
      const end = this.#xOf(times[Math.min(i + 1, last)]);
      pen.fillRect(begin, top + 6, Math.max(end - begin, 1), row - 11);
    }
  }

  #moveCursor() {
    if (!this.width) return;
    this.cursor.style.transform = `translateX(${this.#xOf(this.age)}px)`;
  }

  get names() {
    return this.rows.map(({ id, type }) => `${id} ${moduleNames[type]}`);
  }
}
