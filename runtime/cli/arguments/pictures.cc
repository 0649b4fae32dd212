// Options and help of the commands that make pictures.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

namespace {

std::string CheckEnding(const std::string& path) {
  if (path == "-" || path.ends_with(".svg") || path.ends_with(".png"))
    return "";
  return "expected a file that ends in .svg or .png, or -, found '" + path +
         "'";
}

}  // namespace

CLI::App* AddDraw(CLI::App& app, DrawCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "draw", "Draw bodies or brains, several environments side by side");
  sub->add_option("FILE", command.file,
                  "a genotype file (- is standard input), or the store of a "
                  "run")
      ->required();
  sub->add_option("ROBOT", command.individual,
                  "which robot of the run: a number, or best")
      ->option_text("ROBOT");
  sub->add_option("--env", command.environments,
                  "what the robot senses: STATE=VALUE,... or the name of an "
                  "environment of the file, of a season of the run; may be "
                  "repeated (default: all of them)")
      ->option_text("ENVIRONMENT");
  CLI::Option* brain =
      sub->add_flag("--brain", command.brain, "the brain instead of the body");
  sub->add_option("--colour,--color", command.colour,
                  "what colours tell of a module: its type (default), or the "
                  "rule that made it")
      ->transform(CLI::CheckedTransformer(std::map<std::string, ColourBy>{
          {"type", ColourBy::kType}, {"rule", ColourBy::kRule}}))
      ->type_name("type|rule")
      ->option_text("type|rule")
      ->excludes(brain);
  CLI::Option* output =
      sub->add_option("-o,--output", command.output,
                      "the picture, an .svg or a .png; - prints the SVG "
                      "(default: draw in the "
                      "terminal)")
          ->option_text("FILE")
          ->check(CheckEnding);
  AddForce(sub, command.force);
  sub->add_option("--scale", command.scale,
                  "of a .png: its pixels per pixel of the .svg (default 2; a "
                  "module is 100 pixels of the .svg)")
      ->option_text("NUMBER")
      ->check(CLI::Range(0.05, 50.0))
      ->needs(output);
  sub->add_flag("--terminal", command.terminal,
                "draw in the terminal, even with -o");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
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
  return sub;
}

}  // namespace plsc::cli
