#include "updating/places/told_apart.hpp"

#include "updating/places/gathered.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <bit>
#include <compare>
#include <cstddef>
#include <map>
#include <string>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// Where it is, and what only the like are gathered with.
struct Seen {
  struct Kind {
    std::string form;
    std::size_t length = 0;  // in grids, to a factor of two; 0 and 1: no line
    Eigen::Index along = 0;  // the axis that it runs along most

    auto operator<=>(const Kind&) const = default;
  };
  Kind kind;
  Vector3d at;
};

Seen seen(const Location& where, const Deck& deck) {
  if (where.nodes.empty())
    return {{where.variant}, deck.grid(where.node).position};
  Vector3d middle = Vector3d::Zero();
  for (const int node : where.nodes) {
    middle +=
        deck.grid(node).position / static_cast<double>(where.nodes.size());
  }
  Seen line{{where.variant, std::bit_width(where.nodes.size())}, middle};
  const Vector3d extent = deck.grid(where.nodes.back()).position -
                          deck.grid(where.nodes.front()).position;
  extent.cwiseAbs().maxCoeff(&line.kind.along);
  return line;
}

}  // namespace

std::vector<Location> told_apart(const std::vector<Location>& places,
                                 const Deck& deck) {
  struct Alike {
    std::vector<std::size_t> number;
    std::vector<Vector3d> at;
  };
  std::map<Seen::Kind, Alike> kinds;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Seen one = seen(places[k], deck);
    kinds[one.kind].number.push_back(k);
    kinds[one.kind].at.push_back(one.at);
  }
  std::vector<std::size_t> kept;
  for (const auto& [kind, alike] : kinds) {
    const std::size_t most = kind.length > 1 ? most_lines : most_places;
    for (const std::size_t k : spread_out(alike.at, most)) {
      kept.push_back(alike.number[k]);
    }
  }
  std::ranges::sort(kept);
  std::vector<Location> result;
  for (const std::size_t k : kept) result.push_back(places[k]);
  return result;
}

}  // namespace tapfit::updating
