#include "tui/report/update_output.hpp"

#include "tui/report/effect_output.hpp"
#include "tui/report/report_words.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

using updating::RecordedStep;
using updating::UpdateRecord;

constexpr Eigen::Index l_curve_rows = 9;
constexpr std::size_t most_correlated = 8;

std::vector<double> listed(const Eigen::VectorXd& numbers) {
  return {numbers.begin(), numbers.end()};
}

ordered_json steps_json(const UpdateRecord& record) {
  ordered_json steps = ordered_json::array();
  for (const RecordedStep& step : record.steps) {
    ordered_json parameters = ordered_json::object();
    for (std::size_t k = 0; k < record.parameters.size(); ++k) {
      parameters[record.parameters[k]] =
          step.values(static_cast<Eigen::Index>(k));
    }
    steps.push_back({{"stage", step.stage},
                     {"error", step.error},
                     {"step", step.length},
                     {"lambda", step.lambda},
                     {"parameters", std::move(parameters)}});
  }
  return steps;
}

ordered_json l_curve_json(const std::optional<updating::LCurve>& curve) {
  if (!curve || curve->lambda.size() == 0) return nullptr;
  ordered_json json = {{"lambda", listed(curve->lambda)},
                       {"residual_norm", listed(curve->residual_norm)},
                       {"solution_norm", listed(curve->solution_norm)},
                       {"curvature", listed(curve->curvature)},
                       {"corner", curve->corner},
                       {"corner_lambda", curve->lambda(curve->corner)}};
  if (curve->used) json["prior_lambda"] = curve->used->lambda;
  return json;
}

ordered_json correlation_json(const UpdateRecord& record) {
  ordered_json rows = ordered_json::array();
  for (Eigen::Index k = 0; k < record.correlation.rows(); ++k) {
    rows.push_back(listed(record.correlation.row(k).transpose()));
  }
  return rows;
}

ordered_json record_json(const UpdateRecord& record) {
  ordered_json json = placed_json("added", record.added, record.where);
  json.update(ordered_json{
      {"lines", record.lines},
      {"converged", record.converged},
      {"message", record.message},
      {"parameters", record.parameters},
      {"iterations", steps_json(record)},
      {"l_curve", l_curve_json(record.l_curve)},
      {"identifiability",
       {{"singular_values", listed(record.identifiability.singular_values)},
        {"not_told_apart", record.confounded}}},
      {"correlation", correlation_json(record)}});
  return json;
}

std::string convergence_text(const std::vector<UpdateRecord>& records) {
  TextTable table({"<identified", "steps", "residual from", "to", "<"});
  for (const UpdateRecord& record : records) {
    if (record.steps.empty()) continue;
    // Residuals of different lines are not to be compared.
    const int last = record.steps.back().stage;
    const auto first =
        std::ranges::find(record.steps, last, &RecordedStep::stage);
    const auto stages = static_cast<std::size_t>(last) + 1;
    table.add({effect_text(record.added, record.where),
               fmt::format("{}", record.steps.size() - stages),
               percent(first->error),
               percent(record.steps.back().error),
               record.message});
  }
  return table.text();
}

std::string confounded_text(const UpdateRecord& record) {
  std::string text;
  for (std::vector<std::string> group : record.confounded) {
    for (std::string& name : group) name = parameter_words(name);
    text += group.size() == 1
                ? fmt::format("  note: the data say nothing of {}\n", group[0])
                : fmt::format("  note: the data alone do not tell apart {}\n",
                              fmt::join(group, ", "));
  }
  return text;
}

std::string correlation_text(const UpdateRecord& record) {
  const std::size_t count = record.parameters.size();
  if (count < 2 || count > most_correlated || record.correlation.rows() == 0) {
    return {};
  }
  std::vector<std::string> heading = {"<correlation"};
  for (std::size_t k = 0; k < count; ++k) {
    heading.push_back(fmt::format("{}", k + 1));
  }
  TextTable table(heading);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<std::string> row = {
        fmt::format("{} {}", k + 1, parameter_words(record.parameters[k]))};
    for (std::size_t j = 0; j <= k; ++j) {
      row.push_back(
          fmt::format("{:.2f}",
                      record.correlation(static_cast<Eigen::Index>(k),
                                         static_cast<Eigen::Index>(j))));
    }
    table.add(std::move(row));
  }
  return "\n" + table.text();
}

std::string l_curve_text(const UpdateRecord& record) {
  if (!record.l_curve || record.l_curve->lambda.size() == 0) return {};
  const updating::LCurve& curve = *record.l_curve;
  if (curve.used) return {};  // nobody asked for it
  TextTable table({"lambda", "|S x - d|", "|x|", "<L-curve, first step"});
  const Eigen::Index points = curve.lambda.size();
  const Eigen::Index every =
      std::max<Eigen::Index>(1, points / (l_curve_rows - 1));
  for (Eigen::Index k = 0; k < points; ++k) {
    if (k != curve.corner && k % every != 0) continue;
    table.add({fmt::format("{:.3g}", curve.lambda(k)),
               fmt::format("{:.4g}", curve.residual_norm(k)),
               fmt::format("{:.4g}", curve.solution_norm(k)),
               k == curve.corner ? "corner" : ""});
  }
  return "\n" + table.text();
}

}  // namespace

ordered_json updates_json(const std::vector<UpdateRecord>& records) {
  ordered_json list = ordered_json::array();
  for (const UpdateRecord& record : records) {
    list.push_back(record_json(record));
  }
  return list;
}

std::string updates_text(const std::vector<UpdateRecord>& records) {
  if (records.empty()) return {};
  const UpdateRecord& last = records.back();
  return "\n" + capitalised(on_contour(last.lines)) + "\n" +
         convergence_text(records) + confounded_text(last) +
         correlation_text(last) + l_curve_text(last) + "\n";
}

}  // namespace tapfit::tui
