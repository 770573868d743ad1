#include "tui/report/robustness_output.hpp"

#include "tui/report/effect_output.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace tapfit::tui {

using updating::Robustness;

namespace {

// Values alone, each by its parameter's name.
std::string sizes_text(const Robustness& row) {
  std::string text;
  for (const updating::Estimate& e : row.parameters) {
    text += fmt::format("{}{} {}",
                        text.empty() ? "" : ", ",
                        e.name.substr(e.name.rfind(' ') + 1),
                        short_number(e.value));
  }
  return text;
}

}  // namespace

std::string firmness_words(const RobustnessRows& rows) {
  const auto stands =
      std::ranges::count(rows, true, &Robustness::verdict_stands);
  const auto all = static_cast<std::ptrdiff_t>(rows.size());
  std::string words =
      stands == all
          ? fmt::format("the verdict stands under all {} changes", all)
          : fmt::format(
                "the verdict stands under {} of {} changes", stands, all);
  const auto most =
      std::ranges::max_element(rows, {}, &Robustness::largest_move_sd);
  if (most->parameters.empty()) return words;
  return words + fmt::format(
                     "; sizes move by up to {} standard deviations "
                     "({})",
                     number(most->largest_move_sd, 2),
                     most->change);
}

std::string verdict_then(const Robustness& row) {
  return row.verdict_stands ? "stands" : row.verdict;
}

std::string move_text(const Robustness& row) {
  return row.parameters.empty() ? std::string()
                                : fmt::format("{:.2f} sd", row.largest_move_sd);
}

std::vector<std::string> robustness_table(const RobustnessRows& rows) {
  TextTable table({"<changed", "<verdict", "farthest", "<sizes"});
  for (const Robustness& row : rows) {
    table.add({row.change, verdict_then(row), move_text(row), sizes_text(row)});
  }
  std::istringstream text(table.text());
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

std::string robustness_text(const RobustnessRows& rows) {
  return fmt::format("How firm: {}\n\n{}\n",
                     firmness_words(rows),
                     fmt::join(robustness_table(rows), "\n"));
}

nlohmann::ordered_json robustness_json(const RobustnessRows& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Robustness& row : rows) {
    list.push_back({{"change", row.change},
                    {"verdict", row.verdict},
                    {"verdict_stands", row.verdict_stands},
                    {"largest_move_sd", row.largest_move_sd},
                    {"parameters", parameters_json(row.parameters)}});
  }
  return list;
}

}  // namespace tapfit::tui
