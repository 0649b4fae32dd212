#pragma once

// What a match of an inline test builds. See actions.h.

#include "grammar/actions.h"
#include "grammar/builder.h"
#include "grammar/keywords.h"
#include "grammar/rules.h"

namespace plsc::grammar {

template <>
struct Action<test_place> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.test.environment = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.test.environment));
  }
};

template <>
struct Action<after_number> {
  static void apply0(Builder& b) {
    b.test.has_after = true;
    b.test.after = b.value;
  }
};

// Expected bodies.

template <>
struct Action<body_word> {
  // A module without a face before it is the first.
  static void apply0(Builder& b) { b.face = {}; }
};

template <>
struct Action<face_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    b.face = SpanOf(in, b);
    return !IsKeyword(b.file.Text(b.face));
  }
};

template <>
struct Action<module_name> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    const Span span = SpanOf(in, b);
    if (IsKeyword(b.file.Text(span))) return false;
    const auto depth = static_cast<std::uint32_t>(b.body_path.size());
    b.file.nodes.push_back({b.face, span, {}, {}, depth});
    ++b.test.nodes.count;
    return true;
  }
};

template <>
struct Action<children_open> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    if (b.body_path.size() == kMaxBodyDepth)
      b.Fail(SyntaxError::kBodyDepth, SpanOf(in, b).begin);
    const auto node = static_cast<std::uint32_t>(b.file.nodes.size()) - 1;
    b.file.nodes[node].open = b.open;
    b.body_path.push_back(node);
  }
};

template <>
struct Action<children_end> {
  static void apply0(Builder& b) {
    b.file.nodes[b.body_path.back()].close = b.close;
    b.body_path.pop_back();
    // An error from here on is about the braces around these.
    if (!b.body_path.empty()) b.open = b.file.nodes[b.body_path.back()].open;
  }
};

template <>
struct Action<test_item> {
  static void apply0(Builder& b) {
    b.test.name = b.name;
    b.test.symbols = b.rule.symbols;
    if (b.test.nodes.count > 0) {
      const ast::BodyNode& first = b.file.nodes[b.test.nodes.first];
      b.test.open = first.open;
      b.test.close = first.close;
    } else {
      b.test.open = b.open;
      b.test.close = b.close;
    }
    b.EndItem(ast::ItemKind::kTest, b.file.tests.size());
    b.file.tests.push_back(b.test);
  }
};

}  // namespace plsc::grammar
