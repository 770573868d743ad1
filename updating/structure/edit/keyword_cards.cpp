#include "updating/structure/edit/keyword_cards.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

namespace tapfit::structure {
namespace {

using Lines = std::vector<std::string>;

std::string text_at(const Card& card, std::size_t at) {
  return at < card.fields.size() ? card.fields[at] : "";
}

int integer_at(const Card& card, std::size_t at) {
  return parse_integer(text_at(card, at)).value_or(0);
}

double real_at(const Card& card, std::size_t at) {
  return parse_real(text_at(card, at)).value_or(0.0);
}

// The grids that a card names, behind the first of them.
std::vector<int> grids_from(const Card& card, std::size_t first) {
  std::vector<int> grids;
  for (std::size_t k = first; k < card.fields.size(); ++k) {
    if (integer_at(card, k) > 0) grids.push_back(integer_at(card, k));
  }
  return grids;
}

class CardWriter {
 public:
  CardWriter(const Deck& deck,
             const std::vector<AddedCard>& cards,
             const std::set<int>& left_out,
             KeywordNames& names)
      : deck_(&deck),
        left_out_(&left_out),
        names_(&names),
        next_node_(free_grid(deck, 0)),
        next_element_(free_element(deck, 0)) {
    for (const AddedCard& added : cards) {
      const Card& card = added.card;
      if (card.fields.empty()) continue;
      const int id = integer_at(card, 1);
      int& next = card.name() == "GRID" ? next_node_ : next_element_;
      next = std::max(next, id + 1);
      // A damper along the line of two nodes needs them apart.
      const bool apart = card.name() == "CDAMP2" && integer_at(card, 6) <= 3;
      if (apart) offset_[integer_at(card, 5)] = integer_at(card, 6);
    }
  }

  void write(const AddedCard& added) {
    if (added.card.fields.empty()) {
      lines.of_part.push_back("**" + added.comment.substr(1));
      return;
    }
    const Card& card = added.card;
    if (touches_left_out(card)) return;
    const std::map<std::string, void (CardWriter::*)(const Card&)> writers = {
        {"GRID", &CardWriter::write_node},
        {"CONM2", &CardWriter::write_mass},
        {"CELAS2", &CardWriter::write_spring},
        {"CDAMP2", &CardWriter::write_damper},
        {"RBE2", &CardWriter::write_coupling},
        {"SPC1", &CardWriter::write_hold},
        {"DMIG", &CardWriter::leave_matrix}};
    const auto own = writers.find(card.name());
    if (own != writers.end()) return (this->*own->second)(card);
    say(fmt::format("** not written: {}", fmt::join(card.fields, ",")));
  }

  AddedKeywords lines;

 private:
  void say(const std::string& line) { lines.of_part.push_back(line); }

  void say_once(const std::string& line) {
    if (said_.insert(line).second) say(line);
  }

  bool touches_left_out(const Card& card) {
    std::vector<int> grids = grids_from(card, card.name() == "GRID" ? 1 : 2);
    const bool touches = std::ranges::any_of(
        grids, [this](int grid) { return left_out_->contains(grid); });
    if (touches || card.name().starts_with("CORD")) {
      say_once(
          "** not written: a joint along no axis of the deck, whose nodes "
          "would have axes of their own");
      return true;
    }
    return false;
  }

  // In the deck's own length.
  Eigen::Vector3d place_of(int node) const {
    const auto own = places_.find(node);
    if (own != places_.end()) return own->second;
    return deck_->grid(node).position / deck_->file_length_m;
  }

  // Along a component of a node, as long as a damper is drawn.
  Eigen::Vector3d arm_along(int node, int component) const {
    constexpr double length_m = 0.1;
    Eigen::Vector3d axis = Eigen::Vector3d::Unit(component - 1);
    if (!places_.contains(node)) {
      axis = deck_->grid(node).axes.col(component - 1);
    }
    return length_m / deck_->file_length_m * axis;
  }

  void put_node(int id, const Eigen::Vector3d& at) {
    say("*NODE");
    say(fmt::format("{}, {}, {}, {}",
                    id,
                    card_real(at.x()),
                    card_real(at.y()),
                    card_real(at.z())));
  }

  void hold(int node, const std::string& components) {
    lines.of_model.emplace_back("*BOUNDARY");
    std::ranges::move(boundary_lines(names_->node(node), components),
                      std::back_inserter(lines.of_model));
  }

  void write_node(const Card& card) {
    const int id = integer_at(card, 1);
    Eigen::Vector3d at(real_at(card, 3), real_at(card, 4), real_at(card, 5));
    places_[id] = at;
    const auto apart = offset_.find(id);
    if (apart != offset_.end()) at += arm_along(id, apart->second);
    places_[id] = at;
    put_node(id, at);
    const std::string held = text_at(card, 7);
    if (!held.empty() && held != "0") hold(id, held);
  }

  // Elements that are one, and the keyword with its numbers.
  Lines element(const std::string& type,
                const std::string& element,
                const std::string& keyword,
                const Lines& data) {
    const std::string set = names_->next();
    Lines own = {fmt::format("*ELEMENT, TYPE={}, ELSET={}", type, set),
                 element,
                 fmt::format("*{}, ELSET={}", keyword, set)};
    own.insert(own.end(), data.begin(), data.end());
    return own;
  }

  void put(const Lines& own) {
    for (const std::string& line : own) say(line);
  }

  void put_as_comment(const std::string& why, const Lines& own) {
    say("** not written: " + why +
        ", at which CalculiX stops; for Abaqus take the ** off the lines "
        "below");
    for (const std::string& line : own) say("** " + line);
  }

  void write_mass(const Card& card) {
    const int node = integer_at(card, 2);
    put(element("MASS",
                fmt::format("{}, {}", integer_at(card, 1), node),
                "MASS",
                {card_real(real_at(card, 4))}));
    const std::array<double, 3> inertia = {
        real_at(card, 9), real_at(card, 11), real_at(card, 14)};
    if (inertia[0] == 0.0 && inertia[1] == 0.0 && inertia[2] == 0.0) return;
    put_as_comment(fmt::format("the rotary inertia at node {}", node),
                   element("ROTARYI",
                           fmt::format("{}, {}", next_element_++, node),
                           "ROTARY INERTIA",
                           {fmt::format("{}, {}, {}",
                                        card_real(inertia[0]),
                                        card_real(inertia[1]),
                                        card_real(inertia[2]))}));
  }

  void write_spring(const Card& card) {
    const bool two = integer_at(card, 5) > 0;
    const int component = integer_at(card, 4);
    if (component > 3 || integer_at(card, 6) > 3) {
      say_once(
          "** CalculiX passes over springs on rotations (4 to 6): what they "
          "hold "
          "turns freely there");
    }
    const std::string ids =
        fmt::format("{}, {}", integer_at(card, 1), integer_at(card, 3));
    put(element(two ? "SPRING2" : "SPRING1",
                two ? fmt::format("{}, {}", ids, integer_at(card, 5)) : ids,
                "SPRING",
                {two ? fmt::format("{}, {}", component, integer_at(card, 6))
                     : fmt::format("{}", component),
                 card_real(real_at(card, 2))}));
  }

  void write_damper(const Card& card) {
    const int id = integer_at(card, 1);
    const int node = integer_at(card, 3);
    const int component = integer_at(card, 4);
    int other = integer_at(card, 5);
    const std::string c = card_real(real_at(card, 2));
    if (component > 3) {
      put_as_comment(fmt::format("the damper on a rotation of node {}", node),
                     element("DASHPOT1",
                             fmt::format("{}, {}", id, node),
                             "DASHPOT",
                             {fmt::format("{}", component), c}));
      return;
    }
    if (other == 0) {
      other = next_node_++;
      put_node(other, place_of(node) + arm_along(node, component));
      hold(other, "123");
    }
    put(element("DASHPOTA",
                fmt::format("{}, {}, {}", id, node, other),
                "DASHPOT",
                {"", c}));
  }

  void write_coupling(const Card& card) {
    say_once(
        "** CalculiX does not take *KINEMATIC COUPLING, by which nodes follow "
        "others here");
    say(fmt::format("*KINEMATIC COUPLING, REF NODE={}", integer_at(card, 2)));
    for (const int node : grids_from(card, 4)) {
      put(boundary_lines(std::to_string(node), text_at(card, 3)));
    }
  }

  void write_hold(const Card& card) {
    for (const int node : grids_from(card, 3)) hold(node, text_at(card, 2));
  }

  void leave_matrix(const Card& card) {
    say_once(fmt::format(
        "** not written: the stiffness matrix {}, for which both programs have "
        "no keyword; a *STATIC step with the load in front of *FREQUENCY gives "
        "it",
        text_at(card, 1)));
  }

  const Deck* deck_;
  const std::set<int>* left_out_;
  KeywordNames* names_;
  int next_node_;
  int next_element_;
  std::map<int, int> offset_;              // new node -> component
  std::map<int, Eigen::Vector3d> places_;  // of new nodes
  std::set<std::string> said_;
};

}  // namespace

std::vector<AddedCard> added_cards(const std::vector<std::string>& added) {
  std::vector<AddedCard> cards;
  Lines pending;
  const auto close = [&] {
    for (Card& card : cards_in(pending)) cards.push_back({"", std::move(card)});
    pending.clear();
  };
  for (const std::string& text : added) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with('$')) {
        pending.push_back(line);
        continue;
      }
      close();
      cards.push_back({line, {}});
    }
  }
  close();
  return cards;
}

std::set<int> grids_left_out(const std::vector<AddedCard>& cards) {
  std::set<int> left_out;
  for (const AddedCard& added : cards) {
    const Card& card = added.card;
    if (card.fields.empty()) continue;
    if (card.name() == "GRID" && integer_at(card, 6) != 0) {
      left_out.insert(integer_at(card, 1));
    }
    if (card.name() == "RBE2" && left_out.contains(integer_at(card, 2))) {
      for (const int grid : grids_from(card, 4)) left_out.insert(grid);
    }
  }
  return left_out;
}

AddedKeywords keyword_lines(const Deck& deck,
                            const std::vector<AddedCard>& cards,
                            const std::set<int>& left_out,
                            KeywordNames& names) {
  CardWriter writer(deck, cards, left_out, names);
  for (const AddedCard& added : cards) writer.write(added);
  return std::move(writer.lines);
}

}  // namespace tapfit::structure
