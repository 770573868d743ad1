#include "updating/practice/score_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using structure::Deck;

std::vector<std::string> parts_of(const std::string& joined, char at) {
  std::vector<std::string> parts = {""};
  for (const char c : joined) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Eigen::Vector3d middle_of(const Deck& deck, const std::vector<int>& grids) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int id : grids) sum += deck.grids[deck.grid_index(id)].position;
  return sum / static_cast<double>(std::max<std::size_t>(grids.size(), 1));
}

std::vector<int> grids_of(const Deck& deck, const std::vector<int>& elements) {
  std::vector<int> grids;
  const auto add = [&](const auto& element) {
    if (std::find(elements.begin(), elements.end(), element.id) ==
        elements.end()) {
      return;
    }
    grids.insert(grids.end(), element.grids.begin(), element.grids.end());
  };
  std::for_each(deck.shells.begin(), deck.shells.end(), add);
  std::for_each(deck.bars.begin(), deck.bars.end(), add);
  return grids;
}

double longest_side(const Deck& deck) {
  double longest = 0.0;
  const auto see = [&](const auto& element) {
    for (std::size_t k = 0; k < element.grids.size(); ++k) {
      const int next = element.grids[(k + 1) % element.grids.size()];
      longest = std::max(
          longest,
          (middle_of(deck, {element.grids[k]}) - middle_of(deck, {next}))
              .norm());
    }
  };
  std::for_each(deck.shells.begin(), deck.shells.end(), see);
  std::for_each(deck.bars.begin(), deck.bars.end(), see);
  return longest;
}

// Turning or moving as it does, or both, and all that is held.
bool same_support(const VirtualEffect& hidden,
                  const Location& found,
                  const Deck& deck) {
  std::set<int> held;
  for (const structure::Constraint& c : deck.constraints) held.insert(c.grid);
  const std::string form = hidden.form.empty() ? "rotation" : hidden.form;
  return found.variant.starts_with(form) &&
         held == std::set<int>(found.nodes.begin(), found.nodes.end());
}

// Within one element, or the same channels.
bool same_place(const VirtualEffect& hidden,
                const Location& found,
                const Deck& deck) {
  if (hidden.name == "soft-support") return same_support(hidden, found, deck);
  if (!found.channels.empty()) {
    return hidden.places.empty() || std::is_permutation(hidden.places.begin(),
                                                        hidden.places.end(),
                                                        found.channels.begin(),
                                                        found.channels.end());
  }
  if (hidden.places.empty()) return true;
  std::vector<int> there = found.nodes;
  if (found.node != 0) there = {found.node};
  std::vector<int> here = hidden.numbers();
  if (!found.elements.empty() && found.nodes.empty()) {
    there = grids_of(deck, found.elements);
    here = grids_of(deck, here);
  }
  const double apart = (middle_of(deck, here) - middle_of(deck, there)).norm();
  return apart <= 1.01 * longest_side(deck);
}

// The estimates that hidden values are compared with, in their order.
std::vector<Estimate> counterparts(const VirtualEffect& hidden,
                                   const Rung& rung) {
  const bool per_metre =
      hidden.name == "soft-support" || hidden.name == "joint";
  if (!per_metre) return rung.parameters;
  std::vector<Estimate> result;
  for (const Estimate& e : rung.parameters) {
    // What follows a dot tells ends of a clamp.
    const std::string name = e.name.substr(0, e.name.find('.'));
    if (name.ends_with("per_rad_per_m") || name.ends_with("per_m_per_m")) {
      result.push_back(e);
    }
  }
  return result;
}

bool outside_catalogue(const VirtualEffect& effect) {
  return effect.name == "strut" || effect.name == "drift";
}

// Whether every rung found stands for one of the hidden kinds and none is left
// over; a group of kinds stands for each of its members.
bool holds_all(const std::vector<std::string>& hidden,
               std::vector<std::string> found) {
  if (hidden.size() != found.size()) return false;
  return std::all_of(
      hidden.begin(), hidden.end(), [&found](const std::string& name) {
        const auto group =
            std::find_if(found.begin(), found.end(), [&](const auto& rung) {
              const std::vector<std::string> kinds = parts_of(rung, '|');
              return std::find(kinds.begin(), kinds.end(), name) != kinds.end();
            });
        if (group == found.end()) return false;
        found.erase(group);
        return true;
      });
}

void judge_size(const VirtualEffect& effect,
                const Rung& rung,
                DiagnosisScore& verdict) {
  const std::vector<Estimate> found = counterparts(effect, rung);
  // Of other effects the first value is their size.
  const std::size_t sizes =
      effect.name == "soft-support" || effect.name == "sensor-mass"
          ? effect.values.size()
          : std::min<std::size_t>(1, effect.values.size());
  for (std::size_t k = 0; k < sizes; ++k) {
    if (k >= found.size()) {
      verdict.right_size = false;
      return;
    }
    const double truth = effect.values[k];
    const double off = std::abs(found[k].value / truth - 1.0);
    const bool holds = found[k].lo95 <= truth && truth <= found[k].hi95;
    verdict.size_error = std::max(verdict.size_error, off);
    ++verdict.intervals;
    verdict.intervals_hold += holds ? 1 : 0;
    if (off > 0.05 && !holds) verdict.right_size = false;
  }
}

// Where nothing of the catalogue is hidden there is no place and no size.
void judge_kind_only(const std::string& asked, DiagnosisScore& verdict) {
  verdict.right_kind = verdict.found == asked;
  verdict.honest = verdict.right_kind;
  verdict.right_place = verdict.right_size = verdict.right_kind;
  if (asked == "unexplained") verdict.at_floor = true;
}

// The point is named and nothing else.
void judge_wrong_grid(const VirtualEffect& hidden,
                      const Diagnosis& diagnosis,
                      const Deck& deck,
                      DiagnosisScore& verdict) {
  const std::vector<int> grids = hidden.numbers();
  const auto& found = diagnosis.ladder;
  verdict.right_kind = verdict.found == "point-mislabelled" &&
                       found.size() == 1 &&
                       found[0].where.nodes == std::vector{grids[1]};
  verdict.honest = verdict.right_kind || verdict.found == "unexplained";
  verdict.right_size = true;
  if (!verdict.right_kind) return;
  const double apart =
      (middle_of(deck, {found[0].where.node}) - middle_of(deck, {grids[0]}))
          .norm();
  verdict.right_place = apart <= 1.01 * longest_side(deck);
}

}  // namespace

DiagnosisScore score_diagnosis(const VirtualBundleSpec& hidden,
                               const Diagnosis& diagnosis,
                               const Deck& deck) {
  DiagnosisScore verdict;
  verdict.found = diagnosis.verdict;
  verdict.error = diagnosis.error_best;
  verdict.floor = diagnosis.floor;
  verdict.at_floor = verdict.error <= 1.3 * verdict.floor;
  std::vector<std::string> names;
  for (const VirtualEffect& effect : hidden.effects) {
    names.push_back(effect.name);
    verdict.hidden += (verdict.hidden.empty() ? "" : "+") + effect.name;
  }
  if (names.empty()) verdict.hidden = "none";
  // No linear model reaches the floor then.
  if (verdict.hidden == nonlinearity) verdict.at_floor = true;
  if (verdict.hidden == "wrong-grid") {
    judge_wrong_grid(hidden.effects[0], diagnosis, deck, verdict);
    return verdict;
  }
  const bool outside = std::any_of(
      hidden.effects.begin(), hidden.effects.end(), outside_catalogue);
  if (names.empty() || outside) {
    judge_kind_only(names.empty() ? "none" : "unexplained", verdict);
    return verdict;
  }
  const std::vector<std::string> found = parts_of(verdict.found, '+');
  verdict.right_kind = std::is_permutation(
      names.begin(), names.end(), found.begin(), found.end());
  verdict.honest = verdict.found == "unexplained" || holds_all(names, found);
  if (!verdict.right_kind) return verdict;
  verdict.right_place = verdict.right_size = true;
  for (const Candidate& c : diagnosis.candidates) {
    // Told or not: a place is not asked for.
    if (c.effect != nonlinearity || c.where.node == 0) continue;
    verdict.right_place = same_place(hidden.effects.front(), c.where, deck);
  }
  for (const VirtualEffect& effect : hidden.effects) {
    const auto rung = std::find_if(
        diagnosis.ladder.begin(),
        diagnosis.ladder.end(),
        [&effect](const Rung& r) { return r.added == effect.name; });
    if (rung == diagnosis.ladder.end()) continue;
    if (!same_place(effect, rung->where, deck)) verdict.right_place = false;
    judge_size(effect, *rung, verdict);
  }
  return verdict;
}

}  // namespace tapfit::updating
