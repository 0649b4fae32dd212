// How things look, as shaders that do as little as they can: on machines
// without a graphics card every point of the picture is work for the processor.
// Light is reckoned at corners, for boxes have flat sides; colours are those of
// the screen from end to end.
import { CustomBlending, EqualStencilFunc, IncrementStencilOp, ShaderMaterial, Vector3 } from "three";
import { sky } from "./colours.js";

// Where light comes from: above, behind, and a little from the left.
export const toLight = new Vector3(-0.45, -0.35, 1).normalize();

const parts = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255);

const vertexShader = `
uniform vec3 light;
varying vec3 paint;
varying vec2 place;
attribute vec3 color;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  paint = color;
#ifdef IS_LIT
  vec3 up = mat3(modelMatrix) * normal;
  paint *= LIGHT;
#endif
#ifdef HAS_MAP
  place = uv;
#endif
}`;

const fragmentShader = `
uniform sampler2D map;
uniform vec3 sky;
uniform vec3 glow;
uniform vec2 fade;
uniform float opacity;
varying vec3 paint;
varying vec2 place;
void main() {
  vec3 seen = paint + glow;
#ifdef HAS_MAP
  seen *= texture2D(map, place).rgb;
#endif
#ifdef FADES
  seen = mix(seen, sky, clamp((1.0 / gl_FragCoord.w - fade.x) * fade.y, 0.0, 1.0));
#endif
  gl_FragColor = vec4(seen, opacity);
}`;

// On things bright above and not too dark below; on hills so that slopes differ.
const onThings = "(0.66 + 0.14 * up.z + 0.3 * max(dot(up, light), 0.0))";
const onHills = "(0.25 + 0.86 * dot(up, light))";

// `light` is one of these, or nothing; `fading` is shared by all that fade: a uniform, see makeFading.
function material({ light = null, map = null, fading = null, ...rest }) {
  return new ShaderMaterial({
    vertexShader,
    fragmentShader,
    defines: {
      ...(light ? { IS_LIT: 1, LIGHT: light } : {}),
      ...(map ? { HAS_MAP: 1 } : {}),
      ...(fading ? { FADES: 1 } : {}),
    },
    uniforms: {
      light: { value: toLight },
      map: { value: map },
      sky: { value: parts(sky) },
      glow: { value: [0, 0, 0] },
      fade: fading ?? { value: [0, 0] },
      opacity: { value: 1 },
    },
    ...rest,
  });
}

export function makeFading() {
  return { value: [2, 0.1] };
}

// m from the camera, where fading into the sky begins and ends.
export function setFading(fading, near, far) {
  fading.value = [near, 1 / (far - near)];
}

export const planeMaterial = (map, fading) => material({ map, fading });
export const hillMaterial = (map, fading) => material({ map, fading, light: onHills });
export const solidMaterial = (fading = null) => material({ light: onThings, fading });
export const flatMaterial = () => material({});
export const ghostMaterial = () => material({ light: onThings, transparent: true, depthWrite: false });

// Blended with the ground before anything solid is drawn (materials that are
// `transparent` would come after). Where shadows of links overlap, the ground is
// darkened once.
export function shadowMaterial() {
  const made = material({
    blending: CustomBlending,
    depthTest: false,
    depthWrite: false,
    stencilWrite: true,
    stencilRef: 0,
    stencilFunc: EqualStencilFunc,
    stencilZPass: IncrementStencilOp,
  });
  made.uniforms.opacity.value = 0.17;
  made.uniforms.glow.value = [-1, -0.93, -0.85]; // whatever the colour: dark
  return made;
}

export function setGlow(made, colour, share) {
  made.uniforms.glow.value = parts(colour).map((part) => part * share);
}
export function setOpacity(made, opacity) {
  made.uniforms.opacity.value = opacity;
}
export { parts as partsOf };
