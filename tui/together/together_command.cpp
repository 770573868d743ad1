#include "tui/together/together_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/report/json_text.hpp"
#include "tui/together/together_output.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/session/tests_together.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

std::vector<updating::EffectRef> parsed(const std::vector<std::string>& texts) {
  std::vector<updating::EffectRef> effects;
  for (const std::string& text : texts) {
    effects.push_back(updating::parse_effect(text));
  }
  return effects;
}

updating::TogetherChoice together_choice(const CommandOptions& options) {
  const TogetherArguments& given = options.together;
  updating::TogetherChoice choice;
  choice.shared = parsed(given.shared);
  choice.each = parsed(options.effects);
  choice.own = given.own;
  choice.structures = given.structures;
  const auto count = static_cast<int>(given.bundles.size());
  for (const auto& [number, effect] : given.single) {
    if (number < 1 || number > count) {
      throw InputError(fmt::format("there is no test {}", number),
                       fmt::format("--effect-in {} {}", number, effect),
                       fmt::format("{} are named: 1 to {}", count, count));
    }
    choice.single.emplace_back(static_cast<std::size_t>(number - 1),
                               updating::parse_effect(effect));
  }
  return choice;
}

}  // namespace

std::string together_command(const CommandOptions& options,
                             const Progress& progress) {
  const updating::TogetherChoice choice = together_choice(options);
  std::vector<updating::Session> sessions;
  std::vector<std::string> names;
  for (const std::filesystem::path& bundle : options.together.bundles) {
    CommandOptions own = options;
    own.input = bundle;
    sessions.push_back(open_by_hand(own, progress));
    names.push_back(bundle.string());
  }
  const updating::TestsTogether found =
      updating::fit_tests_together(sessions, names, choice, progress);
  return options.json ? json_text(together_json(found, names))
                      : together_text(found, names);
}

}  // namespace tapfit::tui
