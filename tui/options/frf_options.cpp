#include "signal/mass_removal/named_masses.hpp"
#include "tui/options/option_groups.hpp"

namespace tapfit::tui {
namespace {

/// What is wrong with a mass as written; empty where nothing is.
std::string free_fault(const std::string& text) {
  return signal::parse_free(text)
             ? std::string{}
             : "\"" + text + "\" is not SENSOR[=KG][,sd=KG]";
}

}  // namespace

void add_estimate(CLI::App& command, FrfArguments& frf) {
  command.add_option("--estimator", frf.estimator, "H1 (default), H2 or Hv")
      ->check(CLI::IsMember({"H1", "H2", "Hv"}));
  command
      .add_option(
          "--form", frf.form, "accelerance (default), mobility or receptance")
      ->check(CLI::IsMember({"accelerance", "mobility", "receptance"}));
  auto* window = command
                     .add_option("--window",
                                 frf.window,
                                 "Value of the exponential window at the "
                                 "block's end (0.01; 1: none)")
                     ->check(CLI::Range(1e-6, 1.0));
  command
      .add_option(
          "--sigma", frf.sigma, "On the line s = sigma + j omega, sigma in 1/s")
      ->check(CLI::NonNegativeNumber)
      ->excludes(window);
  command.add_flag("--best-hits",
                   frf.best_hits,
                   "Without hits that stand apart from the others");
}

void add_free_masses(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--free",
                  options.free,
                  "Take a sensor's mass off: all, acc1, acc1=0.020 or "
                  "acc1=0.020,sd=0.001 [kg]; may be repeated")
      ->check(CLI::Validator(free_fault, "SENSOR[=KG][,sd=KG]"))
      ->allow_extra_args(false);
}

}  // namespace tapfit::tui
