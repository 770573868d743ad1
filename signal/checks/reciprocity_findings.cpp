#include "signal/checks/reciprocity_findings.hpp"

#include "acquisition/foundation/unit_slips.hpp"
#include "signal/checks/frf_findings.hpp"
#include "signal/checks/shared_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tapfit::signal {
namespace {

using acquisition::TestBundle;

Finding differing_pair(const TestBundle& bundle,
                       const FrfSet& set,
                       const Reciprocal& pair) {
  const Frf& a = set.frfs[pair.frf];
  const Frf& b = set.frfs[pair.other];
  const std::string both = titled(bundle, a) + " and " + titled(bundle, b);
  Finding finding;
  finding.where = subject_of(bundle, a);
  if (b.run != a.run) finding.where.runs.push_back(b.run);
  std::ranges::sort(finding.where.runs);
  const bool factor = pair.by_a_factor();
  if (factor && pair.gain < 0.0) {
    finding.what = both + " have opposite signs";
    finding.likely = "the polarity of one of the two sensors is turned";
    finding.remedy =
        "turn the direction of one of the two sensors in test.json; a "
        "driving point says which";
  } else if (factor && channel_of(bundle, a) == channel_of(bundle, b)) {
    finding.what = fmt::format(
        "{} differ by a factor of {:.4g} and nothing else, though one sensor "
        "measured both",
        both,
        pair.gain);
    finding.likely =
        "its range or the hammer's was changed between the two runs";
    finding.remedy = "give each run the sensitivity it was measured with";
  } else if (factor) {
    finding.what = fmt::format(
        "{} differ by a factor of {:.4g} and nothing else", both, pair.gain);
    finding.likely =
        "one of the two sensitivities is off by it, or the hammer's in one of "
        "the two runs";
    const std::string unit = acquisition::channel_slip(std::abs(pair.gain));
    if (!unit.empty()) finding.likely += ": a unit or range (" + unit + ")";
    finding.remedy = unit.empty()
                         ? "tapfit calibrate on a free mass says which"
                         : fmt::format(
                               "check unit, sensitivity and "
                               "sensitivity_unit of {} and {} in test.json",
                               channel_of(bundle, a),
                               channel_of(bundle, b));
  } else if (pair.by_a_constant()) {
    const bool first = pair.constant > 0.0;
    finding.what = fmt::format("{} differ by {:.3g} %: by a constant {:.3g} {}",
                               both,
                               100.0 * pair.difference,
                               std::abs(pair.constant),
                               "(m/s^2)/N, on all lines");
    finding.likely = fmt::format(
        "the hammer's signal leaks into that of {} ({} with the opposite "
        "sign): "
        "crosstalk of cables or channels",
        channel_of(bundle, first ? a : b),
        channel_of(bundle, first ? b : a));
    finding.remedy =
        "lay the cables apart and ground them at one end; a tap on another "
        "structure shows what is left of it";
  } else {
    finding.what = fmt::format("{} differ by {:.3g} %, whatever the factor",
                               both,
                               100.0 * pair.shape_difference);
    finding.likely =
        "a point or direction is another one than written down, a sensor "
        "that moved has shifted the resonances (tapfit modes tells its "
        "mass), or hits of differing strength move a structure that is not "
        "linear";
    finding.remedy = "compare the two points with the sheet";
  }
  return finding;
}

// A sensor across the direction written down hears a few per cent of what it
// should: its transverse sensitivity.
constexpr double most_across = 0.2;

Finding factor_finding(const TestBundle& bundle, const SharedFactor& shared) {
  const std::string who = shared.channel < bundle.channels.size()
                              ? bundle.channels[shared.channel].name
                              : "the sensor at " + name(shared.point);
  const std::string hammer =
      shared.run < bundle.runs.size()
          ? bundle.channels[bundle.runs[shared.run].hammer.channel].name
          : "the hammer";
  const std::string unit = acquisition::channel_slip(shared.factor);
  return {Severity::Warning,
          {{shared.run}, who, {}, name(shared.point)},
          fmt::format("{} paths from {} to other points differ from the way "
                      "back by a factor of {:.4g} and nothing else",
                      shared.pairs.size(),
                      name(shared.point),
                      shared.factor),
          fmt::format("of the sensitivities that of {} is off by it, or that "
                      "of {} in run {}{}{}",
                      who,
                      hammer,
                      shared.run + 1,
                      unit.empty() ? unit : ": a unit or range (" + unit + ")",
                      shared.factor < most_across
                          ? fmt::format(", or {} measures across the direction "
                                        "written down",
                                        who)
                          : std::string()),
          unit.empty()
              ? "tapfit calibrate on a free mass says whether it is the sensor"
              : fmt::format("check unit, sensitivity and sensitivity_unit of "
                            "{} in test.json",
                            who)};
}

}  // namespace

std::vector<Finding> reciprocity_findings(
    const TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Reciprocal>& pairs) {
  std::vector<Finding> found;
  std::set<std::size_t> told;
  for (const SharedFactor& shared : shared_factors(set, pairs)) {
    told.insert(shared.pairs.begin(), shared.pairs.end());
    found.push_back(factor_finding(bundle, shared));
  }
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (pairs[p].fair() || told.contains(p)) continue;
    found.push_back(differing_pair(bundle, set, pairs[p]));
  }
  return found;
}

}  // namespace tapfit::signal
