// Two layers are all there is: edges lead from inputs to oscillators, or back
// to their own node. So there is nothing to optimise, and nodes are put in the
// order of their modules instead of one with fewer crossings: the same brain
// looks the same in every environment, and differences are seen where they are.

#include "runtime/pictures/brain_layout.h"

#include <algorithm>
#include <cstddef>

namespace plsc {

namespace {

/// Its nodes in the order of their modules.
std::vector<std::size_t> ColumnOf(const Brain& brain, NodeType type) {
  std::vector<std::size_t> column;
  for (std::size_t i = 0; i < brain.nodes.size(); ++i)
    if (brain.nodes[i].type == type) column.push_back(i);
  std::stable_sort(column.begin(), column.end(),
                   [&](std::size_t a, std::size_t b) {
                     return brain.nodes[a].module < brain.nodes[b].module;
                   });
  return column;
}

}  // namespace

BrainLayout LayOutBrain(const Brain& brain, int row_height) {
  const std::vector<std::size_t> inputs = ColumnOf(brain, NodeType::kInput);
  const std::vector<std::size_t> oscillators =
      ColumnOf(brain, NodeType::kOscillator);
  const std::size_t rows =
      std::max<std::size_t>({inputs.size(), oscillators.size(), 1});
  BrainLayout layout;
  layout.places.resize(brain.nodes.size());
  layout.height = static_cast<int>(rows) * row_height;
  for (const auto* column : {&inputs, &oscillators}) {
    const std::size_t count = column->size();
    // Half rows are fine: the columns are centred on each other.
    const int top = static_cast<int>(rows - count) * row_height / 2;
    for (std::size_t i = 0; i < count; ++i)
      layout.places[(*column)[i]] = {
          column == &inputs ? kInputColumn : kOscillatorColumn,
          top + static_cast<int>(i) * row_height,
          count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1)
                    : 0.5};
  }
  return layout;
}

}  // namespace plsc
