// A module looks as it does in the drawings (runtime/pictures/svg_style).
export const moduleColours = {
  C: "#ffe135",
  B: "#5b8ff9",
  A1: "#d7263d",
  A2: "#ff9f9f",
  T: "#2ca02c",
};
// Of a sensor that touches something, in the scene and in the plots.
export const touchColour = "#7b2cff";

export const moduleNames = {
  C: "core",
  B: "brick",
  A1: "vertical joint",
  A2: "horizontal joint",
  T: "touch sensor",
};

// Servos are dark in any joint, so that one sees what turns against what.
export const servoColour = "#4a4f57";

// Also the ground: it fades into the sky, and robots stand out from both.
export const sky = "#f5f7fa";
export const ghostColour = "#8a94a3";
export const pathColour = "#0072b2";
export const targetColour = "#d55e00";
export const newColour = "#ff7a00";
