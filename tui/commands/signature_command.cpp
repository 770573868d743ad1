#include "acquisition/foundation/input_error.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;

ordered_json signature_json(const updating::Signature& signature) {
  ordered_json z = ordered_json::array();
  for (const std::complex<double>& value : signature.z) {
    z.push_back({value.real(), value.imag()});
  }
  const auto list = [](const Eigen::VectorXd& values) {
    return std::vector<double>(values.begin(), values.end());
  };
  return {{"node", signature.node},
          {"explained", signature.explained},
          {"laws",
           {{"mass",
             {{"unexplained", signature.mass_unexplained},
              {"mass_kg", signature.mass_kg}}},
            {"spring",
             {{"unexplained", signature.spring_unexplained},
              {"stiffness_n_per_m", signature.spring_n_per_m}}},
            {"dashpot",
             {{"unexplained", signature.dashpot_unexplained},
              {"damping_ns_per_m", signature.dashpot_ns_per_m}}},
            {"absorber",
             {{"unexplained", signature.absorber.unexplained},
              {"mass_kg", signature.absorber.mass_kg},
              {"frequency_hz", signature.absorber.frequency_hz},
              {"damping_ratio", signature.absorber.damping_ratio}}}}},
          {"frequency_hz", list(signature.frequency_hz)},
          {"z_n_per_m", std::move(z)},
          {"z_sd_n_per_m", list(signature.z_sd)}};
}

std::string signature_text(const updating::Signature& signature) {
  TextTable table({"<law", "left unexplained", "<size"});
  table.add({"mass (falls with frequency squared)",
             percent(signature.mass_unexplained),
             short_number(signature.mass_kg) + " kg"});
  table.add({"spring (constant)",
             percent(signature.spring_unexplained),
             short_number(signature.spring_n_per_m) + " N/m"});
  table.add({"dashpot (imaginary, rises)",
             percent(signature.dashpot_unexplained),
             short_number(signature.dashpot_ns_per_m) + " N s/m"});
  table.add({"absorber (a resonance)",
             percent(signature.absorber.unexplained),
             fmt::format("{} kg, {} Hz, damping {}",
                         short_number(signature.absorber.mass_kg),
                         short_number(signature.absorber.frequency_hz),
                         percent(signature.absorber.damping_ratio))});
  return fmt::format(
             "Missing dynamic stiffness at node {}: one place explains {} of "
             "the discrepancy\n",
             signature.node,
             percent(signature.explained)) +
         table.text();
}

ordered_json localisation_map_json(
    const std::vector<updating::GridShare>& map) {
  ordered_json grids = ordered_json::array();
  for (const updating::GridShare& grid : map) {
    grids.push_back({{"node", grid.node}, {"explained", grid.explained}});
  }
  return {{"grids", std::move(grids)}};
}

std::string localisation_map_text(const std::vector<updating::GridShare>& map) {
  constexpr std::size_t shown = 20;
  TextTable table({"node", "explained", "<"});
  for (std::size_t k = 0; k < std::min(shown, map.size()); ++k) {
    table.add(
        {fmt::format("{}", map[k].node),
         percent(map[k].explained),
         std::string(static_cast<std::size_t>(30.0 * map[k].explained), '#')});
  }
  return fmt::format(
             "Share of the discrepancy that one place explains, the best of {} "
             "grids\n",
             map.size()) +
         table.text();
}

}  // namespace

std::string signature_command(const CommandOptions& options,
                              const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  if (options.node == 0) {
    const auto map = session.localisation_map(progress);
    return options.json ? json_text(localisation_map_json(map))
                        : localisation_map_text(map);
  }
  const updating::Signature signature =
      session.signature(options.node, progress);
  if (signature.z.isZero(0.0)) {
    throw InputError(
        fmt::format("grid {} does not move in the measured direction",
                    options.node),
        "signature",
        "choose a grid that the model does not hold there");
  }
  return options.json ? json_text(signature_json(signature))
                      : signature_text(signature);
}

}  // namespace tapfit::tui
