#include "updating/structure/cards/bulk_lines.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace tapfit::structure {
namespace {

constexpr std::size_t kMaxDepth = 20;

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

// A quote may hold a $ only in file names, which INCLUDE reads beforehand.
std::string without_comment(const std::string& text) {
  return text.substr(0, text.find('$'));
}

// Editors may begin a file with the mark of UTF-8.
void drop_byte_order_mark(std::string& text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
}

bool ends_inside_quotes(const std::string& text) {
  const std::size_t open = text.find_first_of("'\"");
  return open != std::string::npos &&
         text.find(text[open], open + 1) == std::string::npos;
}

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

struct RawLine {
  std::string text;
  std::string where;
  int number = 0;
};

bool next_line(std::istream& file, std::string& text) {
  if (!std::getline(file, text)) return false;
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return true;
}

void read_file(const std::filesystem::path& path,
               const std::string& asked_by,
               std::size_t depth,
               std::vector<RawLine>& lines) {
  if (depth > kMaxDepth) {
    throw InputError("INCLUDE files include each other without end",
                     asked_by,
                     "Remove the INCLUDE that leads back.");
  }
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("cannot open the model {}", path.string()),
                     asked_by,
                     "Check the file's name and that it may be read.");
  }
  std::string text;
  for (int number = 1; next_line(file, text); ++number) {
    if (number == 1) drop_byte_order_mark(text);
    const std::string where =
        fmt::format("{}:{}", path.filename().string(), number);
    // A long name goes on in the next lines.
    for (std::string more; include_name(text) && ends_inside_quotes(text);) {
      if (!next_line(file, more)) {
        throw InputError("the name of the INCLUDE file does not end",
                         where,
                         "Close the quotes.");
      }
      text += trimmed(more);
      ++number;
    }
    const std::optional<std::string> name = include_name(text);
    if (name) {
      lines.push_back({"$ inlined: " + trimmed(text), where, number});
      read_file(path.parent_path() / *name, where, depth + 1, lines);
    } else {
      lines.push_back({text, where, number});
    }
  }
}

bool is_begin_bulk(const std::string& text) {
  const std::string line = upper(trimmed(text));
  return line.starts_with("BEGIN") && line.find("BULK") != std::string::npos;
}

bool is_end(const std::string& text) {
  return upper(trimmed(text)).starts_with("ENDDATA");
}

bool looks_like_control(const std::string& text) {
  static constexpr std::array<const char*, 14> kWords{"SOL",
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
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end() ||
         (equals > 0 && equals < 24 && line.find_first_of(",=(") != comma);
}

std::optional<int> selected_spc(const std::string& text) {
  const std::string line = upper(trimmed(text));
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return {};
  if (trimmed(line.substr(0, equals)) != "SPC") return {};
  return parse_integer(trimmed(line.substr(equals + 1)));
}

void take_spc(std::optional<int> set, DeckLines& lines) {
  if (!set || set == lines.spc_set) return;
  std::vector<int>& others = lines.other_spc_sets;
  if (!lines.spc_set) {
    lines.spc_set = set;
  } else if (std::find(others.begin(), others.end(), *set) == others.end()) {
    others.push_back(*set);
  }
}

}  // namespace

DeckLines read_deck_lines(const std::filesystem::path& path) {
  std::vector<RawLine> raw;
  read_file(path, path.string(), 0, raw);
  const bool has_begin =
      std::any_of(raw.begin(), raw.end(), [](const RawLine& line) {
        return is_begin_bulk(without_comment(line.text));
      });
  DeckLines result;
  bool in_bulk = !has_begin;
  bool ended = false;
  for (const RawLine& line : raw) {
    result.all.push_back(line.text);
    const std::string text = expand_tabs(without_comment(line.text));
    if (ended || trimmed(text).empty()) continue;
    if (!in_bulk || (!has_begin && looks_like_control(text))) {
      take_spc(selected_spc(text), result);
      if (is_begin_bulk(text)) in_bulk = true;
    } else if (is_end(text)) {
      ended = true;
    } else {
      result.bulk.push_back(
          {text, line.where, line.number, result.all.size() - 1});
    }
  }
  return result;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  return text;
}

}  // namespace tapfit::structure
