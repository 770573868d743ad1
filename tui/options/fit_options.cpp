#include "acquisition/foundation/input_error.hpp"
#include "tui/options/option_groups.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/residual/line_rule.hpp"

#include <cmath>

namespace tapfit::tui {
namespace {

/// What is wrong with an effect as written; empty where nothing is.
std::string effect_fault(const std::string& text) {
  try {
    static_cast<void>(updating::parse_effect(text));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string lines_fault(const std::string& text) {
  try {
    static_cast<void>(updating::parse_lines(text));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string lambda_fault(const std::string& text) {
  double value = 0.0;
  const bool number = CLI::detail::lexical_cast(text, value) &&
                      std::isfinite(value) && value >= 0.0;
  return number || text == "l-curve"
             ? std::string()
             : "\"" + text + "\" is neither a number from 0 on nor l-curve";
}

}  // namespace

void add_effects(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--effect",
                  options.effects,
                  "Effect to add, for example added-mass@201")
      ->check(CLI::Validator(effect_fault, "EFFECT[@PLACE]"))
      ->allow_extra_args(false);
}

void add_regularisation(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--lines",
                  options.lines,
                  "Frequency lines: damped, rule, even, random, before-peaks "
                  "or a list in Hz such as 20,31.5,40:60:0.5")
      ->check(CLI::Validator(lines_fault, "LINES"));
  command
      .add_option("--lambda",
                  options.lambda,
                  "Tikhonov regularisation instead of the prior")
      ->check(CLI::Validator(lambda_fault, "VALUE|l-curve"));
}

}  // namespace tapfit::tui
