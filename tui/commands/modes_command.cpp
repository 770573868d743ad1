#include "tui/commands/modes_command.hpp"

#include "acquisition/channel_names.hpp"
#include "modal/sensor_shifts.hpp"
#include "modal/uff55.hpp"
#include "tui/commands/open_bundle.hpp"
#include "tui/commands/text_table.hpp"
#include "updating/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

ordered_json shape_json(const modal::ModeSet& modes, const modal::Mode& mode) {
  ordered_json shape = ordered_json::object();
  for (std::size_t row = 0; row < modes.dofs.size(); ++row) {
    const std::complex<double> phi = mode.shape(static_cast<Eigen::Index>(row));
    shape[name(modes.dofs[row])] = {phi.real(), phi.imag()};
  }
  return shape;
}

const char* cause_word(modal::ShiftCause cause) {
  switch (cause) {
    case modal::ShiftCause::SensorMass:
      return "sensor-mass";
    case modal::ShiftCause::SameFraction:
      return "same-fraction";
    case modal::ShiftCause::Unknown:
      return "unknown";
    case modal::ShiftCause::Noise:
      break;
  }
  return "none";
}

ordered_json masses_json(const modal::PoleShifts& shifts,
                         const std::vector<std::string>& channels) {
  ordered_json masses = ordered_json::array();
  const bool shared = shifts.masses.size() == 1;
  for (std::size_t m = 0; m < shifts.masses.size(); ++m) {
    ordered_json names = ordered_json::array();
    for (std::size_t q = 0; q < shifts.sensors.size(); ++q) {
      if (!shared && q != m) continue;
      for (const std::size_t channel : shifts.sensors[q]) {
        if (channel < channels.size()) names.push_back(channels[channel]);
      }
    }
    const modal::MassEstimate& mass = shifts.masses[m];
    masses.push_back({{"channels", std::move(names)},
                      {"mass_kg",
                       {{"value", mass.kg},
                        {"sd", mass.sd_kg},
                        {"lo95", mass.lo95_kg},
                        {"hi95", mass.hi95_kg}}}});
  }
  return masses;
}

ordered_json shifts_json(const modal::PoleShifts& shifts,
                         const std::vector<std::string>& channels) {
  return {{"cause", cause_word(shifts.cause)},
          {"largest_percent", 100.0 * shifts.largest},
          {"explained", shifts.explained},
          {"p_mass", shifts.p_mass},
          {"p_same_fraction", shifts.p_same_fraction},
          {"p_noise", shifts.p_noise},
          {"same_fraction_percent", 100.0 * shifts.same_fraction},
          {"masses", masses_json(shifts, channels)},
          {"statement", statement(shifts, channels)}};
}

}  // namespace

ordered_json modes_json(const modal::ModeSet& modes,
                        const std::vector<std::string>& channels) {
  ordered_json list = ordered_json::array();
  for (const auto& mode : modes.modes) {
    list.push_back(
        {{"frequency_hz",
          {{"value", mode.frequency_hz}, {"sd", mode.frequency_sd_hz}}},
         {"damping_ratio",
          {{"value", mode.damping_ratio}, {"sd", mode.damping_sd}}},
         {"mpc", mode.mpc},
         {"shape", shape_json(modes, mode)}});
  }
  ordered_json json = {{"modes", std::move(list)},
                       {"unit_modal_mass", modes.scaled},
                       {"synthesis_error", modes.synthesis_error},
                       {"warnings", modes.warnings}};
  if (modes.shifts) json["pole_shifts"] = shifts_json(*modes.shifts, channels);
  return json;
}

std::string modes_text(const modal::ModeSet& modes,
                       const std::vector<std::string>& channels) {
  std::string text = fmt::format("Modes: {} identified, synthesis error {}\n",
                                 modes.modes.size(),
                                 percent(modes.synthesis_error));
  TextTable table({"mode", "frequency Hz", "sd Hz", "damping", "sd", "MPC"});
  for (std::size_t index = 0; index < modes.modes.size(); ++index) {
    const auto& mode = modes.modes[index];
    table.add({fmt::format("{}", index + 1),
               fmt::format("{:.3f}", mode.frequency_hz),
               fmt::format("{:.2g}", mode.frequency_sd_hz),
               percent(mode.damping_ratio),
               fmt::format("{:.2g} %", 100.0 * mode.damping_sd),
               fmt::format("{:.3f}", mode.mpc)});
  }
  text += table.text();
  if (modal::is_telling(modes.shifts)) {
    text += "  note: " + statement(*modes.shifts, channels) + "\n";
  }
  for (const auto& warning : modes.warnings)
    text += "  note: " + warning + "\n";
  return text;
}

std::string modes_command(const CommandOptions& options,
                          const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  const modal::ModeSet& modes = session.modes(progress);
  if (options.uff) {
    modal::write_modes_uff(modes, session.bundle().title, *options.uff);
  }
  const std::vector<std::string> channels =
      acquisition::channel_names(session.bundle());
  return options.json ? modes_json(modes, channels).dump(2) + "\n"
                      : modes_text(modes, channels);
}

}  // namespace tapfit::tui
