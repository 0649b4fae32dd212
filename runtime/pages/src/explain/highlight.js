// Pointing: what the pointer is over, or has the focus, lights up with all that
// belongs to it; a click (Enter, a tap) keeps it until the next one, or Escape.
import { linksOf } from "./links.js";

export class Highlight {
  // `root` holds all elements with data-key; told(key, isKept) is called when
  // another key, or null, is shown.
  constructor(root, robot, told) {
    this.root = root;
    this.robot = robot;
    this.told = told;
    this.kept = null;
    this.shown = null;
    this.elements = new Map();
    for (const element of root.querySelectorAll("[data-key]")) {
      const all = this.elements.get(element.dataset.key) ?? [];
      this.elements.set(element.dataset.key, [...all, element]);
    }
    const keyOf = (event) => event.target.closest?.("[data-key]")?.dataset.key ?? null;
    root.addEventListener("pointerover", (event) => event.pointerType === "mouse" && this.show(keyOf(event) ?? this.kept, event.target));
    root.addEventListener("pointerleave", () => this.show(this.kept));
    root.addEventListener("focusin", (event) => keyOf(event) && this.show(keyOf(event), event.target));
    root.addEventListener("focusout", () => this.show(this.kept));
    root.addEventListener("click", (event) => keyOf(event) && this.keep(keyOf(event), event.target));
    root.addEventListener("keydown", (event) => this.onKey(event, keyOf(event)));
  }
  // A second time, it is let go.
  keep(key, origin) {
    this.kept = this.kept === key ? null : key;
    this.shown = undefined; // to be told, although it is shown already
    this.show(key, origin);
  }
  letGo() {
    this.kept = null;
    this.shown = undefined;
    this.show(null);
  }
  onKey(event, key) {
    if (event.key === "Escape") return this.letGo();
    // Buttons press themselves; shapes of an SVG do not.
    if ((event.key === "Enter" || event.key === " ") && key && !(event.target instanceof HTMLButtonElement)) {
      event.preventDefault();
      return this.keep(key, event.target);
    }
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const group = step && key && event.target.closest("[data-group]");
    if (!group) return;
    const all = [...group.querySelectorAll("[data-key][tabindex]")].filter((one) => one.getClientRects().length > 0);
    const next = all[all.indexOf(event.target.closest("[data-key]")) + step];
    if (!next) return;
    event.preventDefault();
    next.focus();
  }
  show(key, origin) {
    if (key === this.shown) return;
    this.shown = key;
    for (const element of this.root.querySelectorAll(".lit, .kin, .pointed")) element.classList.remove("lit", "kin", "pointed");
    this.root.classList.toggle("pointing", key !== null);
    if (key !== null) {
      const { lit, kin } = linksOf(this.robot, key);
      this.mark(lit, "lit");
      this.mark(kin, "kin");
      this.mark([key], "pointed");
      this.scroll(origin);
    }
    this.told(key, key !== null && key === this.kept);
  }
  mark(keys, name) {
    for (const key of keys) for (const element of this.elements.get(key) ?? []) element.classList.add(name);
  }
  // Long lists show the first thing that is lit, but for the list pointed at:
  // it would slip away under the pointer.
  scroll(origin) {
    for (const box of this.root.querySelectorAll("[data-scroll]")) {
      if (origin && box.contains(origin)) continue;
      const first = box.querySelector(".lit");
      if (!first || box.scrollHeight <= box.clientHeight) continue;
      const from = first.getBoundingClientRect().top - box.getBoundingClientRect().top;
      if (from < 0 || from > box.clientHeight - 30) box.scrollTop += from - box.clientHeight / 3;
    }
  }
}

// In each group one element can be reached with Tab, the others from it with
// the arrow keys: there may be thousands.
export function enter(root) {
  for (const group of root.querySelectorAll("[data-group]"))
    [...group.querySelectorAll("[data-key]")].forEach((one, i) => one.setAttribute("tabindex", i === 0 ? "0" : "-1"));
}
