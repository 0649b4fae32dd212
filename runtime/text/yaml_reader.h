#pragma once

// Strict reading of a YAML file, for scenarios and experiments: everything
// that is not understood is an error at its place, and all errors of a file
// are found in one go. The door to yaml-cpp is yaml_reader.cc.
//
// A reader asks a map for each key it knows, with the default, and then calls
// Close(), which reports what nobody asked for.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grammar/diagnostic.h"
#include "grammar/enum_names.h"
#include "runtime/text/quantity.h"

namespace plsc {

class YamlMap;
struct YamlDocument;  // holds yaml-cpp's nodes and the diagnostics
struct YamlNode;

/// One value of a file. Cheap to copy; the document lives as long as any value
/// of it. The reading functions report what is wrong and return nothing.
class YamlValue {
 public:
  YamlValue(std::shared_ptr<YamlDocument> document,
            std::shared_ptr<const YamlNode> node)
      : document_(std::move(document)), node_(std::move(node)) {}

  bool is_scalar() const;
  bool is_map() const;
  bool is_quoted() const;    ///< "50" or '50': a text, never a number
  std::string text() const;  ///< of a scalar, without quotes
  Span span() const;         ///< of a scalar; the first byte of others

  std::optional<double> Number(const Quantity& quantity) const;
  /// `usual` is shown where something else stands; nothing: `low` is.
  std::optional<std::int64_t> Integer(
      std::int64_t low, std::int64_t high,
      std::optional<std::int64_t> usual = std::nullopt) const;
  std::optional<std::uint64_t> Unsigned() const;  ///< 0 to 2^64 - 1
  std::optional<bool> Bool() const;               ///< true, True, false, False
  /// A scalar that is not empty. `what` says what it is: "a name".
  std::optional<std::string> Text(std::string_view what) const;
  template <typename E, std::size_t N>
  std::optional<E> Choice(const EnumNames<E, N>& names) const {
    const std::optional<std::size_t> index = IndexIn(AllNames(names));
    return index ? std::optional(names[*index].first) : std::nullopt;
  }
  std::optional<std::vector<YamlValue>> List(std::string_view what) const;
  std::optional<YamlMap> Map(std::string_view what) const;

  std::size_t CountEntries() const;  ///< of a map or list
  /// Values in it and itself, counted up to `most`: with aliases a short text
  /// may have any number.
  std::size_t CountValues(std::size_t most) const;

  /// Whether so many errors were found that no more are reported; a loop over
  /// what a file may have thousands of ends then.
  bool is_full() const;
  /// Reports an error here. `replacement`, if not empty, is to be written in
  /// its place.
  void Report(Code code, std::string message, std::string help = "",
              std::string replacement = "") const;
  /// Likewise, what is wrong with a part of a scalar: places are in text().
  void ReportPart(Diagnostic problem) const;
  /// Of the file, so far: who puts values together that were read one by one
  /// has nothing to say where one of them is wrong and only a default stands in
  /// for it.
  std::size_t error_count() const;

 private:
  std::optional<std::size_t> IndexIn(
      const std::vector<std::string_view>& names) const;
  void ReportQuoted(std::string_view expected, const std::string& meant,
                    const std::string& example) const;

  std::shared_ptr<YamlDocument> document_;
  std::shared_ptr<const YamlNode> node_;
};

/// A map of a file. Keys that occur twice are reported when it is made.
class YamlMap {
 public:
  struct Entry {
    std::string key;
    YamlValue at;  ///< the key's own place
    YamlValue value;
  };
  YamlMap(YamlValue place, std::vector<Entry> entries)
      : place_(std::move(place)), entries_(std::move(entries)) {}

  /// All, in the file's order; then all count as known.
  const std::vector<Entry>& TakeAll();
  /// Makes the key known.
  std::optional<YamlValue> Find(std::string_view key);
  /// As Find; a missing key is an error, which Close reports unless an unknown
  /// key is the misspelt one.
  std::optional<YamlValue> Need(std::string_view key, std::string_view help);

  double Number(std::string_view key, double otherwise,
                const Quantity& quantity);
  int Int(std::string_view key, int otherwise, int low, int high);
  bool Bool(std::string_view key, bool otherwise);
  std::string Text(std::string_view key, const std::string& otherwise);
  template <typename E, std::size_t N>
  E Choice(std::string_view key, std::type_identity_t<E> otherwise,
           const EnumNames<E, N>& names) {
    const std::optional<YamlValue> value = Find(key);
    return value ? value->Choice(names).value_or(otherwise) : otherwise;
  }

  /// Reports keys that nobody asked for, with the nearest known one.
  void Close() const;
  const YamlValue& place() const { return place_; }

 private:
  YamlValue place_;
  std::vector<Entry> entries_;
  std::vector<std::string> known_;
  std::vector<std::pair<std::string, std::string>> missing_;  // and its help
};

/// A parsed file. `source` outlives it.
class YamlFile {
 public:
  explicit YamlFile(const Source& source);

  /// Nothing when the text is not YAML, or is not a map.
  std::optional<YamlMap> Root(std::string_view what) const;
  /// In the order of finding.
  const std::vector<Diagnostic>& diagnostics() const;

 private:
  std::shared_ptr<YamlDocument> document_;
};

}  // namespace plsc
