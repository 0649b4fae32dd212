// Places of the language server (lines and UTF-16 units, from 0) and of plsc's
// own answers (bytes of UTF-8) in a text of CodeMirror.

export function offsetOf(doc, { line, character }) {
  if (line >= doc.lines) return doc.length;
  const { from, to } = doc.line(line + 1);
  return Math.min(from + character, to);
}

export function positionOf(doc, offset) {
  const line = doc.lineAt(offset);
  return { line: line.number - 1, character: offset - line.from };
}

export function rangeOf(doc, { start, end }) {
  return { from: offsetOf(doc, start), to: offsetOf(doc, end) };
}

export const wholeOf = (doc) => ({ start: { line: 0, character: 0 }, end: positionOf(doc, doc.length) });

// CodeMirror's changes of the server's edits, which are of one text.
export function changesOf(doc, edits) {
  return edits.map(({ range, newText }) => ({ ...rangeOf(doc, range), insert: newText }));
}

const isAscii = (text) => !/[^\x00-\x7f]/.test(text);

// Gives a function from bytes to UTF-16 units, for rising bytes or any.
export function unitsOf(text) {
  if (isAscii(text)) return (byte) => byte;
  const units = [];
  const encoder = new TextEncoder();
  let unit = 0;
  for (const character of text) {
    for (let k = encoder.encode(character).length; k > 0; --k) units.push(unit);
    unit += character.length;
  }
  return (byte) => units[byte] ?? unit;
}
