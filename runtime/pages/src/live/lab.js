// From the text to the robot and its lives: one question at a time, and of the
// texts that wait only the newest.
import { Newest } from "./newest.js";

const patience = 1500; // ms that something newer waits before what goes on is ended

export class Lab {
  // listeners: onRobot(page), onLife(life, page, input, milliseconds),
  // onWrong(answer), onBusy(isBusy).
  constructor(door, listeners) {
    this.door = door;
    this.listeners = listeners;
    this.work = new Newest((input) => this.#make(input), { patience, overdue: () => door.restart() });
  }

  // {text, name, scenario, genotype}
  make(input) {
    this.work.add(input);
  }

  async #make(input) {
    const { onRobot, onLife, onWrong, onBusy } = this.listeners;
    onBusy(true);
    const begun = performance.now();
    const { text, name, scenario, genotype } = input;
    const common = { text, name, ...(scenario ? { scenario } : {}), ...(genotype ? { genotype } : {}) };
    const robot = await this.door.ask({ ask: "explain", ...common });
    if (robot.ok) {
      onRobot(robot.explained);
      const life = await this.door.ask({ ask: "live", record: true, ...common });
      if (life.ok) onLife(life, robot.explained, input, performance.now() - begun);
      else onWrong(life);
    } else {
      onWrong(robot);
    }
    onBusy(false);
  }
}
