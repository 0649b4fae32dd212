// A text as a literal of C++: in pieces, as compilers bound the length of one.
export function literal(text) {
  const escape = (c) => (/[\\"?]/.test(c) ? `\\${c}` : `\\${c.charCodeAt(0).toString(8).padStart(3, "0")}`);
  const pieces = [];
  for (let at = 0; at < text.length; ) {
    let end = at + 8000;
    if (/[\ud800-\udbff]/.test(text[end - 1] ?? "")) ++end; // one character, two units
    pieces.push(`    "${text.slice(at, end).replace(/[\\"?\x00-\x1f\x7f]/g, escape)}"`);
    at = end;
  }
  return pieces.length ? pieces.join("\n") : '    ""';
}

// As a std::string_view.
export const view = (text) => `std::string_view(\n${literal(text)},\n    ${Buffer.byteLength(text)})`;
