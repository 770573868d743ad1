#include "updating/places/near_places.hpp"

#include <bit>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

// Of the grids of places those nearest to a grid, itself first.
std::vector<int> nearest(int node,
                         const std::vector<Location>& places,
                         const structure::Deck& deck,
                         int count) {
  const auto position = [&deck](int id) { return deck.grid(id).position; };
  std::vector<std::pair<double, int>> distance = {{0.0, node}};
  std::set<int> known = {node};
  for (const Location& place : places) {
    if (!known.insert(place.node).second) continue;
    distance.emplace_back((position(place.node) - position(node)).norm(),
                          place.node);
  }
  const auto n = std::min<std::size_t>(distance.size(),
                                       static_cast<std::size_t>(count) + 1);
  std::partial_sort(distance.begin(),
                    distance.begin() + static_cast<std::ptrdiff_t>(n),
                    distance.end());
  std::vector<int> nodes;
  for (std::size_t k = 0; k < n; ++k) nodes.push_back(distance[k].second);
  return nodes;
}

// Elements that two patches share, over those of either.
double overlap(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_intersection(
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  const double common = static_cast<double>(both.size());
  return common / (static_cast<double>(a.size() + b.size()) - common);
}

Eigen::Vector3d middle(const structure::Deck& deck,
                       const std::vector<int>& grids) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int id : grids) sum += deck.grid(id).position;
  return sum / static_cast<double>(grids.size());
}

// How far a patch or a seam is from another: elements that are not shared,
// metres between the middles. Empty where they have nothing in common.
std::optional<double> distance(const Location& a,
                               const Location& b,
                               const structure::Deck& deck) {
  if (!a.nodes.empty() && !b.nodes.empty()) {
    return (middle(deck, a.nodes) - middle(deck, b.nodes)).norm();
  }
  const double shared = overlap(a.elements, b.elements);
  return shared > 0.0 ? std::optional(-shared) : std::nullopt;
}

// Patches of at most this many times as many elements, or as few, are near.
constexpr double most_times = 8.0;
// Of each size.
constexpr int per_size = 2;

// Sizes within a factor of two.
int size_class(const Location& where) {
  return static_cast<int>(std::bit_width(where.elements.size()));
}

}  // namespace

std::vector<Location> places_near(const Location& at,
                                  const std::vector<Location>& places,
                                  const structure::Deck& deck,
                                  int count) {
  std::vector<Location> result;
  if (at.node != 0) {
    for (const int node : nearest(at.node, places, deck, count)) {
      result.push_back(at);
      result.back().node = node;
    }
    return result;
  }
  std::vector<std::pair<double, Location>> order;
  for (const Location& where : places) {
    if (const auto far = distance(where, at, deck)) {
      order.emplace_back(*far, where);
    }
  }
  std::stable_sort(order.begin(), order.end(), [](auto& a, auto& b) {
    return a.first < b.first;
  });
  // Patches that share most are about as large. A small one with a large loss
  // may stand for a large one with a small: some of other sizes, too.
  const auto own = static_cast<double>(at.elements.size());
  std::map<int, int> of_size;
  for (auto& [far, where] : order) {
    const auto size = static_cast<double>(where.elements.size());
    const bool near = static_cast<int>(result.size()) <= count;
    const bool other_size = size <= most_times * own &&
                            own <= most_times * size &&
                            of_size[size_class(where)] < per_size;
    if (!near && (where.elements.empty() || !other_size)) continue;
    ++of_size[size_class(where)];
    result.push_back(std::move(where));
  }
  return result;
}

bool within_reach(const Location& from,
                  const Location& to,
                  const std::vector<Location>& places,
                  const structure::Deck& deck,
                  int neighbours) {
  if (from.variant != to.variant) return false;
  if (from.node != 0) {
    const std::vector<int> around =
        nearest(from.node, places, deck, neighbours);
    return std::ranges::find(around, to.node) != around.end();
  }
  return share(from.nodes, to.nodes) ||
         overlap(from.elements, to.elements) > 0.5;
}

}  // namespace tapfit::updating
