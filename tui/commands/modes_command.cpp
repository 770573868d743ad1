#include "tui/commands/modes_command.hpp"

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

}  // namespace

ordered_json modes_json(const modal::ModeSet& modes) {
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
  return {{"modes", std::move(list)},
          {"unit_modal_mass", modes.scaled},
          {"synthesis_error", modes.synthesis_error},
          {"warnings", modes.warnings}};
}

std::string modes_text(const modal::ModeSet& modes) {
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
  return options.json ? modes_json(modes).dump(2) + "\n" : modes_text(modes);
}

}  // namespace tapfit::tui
