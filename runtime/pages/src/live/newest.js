// Work whose input changes faster than it is done: one piece at a time, and of
// those that wait only the newest.

export class Newest {
  // work(input) gives a promise; overdue() is called when something newer has
  // waited for `patience` ms.
  constructor(work, { patience = Infinity, overdue = () => {} } = {}) {
    this.work = work;
    this.patience = patience;
    this.overdue = overdue;
    this.waiting = [];
    this.isBusy = false;
  }

  add(input) {
    this.waiting = [input];
    if (!this.isBusy) this.#run();
    else if (this.patience < Infinity) this.timer ??= setTimeout(() => this.overdue(), this.patience);
  }

  async #run() {
    this.isBusy = true;
    while (this.waiting.length > 0) {
      clearTimeout(this.timer);
      this.timer = undefined;
      await this.work(this.waiting.pop());
    }
    this.isBusy = false;
  }
}
