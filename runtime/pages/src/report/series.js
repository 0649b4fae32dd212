// How each experiment looks in every chart: a colour of Okabe and Ito's
// palette, which all eyes tell apart, and a dash pattern for prints without
// colour. Static experiments, which others are measured against, are grey.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];
const dashes = [null, "8 3", "3 2", "8 3 2 3", "12 3", "2 4", "6 2 2 2 2 2"];
const staticGrey = "#666666";
const staticDashes = ["1.5 3", "5 2 1.5 2", "1.5 2 1.5 5"];

// One style an experiment, in their order.
export function stylesOf(experiments) {
  let compared = 0;
  const statics = new Map(); // by the season they are shown in
  return experiments.map((one) => {
    if (one.static) {
      const season = one.seasons[0].shown_in;
      const nth = statics.get(season) ?? 0;
      statics.set(season, nth + 1);
      return { colour: staticGrey, dash: staticDashes[nth % staticDashes.length], width: 1.75 };
    }
    const nth = compared++;
    return { colour: colours[nth % colours.length], dash: dashes[nth % dashes.length], width: 2 };
  });
}

// What rules are held in: distinct lightness, too.
export const patternColours = ["#0072b2", "#e69f00", "#009e73", "#d9d9d9", "#cc79a7", "#56b4e9", "#d55e00", "#000000"];
