// Blocks of C3D20 bricks as text of an .inp deck.
#pragma once

#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace tapfit::structure {

struct BrickBlock {
  std::array<int, 3> count{4, 1, 1};          ///< along x, y, z
  std::array<double, 3> size{0.4, 0.1, 0.1};  ///< [m]
  double from_x = 0.0;                        ///< [m]
  int first_node = 1;
  int first_element = 1;
};

struct BrickText {
  std::string nodes;      ///< data lines of *NODE
  std::string elements;   ///< of *ELEMENT, TYPE=C3D20, on two lines each
  std::vector<int> root;  ///< nodes at the end of the least x
  std::vector<int> tip;   ///< at the other end
};

/// Nodes of a brick as Abaqus orders them: corners, then middles of the edges
/// below, above, upright; in half sides from its first corner.
inline constexpr std::array<std::array<int, 3>, 20> brick_nodes{
    {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
     {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}, {2, 1, 0},
     {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2},
     {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};

inline BrickText bricks(const BrickBlock& block) {
  BrickText text;
  std::map<std::array<int, 3>, int> ids;
  const auto node = [&](const std::array<int, 3>& at) {
    const auto [found, fresh] =
        ids.try_emplace(at, block.first_node + static_cast<int>(ids.size()));
    if (!fresh) return found->second;
    const auto place = [&](std::size_t k) {
      return block.size.at(k) * at.at(k) / (2.0 * block.count.at(k));
    };
    text.nodes += fmt::format("{}, {}, {}, {}\n",
                              found->second,
                              block.from_x + place(0),
                              place(1),
                              place(2));
    if (at[0] == 0) text.root.push_back(found->second);
    if (at[0] == 2 * block.count[0]) text.tip.push_back(found->second);
    return found->second;
  };
  int element = block.first_element;
  for (int i = 0; i < block.count[0]; ++i) {
    for (int j = 0; j < block.count[1]; ++j) {
      for (int k = 0; k < block.count[2]; ++k) {
        text.elements += fmt::format("{}", element++);
        for (std::size_t n = 0; n < brick_nodes.size(); ++n) {
          const auto& own = brick_nodes.at(n);
          const int id = node({2 * i + own[0], 2 * j + own[1], 2 * k + own[2]});
          text.elements += fmt::format("{}{}", n == 10 ? ",\n" : ", ", id);
        }
        text.elements += "\n";
      }
    }
  }
  return text;
}

inline std::string set_of_nodes(const std::string& name,
                                const std::vector<int>& ids) {
  std::string text = fmt::format("*NSET, NSET={}\n", name);
  for (const int id : ids) text += fmt::format("{},\n", id);
  return text;
}

}  // namespace tapfit::structure
