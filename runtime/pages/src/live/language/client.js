// The client of our own language server, spoken to through the door. Messages
// go one after the other, and of texts only the newest is sent.

const uri = "file:///robot.pls";
const document = { uri };

export class LanguageClient {
  // listeners: onText(client), called when the server knows the newest text and
  // has looked at it; onDiagnostics(diagnostics) of the newest text.
  constructor(door, listeners) {
    this.door = door;
    this.listeners = listeners;
    this.last = Promise.resolve();
    this.ids = 0;
    this.version = 0;
    this.sent = 0; // the version that the server has
    this.text = "";
    this.legend = [];
    this.environment = "";
    this.isPumping = false;
    this.isOpen = false;
  }

  change(text) {
    this.text = text;
    ++this.version;
    this.#pump();
  }

  // A server that was started again knows nothing.
  reopen() {
    this.isOpen = false;
    this.sent = 0;
    this.#pump();
  }

  // The environment that hints are about: a name, or "" for the first.
  async choose(environment) {
    this.environment = environment;
    if (!this.isOpen) return;
    await this.#command();
    this.listeners.onText(this);
  }

  #command() {
    return this.request("workspace/executeCommand", { command: "plsc.chooseEnvironment", arguments: [this.environment] });
  }

  // The answer's result; null where there is none, whatever the reason.
  async request(method, params) {
    this.#flush();
    const id = ++this.ids;
    const messages = await this.#send({ jsonrpc: "2.0", id, method, params });
    return messages.find((message) => message.id === id && !message.method)?.result ?? null;
  }

  ofDocument(method, params = {}) {
    return this.request(method, { textDocument: document, ...params });
  }

  #notify(method, params) {
    return this.#send({ jsonrpc: "2.0", method, params });
  }

  #send(message) {
    return this.#ask({ ask: "lsp", message });
  }

  #ask(request) {
    const answered = this.last.then(async () => {
      const answer = await this.door.ask(request);
      const messages = answer.ok ? answer.messages : [];
      messages.forEach((message) => this.#hear(message));
      this.hasWork = answer.ok && answer.has_work;
      return messages;
    });
    this.last = answered;
    return answered;
  }

  #hear({ method, params }) {
    if (method !== "textDocument/publishDiagnostics") return;
    if (params.version === this.version) this.listeners.onDiagnostics(params.diagnostics);
  }

  #open() {
    const textDocument = {
      completion: { completionItem: { snippetSupport: true } },
      hover: { contentFormat: ["markdown"] },
    };
    const opening = this.request("initialize", { processId: null, rootUri: null, capabilities: { textDocument } });
    opening.then((result) => (this.legend = result?.capabilities.semanticTokensProvider?.legend.tokenTypes ?? []));
    this.#notify("initialized", {});
    this.isOpen = true; // texts may follow
    if (this.environment) this.#command();
  }

  // Sends the newest text, if the server has another one.
  #flush() {
    if (!this.isOpen || this.sent === this.version || this.version === 0) return;
    const isFirst = this.sent === 0;
    this.sent = this.version;
    const textDocument = { uri, version: this.version };
    if (isFirst) this.#notify("textDocument/didOpen", { textDocument: { ...textDocument, languageId: "plsc", text: this.text } });
    else this.#notify("textDocument/didChange", { textDocument, contentChanges: [{ text: this.text }] });
  }

  async #pump() {
    if (this.isPumping) return;
    this.isPumping = true;
    if (!this.isOpen) this.#open();
    while (this.sent !== this.version) {
      this.#flush();
      await this.last;
      while (this.hasWork && this.sent === this.version) await this.#ask({ ask: "idle" });
      if (this.sent === this.version) await this.listeners.onText(this);
    }
    this.isPumping = false;
  }
}
