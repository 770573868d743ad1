#include "tui/report/modes_text.hpp"

#include "modal/mass_loading/sensor_shifts.hpp"
#include "modal/mode_set/complexity.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

ordered_json by_point(const modal::ModeSet& modes,
                      const Eigen::VectorXd& values) {
  ordered_json json = ordered_json::object();
  for (std::size_t row = 0; row < modes.dofs.size(); ++row) {
    json[name(modes.dofs[row])] = values(static_cast<Eigen::Index>(row));
  }
  return json;
}

// Null where the diagram has no poles of the mode: it was put in by hand, or
// comes from too low an order.
ordered_json cluster_json(const modal::PoleCluster& cluster) {
  if (cluster.poles == 0) return nullptr;
  return {{"poles", cluster.poles},
          {"frequency_hz",
           {{"mean", cluster.frequency_hz},
            {"scatter", cluster.frequency_scatter_hz}}},
          {"damping_ratio",
           {{"mean", cluster.damping_ratio},
            {"scatter", cluster.damping_scatter}}}};
}

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

/// Null where it is unknown.
ordered_json or_null(double value, bool is_known) {
  return is_known ? ordered_json(value) : ordered_json(nullptr);
}

// As a test consists of them: nothing was fitted to FRFs.
bool is_given(const modal::ModeSet& modes) {
  return modes.fitted.empty() && modes.diagram.empty() &&
         modes.synthesis_error == 0.0;
}

std::string heading(const modal::ModeSet& modes) {
  if (modes.modes.empty()) return "Modes: none identified";
  if (is_given(modes)) {
    return fmt::format("Modes: {}, as given", modes.modes.size());
  }
  return fmt::format(
      "Modes: {} identified, synthesis error {} ({} before the poles were "
      "refined)",
      modes.modes.size(),
      percent(modes.synthesis_error),
      percent(modes.unrefined_error));
}

}  // namespace

std::string damping_words(const modal::Mode& mode, int digits) {
  if (!(mode.damping_ratio > 0.0)) return "–";
  return with_sd(100.0 * mode.damping_ratio, 100.0 * mode.damping_sd, digits);
}

std::string mpc_words(const modal::Mode& mode) {
  return mode.shape.size() == 0 ? "–" : fixed(mode.mpc, 3);
}

ordered_json modes_json(const modal::ModeSet& modes,
                        const std::vector<std::string>& channels) {
  ordered_json list = ordered_json::array();
  const bool fitted = !is_given(modes);
  for (const auto& mode : modes.modes) {
    const bool damped = mode.damping_ratio > 0.0;
    const bool shaped = mode.shape.size() > 0;
    list.push_back(
        {{"frequency_hz",
          {{"value", mode.frequency_hz}, {"sd", mode.frequency_sd_hz}}},
         {"damping_ratio",
          {{"value", or_null(mode.damping_ratio, damped)},
           {"sd", or_null(mode.damping_sd, damped && mode.damping_sd > 0.0)}}},
         {"mpc", or_null(mode.mpc, shaped)},
         {"mpd_deg", or_null(mode.mpd_deg, shaped)},
         {"cluster", cluster_json(mode.cluster)},
         {"shape", shape_json(modes, mode)},
         {"real_shape", by_point(modes, modal::real_shape(mode.shape))}});
    if (mode.shape_sd.size() == mode.shape.size()) {
      list.back()["shape_sd"] = by_point(modes, mode.shape_sd);
    }
  }
  ordered_json json = {
      {"modes", std::move(list)},
      {"unit_modal_mass", modes.scaled},
      {"unrefined_error", or_null(modes.unrefined_error, fitted)},
      {"synthesis_error", or_null(modes.synthesis_error, fitted)},
      {"warnings", modes.warnings}};
  if (modes.shifts) json["pole_shifts"] = shifts_json(*modes.shifts, channels);
  return json;
}

std::string modes_text(const modal::ModeSet& modes,
                       const std::vector<std::string>& channels) {
  std::string text = heading(modes) + "\n";
  TextTable table({"mode",
                   "frequency Hz",
                   "damping %",
                   "MPC",
                   "MPD deg",
                   "poles",
                   "scatter Hz"});
  for (std::size_t index = 0; index < modes.modes.size(); ++index) {
    const auto& mode = modes.modes[index];
    table.add(
        {fmt::format("{}", index + 1),
         with_sd(mode.frequency_hz, mode.frequency_sd_hz),
         damping_words(mode),
         mpc_words(mode),
         mode.shape.size() == 0 ? "–" : fmt::format("{:.1f}", mode.mpd_deg),
         mode.cluster.poles == 0 ? "–" : fmt::format("{}", mode.cluster.poles),
         mode.cluster.poles == 0
             ? "–"
             : fmt::format("{:.2g}", mode.cluster.frequency_scatter_hz)});
  }
  if (!modes.modes.empty()) text += table.text();
  if (modal::is_significant(modes.shifts)) {
    text += "  note: " + statement(*modes.shifts, channels) + "\n";
  }
  for (const auto& warning : modes.warnings)
    text += "  note: " + warning + "\n";
  return text;
}

}  // namespace tapfit::tui
