#include "tui/paper/paper_report.hpp"

#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

std::optional<double> difference(const PaperRow& row) {
  if (!row.paper || !row.tapfit) return std::nullopt;
  return *row.tapfit - *row.paper;
}

ordered_json number(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : "-";
}

std::string table_text(const PaperTable& table) {
  TextTable text({"<" + table.name, "paper", "tapfit", "difference", "<"});
  for (const PaperRow& row : table.rows) {
    text.add({row.name,
              cell(row.paper),
              cell(row.tapfit),
              cell(difference(row)),
              row.remark});
  }
  std::string result = text.text();
  for (const std::string& note : table.notes) result += "  " + note + "\n";
  return result;
}

std::string history_text(const PaperReport& report) {
  std::vector<std::string> heading = {"step"};
  for (const std::string& name : report.parameters) heading.push_back(name);
  TextTable text(heading);
  for (Eigen::Index step = 0; step < report.history.rows(); ++step) {
    std::vector<std::string> row = {fmt::format("{}", step)};
    for (const double value : report.history.row(step)) {
      row.push_back(fmt::format("{:.4f}", value));
    }
    text.add(std::move(row));
  }
  return text.text();
}

}  // namespace

PaperTable frequency_table(const std::string& name,
                           const std::vector<double>& paper,
                           const Eigen::VectorXd& hz) {
  PaperTable table{name, {}, {}};
  for (std::size_t k = 0; k < paper.size(); ++k) {
    table.rows.push_back({fmt::format("mode {}", k + 1),
                          paper[k],
                          hz(static_cast<Eigen::Index>(k)),
                          ""});
  }
  return table;
}

ordered_json paper_json(const PaperReport& report) {
  ordered_json tables = ordered_json::array();
  for (const PaperTable& table : report.tables) {
    ordered_json rows = ordered_json::array();
    for (const PaperRow& row : table.rows) {
      rows.push_back({{"name", row.name},
                      {"paper", number(row.paper)},
                      {"tapfit", number(row.tapfit)},
                      {"difference", number(difference(row))},
                      {"remark", row.remark}});
    }
    tables.push_back(
        {{"name", table.name}, {"rows", rows}, {"notes", table.notes}});
  }
  ordered_json json{{"structure", report.structure}, {"tables", tables}};
  for (std::size_t k = 0; k < report.parameters.size(); ++k) {
    const Eigen::VectorXd column =
        report.history.col(static_cast<Eigen::Index>(k));
    json["history"][report.parameters[k]] =
        std::vector<double>(column.begin(), column.end());
  }
  return json;
}

std::string paper_text(const PaperReport& report) {
  std::string text = "The paper's " + report.structure + "\n";
  for (const PaperTable& table : report.tables) {
    text += "\n" + table_text(table);
  }
  if (report.parameters.empty()) return text;
  return text + "\n  " + report.history_name +
         ", property over its nominal value\n" + history_text(report);
}

}  // namespace tapfit::tui
