#pragma once

// The one table of symbols: name, category, parameters and their ranges,
// documentation. Everything that knows symbols (compiler, printer, evolver,
// development, help texts) reads it here. Says nothing about what a symbol
// does to a body; that is runtime/develop.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plsc {

/// Index into Alphabet::symbols().
enum class SymbolId : std::uint16_t {};

/// Table 1's headings. Symbols of a user's own alphabet are kModule when
/// replaceable (they can have rules) and kTerminal when not.
enum class Category : std::uint8_t {
  kModule,
  kMounting,            ///< Morphology-mounting commands
  kMoving,              ///< Morphology-moving commands
  kControllerMoving,    ///< Controller-moving commands
  kControllerChanging,  ///< Controller-changing commands
  kTerminal,
};

/// How fresh values of a parameter are drawn (Table 1).
enum class Sampling : std::uint8_t {
  kUniform,        ///< U(low, high)
  kNormal,         ///< N(0, 1)
  kCeilAbsNormal,  ///< ceil(|N(0, 1)|), at least 1: t and d of move_ref_*
};

struct Parameter {
  std::string name;
  bool is_integer = false;
  double low = -std::numeric_limits<double>::infinity();  ///< inclusive
  double high = std::numeric_limits<double>::infinity();  ///< inclusive
  Sampling sampling = Sampling::kUniform;
  std::string doc;
};

struct SymbolInfo {
  std::string name;
  Category category = Category::kTerminal;
  bool is_replaceable = false;  ///< may be the head of a rule
  std::vector<Parameter> parameters;
  std::string doc;
};

/// Most parameters that a symbol may have: A1 and A2 of Table 1 have the most,
/// w, a, p, o. A Symbol stores them in place, so the number costs memory in
/// every symbol of every genotype.
inline constexpr int kMaxParameters = 4;

/// Immutable once made; shared by all genotypes that use it.
class Alphabet {
 public:
  Alphabet(std::string name, int version, std::vector<SymbolInfo> symbols);

  const std::string& name() const { return name_; }
  /// Of a built-in vocabulary, 1 or more; 0 for a file's own alphabet.
  int version() const { return version_; }
  bool is_built_in() const { return version_ > 0; }
  const std::vector<SymbolInfo>& symbols() const { return symbols_; }
  const SymbolInfo& operator[](SymbolId id) const {
    return symbols_[static_cast<std::size_t>(id)];
  }
  std::optional<SymbolId> Find(std::string_view name) const;
  /// All ids of a category, in table order.
  std::vector<SymbolId> OfCategory(Category category) const;

  friend bool operator==(const Alphabet& a, const Alphabet& b);

 private:
  std::string name_;
  int version_;
  std::vector<SymbolInfo> symbols_;
  // Find's hash table: index + 1 of the symbol, 0 for an empty slot. Every
  // symbol of every production is looked up.
  std::vector<std::uint32_t> slots_;
};

using AlphabetPtr = std::shared_ptr<const Alphabet>;

/// The built-in alphabet `plasticoding 1`: Table 1 of Miras et al. 2020.
/// Always the same object.
const AlphabetPtr& PlasticodingAlphabet();

/// SymbolId values of `plasticoding 1`, in Table 1's order.
namespace plasticoding {
inline constexpr SymbolId kC{0};
inline constexpr SymbolId kB{1};
inline constexpr SymbolId kA1{
    2};  ///< vertical joint: axis of rotation vertical
inline constexpr SymbolId kA2{3};  ///< horizontal joint
inline constexpr SymbolId kT{4};
inline constexpr SymbolId kAddRight{5};
inline constexpr SymbolId kAddFront{6};
inline constexpr SymbolId kAddLeft{7};
inline constexpr SymbolId kMoveBack{8};
inline constexpr SymbolId kMoveRight{9};
inline constexpr SymbolId kMoveFront{10};
inline constexpr SymbolId kMoveLeft{11};
inline constexpr SymbolId kMoveRefI{12};
inline constexpr SymbolId kMoveRefN{13};
inline constexpr SymbolId kAddEdge{14};
inline constexpr SymbolId kLoop{15};
inline constexpr SymbolId kMutateEdge{16};
inline constexpr SymbolId kMutateAmp{17};
inline constexpr SymbolId kMutatePer{18};
inline constexpr SymbolId kMutateOff{19};

/// Parameter positions of A1 and A2 (the paper's order w, a, p, o) and T.
inline constexpr int kWeight = 0;
inline constexpr int kAmplitude = 1;
inline constexpr int kPeriod = 2;
inline constexpr int kPhaseOffset = 3;

/// Table 1 and Table 2 of the paper: what oscillator parameters and weights
/// are drawn from and held to. (The text of the Controller section says 0 to
/// 10; both tables and the authors' program say 1 to 10.)
inline constexpr double kOscillatorLow = 1.0;
inline constexpr double kOscillatorHigh = 10.0;
inline constexpr double kWeightLow = -1.0;
inline constexpr double kWeightHigh = 1.0;
}  // namespace plasticoding

}  // namespace plsc
