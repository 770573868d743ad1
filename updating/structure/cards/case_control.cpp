#include "updating/structure/cards/case_control.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/line_text.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

// Names are known by their first four characters.
std::string whole_name(const std::string& written) {
  static const std::array<std::pair<std::string, std::string>, 6> long_names{
      {{"METH", "METHOD"},
       {"ANAL", "ANALYSIS"},
       {"STAT", "STATSUB"},
       {"TEMP", "TEMPERATURE"},
       {"SUBC", "SUBCASE"},
       {"LOAD", "LOAD"}}};
  for (const auto& [start, whole] : long_names) {
    if (written.starts_with(start)) return whole;
  }
  return written;
}

struct Command {
  std::string name;
  CaseCommand rest;
};

// NAME = value, NAME(OPTION) = value, NAME value.
Command command(const std::string& text) {
  const std::string line = upper(trimmed(text));
  const std::size_t end = std::min(line.find_first_of(" =("), line.size());
  Command result;
  result.name = whole_name(line.substr(0, end));
  std::string rest = trimmed(line.substr(end));
  const std::size_t close = rest.find(')');
  if (rest.starts_with("(") && close != std::string::npos) {
    result.rest.option = trimmed(rest.substr(1, close - 1));
    rest = trimmed(rest.substr(close + 1));
  }
  if (rest.starts_with("=")) rest = trimmed(rest.substr(1));
  result.rest.value = rest;
  return result;
}

// NAME, or 2.0*NAME, one after the other.
std::vector<std::string> matrix_names(const std::string& value) {
  std::vector<std::string> names;
  std::size_t from = 0;
  while (from < value.size()) {
    const std::size_t comma = std::min(value.find(',', from), value.size());
    const std::string one = trimmed(value.substr(from, comma - from));
    if (!one.empty()) names.push_back(one);
    from = comma + 1;
  }
  return names;
}

// Those that say what is solved; titles and output do not.
bool chooses_model(const std::string& name) {
  static const std::set<std::string> names{"METHOD",
                                           "CMETHOD",
                                           "FMETHOD",
                                           "ANALYSIS",
                                           "SPC",
                                           "MPC",
                                           "LOAD",
                                           "DLOAD",
                                           "FREQUENCY",
                                           "FREQ",
                                           "TSTEP",
                                           "TRIM",
                                           "STATSUB"};
  return names.contains(name);
}

template <typename Commands>
std::string value_of(const Commands& commands, const char* name) {
  const auto found = commands.find(name);
  return found == commands.end() ? "" : found->second.value;
}

}  // namespace

void CaseReader::add(const std::string& text, const std::string& where) {
  Command read = command(text);
  if (read.name == "SUBCASE") {
    subcases_.push_back({parse_integer(read.rest.value).value_or(0), {}});
    return;
  }
  if (read.name == "METHOD" && read.rest.option.starts_with("F")) return;
  read.rest.where = where;
  Commands& commands = subcases_.empty() ? above_ : subcases_.back().commands;
  commands[read.name] = std::move(read.rest);
}

CaseReader::Commands CaseReader::of(std::size_t subcase) const {
  Commands commands = above_;
  if (subcase >= subcases_.size()) return commands;
  for (const auto& [name, own] : subcases_[subcase].commands) {
    commands[name] = own;
  }
  return commands;
}

std::size_t CaseReader::solved() const {
  std::optional<std::size_t> with_method;
  for (std::size_t k = 0; k < subcases_.size(); ++k) {
    const Commands commands = of(k);
    const std::string analysis = value_of(commands, "ANALYSIS");
    if (analysis.starts_with("MODE")) return k;
    if (!with_method && commands.contains("METHOD") &&
        !analysis.starts_with("STAT")) {
      with_method = k;
    }
  }
  return with_method.value_or(0);
}

CaseControl CaseReader::result() const {
  CaseControl control;
  const std::size_t chosen = solved();
  control.commands = of(chosen);
  control.first = chosen == 0;
  if (chosen < subcases_.size()) control.subcase = subcases_[chosen].number;
  control.selects =
      !subcases_.empty() ||
      std::ranges::any_of(control.commands, [](const auto& entry) {
        return chooses_model(entry.first);
      });
  const std::string solution = value_of(control.commands, "SOL");
  control.normal_modes = solution == "103" || solution == "SEMODES";
  control.spc_set = parse_integer(value_of(control.commands, "SPC"));
  control.mpc_set = parse_integer(value_of(control.commands, "MPC"));
  control.stiffness_matrices = matrix_names(value_of(control.commands, "K2GG"));
  control.mass_matrices = matrix_names(value_of(control.commands, "M2GG"));
  for (std::size_t k = 0; k < subcases_.size(); ++k) {
    const std::optional<int> set = parse_integer(value_of(of(k), "SPC"));
    std::vector<int>& others = control.other_spc_sets;
    if (set && set != control.spc_set &&
        std::ranges::find(others, *set) == others.end()) {
      others.push_back(*set);
    }
  }
  return control;
}

CaseControl case_control(const std::vector<std::string>& lines) {
  const bool has_begin = std::ranges::any_of(lines, [](const auto& line) {
    return is_begin_bulk(without_comment(line));
  });
  CaseReader reader;
  for (const std::string& line : lines) {
    const std::string text = expand_tabs(without_comment(line));
    if (has_begin && is_begin_bulk(text)) break;
    if (trimmed(text).empty()) continue;
    if (has_begin || looks_like_control(text)) reader.add(text, "");
  }
  return reader.result();
}

}  // namespace tapfit::structure
