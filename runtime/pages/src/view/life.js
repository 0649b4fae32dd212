// A recorded life as the page uses it: seasons one after the other on one time
// line (s since the start of the first), with their tracks as numbers.
import { between, readTrack } from "./tracks.js";

// s. A camera that followed every step would shake.
const smoothing = 1;

function readMotion(motion) {
  const samples = motion.samples;
  const steps = readTrack(motion.steps, samples);
  return {
    samples,
    times: steps.map((step) => step * motion.step), // s since the season began
    position: readTrack(motion.position, samples),
    turn: readTrack(motion.turn, samples),
    angle: readTrack(motion.joint_angle, samples),
    touch: readTrack(motion.touch, samples),
  };
}

// m, x y z by sample, of the whole robot's centre of mass.
function massCentres(body, motion) {
  const centres = [0, 1, 2].map(() => new Float64Array(motion.samples));
  const mass = body.links.reduce((sum, link) => sum + link.mass, 0);
  body.links.forEach((link, i) => {
    for (let axis = 0; axis < 3; ++axis)
      for (let sample = 0; sample < motion.samples; ++sample)
        centres[axis][sample] += (link.mass / mass) * motion.position[(3 * i + axis) * motion.samples + sample];
  });
  return centres;
}

// The mean over `smoothing`, less at both ends.
function smooth(numbers, times) {
  const sums = new Float64Array(numbers.length + 1);
  numbers.forEach((number, i) => (sums[i + 1] = sums[i] + number));
  let first = 0;
  let last = 0;
  return numbers.map((_, i) => {
    const half = Math.min(smoothing / 2, times[i], times[times.length - 1] - times[i]);
    while (times[first] < times[i] - half - 1e-9) ++first;
    while (last + 1 < times.length && times[last + 1] <= times[i] + half + 1e-9) ++last;
    return (sums[last + 1] - sums[first]) / (last + 1 - first);
  });
}

function readSeason(season, ground, start) {
  const motion = readMotion(season.motion);
  const centres = massCentres(season.body, motion);
  return {
    ...season,
    ground,
    start, // s on the time line
    end: start + season.duration,
    motion,
    centres,
    followed: centres.map((numbers) => smooth(numbers, motion.times)),
    // s that the robot moved; less than `duration` if something ended it
    lived: motion.samples ? motion.times[motion.samples - 1] : 0,
  };
}

// What is shown of a robot at `time` of the season: between two samples.
export function placeOf(season, time) {
  const { samples, times } = season.motion;
  if (samples === 0) return null;
  let low = 0;
  let high = samples - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  if (low === samples - 1) return { index: low, fraction: 0 };
  const fraction = (time - times[low]) / (times[low + 1] - times[low]);
  return { index: low, fraction: Math.min(Math.max(fraction, 0), 1) };
}

export function followedAt(season, place) {
  return season.followed.map((numbers) => between(numbers, season.motion.samples, 0, place));
}

export function seasonAt(life, time) {
  const season = life.seasons.find((one) => time < one.end);
  return season ?? life.seasons[life.seasons.length - 1];
}

export function readLife({ source, remark, grounds, recording }) {
  let start = 0;
  const seasons = recording.seasons.map((season, i) => {
    const read = readSeason(season, grounds[i], start);
    start = read.end;
    return read;
  });
  const { name, genotype, scenario } = recording;
  return { source, remark, name, genotype, scenario, seasons, end: start };
}
