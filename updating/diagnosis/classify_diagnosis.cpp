#include "updating/diagnosis/classify_diagnosis.hpp"

#include "updating/diagnosis/worth.hpp"
#include "updating/fit/active_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// What the FRFs change with the force is a good part of what is left. At the
// floor nothing is, unless it is the change that lifts the floor: hits that
// differ in force scatter by it.
bool is_nonlinear(const signal::LinearityFinding& level,
                  const Diagnosis& result) {
  constexpr double most = 1.0 / 2.0;
  return follows_the_force(level, result.error_best) &&
         (result.error_best > at_floor * result.floor ||
          level.change >= most * std::min(result.floor, result.error_best));
}

// A rung stands by itself where it explains far more than what changes with the
// force. A spring that hardens alone looks like a linear one at the mean force,
// and its stiffness doubles where the motion grows by 40 %.
std::vector<bool> believed(const signal::LinearityFinding& level,
                           const Diagnosis& result) {
  constexpr double clear = 3.0;
  std::vector<bool> believed;
  double before = result.error_fitted;
  for (const Rung& rung : result.ladder) {
    const double drop = before * before - rung.error * rung.error;
    believed.push_back(drop >= std::pow(clear * level.change, 2));
    before = rung.error;
  }
  return believed;
}

std::string joined(const std::vector<Rung>& ladder,
                   const std::vector<bool>& named) {
  std::string names;
  for (std::size_t k = 0; k < ladder.size(); ++k) {
    if (named[k]) names += (names.empty() ? "" : "+") + ladder[k].added;
  }
  return names;
}

void name_nonlinearity(const signal::LinearityFinding& level,
                       Diagnosis& result) {
  const std::vector<bool> own = believed(level, result);
  result.verdict = joined(result.ladder, own);
  result.verdict += (result.verdict.empty() ? "" : "+");
  result.verdict += nonlinearity;
  Candidate candidate;
  candidate.effect = nonlinearity;
  candidate.probability = 1.0 - level.p_value;
  candidate.error = result.error_best;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (own[k]) continue;
    const Rung& rung = result.ladder[k];
    const bool there = std::ranges::none_of(
        rung.alike, [](const auto& other) { return other.where.node != 0; });
    if (there && candidate.where.node == 0) {
      candidate.where.node = rung.where.node;
    }
    result.warnings.push_back(fmt::format(
        "{} at {} is what comes closest to the nonlinearity at the force that "
        "was used, not an effect by itself",
        rung.added,
        describe(rung.where)));
  }
  result.candidates.insert(result.candidates.begin(), std::move(candidate));
}

}  // namespace

bool follows_the_force(const signal::LinearityFinding& level, double error) {
  constexpr double part = 1.0 / 3.0;
  return level.is_nonlinear() && level.change >= part * error;
}

void classify_diagnosis(const signal::LinearityFinding& level,
                        const std::vector<std::string>& held,
                        Diagnosis& result) {
  constexpr double wide = 0.1;
  if (level.runs == 0 && result.floor > wide) {
    result.warnings.emplace_back(
        "whether the FRFs change with the force, which scatter like this may "
        "come from, cannot be seen: it takes three hits of different force or "
        "more in a run");
  }
  if (is_nonlinear(level, result)) return name_nonlinearity(level, result);
  result.verdict =
      joined(result.ladder, std::vector<bool>(result.ladder.size(), true));
  const bool effects = !result.ladder.empty();
  const double left = effects ? result.error_best : result.error_base;
  const bool much =
      is_unexplained(left, result.floor, result.error_base, effects);
  if (!effects) {
    result.verdict = much ? "unexplained" : "none";
    if (!much || held.empty()) return;
    result.warnings.push_back(
        fmt::format("an error of {:.3g} is left, far above the floor of "
                    "{:.3g}: {}",
                    result.error_best,
                    result.floor,
                    what_is_left(held)));
    return;
  }
  if (!much) return;
  result.warnings.push_back(fmt::format(
      "{} lowers the error from {:.3g} to {:.3g} only, far above the floor "
      "of {:.3g}: {}",
      result.verdict,
      result.error_base,
      result.error_best,
      result.floor,
      what_is_left(held)));
  result.verdict = "unexplained";
}

}  // namespace tapfit::updating
