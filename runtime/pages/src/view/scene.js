// One life in 3-D: the scene of each season, made when it is first seen.
import { DirectionalLight, Fog, Group, HemisphereLight, Scene, Vector3 } from "three";
import { compareBodies, nothingChanged } from "./changes.js";
import { sky } from "./colours.js";
import { makeGround } from "./ground.js";
import { followedAt, placeOf } from "./life.js";
import { makePath } from "./path.js";
import { Robot } from "./robot.js";

const toLight = new Vector3(-0.45, -0.35, 1).normalize();

function changeOf(seasons, i) {
  const before = seasons[i - 1];
  if (!before || seasons[i].change !== "body" || before.body.links.length === 0) return nothingChanged;
  return compareBodies(before.body, seasons[i].body);
}

class SeasonScene {
  constructor(seasons, i) {
    this.season = seasons[i];
    this.object = new Group();
    this.ground = makeGround(this.season.terrain, this.season.ground);
    this.object.add(this.ground.object);
    if (this.season.body.links.length > 0) {
      this.robot = new Robot(this.season, changeOf(seasons, i));
      this.object.add(this.robot.object, this.robot.shadow);
    }
    this.path = makePath(this.season, this.ground);
    this.object.add(this.path);
  }

  // Gives where the robot is, m.
  pose(age) {
    const place = placeOf(this.season, age);
    const at = place ? followedAt(this.season, place) : [0, 0, 0.1];
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
    this.scene.fog = new Fog(sky, 2, 12);
    const sun = new DirectionalLight("#ffffff", 2.1);
    sun.position.copy(toLight);
    this.scene.add(new HemisphereLight("#ffffff", "#9aa5b5", 1.7), sun);
    this.seasons = life.seasons.map(() => null);
    this.shown = null;
  }

  // Gives where to look, m, and whether that is elsewhere than before.
  pose(season, age) {
    const i = this.life.seasons.indexOf(season);
    this.seasons[i] ??= new SeasonScene(this.life.seasons, i);
    const now = this.seasons[i];
    const isNew = now !== this.shown;
    if (isNew) {
      if (this.shown) this.scene.remove(this.shown.object);
      this.scene.add(now.object);
      this.shown = now;
    }
    return { target: now.pose(age), isNew };
  }

  // Ground fades out some way behind what the camera looks at.
  fade(distance) {
    this.scene.fog.near = 1.5 + 2 * distance;
    this.scene.fog.far = 5 + 5 * distance;
  }
}
