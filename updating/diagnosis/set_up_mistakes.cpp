#include "updating/diagnosis/set_up_mistakes.hpp"

#include "modal/mass_loading/stated_masses.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/set_up/sheet_edits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

// Whether an estimate is of that channel: "mass_kg" of all, "mass_kg.acc1".
bool is_mass_of(const Estimate& mass, const std::string& channel) {
  const std::string name = "mass_kg";
  return mass.name == name || mass.name == name + "." + channel;
}

}  // namespace

std::vector<SetUpMistake> set_up_mistakes(
    const std::vector<Rung>& ladder, const acquisition::TestBundle& sheet) {
  std::vector<SetUpMistake> result;
  acquisition::TestBundle corrected = sheet;
  for (const Rung& rung : ladder) {
    const std::string kind = leading_kind(rung);
    const effects::Effect& effect = effects::find(kind);
    if (!effect.is_mistake()) continue;
    std::vector<std::string> edits =
        effects::sheet_edits(effect, rung.where, sheet, corrected);
    effect.correct(rung.where, sheet, corrected);
    if (edits.empty()) continue;
    result.push_back({kind,
                      rung.where,
                      rung.probability,
                      rung.error,
                      fmt::format("{}", fmt::join(edits, "; "))});
  }
  return result;
}

// ln p of one reading x by a normal density of sd x over that of sd u:
// (x / u)^2 / 2 - ln(x / u) - 1/2.
std::vector<SetUpMistake> run_outliers(
    const std::vector<modal::ForeignRun>& foreign,
    std::size_t runs,
    double error) {
  std::vector<SetUpMistake> result;
  for (const modal::ForeignRun& one : foreign) {
    const double times = one.left / std::max(one.usual, 1e-12);
    const double gain = 0.5 * times * times - std::log(times) - 0.5 -
                        std::log(static_cast<double>(runs));
    Location where;
    where.runs = {static_cast<int>(one.run) + 1};
    result.push_back(
        {"run-outlier",
         std::move(where),
         1.0 / (1.0 + std::exp(-gain)),
         error,
         fmt::format("runs[{0}].file, or take runs[{0}] out", one.run)});
  }
  return result;
}

std::vector<Finding> sensor_mass_findings(
    const std::vector<Rung>& ladder, const acquisition::TestBundle& sheet) {
  std::vector<Finding> findings;
  for (const Rung& rung : ladder) {
    if (rung.added != "sensor-mass" || !rung.alike.empty()) continue;
    for (std::size_t c = 0; c < sheet.channels.size(); ++c) {
      const std::string& channel = sheet.channels[c].name;
      if (std::ranges::count(rung.where.channels, channel) == 0) continue;
      const auto mass = std::ranges::find_if(
          rung.parameters,
          [&](const Estimate& e) { return is_mass_of(e, channel); });
      if (mass == rung.parameters.end() || mass->at_bound) continue;
      if (auto off = modal::stated_mass_finding(
              sheet, {{c}, mass->value, mass->sd, "the fit of the model"})) {
        findings.push_back(std::move(*off));
      }
    }
  }
  return findings;
}

std::string describe(const SetUpMistake& mistake) {
  return fmt::format("{}: correct {}",
                     effect_text(mistake.mistake, mistake.where),
                     mistake.edit);
}

}  // namespace tapfit::updating
