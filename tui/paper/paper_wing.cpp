#include "tui/paper/paper_structures.hpp"
#include "updating/studies/wing_study.hpp"

#include <fmt/format.h>

#include <array>

namespace tapfit::tui {
namespace {

using updating::WingStudy;

constexpr std::uint64_t seed = 1;

PaperTable table_6(const updating::WingResult& result) {
  constexpr std::array<const char*, 4> names = {"E1", "E2", "rho1", "A1"};
  constexpr std::array<double, 4> nominal = {210e9, 70e9, 7850.0, 4e-4};
  constexpr std::array<double, 4> paper = {-0.24, 0.27, -0.28, 0.42};
  const std::vector<double> truth = WingStudy::truth();
  PaperTable table{
      "Table 6, error of the properties after updating, %", {}, {}};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double f = result.factor[k];
    table.rows.push_back(
        {names.at(k),
         paper.at(k),
         100.0 * (f / truth[k] - 1.0),
         fmt::format(
             "{:.5g} of {:.5g}", f * nominal.at(k), truth[k] * nominal.at(k))});
  }
  table.notes = {
      result.last.message +
          ", lambda from the L-curve, lines by the rule of 2.3",
      fmt::format(
          "correlation of rho1 and A1: {:.2f}. Bending shows only their",
          result.last.identifiability.correlation(2, 3)),
      "product, the mass per metre; A1 alone is seen where beams are "
      "stretched,",
      "so FRFs of grids 13 and 26 are taken along x, y and z."};
  return table;
}

}  // namespace

PaperReport paper_wing(const std::filesystem::path& folder,
                       const Progress& progress) {
  progress("solar wing", 0.0);
  const WingStudy wing(folder);
  const updating::PropertyStudy& study = wing.study();
  const updating::WingResult result = wing.identify(seed);
  PaperReport report;
  report.structure = "wing";
  report.tables = {frequency_table("Table 5, before updating, Hz",
                                   {0.24, 0.86, 1.99, 4.24, 5.43, 8.23, 8.93},
                                   study.frequencies_hz(study.nominal(), 7)),
                   frequency_table("Table 5, target, Hz",
                                   {0.25, 0.91, 2.09, 4.44, 5.69, 8.63, 9.35},
                                   study.frequencies_hz(WingStudy::truth(), 7)),
                   frequency_table("Table 5, after updating, Hz",
                                   {0.25, 0.90, 2.08, 4.38, 5.68, 8.59, 9.29},
                                   study.frequencies_hz(result.factor, 7)),
                   table_6(result)};
  report.tables[0].notes = {
      "The paper's text gives no dimensions; those of the bundle were chosen "
      "to",
      "come near this row."};
  report.parameters = {"E1", "E2", "rho1", "A1"};
  report.history = result.history;
  return report;
}

}  // namespace tapfit::tui
