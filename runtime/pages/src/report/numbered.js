// The data of a report calls measures, seasons and experiments by their names;
// the page counts them.
export function numbered(data) {
  const indexOf = (names) => {
    const places = new Map(names.map((name, i) => [name, i]));
    return (name) => places.get(name);
  };
  const find = {
    measure: indexOf(data.measures.map(({ id }) => id)),
    season: indexOf(data.seasons),
    experiment: indexOf(data.experiments.map(({ name }) => name)),
  };
  find.first = find.second = find.experiment;
  const count = (one) => Object.fromEntries(Object.entries(one).map(([key, value]) => [key, find[key] ? find[key](value) : value]));
  const tables = ["curves", "finals", "tests", "diversity", "plasticity", "regulation", "runs", "constants"];
  return { ...data, ...Object.fromEntries(tables.map((name) => [name, data[name].map(count)])) };
}
