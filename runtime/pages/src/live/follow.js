// Joined with a file by `plsc live`: what another program saves comes in, what
// is written here is saved, and where both happened one sees both.
import { element } from "../common/dom.js";

const resting = 400; // ms after the last change

export class Follow {
  // say(text, isWrong) tells how it stands; setText(text) changes the editor.
  constructor(door, editor, version, { say, setText }) {
    this.door = door;
    this.editor = editor;
    this.say = say;
    this.setText = setText;
    this.known = { text: editor.text, version }; // of the file
    this.object = element("section", { class: "conflict", hidden: true, role: "alertdialog", "aria-label": "Both texts changed" });
    door.follow(
      (file) => this.#changed(file),
      (isThere) => say(isThere ? "joined with the file" : "plsc live does not answer", !isThere),
    );
  }

  get isChanged() {
    return this.editor.text !== this.known.text;
  }

  // The text was edited here.
  touch() {
    clearTimeout(this.timer);
    if (!this.isChanged || this.conflict) return;
    this.say("not saved yet");
    this.timer = setTimeout(() => this.#save(), resting);
  }

  async #save() {
    if (this.isSaving) return (this.isAsked = true);
    this.isSaving = true;
    const { text } = this.editor;
    const answer = await this.door.save(text, this.known.version);
    this.isSaving = false;
    if (answer.conflict) return this.#show(answer.conflict);
    if (!answer.ok) return this.say(answer.error, true);
    this.known = { text, version: answer.version };
    this.say("saved");
    if (this.isAsked || this.isChanged) {
      this.isAsked = false;
      this.touch();
    }
  }

  #changed(file) {
    if (file.version === this.known.version) return;
    if (file.text === null) {
      // What is written here from now on makes it again.
      this.known = { text: this.known.text, version: file.version };
      return this.say(`the file is gone: ${file.reason}`, true);
    }
    if (file.text === this.editor.text) {
      this.known = file;
      return this.#close();
    }
    if (this.isChanged) return this.#show(file);
    clearTimeout(this.timer);
    this.known = file;
    this.setText(file.text);
    this.say("changed by another program");
  }

  #close() {
    this.conflict = null;
    this.object.hidden = true;
  }

  #show(file) {
    clearTimeout(this.timer);
    this.conflict = file;
    this.say("changed here and in the file", true);
    const text = (label, body, button, act) =>
      element("div", {}, element("h3", {}, label), element("pre", { tabindex: 0 }, body), element("button", { type: "button", onclick: act }, button));
    this.object.replaceChildren(
      element("h2", {}, "Another program changed the file while you edited here"),
      element(
        "div",
        { class: "both" },
        file.text === null
          ? element("p", {}, `The file cannot be read: ${file.reason}`)
          : text("In the file", file.text, "Take this one", () => this.#take(file)),
        text("Here", this.editor.text, "Keep this one", () => this.#keep(file)),
      ),
    );
    this.object.hidden = false;
    this.object.querySelector("button").focus();
  }

  #take(file) {
    this.#close();
    this.known = file;
    this.setText(file.text);
    this.say("as in the file");
  }

  #keep(file) {
    this.#close();
    this.known = file;
    this.touch();
  }
}
