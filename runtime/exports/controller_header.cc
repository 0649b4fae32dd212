// sim/controller.cc once more, as C99 text. The expressions and the order of
// additions are those of the simulator, so that outputs are equal bit for bit:
// whoever changes one must change the other, and a test
// compiles the header and compares. Names begin with the robot's own, as
// several may be included in one program ('@' in the texts below), and nothing
// a user wrote can end a comment or a line (InComment).

#include "runtime/exports/controller_header.h"
#include "grammar/number.h"

#include <fmt/format.h>

#include <numbers>

#include "runtime/exports/controller_tables.h"
#include "runtime/exports/sine_in_c.h"
#include "runtime/scenario/scenario_physics.h"
#include "sim/controller.h"

namespace plsc {

namespace {

bool IsWordLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_';
}

std::string Word(const std::string& text) {
  std::string word;
  for (const char c : text) word += IsWordLetter(c) ? c : '_';
  return word;
}

/// What a comment of C may hold: nothing that ends it, or the line.
std::string InComment(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    // A '/' of a unit may stay, not behind the '*' of a line's beginning.
    const bool is_bad =
        c == '*' || c == '\\' || c == '?' ||
        (c == '/' && (safe.empty() || !IsWordLetter(safe.back()))) ||
        (static_cast<unsigned char>(c) < ' ' && c != '\n');
    safe += is_bad ? '_' : c;
    if (c == '\n') safe += " * ";
  }
  return safe;
}

/// A constant of type double.
std::string DoubleText(double number) {
  const std::string text = PrintPlainNumber(number == 0 ? 0.0 : number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

constexpr const char* kUse = R"( *
 * C99, and nothing but <math.h> (link with -lm). Use, with times in s since
 * birth, angles in rad, and `touched` an int an input, 1 if it meets something,
 * else 0:
 *
 *   static @_state state;
 *   double outputs[@_SPACE];
 *   @_reset(&state);
 *   (then at times 0, 1 / @_update_rate...)
 *   @_update(&state, time, touched, outputs);
 *   speed = @_speed(outputs[j], angle[j]);
 *
 * for each joint j, whose motor holds that speed, rad/s, with up to
 * @_max_torque N m until the next time.
 * That is `controller: coupled`. @_oscillate(time, outputs)
 * in place of _update leaves touch and loops out (`controller: open_loop`).
 * For motors that take angles, _target is the angle that a servo strives for.
 * Results are those of plsc, bit for bit, where the compiler does not join
 * multiplications and additions (-ffp-contract=off).
)";

/// Which of the two plsc ran, and when.
std::string Mode(const SimulationOptions& options) {
  const bool is_coupled = options.controller == ControllerMode::kCoupled;
  std::string text =
      fmt::format(" *\n * plsc ran `controller: {}`, which is @_{}.\n",
                  NameIn(kControllerNames, options.controller),
                  is_coupled ? "update" : "oscillate");
  if (options.servo.refresh == Refresh::kLate)
    text += fmt::format(
        " * It did so with `refresh: late`: not at these times but at the "
        "first step of\n * {} s that is more than 1 / @_update_rate after "
        "the time before,\n * joints held until the first.\n",
        options.physics.step);
  return text;
}

constexpr const char* kTypes = R"(
/* The length of outputs; not 0, as C has no empty arrays. */
#define @_SPACE (@_joints > 0 ? @_joints : 1)

typedef struct @_oscillator {
  int joint;
  double amplitude;
  double period;       /* s */
  double phase_offset; /* in periods */
} @_oscillator;

/* Onto an oscillator: of an input, or (-1) of its own output before. */
typedef struct @_edge {
  int input;
  int oscillator;
  double weight;
} @_edge;

/* What loops remember: the latest output by oscillator. */
typedef struct @_state {
  double previous[@_oscillators > 0 ? @_oscillators : 1];
} @_state;
)";

constexpr const char* kFunctions = R"(
static inline double @_clamp(double value, double low, double high) {
  return value < low ? low : high < value ? high : value;
}

/* Of an oscillator alone: a sine about 0.5. */
static inline double @_oscillation(int oscillator, double time) {
  const @_oscillator* one = &@_oscillator_table[oscillator];
  const double turns = time / one->period - one->phase_offset;
  const double part = turns - round(turns);
  return 0.5 + one->amplitude / 2 * @_sine(@_two_pi * part);
}

static inline void @_reset(@_state* state) {
  int i;
  for (i = 0; i < @_oscillators; ++i) state->previous[i] = @_rest_output;
}

/* Outputs by joint, oscillators alone. */
static inline void @_oscillate(double time, double outputs[@_SPACE]) {
  int i;
  for (i = 0; i < @_joints; ++i) outputs[i] = @_rest_output;
  for (i = 0; i < @_oscillators; ++i)
    outputs[@_oscillator_table[i].joint] = @_oscillation(i, time);
}

/* Outputs by joint, with what loops remember and what is touched: an int an
 * input, or a null pointer for nothing. */
static inline void @_update(@_state* state, double time,
                            const int* touched,
                            double outputs[@_SPACE]) {
  int i, edge;
  for (i = 0; i < @_joints; ++i) outputs[i] = @_rest_output;
  for (i = 0; i < @_oscillators; ++i) {
    double output = @_oscillation(i, time);
    for (edge = 0; edge < @_edges; ++edge) {
      const @_edge* one = &@_edge_table[edge];
      if (one->oscillator != i) continue;
      if (one->input < 0)
        output += one->weight * (state->previous[i] - @_rest_output);
      else if (touched && touched[one->input])
        output += one->weight;
    }
    output = @_clamp(output, 0.0, 1.0);
    state->previous[i] = output;
    outputs[@_oscillator_table[i].joint] = output;
  }
}

/* rad, what the servo of a joint with that output strives for. */
static inline double @_target(double output) {
  return -@_range +
         @_clamp(output, @_min_output, @_max_output) * 2 * @_range;
}

/* rad/s, of the servo of a joint that is at `angle`. */
static inline double @_speed(double output, double angle) {
  return @_clamp(@_gain * (@_target(output) - angle), -@_max_speed,
                 @_max_speed);
}
)";

/// The text with each '@' replaced by the names' beginning.
std::string Named(std::string_view text, const std::string& names) {
  std::string named;
  for (const char c : text) named += c == '@' ? names : std::string(1, c);
  return named;
}

std::string Lists(const RobotModel& model, const ControllerTables& tables) {
  std::string text = " *\n * Joints, by number:";
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    text += fmt::format("\n *   {} {}", i, model.joints[i]);
  text += model.joints.empty() ? " none\n" : "\n";
  text += " * Inputs, by number:";
  for (std::size_t i = 0; i < tables.inputs.size(); ++i)
    text += fmt::format("\n *   {} {}", i, tables.inputs[i]);
  return text + (tables.inputs.empty() ? " none\n" : "\n");
}

std::string Sizes(const RobotModel& model, const ControllerTables& tables) {
  return fmt::format(
      "enum {{\n  @_joints = {},\n  @_inputs = {},\n  @_oscillators = {},\n"
      "  @_edges = {}\n}};\n",
      model.joints.size(), tables.inputs.size(), tables.oscillators.size(),
      tables.edges.size());
}

std::string Constants(const ServoOptions& servo) {
  struct Row {
    const char* name;
    double value;
    const char* unit;
  };
  const Row rows[] = {
      {"update_rate", servo.update_rate, "Hz"},
      {"range", servo.range, "rad, limits of joints are -range and +range"},
      {"gain", servo.gain, "1/s"},
      {"max_speed", servo.max_speed, "rad/s"},
      {"max_torque", servo.max_torque, "N m"},
      {"min_output", kMinOutput, "what a servo takes"},
      {"max_output", kMaxOutput, "likewise"},
      {"rest_output", kRestOutput, "of a joint without oscillator"},
      {"two_pi", 2 * std::numbers::pi, "rad"}};
  std::string text = "\n";
  for (const Row& row : rows)
    text += fmt::format("static const double @_{} = {}; /* {} */\n", row.name,
                        DoubleText(row.value), row.unit);
  return text;
}

std::string Tables(const ControllerTables& tables) {
  std::string text = "\nstatic const @_oscillator @_oscillator_table[] = {\n";
  for (const TableOscillator& one : tables.oscillators)
    text += fmt::format("  {{{}, {}, {}, {}}},\n", one.joint,
                        DoubleText(one.amplitude), DoubleText(one.period),
                        DoubleText(one.phase_offset));
  if (tables.oscillators.empty()) text += "  {0, 0.0, 1.0, 0.0} /* unused */\n";
  text += "};\n\nstatic const @_edge @_edge_table[] = {\n";
  for (const TableEdge& edge : tables.edges)
    text += fmt::format("  {{{}, {}, {}}},\n",
                        edge.is_loop ? -1 : static_cast<int>(edge.input),
                        edge.oscillator, DoubleText(edge.weight));
  if (tables.edges.empty()) text += "  {0, 0, 0.0} /* unused */\n";
  return text + "};\n";
}

}  // namespace

std::string NamesInC(const RobotModel& model) {
  const std::string word = Word(model.name + "_" + model.environment);
  const bool is_name = word[0] < '0' || word[0] > '9';
  return is_name ? word : "robot_" + word;
}

std::string ControllerHeader(const RobotModel& model) {
  const ControllerTables tables = TablesOf(model);
  const std::string body =
      kUse + Mode(model.options) + Lists(model, tables) + " */\n" +
      "#ifndef @_CONTROLLER_H\n#define @_CONTROLLER_H\n\n"
      "#include <math.h>\n\n" +
      Sizes(model, tables) + kTypes + Constants(model.options.servo) +
      Tables(tables) + kSineInC + kFunctions + "\n#endif\n";
  return "/* " + InComment(NotesOn(model)) + "\n" +
         Named(body, NamesInC(model));
}

}  // namespace plsc
