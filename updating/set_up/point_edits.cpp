#include "updating/set_up/point_edits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace tapfit::effects {
namespace {

using acquisition::Channel;
using acquisition::Run;
using acquisition::TestBundle;

// What a point is in truth.
using Move = std::pair<Dof, Dof>;

struct Moves {
  std::set<Move> hammers;
  std::map<Move, std::set<Dof>> sensors;  // and the blows they measured
  std::set<Dof> right;                    // sensors, in some run
};

Moves moves_between(const TestBundle& before, const TestBundle& after) {
  Moves moves;
  for (std::size_t r = 0; r < before.runs.size(); ++r) {
    const Run& was = before.runs[r];
    const Run& is = after.runs[r];
    if (was.hammer.dof != is.hammer.dof) {
      moves.hammers.insert({was.hammer.dof, is.hammer.dof});
    }
    for (std::size_t k = 0; k < was.sensors.size(); ++k) {
      const Dof& from = was.sensors[k].dof;
      const Dof& to = is.sensors[k].dof;
      if (from == to) {
        moves.right.insert(from);
      } else {
        moves.sensors[{from, to}].insert(was.hammer.dof);
      }
    }
  }
  return moves;
}

std::string shortened(const std::vector<std::string>& names) {
  constexpr std::size_t few = 4;
  if (names.size() <= few) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format(
      "{} ... {} ({} of them)", names.front(), names.back(), names.size());
}

std::string arrow(const Move& move) {
  return fmt::format("{} -> {}", name(move.first), name(move.second));
}

// Of what the file holds; an FRF is divided by the hammer's channel.
std::string change_of_values(const Channel& was, const Channel& is, bool frfs) {
  if (was.quantity != is.quantity) {
    return fmt::format("{}, not {}",
                       acquisition::name(is.quantity),
                       acquisition::name(was.quantity));
  }
  const bool divided = frfs && was.quantity == acquisition::Quantity::Force;
  const double factor = divided ? is.sensitivity / was.sensitivity
                                : was.sensitivity / is.sensitivity;
  return factor == -1.0 ? "other sign" : fmt::format("times {:.4g}", factor);
}

std::vector<std::string> channel_edits(const TestBundle& before,
                                       const TestBundle& after) {
  const bool frfs = before.frfs.has_value();
  std::map<std::string, std::vector<std::string>> channels;
  for (std::size_t c = 0; c < before.channels.size(); ++c) {
    const Channel& was = before.channels[c];
    const Channel& is = after.channels[c];
    if (was.quantity == is.quantity && was.sensitivity == is.sensitivity) {
      continue;
    }
    channels[change_of_values(was, is, frfs)].push_back(was.name);
  }
  std::vector<std::string> result;
  for (const auto& [change, names] : channels) {
    result.push_back(fmt::format("of {}: {}", shortened(names), change));
  }
  return result;
}

std::vector<std::string> move_edits(const Moves& moves) {
  std::vector<std::string> result;
  std::vector<std::string> hammers;
  for (const Move& move : moves.hammers) hammers.push_back(arrow(move));
  if (!hammers.empty()) result.push_back("hit at " + shortened(hammers));
  std::vector<std::string> sensors;
  for (const auto& [move, blows] : moves.sensors) {
    if (!moves.right.contains(move.first)) {
      sensors.push_back(arrow(move));
      continue;
    }
    std::vector<std::string> hit;
    for (const Dof& blow : blows) hit.push_back(name(blow));
    result.push_back(
        fmt::format("measured at {}, hit at {}", arrow(move), shortened(hit)));
  }
  if (!sensors.empty()) result.push_back("measured at " + shortened(sensors));
  return result;
}

}  // namespace

bool is_without_sheet(const TestBundle& bundle) {
  return bundle.frfs.has_value() || bundle.uff.has_value();
}

std::vector<std::string> point_edits(const TestBundle& before,
                                     const TestBundle& after) {
  std::vector<std::string> edits = channel_edits(before, after);
  std::ranges::move(move_edits(moves_between(before, after)),
                    std::back_inserter(edits));
  for (std::string& edit : edits) {
    edit.insert(0, before.frfs ? "FRFs " : "records ");
  }
  return edits;
}

}  // namespace tapfit::effects
