#include "runtime/cli/arguments/pictures.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

namespace {

std::string CheckEnding(const std::string& path) {
  if (path == "-" || path.ends_with(".svg") || path.ends_with(".png"))
    return "";
  return "expected a file that ends in .svg or .png, or -, found '" + path +
         "'";
}

}  // namespace

void Add(Options& options, DrawCommand& command) {
  options.Command("draw",
                  "Draw bodies or brains, several environments side by side");
  options
      .Add("FILE", command.file,
           "a genotype file (- is standard input), or the store of a "
           "run")
      .Required();
  AddRobot(options, command.individual);
  options
      .Add("--env", command.environments,
           "what the robot senses: STATE=VALUE,... or the name of an "
           "environment of the file, of a season of the run; may be "
           "repeated (default: all of them)")
      .ValueName("ENVIRONMENT");
  const Option brain =
      options.Flag("--brain", command.brain, "the brain instead of the body");
  options
      .Choice("--colour,--color", command.colour,
              "what colours tell of a module: its type (default), or the "
              "rule that made it",
              {{"type", ColourBy::kType}, {"rule", ColourBy::kRule}})
      .Excludes(brain);
  const Option output =
      options
          .Add("-o,--output", command.output,
               "the picture, an .svg or a .png; - prints the SVG "
               "(default: draw in the "
               "terminal)")
          .ValueName("FILE")
          .Check(CheckEnding);
  AddForce(options, command.force);
  options
      .Add("--scale", command.scale,
           "of a .png: its pixels per pixel of the .svg (default 2; a "
           "module is 100 pixels of the .svg)")
      .ValueName("NUMBER")
      .Range(0.05, 50.0)
      .Needs(output);
  options.Flag("--terminal", command.terminal,
               "draw in the terminal, even with -o");
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "Bodies are seen from above, the core's front up. What differs from the "
      "first\nenvironment is marked: thick lines where that has no module, "
      "dashed ones (in the\nterminal double ones) where it has another, a "
      "dotted square where only it has one.\nA module is the same one where it "
      "hangs at the same place of the tree, is of the\nsame kind and rolled "
      "the same way. Brains are marked likewise: nodes of the same\nplaces, "
      "edges between the same nodes, dashed (double) where numbers differ.\n\n"
      "  plsc draw robot.pls\n"
      "  plsc draw robot.pls --env flat --env tilted -o robot.svg\n"
      "  plsc draw robot.pls --colour rule -o robot.png --scale 3\n"
      "  plsc draw robot.pls --brain -o brain.svg\n"
      "  plsc draw robot.pls -o - | rsvg-convert -f pdf -o robot.pdf\n"
      "  plsc draw run1.sqlite best -o best.svg");
}

}  // namespace plsc::cli
