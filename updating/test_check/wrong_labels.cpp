#include "updating/test_check/wrong_labels.hpp"

#include "modal/checks/sensor_patterns.hpp"

#include <algorithm>

namespace tapfit::updating {
namespace {

using acquisition::TestBundle;
using signal::DrivingPoint;
using signal::Frf;
using signal::FrfSet;
using signal::WrongLabel;

bool same_sensors(const acquisition::Run& a, const acquisition::Run& b) {
  return std::ranges::equal(
      a.sensors, b.sensors, [](const auto& one, const auto& other) {
        return one.channel == other.channel && one.dof == other.dof;
      });
}

// Whether run_residue_findings() holds the run against others.
bool has_pattern(const TestBundle& bundle, std::size_t run) {
  const acquisition::Run& own = bundle.runs.at(run);
  const auto alike =
      std::ranges::count_if(bundle.runs, [&own](const acquisition::Run& other) {
        return same_sensors(own, other);
      });
  return own.sensors.size() > 1 && static_cast<std::size_t>(alike) >=
                                       modal::RunResidueLimits{}.fewest_runs;
}

bool is_about(const Finding& finding, std::size_t run) {
  return std::ranges::find(finding.where.runs, run) != finding.where.runs.end();
}

// A driving point in another run that would not be as it is were the two
// channels exchanged throughout: on others it would be fair.
bool speaks_against_exchange(const FrfSet& set,
                             const DrivingPoint& of,
                             const DrivingPoint& other) {
  const Frf& own = set.frfs[of.frf];
  const Frf& there = set.frfs[other.frf];
  const std::size_t one = own.channel;
  const std::size_t two = set.frfs[*of.rather].channel;
  if (there.run == own.run || other.peaks == 0) return false;
  if (there.channel != one && there.channel != two) return other.mixed();
  const std::size_t partner = there.channel == one ? two : one;
  const bool exchanged =
      other.rather && set.frfs[*other.rather].channel == partner;
  return other.fair() || (other.mixed() && !exchanged);
}

}  // namespace

WrongLabels wrong_labels(const TestBundle& bundle,
                         const FrfSet& set,
                         const std::vector<Finding>& residues,
                         std::vector<DrivingPoint>& points) {
  WrongLabels wrong;
  for (DrivingPoint& point : points) {
    if (!point.rather) continue;
    const std::size_t run = set.frfs[point.frf].run;
    if (run >= bundle.runs.size() || !has_pattern(bundle, run)) continue;
    const bool differs = std::ranges::any_of(
        residues, [run](const Finding& of) { return is_about(of, run); });
    if (differs) {
      point.wrong = WrongLabel::Channel;
      wrong.channels.insert(run);
    } else if (std::ranges::any_of(points, [&](const DrivingPoint& other) {
                 return speaks_against_exchange(set, point, other);
               })) {
      point.wrong = WrongLabel::Blow;
      wrong.blows.insert(run);
    }
  }
  return wrong;
}

std::vector<Finding> without_exchanged(std::vector<Finding> residues,
                                       const WrongLabels& labels) {
  std::erase_if(residues, [&labels](Finding& of) {
    std::erase_if(of.where.runs, [&labels](std::size_t run) {
      return labels.channels.contains(run);
    });
    return of.where.runs.empty();
  });
  return residues;
}

}  // namespace tapfit::updating
