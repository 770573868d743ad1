#include "modal/mass_loading/stated_masses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::modal {
namespace {

constexpr double certain = 3.0;   // standard deviations
constexpr double mounting = 0.1;  // cable, glue and mount, of the sensor

std::string as_grams(double kg) { return in_digits(1e3 * kg, 3); }

}  // namespace

std::optional<Finding> stated_mass_finding(
    const acquisition::TestBundle& bundle, const FoundMass& found) {
  double each = 0.0;
  double all = 0.0;
  std::string who;
  for (const std::size_t c : found.channels) {
    if (c >= bundle.channels.size()) return {};
    const acquisition::Channel& channel = bundle.channels[c];
    who += (who.empty() ? "" : ", ") + channel.name;
    each = std::max(each, channel.mass_kg.value_or(0.0));
    all += channel.mass_kg.value_or(0.0);
  }
  if (!(all > 0.0) || !(found.kg > 0.0)) return {};
  const double stated = std::clamp(found.kg, each, all);
  const double sd = std::hypot(found.sd_kg, mounting * stated);
  if (std::abs(found.kg - stated) <= certain * sd) return {};
  return Finding{Severity::Warning,
                 {{}, who, {}, {}},
                 fmt::format("its mass is {} g (sd {} g) by {}, and {} g in "
                             "test.json",
                             as_grams(found.kg),
                             as_grams(found.sd_kg),
                             found.by,
                             as_grams(stated)),
                 "mass_kg is that of another sensor or in another unit, or the "
                 "deck has the sensor already",
                 "weigh the sensor and correct its mass_kg in test.json"};
}

std::vector<Finding> stated_mass_findings(
    const acquisition::TestBundle& bundle,
    const std::optional<PoleShifts>& shifts) {
  if (!shifts || shifts->cause != ShiftCause::SensorMass) return {};
  std::vector<Finding> findings;
  for (std::size_t s = 0; s < shifts->sensors.size(); ++s) {
    if (shifts->masses.empty()) break;
    const MassEstimate& mass =
        shifts->masses[std::min(s, shifts->masses.size() - 1)];
    if (auto off = stated_mass_finding(bundle,
                                       {shifts->sensors[s],
                                        mass.kg,
                                        mass.sd_kg,
                                        "how frequencies move with it"})) {
      findings.push_back(std::move(*off));
    }
  }
  return findings;
}

}  // namespace tapfit::modal
