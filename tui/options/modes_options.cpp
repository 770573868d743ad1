#include "tui/options/option_groups.hpp"

#include <cmath>
#include <cstdlib>

namespace tapfit::tui {
namespace {

CLI::Validator finite() {
  return {[](const std::string& text) {
            return std::isfinite(std::strtod(text.c_str(), nullptr))
                       ? std::string()
                       : text + " is no number to hold a mode to";
          },
          ""};
}

/// An option of some percentages that set as many ratios.
void add_percents(CLI::App& command,
                  const std::string& name,
                  const std::string& values,
                  const std::vector<double*>& ratios,
                  const std::string& does) {
  command
      .add_option_function<std::vector<double>>(
          name,
          [ratios, name](const std::vector<double>& percents) {
            if (percents.size() == 2 && !(percents[0] < percents[1])) {
              throw CLI::ValidationError(name, "give the least first");
            }
            for (std::size_t k = 0; k < ratios.size(); ++k) {
              *ratios[k] = 0.01 * percents[k];
            }
          },
          does)
      ->type_name(values)
      ->expected(static_cast<int>(ratios.size()))
      ->check(CLI::Range(0.0, 100.0))
      ->check(finite());
}

}  // namespace

void add_modes_options(CLI::App& command, ModesArguments& arguments) {
  modal::IdentifyOptions& identify = arguments.identify;
  command
      .add_option("--order",
                  identify.max_order,
                  "Largest model order, pairs of poles (100)")
      ->check(CLI::Range(2, 500));
  add_percents(command,
               "--stable",
               "FREQUENCY DAMPING VECTOR",
               {&identify.frequency_tolerance,
                &identify.damping_tolerance,
                &identify.vector_tolerance},
               "Tolerances of stable poles in % (1 5 2)");
  add_percents(command,
               "--damping",
               "LEAST LARGEST",
               {&identify.least_damping_ratio, &identify.max_damping_ratio},
               "Least and largest damping of a mode in % (0.0001 20)");
  command.add_option("--mpc", identify.least_mpc, "Least MPC of a mode (0.2)")
      ->check(CLI::Range(0.0, 1.0))
      ->check(finite());
  command
      .add_option("--mpd",
                  identify.largest_mpd_deg,
                  "Largest mean phase deviation of a mode in degrees (60)")
      ->check(CLI::Range(0.0, 90.0))
      ->check(finite());
  command.add_flag(
      "--diagram", arguments.diagram, "Print the stabilisation diagram too");
  command
      .add_option(
          "--dataset", arguments.dataset, "Of --uff: 55 (default) or 2414")
      ->check(CLI::IsMember({55, 2414}));
  command
      .add_option("--fit",
                  arguments.fit,
                  "Universal file for the synthesised FRFs (58)")
      ->type_name("FILE");
}

}  // namespace tapfit::tui
