#include "signal/checks/calibration_findings.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/finding_text.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

std::string calibrate_command(const CommandOptions& options,
                              const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  refuse_modes(session.bundle());
  const signal::FrfSet& frfs = session.frfs(progress);
  const auto found = signal::calibrate(frfs, options.mass_kg);
  const auto findings =
      signal::calibration_findings(session.bundle(), frfs, found);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  TextTable table({"<FRF", "run", "gain", "sd", "delay s", "sd", "deviation"});
  for (const signal::Calibration& c : found) {
    const signal::Frf& frf = frfs.frfs[c.frf];
    list.push_back({{"frf", name(frf)},
                    {"run", frf.run + 1},
                    {"gain", {{"value", c.gain}, {"sd", c.gain_sd}}},
                    {"delay_s", {{"value", c.delay_s}, {"sd", c.delay_sd}}},
                    {"deviation", c.deviation}});
    table.add({name(frf),
               fmt::format("{}", frf.run + 1),
               fmt::format("{:.5f}", c.gain),
               fmt::format("{:.2g}", c.gain_sd),
               fmt::format("{:.3g}", c.delay_s),
               fmt::format("{:.2g}", c.delay_sd),
               percent(c.deviation)});
  }
  if (options.json) {
    return json_text(nlohmann::ordered_json{
        {"calibration", list},
        {"findings", findings_json(session.bundle(), findings)}});
  }
  return fmt::format("Accelerance times {:g} kg, which is 1 for a fair chain\n",
                     options.mass_kg) +
         table.text() +
         "  gain: the sensor's over the hammer's sensitivity, true over "
         "assumed; below zero: polarity turned\n  deviation: how little the "
         "body answers as a mass alone\n" +
         findings_text(findings);
}

}  // namespace tapfit::tui
