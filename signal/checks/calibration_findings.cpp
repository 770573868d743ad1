#include "signal/checks/calibration_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using acquisition::TestBundle;

constexpr double slight_gain = 0.005;
constexpr double much_deviation = 0.05;
constexpr double slight_phase = 0.05;  // at the band's end [rad]

}  // namespace

std::vector<Finding> mass_line_findings(const TestBundle& bundle,
                                        const FrfSet& set,
                                        const std::vector<DrivingPoint>& points,
                                        double mass_kg,
                                        double share) {
  std::vector<Finding> found;
  for (const DrivingPoint& point : points) {
    if (point.low != LowLine::Mass ||
        point.mass_kg <= (1.0 + share) * mass_kg) {
      continue;
    }
    const Frf& frf = set.frfs[point.frf];
    found.push_back(
        {Severity::Warning,
         subject_of(bundle, frf),
         fmt::format("{}: its mass line is {:.4g} kg, the whole body has "
                     "{:.4g} kg",
                     titled(bundle, frf),
                     point.mass_kg,
                     mass_kg),
         fmt::format("{} over the hammer reads {:.4g} times what it should, or "
                     "less",
                     channel_of(bundle, frf),
                     mass_kg / point.mass_kg),
         "check both sensitivities with tapfit calibrate on a free mass, and "
         "the mass on a scale"});
  }
  return found;
}

std::vector<Finding> calibration_findings(
    const TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Calibration>& found) {
  std::vector<Finding> result;
  for (const Calibration& c : found) {
    const Frf& frf = set.frfs[c.frf];
    const std::string who = titled(bundle, frf);
    if (c.deviation > much_deviation) {
      result.push_back(
          {Severity::Warning,
           subject_of(bundle, frf),
           fmt::format("{}: the body answers as a mass alone only to {:.3g} %",
                       who,
                       100.0 * c.deviation),
           "a resonance of the body or its suspension lies in the band",
           "take a band (band_hz) well below its first resonance and above "
           "that of its suspension; gain and delay mean little till then"});
    }
    if (c.gain < 0.0) {
      result.push_back({Severity::Warning,
                        subject_of(bundle, frf),
                        who + ": the answer points against the blow",
                        "the polarity is inverted",
                        "turn the sensor's direction in test.json"});
    }
    if (c.deviation > much_deviation) continue;
    const double off = std::abs(c.gain) - 1.0;
    if (std::abs(off) > std::max(slight_gain, 2.0 * c.gain_sd)) {
      const bool known = frf.channel < bundle.channels.size();
      const double now = known ? bundle.channels[frf.channel].sensitivity : 1.0;
      result.push_back(
          {Severity::Warning,
           subject_of(bundle, frf),
           fmt::format(
               "{}: reads {:.4g} times what it should", who, std::abs(c.gain)),
           "a sensitivity is off by that",
           known ? fmt::format("with a hammer that is right, the sensitivity "
                               "of {} is {:.5g} V/({}), not {:.5g}; where all "
                               "sensors are off alike, divide the hammer's by "
                               "{:.4g}",
                               channel_of(bundle, frf),
                               now * std::abs(c.gain),
                               bundle.channels[frf.channel].unit,
                               now,
                               std::abs(c.gain))
                 : "scale the FRFs anew in the program that made them"});
    }
    if (std::abs(c.delay_s) > 2.0 * c.delay_sd &&
        std::abs(c.delay_s) * set.s.imag().maxCoeff() > slight_phase) {
      result.push_back(
          {Severity::Warning,
           subject_of(bundle, frf),
           fmt::format("{}: comes {:.3g} s {} the hammer",
                       who,
                       std::abs(c.delay_s),
                       c.delay_s > 0.0 ? "behind" : "before"),
           "filters or converters that differ",
           "give both channels the same anti-alias filter and converter; the "
           "diagnosis takes it in as channel-delay"});
    }
  }
  return result;
}

}  // namespace tapfit::signal
