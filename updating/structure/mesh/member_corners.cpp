#include "updating/structure/mesh/member_corners.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace tapfit::structure {
namespace {

using Eigen::Vector3d;

std::optional<Member> member(const Deck& deck, std::size_t index) {
  const Bar& bar = deck.bars[index];
  const auto p = deck.bar_properties.find(bar.property);
  if (p == deck.bar_properties.end() || !(p->second.area > 0.0)) return {};
  Member m;
  m.bar = index;
  for (std::size_t k = 0; k < 2; ++k) {
    m.ends.at(k) = deck.grids[deck.grid_index(bar.grids.at(k))].position +
                   bar.offsets.at(k);
  }
  m.length = (m.ends[1] - m.ends[0]).norm();
  if (!(m.length > 0.0)) return {};
  m.x = (m.ends[1] - m.ends[0]) / m.length;
  m.z = m.x.cross(bar.orientation);
  if (!(m.z.norm() > 0.0)) return {};
  m.z.normalize();
  m.y = m.z.cross(m.x);
  m.half_y = std::sqrt(3.0 * std::max(p->second.I1, 0.0) / p->second.area);
  m.half_z = std::sqrt(3.0 * std::max(p->second.I2, 0.0) / p->second.area);
  return m;
}

// A member at a grid, and its direction away from it.
struct Leg {
  std::size_t member = 0;
  Vector3d away;
};

using Legs = std::vector<Leg>;

class Network {
 public:
  explicit Network(const Deck& deck) : deck_(&deck) {
    for (std::size_t i = 0; i < deck.bars.size(); ++i) {
      if (std::optional<Member> m = member(deck, i)) members.push_back(*m);
    }
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Member& m = members[k];
      legs[grid(k, 0)].push_back({k, m.x});
      legs[grid(k, 1)].push_back({k, -m.x});
    }
  }

  [[nodiscard]] int grid(std::size_t member, std::size_t end) const {
    return deck_->bars[members[member].bar].grids.at(end);
  }

  // From grid to grid along a line, as far as it goes straight on.
  void walk(CornerEnd& end) const {
    int at = end.grid;
    std::optional<std::size_t> next = end.own;
    for (double left = end.length; next;) {
      const Member& m = members[*next];
      end.inside.emplace_back(*next, std::min(left / m.length, 1.0));
      left -= m.length;
      if (left <= 1e-6 * m.length) return;
      at = grid(*next, grid(*next, 0) == at ? 1 : 0);
      const Legs& meeting = legs.at(at);
      const auto on = std::ranges::find_if(meeting, [&](const Leg& leg) {
        return leg.away.dot(end.along) > 1.0 - 1e-6;
      });
      next = on == meeting.end() ? std::nullopt : std::optional(on->member);
    }
  }

  std::vector<Member> members;
  std::map<int, Legs> legs;

 private:
  const Deck* deck_;
};

bool goes_on(const Legs& meeting, const Vector3d& away) {
  return std::ranges::any_of(meeting, [&](const Leg& other) {
    return other.away.dot(away) < 0.0 &&
           other.away.cross(away).norm() < corner_sine;
  });
}

std::optional<CornerEnd> corner_end(const Network& network,
                                    int grid,
                                    const Leg& own) {
  const Legs& meeting = network.legs.at(grid);
  if (goes_on(meeting, own.away)) return {};
  CornerEnd end{grid, own.member, own.away, 0.0, false, meeting.size(), {}};
  for (const Leg& other : meeting) {
    const double sine = own.away.cross(other.away).norm();
    if (sine < corner_sine) continue;
    const double reach = network.members[other.member].reach(own.away);
    end.length = std::max(end.length, reach / sine);
    end.in_through = end.in_through || goes_on(meeting, other.away);
  }
  if (end.length <= 0.0) return {};
  network.walk(end);
  return end;
}

}  // namespace

double Member::reach(const Vector3d& u) const {
  return half_y * std::abs(u.dot(y)) + half_z * std::abs(u.dot(z));
}

MemberCorners member_corners(const Deck& deck) {
  Network network(deck);
  std::vector<CornerEnd> ends;
  for (const auto& [grid, meeting] : network.legs) {
    for (const Leg& own : meeting) {
      if (auto end = corner_end(network, grid, own)) {
        ends.push_back(std::move(*end));
      }
    }
  }
  return {std::move(network.members), std::move(ends)};
}

}  // namespace tapfit::structure
