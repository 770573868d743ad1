#include "updating/test_check/body_mass.hpp"

#include "acquisition/foundation/unit_slips.hpp"
#include "modal/checks/modal_mass.hpp"
#include "signal/checks/calibration_findings.hpp"
#include "updating/session/weighed_mass.hpp"

#include <fmt/format.h>

namespace tapfit::updating {
namespace {

using acquisition::TestBundle;

// A scale is that good.
constexpr double scale_share = 0.02;
// The deck is what is doubted: it may lack a mass, or a part.
constexpr double deck_share = 0.5;

std::string in_brackets(const std::string& unit) {
  return unit.empty() ? unit : " (" + unit + ")";
}

double weighed_with_sensors(const TestBundle& bundle) {
  if (!bundle.weighed) return 0.0;
  double sum = bundle.weighed->mass_kg;
  for (const acquisition::Channel& channel : bundle.channels) {
    sum += channel.mass_kg.value_or(0.0);
  }
  return sum;
}

Finding heavy_sensor(const acquisition::Channel& channel, double body_kg) {
  const double kg = *channel.mass_kg;
  return {Severity::Warning,
          {{}, channel.name, {}, {}},
          fmt::format("it is said to weigh {} kg, the structure {} kg",
                      in_digits(kg, 3),
                      in_digits(body_kg, 3)),
          "mass_kg of the sensor is in another unit (1000: g for kg), or the "
          "structure's mass is",
          fmt::format("give mass_kg of {} in kg in test.json", channel.name)};
}

}  // namespace

BodyMass::BodyMass(const TestBundle& bundle,
                   std::optional<double> said_kg,
                   double deck_kg)
    : bundle_(bundle),
      said_kg_(said_kg),
      deck_kg_(deck_kg),
      weighed_kg_(weighed_with_sensors(bundle)),
      differing_(weighed_mass_finding(bundle, deck_kg)) {}

void BodyMass::compare_with(const signal::FrfSet& set,
                            const modal::ModeSet& modes,
                            const std::vector<signal::DrivingPoint>& points) {
  if (!differing_) return;
  const std::vector<modal::ChannelSize> sizes =
      modal::channel_sizes(set, modes);
  const auto moves_like = [&](double kg) {
    return modal::have_mass(sizes, kg) &&
           mass_line_findings(bundle_, set, points, kg, scale_share).empty();
  };
  const bool scale = moves_like(weighed_kg_);
  if (scale != moves_like(deck_kg_)) {
    right_ = scale ? Right::Scale : Right::Deck;
  }
}

double BodyMass::kg() const {
  if (said_kg_) return *said_kg_;
  const bool by_scale = weighed_kg_ > 0.0 && right_ != Right::Deck;
  return by_scale ? weighed_kg_ : deck_kg_;
}

double BodyMass::tolerance() const {
  const bool by_scale = weighed_kg_ > 0.0 && right_ != Right::Deck;
  return said_kg_ || by_scale ? scale_share : deck_share;
}

std::vector<Finding> BodyMass::findings() const {
  std::vector<Finding> found;
  if (differing_) {
    Finding of = *differing_;
    const std::string unit = in_brackets(
        acquisition::mass_slip(bundle_.weighed->mass_kg / deck_kg_));
    if (right_ == Right::Deck) {
      // Fits take it for a datum.
      of.severity = Severity::Error;
      of.likely = "\"weighed\" in test.json is wrong" + unit +
                  ": the structure moves like one of the deck's mass";
    } else if (right_ == Right::Scale) {
      of.likely =
          (unit.empty()
               ? std::string("parts or masses are missing from the deck or "
                             "too many, or a density or thickness is wrong")
               : "a density of the deck is in another unit" + unit) +
          ": the structure moves like one of the weighed mass";
    }
    found.push_back(std::move(of));
  }
  const double body = deck_kg_ > 0.0 ? deck_kg_ : weighed_kg_;
  for (const acquisition::Channel& channel : bundle_.channels) {
    if (body > 0.0 && channel.mass_kg.value_or(0.0) > body) {
      found.push_back(heavy_sensor(channel, body));
    }
  }
  return found;
}

}  // namespace tapfit::updating
