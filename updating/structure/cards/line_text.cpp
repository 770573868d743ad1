#include "updating/structure/cards/line_text.hpp"

#include <algorithm>
#include <array>

namespace tapfit::structure {

std::string expand_tabs(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\t') {
      result.append(8 - result.size() % 8, ' ');
    } else {
      result += c;
    }
  }
  return result;
}

std::string without_comment(const std::string& text) {
  return text.substr(0, text.find('$'));
}

bool is_begin_bulk(const std::string& text) {
  const std::string line = upper(trimmed(text));
  return line.starts_with("BEGIN") && line.find("BULK") != std::string::npos;
}

bool is_end(const std::string& text) {
  return upper(trimmed(text)).starts_with("ENDDATA");
}

bool looks_like_control(const std::string& text) {
  static constexpr std::array<const char*, 14> words{"SOL",
                                                     "CEND",
                                                     "ID",
                                                     "TIME",
                                                     "TITLE",
                                                     "SUBTITLE",
                                                     "LABEL",
                                                     "ECHO",
                                                     "SUBCASE",
                                                     "NASTRAN",
                                                     "ASSIGN",
                                                     "DIAG",
                                                     "INIT",
                                                     "BEGIN"};
  const std::string line = upper(trimmed(text));
  const std::string word = line.substr(0, line.find_first_of(" ,=("));
  const std::size_t equals = line.find('=');
  const std::size_t comma = line.find(',');
  return std::find(words.begin(), words.end(), word) != words.end() ||
         (equals > 0 && equals < 24 && line.find_first_of(",=(") != comma);
}

}  // namespace tapfit::structure
