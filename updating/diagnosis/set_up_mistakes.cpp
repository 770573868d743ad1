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

/// One fit of sensors' masses.
struct FittedMasses {
  const std::vector<std::string>* channels;
  const std::vector<Estimate>* estimates;
};

// Those that count, the ladder's or the candidates' with the fewest channels
// first: what one mass for all is, is not each one's.
std::vector<FittedMasses> fitted_masses(const Diagnosis& d) {
  const std::string kind = "sensor-mass";
  std::vector<FittedMasses> found;
  for (const Rung& rung : d.ladder) {
    if (rung.added != kind || !rung.alike.empty()) continue;
    found.push_back({&rung.where.channels, &rung.parameters});
  }
  if (d.verdict == "none") {
    for (const Candidate& one : d.candidates) {
      if (one.effect != kind) continue;
      found.push_back({&one.where.channels, &one.parameters});
    }
  }
  std::ranges::stable_sort(
      found, {}, [](const FittedMasses& fit) { return fit.channels->size(); });
  return found;
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
    const Diagnosis& diagnosis, const acquisition::TestBundle& sheet) {
  const std::vector<FittedMasses> fitted = fitted_masses(diagnosis);
  std::vector<Finding> findings;
  for (std::size_t c = 0; c < sheet.channels.size(); ++c) {
    const std::string& channel = sheet.channels[c].name;
    for (const FittedMasses& fit : fitted) {
      if (std::ranges::count(*fit.channels, channel) == 0) continue;
      const auto mass = std::ranges::find_if(
          *fit.estimates,
          [&](const Estimate& e) { return is_mass_of(e, channel); });
      if (mass == fit.estimates->end()) continue;
      if (auto off = modal::stated_mass_finding(
              sheet, {{c}, mass->value, mass->sd, "the fit of the model"})) {
        findings.push_back(std::move(*off));
      }
      break;
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
