// The time of the lives, in s since their start, and how it passes.

// s. After a pause of the browser (another tab) time goes on from where it was.
const longestFrame = 0.1;

export class Clock {
  constructor(end) {
    this.end = end;
    this.time = 0;
    this.speed = 1;
    this.isPlaying = false;
    this.isLooping = false;
    this.listeners = [];
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  #tell() {
    for (const listener of this.listeners) listener(this);
  }

  go(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
    this.#tell();
  }

  // Other lives, at the same time of theirs.
  setEnd(end) {
    this.end = end;
    this.go(this.time);
  }

  play(isPlaying = true) {
    this.isPlaying = isPlaying;
    if (isPlaying && this.time >= this.end) this.time = 0;
    this.#tell();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.#tell();
  }

  // `seconds` on the wall. Time never goes back, whatever the browser's clock
  // does: a frame may be stamped with a time before that of the one before.
  pass(seconds) {
    if (!this.isPlaying) return;
    this.time += Math.min(Math.max(seconds, 0), longestFrame) * this.speed;
    if (this.time >= this.end) {
      this.time = this.isLooping ? 0 : this.end;
      this.isPlaying = this.isLooping;
    }
    this.#tell();
  }
}
