// One life in 3-D: the scene of each season, made when it is first seen.
import { Group, Scene, Vector3 } from "three";
import { compareBodies, nothingChanged } from "./changes.js";
import { makeGround } from "./ground.js";
import { followedAt, placeOf } from "./life.js";
import { makeFading, setFading, toLight } from "./materials.js";
import { makePath } from "./path.js";
import { Robot, unlivedHeight } from "./robot.js";
import { makeTargets } from "./targets.js";

function changeOf(seasons, i) {
  const before = seasons[i - 1];
  if (!before || seasons[i].change !== "body" || before.body.links.length === 0) return nothingChanged;
  return compareBodies(before.body, seasons[i].body);
}

class SeasonScene {
  constructor(seasons, i, fading) {
    this.season = seasons[i];
    this.object = new Group();
    this.ground = makeGround(this.season.terrain, this.season.ground, fading);
    this.object.add(this.ground.object);
    if (this.season.body.links.length > 0) {
      this.robot = new Robot(this.season, changeOf(seasons, i));
      this.object.add(this.robot.object, this.robot.shadow);
    }
    this.path = makePath(this.season, this.ground);
    this.object.add(this.path, makeTargets(this.season, this.ground));
  }

  // Gives where the robot is, m.
  pose(age) {
    const place = placeOf(this.season, age);
    const at = place ? followedAt(this.season, place) : [0, 0, unlivedHeight];
    this.ground.moveTo(at);
    this.path.geometry.setDrawRange(0, place ? place.index + 1 : 0);
    if (!this.robot) return at;
    this.robot.pose(place, age);
    this.robot.shadow.visible = place !== null;
    if (place) {
      const below = new Vector3(at[0], at[1], this.ground.heightAt(at[0], at[1]));
      this.robot.castShadow(this.ground.normal, below, toLight);
    }
    return at;
  }
}

// m, how far any part of any of the bodies is from its core.
export function radiusOf(life) {
  const boxes = life.seasons.flatMap(({ body }) =>
    body.links.flatMap((link) => link.boxes.map((box) => box.centre.map((part, axis) => part + link.rest[axis]))),
  );
  return boxes.reduce((most, centre) => Math.max(most, Math.hypot(...centre)), 0.08) + 0.03;
}

export class LifeScene {
  constructor(life) {
    this.life = life;
    this.scene = new Scene();
    this.fading = makeFading();
    this.seasons = life.seasons.map(() => null);
    this.shown = null;
  }

  // Gives where to look, m, and whether that is elsewhere than before.
  pose(season, age) {
    const i = this.life.seasons.indexOf(season);
    this.seasons[i] ??= new SeasonScene(this.life.seasons, i, this.fading);
    const now = this.seasons[i];
    const isNew = now !== this.shown;
    if (isNew) {
      if (this.shown) this.scene.remove(this.shown.object);
      this.scene.add(now.object);
      this.shown = now;
    }
    return { target: now.pose(age), isNew };
  }

  // Frees what the graphics card keeps. What scenes share comes back when one
  // that needs it is drawn.
  dispose() {
    for (const season of this.seasons)
      season?.object.traverse(({ geometry, material }) => {
        geometry?.dispose();
        material?.dispose();
      });
  }

  // Before it is drawn: `distance` in m from the camera to what it looks at.
  prepare(distance, isRough) {
    setFading(this.fading, 1 + 2 * distance, 4 + 5 * distance);
    this.shown.ground.setRough(isRough);
  }
}
