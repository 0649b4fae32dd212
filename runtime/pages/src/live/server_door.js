// The door to `plsc live`: POST /ask, POST /save and events of the file.

export class ServerDoor {
  // Addresses are relative to the page's, whose path has the token without
  // which the server answers nobody.
  constructor() {
    this.ids = 0;
    this.onRestart = () => {};
    this.going = new AbortController();
  }

  async #post(path, body, signal) {
    try {
      const response = await fetch(path, {
        method: "POST",
        headers: { "Content-Type": "application/json" },
        body: JSON.stringify(body),
        signal,
      });
      const text = await response.text();
      try {
        return JSON.parse(text);
      } catch {
        return { ok: false, error: `the server answers ${response.status}: ${text.slice(0, 200)}` };
      }
    } catch (error) {
      if (error.name === "AbortError") return { ok: false, error: "ended, because something newer is to be done", ended: true };
      return { ok: false, error: "plsc live does not answer: was it ended?", isGone: true };
    }
  }

  ask(request) {
    const isLanguage = request.ask === "lsp" || request.ask === "idle";
    return this.#post("ask", { id: ++this.ids, ...request }, isLanguage ? undefined : this.going.signal);
  }

  restart() {
    this.going.abort();
    this.going = new AbortController();
  }

  // {ok, version}, or {ok: false, conflict: {text, version}} when the file is
  // not what the text was made from.
  save(text, version) {
    return this.#post("save", { text, version });
  }

  // onFile({text, version}) when another program changed the file.
  follow(onFile, onConnection) {
    const events = new EventSource("events");
    events.addEventListener("file", (event) => onFile(JSON.parse(event.data)));
    events.addEventListener("open", () => onConnection(true));
    events.addEventListener("error", () => onConnection(false));
  }
}
