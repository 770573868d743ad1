#include "tui/options/open_bundle.hpp"
#include "tui/paper/paper_structures.hpp"
#include "updating/session/add_diagnosed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::tui {
namespace {

using Errors = std::array<double, 4>;

PaperTable frequency_table(const std::string& name,
                           const Errors& paper,
                           const updating::Comparison& comparison) {
  PaperTable table{"Table 7, error of frequency " + name + ", %", {}, {}};
  double paper_sum = 0.0;
  double sum = 0.0;
  std::size_t count = 0;
  for (const updating::ModePair& pair : comparison.pairs) {
    if (count == paper.size()) break;
    table.rows.push_back(
        {fmt::format("mode {}", pair.measured + 1),
         paper.at(count),
         pair.error_percent,
         fmt::format(
             "measured {:.3f} Hz, MAC {:.3f}", pair.measured_hz, pair.mac)});
    paper_sum += std::abs(paper.at(count));
    sum += std::abs(pair.error_percent);
    ++count;
  }
  if (count == 0) return table;
  const auto n = static_cast<double>(count);
  table.rows.push_back({"mean of sizes", paper_sum / n, sum / n, ""});
  return table;
}

// Modes that are paired, and the most that any two others are alike.
PaperTable mac_table(const std::string& name,
                     const updating::Comparison& comparison) {
  PaperTable table{"Figure 18, MAC " + name, {}, {}};
  Eigen::MatrixXd others = comparison.mac;
  for (const updating::ModePair& pair : comparison.pairs) {
    table.rows.push_back(
        {fmt::format("mode {}", pair.measured + 1), {}, pair.mac, ""});
    others(pair.measured, pair.model) = 0.0;
  }
  const double most = others.size() > 0 ? others.maxCoeff() : 0.0;
  table.rows.push_back({"any two others, at most", {}, most, ""});
  return table;
}

// The bundle's two accelerometers are of one make: one mass for both.
PaperTable mass_table(const std::vector<updating::Estimate>& parameters) {
  PaperTable table{"Table 8, mass of an accelerometer, g", {}, {}};
  PaperRow m1{"m1", 17.78, {}, "not identified"};
  PaperRow m2{"m2", 17.32, {}, "not identified"};
  const auto found = std::ranges::find(
      parameters, "sensor-mass mass_kg", &updating::Estimate::name);
  if (found != parameters.end()) {
    m1.tapfit = m2.tapfit = 1e3 * found->value;
    m1.remark = m2.remark = fmt::format(
        "95 % {:.2f} to {:.2f}", 1e3 * found->lo95, 1e3 * found->hi95);
  }
  table.rows = {m1, m2};
  table.notes = {"Both weigh 20 g, in the paper and in the bundle."};
  return table;
}

}  // namespace

PaperReport paper_frame(const std::filesystem::path& folder,
                        const Progress& progress) {
  updating::Session session = open_bundle(folder);
  const updating::Comparison before = session.base_comparison(progress);
  const updating::Diagnosis diagnosis =
      updating::add_diagnosed(session, progress);
  const updating::Comparison after = session.comparison(progress);
  PaperReport report;
  report.structure = "frame";
  report.tables = {
      frequency_table("before updating", {8.84, 1.41, 9.13, 8.74}, before),
      frequency_table("after updating", {0.0, -2.43, 2.99, 1.46}, after),
      mass_table(session.model_parameters(progress)),
      mac_table("before updating", before),
      mac_table("after updating", after)};
  report.tables[0].notes = {
      "A frame of other dimensions, see the bundle: the paper gives none."};
  report.tables[1].notes = {"with what the diagnosis found: " +
                            diagnosis.verdict};
  report.tables[3].notes = {"The paper's figure has no numbers in its text."};
  return report;
}

}  // namespace tapfit::tui
