#include "updating/effects/joint_cards.hpp"

#include "updating/structure/edit/deck_cards.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tapfit::effects {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// Above every integer on the deck's coordinate cards, ids among them.
int free_system(const Deck& deck) {
  int highest = 0;
  for (const std::string& line : deck.cards) {
    if (!line.starts_with("CORD")) continue;
    std::string word;
    for (const char c : line + ",") {
      if (c != ',' && c != ' ' && c != '\t') {
        word += c;
        continue;
      }
      int number = 0;
      const char* end = word.data() + word.size();
      const auto [stop, error] = std::from_chars(word.data(), end, number);
      if (error == std::errc() && stop == end) {
        highest = std::max(highest, number);
      }
      word.clear();
    }
  }
  return highest + 1;
}

// Component 4..6 of the basic axis that this is, in either sense.
int basic_turn(const Vector3d& axis) {
  constexpr double rounding = 1e-6;
  for (int c = 0; c < 3; ++c) {
    if (std::abs(axis(c)) > 1.0 - rounding) return 4 + c;
  }
  return 0;
}

std::string all_but(int component) {
  std::string components = "123456";
  components.erase(static_cast<std::size_t>(component - 1), 1);
  return components;
}

std::string system_card(int id, const Vector3d& z) {
  Eigen::Index across = 0;
  z.cwiseAbs().minCoeff(&across);
  const Vector3d c = Vector3d::Unit(across);
  return fmt::format(
      "CORD2R,{},0,0.,0.,0.,{},{},{}\n"
      ",{},{},{}",
      id,
      structure::card_real(z.x()),
      structure::card_real(z.y()),
      structure::card_real(z.z()),
      structure::card_real(c.x()),
      structure::card_real(c.y()),
      structure::card_real(c.z()));
}

// Cards for one line, with ids counted on from the deck's own.
class Writer {
 public:
  explicit Writer(const Deck& deck) : deck_(&deck) {}

  int grid(int like, int axes) {
    const int id = free_grid(*deck_, grids_++);
    cards.push_back(grid_card(*deck_, id, like, "", axes));
    return id;
  }
  void follow(int leader, const std::string& components, int follower) {
    cards.push_back(fmt::format(
        "RBE2,{},{},{},{}", element(), leader, components, follower));
  }
  void spring(double stiffness, int a, int b, int component) {
    cards.push_back(fmt::format(
        "CELAS2,{},{},{},{},{},{}",
        element(),
        structure::card_real(file_stiffness(*deck_, component, stiffness)),
        a,
        component,
        b,
        component));
  }

  std::vector<std::string> cards;

 private:
  int element() { return free_element(*deck_, elements_++); }

  const Deck* deck_;
  int grids_ = 0;
  int elements_ = 0;
};

}  // namespace

int turned_across(const updating::Location& where, const TestContext& context) {
  if (where.nodes.size() != 1) return context.component;
  std::vector<int> components = {context.component};
  components.insert(
      components.end(), context.components.begin(), context.components.end());
  return updating::across_bar(
      *context.deck, where.nodes.front(), where.elements, components);
}

updating::JointLine joint_at(const updating::Location& where,
                             const TestContext& context) {
  if (where.nodes.size() > 1) {
    return updating::shell_joint(*context.deck, where.nodes);
  }
  return updating::bar_joint(*context.deck,
                             where.nodes.front(),
                             where.elements,
                             turned_across(where, context));
}

namespace {

// What to say where a grid's double would have to share its axes; else empty.
std::vector<std::string> not_written(const Deck& deck,
                                     const auto& grids,
                                     const std::string& springs) {
  for (const auto& grid : grids) {
    if (deck.grids[deck.grid_index(grid.node)].axes.isIdentity(1e-9)) continue;
    return {fmt::format(
        "$ not written: grid {} has displacement axes (CD) of its own; give it "
        "CD 0, double the joint's grids for the elements on one side, CELAS2 "
        "of {}",
        grid.node,
        springs)};
  }
  return {};
}

}  // namespace

JointCards crack_cards(const Deck& deck,
                       const updating::CrackLine& crack,
                       double stiffness) {
  JointCards result;
  result.added = not_written(
      deck,
      crack.grids,
      fmt::format("{:.4g} N/m per square metre between the faces", stiffness));
  if (!result.added.empty()) return result;
  result.side = crack.side;
  Writer writer(deck);
  for (const updating::PartedGrid& grid : crack.grids) {
    const int twin = writer.grid(grid.node, 0);
    result.doubles[grid.node] = twin;
    for (std::size_t a = 0; a < 3; ++a) {
      const int turn = basic_turn(grid.axes[a]);
      if (turn == 0) continue;
      writer.spring(stiffness * grid.area, twin, grid.node, turn - 3);
      if (a == 2) continue;
      writer.spring(stiffness * grid.turn, twin, grid.node, turn);
    }
  }
  result.added = std::move(writer.cards);
  const bool askew = std::ranges::any_of(crack.grids, [](const auto& grid) {
    return basic_turn(grid.axes[0]) == 0 || basic_turn(grid.axes[1]) == 0;
  });
  if (askew) {
    result.added.push_back(fmt::format(
        "$ springs of {:.4g} N/m per square metre between the faces are left "
        "out along their own axes",
        stiffness));
  }
  return result;
}

JointCards joint_cards(const Deck& deck,
                       const updating::JointLine& joint,
                       double stiffness) {
  JointCards result;
  if (joint.grids.empty()) return result;
  result.added = not_written(
      deck,
      joint.grids,
      fmt::format("{:.4g} N m/rad per metre between the turns", stiffness));
  if (!result.added.empty()) return result;
  result.side = joint.side;
  Writer writer(deck);
  const Vector3d axis = joint.grids.front().axis;
  const int turn = basic_turn(axis);
  const int axes = turn != 0 ? 0 : free_system(deck);
  if (turn == 0) writer.cards.push_back(system_card(axes, axis));
  for (const updating::JointGrid& grid : joint.grids) {
    const double k = stiffness * grid.length;
    const int twin = writer.grid(grid.node, 0);
    result.doubles[grid.node] = twin;
    if (turn != 0) {
      writer.follow(grid.node, all_but(turn), twin);
      writer.spring(k, twin, grid.node, turn);
      continue;
    }
    const int fast = writer.grid(grid.node, axes);
    const int loose = writer.grid(grid.node, axes);
    writer.follow(grid.node, "123456", fast);
    writer.follow(fast, all_but(6), loose);
    writer.follow(loose, "123456", twin);
    writer.spring(k, loose, fast, 6);
  }
  result.added = std::move(writer.cards);
  return result;
}

JointCards joint_cards(const updating::Location& where,
                       const TestContext& context,
                       double stiffness) {
  const Deck& deck = *context.deck;
  return where.variant == updating::crack
             ? crack_cards(
                   deck, updating::crack_line(deck, where.nodes), stiffness)
             : joint_cards(deck, joint_at(where, context), stiffness);
}

}  // namespace tapfit::effects
