// Series of numbers as recordings have them (docs/formats.md): differences of
// whole multiples of a unit, zigzag, in groups of 7 bits, in base64.

// All rows one after the other; row r, sample s is at r * samples + s.
export function readTrack({ unit, rows, data }, samples) {
  const text = atob(data);
  const numbers = new Float32Array(rows * samples);
  let at = 0;
  const next = () => {
    let number = 0;
    let factor = 1;
    let byte;
    do {
      byte = text.charCodeAt(at++);
      number += (byte & 127) * factor;
      factor *= 128;
    } while (byte > 127);
    return number % 2 ? -(number + 1) / 2 : number / 2;
  };
  for (let row = 0; row < rows; ++row) {
    let number = 0;
    for (let sample = 0; sample < samples; ++sample) {
      number += next();
      numbers[row * samples + sample] = number * unit;
    }
  }
  return numbers;
}

// The number of a row at a place between samples, {index, fraction}.
export function between(numbers, samples, row, place) {
  const at = row * samples + place.index;
  const here = numbers[at];
  return place.fraction > 0 ? here + (numbers[at + 1] - here) * place.fraction : here;
}
