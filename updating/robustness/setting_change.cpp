#include "updating/robustness/setting_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

constexpr std::size_t most_groups = 10;
// Of ln factor: as good as held.
constexpr double held_sd = 1e-6;

constexpr double half = 0.5;
constexpr double twice = 2.0;

const char* word(double factor) { return factor < 1.0 ? "halved" : "doubled"; }

void add_priors(const FitProblem& problem,
                const std::vector<PropertyName>& properties,
                std::vector<SettingChange>& changes) {
  const auto add = [&changes](const std::string& of,
                              std::vector<std::size_t> which) {
    for (const double factor : {half, twice}) {
      SettingChange change{fmt::format("prior of {} {}", of, word(factor))};
      change.of = which;
      change.prior = factor;
      changes.push_back(std::move(change));
    }
  };
  std::vector<std::size_t> corrections;
  for (std::size_t k = 0; k < problem.uncertain_sd.size(); ++k) {
    k < properties.size() ? add(properties[k].name, {k})
                          : corrections.push_back(k);
  }
  if (!corrections.empty()) add("the model's corrections", corrections);
  if (problem.targets.back().is_modal()) return;  // damping is no datum
  for (const double factor : {half, twice}) {
    SettingChange change{fmt::format("prior of damping {}", word(factor))};
    change.damping_prior = factor;
    changes.push_back(std::move(change));
  }
}

// "run 3", "runs 3 to 5".
std::string runs_text(const std::vector<std::size_t>& runs) {
  return runs.size() == 1
             ? fmt::format("run {}", runs.front() + 1)
             : fmt::format("runs {} to {}", runs.front() + 1, runs.back() + 1);
}

// Neighbours go together, in groups as even as can be.
void add_runs(const FitProblem& problem, std::vector<SettingChange>& changes) {
  const Target& target = problem.targets.back();
  const std::set<std::size_t> all(target.run.begin(), target.run.end());
  const std::vector<std::size_t> runs(all.begin(), all.end());
  if (runs.size() < 2) return;
  const std::size_t groups = std::min(runs.size(), most_groups);
  for (std::size_t g = 0; g < groups; ++g) {
    SettingChange change;
    for (std::size_t k = g * runs.size() / groups;
         k < (g + 1) * runs.size() / groups;
         ++k) {
      change.left_out.push_back(runs[k]);
    }
    change.what = runs_text(change.left_out) + " left out";
    changes.push_back(std::move(change));
  }
}

}  // namespace

bool SettingChange::moves_fits() const {
  return !of.empty() || damping_prior != 1.0 || !left_out.empty();
}

std::vector<SettingChange> setting_changes(
    const FitProblem& problem, const std::vector<PropertyName>& properties) {
  std::vector<SettingChange> changes;
  add_priors(problem, properties, changes);
  for (std::size_t k = 0; k < properties.size(); ++k) {
    SettingChange change{properties[k].name + " held at the deck's value"};
    change.of = {k};
    change.held = true;
    changes.push_back(std::move(change));
  }
  for (const double factor : {half, twice}) {
    SettingChange change{fmt::format("allowance for form {}", word(factor))};
    change.form = factor;
    changes.push_back(std::move(change));
  }
  add_runs(problem, changes);
  return changes;
}

FitProblem changed(FitProblem problem, const SettingChange& change) {
  for (const std::size_t k : change.of) {
    double& sd = problem.uncertain_sd.at(k);
    sd = change.held ? held_sd : change.prior * sd;
  }
  problem.damping_spread *= change.damping_prior;
  problem.form_allowance *= change.form;
  for (Target& target : problem.targets) leave_out(change.left_out, target);
  return problem;
}

}  // namespace tapfit::updating
