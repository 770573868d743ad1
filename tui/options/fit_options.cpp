#include "acquisition/foundation/input_error.hpp"
#include "tui/options/option_groups.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/prediction/stated_change.hpp"
#include "updating/residual/line_rule.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::tui {
namespace {

/// What is wrong with a text as written; empty where nothing is.
template <class Parse>
std::string fault_of(const Parse& parse, const std::string& text) {
  try {
    static_cast<void>(parse(text));
    return {};
  } catch (const InputError& error) {
    return error.remedy().empty()
               ? error.fault()
               : fmt::format("{} ({})", error.fault(), error.remedy());
  }
}

std::string lines_fault(const std::string& text) {
  return fault_of(updating::parse_lines, text);
}

std::string change_fault(const std::string& text) {
  return fault_of(updating::parse_stated_change, text);
}

std::string with_fault(const std::string& text) {
  return text == "none" ? std::string() : effect_fault(text);
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

std::string effect_fault(const std::string& text) {
  return fault_of(updating::parse_effect, text);
}

void add_effects(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--effect",
                  options.effects,
                  "Effect to add, for example added-mass@201; may be repeated")
      ->check(CLI::Validator(effect_fault, "EFFECT[@PLACE]"))
      ->allow_extra_args(false);
}

void add_predict_options(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--effect",
                  options.prediction.changes,
                  "Known change and its size, for example "
                  "added-mass@201=0.010 or =10g; may be repeated")
      ->required()
      ->check(CLI::Validator(change_fault, "EFFECT[@PLACE]=SIZE[,SIZE...]"))
      ->allow_extra_args(false);
  command
      .add_option("--with",
                  options.effects,
                  "Effect that the model has now, fitted along; none: what is "
                  "uncertain alone. Without it those kept in session.json or "
                  "found by a diagnosis")
      ->check(CLI::Validator(with_fault, "EFFECT[@PLACE]|none"))
      ->allow_extra_args(false);
  auto* against = command.add_option(
      "--against",
      options.prediction.against,
      "Bundle measured after the change: is it as predicted?");
  command
      .add_option("--repeatability",
                  options.prediction.repeatability_percent,
                  "By which frequencies scatter from one set-up of the "
                  "structure to the next (standard deviation) [%]; else 0")
      ->check(CLI::Range(0.0, 100.0))
      ->needs(against);
}

void add_regularisation(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--lines",
                  options.lines,
                  "Frequency lines: damped (default), rule, even, random, "
                  "before-peaks or a list in Hz such as 20,31.5,40:60:0.5")
      ->check(CLI::Validator(lines_fault, "RULE|LIST"));
  command
      .add_option("--lambda",
                  options.lambda,
                  "Tikhonov regularisation instead of the prior")
      ->check(CLI::Validator(lambda_fault, "VALUE|l-curve"));
}

}  // namespace tapfit::tui
