// A channel in another unit than the sheet says: kN for N, g for m/s^2, pounds,
// inches, a range switch a decade off, or velocity where acceleration is meant.
// Its FRFs are multiplied by a known factor, or by s to a power. In one run
// only, with those of its placement, where the range was changed there.
#include "acquisition/foundation/unit_slips.hpp"
#include "updating/effects/sensor_channels.hpp"
#include "updating/set_up/mistakes.hpp"
#include "updating/set_up/sheet_mistake.hpp"
#include "updating/set_up/sheet_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace tapfit::effects {
namespace {

// What a channel reads, times what it should: factor s^power.
struct ReadSlip {
  std::string name;
  double factor = 1.0;
  int power = 0;
};

// Units that are taken for each other, and their quotients: pounds at grams,
// g at inches; an amplifier's ranges.
std::vector<ReadSlip> all_slips() {
  const std::span<const acquisition::UnitSlip> units =
      acquisition::unit_slips();
  std::vector<ReadSlip> slips;
  const auto add = [&slips](const std::string& name, double factor) {
    // Some quotients are the same: 386.1 / 9.807 = 1000 / 25.4.
    const bool known = std::ranges::any_of(slips, [&](const ReadSlip& other) {
      return std::abs(other.factor / factor - 1.0) < 1e-4;
    });
    if (known) return;
    slips.push_back({name, factor, 0});
    slips.push_back({"1/" + name, 1.0 / factor, 0});
  };
  for (const auto& unit : units) add(unit.name, unit.factor);
  for (const auto& step : acquisition::range_steps()) {
    add(step.name, step.factor);
  }
  for (std::size_t a = 0; a < units.size(); ++a) {
    for (std::size_t b = a + 1; b < units.size(); ++b) {
      const double f = units[a].factor;
      const double g = units[b].factor;
      add(fmt::format("{:.4g}", f * g), f * g);
      const double ratio = std::max(f, g) / std::min(f, g);
      add(fmt::format("{:.4g}", ratio), ratio);
    }
  }
  slips.push_back({"integrated", 1.0, -1});
  slips.push_back({"integrated-twice", 1.0, -2});
  slips.push_back({"differentiated", 1.0, 1});
  return slips;
}

const std::vector<ReadSlip>& slips() {
  static const std::vector<ReadSlip> all = all_slips();
  return all;
}

std::vector<std::string> slip_names() {
  std::vector<std::string> names;
  for (const ReadSlip& slip : slips()) names.push_back(slip.name);
  return names;
}

const ReadSlip& slip_of(const Location& where) {
  const auto found = std::ranges::find(slips(), where.variant, &ReadSlip::name);
  assert(found != slips().end());
  return *found;
}

struct Motion {
  acquisition::Quantity quantity;
  const char* si_unit;
};

// An accelerometer's that is a velocity sensor's in truth, and so on.
std::optional<Motion> motion_behind(acquisition::Quantity written, int power) {
  using acquisition::Quantity;
  constexpr std::array<Motion, 3> motions = {{{Quantity::Acceleration, "m/s^2"},
                                              {Quantity::Velocity, "m/s"},
                                              {Quantity::Displacement, "m"}}};
  const auto at = std::ranges::find(motions, written, &Motion::quantity);
  if (at == motions.end()) return std::nullopt;
  const auto real = (at - motions.begin()) - power;
  if (real < 0 || real > 2) return std::nullopt;
  return motions.at(static_cast<std::size_t>(real));
}

acquisition::Quantity quantity_of(const std::string& channel,
                                  const acquisition::TestBundle& sheet) {
  const auto found =
      std::ranges::find(sheet.channels, channel, &acquisition::Channel::name);
  return found->quantity;
}

class UnitFactor final : public SheetMistake {
 public:
  UnitFactor()
      : SheetMistake({.name = "unit-factor",
                      .words = "channel in another unit than written down",
                      .entry = Entry::Measurement,
                      .sits = Sits::AtSheetPoints,
                      .law = Law::Own,
                      .variants = slip_names()}) {}

  // All sensors together and each channel with each factor that it may read too
  // much by (Where::variant), in all runs, then one channel in the runs of one
  // placement, which are averaged.
  std::vector<Location> places(const TestContext& context) const override {
    const acquisition::TestBundle& sheet = *context.bundle;
    std::vector<Location> whole;
    std::vector<Location> single;
    std::vector<Location> channels = channel_places(context);
    const std::vector<Location> sensors = sensor_places(context);
    if (sensors.size() > 1) channels.insert(channels.begin(), sensors.front());
    for (const Location& channel : channels) {
      const acquisition::Quantity written =
          quantity_of(channel.channels.front(), sheet);
      const std::vector<std::vector<int>> averages =
          averaged_runs(channel, sheet);
      for (const ReadSlip& slip : slips()) {
        if (slip.power != 0 && !motion_behind(written, slip.power)) continue;
        whole.push_back(channel);
        whole.back().variant = slip.name;
        // What a sensor measures does not change from run to run.
        const bool all = channel.channels.size() > 1;
        if (slip.power != 0 || all || averages.size() < 2) continue;
        for (const std::vector<int>& runs : averages) {
          single.push_back(whole.back());
          single.back().runs = runs;
        }
      }
    }
    whole.insert(whole.end(), single.begin(), single.end());
    return whole;
  }

  std::vector<Fixed> fixed(const Location& where) const override {
    const ReadSlip& slip = slip_of(where);
    if (slip.power != 0) return {};
    return {{"factor", slip.factor}};
  }

  // Twice the factor's position; one more for the hammer.
  std::size_t passed_as(const Location& where, bool hammer) const override {
    const auto at = static_cast<std::size_t>(&slip_of(where) - slips().data());
    return 2 * at + (hammer ? 1 : 0);
  }

  std::complex<double> law(std::complex<double> s,
                           const std::vector<double>&,
                           std::size_t group) const override {
    const ReadSlip& slip = slips().at(group / 2);
    const std::complex<double> read = slip.factor * std::pow(s, slip.power);
    return group % 2 == 0 ? read : 1.0 / read;
  }

  // A sensitivity, or what is measured, then in its SI unit; nothing for
  // single runs, which have the same sensitivity on the sheet as the others.
  void correct(const Location& where,
               const acquisition::TestBundle&,
               acquisition::TestBundle& sheet) const override {
    if (!where.runs.empty()) return;
    const ReadSlip& slip = slip_of(where);
    for (acquisition::Channel& channel : sheet.channels) {
      if (std::ranges::find(where.channels, channel.name) ==
          where.channels.end()) {
        continue;
      }
      channel.sensitivity *= slip.factor;
      if (slip.power == 0) continue;
      const auto real = motion_behind(channel.quantity, slip.power);
      if (!real) continue;
      // What was written is no unit of that: volts per SI unit stay the same.
      channel.quantity = real->quantity;
      channel.sensitivity /= channel.unit_to_si;
      channel.unit = real->si_unit;
      channel.unit_to_si = 1.0;
    }
  }
};

}  // namespace

const Effect& unit_factor() {
  static const UnitFactor effect;
  return effect;
}

}  // namespace tapfit::effects
