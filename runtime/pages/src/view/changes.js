// What two bodies of one robot have in common: boxes of the same kind at the
// same place when both are at rest, seen from the core.

// mm; far above what rounding moves, far below the size of any part.
const grain = 2;

function placesOf(body) {
  return body.links.flatMap((link, i) =>
    link.boxes.map((box, k) => {
      const centre = box.centre.map((part, axis) => part + link.rest[axis]);
      const key = [box.part, ...centre.map((part) => Math.round((part * 1000) / grain))].join(" ");
      return { key, centre, box, link: i, index: k };
    }),
  );
}

// {isNew(link, index): of a box of `after`, gone: [{centre, box}] of `before`}
export function compareBodies(before, after) {
  const old = placesOf(before);
  const now = placesOf(after);
  const oldKeys = new Set(old.map((place) => place.key));
  const nowKeys = new Set(now.map((place) => place.key));
  const fresh = new Set(now.filter((place) => !oldKeys.has(place.key)).map((place) => `${place.link} ${place.index}`));
  return {
    isNew: (link, index) => fresh.has(`${link} ${index}`),
    gone: old.filter((place) => !nowKeys.has(place.key)),
  };
}

// For the first season, and where the body is the same.
export const nothingChanged = { isNew: () => false, gone: [] };
