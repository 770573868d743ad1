#include "updating/structure/cards/include_lines.hpp"

#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/abaqus/keyword_block.hpp"
#include "updating/structure/cards/line_text.hpp"

#include <algorithm>
#include <system_error>

namespace tapfit::structure {
namespace {

constexpr std::size_t columns = 72;

bool ends_inside_quotes(const std::string& text) {
  const std::size_t open = text.find_first_of("'\"");
  return open != std::string::npos &&
         text.find(text[open], open + 1) == std::string::npos;
}

bool on_disk(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

// What stands behind the quotes; nothing where there are none.
std::string behind_name(const std::string& text) {
  const std::size_t open = text.find_first_of("'\"");
  if (open == std::string::npos) return {};
  const std::size_t close = text.find(text[open], open + 1);
  return close == std::string::npos ? "" : text.substr(close + 1);
}

}  // namespace

std::optional<std::string> include_name(const std::string& text) {
  const std::string line = trimmed(text);
  if (line.size() < 8 || upper(line.substr(0, 7)) != "INCLUDE") return {};
  const char next = line[7];
  if (next != ' ' && next != '\'' && next != '"' && next != '=') return {};
  const std::size_t open = line.find_first_of("'\"");
  if (open == std::string::npos) return trimmed(line.substr(8));
  const std::size_t close = line.find(line[open], open + 1);
  return line.substr(open + 1, close - open - 1);
}

bool complete_include(std::istream& file, std::string& text, int& number) {
  if (is_keyword_line(text) && upper(trimmed(text)) == "*INCLUDE,") {
    std::string more;
    if (!acquisition::take_line(file, more)) return false;
    text = trimmed(text) + trimmed(more);
    ++number;
  }
  for (std::string more; include_name(text) && ends_inside_quotes(text);) {
    if (!acquisition::take_line(file, more)) return false;
    text += trimmed(more);
    ++number;
  }
  return true;
}

std::filesystem::path included(
    const std::filesystem::path& asks,
    std::string name,
    const std::filesystem::path& main,
    const std::function<bool(const std::filesystem::path&)>& exists) {
  const auto is_there = [&exists](const std::filesystem::path& file) {
    return exists ? exists(file) : on_disk(file);
  };
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path beside = asks.parent_path() / name;
  const std::filesystem::path at_main = main / name;
  return !is_there(beside) && is_there(at_main) ? at_main : beside;
}

std::vector<std::string> renamed_include(const std::string& text,
                                         const std::string& name,
                                         bool keyword) {
  if (keyword) {
    const std::string quote = text.find('"') == std::string::npos ? "" : "\"";
    return {text.substr(0, text.find('=') + 1) + quote + name + quote};
  }
  const char quote = name.find('\'') == std::string::npos ? '\'' : '"';
  std::string rest = std::string("INCLUDE ") + quote + name + quote;
  std::vector<std::string> lines;
  while (rest.size() > columns) {
    // The first break that is left is behind the last folder that fits.
    std::size_t slash = rest.rfind('/', columns - 1);
    if (slash == std::string::npos) slash = rest.find('/');
    if (slash == std::string::npos) break;
    lines.push_back(rest.substr(0, slash + 1));
    rest.erase(0, slash + 1);
  }
  lines.push_back(rest + behind_name(text));
  return lines;
}

}  // namespace tapfit::structure
