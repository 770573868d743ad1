#include "tui/app/key_script.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string>

namespace tapfit::tui {
namespace {

using StepKind = ScriptStep::Kind;

ScriptStep parse_resize(const std::string& line, int number) {
  std::istringstream words(line);
  std::string word;
  ScriptStep step{StepKind::Resize, {}, 0, 0};
  words >> word >> step.width >> step.height;
  if (!words || step.width < 1 || step.height < 1 || step.width > 2000 ||
      step.height > 2000) {
    throw InputError("no size of a screen: " + line,
                     fmt::format("key script, line {}", number),
                     "write columns and rows, as in: resize 120 35");
  }
  return step;
}

void parse_keys(std::string_view line,
                int number,
                std::vector<ScriptStep>& steps) {
  while (!line.empty()) {
    const std::optional<NamedKey> next = read_key(line);
    if (!next) {
      throw InputError(
          fmt::format("no such key: {}", line.substr(0, line.find('>') + 1)),
          fmt::format("key script, line {}", number),
          "write <Enter>, <Esc>, <Tab>, <Left>, <C-r>, or <lt> for '<'");
    }
    steps.push_back({StepKind::Press, next->key, 0, 0});
    line.remove_prefix(next->bytes);
  }
}

}  // namespace

std::vector<ScriptStep> parse_key_script(std::string_view text) {
  std::vector<ScriptStep> steps;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    if (line == "wait") {
      steps.push_back({StepKind::Wait, {}, 0, 0});
    } else if (line == "screen") {
      steps.push_back({StepKind::Dump, {}, 0, 0});
    } else if (line.starts_with("resize ")) {
      steps.push_back(parse_resize(line, number));
    } else {
      parse_keys(line, number, steps);
    }
  }
  return steps;
}

std::vector<ScriptStep> read_key_script(const std::filesystem::path& file) {
  if (!acquisition::open_input(file)) {
    throw InputError("the key script cannot be read",
                     file.string(),
                     "check the path and its permissions");
  }
  return parse_key_script(acquisition::read_input(file));
}

}  // namespace tapfit::tui
